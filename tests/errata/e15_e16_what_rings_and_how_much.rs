//! E15, E16: how much rings, and what the square wave is made of.

use nyquist::laws::gibbs::{ringing, wilbraham_gibbs};
use nyquist::prelude::*;
use std::f64::consts::PI;

/// The sinc interpolation of a step by brute force: `Σ_{0≤k<N} sinc(x−k)`, the sample at zero being `on_jump`. Cut off far
/// from the jump, at `N = 40 000`, where at most 1/(πN) = 8·10⁻⁶ is missing.
fn by_force(x: f64, on_jump: f64) -> f64 {
    let sinc = |t: f64| if t == 0.0 { 1.0 } else { (PI * t).sin() / (PI * t) };
    (1..40_000).rev().map(|k| sinc(x - f64::from(k))).sum::<f64>() + on_jump * sinc(x)
}

/// The largest value on a grid of thousandths; flat to 10⁻⁵ about the maximum.
fn top(f: impl Fn(f64) -> f64) -> f64 {
    (0..1900).map(|i| f(f64::from(i) / 1000.0)).fold(0.0, f64::max)
}

#[test]
fn e15_a_sampled_step_overshoots_by_14_114_percent_wherever_the_jump_lies_between_samples() {
    assert!((top(|x| by_force(x, 1.0)) - 1.141_14).abs() < 3e-5);
    for jump in [0.1, 0.5, 0.93] {
        let step = from_fn(|x| f64::from(u8::from(x > jump)));
        let samples = Samples::of(&step, Axis::nodes(-5.0..6.0, 11).unwrap());
        let back = reconstruct(&samples, Ideal).edge(Edge::Clamp); // the step goes on for ever
        let peak = top(|x| back.at(1.0 + x));
        assert!((peak - 1.141_141_7).abs() < 1e-5, "jump at {jump}: {peak}");
    }
}

#[test]
fn e15_with_one_half_on_the_jump_it_is_3_289_percent() {
    assert!((top(|x| by_force(x, 0.5)) - 1.032_89).abs() < 3e-5);
    let step = from_fn(|x: f64| 0.5 * (1.0 + if x == 0.0 { 0.0 } else { x.signum() }));
    let samples = Samples::of(&step, Axis::centered(1.0, 11).unwrap());
    let back = reconstruct(&samples, Ideal).edge(Edge::Clamp);
    assert!((top(|x| back.at(x)) - 1.032_891_9).abs() < 1e-5);
}

#[test]
fn e15_the_classical_8_949_percent_belong_to_the_low_passed_continuous_step() {
    // f̃(x) = ∫_{−∞}^{x} 2B·sinc(2Bt) dt by Simpson's rule from the symmetric point zero, where it is ½
    let low_passed = |x: f64| {
        let (n, sinc) = (2000, |t: f64| if t == 0.0 { 1.0 } else { (PI * t).sin() / (PI * t) });
        let h = x / f64::from(n);
        let panel = |i: i32| {
            let a = h * f64::from(i);
            h / 6.0 * (sinc(a) + 4.0 * sinc(a + 0.5 * h) + sinc(a + h))
        };
        0.5 + (0..n).map(panel).sum::<f64>()
    };
    assert!((low_passed(1.0) - 1.089_489_87).abs() < 1e-8); // B = ½: the maximum stands at the first zero of the sinc
    assert!((0.5 + 0.5 * wilbraham_gibbs() - 1.089_489_87).abs() < 1e-8);
    // and not to sampled steps, neither with the jump between samples nor with ½ on it
    for on_jump in [1.0, 0.5] {
        let [peak, _] = ringing(&nyquist::laws::gibbs::sampled_step(on_jump));
        assert!((peak.value - 1.089_489_87).abs() > 0.05);
    }
}

#[test]
fn e15_the_sinc_does_not_ring_on_samples_of_a_band_limited_signal() {
    let f = RaisedCosine::new(1.0).unwrap();
    let samples = Samples::of(&f, Axis::centered(0.5, 101).unwrap());
    let back = reconstruct(&samples, Ideal);
    // at the critical rate all samples but three are zero: nothing is left out
    assert!((0..200).all(|i| (back.at(0.0173 * f64::from(i)) - f.at(0.0173 * f64::from(i))).abs() < 5e-15));
}

#[test]
fn e16_equal_amplitudes_peak_at_5_82_and_make_no_square_wave() {
    let sum = |x: f64, amplitude: &dyn Fn(f64) -> f64| -> f64 {
        (1..=8).map(|k| f64::from(2 * k - 1)).map(|h| amplitude(h) * (2.0 * PI * h * x).sin()).sum()
    };
    let printed = top(|x| sum(x / 40.0, &|_| 1.0));
    assert!((printed - 5.818).abs() < 5e-4, "{printed}");
    let right = top(|x| sum(x / 40.0, &|h| 4.0 / (PI * h)));
    assert!((right - 1.180_284).abs() < 1e-5, "{right}");
    let series = PartialSum::new(Wave::Square, 8, 1.0).unwrap();
    assert!((series.at(1.0 / 32.0) - 1.180_284).abs() < 1e-6);
}
