//! Ways to antialias (slide «Способы антиалиасинга»): remove what the pixels cannot show before sampling, or sample more
//! finely and average.
//!
//! | way | here | what it leaves |
//! | --- | --- | --- |
//! | prefilter by exact area | [`Image::averaged`](crate::image::Image::averaged) | `sinc(ν)` of everything above Nyquist (E13) |
//! | prefilter by any kernel | [`prefiltered`](prefilter::prefiltered) | the kernel's response there |
//! | uniform supersampling with weights | [`weighted`](supersample::weighted) | everything near multiples of the finer rate (F33) |
//! | supersampling by a pattern | [`supersample`](supersample::supersample) | noise, of the pattern's spectrum |
//! | adaptive | [`adaptive`](adaptive::adaptive) | what the first samples miss |
//!
//! Point sampling is [`Image::of`](crate::image::Image::of): supersampling by one regular point and the box.

pub mod adaptive;
pub mod prefilter;
pub mod supersample;
