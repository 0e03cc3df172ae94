//! What jitter does to the spectrum: to the comb's own (V10), and to the samples taken with it (V11).

use crate::beyond::jitter::{Jitter, JitteredComb};
use crate::error::{Error, Result, within};
use crate::laws::Law;
use crate::num::cos_pi;
use crate::residual::Residual;
use crate::sampled::dft::dft;
use crate::text::Text;
use num_complex::Complex;

/// How many standard deviations the largest of `trials` independent normal numbers exceeds with probability below
/// 1/1000: `P(max > z) ≤ trials·e^{−z²/2}`.
pub fn deviations(trials: usize) -> f64 {
    (2.0 * (1e3 * trials as f64).ln()).sqrt()
}

/// How much the mean periodogram `power` of `patterns` patterns of `n` spikes `T` apart may deviate where its
/// expectation is a floor `noise` and a line `line·nT`: one standard deviation.
///
/// With the sum `S = n·φ + Σw` and independent `w` of mean zero and `|w| ≤ 2`, `E|Σw|⁴ ≤ 3(Σ E|w|²)² + Σ E|w|⁴`, so the
/// noise deviates by at most `√(2P² + 4PT/n)`; it beats with the line by `2√(line·nT·P)`.
fn deviation(noise: f64, line: f64, step: f64, n: usize, patterns: u32) -> f64 {
    let floor = (2.0 * noise * noise + 4.0 * noise * step / n as f64).sqrt();
    (floor + 2.0 * (line * n as f64 * step * noise).sqrt()) / f64::from(patterns).sqrt()
}

/// The power spectrum of a jittered comb is `P(ν) = T[1 − |φ|²] + |φ|² Σδ(ν − k/T)` (V10).
///
/// Runs `patterns` patterns of `n` spikes of `comb` and compares their mean periodogram with the spectrum of `model`
/// (the same comb, if the law is to hold) at every multiple of `1/(nT)` up to `order/T`. Measured: the largest
/// difference, in units of what is allowed there: [`deviations`] standard deviations for so many bins, each as derived
/// above, and the rounding of `n` phasors, which are powers of one. Bartlett's periodograms at these frequencies are
/// unbiased for any `n`, so that nothing else stands in the bound. Balakrishnan 1962.
///
/// ```
/// use nyquist::laws::jitter::jitter_spectrum;
/// use nyquist::prelude::*;
/// let comb = JitteredComb::new(1.0, Jitter::Uniform { width: 1.0 })?;
/// assert!(jitter_spectrum(&comb, &comb, 5, 64, 400, 3).holds());
/// // the spectrum as a popular book prints it: an unnormalised sinc(Tω/2) beside cycles (E32)
/// let printed = JitteredComb::new(1.0, Jitter::Uniform { width: 0.5 / std::f64::consts::PI })?;
/// assert!(!jitter_spectrum(&comb, &printed, 5, 64, 400, 3).holds());
/// # Ok::<(), Error>(())
/// ```
pub fn jitter_spectrum(
    comb: &JitteredComb,
    model: &JitteredComb,
    seed: u64,
    n: usize,
    patterns: u32,
    order: usize,
) -> Residual {
    let step = comb.step();
    let z = deviations(n * order + 1);
    let excess = |(m, [nu, power]): (usize, [f64; 2])| {
        let noise = model.noise(nu);
        let line = if m.is_multiple_of(n) { model.characteristic(nu).powi(2) } else { 0.0 };
        let expected = noise + line * n as f64 * step;
        let phasors = 2.0 * f64::EPSILON * n as f64 * (m + 1) as f64;
        let rounding = step / n as f64 * (2.0 * phasors * (n as f64 * expected / step).sqrt() + phasors * phasors);
        (power - expected).abs() / (z * deviation(noise, line, step, n, patterns) + rounding)
    };
    let powers = comb.mean_periodogram(seed, n, patterns, order);
    let worst = powers.into_iter().enumerate().map(excess).fold(0.0, f64::max);
    Residual::at_most("power spectrum of a jittered comb, in units of the statistical deviation", worst, 1.0)
}

/// What [`displayed_on_the_grid`] finds in the spectrum.
#[derive(Debug, Clone, PartialEq)]
pub struct Displayed {
    /// The power `|ĉ|²` of the coherent line at the tone's frequency.
    pub line: f64,
    /// The mean power of the noise in a bin.
    pub noise: f64,
    /// The power of the noise in every bin `0..n`, averaged over the patterns; the tone's own two bins are `NaN`.
    pub bins: Vec<f64>,
}

/// Samples of the tone `cos(2πmx/(nT))` taken at the jittered positions of `comb` and displayed at the regular ones,
/// `x = kT`, as an image does: the mean spectrum of `patterns` patterns of `n` samples. With `m > n/2` the tone is above
/// Nyquist, and its line stands at the alias as well.
///
/// # Errors
/// A bin `m` outside `1 ..= n − 1`, or the one at Nyquist, `n/2`, where the tone's two lines meet.
pub fn displayed_on_the_grid(comb: &JitteredComb, seed: u64, n: usize, patterns: u32, m: usize) -> Result<Displayed> {
    within("the bin of a tone", m as f64, 1.0, n as f64 - 1.0)?;
    if 2 * m == n {
        return Err(Error::Unsupported("a tone at Nyquist, displayed on the grid"));
    }
    let (mut mean, mut bins) = (Complex::ZERO, vec![0.0; n]);
    for pattern in 0..patterns {
        let tone = |x: f64| cos_pi(2.0 * (x / comb.step()) * m as f64 / n as f64);
        let values: Vec<f64> =
            comb.positions(JitteredComb::pattern_seed(seed, pattern), n).into_iter().map(tone).collect();
        let spectrum = dft(&values)?;
        mean += spectrum[m] / (n as f64 * f64::from(patterns));
        let gain = 1.0 / (n as f64 * f64::from(patterns));
        bins.iter_mut().zip(&spectrum).for_each(|(bin, s)| *bin += s.norm_sqr() * gain);
    }
    let noise = (bins.iter().sum::<f64>() - bins[m] - bins[n - m]) / (n - 2) as f64;
    (bins[m], bins[n - m]) = (f64::NAN, f64::NAN);
    Ok(Displayed { line: mean.norm_sqr(), noise, bins })
}

