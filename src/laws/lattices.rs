//! Sampling on lattices of the plane (V26).

use crate::error::Result;
use crate::field::FourierField;
use crate::field::spot::GaussianSpot;
use crate::image::lattice::Lattice;
use crate::laws::Law;
use crate::laws::poisson::sum_rounding;
use crate::num::{cos_pi, sin_pi};
use crate::residual::Residual;
use crate::text::Text;
use num_complex::Complex;

/// Poisson summation in the plane: `|det|·Σ f(p) e^{−2πi k·p} = Σ F(k − k*)` over the lattice and its dual.
///
/// Measured: the largest difference over `frequencies`, the points summed up to `radius` from the origin, the copies up to
/// `reach`. Allowed: the rounding of the left sum plus `tail`, the caller's bound for what both leave out.
///
/// ```
/// use nyquist::laws::lattices::poisson_on;
/// use nyquist::prelude::*;
/// let spot = GaussianSpot::round(0.5)?;
/// let residual = poisson_on(&Lattice::hexagonal(0.6)?, &spot, 4.0, 12.0, &[[0.3, 0.8]], 0.0)?;
/// assert!(residual.holds() && residual.bound < 1e-12);
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// Radii that are not finite or too large.
pub fn poisson_on(
    lattice: &Lattice,
    field: &impl FourierField,
    radius: f64,
    reach: f64,
    frequencies: &[[f64; 2]],
    tail: f64,
) -> Result<Residual> {
    let weights = lattice.times(field, radius)?;
    let copies = lattice.replicated(&field.spectrum(), reach)?;
    let sum = |u: f64, v: f64| -> Complex<f64> {
        let wave = |[x, y]: [f64; 2]| {
            let turns = 2.0 * (u * x + v * y);
            Complex::new(cos_pi(turns), -sin_pi(turns))
        };
        weights.iter().map(|w| w.weight * wave(w.at)).sum()
    };
    let measured = frequencies.iter().map(|&[u, v]| (sum(u, v) - copies.density(u, v)).norm()).fold(0.0, f64::max);
    let size: f64 = weights.iter().map(|w| w.weight.norm()).sum();
    let bound = sum_rounding(weights.len(), size) + tail;
    Ok(Residual::at_most("sum over the lattice = sum of the copies on its dual", measured, bound))
}

/// The copies of a disc of radius `band` on the dual do not overlap, and touch: the distance of nearest copies is twice the
/// radius.
///
/// Measured: the difference, relative to the band. Allowed: rounding, `8ε`.
pub fn copies_touch(lattice: &Lattice, band: f64) -> Residual {
    let measured = (lattice.dual().step() - 2.0 * band).abs() / band;
    Residual::at_most("copies of a disc just touch", measured, 8.0 * f64::EPSILON)
}

/// The copies of a disc of radius `band` do not overlap: the shortfall of their distance, and none is allowed but rounding.
pub fn copies_apart(lattice: &Lattice, band: f64) -> Residual {
    let shortfall = 2.0 - lattice.dual().step() / band;
    Residual::at_most("copies of a disc are apart", shortfall.max(0.0), 8.0 * f64::EPSILON)
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "poisson-on-lattices",
        inventory: &["V26", "V03"],
        says: &Text::fixed(
            "Sampling on a lattice repeats the spectrum on the dual lattice, with gain 1",
            "Дискретизация на решётке повторяет спектр на двойственной решётке с усилением 1",
        ),
        holds: || {
            // e^{−x²/a² − y²/b²}: below ε at 6.2·0.6, its spectrum at 2.4 (a = ½)
            let spot = GaussianSpot::turned([0.5, 0.6], 0.4).expect("positive");
            let frequencies = [[0.0, 0.0], [0.4, 0.1], [-0.9, 1.1], [0.83, 0.0], [2.0, -3.0]];
            let skewed = Lattice::new([0.7, 0.1], [0.2, 0.9]).expect("not parallel");
            [Lattice::square(0.6).expect("positive"), Lattice::hexagonal(0.7).expect("positive"), skewed]
                .map(|l| poisson_on(&l, &spot, 4.0, 8.0, &frequencies, 0.0).expect("the radii are finite"))
                .into()
        },
        breaks: || {
            // the copies of the square lattice are not those of the hexagonal one
            let spot = GaussianSpot::round(0.5).expect("positive");
            let (square, hexagonal) =
                (Lattice::square(0.7).expect("positive"), Lattice::hexagonal(0.7).expect("positive"));
            let copies = square.replicated(&spot.spectrum(), 8.0).expect("finite");
            let sum: f64 = hexagonal.times(&spot, 4.0).expect("finite").iter().map(|w| w.weight.re).sum();
            vec![Residual::near("copies on another lattice", sum, copies.density(0.0, 0.0).re, sum_rounding(200, sum))]
        },
    },
    Law {
        name: "hexagonal-sampling",
        inventory: &["V26"],
        says: &Text::fixed(
            "A round band needs √3/2 of the density on a hexagonal lattice: 13.4 % fewer samples, and the copies just touch",
            "Круглой полосе на гексагональной решётке хватает √3/2 плотности: на 13,4 % меньше отсчётов, и копии лишь касаются",
        ),
        holds: || {
            let mut residuals = Vec::new();
            for band in [0.5, 1.0, 3.7] {
                let square = Lattice::square_for(band).expect("positive");
                let hexagonal = Lattice::hexagonal_for(band).expect("positive");
                let ratio = hexagonal.density() / square.density();
                residuals.push(Residual::near("hexagonal/square density", ratio, 0.75f64.sqrt(), 8.0 * f64::EPSILON));
                residuals.extend([copies_touch(&square, band), copies_touch(&hexagonal, band)]);
                // all six neighbours touch, four on the square
                for (lattice, neighbours) in [(square, 4.0), (hexagonal, 6.0)] {
                    let near = 2.0 * band * (1.0 + 8.0 * f64::EPSILON);
                    let touching = lattice.dual().points(near).expect("few points").len() as f64 - 1.0;
                    residuals.push(Residual::near(
                        "copies that touch the one in the middle",
                        touching,
                        neighbours,
                        0.0,
                    ));
                }
            }
            residuals
        },
        breaks: || {
            // a square lattice of the hexagonal density is too coarse
            let enough = Lattice::hexagonal_for(0.5).expect("positive").density();
            let square = Lattice::square(1.0 / enough.sqrt()).expect("positive");
            vec![copies_apart(&square, 0.5), copies_touch(&square, 0.5)]
        },
    },
];
