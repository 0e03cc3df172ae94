//! The cubics of Mitchell and Netravali: their values, their spectrum, and how high an order they reach (V04, V05).

use crate::kernel::Kernel;
use crate::kernel::cubic::Cubic;
use crate::laws::Law;
use crate::laws::kernels::{
    FREQUENCIES, moment, places, reproduces_constants, reproduces_lines, response_is_transform,
};
use crate::num::extremum::maximum;
use crate::num::quadrature::integrate_pieces;
use crate::residual::Residual;
use crate::signal::Signal;
use crate::text::Text;

/// `Σ_i i²k(x−i) − x²` does not depend on `x`: the third of the Strang–Fix conditions. The constant is `∫ t²k`, zero for
/// Catmull–Rom, which therefore reproduces parabolas; ⅓ for the cubic B-spline.
///
/// Measured: the spread over a step; beside it the constant is returned.
pub fn second_moment(kernel: &(impl Kernel + ?Sized)) -> (Residual, f64) {
    let (mut low, mut high, mut bound) = (f64::INFINITY, f64::NEG_INFINITY, 0.0f64);
    for x in places() {
        let (sum, rounding) = moment(kernel, 2, x);
        (low, high) = (low.min(sum - x * x), high.max(sum - x * x));
        bound = bound.max(rounding);
    }
    (Residual::at_most("Σi²k(x−i) − x² is constant", high - low, bound), 0.5 * (low + high))
}

/// The cubic B-spline is the box convolved with itself three times: `k(t) = ∫ tent(s)·tent(t−s) ds`, by quadrature between
/// the kinks of both tents (Schoenberg 1946).
///
/// Measured: the largest difference of `kernel` to that. Allowed: the quadrature's error, which is rounding, for quadratic
/// pieces.
pub fn box_four_times(kernel: &(impl Kernel + ?Sized)) -> Residual {
    let tent = |t: f64| (1.0 - t.abs()).max(0.0);
    let (mut measured, mut bound) = (0.0f64, 0.0f64);
    for i in 0..=20 {
        let t = f64::from(i) / 10.0;
        let mut breaks = vec![-1.0, 0.0, 1.0, t - 1.0, t, t + 1.0];
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        let spline = integrate_pieces(|s| tent(s) * tent(t - s), &breaks, 1e-16);
        measured = measured.max((kernel.at(t) - spline.value).abs());
        bound = bound.max(spline.error + 4.0 * f64::EPSILON);
    }
    Residual::at_most("k = box ⊗ box ⊗ box ⊗ box", measured, bound)
}

/// The numbers that the paper's filter is known by: `k(0) = 8/9`, `k(1) = 1/18`, least value −0.03628.
///
/// Allowed: rounding for the fractions, half a unit of the last digit for the least value.
pub fn mitchell_numbers(kernel: &(impl Kernel + ?Sized)) -> [Residual; 3] {
    let least = -maximum(|t| -kernel.at(t), 1.0, 2.0, 16).value;
    [
        Residual::near("k(0) = 8/9", kernel.at(0.0), 8.0 / 9.0, 2.0 * f64::EPSILON),
        Residual::near("k(1) = 1/18", kernel.at(1.0), 1.0 / 18.0, 2.0 * f64::EPSILON),
        Residual::near("min k = −0.03628", least, -0.03628, 5e-6),
    ]
}

fn cubic(b: f64, c: f64) -> Cubic {
    Cubic::new(b, c).expect("B and C are small")
}

/// Cubics on the line `B + 2C = 1` and off it.
const ON_LINE: [[f64; 2]; 5] = [[1.0 / 3.0, 1.0 / 3.0], [0.0, 0.5], [1.0, 0.0], [0.5, 0.25], [-1.0, 1.0]];
const OFF_LINE: [[f64; 2]; 4] = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [0.3, 0.3]];

fn plane() -> impl Iterator<Item = Cubic> {
    ON_LINE.iter().chain(&OFF_LINE).map(|[b, c]| cubic(*b, *c))
}

fn on_line() -> impl Iterator<Item = Cubic> {
    ON_LINE.iter().map(|[b, c]| cubic(*b, *c))
}

fn off_line() -> impl Iterator<Item = Cubic> {
    OFF_LINE.iter().map(|[b, c]| cubic(*b, *c))
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "cubic-spectrum",
        inventory: &["V04"],
        says: &Text::fixed(
            "The cubics of Mitchell and Netravali: their spectrum in closed form, and (1, 0) is the cubic B-spline",
            "Кубические ядра Митчелла и Нетравали: спектр в замкнутой форме, и (1, 0) — кубический B-сплайн",
        ),
        holds: || {
            let mut measured: Vec<Residual> = plane().map(|k| response_is_transform(&k, &FREQUENCIES)).collect();
            measured.push(box_four_times(&Cubic::b_spline()));
            measured.extend(mitchell_numbers(&Cubic::mitchell()));
            measured
        },
        breaks: || {
            let mut measured = vec![response_is_transform(&WrongSign(cubic(0.3, 0.35)), &FREQUENCIES)];
            measured.push(box_four_times(&Cubic::mitchell()));
            measured.extend(mitchell_numbers(&Cubic::catmull_rom()));
            measured
        },
    },
    Law {
        name: "cubic-order",
        inventory: &["V04", "V05"],
        says: &Text::fixed(
            "The cubics reproduce constants for all B, C, and straight lines exactly where B + 2C = 1",
            "Кубические ядра воспроизводят константы при всех B, C, а прямые — только при B + 2C = 1",
        ),
        holds: || {
            let mut measured: Vec<Residual> = plane().map(|k| reproduces_constants(&k)).collect();
            measured.extend(on_line().map(|k| reproduces_lines(&k)));
            measured.extend(on_line().map(|k| second_moment(&k).0));
            let parabolas = second_moment(&Cubic::catmull_rom());
            measured.push(Residual::near("Catmull–Rom: Σi²k(x−i) = x²", parabolas.1, 0.0, parabolas.0.bound));
            measured
        },
        breaks: || {
            let lines = off_line().map(|k| reproduces_lines(&k));
            lines.chain(off_line().map(|k| second_moment(&k).0)).collect()
        },
    },
];

/// A cubic whose spectrum has the sign of the `C` term wrong, the slip that the formula invites.
struct WrongSign(Cubic);

impl Signal for WrongSign {
    fn at(&self, t: f64) -> f64 {
        self.0.at(t)
    }
}

impl Kernel for WrongSign {
    fn name(&self) -> String {
        self.0.name()
    }
    fn radius(&self) -> f64 {
        self.0.radius()
    }
    fn claims(&self) -> crate::kernel::Claims {
        self.0.claims()
    }
    fn response(&self, nu: f64) -> f64 {
        cubic(self.0.b(), -self.0.c()).response(nu)
    }
}
