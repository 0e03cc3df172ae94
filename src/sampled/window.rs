//! Windows: weights that fade a record in and out.

use crate::error::{Error, Result, positive, unknown, within};
use crate::num::cos_pi;
use crate::num::special::bessel_i0;
use std::fmt;
use std::str::FromStr;

/// A window over a record, in its periodic form: `w_j` of `n` is the value at `j/n`, so that the next period would
/// start with `w_n = w_0`. (The symmetric form, which filters use, is the periodic one of `n − 1`.)
///
/// Formulas after Harris, *On the use of windows for harmonic analysis with the DFT*, 1978.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Window {
    /// 1: no window. First side lobe −13.3 dB.
    Rectangular,
    /// `½ − ½cos(2πt)`. First side lobe −31.5 dB, then 18 dB an octave.
    Hann,
    /// `0.54 − 0.46cos(2πt)`. First side lobe −43 dB, then 6 dB an octave.
    Hamming,
    /// `0.42 − 0.5cos(2πt) + 0.08cos(4πt)`. First side lobe −58 dB.
    Blackman,
    /// The four-term window of Blackman and Harris: side lobes under −92 dB.
    BlackmanHarris,
    /// The five-term flat top of D'Antona and Ferrero (2006, as SciPy has it): a tone anywhere between two bins reads its
    /// amplitude to 0.01 dB; five bins wide to either side. Side lobes under −90 dB.
    FlatTop,
    /// `e^{−½((t − ½)/σ)²}` with σ as a fraction of the record.
    Gaussian(f64),
    /// `I₀(β√(1 − (2t − 1)²))/I₀(β)`, the window of Kaiser (1974): the first side lobe is at `0.217·β/sinh β`, which is
    /// −155 dB for β = 20, and a line is `√(1 + (β/π)²)` bins wide to either side.
    Kaiser(f64),
}

impl Window {
    /// The value at fraction `t` of the record, `0 ≤ t < 1`.
    pub fn at(self, t: f64) -> f64 {
        let sum = |c: &[f64]| c.iter().zip(0..).map(|(c, k)| c * cos_pi(2.0 * f64::from(k) * t)).sum();
        match self {
            Self::Rectangular => 1.0,
            Self::Hann => sum(&[0.5, -0.5]),
            Self::Hamming => sum(&[0.54, -0.46]),
            Self::Blackman => sum(&[0.42, -0.5, 0.08]),
            Self::BlackmanHarris => sum(&[0.35875, -0.48829, 0.14128, -0.01168]),
            Self::FlatTop => sum(&[0.215_578_95, -0.416_631_58, 0.277_263_158, -0.083_578_947, 0.006_947_368]),
            Self::Gaussian(sigma) => (-0.5 * ((t - 0.5) / sigma).powi(2)).exp(),
            Self::Kaiser(beta) => bessel_i0(beta * (4.0 * t * (1.0 - t)).max(0.0).sqrt()) / bessel_i0(beta),
        }
    }

    /// The values for a record of `n` samples.
    ///
    /// ```
    /// use nyquist::sampled::window::Window;
    /// assert_eq!(Window::Hann.values(4), [0.0, 0.5, 1.0, 0.5]);
    /// ```
    pub fn values(self, n: usize) -> Vec<f64> {
        (0..n).map(|j| self.at(j as f64 / n as f64)).collect()
    }
}

/// The windows without a parameter.
const NAMED: [(&str, Window); 6] = [
    ("rectangular", Window::Rectangular),
    ("hann", Window::Hann),
    ("hamming", Window::Hamming),
    ("blackman", Window::Blackman),
    ("blackman-harris", Window::BlackmanHarris),
    ("flat-top", Window::FlatTop),
];

/// The largest β: beyond it `I₀` is near the end of `f64`.
const MOST_BETA: f64 = 500.0;

/// The name that [`Window::from_str`] reads.
impl fmt::Display for Window {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Gaussian(sigma) => write!(f, "gaussian:{sigma}"),
            Self::Kaiser(beta) => write!(f, "kaiser:{beta}"),
            plain => f.write_str(NAMED.iter().find(|(_, window)| window == plain).map_or("", |(name, _)| name)),
        }
    }
}

/// Reads a window's name: `hann`, `flat-top`, `gaussian:0.15` (σ), `kaiser:14` (β, up to 500).
///
/// ```
/// use nyquist::sampled::window::Window;
/// assert_eq!("kaiser:14".parse(), Ok(Window::Kaiser(14.0)));
/// assert_eq!(Window::BlackmanHarris.to_string(), "blackman-harris");
/// let error = "han".parse::<Window>().unwrap_err();
/// assert!(error.to_string().starts_with("no window is called \"han\"; known: hann, "));
/// ```
impl FromStr for Window {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self> {
        if let Some((_, window)) = NAMED.iter().find(|(known, _)| *known == name) {
            return Ok(*window);
        }
        let number = |what: &str, text: &str| {
            let wanted = "a number";
            text.parse::<f64>().map_err(|_| Error::Unreadable { what: what.into(), given: text.into(), wanted })
        };
        match name.split_once(':') {
            Some(("gaussian", sigma)) => {
                Ok(Self::Gaussian(positive("σ of a Gaussian window", number("gaussian", sigma)?)?))
            }
            Some(("kaiser", beta)) => {
                Ok(Self::Kaiser(within("β of Kaiser's window", number("kaiser", beta)?, 0.0, MOST_BETA)?))
            }
            _ => Err(unknown("window", name, NAMED.map(|(known, _)| known).into_iter().chain(FAMILIES))),
        }
    }
}

/// The windows with a parameter, as they are written.
const FAMILIES: [&str; 2] = ["gaussian:SIGMA", "kaiser:BETA"];
