//! Lengths that are cut into rows or become convolutions, and the bits of any number of threads.

use crate::oracle::{complex_noise, direct, noise, rounding, size};
use num_complex::Complex;
use nyquist::axis::Axis;
use nyquist::engine::fft::{Butterflies, Fft, PhysicalFft, PhysicalRealFft, RealFft};

/// A power of two, one with other factors, rows of odd length, a prime, twice a prime, an odd length in one piece, and an
/// even one that is no multiple of a block, with more factors than stand in a table; and such that vectors pass over: a
/// power of two, and one with every other factor there is, also as half as many complex numbers.
const LENGTHS: [usize; 9] = [1 << 18, 3 << 16, 131_184, 131_101, 262_202, 177_147, 44_100, 1 << 11, 53_760];

/// Errors of single frequencies are like random numbers whose deviation is what the whole may have on the average: six of
/// them.
const DEVIATIONS: f64 = 6.0;

fn threads<R: Send>(count: usize, f: impl FnOnce() -> R + Send) -> R {
    rayon::ThreadPoolBuilder::new().num_threads(count).build().expect("two or three threads").install(f)
}

#[test]
fn single_frequencies_are_the_direct_sums() {
    for n in LENGTHS {
        let values = complex_noise(n);
        let real: Vec<f64> = values.iter().map(|z| z.re).collect();
        let whole: Vec<_> = real.iter().map(|&x| Complex::from(x)).collect();
        for butterflies in [Butterflies::Scalar, Butterflies::Fastest] {
            let (mut out, mut half) = (vec![Complex::ZERO; n], vec![Complex::ZERO; n / 2 + 1]);
            Fft::with(n, butterflies).unwrap().forward(&values, &mut out).unwrap();
            RealFft::with(n, butterflies).unwrap().forward(&real, &mut half).unwrap();
            let bound = DEVIATIONS * rounding(n, f64::EPSILON) * size(values.iter().copied());
            for k in [0, 1, 17, n / 3, n / 2 - 1, n / 2, n / 2 + 1, n - 1] {
                assert!((out[k] - direct(&values, k)).norm() <= bound, "{n} at {k}");
                if k <= n / 2 {
                    assert!((half[k] - direct(&whole, k)).norm() <= bound, "{n} at {k}, real");
                }
            }
        }
    }
}

#[test]
fn energy_is_kept_and_the_way_back_leads_back() {
    for n in LENGTHS {
        let values = noise(n, 3);
        let norm = size(values.iter().map(|&x| x.into()));
        let plan = RealFft::<f64>::new(n).unwrap();
        let (mut half, mut back) = (vec![Complex::ZERO; n / 2 + 1], vec![0.0; n]);
        plan.forward(&values, &mut half).unwrap();
        let twice = |k: usize| if k == 0 || 2 * k == n { 1.0 } else { 2.0 };
        let energy: f64 = half.iter().enumerate().map(|(k, z)| twice(k) * z.norm_sqr()).sum();
        // the sums of n squares round, too: ε·√n·deviations
        let bound = 2.0 * rounding(n, f64::EPSILON) + DEVIATIONS * f64::EPSILON * (n as f64).sqrt();
        assert!((energy / n as f64 / (norm * norm) - 1.0).abs() <= bound, "{n}");
        plan.inverse(&half, &mut back).unwrap();
        let error = size(back.iter().zip(&values).map(|(a, b)| Complex::from(a / n as f64 - b)));
        assert!(error <= 2.0 * rounding(n, f64::EPSILON) * norm, "{n}: {error}");
    }
}

#[test]
fn single_precision_errs_by_its_own_rounding() {
    for n in LENGTHS {
        let values = noise(n, 4);
        let single: Vec<f32> = values.iter().map(|&x| x as f32).collect();
        let (mut half, mut exact) = (vec![Complex::ZERO; n / 2 + 1], vec![Complex::ZERO; n / 2 + 1]);
        RealFft::new(n).unwrap().forward(&single, &mut half).unwrap();
        RealFft::new(n).unwrap().forward(&values, &mut exact).unwrap();
        let errors = half.iter().zip(&exact).map(|(a, b)| Complex::new(f64::from(a.re), f64::from(a.im)) - b);
        let epsilon = f64::from(f32::EPSILON);
        assert!(size(errors) <= (rounding(n, epsilon) + epsilon) * size(exact.iter().copied()), "{n}");
    }
}

