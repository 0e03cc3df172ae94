//! Values between the samples of a record.

use crate::axis::Edge;
use crate::error::{Error, Result, all_finite};
use crate::num::mean::mean;
use crate::parallel;
use crate::reconstruct::reconstruct;
use crate::record::dense::Dense;
use crate::record::ends::Recovered;
use crate::record::interpolator::{Interpolator, Way, Windowed};
use crate::sampled::Samples;
use crate::sampled::dft::dft;
use crate::sampled::power::periodogram;
use crate::sampled::window::Window;
use crate::signal::Signal;
use crate::signal::trigonometric::TrigPolynomial;
use num_complex::Complex;

/// Samples of a record and the way between them, again a [`Signal`]; beyond a piece it is that of the nearest, continued as
/// its edge says.
#[derive(Debug, Clone)]
pub struct Interpolated<'a> {
    between: &'a Interpolator,
    engines: Vec<Engine>,
    misfit: Option<f64>,
    beyond: f64,
}

#[derive(Debug, Clone)]
enum Engine {
    /// The samples without their mean, which no window keeps exactly; with it where zero is what they are continued by.
    Kernel {
        samples: Samples,
        mean: f64,
        kernel: Windowed,
        edge: Edge,
    },
    Polynomial(Dense),
    Recovered(Recovered),
}

impl<'a> Interpolated<'a> {
    pub(super) fn new(between: &'a Interpolator, count: usize, values: &[f64]) -> Result<Self> {
        if values.len() != count {
            return Err(Error::Length {
                what: "values at the positions of a record",
                expected: count,
                got: values.len(),
            });
        }
        all_finite("values at the positions of a record", values)?;
        let (mut engines, mut squares, mut fitted, mut beyond) = (Vec::new(), 0.0, 0, 0.0f64);
        for piece in between.pieces() {
            let values = &values[piece.stretch.clone()];
            engines.push(match &piece.way {
                Way::Kernel { axis, kernel, edge, band, .. } => {
                    let average = mean(values);
                    let centred = Samples::new(*axis, values.iter().map(|v| v - average).collect())?;
                    beyond = beyond.max(part_beyond(&centred, *band));
                    let (samples, mean) = match edge {
                        Edge::Zero => (Samples::new(*axis, values.to_vec())?, 0.0),
                        _ => (centred, average),
                    };
                    Engine::Kernel { samples, mean, kernel: *kernel, edge: *edge }
                }
                Way::Periodic { axis } => {
                    let period = axis.start()..axis.start() + axis.span();
                    Engine::Polynomial(Dense::of(TrigPolynomial::new(period, through(values)?)?))
                }
                Way::LeastSquares(recoverable) => {
                    let (recovered, misfit) = recoverable.fit(values)?;
                    squares += misfit * misfit * values.len() as f64;
                    fitted += values.len();
                    Engine::Recovered(recovered)
                }
            });
        }
        let misfit = (fitted > 0).then(|| (squares / fitted as f64).sqrt());
        Ok(Self { between, engines, misfit, beyond })
    }

    /// The values at many places, on all threads.
    pub fn at_all(&self, places: &[f64]) -> Vec<f64> {
        match self.engines.as_slice() {
            [Engine::Polynomial(dense)] => dense.at_all(places),
            [Engine::Recovered(recovered)] => recovered.at_all(places),
            _ => parallel::map(places.len(), |i| self.at(places[i])),
        }
    }

    /// Where kernels are used, the part of the energy that lies beyond the band they were made for: it is damped, and what
    /// is left of it errs.
    pub fn beyond_band(&self) -> f64 {
        self.beyond
    }

    /// How far the samples are from the signal of least squares, in the root mean square; none where all are passed.
    pub fn misfit(&self) -> Option<f64> {
        self.misfit
    }
}

/// The part of the energy of samples beyond a band, under Hann's window, which smears by two bins.
fn part_beyond(samples: &Samples, band: f64) -> f64 {
    let powers = periodogram(samples, Window::Hann);
    let smear = 2.0 / samples.axis().span();
    let sum = |least: f64| powers.iter().filter(|p| p[0].abs() > least).map(|p| p[1]).sum::<f64>();
    let all = sum(-1.0);
    if all > 0.0 { sum(band + smear) / all } else { 0.0 }
}

/// The coefficients of the polynomial through the samples of a period; the line at the Nyquist frequency, which an even
/// number has, as a cosine.
fn through(values: &[f64]) -> Result<Vec<Complex<f64>>> {
    let n = values.len();
    let mut coefficients = dft(values)?;
    coefficients.truncate(n / 2 + 1);
    coefficients.iter_mut().for_each(|c| *c /= n as f64);
    coefficients[0].im = 0.0;
    if n.is_multiple_of(2) {
        coefficients[n / 2] = (0.5 * coefficients[n / 2].re).into();
    }
    Ok(coefficients)
}

impl Signal for Interpolated<'_> {
    fn at(&self, x: f64) -> f64 {
        match &self.engines[self.between.nearest(x)] {
            Engine::Kernel { samples, mean, kernel, edge } => {
                let sum = match kernel {
                    Windowed::Kaiser(kernel) => reconstruct(samples, *kernel).edge(*edge).at(x),
                    Windowed::Regularised(kernel) => reconstruct(samples, *kernel).edge(*edge).at(x),
                };
                mean + sum
            }
            Engine::Polynomial(dense) => dense.at(x),
            Engine::Recovered(recovered) => recovered.at(x),
        }
    }
}
