//! What resizing does to a wave is known before it is done: the gain of its weights, at the alias, and at every image.

use num_complex::Complex;
use nyquist::image::resize::{nearest, over, resize};
use nyquist::image::weights::Weights;
use nyquist::prelude::*;

/// `Σ_k f_k e^{−2πiνy_k}/n` over a row: the amplitude of `e^{2πiνy}` in it.
fn amplitude(image: &Image, nu: f64) -> Complex<f64> {
    let wave = |y: f64| Complex::cis(-std::f64::consts::TAU * (nu * y).rem_euclid(1.0));
    let n = image.width() as f64;
    image.values().iter().zip(image.grid().x().iter()).map(|(f, y)| wave(y) * f).sum::<Complex<f64>>() / n
}

/// A row of `n` pixels of `cos 2πνx` with a whole number of periods.
fn wave(n: usize, periods: usize) -> Image {
    let grating = Grating::new([periods as f64 / n as f64, 0.0]).expect("a finite frequency");
    Image::of(&grating, Grid::pixels(n, 1).expect("a row"))
}

#[test]
fn a_wave_is_found_at_its_alias_with_the_predicted_amplitude_and_phase() {
    // 240 pixels and 80, 96, 160 new ones: factors 3, 2.5 and 1.5
    let n = 240;
    for new in [80, 96, 160, 300] {
        for kernel in nyquist::kernel::catalog::all().into_iter().filter(|kernel| kernel.radius().is_finite()) {
            let grid = over(Grid::pixels(n, 1).unwrap(), new, 1).unwrap();
            let weights = Weights::of(Grid::pixels(n, 1).unwrap().x(), grid.x(), &kernel).unwrap();
            for periods in [7, 37, 53, 71, 97, 113] {
                let resized = resize(&wave(n, periods), new, 1, &kernel, Edge::Wrap).unwrap();
                let nu = periods as f64 / n as f64;
                // all that lands on the same place: images of +ν and of −ν. Their gains are sums, mean over n, of products
                let found = amplitude(&resized, nu);
                let places = new / gcd(n, new);
                let image = |nu: f64, m: i64| weights.gain(nu, m) * Complex::cis(-std::f64::consts::PI * m as f64);
                let mut known = 0.5 * weights.gain(nu, 0);
                for m in 1..places as i64 {
                    if (m * n as i64) % new as i64 == 0 {
                        known += 0.5 * image(nu, m);
                    }
                }
                for m in 0..places as i64 {
                    // −ν + m lands on ν where 2·periods = m·n modulo new
                    if (2 * periods as i64 - m * n as i64).rem_euclid(new as i64) == 0 {
                        known += 0.5 * image(-nu, m);
                    }
                }
                let taps = 2.0 * kernel.radius() * (n as f64 / new as f64).max(1.0) + 1.0;
                let rounding = 64.0 * f64::EPSILON * taps * n as f64;
                assert!((found - known).norm() < rounding, "{} {new} {periods}: {found} {known}", kernel.name());
            }
        }
    }
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[test]
fn taking_the_nearest_pixel_folds_everything_and_weakens_nothing_at_a_whole_factor() {
    let image = wave(240, 97);
    let small = nearest(&image, over(image.grid(), 80, 1).unwrap(), Edge::Clamp);
    let every_third: Vec<f64> = image.values()[1..].iter().step_by(3).copied().collect();
    assert_eq!(small.values(), every_third);
    let weights = Weights::nearest(image.grid().x(), small.grid().x());
    assert!((weights.gain(97.0 / 240.0, 0).norm() - 1.0).abs() < 1e-13);
    // at factors that are no whole numbers the box is read at all phases: sinc ν is left, and images of sinc(ν + m)
    let weights = Weights::nearest(image.grid().x(), over(image.grid(), 89, 1).unwrap().x());
    for (nu, m) in [(0.1, 0), (0.4, 0), (0.4, -1), (0.4, 1)] {
        // 89 phases: the mean is the integral up to the images 89 apart
        let sinc = nyquist::num::sinc(nu + f64::from(m));
        assert!((weights.gain(nu, i64::from(m)).norm() - sinc.abs()).abs() < 2.0 / 89.0, "{nu} {m}");
    }
}

#[test]
fn the_gain_is_the_response_of_the_kernel_where_the_kernel_is_wide() {
    // by Poisson the sampled kernel differs from the continuous one by K(c(ν + m)), m ≠ 0
    let (old, new) = (Axis::cells(0.0..400.0, 400).unwrap(), Axis::cells(0.0..400.0, 50).unwrap());
    let kernel = Cubic::b_spline();
    let weights = Weights::of(old, new, &kernel).unwrap();
    for nu in [0.01, 0.05, 0.1] {
        let images: f64 = (1..20).map(|m| 2.0 * kernel.response(8.0 * (f64::from(m) - nu)).abs()).sum();
        assert!((weights.gain(nu, 0).re - kernel.response(8.0 * nu)).abs() < 3.0 * images + 1e-13);
    }
    assert!((weights.gain(0.0, 0).re - 1.0).abs() < 1e-14);
}
