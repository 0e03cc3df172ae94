//! Which way leads from the samples of a record to the values between them.

use crate::axis::{Axis, Edge};
use crate::error::{Error, Result, positive, unknown};
use crate::kernel::Kernel;
use crate::kernel::kaiser::Kaiser;
use crate::kernel::regularised::Regularised;
use crate::record::interpolated::Interpolated;
use crate::record::recovered::Recoverable;
use crate::record::sampling::Sampling;
use std::f64::consts::PI;
use std::ops::Range;
use std::str::FromStr;

/// A way to values between samples.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Method {
    /// A sinc under Kaiser's window, for equally spaced samples; beyond their ends the record goes on as its edge says.
    Kaiser,
    /// A sinc under a Gaussian, the same with a proven bound of the error (V09c).
    Regularised,
    /// The trigonometric polynomial through equally spaced samples of one period.
    Periodic,
    /// The nearest band-limited signal, for any samples.
    LeastSquares,
}

impl Method {
    /// All four.
    pub const ALL: [Self; 4] = [Self::Kaiser, Self::Regularised, Self::Periodic, Self::LeastSquares];

    /// Its name: `kaiser`, `regularised`, `periodic`, `least-squares`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Kaiser => "kaiser",
            Self::Regularised => "regularised",
            Self::Periodic => "periodic",
            Self::LeastSquares => "least-squares",
        }
    }
}

/// Reads a method's name, in letters of any case.
impl FromStr for Method {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self> {
        let found = Self::ALL.into_iter().find(|m| m.name().eq_ignore_ascii_case(name));
        found.ok_or_else(|| unknown("method", name, Self::ALL.map(Self::name)))
    }
}

/// What is wanted of values between samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wanted {
    /// The way; none: [`Method::Kaiser`] where samples are equally spaced, [`Method::LeastSquares`] where they are not.
    pub method: Option<Method>,
    /// How the record goes on beyond its ends.
    pub edge: Edge,
    /// The band of the signal. None: 0.8 of the Nyquist frequency for kernels, what the positions support for least
    /// squares ([`Recoverable::new`]).
    pub band: Option<f64>,
    /// The largest condition number of least squares that is still an answer.
    pub most_condition: f64,
}

impl Default for Wanted {
    fn default() -> Self {
        Self { method: None, edge: Edge::Mirror, band: None, most_condition: 1e4 }
    }
}

/// The part of the band that kernels are made for where none is said.
const PART: f64 = 0.8;
/// The error that kernels aim at.
const AIM: f64 = 1e-9;
/// The widest kernel, in steps: then its error is larger.
const MOST_RADIUS: f64 = 512.0;
/// Samples below which nothing is recovered by least squares.
const FEW: usize = 4;

/// A record's positions, prepared to find values between them.
///
/// Long gaps part a record into pieces ([`Sampling::stretches`]), each of which is continued on its own. Those of a single
/// sample, and irregular ones of less than four, are left out.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::record::{Interpolator, Sampling, Wanted};
/// // six periods of a tone in forty samples, one of which is lost
/// let times: Vec<f64> = (0..40).filter(|k| *k != 17).map(f64::from).collect();
/// let tone = |t: f64| nyquist::num::cos_pi(0.3 * t);
/// let sampling = Sampling::of(&times, &[0.0; 39])?;
/// let between = Interpolator::new(&sampling, Wanted { edge: Edge::Wrap, ..Wanted::default() })?;
/// let values: Vec<f64> = times.iter().map(|&t| tone(t)).collect();
/// assert!((between.of(&sampling, &values)?.at(17.0) - tone(17.0)).abs() < 1e-12);
/// let wider = Interpolator::new(&sampling, Wanted { band: Some(0.6), ..Wanted::default() });
/// assert!(wider.is_err()); // 39 samples of 40 cells support no more than 0.4875
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Interpolator {
    pieces: Vec<Piece>,
    left_out: Vec<Range<usize>>,
    slack: f64,
}

/// A stretch of a record, and the way to values between its samples.
#[derive(Debug, Clone)]
pub struct Piece {
    /// Which of the positions.
    pub stretch: Range<usize>,
    /// From the first to the last of them.
    pub between: [f64; 2],
    /// The way.
    pub way: Way,
}

/// The way to values between samples, with its numbers.
#[derive(Debug, Clone)]
pub enum Way {
    /// A kernel of finite radius.
    Kernel {
        /// The samples.
        axis: Axis,
        /// The kernel.
        kernel: Windowed,
        /// How the record goes on.
        edge: Edge,
        /// The band that it was made for.
        band: f64,
        /// The largest error of a tone of that band, as a part of its amplitude; farther than the radius from the ends.
        error: f64,
    },
    /// The trigonometric polynomial through the samples: exact for signals whose period is the record.
    Periodic {
        /// The samples.
        axis: Axis,
    },
    /// Least squares.
    LeastSquares(Recoverable),
}

/// A windowed sinc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Windowed {
    /// Under Kaiser's window.
    Kaiser(Kaiser),
    /// Under a Gaussian.
    Regularised(Regularised),
}

