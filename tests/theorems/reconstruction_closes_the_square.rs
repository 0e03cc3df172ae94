//! Samples and a kernel are a signal again: exactly the right one where the theorem says so, and total everywhere.

use nyquist::kernel::catalog;
use nyquist::num::random::uniform;
use nyquist::prelude::*;
use std::f64::consts::PI;

/// Any data at all: 23 numbers from −1 to 1.
fn data() -> Samples {
    let values = (0..23).map(|i| 2.0 * uniform(7, i, 0) - 1.0).collect();
    let axis = Axis::new(-3.0, 0.7, 23).expect("the step is positive");
    Samples::new(axis, values).expect("as many numbers as places")
}

#[test]
fn the_tent_is_linear_interpolation() {
    let samples = data();
    let (axis, v) = (samples.axis(), samples.values());
    let back = reconstruct(&samples, TentKernel);
    for i in 0..22 {
        for part in [0.0, 0.25, 0.3, 0.99] {
            let x = axis.at(i as i64) + part * axis.step();
            let linear = v[i] + part * (v[i + 1] - v[i]);
            assert!((back.at(x) - linear).abs() < 1e-14, "at {x}");
        }
    }
}

#[test]
fn interpolating_kernels_pass_through_any_samples() {
    let samples = data();
    for kernel in catalog::all().iter().filter(|k| k.claims().interpolating) {
        for edge in Edge::ALL {
            let back = reconstruct(&samples, kernel).edge(edge);
            for [x, v] in samples.points() {
                // the one for the sample itself and zeros for all others: exactly, but for sums in closed form
                let bound = if kernel.radius().is_finite() { 0.0 } else { 1e-14 };
                assert!((back.at(x) - v).abs() <= bound, "{}, {edge:?}", kernel.name());
            }
        }
    }
}

#[test]
fn a_raised_cosine_comes_back_from_its_samples() {
    for (band, step) in [(1.0, 0.5), (1.0, 0.4), (0.5, 1.0), (2.0, 0.2)] {
        let f = RaisedCosine::new(band).unwrap();
        let samples = Samples::of(&f, Axis::centered(step, 8001).unwrap());
        let back = reconstruct(&samples, Ideal);
        // left out: |f(kT)| ≤ 4B/(3π)|2BkT|⁻³ times 1/(πk), summed on both sides from 4000 on
        let tail = 8.0 * band / (9.0 * PI * PI) * (2.0 * band * step * 4000.0).powi(-3);
        for i in 0..50 {
            let x = 0.0731 * f64::from(i);
            let error = (back.at(x) - f.at(x)).abs();
            assert!(error <= (tail * 2.0).max(1e-12), "RC({band}), T = {step}, x = {x}: {error:e}");
        }
    }
}

#[test]
fn a_periodic_signal_below_nyquist_comes_back_exactly_for_even_and_odd_lengths() {
    for n in [1, 2, 5, 8, 9, 16, 33] {
        let highest = (n - 1) / 2;
        let wave = move |x: f64| -> f64 {
            (0..=highest)
                .map(|k| {
                    (2.0 * PI * k as f64 * (x - 0.3) / 1.5 + uniform(3, k as u64, 0)).cos() * uniform(4, k as u64, 1)
                })
                .sum()
        };
        let samples = Samples::of(&from_fn(wave), Axis::nodes(0.2..1.7, n).unwrap());
        let back = reconstruct(&samples, Ideal).edge(Edge::Wrap);
        for i in 0..60 {
            let x = -2.0 + 0.0837 * f64::from(i);
            // n terms of size up to one, phases of up to n turns
            let bound = 1e-15 * (n * n) as f64 + 1e-13;
            assert!((back.at(x) - wave(x)).abs() <= bound, "n = {n}, x = {x}");
        }
    }
}

