//! The theorems of the Fourier transform (V31), measured.

use crate::axis::Axis;
use crate::error::Result;
use crate::laws::Law;
use crate::num::mean::mean;
use crate::num::quadrature::{even_breaks, integrate_pieces};
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::sampled::convolution::convolve;
use crate::sampled::dft::{forward, inverse};
use crate::signal::boxcar::Boxcar;
use crate::signal::gaussian::Gaussian;
use crate::signal::raised_cosine::RaisedCosine;
use crate::signal::tent::Tent;
use crate::signal::theorem::{Convolution, Derivative, Modulated, Product, Scaled, Shifted, Stretched, Sum};
use crate::signal::{FourierPair, Signal};
use crate::spectrum::Spectrum;
use crate::text::Text;
use num_complex::Complex;
use std::f64::consts::PI;

/// `∫ f(x) e^{−2πiνx} dx` by quadrature between the rising `breaks`, beyond which `f` is zero or negligible, against
/// the closed form: the oracle that no transform of the library takes part in.
///
/// Measured: the largest difference over `frequencies`. Allowed: the quadrature's own error estimate plus `tail`, the
/// caller's bound for `∫|f|` beyond the breaks.
///
/// ```
/// use nyquist::laws::theorems::pair_by_quadrature;
/// use nyquist::prelude::*;
/// let residual = pair_by_quadrature(&Tent::new(1.0)?, &[-1.0, 0.0, 1.0], &[0.0, 0.3, 2.7], 0.0);
/// assert!(residual.holds() && residual.bound < 1e-13);
/// # Ok::<(), Error>(())
/// ```
pub fn pair_by_quadrature(pair: &impl FourierPair, breaks: &[f64], frequencies: &[f64], tail: f64) -> Residual {
    let spectrum = pair.spectrum();
    let (mut measured, mut bound) = (0.0f64, tail);
    for &nu in frequencies {
        let step = 0.5 / nu.abs().max(0.1);
        let mut fine: Vec<f64> = breaks.windows(2).flat_map(|w| even_breaks(w[0], w[1], step)).collect();
        fine.dedup();
        let wave = |x: f64| Complex::cis(-2.0 * PI * nu * x) * pair.at(x);
        let integral = integrate_pieces(wave, &fine, 1e-15);
        measured = measured.max((integral.value - spectrum.density(nu)).norm());
        bound = bound.max(integral.error + tail);
    }
    Residual::at_most("closed-form spectrum = quadrature", measured, bound)
}

/// `∫ f² dx = ∫ |F|² dν` (Parseval, Plancherel), both by quadrature: the left between `breaks`, the right over the
/// spectrum's extent. Allowed: both error estimates plus `tail`, the caller's bound for the energy beyond the breaks.
pub fn parseval(pair: &impl FourierPair, breaks: &[f64], tail: f64) -> Residual {
    let space = integrate_pieces(|x| pair.at(x).powi(2), breaks, 1e-15);
    let spectrum = pair.spectrum();
    let frequency = spectrum.energy(-spectrum.extent(), spectrum.extent());
    let bound = space.error + 64.0 * f64::EPSILON * frequency + tail;
    Residual::near("∫f² = ∫|F|²", space.value, frequency, bound)
}

/// `T Σ f(x_j)² = (1/span) Σ |F(ν_k)|²`, exact for any samples.
///
/// Allowed, relative: twice the rounding of an FFT, `8ε·log₂n`, as the norm's square is off by twice what the norm is; and
/// `8ε` for squares, [means](mean) and factors. Plain sums of `n` squares could be off by `nε/2` where many are equal.
pub fn parseval_of_samples(samples: &Samples) -> Residual {
    let (axis, bins) = (samples.axis(), forward(samples));
    let squares: Vec<f64> = samples.values().iter().map(|v| v * v).collect();
    let powers: Vec<f64> = bins.values().iter().map(|v| v.norm_sqr()).collect();
    let (space, frequency) = (axis.span() * mean(&squares), mean(&powers) / axis.step());
    let bound = (2.0 * 8.0 * (squares.len() as f64).log2().max(1.0) + 8.0) * f64::EPSILON * space;
    Residual::near("T·Σf² = Σ|F|²/span", frequency, space, bound)
}

