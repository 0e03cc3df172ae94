//! E03, E04, E10: the gain of the ideal chain, the argument of the box, and what is multiplied by what.

use nyquist::prelude::*;

fn signal() -> RaisedCosine {
    RaisedCosine::new(0.5).expect("the band is positive")
}

/// What the chain «copies × box» makes of the signal at `x`, the comb's lines weighing `line`.
fn chain(step: f64, line: f64, x: f64) -> f64 {
    let copies = signal().spectrum().replicated(1.0 / step, 4).expect("the arguments are valid").scaled(line);
    copies.low_passed(0.5 / step).expect("the arguments are valid").inverse_at(x).expect("the arguments are valid").re
}

#[test]
fn e03_with_lines_of_weight_one_the_chain_returns_the_signal() {
    for step in [0.125, 0.5, 0.8, 1.0] {
        for x in [0.0, 0.3, 1.7] {
            // the quadrature of inverse_at asks for 1e-15 and rounds to a few ε
            assert!((chain(step, 1.0, x) - signal().at(x)).abs() < 1e-14, "T = {step}, x = {x}");
        }
    }
}

#[test]
fn e03_with_the_printed_weight_the_chain_has_the_gain_one_over_t() {
    for (step, gain) in [(0.125, 8.0), (0.5, 2.0), (0.8, 1.25)] {
        for x in [0.0, 0.3] {
            let literal = chain(step, 1.0 / step, x);
            assert!((literal - gain * signal().at(x)).abs() < 1e-13, "T = {step}");
            assert!((literal - signal().at(x)).abs() > 0.05);
        }
    }
    // a box of height T undoes it: what PBRT's later editions print
    assert!((0.5 * chain(0.5, 2.0, 0.3) - signal().at(0.3)).abs() < 1e-14);
}

#[test]
fn e04_the_box_cuts_a_spectrum_as_a_function_of_frequency_and_a_signal_as_a_function_of_position() {
    let step = 0.8;
    let width = 1.0 / step;
    // Π_{1/T}(ν) on the copies: the signal comes back everywhere
    for x in [0.0, 0.4, 0.7, 2.0] {
        assert!((chain(step, 1.0, x) - signal().at(x)).abs() < 1e-14);
    }
    // Π_{1/T}(x), as printed, on the signal: nothing is left beyond 1/2T …
    let printed = from_fn(|x| Boxcar::new(width).expect("positive").at(x) * signal().at(x));
    assert!(printed.at(0.7) == 0.0 && signal().at(0.7) > 0.2);
    // … and its spectrum does not end any more: the jump at ±1/2T decays like 1/ν
    let axis = Axis::centered(1.0 / 512.0, 4096).unwrap();
    let bins = forward(&Samples::of(&printed, axis));
    let beyond = bins.magnitudes().filter(|p| p[0].abs() > 2.0 && p[0].abs() < 20.0).map(|p| p[1]).fold(0.0, f64::max);
    assert!(beyond > 0.01, "{beyond}");
    let whole = forward(&Samples::of(&signal(), Axis::centered(1.0 / 8.0, 4096).unwrap()));
    let beyond = whole.magnitudes().filter(|p| p[0].abs() > 0.55).map(|p| p[1]).fold(0.0, f64::max);
    assert!(beyond < 1e-5, "{beyond}"); // what 256 units of x⁻³ leave out, off the edge
}

/// How far apart the copies are that the samples at `step` see: the least shift of the spectrum of the samples onto
/// itself, found among multiples of 1/20.
fn spacing(step: f64) -> f64 {
    let f = RaisedCosine::new(0.2).expect("the arguments are valid"); // narrow enough for copies of all these spacings to stand apart
    let samples = Samples::of(&f, Axis::centered(step, 4001).expect("the arguments are valid"));
    let at = |nu: f64| dtft(&samples, nu).re;
    let repeats = |shift: f64| (0..20).map(|i| 0.03 * f64::from(i)).all(|nu| (at(nu + shift) - at(nu)).abs() < 1e-9);
    (1..=80).map(|k| 0.05 * f64::from(k)).find(|shift| repeats(*shift)).expect("copies within 4")
}

#[test]
fn e10_a_signal_times_the_comb_in_space_has_copies_at_the_lines_of_the_combs_spectrum() {
    for step in [0.5, 0.8] {
        assert!((spacing(step) - 1.0 / step).abs() < 1e-9, "T = {step}");
    }
}

#[test]
fn e10_a_signal_times_the_comb_of_the_spectrum_has_not() {
    // «произведение сигнала на гребенку спектра», literally: impulses 1/T apart, whose copies are T apart
    for step in [0.5, 0.8] {
        let literal = spacing(1.0 / step);
        assert!((literal - step).abs() < 1e-9 && (literal - 1.0 / step).abs() > 0.1, "T = {step}: {literal}");
    }
}
