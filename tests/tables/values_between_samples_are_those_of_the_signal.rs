//! Interpolation of records: exact where it says so, within its bound elsewhere.

use nyquist::axis::Edge;
use nyquist::laws::frames::random_polynomial;
use nyquist::num::random::uniform;
use nyquist::prelude::*;
use nyquist::record::{Interpolator, Method, Sampling, Wanted, Way};
use std::f64::consts::PI;

fn of(times: &[f64]) -> Sampling {
    Sampling::of(times, &vec![0.0; times.len()]).expect("positions")
}

fn regular(n: u32) -> Vec<f64> {
    (0..n).map(|k| 0.5 * f64::from(k)).collect()
}

fn worst(interpolated: &impl Signal, truth: impl Fn(f64) -> f64, low: f64, high: f64) -> f64 {
    let place = |i: u32| low + (high - low) * (f64::from(i) + 0.3) / 2000.0;
    (0..2000).map(place).map(|t| (interpolated.at(t) - truth(t)).abs()).fold(0.0, f64::max)
}

#[test]
fn the_periodic_method_is_exact_for_periods() {
    for n in [64, 65, 1000, 4001] {
        let sampling = of(&regular(n));
        let f = random_polynomial(3, 0.5 * f64::from(n), (n as usize - 1) / 2).unwrap();
        let values: Vec<f64> = sampling.positions().iter().map(|&t| f.at(t)).collect();
        let wanted = Wanted { method: Some(Method::Periodic), ..Wanted::default() };
        let between = Interpolator::new(&sampling, wanted).unwrap();
        let interpolated = between.of(&sampling, &values).unwrap();
        // the oracle is Horner's rule, 2Kε·Σ|c|; the transform and the kernel add a few ε·log n of the same sum
        let size: f64 = f.coefficients().iter().map(|c| 2.0 * c.norm()).sum();
        let bound = f64::EPSILON * (f64::from(n) + 50.0) * size;
        let error = worst(&interpolated, |t| f.at(t), 0.0, 0.5 * f64::from(n));
        assert!(error < bound, "{n}: {error:e} {bound:e}");
        assert_eq!(interpolated.misfit(), None);
    }
}

#[test]
fn kernels_keep_the_bound_they_print() {
    let sampling = of(&regular(600));
    for (method, part) in [
        (Method::Kaiser, 0.8),
        (Method::Kaiser, 0.5),
        (Method::Kaiser, 0.97),
        (Method::Regularised, 0.8),
        (Method::Regularised, 0.5),
        (Method::Regularised, 0.95),
    ] {
        let wanted = Wanted { method: Some(method), band: Some(part), ..Wanted::default() };
        let between = Interpolator::new(&sampling, wanted).unwrap();
        let Way::Kernel { error, kernel, band, .. } = between.pieces()[0].way.clone() else { panic!("a kernel") };
        assert_eq!(band, part); // the Nyquist frequency is one
        let radius = 0.5 * kernel.kernel().radius();
        if method == Method::Regularised {
            let proven = (-PI * (1.0 - part) * kernel.kernel().radius() / 2.0).exp(); // V09c
            assert!(error < proven, "{part}: {error:e} {proven:e}");
        }
        for share in [0.0, 0.3, 0.77, 1.0] {
            // up to the edge of the band itself
            let tone = |t: f64| 3.0 * (2.0 * PI * part * share * t + 0.7).cos();
            let values: Vec<f64> = sampling.positions().iter().map(|&t| tone(t)).collect();
            let interpolated = between.of(&sampling, &values).unwrap();
            let off = worst(&interpolated, tone, radius, 299.5 - radius);
            // the mean that is taken away and added again, and sums of some hundred terms
            let rounding = 3.0 * 200.0 * f64::EPSILON;
            assert!(off <= 3.0 * error + rounding, "{method:?} {part} {share}: {off:e} {error:e}");
            // and at the edge, where an image of nearly the same size meets the tone's loss, the bound is no luxury
            assert!(share < 1.0 || off > 1.5 * error, "{method:?} {part}: {off:e} {error:e}");
        }
    }
    // and a constant is a constant
    let between = Interpolator::new(&sampling, Wanted::default()).unwrap();
    let interpolated = between.of(&sampling, &[0.1; 600]).unwrap();
    assert_eq!(worst(&interpolated, |_| 0.1, 0.0, 299.5), 0.0);
}

