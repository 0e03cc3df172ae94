//! How a spectrum ends.

use crate::inspect::sound::floor::{Floor, ceiling};
use crate::inspect::sound::line::offset;
use crate::inspect::sound::standard::smallest_standard;
use crate::inspect::sound::window::reach;
use crate::sampled::welch::PowerSpectrum;

/// How far above the noise floor something stands out: 6 dB, three times as much sound as noise.
const MARGIN: f64 = 4.0;
/// An end within this part of the Nyquist frequency is where every recorder's own filter ends.
const TOP: f64 = 0.97;
/// Where the density just below a place is looked at, as parts of its frequency.
const BELOW: [f64; 2] = [0.93, 0.97];
/// How many times what is left above the density there is at least, to be called cut: 25 dB, four times as many as sound loses
/// there that fades by 60 dB an octave, `60·log₂(1/0.93) = 6`.
const CUT: f64 = 316.0;

/// How a spectrum ends: the highest frequency that stands 6 dB above the [noise floor](Floor) (more, where few averages
/// let noise do that), and what is before and after it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ending {
    /// The spectrum is flat: nothing stands above its floor.
    Flat,
    /// It comes down to its floor below 0.97 of the Nyquist frequency, slowly, or with a line as the last thing.
    Falls {
        /// Where, in Hz.
        at: f64,
    },
    /// It ends abruptly, and its top is empty: as after upsampling, after a low-pass such as that of lossy coders, or in a
    /// sound that was made so.
    ///
    /// The evidence is that nothing above comes within 25 dB of what lies 3 to 7 % below: a fall of 240 dB an octave at
    /// least, where what rooms, voices and microphones weaken falls by a tenth of that. It can be missed where the sound had
    /// come down to the noise before it was cut, and is where those 4 % are narrower than a line: below 1.2 kHz in a long
    /// sound at 48 kHz.
    Cut {
        /// Where, in Hz.
        at: f64,
        /// By how much at least, in dB.
        drop: f64,
    },
    /// It goes on to the Nyquist frequency: whatever lay beyond when it was sampled has folded.
    Runs,
}

impl Ending {
    /// `band` is where nearly all of the power lies below.
    pub(super) fn of(spectrum: &PowerSpectrum, floor: &Floor, averages: f64, band: f64) -> Self {
        let density = spectrum.density();
        let top = TOP * 0.5 * spectrum.rate();
        // not below the band, as far as something stands out there
        let at = |bin: usize| highest(spectrum, bin).max(band.min(spectrum.frequency(bin)));
        if let Some((bin, drop)) = cut(density, floor.density).filter(|(bin, _)| at(*bin) <= top) {
            return Self::Cut { at: at(bin), drop: 10.0 * drop.log10() };
        }
        let least = MARGIN.max(ceiling(averages, density.len())) * floor.density;
        match density.iter().rposition(|p| *p > least).map(at) {
            None => Self::Flat,
            Some(at) if at > top => Self::Runs,
            Some(at) => Self::Falls { at },
        }
    }

    /// The frequency where it ends; `None` where there is no end below the Nyquist frequency.
    pub fn at(&self) -> Option<f64> {
        match self {
            Self::Falls { at } | Self::Cut { at, .. } => Some(*at),
            Self::Flat | Self::Runs => None,
        }
    }

    /// The least standard rate whose Nyquist frequency is above the end.
    pub fn enough(&self) -> Option<u32> {
        let at = self.at()?;
        smallest_standard(|rate| 0.5 * rate > at)
    }
}

/// Where that stands which a bin is the upper end of: the window widens what it sees by the width of a line, so there is a
/// largest bin within this width below; a line where that is a peak, a slope where it is not.
fn highest(spectrum: &PowerSpectrum, bin: usize) -> f64 {
    let density = spectrum.density();
    let from = bin.saturating_sub(reach());
    let largest = (from..=bin).rev().max_by(|a, b| density[*a].total_cmp(&density[*b])).unwrap_or(from);
    let peak = (1..density.len() - 1).contains(&largest)
        && density[largest - 1] < density[largest]
        && density[largest + 1] <= density[largest];
    let place = largest as f64 + if peak { offset(density[largest - 1], density[largest + 1]) } else { 0.0 };
    place * spectrum.step()
}

/// The bin at which a density is cut, and how many times as much as all that is left above lies just below it.
///
/// Just below is a [middle without a line](without_line), so that a line is no edge; above it is the largest, so that a line
/// there is an objection, and not less than the noise floor.
fn cut(density: &[f64], floor: f64) -> Option<(usize, f64)> {
    let mut above = floor;
    let mut drops = vec![0.0; density.len()];
    for bin in (1..density.len()).rev() {
        above = above.max(density[bin]);
        let [from, to] = BELOW.map(|part| (part * bin as f64).round() as usize);
        if let Some(below) = without_line(&density[from..to]).filter(|_| above > 0.0) {
            drops[bin] = below / above;
        }
    }
    let most = drops.iter().copied().fold(0.0, f64::max);
    // half-way down, in decibels
    let enough = CUT.max(most.sqrt());
    drops.iter().position(|drop| *drop >= enough).map(|bin| (bin, most))
}

/// The median, or less where a line alone could be as wide as half of the densities; `None` where it could be all of them.
fn without_line(densities: &[f64]) -> Option<f64> {
    let others = densities.len().checked_sub(2 * reach() + 1)?;
    let mut sorted = densities.to_vec();
    let place = others.min(sorted.len() / 2);
    Some(*sorted.select_nth_unstable_by(place, f64::total_cmp).1)
}
