//! The power spectra of point sets in the plane (V10, V21, V32).

use crate::error::Result;
use crate::laws::Law;
use crate::laws::jitter::deviations;
use crate::num::sinc;
use crate::pattern::Pattern;
use crate::pattern::best_candidate::BestCandidate;
use crate::pattern::jittered::Jittered;
use crate::pattern::measure::periodogram::Periodogram;
use crate::pattern::measure::whiteness::{peak_to_mean, white_peak};
use crate::pattern::n_rooks::NRooks;
use crate::pattern::poisson_disk::PoissonDisk;
use crate::pattern::random::Random;
use crate::pattern::regular::Regular;
use crate::residual::Residual;
use crate::text::Text;

/// What the expected periodogram of a pattern is made of at one frequency: independent displacements with characteristic
/// function `φ` keep `φ²` of the lines, and `1 − φ²` is noise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Model {
    /// Jitter of that width in a grid of that many cells: `φ = sinc(au/m)·sinc(av/n)`, lines at the multiples of `m`, `n`.
    Jittered([usize; 2], f64),
    /// Independent points: one everywhere but at zero.
    White,
}

impl Model {
    /// Noise and `φ²` of a line, if there is one, at integer frequencies.
    pub fn at(&self, [u, v]: [i64; 2]) -> [f64; 2] {
        match *self {
            Self::White => [1.0, 0.0],
            Self::Jittered([m, n], width) => {
                let phi = sinc(width * u as f64 / m as f64) * sinc(width * v as f64 / n as f64);
                let line = u % m as i64 == 0 && v % n as i64 == 0;
                [1.0 - phi * phi, if line { phi * phi } else { 0.0 }]
            }
        }
    }
}

/// The mean periodogram of a pattern is `1 − φ² + φ²N·(lines)` at all integer frequencies but zero (V10 in the plane).
///
/// Measured: the largest difference, in units of what is allowed there. With `S = Nφ + Σw`, independent `w` of mean zero
/// and `|w| ≤ 2`, one periodogram deviates by at most `√(2P² + 4P/N) + 2√(φ²N·P)` where the noise is `P`, their mean by
/// `1/√R` of that; allowed are [`deviations`] of it for so many frequencies, and the rounding of powers of phasors.
///
/// # Errors
/// No patterns, or too far a reach.
pub fn point_spectrum(pattern: &dyn Pattern<2>, model: Model, patterns: u32, reach: usize) -> Result<Residual> {
    Ok(follows(&Periodogram::mean(pattern, 11, patterns, reach)?, model, 1))
}

/// [`point_spectrum`] of a periodogram that is there already, one of `seeds` that may be tried.
///
/// ```
/// use nyquist::laws::point_spectra::{Model, follows};
/// use nyquist::prelude::*;
/// let found = Periodogram::mean(&Jittered::<2>::new([8, 8])?, 1, 100, 12)?;
/// assert!(follows(&found, Model::Jittered([8, 8], 1.0), 1).holds());
/// assert!(!follows(&found, Model::White, 1).holds());
/// # Ok::<(), Error>(())
/// ```
pub fn follows(found: &Periodogram, model: Model, seeds: usize) -> Residual {
    let n = found.points();
    let z = deviations(seeds * found.half().count());
    let phasor = 4.0 * f64::EPSILON * (found.reach() + 1) as f64;
    let excess = |(frequency, power): ([i64; 2], f64)| {
        let [noise, line] = model.at(frequency);
        let expected = noise + line * n;
        let floor = (2.0 * noise * noise + 4.0 * noise / n).sqrt();
        let deviation = (floor + 2.0 * (line * n * noise).sqrt()) / f64::from(found.patterns()).sqrt();
        let rounding = 2.0 * n * phasor * expected.sqrt() + n * phasor * phasor;
        (power - expected).abs() / (z * deviation + rounding)
    };
    let worst = found.half().map(excess).fold(0.0, f64::max);
    Residual::at_most("mean periodogram of points, in units of the statistical deviation", worst, 1.0)
}

