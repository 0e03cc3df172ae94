//! The door: files of images and of sound in and out, and the one place where sRGB becomes linear light and back.
//!
//! Reading takes PNG (8 and 16 bits a channel, grey, colour, palettes, with or without alpha) and JPEG (8 bits, grey and
//! colour, baseline and progressive), writing makes PNG of 8 or 16 bits; both need the feature `files`. Bytes come in
//! and bytes go out: whoever calls writes them to a temporary file and renames it.
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
//! # What is not done
//!
//! Colour profiles (ICC) and chromaticities are not applied: the primaries are taken for those of sRGB. A PNG that says by
//! `gAMA` that it is not sRGB is decoded with that gamma. CMYK has no meaning without a profile and is refused.

#[cfg(feature = "files")]
mod jpeg;
pub mod kind;
#[cfg(feature = "files")]
mod orientation;
pub mod picture;
#[cfg(feature = "files")]
mod png;
pub mod srgb;
pub mod wav;

#[cfg(feature = "files")]
pub use crate::door::files::{Depth, Limits, open_picture, png_bytes, read_picture};

#[cfg(feature = "files")]
mod files;
