//! Conversion of sampling rates: sound at 44.1 kHz as if it had been sampled at 48 kHz.
//!
//! The samples of the new rate are those of the signal that the old ones stand for, low-passed to what both rates can
//! hold: reconstruct, filter, sample. A [`Quality`] is a promise in numbers, and the filter is designed to keep it:
//!
//! | quality | passes, of the lower Nyquist frequency | to within | rejects from there on all that would alias or image by |
//! | --- | --- | --- | --- |
//! | `fast` | 0.91 (20.1 of 22.05 kHz) | 0.0001 dB | 100 dB |
//! | `high` | 0.96 (21.2 of 22.05 kHz) | 3·10⁻⁷ dB | 150 dB |
//! | `best` | 0.99 (21.8 of 22.05 kHz) | 10⁻⁹ dB | 200 dB |
//!
//! The transition lies below the Nyquist frequency, where nothing folds: no band is left to alias "a little".
//!
//! # How
//!
//! The filter is a sinc under Kaiser's window, whose parameter and length follow from the promise by the window's transform
//! ([`design`]). A ratio `L/M` of whole numbers is done by overlap-save (Stockham 1966): a window of `qM` samples is
//! transformed, its spectrum multiplied by the filter and cut or padded to that of `qL` samples, and transformed back; what
//! the ends of the window touch is thrown away, a twelfth to a fifth of it (up to half where windows would be too long). So
//! the phases of the ratio are exact, however large `L` and `M` are. Other ratios go through one and a half times the rate
//! (twice in `f32`), or a whole fraction of that, by the same means, and from there to any times by a window of 16 (10)
//! samples, whose spectrum is divided out on the way there: a transform at non-uniform points, as in
//! [`nonuniform`](crate::engine::nonuniform). In 64 bits it errs by less than `6·10⁻¹²` of a tone. Times are counted in steps of 2⁻¹²⁸
//! samples.
//!
//! Delay is compensated: the filter is symmetric, and output `m` stands for the time `m/R` exactly. Of `n` samples there
//! come `round(n·R/R₀)`. Before and after the record there is silence. What is given stays behind what was taken by less
//! than a window ([`Converter::delay`]: from 44.1 kHz to a rate not far from it 0.4 s for `best`, 0.5 where the ratio is not
//! one of whole numbers, 0.05 for `fast`; in proportion more to much lower rates). Channels do not meet: each has transforms of its own, or a loud one would leave its rounding in a silent one.
//!
//! The bits do not depend on how the input is cut into blocks, nor on the number of threads, on which windows are converted
//! side by side; nor on the processor, unless the fastest butterflies are asked for ([`Converter::with`]). Numbers of 32
//! bits round to −134 dB of a tone in the root mean square (−130 where the ratio is not one of whole numbers), those of 64 to
//! −300.

mod between;
mod blocks;
mod converter;
pub mod design;
mod frames;
mod phases;
mod quality;
mod ratio;
mod response;
mod time;

pub use converter::{Converter, convert};
pub use quality::{Promise, Quality};
pub use ratio::Ratio;
pub use response::Response;