/// `inverse(forward(f)) = f`. Measured: the largest difference. Allowed: the rounding of two FFTs, `8ε·log₂n` of the
/// samples' root-sum-square (the norm in which an FFT is backward stable; Higham 2002, §24.1).
pub fn round_trip(samples: &Samples) -> Residual {
    let back = inverse(&forward(samples));
    let worst = samples.values().iter().zip(back.values()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let size = samples.values().iter().map(|v| v * v).sum::<f64>().sqrt();
    let bound = 8.0 * f64::EPSILON * (samples.values().len() as f64).log2().max(1.0) * size;
    Residual::at_most("inverse(forward(f)) = f", worst, bound)
}

/// The convolution theorem on samples: the bins of `f ⊗ g` are `F·G`, for two records that have room for it.
///
/// Measured: the largest difference between the DFT of the linear convolution and the product of the DTFTs on the same
/// grid, relative to `max|F|·max|G|`. Allowed: the rounding of four FFTs, `32ε·log₂n`.
///
/// # Errors
/// Steps that differ.
pub fn convolution_theorem(f: &Samples, g: &Samples) -> Result<Residual> {
    let h = convolve(f, g)?;
    let longer = |s: &Samples| {
        let axis = Axis::new(s.axis().start(), s.axis().step(), h.values().len())?;
        let mut values = s.values().to_vec();
        values.resize(axis.len(), 0.0);
        Ok(forward(&Samples::new(axis, values)?))
    };
    let (bins_f, bins_g, bins_h) = (longer(f)?, longer(g)?, forward(&h));
    let peak = |b: &crate::sampled::Bins| b.values().iter().map(|v| v.norm()).fold(0.0, f64::max);
    let scale = peak(&bins_f) * peak(&bins_g);
    let products = bins_f.values().iter().zip(bins_g.values()).map(|(a, b)| a * b);
    let measured = bins_h.values().iter().zip(products).map(|(h, p)| (h - p).norm()).fold(0.0, f64::max) / scale;
    let bound = 32.0 * f64::EPSILON * (h.values().len() as f64).log2().max(1.0);
    Ok(Residual::at_most("FFT(f ⊗ g) = F·G", measured, bound))
}

/// `σ_x·σ_ν ≥ 1/(4π)` for the deviations of the intensities `f²` and `|F|²` (Heisenberg, Weyl, Gabor 1946), with
/// equality for the Gaussian. Returns the product divided by `1/(4π)`.
///
/// For even signals, by quadrature between `±reach` and over the spectrum's extent.
pub fn uncertainty(pair: &impl FourierPair, reach: f64) -> f64 {
    let deviation = |density: &dyn Fn(f64) -> f64, limit: f64| {
        let breaks = even_breaks(-limit, limit, limit / 16.0);
        let mass = integrate_pieces(density, &breaks, 1e-15).value;
        let second = integrate_pieces(|t| t * t * density(t), &breaks, 1e-15).value;
        (second / mass).sqrt()
    };
    let spectrum = pair.spectrum();
    let space = deviation(&|x| pair.at(x).powi(2), reach);
    let frequency = deviation(&|nu| spectrum.density(nu).norm_sqr(), spectrum.extent());
    space * frequency * 4.0 * PI
}

/// A signal with somebody else's spectrum: what the laws must catch.
#[derive(Debug, Clone)]
struct Mismatched<S> {
    signal: S,
    spectrum: Spectrum,
}

impl<S: Signal> Signal for Mismatched<S> {
    fn at(&self, x: f64) -> f64 {
        self.signal.at(x)
    }
}

impl<S: Signal> FourierPair for Mismatched<S> {
    fn spectrum(&self) -> Spectrum {
        self.spectrum.clone()
    }
}

const FREQUENCIES: [f64; 6] = [0.0, 0.2, -0.45, 1.0, 1.43, -2.6];

fn gaussian() -> Gaussian {
    Gaussian::new(1.3).expect("the width is positive")
}

/// Where that Gaussian has fallen below rounding: `|x| = 8·1.3`, e^{−64π}.
fn whole() -> Vec<f64> {
    even_breaks(-10.4, 10.4, 1.3)
}

fn noise(n: usize) -> Samples {
    let values = (0..n as u64).map(|i| crate::num::random::normal(9, i, 0)).collect();
    Samples::new(Axis::new(-1.3, 0.7, n).expect("the axis is finite"), values).expect("normal numbers are finite")
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "fourier-pairs",
        inventory: &["V31", "F13"],
        says: &Text::fixed(
            "Every closed-form spectrum is the integral ∫f(x)e^{−i2πνx}dx",
            "Каждый спектр в замкнутом виде равен интегралу ∫f(x)e^{−i2πνx}dx",
        ),
        holds: || {
            let (unit, tent) = (Boxcar::new(1.0).expect("positive"), Tent::new(0.8).expect("positive"));
            vec![
                pair_by_quadrature(&unit, &[-0.5, 0.5], &FREQUENCIES, 0.0),
                pair_by_quadrature(&tent, &[-0.8, 0.0, 0.8], &FREQUENCIES, 0.0),
                pair_by_quadrature(&gaussian(), &whole(), &FREQUENCIES, 0.0),
            ]
        },
        breaks: || {
            let unit = Boxcar::new(1.0).expect("positive");
            let wider = Boxcar::new(1.01).expect("positive").spectrum();
            vec![pair_by_quadrature(&Mismatched { signal: unit, spectrum: wider }, &[-0.5, 0.5], &FREQUENCIES, 0.0)]
        },
    },
    Law {
        name: "shift",
        inventory: &["V31"],
        says: &Text::fixed("f(x − x_{0}) ↔ e^{−i2πνx₀}F(ν)", "f(x − x_{0}) ↔ e^{−i2πνx₀}F(ν)"),
        holds: || {
            let moved = Shifted::new(0.37, gaussian()).expect("finite");
            vec![pair_by_quadrature(&moved, &whole(), &FREQUENCIES, 0.0)]
        },
        breaks: || {
            let moved = Shifted::new(0.37, gaussian()).expect("finite");
            let back = Shifted::new(-0.37, gaussian()).expect("finite").spectrum();
            vec![pair_by_quadrature(&Mismatched { signal: moved, spectrum: back }, &whole(), &FREQUENCIES, 0.0)]
        },
    },
    Law {
        name: "similarity",
        inventory: &["V31"],
        says: &Text::fixed("f(x/c) ↔ c·F(cν)", "f(x/c) ↔ c·F(cν)"),
        holds: || {
            let wide = Stretched::new(0.6, gaussian()).expect("positive");
            vec![pair_by_quadrature(&wide, &whole(), &FREQUENCIES, 0.0)]
        },
        breaks: || {
            let wide = Stretched::new(0.6, gaussian()).expect("positive");
            let without_factor = wide.spectrum().scaled(1.0 / 0.6);
            vec![pair_by_quadrature(&Mismatched { signal: wide, spectrum: without_factor }, &whole(), &[0.2], 0.0)]
        },
    },
    Law {
        name: "derivative",
        inventory: &["V31"],
        says: &Text::fixed("f′ ↔ i2πν·F(ν)", "f′ ↔ i2πν·F(ν)"),
        holds: || vec![pair_by_quadrature(&Derivative(gaussian()), &whole(), &FREQUENCIES, 0.0)],
        breaks: || {
            let conjugate = Derivative(gaussian()).spectrum().scaled(-1.0);
            let wrong = Mismatched { signal: Derivative(gaussian()), spectrum: conjugate };
            vec![pair_by_quadrature(&wrong, &whole(), &[0.2], 0.0)]
        },
    },
    Law {
        name: "modulation",
        inventory: &["V31"],
        says: &Text::fixed(
            "f·cos(2πν_{0}x) ↔ ½F(ν − ν_{0}) + ½F(ν + ν_{0})",
            "f·cos(2πν_{0}x) ↔ ½F(ν − ν_{0}) + ½F(ν + ν_{0})",
        ),
        holds: || {
            let burst = Modulated::new(1.5, gaussian()).expect("positive");
            vec![pair_by_quadrature(&burst, &whole(), &FREQUENCIES, 0.0)]
        },
        breaks: || {
            let burst = Modulated::new(1.5, gaussian()).expect("positive");
            let one_sided = gaussian().spectrum().translated(1.5);
            vec![pair_by_quadrature(&Mismatched { signal: burst, spectrum: one_sided }, &whole(), &[1.43], 0.0)]
        },
    },
    Law {
        name: "linearity",
        inventory: &["V31"],
        says: &Text::fixed("a·f + b·g ↔ a·F + b·G", "a·f + b·g ↔ a·F + b·G"),
        holds: || {
            let sum = Sum(Scaled::new(2.0, gaussian()).expect("finite"), Tent::new(1.3).expect("positive"));
            vec![pair_by_quadrature(&sum, &whole(), &FREQUENCIES, 0.0)]
        },
        breaks: || {
            let square = crate::signal::from_fn(|x| gaussian().at(x).powi(2));
            let wrong = Mismatched { signal: square, spectrum: gaussian().spectrum() };
            vec![pair_by_quadrature(&wrong, &whole(), &[0.2], 0.0)]
        },
    },
    Law {
        name: "convolution",
        inventory: &["V31", "F17"],
        says: &Text::fixed("f ⊗ g ↔ F·G", "f ⊗ g ↔ F·G"),
        holds: || {
            let unit = Boxcar::new(1.0).expect("positive");
            let tent = Convolution::new(unit, &[-0.5, 0.5], unit, &[-0.5, 0.5]).expect("finite breaks");
            vec![
                pair_by_quadrature(&tent, &[-1.0, 0.0, 1.0], &FREQUENCIES, 1e-14),
                convolution_theorem(&noise(97), &noise(64)).expect("equal steps"),
            ]
        },
        breaks: || {
            let unit = Boxcar::new(1.0).expect("positive");
            let tent = Convolution::new(unit, &[-0.5, 0.5], unit, &[-0.5, 0.5]).expect("finite breaks");
            let wrong = Mismatched { signal: tent, spectrum: unit.spectrum() };
            vec![pair_by_quadrature(&wrong, &[-1.0, 0.0, 1.0], &[0.2], 1e-14)]
        },
    },
    Law {
        name: "product",
        inventory: &["V31", "F17"],
        says: &Text::fixed("f·g ↔ F ⊗ G", "f·g ↔ F ⊗ G"),
        holds: || {
            let both = Product::new(gaussian(), Tent::new(1.3).expect("positive")).expect("one extent is finite");
            // 1e-13: the quadrature inside the convolution of the two densities
            vec![pair_by_quadrature(&both, &[-1.3, 0.0, 1.3], &FREQUENCIES, 1e-13)]
        },
        breaks: || {
            let both = Product::new(gaussian(), Tent::new(1.3).expect("positive")).expect("one extent is finite");
            let product = gaussian().spectrum().multiplied(&Tent::new(1.3).expect("positive").spectrum());
            let wrong = Mismatched { signal: both, spectrum: product };
            vec![pair_by_quadrature(&wrong, &[-1.3, 0.0, 1.3], &[0.2], 1e-13)]
        },
    },
    Law {
        name: "parseval",
        inventory: &["V31", "F12"],
        says: &Text::fixed(
            "∫f² = ∫|F|², and Σ|F_{k}|² of samples likewise",
            "∫f² = ∫|F|², и так же Σ|F_{k}|² отсчётов",
        ),
        holds: || {
            vec![
                parseval(&gaussian(), &whole(), 0.0),
                parseval_of_samples(&noise(100)),
                parseval_of_samples(&noise(101)),
            ]
        },
        breaks: || {
            let louder = gaussian().spectrum().scaled(1.1);
            vec![parseval(&Mismatched { signal: gaussian(), spectrum: louder }, &whole(), 0.0)]
        },
    },
    Law {
        name: "round-trip",
        inventory: &["V31", "F12"],
        says: &Text::fixed(
            "The inverse transform returns the samples, for any length and any start",
            "Обратное преобразование возвращает отсчёты при любой длине и любом начале",
        ),
        holds: || [1, 2, 3, 64, 97, 100, 1000].map(|n| round_trip(&noise(n))).into(),
        breaks: || {
            // without the neighbour's phase: a record that starts elsewhere is another signal
            let samples = noise(64);
            let moved = Axis::new(0.0, 0.7, 64).expect("finite");
            let bins = forward(&Samples::trusted(moved, samples.values().to_vec()));
            let back = inverse(&crate::sampled::Bins::trusted(samples.axis(), bins.into_values()));
            let worst = samples.values().iter().zip(back.values()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            vec![Residual::at_most("bins read with another start", worst, 1e-12)]
        },
    },
    Law {
        name: "uncertainty",
        inventory: &["V31"],
        says: &Text::fixed(
            "σ_{x}·σ_{ν} ≥ 1/(4π) for intensities; the Gaussian reaches it",
            "σ_{x}·σ_{ν} ≥ 1/(4π) для интенсивностей; гауссиан достигает границы",
        ),
        holds: || {
            let rc = RaisedCosine::new(1.0).expect("positive");
            vec![
                Residual::near("Gaussian: σσ·4π = 1", uncertainty(&gaussian(), 10.4), 1.0, 1e-12),
                Residual::at_least("raised cosine: σσ·4π ≥ 1", uncertainty(&rc, 400.0), 1.0),
            ]
        },
        breaks: || {
            // a spectrum that is too narrow for its signal would beat the bound
            let narrow = Stretched::new(1.1, gaussian()).expect("positive").spectrum();
            let impossible = uncertainty(&Mismatched { signal: gaussian(), spectrum: narrow }, 10.4);
            vec![Residual::at_least("impossible pair: σσ·4π ≥ 1", impossible, 1.0)]
        },
    },
];
