//! Looking into sound: its band, how its spectrum ends, and what sampling it at another rate would do.
//!
//! A [`Meter`] takes frames as they come and keeps, for each channel, a few numbers and two averaged spectra: memory does
//! not grow with the sound. What it returns, a [`Sound`], answers the questions:
//!
//! | question | answer |
//! | --- | --- |
//! | how loud? | [`Levels`]: peak, RMS, mean |
//! | up to which frequency? | [`Channel::occupied`]: 99 % of the power, say; [`Ending`]: down to the [noise floor](Floor) |
//! | is the top of the spectrum empty, as after upsampling? | [`Ending::Cut`] |
//! | which tones? | [`Line`]s, to a small part of a bin |
//! | what folds at another rate, where to, how much of it? | a [`Forecast`], of plain sampling and of each [`Quality`] |
//! | is that tolerable? | a [`Check`] |
//!
//! [`Quality`]: crate::rate::Quality
//!
//! # Conventions
//!
//! Full scale is ±1. A level is in dBFS, where the sine of full scale is zero (AES17): [`dbfs`] of a mean square `p` is
//! `10·log₁₀(2p)`, so that a square wave of full scale has +3.01. The mean of a sound is no sound, and in no spectrum here.
//!
//! # How
//!
//! Welch's method under Kaiser's window of `β = 24` ([`BETA`]), whose side lobes are 188 dB down: below what the noise of 24
//! bits leaves in one bin (181 dB below a sine of full scale), so that no file of up to 24 bits is limited by leakage. A
//! line is 7.7 bins wide to either side. Segments are an eighth of the sound long, a power of two from 64 to 16384 samples
//! (fewer with more than 32 channels), one every eighth of their length: so the squared windows add up to a constant within
//! 0.013 dB, and all moments count alike but the first and the last ones: what lies within a third of a segment from either
//! end would count less than 5 %. These are heard through shorter windows, down to a hundred samples ([`Channel::whole`]).

mod channel;
mod check;
mod ending;
mod ends;
mod floor;
mod forecast;
mod levels;
mod line;
mod meter;
mod moment;
mod standard;
mod window;

pub use channel::Channel;
pub use check::{Check, TOLERANCE};
pub use ending::Ending;
pub use floor::Floor;
pub use forecast::{Folded, Forecast, Outcome, Stretch, Way};
pub use levels::{Levels, dbfs};
pub use line::Line;
pub use meter::{LEAST_FRAMES, Meter, Sound};
pub use moment::Moment;
pub use standard::{STANDARD_RATES, smallest_standard};
pub use window::BETA;
