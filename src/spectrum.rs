//! What a signal is in frequency: a density, plus lines that carry weight.

use crate::error::{Error, Result, finite, positive};
use crate::num::quadrature::{even_breaks, integrate_pieces};
use num_complex::Complex;
use std::sync::Arc;

/// A Dirac impulse `weight·δ(· − at)`: a position and a weight, never a tall sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Impulse {
    /// Where it stands.
    pub at: f64,
    /// How much it weighs: the area under it.
    pub weight: Complex<f64>,
}

impl Impulse {
    /// `weight·δ(· − at)`.
    pub fn new(at: f64, weight: impl Into<Complex<f64>>) -> Self {
        Self { at, weight: weight.into() }
    }
}

type Density = Arc<dyn Fn(f64) -> Complex<f64> + Send + Sync>;

/// A Fourier transform `F(ν) = ∫ f(x) e^{−2πiνx} dx` in closed form: a density and weighted lines.
///
/// Frequencies are in cycles per unit; no factor stands in front in either direction. `band` is the exact support:
/// the spectrum is zero for `|ν| > band`; it is infinite for signals that are not band-limited. `extent` is where the
/// density has become invisible beside its peak in `f64`: equal to the band where that is finite, finite for a
/// Gaussian, infinite where the density decays algebraically.
///
/// ```
/// use nyquist::prelude::*;
/// // cos(2π·3x) is two lines of weight ½, and no density at all
/// let tone = Cosine::new(3.0)?.spectrum();
/// assert_eq!(tone.lines().iter().map(|l| (l.at, l.weight.re)).collect::<Vec<_>>(), [(-3.0, 0.5), (3.0, 0.5)]);
/// assert_eq!((tone.density(3.0).norm(), tone.band()), (0.0, 3.0));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone)]
pub struct Spectrum {
    density: Option<Density>,
    lines: Vec<Impulse>,
    band: f64,
    extent: f64,
}

impl std::fmt::Debug for Spectrum {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Spectrum")
            .field("density", &self.density.as_ref().map(|_| "Fn(f64) -> Complex<f64>"))
            .field("lines", &self.lines)
            .field("band", &self.band)
            .field("extent", &self.extent)
            .finish()
    }
}

impl Spectrum {
    /// Nothing at any frequency.
    pub fn zero() -> Self {
        Self { density: None, lines: Vec::new(), band: 0.0, extent: 0.0 }
    }

    /// A density that is zero beyond `band` (infinite if it never ends); it need not vanish there by itself.
    /// Exactly at `±band` the given value is taken as it is.
    pub fn density_of(band: f64, density: impl Fn(f64) -> Complex<f64> + Send + Sync + 'static) -> Self {
        let within = move |nu: f64| if nu.abs() <= band { density(nu) } else { Complex::ZERO };
        Self { density: Some(Arc::new(within)), lines: Vec::new(), band, extent: band }
    }

    /// A density without an end that is below rounding beyond `extent`.
    pub fn decaying(extent: f64, density: impl Fn(f64) -> Complex<f64> + Send + Sync + 'static) -> Self {
        Self { density: Some(Arc::new(density)), lines: Vec::new(), band: f64::INFINITY, extent }
    }

    /// Lines alone, sorted by frequency; lines at the same place are added up.
    ///
    /// # Errors
    /// A position or weight that is not finite.
    pub fn of_lines(lines: impl IntoIterator<Item = Impulse>) -> Result<Self> {
        let lines: Vec<Impulse> = lines.into_iter().collect();
        for line in &lines {
            finite("the frequency of a line", line.at)?;
            finite("the weight of a line", line.weight.norm())?;
        }
        Ok(Self::from_lines(lines))
    }

