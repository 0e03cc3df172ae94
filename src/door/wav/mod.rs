//! WAV: sound in and out, in blocks of frames.
//!
//! A frame is one value for every channel; blocks hold frames one after another (interleaved), as `f64` with ±1 as full
//! scale. Readers take any [`Read`](std::io::Read), writers any [`Write`](std::io::Write): a pipe is as good as a file,
//! and memory follows the data that came, never what a header claims.
//!
//! | | |
//! | --- | --- |
//! | samples | integers of 8 (unsigned), 16, 24, 32 bits, floats of 32 and 64 bits; 12 or 20 valid bits in a larger container |
//! | channels | 1 to 65535 |
//! | headers | plain and `WAVE_FORMAT_EXTENSIBLE`; RIFF, and RF64 or BW64 (EBU Tech 3306) above 4 GiB |
//! | lengths left open | 0 and 0xFFFFFFFF, and 0x7FFFF000 of sox and espeak, which write into pipes: the data go on to the end |
//! | other chunks | skipped, and counted by name |
//! | refused | compressed kinds, big-endian RIFX, headers that contradict themselves or the data, NaN and ∞ (with their frame) |
//!
//! # Why not a crate
//!
//! `hound`, the best kept one, has no 64-bit floats in either direction, no RF64, its writer must seek, and a length that a
//! stream left open is an error or an empty file to it; `wav` reads whole files into memory. What is needed is a few
//! hundred lines, whose errors name the frame.
//!
//! Sources: IBM and Microsoft, *Multimedia Programming Interface and Data Specifications 1.0*, 1991; Microsoft, *Multiple
//! channel audio data and WAVE files*, 2001; EBU Tech 3306, *RF64*, 2018.

mod encoding;
mod header;
mod reader;
mod writer;

pub use crate::door::skipped::Skipped;
pub use encoding::{Clipping, Encoding};
pub use header::WavFormat;
pub use reader::WavReader;
pub use writer::{Dither, WavWriter};
