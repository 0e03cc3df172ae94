//! E21: an edge has no «infinite frequencies»; its spectrum falls like 1/ν and never ends, so the error of sampling it
//! falls only like √T.

use nyquist::num::quadrature::{even_breaks, integrate_pieces};
use nyquist::prelude::*;

/// `‖f̃ − f‖₂` for a pulse on `[0, 1)`, jumps half-way between samples `step = 1/n` apart, by the cardinal series and
/// quadrature from −4 to 5: beyond, the alternating terms leave `T/(2πx²)`, whose energy is below T²/1000.
fn pulse_error(n: u32) -> f64 {
    let step = 1.0 / f64::from(n);
    let samples =
        Samples::new(Axis::cells(0.0..1.0, n as usize).expect("the arguments are valid"), vec![1.0; n as usize])
            .expect("the arguments are valid");
    let back = reconstruct(&samples, Ideal);
    let energy = |low: f64, high: f64, value: f64| {
        let breaks = even_breaks(low, high, 0.5 * step);
        integrate_pieces(|x| (back.at(x) - value).powi(2), &breaks, 1e-9).value
    };
    (energy(-4.0, 0.0, 0.0) + energy(0.0, 1.0, 1.0) + energy(1.0, 5.0, 0.0)).sqrt()
}

/// The least-squares slope of `log error` against `log T`.
fn slope(errors: &[(f64, f64)]) -> f64 {
    let n = errors.len() as f64;
    let (mx, my) = errors.iter().fold((0.0, 0.0), |(a, b), (t, e)| (a + t.ln() / n, b + e.ln() / n));
    let (xy, xx) =
        errors.iter().fold((0.0, 0.0), |(a, b), (t, e)| (a + (t.ln() - mx) * (e.ln() - my), b + (t.ln() - mx).powi(2)));
    xy / xx
}

#[test]
fn the_error_of_a_sampled_edge_falls_like_the_root_of_the_step() {
    let errors: Vec<(f64, f64)> = [8, 16, 32, 64].map(|n| (1.0 / f64::from(n), pulse_error(n))).into();
    let slope = slope(&errors);
    // each edge errs by g(x/T), of energy T·‖g‖²; the other edge, n samples away, adds terms of order T²: with n ≥ 8 the
    // energy is proportional to T up to 2 %, the slope ½ up to ½·2 %/ln 8
    assert!((slope - 0.5).abs() < 0.005, "{slope}");
    for pair in errors.windows(2) {
        assert!(((pair[0].1 / pair[1].1).powi(2) - 2.0).abs() < 0.04, "{errors:?}"); // energy ∝ T
    }
}

#[test]
fn a_signal_whose_frequencies_end_errs_by_nothing_once_the_step_is_small_enough() {
    let f = RaisedCosine::new(1.0).unwrap();
    for step in [0.5, 0.25] {
        let samples = Samples::of(&f, Axis::centered(step, 4001).unwrap());
        let back = reconstruct(&samples, Ideal);
        let worst = (0..50).map(|i| 0.05 * f64::from(i)).map(|x| (back.at(x) - f.at(x)).abs()).fold(0.0, f64::max);
        assert!(worst < 1e-9, "T = {step}: {worst}"); // x⁻³ beyond 500 units
    }
}

#[test]
fn the_spectrum_of_an_edge_is_unbounded_and_yet_almost_all_of_it_lies_low() {
    // printed: «infinite frequencies». The box has some density beyond every frequency …
    let spectrum = Boxcar::new(1.0).unwrap().spectrum();
    assert_eq!(spectrum.band(), f64::INFINITY);
    for k in [10, 1000, 100_000] {
        let nu = f64::from(k) + 0.5;
        // … but only 1/(πν) of it
        assert!((spectrum.density(nu).norm() * std::f64::consts::PI * nu - 1.0).abs() < 1e-9);
    }
    // 97 % of the energy lies below ν = 3, and beyond ν there is 1/(π²ν) of it
    let energy = |nu: f64| {
        let breaks = even_breaks(-nu, nu, 0.5);
        integrate_pieces(|f| spectrum.density(f).norm_sqr(), &breaks, 1e-13).value
    };
    for nu in [3.0, 10.0, 30.0] {
        let rest = 1.0 - energy(nu);
        // ∫ sin²/(πν)² beyond an integer ν, both sides: 1/(π²ν) less an oscillation of 1/(2π²ν²) = 0.05/ν² of it
        assert!((rest * std::f64::consts::PI.powi(2) * nu - 1.0).abs() < 0.1 / (nu * nu), "{nu}: {rest}");
    }
}