/// The sum over the record continued 200 000 samples to either side, which the closed forms replace. With the ideal kernel
/// the pairs left out are below `2·max|v|·n/200000`.
fn by_force(samples: &Samples, kernel: &dyn Kernel, edge: Edge, x: f64) -> f64 {
    let u = samples.axis().index_of(x);
    let n = samples.values().len();
    let reach = if kernel.radius().is_finite() { 100 } else { 200_000 };
    let middle = n as i64 / 2;
    let value = |i: i64| edge.index(i, n).map_or(0.0, |j| samples.values()[j]) * kernel.at(u - i as f64);
    (1..=reach).rev().map(|d| value(middle - d) + value(middle + d)).sum::<f64>() + value(middle)
}

#[test]
fn beyond_its_ends_the_record_goes_on_as_the_edge_says() {
    let samples = data();
    for kernel in catalog::all() {
        for edge in Edge::ALL {
            for x in [-6.1, -3.0, -2.7, 0.123, 5.0, 12.4, 14.9] {
                let (fast, slow) =
                    (reconstruct(&samples, &kernel).edge(edge).at(x), by_force(&samples, &*kernel, edge, x));
                let bound = if kernel.radius().is_finite() { 1e-13 } else { 2.0 * 23.0 / 200_000.0 };
                assert!((fast - slow).abs() <= bound, "{} {edge:?} at {x}: {fast} ≠ {slow}", kernel.name());
            }
        }
    }
}

#[test]
fn dirichlets_kernel_is_the_repeated_sinc() {
    for n in 1..=8 {
        for u in [0.0, 1e-12, 0.3, 0.5, 1.0, 2.5, 3.999] {
            // pairs j and −j left out of the sum are below 2|u|·n/(jn)² on the whole
            let sinc = |j: i32| nyquist::num::sinc(u - f64::from(j * n));
            let sum: f64 = (1..=100_000).rev().map(|j| sinc(j) + sinc(-j)).sum::<f64>() + sinc(0);
            assert!((Ideal.periodic(u, n as usize) - sum).abs() < 1e-4, "n = {n}, u = {u}");
        }
        assert_eq!(Ideal.periodic(f64::from(n) * 5.0, n as usize), 1.0);
    }
}

#[test]
fn a_reconstruction_is_a_number_for_every_number() {
    let one = Samples::new(Axis::new(0.0, 1.0, 1).unwrap(), vec![1.0]).unwrap();
    for samples in [&data(), &one] {
        for kernel in catalog::all() {
            for edge in Edge::ALL {
                let back = reconstruct(samples, &kernel).edge(edge);
                for x in [0.0, -1e-300, 1e9, -1e18, 1e100, -1e300] {
                    assert!(back.at(x).is_finite(), "{} {edge:?} at {x}", kernel.name());
                }
                for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                    assert!(back.at(x).is_nan(), "{} {edge:?} at {x}", kernel.name());
                }
            }
        }
    }
}

#[test]
fn the_weights_of_a_place_are_what_its_value_is_made_of() {
    let samples = data();
    for kernel in catalog::all() {
        let back = reconstruct(&samples, &kernel);
        for x in [-3.1, 0.2, 3.33, 12.0] {
            let sum: f64 = back.weights(x).map(|(i, weight)| samples.values()[i] * weight).sum();
            assert!((sum - back.at(x)).abs() < 1e-14, "{} at {x}", kernel.name());
        }
    }
}

#[test]
fn the_spectrum_of_a_reconstruction_is_the_transform_of_its_values() {
    let samples = data();
    let back = reconstruct(&samples, Cubic::mitchell());
    // Simpson's rule on half steps, inside which the cubics are smooth
    for nu in [0.0, 0.31, 0.9, 1.7] {
        let (start, n, h) = (-3.0 - 1.4, 54 * 64, 0.35 / 64.0);
        let f = |x: f64| num_complex::Complex::cis(-2.0 * PI * nu * x) * back.at(x);
        let sum: num_complex::Complex<f64> = (0..n)
            .map(|i| {
                let a = start + h * f64::from(i);
                (f(a) + f(a + 0.5 * h) * 4.0 + f(a + h)) * (h / 6.0)
            })
            .sum();
        assert!((sum - back.spectrum_at(nu)).norm() < 1e-7, "at {nu}");
    }
}
