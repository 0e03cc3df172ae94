//! Lines: sinusoids that stand out of what is around them.

use crate::error::Result;
use crate::inspect::table::drift::Drift;
use crate::inspect::table::frame::Frame;
use crate::inspect::table::tone::Tone;
use crate::num::mean::mean;

/// A sinusoid `A cos(2πν(t − t_0) + φ)`, `t_0` the first position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// `ν`, to a small part of the record's resolution.
    pub frequency: f64,
    /// `A`.
    pub amplitude: f64,
    /// `φ` in radians.
    pub phase: f64,
    /// How much more of the mean square it explains than the frequencies around it do on the average.
    pub clearance: f64,
}

impl Line {
    /// `A²/2`.
    pub fn energy(&self) -> f64 {
        0.5 * self.amplitude * self.amplitude
    }
}

/// Frequencies to either side of one over which the floor is taken.
const AROUND: usize = 48;
/// A sinusoid of fewer periods is a drift.
const PERIODS: usize = 4;
/// Lines of a hundred thousandth of the strongest are its own rounding, or that of the printed values.
const FAINT: f64 = 1e-5;
/// Bins that a line takes to either side, under Hann's window.
const TAKEN: f64 = 1.6;
/// How improbable a line must be in noise: `e^{−9}`, one in ten thousand records, and, since the floor is an estimate from
/// some thirty independent frequencies, in fact one in a thousand.
const IMPROBABLE: f64 = 9.0;
/// Rounds in which lines are fitted again beside each other, and the evaluations that all of them may take.
const ROUNDS: usize = 24;
const MOST_EVALUATIONS: usize = 40_000_000;

/// The lines in values of mean zero, at most `most`, the strongest first, and what is left without them, of mean zero again.
///
/// A frequency is a line where it explains more of the mean square than `ln M + 9` times what those around it do, `M` the
/// number of frequencies: in noise the parts explained are exponentially distributed, and the largest of `M` exceeds that
/// with a probability below one in a thousand. Lines are found in the spectrum of what earlier ones left, fitted with
/// their frequency, and in the end fitted again one after another in what the others leave, until they stay (Li and Stoica,
/// RELAX, 1996). A polynomial of degree five takes part in this, or a drift would hide lines where positions have gaps; it is
/// no line, and stays in what is left.
pub(super) fn lines(frame: &Frame, centred: &[f64], most: usize) -> Result<(Vec<Line>, Vec<f64>)> {
    let mut rest = centred.to_vec();
    let mut drift = Drift::default();
    drift.relax(frame, &mut rest);
    let mut found: Vec<(Tone, f64)> = Vec::new();
    let peak = centred.iter().map(|v| v.abs()).fold(0.0, f64::max);
    // what rounding alone explains: less cannot be told from nothing
    let least = (16.0 * f64::EPSILON * peak).powi(2);
    while found.len() < most && peak > 0.0 {
        let before = found.len();
        let (transform, _) = frame.transform(&rest)?;
        let explained: Vec<f64> =
            (0..=frame.order).map(|m| if m == 0 { 0.0 } else { frame.fitted(m, transform[m]).1 }).collect();
        let strongest = found.iter().map(|(tone, _)| tone.amplitude()).fold(0.0, f64::max);
        for (m, clearance) in candidates(frame, &explained, &found, least) {
            let ([cos, sin], part) = frame.fitted(m, transform[m]);
            let wave = Tone { frequency: m as f64 / frame.length, cos, sin };
            let tone = wave.refined(frame, &rest);
            let near = |other: &Tone| (other.frequency - tone.frequency).abs() * frame.length < 1.0;
            let faint = tone.amplitude() < FAINT * strongest || part <= least;
            if faint || found.iter().any(|(other, _)| near(other)) {
                continue;
            }
            tone.add(frame, &mut rest, -1.0);
            found.push((tone, clearance));
            if found.len() == most {
                break;
            }
        }
        relax(frame, &mut found, &mut drift, &mut rest);
        if found.len() == before {
            break;
        }
    }
    let strongest = found.iter().map(|(tone, _)| tone.amplitude()).fold(0.0, f64::max);
    found.retain(|(tone, _)| {
        let faint = tone.amplitude() < FAINT * strongest;
        if faint {
            tone.add(frame, &mut rest, 1.0);
        }
        !faint
    });
    drift.add(frame, &mut rest, 1.0);
    let offset = mean(&rest);
    rest.iter_mut().for_each(|v| *v -= offset);
    let line = |(tone, clearance): &(Tone, f64)| Line {
        frequency: tone.frequency,
        amplitude: tone.amplitude(),
        phase: tone.phase(),
        clearance: *clearance,
    };
    let mut lines: Vec<Line> = found.iter().map(line).collect();
    lines.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude));
    Ok((lines, rest))
}

