//! The response of every kernel is the transform of its value: against Simpson's rule and the formulas as printed.

use nyquist::kernel::catalog;
use nyquist::num::sinc;
use nyquist::prelude::*;
use std::f64::consts::PI;

/// `2∫₀^r k(t) cos(2πνt) dt` by Simpson's rule on 4096 panels to every quarter of the radius. The kernels are smooth there,
/// with derivatives up to `(2π(1+ν))⁴`: the error is below `r·h⁴/2880·(2π(1+ν))⁴`, and
/// rounding adds `ε` for each of the 16384 panels.
fn simpson(kernel: &dyn Kernel, nu: f64) -> (f64, f64) {
    let (r, n) = (kernel.radius(), 4096);
    let f = |t: f64| kernel.at(t) * (2.0 * PI * nu * t).cos();
    let h = 0.25 * r / f64::from(n);
    let mut sum = 0.0;
    for quarter in 0..4 {
        let start = 0.25 * r * f64::from(quarter);
        for i in 0..n {
            let a = start + h * f64::from(i);
            // the box has its half value at the edge: Simpson must see the inner limit there
            let end = if quarter == 3 && i == n - 1 { (a + h).min(r) * (1.0 - 1e-15) } else { a + h };
            sum += h / 6.0 * (f(a) + 4.0 * f(a + 0.5 * h) + f(end));
        }
    }
    (2.0 * sum, 2.0 * r * h.powi(4) / 2880.0 * (2.0 * PI * (1.0 + nu)).powi(4) + 16384.0 * f64::EPSILON)
}

#[test]
fn every_finite_kernel_has_the_response_that_simpsons_rule_gives() {
    for kernel in catalog::all().iter().filter(|k| k.radius().is_finite()) {
        for nu in [0.0, 1e-4, 0.1, 0.25, 0.5, 0.5001, 0.75, 1.0, 1.5, 2.25] {
            let (expected, bound) = simpson(&**kernel, nu);
            let response = kernel.response(nu);
            assert!((response - expected).abs() <= bound, "{} at {nu}: {response} ≠ {expected}", kernel.name());
            assert_eq!(kernel.response(-nu), response, "{} is even", kernel.name());
        }
    }
}

#[test]
fn the_cubics_have_the_values_and_the_spectrum_that_the_paper_prints() {
    for (b, c) in [(1.0 / 3.0, 1.0 / 3.0), (0.0, 0.5), (1.0, 0.0), (0.2, 0.7)] {
        let kernel = Cubic::new(b, c).unwrap();
        // Mitchell & Netravali 1988, equation 8
        let inner = |x: f64| {
            ((12.0 - 9.0 * b - 6.0 * c) * x.powi(3) + (-18.0 + 12.0 * b + 6.0 * c) * x * x + 6.0 - 2.0 * b) / 6.0
        };
        let outer = |x: f64| {
            ((-b - 6.0 * c) * x.powi(3)
                + (6.0 * b + 30.0 * c) * x * x
                + (-12.0 * b - 48.0 * c) * x
                + 8.0 * b
                + 24.0 * c)
                / 6.0
        };
        for i in 0..100 {
            let x = f64::from(i) / 100.0;
            assert!((kernel.at(x) - inner(x)).abs() < 1e-15);
            // the expanded polynomial cancels from 32 down
            assert!((kernel.at(1.0 + x) - outer(1.0 + x)).abs() < 32.0 * f64::EPSILON * (1.0 + b.abs() + c.abs()));
        }
        for w in [0.25, 0.5, 0.75, 1.0, 1.5] {
            let p = (PI * w).powi(-2);
            let printed = (1.0 - b) * 3.0 * p * (sinc(w).powi(2) - sinc(2.0 * w))
                + b * sinc(w).powi(4)
                + c * 2.0 * p * (2.0 * sinc(2.0 * w) + sinc(4.0 * w) - 3.0 * sinc(2.0 * w).powi(2));
            assert!((kernel.response(w) - printed).abs() < 1e-14, "({b}, {c}) at {w}");
        }
    }
}

#[test]
fn the_series_of_the_cubic_response_meets_its_closed_form() {
    // the two branches meet at |πν| = 1; the response is smooth there, so neighbours differ by |K′|·2δ, and |K′| < 4
    let nu = 1.0 / PI;
    for (b, c) in [(1.0 / 3.0, 1.0 / 3.0), (0.0, 0.5), (1.0, 0.0)] {
        let kernel = Cubic::new(b, c).unwrap();
        let jump = kernel.response(nu * (1.0 - 1e-15)) - kernel.response(nu * (1.0 + 1e-15));
        assert!(jump.abs() < 1e-14, "({b}, {c}): {jump:e}");
    }
}

#[test]
fn the_gaussians_of_both_editions_of_pbrt_are_one_curve_cut_off_at_two_radii() {
    let (two, four) = (GaussianKernel::pbrt2(), GaussianKernel::pbrt4());
    for i in 0..150 {
        let x = f64::from(i) / 100.0;
        let printed = |r: f64| (-2.0 * x * x).exp() - (-2.0 * r * r).exp();
        assert!((two.at(x) * two.area() - printed(2.0)).abs() < 1e-15);
        assert!((four.at(x) * four.area() - printed(1.5)).abs() < 1e-15);
    }
    assert_eq!(GaussianKernel::from_alpha(2.0, 2.0).unwrap(), two);
}

#[test]
fn lanczos_is_not_of_unit_gain() {
    // 0.99705… for three lobes: the trapezoid rule on the windowed sinc
    for (lobes, gain) in [(2.0, 1.009_790), (3.0, 0.997_055), (4.0, 1.001_256)] {
        let kernel = Lanczos::new(lobes).unwrap();
        let n = 100_000;
        let sum: f64 = (1..n)
            .map(|i| {
                let t = lobes * f64::from(i) / f64::from(n);
                (PI * t).sin() * (PI * t / lobes).sin() * lobes / (PI * t).powi(2)
            })
            .sum();
        let integral = 2.0 * (sum + 0.5) * lobes / f64::from(n);
        assert!((integral - gain).abs() < 1e-6 && (kernel.response(0.0) - integral).abs() < 1e-8);
    }
}