    /// Lines whose places and weights are known to be finite.
    pub(crate) fn from_lines(mut lines: Vec<Impulse>) -> Self {
        lines.sort_by(|a, b| a.at.total_cmp(&b.at));
        lines.dedup_by(|b, a| {
            // 0.0 and -0.0 are one place, hence == and not the total order
            let same = a.at == b.at;
            if same {
                a.weight += b.weight;
            }
            same
        });
        let band = lines.iter().fold(0.0, |band: f64, line| band.max(line.at.abs()));
        Self { density: None, lines, band, extent: band }
    }

    /// The density at frequency `nu`, without the lines.
    pub fn density(&self, nu: f64) -> Complex<f64> {
        self.density.as_ref().map_or(Complex::ZERO, |density| density(nu))
    }

    /// Whether there is a density at all.
    pub fn has_density(&self) -> bool {
        self.density.is_some()
    }

    /// The lines, sorted by frequency.
    pub fn lines(&self) -> &[Impulse] {
        &self.lines
    }

    /// The exact band limit `B`: nothing beyond `±B`. Infinite for signals that are not band-limited.
    pub fn band(&self) -> f64 {
        self.band
    }

    /// Where the density has sunk below `f64` rounding of its peak; infinite if it decays algebraically.
    pub fn extent(&self) -> f64 {
        self.extent
    }

    /// Whether a line stands exactly at the band limit: then a rate of `2B` does not suffice (E08).
    pub fn has_line_at_band(&self) -> bool {
        self.lines.iter().any(|line| line.at.abs() == self.band && line.weight != Complex::ZERO)
    }

    fn build(density: Option<Density>, lines: Vec<Impulse>, band: f64, extent: f64) -> Self {
        Self { density, band, extent, ..Self::from_lines(lines) }
    }

