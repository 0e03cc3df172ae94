//! Sampling lattices of the plane: square, hexagonal, or any other, and the copies that they make.

use crate::error::{Error, Result, finite, positive};
use crate::field::Field;
use crate::field::spectrum::{PlaneImpulse, PlaneSpectrum};

/// The points `m·a + n·b` for all whole `m`, `n`.
///
/// Sampling on a lattice repeats the spectrum on its [dual](Lattice::dual); the comb is `|det|·Σ δ(p − p_mn)`, so that the
/// copies have gain 1.
///
/// ```
/// use nyquist::prelude::*;
/// // the least density that keeps the copies of a round band apart: hexagonal, 13.4 % less than square
/// let (square, hexagonal) = (Lattice::square_for(0.5)?, Lattice::hexagonal_for(0.5)?);
/// assert!((hexagonal.density() / square.density() - 0.75f64.sqrt()).abs() < 1e-15);
/// assert!((hexagonal.widest_disc() - 0.5).abs() < 1e-15);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lattice {
    basis: [[f64; 2]; 2],
}

impl Lattice {
    /// The lattice that `a` and `b` span.
    ///
    /// # Errors
    /// Vectors that are not finite, or nearly parallel: less than `10⁻¹²` of the product of their lengths between them.
    pub fn new(a: [f64; 2], b: [f64; 2]) -> Result<Self> {
        for part in [a[0], a[1], b[0], b[1]] {
            finite("a basis vector of a lattice", part)?;
        }
        let area = finite("the area of a lattice's cell", determinant([a, b]))?.abs();
        positive("the area of a lattice's cell", area)?;
        if area < 1e-12 * a[0].hypot(a[1]) * b[0].hypot(b[1]) {
            return Err(Error::Unsupported("a lattice whose basis vectors are parallel"));
        }
        Ok(Self { basis: [a, b] })
    }

    /// Squares of the side `step`.
    ///
    /// # Errors
    /// A step that is not positive and finite.
    pub fn square(step: f64) -> Result<Self> {
        positive("the step of a lattice", step)?;
        Self::new([step, 0.0], [0.0, step])
    }

    /// Neighbours at the distance `step` in six directions, one of them along x.
    ///
    /// # Errors
    /// A step that is not positive and finite.
    pub fn hexagonal(step: f64) -> Result<Self> {
        positive("the step of a lattice", step)?;
        Self::new([step, 0.0], [0.5 * step, 0.75f64.sqrt() * step])
    }

    /// The coarsest square lattice that samples a round band: the copies of the disc of that radius just touch.
    ///
    /// # Errors
    /// A band that is not positive and finite.
    pub fn square_for(band: f64) -> Result<Self> {
        Self::square(0.5 / positive("the band of a lattice", band)?)
    }

    /// The coarsest hexagonal lattice that samples a round band, and the coarsest lattice of all that does: it needs
    /// √3/2 = 0.8660 of the density of the square one (Petersen and Middleton 1962).
    ///
    /// # Errors
    /// A band that is not positive and finite.
    pub fn hexagonal_for(band: f64) -> Result<Self> {
        // the dual of the lattice with step s has the step 2/(√3·s), which must be 2B
        Self::hexagonal(1.0 / (3f64.sqrt() * positive("the band of a lattice", band)?))
    }

    /// The two vectors.
    pub fn basis(&self) -> [[f64; 2]; 2] {
        self.basis
    }

    /// Points per area, `1/|det|`.
    pub fn density(&self) -> f64 {
        1.0 / determinant(self.basis).abs()
    }

    /// The dual lattice, `a*·a = b*·b = 1`, `a*·b = b*·a = 0`: where the copies of the spectrum stand.
    #[must_use]
    pub fn dual(&self) -> Self {
        let [[ax, ay], [bx, by]] = self.basis;
        let det = determinant(self.basis);
        Self { basis: [[by / det, -bx / det], [-ay / det, ax / det]] }
    }

