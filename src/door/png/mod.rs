//! PNG, in and out: the only place that knows the decoder.

mod chunks;
mod reader;
mod writer;

pub(super) use reader::read;
pub(super) use writer::write;

/// The gamma of sRGB as `gAMA` has it, in units of 10⁻⁵.
const SRGB_GAMMA: u32 = 45_455;
