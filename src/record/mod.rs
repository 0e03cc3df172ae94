//! Records as they were taken: how regular their positions are, and band-limited values between them.
//!
//! A logger's times are printed to some decimals, jitter, have gaps, and come twice or out of order. [`Sampling`] says
//! which of all this is so, and what it allows; [`Interpolator`] chooses for each stretch without long gaps between what
//! equally spaced samples permit and least squares.

mod dense;
mod ends;
mod interpolated;
mod interpolator;
mod line;
mod moments;
mod recovered;
mod sampling;
mod steps;
mod stretches;

pub use dense::Dense;
pub use ends::Recovered;
pub use interpolated::Interpolated;
pub use interpolator::{Interpolator, Method, Piece, Wanted, Way, Windowed};
pub use moments::{MOST_MOMENTS, Moments};
pub use recovered::Recoverable;
pub use sampling::{Duplicates, Jitter, Kind, Order, Sampling};
pub use stretches::Gap;
