//! JPEG, in and out: the only place that knows decoder and encoder.

mod reader;
mod segments;
mod writer;

pub(super) use reader::read;
pub(super) use writer::write;
