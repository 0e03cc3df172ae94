//! V28, V29, V30: sample and hold, the shutter, uniform supersampling.

use nyquist::laws::hold::{held_image, shutter, supersampled_tone, uniform_transfer};
use nyquist::prelude::*;
use std::f64::consts::PI;

#[test]
fn the_image_of_a_held_tone_has_f_over_one_minus_f_of_its_amplitude() {
    // the staircase's Fourier coefficient, step by step: ∫_{i−½}^{i+½} e^{−2πiνx} dx by hand
    for (p, q) in [(1, 10), (1, 4), (2, 5)] {
        let f = f64::from(p) / f64::from(q);
        let coefficient = |nu: f64| -> f64 {
            let sum: num_complex::Complex<f64> = (0..q)
                .map(f64::from)
                .map(|i| {
                    let wave = |x: f64| num_complex::Complex::cis(-2.0 * PI * nu * x);
                    let step = (wave(i + 0.5) - wave(i - 0.5)) / num_complex::Complex::new(0.0, -2.0 * PI * nu);
                    step * (2.0 * PI * f * i + 0.3).cos()
                })
                .sum();
            sum.norm()
        };
        let ratio = coefficient(1.0 - f) / coefficient(f);
        assert!((ratio - f / (1.0 - f)).abs() < 1e-13, "{p}/{q}");
        assert!(held_image(&BoxKernel, p, q as u32).unwrap().holds());
        // through a tent it is the square: the law is about the hold alone
        assert!(!held_image(&TentKernel, p, q as u32).unwrap().holds());
    }
}

#[test]
fn spots_of_phosphor_damp_the_image_of_a_tone_at_a_tenth_to_two_percent() {
    // Gaussian spots of σ = ½: e^{−2π²σ²(0.81 − 0.01)} = 0.0193, and the raster ripples by ±2e^{−2π²σ²} = ±1.44 %
    let spot = GaussianKernel::new(0.5, 6.0).unwrap();
    assert!((spot.response(0.9) / spot.response(0.1) - 0.0193).abs() < 5e-5);
    assert!((nyquist::kernel::metrics::dc_ripple(&spot) - 0.0144).abs() < 5e-5);
}

#[test]
fn a_half_open_shutter_leaves_two_thirds_of_the_wagon_wheels_spokes() {
    let (rate, tau) = (23.2, 1.0 / 48.0);
    // the mean over the opening, by the midpoint rule
    let n = 10_000;
    let mean: f64 = (0..n)
        .map(|i| tau * ((f64::from(i) + 0.5) / f64::from(n) - 0.5))
        .map(|t| (2.0 * PI * rate * t).cos())
        .sum::<f64>()
        / f64::from(n);
    assert!((mean - 0.658).abs() < 5e-4);
    assert!(shutter(rate, tau, mean).unwrap().measured < 1e-7);
    assert!(!shutter(rate, tau, 0.0).unwrap().holds(), "it is not removed");
}

#[test]
fn four_samples_a_pixel_let_pass_what_the_pixels_box_would_stop() {
    let by_hand = |n: u32, nu: f64| {
        let taps = (0..n).map(|j| (f64::from(j) + 0.5) / f64::from(n) - 0.5);
        taps.map(|x| (2.0 * PI * nu * x).cos()).sum::<f64>() / f64::from(n)
    };
    assert!((by_hand(4, 3.9) + 0.984_64).abs() < 5e-6);
    assert!(((PI * 3.9).sin() / (PI * 3.9) + 0.025_22).abs() < 5e-6);
    for n in 1..=9 {
        for i in 0..100 {
            let nu = 0.173 * f64::from(i);
            assert!((uniform_transfer(n, nu) - by_hand(n, nu)).abs() < 1e-13, "{n} taps at {nu}");
            assert!(supersampled_tone(n, nu, by_hand(n, nu)).holds());
        }
        // at the multiples of n everything passes, and the quotient of sines is 0/0
        for k in 0..4 {
            let nu = f64::from(n * k);
            assert!((uniform_transfer(n, nu).abs() - 1.0).abs() < 1e-15);
            assert!((uniform_transfer(n, nu) - by_hand(n, nu)).abs() < 1e-13, "{n} taps at {nu}");
        }
    }
}
