//! Sounds in closed form or from a seed, and what is measured of them without the library's spectra.

use nyquist::inspect::sound::{Meter, Sound};
use nyquist::num::{cos_pi, random, sin_pi};

/// `A·sin(2πft + φ)` at `t = i/rate`; turns are reduced before they are multiplied by π.
pub(crate) fn tone(amplitude: f64, frequency: f64, phase: f64, rate: f64, i: usize) -> f64 {
    let cycles = frequency / rate * i as f64;
    amplitude * sin_pi(2.0 * (cycles - cycles.floor()) + phase)
}

/// White noise, even in `−½..½`: of power 1/12.
pub(crate) fn noise(seed: u64, frames: usize) -> Vec<f64> {
    (0..frames).map(|i| random::uniform(seed, i as u64, 0) - 0.5).collect()
}

/// One channel, looked into.
pub(crate) fn heard(rate: f64, values: &[f64]) -> Sound {
    let mut meter = Meter::new(rate, 1).expect("the rate is sound");
    meter.push(values).expect("the values are finite");
    meter.finish().expect("there are enough frames")
}

/// The amplitudes of tones of these frequencies that together leave the least of a record, and the mean square of what
/// they leave: normal equations, by elimination with pivots.
pub(crate) fn fitted(record: &[f64], rate: f64, frequencies: &[f64]) -> (Vec<f64>, f64) {
    let n = 2 * frequencies.len();
    let waves = |i: usize| -> Vec<f64> {
        let turns = frequencies.iter().map(|f| {
            let cycles = f / rate * i as f64;
            2.0 * (cycles - cycles.floor())
        });
        turns.flat_map(|t| [cos_pi(t), sin_pi(t)]).collect()
    };
    let mut rows = vec![vec![0.0; n + 1]; n];
    for (i, v) in record.iter().enumerate() {
        let w = waves(i);
        for (row, a) in rows.iter_mut().zip(&w) {
            row[..n].iter_mut().zip(&w).for_each(|(sum, b)| *sum += a * b);
            row[n] += a * v;
        }
    }
    for k in 0..n {
        let pivot = (k..n).max_by(|a, b| rows[*a][k].abs().total_cmp(&rows[*b][k].abs())).expect("there are rows");
        rows.swap(k, pivot);
        for i in k + 1..n {
            let factor = rows[i][k] / rows[k][k];
            let (above, below) = rows.split_at_mut(i);
            below[0].iter_mut().zip(&above[k]).for_each(|(a, b)| *a -= factor * b);
        }
    }
    let mut solved = vec![0.0; n];
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| rows[k][j] * solved[j]).sum();
        solved[k] = (rows[k][n] - known) / rows[k][k];
    }
    let rest = record.iter().enumerate().map(|(i, v)| {
        let sum: f64 = waves(i).iter().zip(&solved).map(|(w, a)| w * a).sum();
        (v - sum).powi(2)
    });
    let rest = rest.sum::<f64>() / record.len() as f64;
    (solved.chunks(2).map(|p| p[0].hypot(p[1])).collect(), rest)
}

pub(crate) fn mean_square(values: &[f64]) -> f64 {
    values.iter().map(|v| v * v).sum::<f64>() / values.len() as f64
}

/// Something like speech, three seconds at 48 kHz: gliding harmonics that weaken with frequency, bursts of hiss up to the
/// top, silence before, between and after.
pub(crate) fn speech(rate: f64) -> Vec<f64> {
    let frames = (3.0 * rate) as usize;
    let hiss = noise(7, frames + 2);
    let mut cycles = 0.0;
    (0..frames)
        .map(|i| {
            let t = i as f64 / rate;
            cycles += (120.0 + 30.0 * sin_pi(2.0 * 1.3 * t)) / rate;
            let swell =
                |from: f64, to: f64| if t > from && t < to { sin_pi((t - from) / (to - from)).powi(2) } else { 0.0 };
            let voice: f64 = (1..40).map(|k| sin_pi(2.0 * (f64::from(k) * cycles).fract()) / f64::from(k * k)).sum();
            // second differences: louder towards the top
            let bright = hiss[i] - 2.0 * hiss[i + 1] + hiss[i + 2];
            0.4 * voice * (swell(0.4, 1.1) + swell(1.3, 2.4)) + 0.03 * bright * (swell(1.0, 1.3) + swell(2.3, 2.6))
        })
        .collect()
}