/// The greatest power of white noise is about `ln M` times the mean of `M` bins (V32): with probability 998/1000 it lies
/// between the quantiles of [`white_peak`]; a line stands out.
///
/// Measured: the distance of peak/mean from the middle between the quantiles; allowed: half their distance.
///
/// # Errors
/// No powers, or powers whose mean is not positive.
pub fn white_noise_peak(powers: &[f64]) -> Result<Residual> {
    let quantile = |p| white_peak(powers.len(), p);
    let (low, high) = (quantile(1e-3)?, quantile(1.0 - 1e-3)?);
    let peak = peak_to_mean(powers)?;
    Ok(Residual::near("peak/mean of white noise ≈ ln M", peak, 0.5 * (low + high), 0.5 * (high - low)))
}

/// The mean power at the frequencies `low·√N ≤ |(u, v)| < high·√N`, and its standard deviation.
///
/// # Errors
/// No patterns, or too far a reach.
pub fn band_power(pattern: &dyn Pattern<2>, patterns: u32, [low, high]: [f64; 2]) -> Result<[f64; 2]> {
    let about = pattern.count().unwrap_or_else(|| pattern.points(0).len()) as f64;
    Ok(in_band(&Periodogram::mean(pattern, 5, patterns, (high * about.sqrt()).ceil() as usize)?, [low, high]))
}

/// [`band_power`] of a periodogram that is there already, and reaches so far.
pub fn in_band(found: &Periodogram, [low, high]: [f64; 2]) -> [f64; 2] {
    let unit = found.points().sqrt();
    let inside = |[u, v]: [i64; 2]| (low..high).contains(&((u as f64).hypot(v as f64) / unit));
    let powers: Vec<f64> = found.half().filter(|(f, _)| inside(*f)).map(|(_, power)| power).collect();
    let mean = powers.iter().sum::<f64>() / powers.len().max(1) as f64;
    [mean, mean / (powers.len().max(1) as f64 * f64::from(found.patterns())).sqrt()]
}

/// The power of a saturated Poisson disk pattern at `0.02 ≤ |ν|/√N < 0.1`, and its deviation: the mean over 4000, 1500 and
/// 300 patterns of 256, 1024 and 4096 points, 0.05827(46), 0.05829(43) and 0.05872(41). The variance of the number of
/// points, `P(0)·N`, says the same.
pub const PLATEAU: [f64; 2] = [0.0584, 0.00025];

/// The power spectrum of a saturated Poisson disk pattern does not vanish at low frequencies (V21): a plateau of 0.058,
/// the same for any number of points. So the variance of a mean falls as `N⁻¹`, only with a small factor.
///
/// Measured: the difference to [`PLATEAU`]. Allowed: [`deviations`] of the mean over bins and patterns, and how well the
/// plateau itself is known.
///
/// # Errors
/// No patterns, or too far a reach.
pub fn plateau(pattern: &dyn Pattern<2>, patterns: u32) -> Result<Residual> {
    let [power, deviation] = band_power(pattern, patterns, [0.02, 0.1])?;
    let bound = deviations(1) * (deviation + PLATEAU[1]);
    Ok(Residual::near("plateau of a Poisson disk pattern", power, PLATEAU[0], bound))
}

/// The noise of a pattern in a band of frequencies is at most `most` (E11a): jitter pushes it up to high frequencies,
/// independent points leave it everywhere.
///
/// Measured: the mean power less [`deviations`] of it.
///
/// # Errors
/// No patterns, or too far a reach.
pub fn little_noise(pattern: &dyn Pattern<2>, patterns: u32, band: [f64; 2], most: f64) -> Result<Residual> {
    let [power, deviation] = band_power(pattern, patterns, band)?;
    Ok(Residual::at_most("noise at low frequencies", power - deviations(1) * deviation, most))
}

fn jittered(along: [usize; 2], width: f64) -> Jittered<2> {
    Jittered::new(along).and_then(|p| p.with_width(width)).expect("a width of at most one")
}

fn regular() -> Regular<2> {
    Regular::new([8, 8]).expect("there are points")
}

fn random(n: usize) -> Random {
    Random::new(n).expect("there are points")
}

fn spectrum_of(pattern: &dyn Pattern<2>, model: Model, patterns: u32) -> Residual {
    point_spectrum(pattern, model, patterns, 20).expect("there are patterns")
}