impl Windowed {
    /// For signals that fill the part `r` of the band, as wide as the error `10⁻⁹` needs but at most 512 steps: `e^{−π(1−r)n}`
    /// for Kaiser's window with `β = π(1−r)n`, `e^{−π(1−r)n/2}` for the Gaussian.
    fn new(method: Method, part: f64) -> Result<Self> {
        let exponent = -AIM.ln() / (PI * (1.0 - part));
        let radius = |wide: f64| wide.ceil().clamp(8.0, MOST_RADIUS);
        if method == Method::Regularised {
            return Ok(Self::Regularised(Regularised::for_band(radius(2.0 * exponent), part)?));
        }
        let radius = radius(exponent);
        Ok(Self::Kaiser(Kaiser::new(radius, (PI * (1.0 - part) * radius).min(100.0))?))
    }

    /// The kernel.
    pub fn kernel(&self) -> &dyn Kernel {
        match self {
            Self::Kaiser(kernel) => kernel,
            Self::Regularised(kernel) => kernel,
        }
    }

    /// `max |K(ν) − 1| + Σ_{m≠0} |K(ν + m)|` over the band: what a tone loses, and what its images add.
    fn error(&self, part: f64) -> f64 {
        let kernel = self.kernel();
        let off = |nu: f64| {
            let images: f64 =
                (1..=4).map(f64::from).map(|m| kernel.response(m - nu).abs() + kernel.response(m + nu).abs()).sum();
            (kernel.response(nu) - 1.0).abs() + images
        };
        (0..=4).map(|i| off(0.125 * f64::from(i) * part)).fold(0.0, f64::max)
    }
}

impl Interpolator {
    /// For the positions of a record.
    ///
    /// # Errors
    /// A method of equally spaced samples where they are not; a band that the positions do not support
    /// ([`Error::OutOfRange`] or [`Error::IllConditioned`], with the numbers); no stretch without a long gap of four
    /// samples, or of two that are equally spaced.
    pub fn new(sampling: &Sampling, wanted: Wanted) -> Result<Self> {
        let (mut pieces, mut left_out) = (Vec::new(), Vec::new());
        for stretch in sampling.stretches() {
            let axis = sampling.axis_of(stretch.clone());
            let enough = if axis.is_some() { 2 } else { FEW };
            if stretch.len() < enough.min(sampling.positions().len()) {
                left_out.push(stretch);
                continue;
            }
            let positions = &sampling.positions()[stretch.clone()];
            let between = [positions[0], positions[positions.len() - 1]];
            pieces.push(Piece { way: way(sampling, stretch.clone(), axis, wanted)?, stretch, between });
        }
        if pieces.is_empty() {
            let got = left_out.iter().map(Range::len).max().unwrap_or(0);
            return Err(Error::TooFew { what: "samples in a row without a long gap", least: FEW, got });
        }
        let positions = sampling.positions();
        let farthest = positions[0].abs().max(positions[positions.len() - 1].abs());
        Ok(Self { pieces, left_out, slack: sampling.rounding() + 4.0 * f64::EPSILON * farthest })
    }

    /// The pieces, in order.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Stretches of too few samples.
    pub fn left_out(&self) -> &[Range<usize>] {
        &self.left_out
    }

    /// Whether `x` lies between the first and the last sample of a piece, to the rounding of positions.
    pub fn covers(&self, x: f64) -> bool {
        let [from, to] = self.pieces[self.nearest(x)].between;
        from - self.slack <= x && x <= to + self.slack
    }

    /// The piece that `x` lies in, or the nearest.
    pub(super) fn nearest(&self, x: f64) -> usize {
        let next = self.pieces.partition_point(|piece| piece.between[0] <= x);
        let before = next.saturating_sub(1);
        match self.pieces.get(next) {
            Some(piece) if next > 0 && piece.between[0] - x < x - self.pieces[before].between[1] => next,
            _ => before,
        }
    }

    /// The values between samples that have these values.
    ///
    /// # Errors
    /// Values of another number than the positions of `sampling`, or that are not finite; what [`Recoverable::fit`]
    /// refuses.
    pub fn of(&self, sampling: &Sampling, values: &[f64]) -> Result<Interpolated<'_>> {
        Interpolated::new(self, sampling.positions().len(), values)
    }
}

fn way(sampling: &Sampling, stretch: Range<usize>, axis: Option<Axis>, wanted: Wanted) -> Result<Way> {
    let equal = || {
        let why = "the methods kaiser, regularised and periodic need equally spaced samples; least-squares does not";
        axis.ok_or(Error::Unsupported(why))
    };
    let by_default = if axis.is_some() { Method::Kaiser } else { Method::LeastSquares };
    match wanted.method.unwrap_or(by_default) {
        Method::Periodic => Ok(Way::Periodic { axis: equal()? }),
        Method::LeastSquares => {
            let nodes = sampling.nodes_of(stretch.clone());
            let positions = &sampling.positions()[stretch];
            Ok(Way::LeastSquares(Recoverable::new(positions, nodes, wanted.edge, wanted.band, wanted.most_condition)?))
        }
        method => {
            let (axis, edge) = (equal()?, wanted.edge);
            let band = positive("the band", wanted.band.unwrap_or(PART * axis.nyquist()))?;
            let part = band / axis.nyquist();
            if part > 0.999 {
                let (what, high) = ("the band that a kernel can interpolate at this rate", 0.999 * axis.nyquist());
                return Err(Error::OutOfRange { what, value: band, low: 0.0, high });
            }
            let kernel = Windowed::new(method, part)?;
            Ok(Way::Kernel { axis, kernel, edge, band, error: kernel.error(part) })
        }
    }
}