/// Samples taken at `kT + ξ_k` and displayed at `kT` (V11, one jittered sample a pixel): a tone keeps `φ(ν)` of its
/// amplitude, and what it loses reappears as *white* noise of power `½(1 − φ²)`; energy is conserved, not removed.
///
/// Three residuals, against the `φ` of `model`: the coherent line `φ²/4`, the noise's mean `½(1 − φ²)`, and its
/// flatness, the largest deviation of one bin in units of what is allowed there. Allowed, with `N = ½(1 − φ²)` and `R`
/// patterns: the mean of `nR` squares of numbers below 2 deviates by at most `√(4N/(nR))`, the coherent amplitude by
/// `√(N/(nR))`, a bin by `√((2N² + 4N/n)/R)`, each times [`deviations`]; and the rounding of the transform.
///
/// # Errors
/// As [`displayed_on_the_grid`].
pub fn jittered_tone(
    comb: &JitteredComb,
    model: &JitteredComb,
    seed: u64,
    n: usize,
    patterns: u32,
    m: usize,
) -> Result<[Residual; 3]> {
    let found = displayed_on_the_grid(comb, seed, n, patterns, m)?;
    let phi = model.characteristic(m as f64 / (n as f64 * comb.step()));
    let (noise, count) = (0.5 * (1.0 - phi * phi), n as f64 * f64::from(patterns));
    let rounding = 8.0 * f64::EPSILON * (n as f64).log2();
    let amplitude = deviations(1) * (noise / count).sqrt();
    let line_bound = phi * amplitude + amplitude * amplitude + rounding;
    let mean_bound = deviations(1) * (4.0 * noise / count).sqrt() + rounding;
    let bin_deviation = ((2.0 * noise * noise + 4.0 * noise / n as f64) / f64::from(patterns)).sqrt();
    let bin_bound = deviations(n / 2) * bin_deviation + rounding;
    let worst = found.bins.iter().map(|bin| (bin - noise).abs() / bin_bound).fold(0.0, f64::max);
    Ok([
        Residual::near("a jittered tone keeps φ(ν) of its amplitude", found.line, 0.25 * phi * phi, line_bound),
        Residual::near("what it loses is noise of power ½(1 − φ²)", found.noise, noise, mean_bound),
        Residual::at_most("that noise is white, in units of the statistical deviation", worst, 1.0),
    ])
}

fn comb(jitter: Jitter) -> JitteredComb {
    JitteredComb::new(1.0, jitter).expect("the widths are positive")
}

const CELL: Jitter = Jitter::Uniform { width: 1.0 };

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "jitter-spectrum",
        inventory: &["V10", "F39", "E32"],
        says: &Text::fixed(
            "Jitter takes |φ|² of the comb's lines and turns the rest into a floor of noise T(1 − |φ|²)",
            "Джиттер оставляет линиям гребёнки долю |φ|², а остальное превращает в шум T(1 − |φ|²)",
        ),
        holds: || {
            let half = Jitter::Uniform { width: 0.5 };
            let all = [Jitter::None, CELL, half, Jitter::Gaussian { sigma: 0.2 }, Jitter::Independent].map(comb);
            let scaled = JitteredComb::new(0.25, CELL).expect("the step is positive");
            all.iter().chain([&scaled]).map(|c| jitter_spectrum(c, c, 5, 64, 400, 3)).collect()
        },
        breaks: || {
            let (cell, printed) = (comb(CELL), comb(Jitter::Uniform { width: 0.5 / std::f64::consts::PI }));
            vec![
                jitter_spectrum(&cell, &printed, 5, 64, 400, 3),
                jitter_spectrum(&comb(Jitter::Independent), &cell, 5, 64, 400, 3), // white, not blue (E11)
            ]
        },
    },
    Law {
        name: "jittered-tone",
        inventory: &["V11", "E11"],
        says: &Text::fixed(
            "One jittered sample a pixel: the tone fades to φ(ν), and what it loses returns as white noise",
            "Один джиттер-отсчёт на пиксель: тон слабеет до φ(ν), а потерянное возвращается белым шумом",
        ),
        holds: || {
            let gaussian = Jitter::Gaussian { sigma: 0.3 };
            let all = [comb(CELL), comb(gaussian), comb(Jitter::None)];
            let check = |c: &JitteredComb| jittered_tone(c, c, 3, 512, 200, 100).expect("bin 100 of 512 is a tone");
            all.iter().flat_map(check).collect()
        },
        breaks: || {
            // taken for a regular comb
            let check = jittered_tone(&comb(CELL), &comb(Jitter::None), 3, 512, 200, 100);
            check.expect("bin 100 of 512 is a tone").into()
        },
    },
];
