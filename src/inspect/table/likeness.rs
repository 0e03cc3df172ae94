//! Frequencies that irregular positions hardly tell apart.

use crate::inspect::table::frame::Frame;
use crate::record::{Kind, Sampling};

/// A line at `ν` and one at `ν ± shift` are alike at the samples: to the part `height` each fits the other's samples.
///
/// `|W(shift)|` of the spectral window `W(ν) = Σ w_j e^{−2πiνt_j}/Σ w_j`. Equally spaced samples have a height of one at
/// their rate; gaps that return every day have high ones at multiples of once a day.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Likeness {
    /// The difference of the frequencies.
    pub shift: f64,
    /// From ½ to one.
    pub height: f64,
}

/// Below, the wrong one of two lines has less than a quarter of the right one's energy.
const LEAST: f64 = 0.5;
/// How many are named.
const MOST: usize = 3;

/// The highest likenesses among shifts of up to twice the highest frequency, beyond the window's own width.
pub(super) fn likenesses(frame: &Frame, sampling: &Sampling) -> Vec<Likeness> {
    if sampling.kind() == Kind::Uniform {
        return Vec::new();
    }
    let height = |m: usize| frame.window.get(m).map_or(0.0, |w| w.norm());
    // that the rate of a grid changes nothing is no news
    let repeated = frame.nodes.map_or(usize::MAX, |nodes| nodes.saturating_sub(4));
    let peak = |m: &usize| height(*m) >= LEAST && height(*m) >= height(m - 1) && height(*m) > height(m + 1);
    let mut found: Vec<Likeness> = (4..frame.window.len().min(repeated))
        .filter(peak)
        .map(|m| {
            // the summit of a parabola through three bins
            let (left, middle, right) = (height(m - 1), height(m), height(m + 1));
            let bend = left - 2.0 * middle + right;
            let off = if bend < 0.0 { 0.5 * (left - right) / bend } else { 0.0 };
            Likeness { shift: (m as f64 + off.clamp(-0.5, 0.5)) / frame.length, height: middle }
        })
        .collect();
    found.sort_by(|a, b| b.height.total_cmp(&a.height));
    found.truncate(MOST);
    found
}