fn powers(pattern: &dyn Pattern<2>) -> Vec<f64> {
    let one = Periodogram::mean(pattern, 1, 1, 15).expect("there are points");
    one.half().map(|(_, power)| power).collect()
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "point-spectrum",
        inventory: &["V10", "F37", "F38", "F39"],
        says: &Text::fixed(
            "Regular points have lines of N, jitter the floor 1 − sinc²(u)sinc²(v), independent points white noise",
            "У регулярных точек линии высоты N, у джиттера шум 1 − sinc²(u)sinc²(v), у независимых точек белый шум",
        ),
        holds: || {
            vec![
                spectrum_of(&regular(), Model::Jittered([8, 8], 0.0), 1),
                spectrum_of(&regular().with_random_offset(), Model::Jittered([8, 8], 0.0), 20),
                spectrum_of(&jittered([8, 8], 1.0), Model::Jittered([8, 8], 1.0), 400),
                spectrum_of(&jittered([8, 8], 0.5), Model::Jittered([8, 8], 0.5), 400),
                spectrum_of(&jittered([12, 5], 0.8), Model::Jittered([12, 5], 0.8), 400),
                spectrum_of(&random(64), Model::White, 400),
            ]
        },
        breaks: || {
            vec![
                spectrum_of(&random(64), Model::Jittered([8, 8], 1.0), 400), // E11
                spectrum_of(&jittered([8, 8], 1.0), Model::White, 400),
                spectrum_of(&jittered([8, 8], 0.5), Model::Jittered([8, 8], 1.0), 400),
                spectrum_of(&NRooks::new(64).expect("there are points"), Model::White, 400), // low on the axes
            ]
        },
    },
    Law {
        name: "white-noise-peak",
        inventory: &["V32", "F40", "F51"],
        says: &Text::fixed(
            "The highest of M bins of white noise is about ln M times their mean; more is structure",
            "Самый высокий из M отсчётов спектра белого шума около ln M средних; больше — структура",
        ),
        holds: || [256, 1024].map(|n| white_noise_peak(&powers(&random(n))).expect("there is power")).into(),
        breaks: || {
            let offset = powers(&regular().with_random_offset());
            let half = powers(&jittered([8, 8], 0.5)); // the lines are lower, but still there
            [offset, half].map(|p| white_noise_peak(&p).expect("there is power")).into()
        },
    },
    Law {
        name: "poisson-plateau",
        inventory: &["V21", "V14"],
        says: &Text::fixed(
            "The spectrum of a Poisson disk pattern does not vanish at low frequencies: a plateau of 0.06 for any N",
            "Спектр пуассоновских дисков на низких частотах не исчезает: плато 0,06 при любом N",
        ),
        holds: || {
            let check = |(n, patterns)| {
                let pattern = PoissonDisk::with_about(n).expect("enough points");
                plateau(&pattern, patterns).expect("there are patterns")
            };
            [(256, 600), (1024, 100), (4096, 15)].map(check).into()
        },
        breaks: || {
            let best = BestCandidate::new(256).expect("there are points");
            let check = |pattern: &dyn Pattern<2>| plateau(pattern, 100).expect("there are patterns");
            vec![check(&best), check(&random(256)), check(&jittered([32, 32], 1.0)), check(&regular())]
        },
    },
    Law {
        name: "noise-goes-high",
        inventory: &["E11", "V21", "F39"],
        says: &Text::fixed(
            "Jitter and Poisson disks push the noise up to high frequencies; independent points do not",
            "Джиттер и пуассоновские диски вытесняют шум на высокие частоты; независимые точки нет",
        ),
        holds: || {
            let disks = PoissonDisk::with_about(1024).expect("enough points");
            // 1 − sinc²u·sinc²v < π²(u² + v²)/3
            let low = |edge: f64| (std::f64::consts::PI * edge).powi(2) / 3.0;
            let jitter = jittered([32, 32], 1.0);
            vec![
                little_noise(&jitter, 40, [0.02, 0.1], low(0.1)).expect("there are patterns"),
                little_noise(&jitter, 40, [0.1, 0.2], low(0.2)).expect("there are patterns"),
                little_noise(&disks, 40, [0.02, 0.35], 0.07).expect("there are patterns"),
            ]
        },
        breaks: || {
            let all: [&dyn Pattern<2>; 2] = [&random(1024), &NRooks::new(1024).expect("there are points")];
            all.map(|pattern| little_noise(pattern, 40, [0.1, 0.35], 0.5).expect("there are patterns")).into()
        },
    },
];
