//! What a field is in frequency: a density over the plane, plus lines that carry weight.

use crate::error::{Error, Result, finite};
use crate::num::{cos_pi, sin_pi};
use crate::spectrum::Spectrum;
use num_complex::Complex;
use std::sync::Arc;

/// A Dirac impulse `weight·δ(u − at₀)·δ(v − at₁)` in the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaneImpulse {
    /// Where it stands.
    pub at: [f64; 2],
    /// The volume under it.
    pub weight: Complex<f64>,
}

impl PlaneImpulse {
    /// `weight·δ(· − at)`.
    pub fn new(at: [f64; 2], weight: impl Into<Complex<f64>>) -> Self {
        Self { at, weight: weight.into() }
    }
}

type Density = Arc<dyn Fn(f64, f64) -> Complex<f64> + Send + Sync>;
type Map = Arc<dyn Fn([f64; 2]) -> [f64; 2] + Send + Sync>;

/// `F(u, v) = ∬ f(x, y) e^{−2πi(ux + vy)} dx dy` in closed form: a density and weighted impulses, in cycles per unit.
///
/// ```
/// use nyquist::prelude::*;
/// let grating = Grating::new([0.25, 0.0])?.spectrum();
/// let lines: Vec<_> = grating.lines().iter().map(|l| (l.at, l.weight.re)).collect();
/// assert_eq!(lines, [([-0.25, 0.0], 0.5), ([0.25, 0.0], 0.5)]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone)]
pub struct PlaneSpectrum {
    density: Option<Density>,
    lines: Vec<PlaneImpulse>,
}

impl std::fmt::Debug for PlaneSpectrum {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let density = self.density.as_ref().map(|_| "Fn(f64, f64) -> Complex<f64>");
        f.debug_struct("PlaneSpectrum").field("density", &density).field("lines", &self.lines).finish()
    }
}

impl PlaneSpectrum {
    /// Nothing at any frequency.
    pub fn zero() -> Self {
        Self { density: None, lines: Vec::new() }
    }

    /// A density.
    pub fn density_of(density: impl Fn(f64, f64) -> Complex<f64> + Send + Sync + 'static) -> Self {
        Self { density: Some(Arc::new(density)), lines: Vec::new() }
    }

    /// Lines alone, sorted by `u`, then `v`; lines at the same place are added up.
    ///
    /// # Errors
    /// A position or weight that is not finite.
    pub fn of_lines(lines: impl IntoIterator<Item = PlaneImpulse>) -> Result<Self> {
        let lines: Vec<_> = lines.into_iter().collect();
        for line in &lines {
            finite("the frequency of a line", line.at[0] + line.at[1])?;
            finite("the weight of a line", line.weight.norm())?;
        }
        Ok(Self::build(None, lines))
    }

    /// Lines that are known to be finite.
    pub(super) fn build(density: Option<Density>, mut lines: Vec<PlaneImpulse>) -> Self {
        // 0.0 and −0.0 are one place: adding zero makes them one number
        let key = |l: &PlaneImpulse| l.at.map(|nu| nu + 0.0);
        lines.sort_by(|a, b| {
            let ([a0, a1], [b0, b1]) = (key(a), key(b));
            a0.total_cmp(&b0).then(a1.total_cmp(&b1))
        });
        lines.dedup_by(|b, a| {
            let same = a.at == b.at;
            if same {
                a.weight += b.weight;
            }
            same
        });
        Self { density, lines }
    }