    /// `F + G`: the transform of the sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let density: Option<Density> = match (self.density.clone(), other.density.clone()) {
            (Some(f), Some(g)) => Some(Arc::new(move |nu| f(nu) + g(nu))),
            (f, g) => f.or(g),
        };
        let lines = self.lines.iter().chain(&other.lines).copied().collect();
        Self::build(density, lines, self.band.max(other.band), self.extent.max(other.extent))
    }

    /// With one more line; the caller's constructor has checked that it is finite.
    #[must_use]
    pub(crate) fn plus_line(mut self, line: Impulse) -> Self {
        self.lines.push(line);
        Self::build(self.density, self.lines, self.band.max(line.at.abs()), self.extent.max(line.at.abs()))
    }

    /// `F·G`: the transform of the convolution. A line of one side is weighed by the density of the other; where lines
    /// of both sides meet the product has no meaning (`δ²`: the convolution of two tones diverges) and nothing is left.
    #[must_use]
    pub fn multiplied(&self, other: &Self) -> Self {
        let weigh = |lines: &[Impulse], by: &Self| {
            let weighed = |l: &Impulse| Impulse { weight: l.weight * by.density(l.at), ..*l };
            lines.iter().map(weighed).collect::<Vec<_>>()
        };
        let lines = [weigh(&self.lines, other), weigh(&other.lines, self)].concat();
        let density: Option<Density> = match (self.density.clone(), other.density.clone()) {
            (Some(f), Some(g)) => Some(Arc::new(move |nu| f(nu) * g(nu))),
            _ => None,
        };
        Self::build(density, lines, self.band.min(other.band), self.extent.min(other.extent))
    }

    /// `H(ν)·F(ν)`: the transform of the convolution with a filter whose response is `response`.
    #[must_use]
    pub fn times(&self, response: impl Fn(f64) -> Complex<f64> + Send + Sync + 'static) -> Self {
        let response = Arc::new(response);
        let lines = self.lines.iter().map(|l| Impulse { weight: l.weight * response(l.at), ..*l }).collect();
        let density = self.density.clone().map(|f| Arc::new(move |nu: f64| f(nu) * response(nu)) as Density);
        Self::build(density, lines, self.band, self.extent)
    }

    /// `gain·F(ν)`.
    #[must_use]
    pub fn scaled(&self, gain: impl Into<Complex<f64>>) -> Self {
        let gain = gain.into();
        self.times(move |_| gain)
    }

    /// `F(ν − by)`: the transform of `f(x) e^{2πi·by·x}`.
    #[must_use]
    pub fn translated(&self, by: f64) -> Self {
        let lines = self.lines.iter().map(|l| Impulse { at: l.at + by, ..*l }).collect();
        let density = self.density.clone().map(|f| Arc::new(move |nu: f64| f(nu - by)) as Density);
        Self::build(density, lines, self.band + by.abs(), self.extent + by.abs())
    }

    /// `|c|·F(cν)`: the transform of `f(x/c)`. A line of weight w at ν becomes a line of the same weight at ν/c, since
    /// `|c|·δ(cν − ν₀) = δ(ν − ν₀/c)` (the factor that the lecture's table forgets, E01).
    #[must_use]
    pub fn stretched(&self, c: f64) -> Self {
        let lines = self.lines.iter().map(|l| Impulse { at: l.at / c, ..*l }).collect();
        let density = self.density.clone().map(|f| Arc::new(move |nu: f64| f(c * nu) * c.abs()) as Density);
        Self::build(density, lines, self.band / c.abs(), self.extent / c.abs())
    }

    /// `Σ_{|k| ≤ order} F(ν − k·rate)`: the copies that sampling at `rate` makes. They have gain 1, because the comb
    /// is `T Σ δ(x − iT)`, and only `order` of them to either side: choose it so that the frequencies looked at are
    /// covered (`order ≥ (|ν| + extent)/rate`); for densities that never end the rest is a tail, not zero.
    ///
    /// # Errors
    /// A rate that is not positive and finite; an order above 2²⁰.
    pub fn replicated(&self, rate: f64, order: usize) -> Result<Self> {
        positive("the sampling rate", rate)?;
        let most = 1 << 20;
        if order > most {
            let what = "the number of copies to either side";
            return Err(Error::Overflow { what, value: order as f64, most: most as f64 });
        }
        let shifts: Vec<f64> = (-(order as i64)..=order as i64).map(|k| k as f64 * rate).collect();
        let copies = |l: &Impulse| shifts.iter().map(|s| Impulse { at: l.at + s, ..*l }).collect::<Vec<_>>();
        let lines = self.lines.iter().flat_map(copies).collect();
        let reach = order as f64 * rate;
        let density = self
            .density
            .clone()
            .map(|f| Arc::new(move |nu: f64| shifts.iter().map(|s| f(nu - s)).sum::<Complex<f64>>()) as Density);
        Ok(Self::build(density, lines, self.band + reach, self.extent + reach))
    }

    /// `Π(ν)·F(ν)` with the ideal low-pass `Π`: one below `cutoff`, ½ exactly at it, zero above (E05).
    ///
    /// # Errors
    /// A cut-off that is not positive and finite.
    pub fn low_passed(&self, cutoff: f64) -> Result<Self> {
        positive("the cut-off frequency", cutoff)?;
        let mut passed = self.times(move |nu| Complex::from(low_pass(nu, cutoff)));
        passed.lines.retain(|line| line.weight != Complex::ZERO);
        passed.band = passed.band.min(cutoff);
        passed.extent = passed.extent.min(cutoff);
        Ok(passed)
    }

    /// `F ⊗ G`: the transform of the product. Exact where either side consists of lines alone; where both have a
    /// density it is an integral, computed at each frequency by quadrature over the shorter extent to about 1e-13 of
    /// its size (the densities must be smooth inside their extents).
    ///
    /// # Errors
    /// [`Error::Unsupported`] where both densities have an infinite extent.
    pub fn convolved(&self, other: &Self) -> Result<Self> {
        let weighted = |lines: &[Impulse], spectrum: &Self| {
            let nothing = Self { density: None, ..Self::zero() };
            lines.iter().fold(nothing, |sum, l| sum.plus(&spectrum.translated(l.at).scaled(l.weight)))
        };
        let other_density = Self { lines: Vec::new(), ..other.clone() };
        let mut sum =
            weighted(&self.lines, other).plus(&weighted(&other.lines, &Self { lines: Vec::new(), ..self.clone() }));
        if let (Some(f), Some(g)) = (self.density.clone(), other_density.density.clone()) {
            let (short, long, extent) =
                if self.extent <= other.extent { (f, g, self.extent) } else { (g, f, other.extent) };
            if extent.is_infinite() {
                return Err(Error::Unsupported("the product of two signals whose spectra both decay algebraically"));
            }
            let reach = if self.extent <= other.extent { other.extent } else { self.extent };
            let density: Density = Arc::new(move |nu| {
                // the long one ends inside the window at ν ± reach: a break there keeps the integrand smooth
                let mut breaks = even_breaks(-extent, extent, extent / 4.0);
                breaks.extend([nu - reach, nu + reach].into_iter().filter(|b| b.abs() < extent));
                breaks.sort_by(f64::total_cmp);
                integrate_pieces(|mu| short(mu) * long(nu - mu), &breaks, 1e-14).value
            });
            sum = sum.plus(&Self::build(Some(density), Vec::new(), 0.0, 0.0));
        }
        sum.band = self.band + other.band;
        sum.extent = self.extent + other.extent;
        Ok(sum)
    }

    /// The energy `∫_a^b |F|² dν` of the density between two frequencies, by quadrature; lines carry power, not
    /// energy, and do not count.
    pub fn energy(&self, a: f64, b: f64) -> f64 {
        let (a, b) = (a.max(-self.extent), b.min(self.extent));
        if a >= b {
            return 0.0;
        }
        let breaks = even_breaks(a, b, (b - a) / 16.0);
        integrate_pieces(|nu| self.density(nu).norm_sqr(), &breaks, 1e-15).value
    }

    /// `f(x) = ∫ F(ν) e^{2πiνx} dν + Σ w e^{2πiν_l x}`: the signal back from its spectrum, by quadrature over the
    /// extent.
    ///
    /// # Errors
    /// [`Error::Unsupported`] where the density has an infinite extent.
    pub fn inverse_at(&self, x: f64) -> Result<Complex<f64>> {
        let wave = |nu: f64| Complex::cis(2.0 * std::f64::consts::PI * nu * x);
        let lines: Complex<f64> = self.lines.iter().map(|l| l.weight * wave(l.at)).sum();
        if !self.has_density() {
            return Ok(lines);
        }
        if self.extent.is_infinite() {
            return Err(Error::Unsupported("the inverse of a spectrum that decays algebraically, by quadrature"));
        }
        // a piece per oscillation of the wave, at least eight; zero is where densities like |ν| have their kink
        let step = (0.5 / x.abs().max(1e-300)).min(self.extent / 4.0);
        let mut breaks = even_breaks(-self.extent, 0.0, step);
        breaks.extend(even_breaks(0.0, self.extent, step).into_iter().skip(1));
        Ok(lines + integrate_pieces(|nu| self.density(nu) * wave(nu), &breaks, 1e-15).value)
    }
}

/// The ideal low-pass `Π`: one for `|ν| < cutoff`, ½ at the edge, zero beyond.
///
/// Both of the lecture's definitions (`|x| < ½` in its table, `|x| ≤ T/2` on its slide) differ from this only at the
/// edge; ½ is the value that the inverse transform gives (E05).
pub fn low_pass(nu: f64, cutoff: f64) -> f64 {
    match nu.abs().partial_cmp(&cutoff) {
        Some(std::cmp::Ordering::Less) => 1.0,
        Some(std::cmp::Ordering::Equal) => 0.5,
        _ => 0.0,
    }
}
