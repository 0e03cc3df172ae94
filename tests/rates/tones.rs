//! Tones in closed form, and what is found of them in a record.

use nyquist::num::{cos_pi, sin_pi};

/// How many periods pass until sample `i`, with its phase: the closed form, reduced before it is multiplied by π.
pub(crate) fn tone(frequency: f64, rate: f64, i: usize) -> f64 {
    let cycles = frequency / rate * i as f64;
    sin_pi(2.0 * (cycles - cycles.floor()) + 0.3)
}

fn waves(frequency: f64, rate: f64, i: usize) -> [f64; 2] {
    let cycles = frequency / rate * i as f64;
    let t = 2.0 * (cycles - cycles.floor());
    [cos_pi(t), sin_pi(t)]
}

/// The amplitudes of the cosine and the sine of a frequency that leave the least of a record of (index, value).
pub(crate) fn fitted(record: &[(usize, f64)], frequency: f64, rate: f64) -> [f64; 2] {
    // normal equations of two unknowns
    let (mut cc, mut cs, mut ss, mut yc, mut ys) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for &(i, v) in record {
        let [c, s] = waves(frequency, rate, i);
        (cc, cs, ss, yc, ys) = (cc + c * c, cs + c * s, ss + s * s, yc + v * c, ys + v * s);
    }
    let det = cc * ss - cs * cs;
    [(yc * ss - ys * cs) / det, (ys * cc - yc * cs) / det]
}

/// What is left of a record when the tone of this frequency is taken away, whatever its amplitude and phase.
pub(crate) fn without(record: &[(usize, f64)], frequency: f64, rate: f64) -> f64 {
    let [a, b] = fitted(record, frequency, rate);
    let rest = record.iter().map(|&(i, v)| {
        let [c, s] = waves(frequency, rate, i);
        (v - a * c - b * s).abs()
    });
    rest.fold(0.0, f64::max)
}

pub(crate) fn decibels(v: f64) -> f64 {
    20.0 * v.log10()
}