#[test]
fn edges_continue_the_record_as_they_say() {
    // far inside nothing changes; beyond the end a wrap is the start, a mirror the way back, a clamp flat
    let sampling = of(&regular(400));
    let slow = |t: f64| (2.0 * PI * 0.031 * t).sin() + 0.2 * t / 200.0;
    let values: Vec<f64> = sampling.positions().iter().map(|&t| slow(t)).collect();
    for edge in Edge::ALL {
        let between = Interpolator::new(&sampling, Wanted { edge, ..Wanted::default() }).unwrap();
        let interpolated = between.of(&sampling, &values).unwrap();
        assert!(worst(&interpolated, slow, 50.0, 150.0) < 1e-7, "{edge:?}");
        assert!(!between.covers(-0.01) && between.covers(0.0) && between.covers(199.5) && !between.covers(199.6));
        // at the samples themselves windows are one and all others vanish
        let on = |i: usize| (interpolated.at(sampling.positions()[i]) - values[i]).abs();
        assert!((0..400).map(on).fold(0.0, f64::max) < 1e-14);
        // outside, also farther than the 33 steps that kernels reach; the mirror stands half a step beyond the end
        let (place, known) = match edge {
            Edge::Zero => (-30.2, 0.0),
            Edge::Clamp => (-30.2, values[0]),
            Edge::Wrap => (-3.2, interpolated.at(200.0 - 3.2)),
            Edge::Mirror => (-0.5 - 3.2, interpolated.at(3.2)),
        };
        // 66 terms below 1.2 at places rounded to 400ε steps, whose slopes are below π; kernels err by 10⁻⁹ of a constant
        let rounding = 66.0 * 1.2 * 400.0 * PI * f64::EPSILON;
        let bound = if edge == Edge::Clamp { 1.2e-9 } else { rounding };
        assert!((interpolated.at(place) - known).abs() <= bound, "{edge:?}: {} {known}", interpolated.at(place));
    }
}

#[test]
fn irregular_samples_give_what_lies_between_them() {
    let jittered: Vec<f64> = (0..800u64).map(|k| 0.5 * (k as f64 + 0.6 * uniform(4, k, 0))).collect();
    let gaps: Vec<f64> = (0..800).filter(|k| k % 11 != 3).map(|k| 0.5 * f64::from(k)).collect();
    // well below half the density, and decayed at both ends: no edge matters
    let pulse = |t: f64| (-0.5 * ((t - 200.0) / 8.0).powi(2)).exp() * (2.0 * PI * 0.5 * t).cos();
    for times in [jittered, gaps] {
        let sampling = of(&times);
        for edge in [Edge::Mirror, Edge::Wrap] {
            let between = Interpolator::new(&sampling, Wanted { edge, ..Wanted::default() }).unwrap();
            let Way::LeastSquares(recoverable) = &between.pieces()[0].way else { panic!("least squares") };
            let values: Vec<f64> = sampling.positions().iter().map(|&t| pulse(t)).collect();
            let interpolated = between.of(&sampling, &values).unwrap();
            // the spectrum is 10⁻¹² at 0.15 from its middle, so all is within the band of 0.72 and more
            assert!(recoverable.band() > 0.7, "{}", recoverable.band());
            let bound = recoverable.condition().powi(2) * f64::EPSILON * 1e3;
            let error = worst(&interpolated, pulse, 0.0, 399.0);
            assert!(error < bound, "{edge:?}: {error:e} {bound:e}");
            assert!(interpolated.misfit().is_some_and(|misfit| misfit < bound));
        }
    }
}

#[test]
fn long_gaps_part_the_record_and_are_not_filled() {
    let times: Vec<f64> = (0..300).filter(|k| !(100..180).contains(k)).map(f64::from).collect();
    let sampling = of(&times);
    let f = |t: f64| (2.0 * PI * 0.1 * t).cos();
    let values: Vec<f64> = times.iter().map(|&t| f(t)).collect();
    let between = Interpolator::new(&sampling, Wanted::default()).unwrap();
    assert_eq!(between.pieces().len(), 2);
    assert!(between.covers(99.0) && !between.covers(99.1) && !between.covers(150.0) && between.covers(180.0));
    let interpolated = between.of(&sampling, &values).unwrap();
    assert!(worst(&interpolated, f, 40.0, 60.0) < 1e-7 && worst(&interpolated, f, 220.0, 260.0) < 1e-7);
    // a lone sample between two gaps is left out
    let times: Vec<f64> = (0..300).filter(|k| *k == 140 || !(100..180).contains(k)).map(f64::from).collect();
    let between = Interpolator::new(&of(&times), Wanted::default()).unwrap();
    assert_eq!((between.pieces().len(), between.left_out().len()), (2, 1));
    assert_eq!(between.left_out()[0], 100..101);
}

#[test]
fn what_cannot_be_is_refused() {
    let uneven = of(&[0.0, 1.0, 2.1, 3.0, 4.2, 5.0, 6.0, 7.3, 8.0, 9.0]);
    for method in [Method::Kaiser, Method::Regularised, Method::Periodic] {
        let error = Interpolator::new(&uneven, Wanted { method: Some(method), ..Wanted::default() }).unwrap_err();
        assert!(error.to_string().contains("equally spaced"), "{error}");
    }
    let even = of(&regular(20));
    for band in [0.0, -1.0, 1.0, 7.0, f64::NAN] {
        assert!(Interpolator::new(&even, Wanted { band: Some(band), ..Wanted::default() }).is_err(), "{band}");
    }
    let error = Interpolator::new(&uneven, Wanted { edge: Edge::Clamp, ..Wanted::default() }).unwrap_err();
    assert!(error.to_string().contains("wrap or mirror"), "{error}");
    let between = Interpolator::new(&even, Wanted::default()).unwrap();
    assert!(matches!(between.of(&even, &[1.0; 3]), Err(Error::Length { .. })));
    assert!(matches!(between.of(&even, &[f64::NAN; 20]), Err(Error::NotFiniteAt { .. })));
    assert_eq!("Periodic".parse::<Method>(), Ok(Method::Periodic));
    assert!("spline".parse::<Method>().is_err());
}