    /// The same lattice with its two shortest vectors for a basis (Lagrange 1773, Gauss 1801).
    #[must_use]
    pub fn reduced(&self) -> Self {
        let [mut a, mut b] = self.basis;
        loop {
            if norm(b) < norm(a) {
                (a, b) = (b, a);
            }
            let whole = (dot(a, b) / dot(a, a)).round();
            let less = [b[0] - whole * a[0], b[1] - whole * a[1]];
            // nothing more to be had, or nothing but rounding
            if whole == 0.0 || norm(less) >= norm(b) {
                return Self { basis: [a, b] };
            }
            b = less;
        }
    }

    /// The distance between nearest neighbours.
    pub fn step(&self) -> f64 {
        norm(self.reduced().basis[0])
    }

    /// The radius of the widest round band that this lattice samples without overlap: half the step of the dual.
    pub fn widest_disc(&self) -> f64 {
        0.5 * self.dual().step()
    }

    /// The points at most `radius` from the origin, from row to row.
    ///
    /// # Errors
    /// A radius that is not finite, or so large that more than 2²⁴ points would have to be looked at.
    pub fn points(&self, radius: f64) -> Result<Vec<[f64; 2]>> {
        finite("the radius of a lattice", radius)?;
        let [a, b] = self.reduced().basis;
        // |n| ≤ r·|a|/|det|, and for each n |m + n·(a·b)/(a·a)| ≤ r/|a|
        let rows = (radius * norm(a) / determinant([a, b]).abs()).max(0.0).floor();
        let row = (radius / norm(a)).max(0.0).floor();
        let (value, most) = ((2.0 * rows + 1.0) * (2.0 * row + 2.0), 16_777_216.0);
        if value > most {
            return Err(Error::Overflow { what: "the number of points of a lattice", value, most });
        }
        let mut points = Vec::new();
        for n in -(rows as i64)..=rows as i64 {
            let middle = -(n as f64) * dot(a, b) / dot(a, a);
            for m in (middle - row).floor() as i64..=(middle + row).ceil() as i64 {
                let point = [m as f64 * a[0] + n as f64 * b[0], m as f64 * a[1] + n as f64 * b[1]];
                if norm(point) <= radius {
                    points.push(point);
                }
            }
        }
        Ok(points)
    }

    /// `Ш·f`: the weights `|det|·f(p)` at the points at most `radius` from the origin.
    ///
    /// # Errors
    /// As [`Lattice::points`].
    pub fn times(&self, field: &impl Field, radius: f64) -> Result<Vec<PlaneImpulse>> {
        let area = determinant(self.basis).abs();
        Ok(self.points(radius)?.into_iter().map(|p| PlaneImpulse::new(p, area * field.at(p[0], p[1]))).collect())
    }

    /// The copies of a spectrum that sampling on this lattice makes: one at every point of the dual at most `radius` from
    /// zero, with gain 1.
    ///
    /// # Errors
    /// As [`Lattice::points`] of the dual.
    pub fn replicated(&self, spectrum: &PlaneSpectrum, radius: f64) -> Result<PlaneSpectrum> {
        let copies = self.dual().points(radius)?;
        let lines: Vec<PlaneSpectrum> = copies.iter().map(|&p| spectrum.lines_at(p)).collect();
        let lines = lines.iter().fold(PlaneSpectrum::zero(), |sum, copy| sum.plus(copy));
        if !spectrum.has_density() {
            return Ok(lines);
        }
        let one = spectrum.clone();
        let density =
            PlaneSpectrum::density_of(move |u, v| copies.iter().map(|p| one.density(u - p[0], v - p[1])).sum());
        Ok(lines.plus(&density))
    }
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn norm(a: [f64; 2]) -> f64 {
    a[0].hypot(a[1])
}

fn determinant([[ax, ay], [bx, by]]: [[f64; 2]; 2]) -> f64 {
    ax * by - ay * bx
}