#[test]
fn units_and_phases_are_the_direct_sum_turned() {
    for n in LENGTHS {
        let axis = Axis::new(-0.3, 0.1, n).unwrap();
        let values = complex_noise(n);
        let real: Vec<f64> = values.iter().map(|z| z.re).collect();
        let whole: Vec<_> = real.iter().map(|&x| Complex::from(x)).collect();
        let (mut out, mut half) = (vec![Complex::ZERO; n], vec![Complex::ZERO; n / 2 + 1]);
        PhysicalFft::new(axis).forward(&values, &mut out).unwrap();
        PhysicalRealFft::new(axis).forward(&real, &mut half).unwrap();
        let turn = |k: f64| 0.1 * Complex::cis(2.0 * std::f64::consts::PI * k * 3.0 / n as f64);
        // the factors are within 9ε, as is the turn that they are compared with
        let bound = DEVIATIONS * (rounding(n, f64::EPSILON) + 18.0 * f64::EPSILON) * 0.1 * size(values.iter().copied());
        for p in [0, 1, 9, n / 3, n / 2 - 1, n / 2, n / 2 + 1, n - 2, n - 1] {
            let k = p as f64 - (n / 2) as f64;
            let wanted = direct(&values, (p + n - n / 2) % n) * turn(k);
            assert!((out[p] - wanted).norm() <= bound, "{n} at {k}");
            if p <= n / 2 {
                let wanted = direct(&whole, p) * turn(p as f64);
                assert!((half[p] - wanted).norm() <= bound, "{n} at {p}, real");
            }
        }
    }
}

#[test]
fn the_transform_is_linear() {
    let n = 1 << 18;
    let plan = Fft::<f64>::new(n).unwrap();
    let (a, b) = (complex_noise(n), noise(n, 5));
    let both: Vec<_> = a.iter().zip(&b).map(|(a, b)| 3.0 * a - b).collect();
    let b: Vec<_> = b.into_iter().map(Complex::from).collect();
    let transform = |values: &[Complex<f64>]| {
        let mut out = vec![Complex::ZERO; n];
        plan.forward(values, &mut out).unwrap();
        out
    };
    let (fa, fb, fboth) = (transform(&a), transform(&b), transform(&both));
    let error = size(fboth.iter().zip(fa.iter().zip(&fb)).map(|(z, (a, b))| z - (3.0 * a - b)));
    let sizes = size(fboth) + 3.0 * size(fa) + size(fb);
    assert!(error <= rounding(n, f64::EPSILON) * sizes);
}

#[test]
fn scalar_and_fastest_butterflies_differ_by_rounding() {
    for n in LENGTHS {
        let values = complex_noise(n);
        let transform = |butterflies| {
            let mut out = vec![Complex::ZERO; n];
            Fft::with(n, butterflies).unwrap().forward(&values, &mut out).unwrap();
            out
        };
        let (scalar, fastest) = (transform(Butterflies::Scalar), transform(Butterflies::Fastest));
        let error = size(scalar.iter().zip(&fastest).map(|(a, b)| a - b));
        assert!(error <= 2.0 * rounding(n, f64::EPSILON) * size(scalar), "{n}");
    }
}

#[test]
fn the_bits_are_those_of_any_number_of_threads() {
    for n in LENGTHS {
        let axis = Axis::new(-3.3, 0.01, n).unwrap();
        let values = complex_noise(n);
        let real: Vec<f64> = values.iter().map(|z| z.re).collect();
        let all = || {
            let (mut bins, mut half, mut back) = (vec![Complex::ZERO; n], vec![Complex::ZERO; n / 2 + 1], vec![0.0; n]);
            PhysicalFft::new(axis).forward(&values, &mut bins).unwrap();
            PhysicalRealFft::new(axis).forward(&real, &mut half).unwrap();
            RealFft::new(n).unwrap().inverse(&half, &mut back).unwrap();
            (bins, half, back)
        };
        let one = threads(1, all);
        assert!([2, 3].into_iter().all(|count| threads(count, all) == one), "{n}");
    }
}

#[test]
fn a_gaussian_far_from_the_middle_has_its_closed_form() {
    use nyquist::prelude::*;
    // 2¹⁷ complex numbers for 2¹⁸ real ones: cut into sixteen
    let n = 1 << 18;
    let f = Shifted::new(901.5, Gaussian::new(1.0).unwrap()).unwrap();
    let samples = Samples::of(&f, Axis::new(-1000.0, 1.0 / 128.0, n).unwrap());
    let mut half = vec![Complex::ZERO; n / 2 + 1];
    PhysicalRealFft::new(samples.axis()).forward(samples.values(), &mut half).unwrap();
    let spectrum = f.spectrum();
    let span = samples.axis().span();
    // sampled beyond 20 widths and far below the Nyquist frequency: only rounding is left, of ‖f‖ ≤ √(1/T)
    let bound = DEVIATIONS * (rounding(n, f64::EPSILON) + 16.0 * f64::EPSILON) / 128f64.sqrt();
    for k in (0..2048).step_by(7) {
        // the closed form's own phase: ν·x rounds
        let turns = 2.0 * f64::EPSILON * 901.5 * k as f64 / span;
        let error = (half[k] - spectrum.density(k as f64 / span)).norm();
        assert!(error <= bound + 2.0 * std::f64::consts::PI * turns, "{k}: {error}");
    }
}
