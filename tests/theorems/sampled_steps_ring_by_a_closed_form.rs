//! V02: the answer of the cardinal series to a sampled step, in closed form.

use nyquist::laws::gibbs::{ringing, sampled_step};
use nyquist::prelude::*;
use std::f64::consts::PI;

#[test]
fn half_a_step_behind_the_jump_it_is_one_half_plus_two_over_pi() {
    assert!((Ideal.step_response(0.5) - (0.5 + 2.0 / PI)).abs() < 1e-15);
    // Leibniz: sinc(½) − … = (2/π)(1 + 1 − 1/3 + 1/5 − …), summed in pairs
    let leibniz: f64 = (0..1_000_000).rev().map(f64::from).map(|j| 2.0 / ((4.0 * j + 1.0) * (4.0 * j + 3.0))).sum();
    assert!((Ideal.step_response(0.5) - 2.0 / PI * (1.0 + leibniz)).abs() < 1e-6);
}

#[test]
fn it_passes_through_the_samples_and_is_symmetric_about_the_middle_of_the_jump() {
    for i in -20..20 {
        assert_eq!(Ideal.step_response(f64::from(i)), f64::from(u8::from(i >= 0)));
        let x = f64::from(i) + 0.37;
        assert!((Ideal.step_response(x) + Ideal.step_response(-1.0 - x) - 1.0).abs() < 1e-15);
    }
}

#[test]
fn it_is_the_alternating_sum() {
    // means of neighbouring partial sums converge like N⁻²: an acceleration by hand
    for x in [-7.3, -0.51, -0.5, -0.49, 0.2, 0.4177, 1.5, 3.9, 12.25] {
        let term = |k: i32| (PI * (x - f64::from(k))).sin() / (PI * (x - f64::from(k)));
        let n = 20_000;
        let partial: f64 = (0..n).rev().map(term).sum();
        assert!((Ideal.step_response(x) - partial - 0.5 * term(n)).abs() < 1e-8, "x = {x}");
    }
}

#[test]
fn its_extrema_stand_where_they_were_computed_to_25_digits() {
    let [peak, dip] = ringing(&sampled_step(1.0));
    assert!((peak.value - 1.141_141_7).abs() < 5e-8 && (peak.at - 0.417_735_6).abs() < 1e-7);
    assert!((dip.value - 0.923_599_0).abs() < 5e-8 && (dip.at - 1.453_18).abs() < 5e-6);
    let [half, _] = ringing(&sampled_step(0.5));
    assert!((half.value - 1.032_891_9).abs() < 5e-8 && (half.at - 1.376_99).abs() < 5e-6);
}

#[test]
fn every_kernel_answers_a_step_as_its_reconstruction_does() {
    let samples = Samples::of(&from_fn(|x| f64::from(u8::from(x > -0.5))), Axis::centered(1.0, 21).unwrap());
    for kernel in nyquist::kernel::catalog::all() {
        let back = reconstruct(&samples, &kernel).edge(Edge::Clamp);
        for x in [-3.2, -0.5, 0.0, 0.31, 2.5, 7.7] {
            assert!((back.at(x) - kernel.step_response(x)).abs() < 1e-13, "{} at {x}", kernel.name());
        }
    }
}