    /// `F(u)·G(v)`: the transform of `f(x)·g(y)`. A separable field is two signals, and its transform two transforms.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// let (wide, narrow) = (Gaussian::new(2.0)?, Gaussian::new(1.0)?);
    /// let spectrum = PlaneSpectrum::separable(&wide.spectrum(), &narrow.spectrum())?;
    /// assert_eq!(spectrum.density(0.0, 0.0).re, 2.0);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Unsupported`] where one signal has lines and the other a density: that product is a wall along a line of
    /// the plane, neither a density nor an impulse.
    pub fn separable(f: &Spectrum, g: &Spectrum) -> Result<Self> {
        let walls = |a: &Spectrum, b: &Spectrum| !a.lines().is_empty() && b.has_density();
        if walls(f, g) || walls(g, f) {
            return Err(Error::Unsupported("the product of a line in one direction and a density in the other"));
        }
        let each = |l: &crate::spectrum::Impulse| {
            let l = *l;
            g.lines().iter().map(move |m| PlaneImpulse::new([l.at, m.at], l.weight * m.weight)).collect::<Vec<_>>()
        };
        let lines = f.lines().iter().flat_map(each).collect();
        let density: Option<Density> = (f.has_density() && g.has_density()).then(|| {
            let (f, g) = (f.clone(), g.clone());
            Arc::new(move |u: f64, v: f64| f.density(u) * g.density(v)) as Density
        });
        Ok(Self::build(density, lines))
    }

    /// The density at a frequency, without the lines.
    pub fn density(&self, u: f64, v: f64) -> Complex<f64> {
        self.density.as_ref().map_or(Complex::ZERO, |density| density(u, v))
    }

    /// Whether there is a density at all.
    pub fn has_density(&self) -> bool {
        self.density.is_some()
    }

    /// The lines, sorted.
    pub fn lines(&self) -> &[PlaneImpulse] {
        &self.lines
    }

    /// `F + G`: the transform of the sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let density: Option<Density> = match (self.density.clone(), other.density.clone()) {
            (Some(f), Some(g)) => Some(Arc::new(move |u, v| f(u, v) + g(u, v))),
            (f, g) => f.or(g),
        };
        Self::build(density, self.lines.iter().chain(&other.lines).copied().collect())
    }

    /// `H·F`: what a filter of that response leaves.
    #[must_use]
    pub fn times(&self, response: impl Fn(f64, f64) -> Complex<f64> + Send + Sync + 'static) -> Self {
        let response = Arc::new(response);
        let weigh = |l: &PlaneImpulse| PlaneImpulse { weight: l.weight * response(l.at[0], l.at[1]), ..*l };
        let lines = self.lines.iter().map(weigh).collect();
        let density = self.density.clone().map(|f| Arc::new(move |u: f64, v: f64| f(u, v) * response(u, v)) as Density);
        Self::build(density, lines)
    }

    /// `e^{−2πi(u·x₀ + v·y₀)}·F`: the transform of the field moved by `(x₀, y₀)`.
    #[must_use]
    pub fn turned(&self, [x, y]: [f64; 2]) -> Self {
        self.times(move |u, v| {
            let turns = 2.0 * (u * x + v * y);
            Complex::new(cos_pi(turns), -sin_pi(turns))
        })
    }

    /// `F(u − u₀, v − v₀)`: the transform of the field times `e^{2πi(u₀x + v₀y)}`; a copy.
    #[must_use]
    pub fn translated(&self, [u0, v0]: [f64; 2]) -> Self {
        let density = self.density.clone().map(|f| Arc::new(move |u: f64, v: f64| f(u - u0, v - v0)) as Density);
        Self { density, ..self.lines_at([u0, v0]) }
    }

    /// The lines alone, moved by a frequency.
    pub(crate) fn lines_at(&self, [u0, v0]: [f64; 2]) -> Self {
        let shift = |l: &PlaneImpulse| PlaneImpulse { at: [l.at[0] + u0, l.at[1] + v0], ..*l };
        Self::build(None, self.lines.iter().map(shift).collect())
    }

    /// `gain·F(to(ν))` for a linear map of the frequencies; lines, which keep their weight, go the other way, by `from`.
    pub(super) fn mapped(&self, to: Map, from: Map, gain: f64) -> Self {
        let lines = self.lines.iter().map(|l| PlaneImpulse { at: from(l.at), ..*l }).collect();
        let density = self.density.clone().map(|f| {
            Arc::new(move |u: f64, v: f64| {
                let [u, v] = to([u, v]);
                f(u, v) * gain
            }) as Density
        });
        Self::build(density, lines)
    }
}