/// Harmonics that stand out, the strongest first, within a tenth of the strongest: weaker ones may be its side lobes, and
/// are looked for when it is gone. Neighbours are left to the next time.
fn candidates(frame: &Frame, explained: &[f64], found: &[(Tone, f64)], least: f64) -> Vec<(usize, f64)> {
    let count = explained.len() - 1;
    let threshold = (count as f64).ln() + IMPROBABLE;
    // next to the Nyquist frequency of a grid a line overlaps with its image
    let top = frame.nodes.map_or(count, |nodes| count.min((nodes / 2).saturating_sub(2)));
    let free = |m: usize| found.iter().all(|(tone, _)| (tone.frequency * frame.length - m as f64).abs() > TAKEN);
    let peak =
        |m: usize| explained[m] >= explained[m - 1] && explained.get(m + 1).is_none_or(|next| explained[m] >= *next);
    let mut peaks: Vec<(usize, f64)> = (PERIODS..=top)
        .filter(|&m| peak(m) && free(m) && explained[m] > least)
        .map(|m| (m, explained[m] / floor(explained, m).max(least)))
        .filter(|(_, clearance)| *clearance > threshold)
        .collect();
    peaks.sort_by(|a, b| explained[b.0].total_cmp(&explained[a.0]));
    let strongest = peaks.first().map_or(0.0, |&(m, _)| explained[m]);
    let mut taken: Vec<usize> = Vec::new();
    peaks.retain(|&(m, _)| {
        let apart = taken.iter().all(|&other| m.abs_diff(other) > 4);
        let keep = apart && explained[m] >= 0.1 * strongest;
        if keep {
            taken.push(m);
        }
        keep
    });
    peaks
}

/// What the frequencies to the left of `m` or those to the right explain on the average, whichever is more, but for its own
/// line: their median over ln 2, since they are exponentially distributed in noise. So the slope of a spectrum that falls
/// is no line.
fn floor(explained: &[f64], m: usize) -> f64 {
    let median = |range: std::ops::Range<usize>| {
        let mut others = explained.get(range).unwrap_or_default().to_vec();
        let middle = others.len() / 2;
        if others.is_empty() { 0.0 } else { *others.select_nth_unstable_by(middle, f64::total_cmp).1 }
    };
    let left = median(m.saturating_sub(AROUND).max(1)..m - 2);
    let right = median(m + 3..(m + AROUND + 1).min(explained.len()).max(m + 3));
    left.max(right) / std::f64::consts::LN_2
}

/// Each line again, in what the others leave, until none moves.
fn relax(frame: &Frame, found: &mut [(Tone, f64)], drift: &mut Drift, rest: &mut [f64]) {
    let round = found.len() * rest.len();
    let rounds = if found.is_empty() { 0 } else { ROUNDS.min(MOST_EVALUATIONS / round.max(1)).max(2) };
    for _ in 0..rounds {
        let mut moved = 0.0f64;
        drift.relax(frame, rest);
        for (tone, _) in found.iter_mut() {
            tone.add(frame, rest, 1.0);
            let refined = tone.refined(frame, rest);
            refined.add(frame, rest, -1.0);
            let turned =
                (refined.cos - tone.cos).hypot(refined.sin - tone.sin) / refined.amplitude().max(f64::MIN_POSITIVE);
            moved = moved.max(turned);
            *tone = refined;
        }
        if moved < 1e-12 {
            break;
        }
    }
}
