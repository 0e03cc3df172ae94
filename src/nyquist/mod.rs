//! Which rate a signal needs, and what happens at one that is too low: [`fold`], [`Alias`], [`Verdict`].
//!
//! Two names that are easily swapped (E36): the *Nyquist frequency* `f_s/2` belongs to a rate, the *Nyquist rate* `2B`
//! to a signal. A rate suffices where its Nyquist frequency is above the band: `f_s/2 > B ⇔ f_s > 2B`.

mod bandpass;
mod fold;
mod verdict;

pub use bandpass::{BandRates, bandpass_rates};
pub use fold::{Alias, Landing, fold, landings};
pub use verdict::{Verdict, nyquist_frequency, nyquist_rate};
