//! V06: smoothing, postaliasing, ripple and overshoot, against plain sums over printed formulas.

use nyquist::kernel::metrics::{Metrics, dc_ripple, overshoot, postaliasing, smoothing};
use nyquist::prelude::*;
use std::f64::consts::PI;

/// `∫_a^b` by the midpoint rule with 20 000 panels.
fn midpoint(f: impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
    let h = (b - a) / 20_000.0;
    (0..20_000).map(|i| f(a + h * (f64::from(i) + 0.5))).sum::<f64>() * h
}

#[test]
fn box_and_tent_have_the_integrals_of_sinc_squared_and_sinc_to_the_fourth() {
    let sinc = |x: f64| (PI * x).sin() / (PI * x);
    let (box_pass, tent_pass) =
        (2.0 * midpoint(|x| sinc(x).powi(2), 0.0, 0.5), 2.0 * midpoint(|x| sinc(x).powi(4), 0.0, 0.5));
    assert!((smoothing(&BoxKernel) - (1.0 - box_pass)).abs() < 1e-9);
    assert!((smoothing(&TentKernel) - (1.0 - tent_pass)).abs() < 1e-9);
    // ∫ box² = 1, ∫ tent² = 2/3
    assert!((postaliasing(&BoxKernel) - (1.0 - box_pass)).abs() < 1e-9);
    assert!((postaliasing(&TentKernel) - (2.0 / 3.0 - tent_pass)).abs() < 1e-9);
}

#[test]
fn postaliasing_is_the_energy_beyond_nyquist_itself() {
    for kernel in [Cubic::mitchell(), Cubic::catmull_rom(), Cubic::b_spline()] {
        // the rest beyond 20 decays like ν⁻⁶ at least
        let beyond = 2.0 * midpoint(|nu| kernel.response(nu).powi(2), 0.5, 20.0);
        assert!((postaliasing(&kernel) - beyond).abs() < 1e-6, "{}", kernel.name());
    }
}

#[test]
fn a_kernel_of_unit_sum_has_no_ripple_and_a_gaussian_has() {
    assert!(dc_ripple(&Cubic::mitchell()) < 4.0 * f64::EPSILON && dc_ripple(&BoxKernel) == 0.0);
    // Poisson: Σk(x−i) = 1 + 2K(1)cos 2πx + 2K(2)cos 4πx + …
    let gaussian = GaussianKernel::pbrt2();
    let series: f64 = (1..200).map(|k| 2.0 * gaussian.response(f64::from(k)).abs()).sum();
    assert!(dc_ripple(&gaussian) <= series + 1e-15 && (dc_ripple(&gaussian) - 0.0143).abs() < 5e-5);
}

#[test]
fn steps_overshoot_as_their_cumulated_kernels_do() {
    // Catmull–Rom between samples: s(x) = k(x) + k(x−1) + k(x−2) + k(1+x…): a cubic of the fraction; its maximum by a fine grid
    let k = |t: f64| {
        let t = t.abs();
        if t < 1.0 {
            (1.5 * t - 2.5) * t * t + 1.0
        } else if t < 2.0 {
            ((-0.5 * t + 2.5) * t - 4.0) * t + 2.0
        } else {
            0.0
        }
    };
    let best = (0..20_000).map(|i| f64::from(i) / 10_000.0).map(|x| (0..5).map(|i| k(x - f64::from(i))).sum::<f64>());
    let expected = best.fold(0.0, f64::max) - 1.0;
    assert!((overshoot(&Cubic::catmull_rom()) - expected).abs() < 1e-7 && (expected - 0.0741).abs() < 5e-5);
    assert!((overshoot(&Cubic::mitchell()) - 0.0363).abs() < 5e-5);
    assert_eq!([overshoot(&BoxKernel), overshoot(&TentKernel)], [0.0, 0.0]);
}

#[test]
fn the_ideal_kernel_takes_nothing_lets_nothing_alias_and_rings_most() {
    let ideal = Metrics::of(&Ideal);
    assert!(ideal.smoothing.abs() < 1e-14 && ideal.postaliasing == 0.0 && ideal.dc_ripple == 0.0);
    assert!((ideal.overshoot - 0.141_141_7).abs() < 5e-8 && (ideal.at_nyquist, ideal.at_rate) == (0.5, 0.0));
    for kernel in nyquist::kernel::catalog::all() {
        let m = Metrics::of(&*kernel);
        assert!(m.smoothing > -1e-13 && m.postaliasing > -1e-13 && m.overshoot <= ideal.overshoot, "{}", kernel.name());
    }
}
