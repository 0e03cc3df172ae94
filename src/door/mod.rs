//! The door: files of images, of sound and of numbers in and out, and the one place where sRGB becomes linear light and back.
//!
//! Reading takes PNG (1 to 16 bits a channel, grey, colour, palettes, with or without alpha) and JPEG (8 bits, grey and
//! colour, baseline and progressive; lossless grey of 16, too), writing makes PNG of 8 or 16 bits and JPEG of 8; all need the
//! feature `files`. Bytes come in and bytes go out: whoever calls writes them to a temporary file and renames it.
//!
//! What a file says beside its pixels is [carried](carried::Carried) to the next one, as far as its format has a place for
//! it: depth, colour space (sRGB, gamma and chromaticities, an ICC profile, code points), density. Everything else is
//! [skipped](skipped::Skipped) and counted by name, so that whoever asked can be told.
//!
//! # What is linear light?
//!
//! What the curve makes of a code. sRGB's unless the file says otherwise: by `gAMA`, by code points (`cICP`), or by the tone
//! curves of its ICC profile, if it is of the matrix kind, as those of cameras and displays are (sRGB, Adobe RGB, Display
//! P3, ProPhoto). Under a profile without such curves sRGB's is assumed, and that is said. Primaries are left alone: what is
//! linear in one set of primaries is linear in every other.
//!
//! # Which decoders, and why
//!
//! PNG is read and written by `png` of the image-rs project, which drawing needs anyway. JPEG is read by `jpeg-decoder` of
//! the same project, without its SIMD and threads: then it has no unsafe code, no dependencies, and gives the same bits on
//! every processor. `zune-jpeg`, which the `image` crate has taken since, is faster and sees more commits; but of 1,711
//! files cut short it accepted 1,210 without a word (17 in its strict mode), `jpeg-decoder` none, and a picture whose lower
//! half is an invention of the decoder is no measurement. (Both take a header that claims more rows than there are data; the
//! reader here finds that out by itself.) Neither panicked on 28,000 damaged files.
//!
//! JPEG is written by `jpeg-encoder`: small, without dependencies, and without unsafe code unless its SIMD is asked for.
//!
//! # What is not done
//!
//! Colours are not converted from one set of primaries to another: brightness is weighed as if they were sRGB's. CMYK has no
//! meaning without a profile and is refused. Of an animated PNG the still picture is read. EXIF is not carried over; its
//! orientation is applied, its resolution kept.

#[cfg(feature = "files")]
pub mod carried;
#[cfg(feature = "files")]
mod exif;
#[cfg(feature = "files")]
mod icc;
#[cfg(feature = "files")]
mod jpeg;
pub mod kind;
#[cfg(feature = "files")]
mod orientation;
pub mod picture;
#[cfg(feature = "files")]
mod png;
pub mod skipped;
pub mod srgb;
pub mod table;
#[cfg(feature = "files")]
pub mod transfer;
pub mod wav;

#[cfg(feature = "files")]
pub use crate::door::carried::Depth;
#[cfg(feature = "files")]
pub use crate::door::files::{Format, Limits, open_picture, png_bytes, read_file, read_picture, write_file};

#[cfg(feature = "files")]
mod files;
