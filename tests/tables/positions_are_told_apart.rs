//! Uniform, with gaps, jittered, irregular; duplicates; order.

use nyquist::num::random::{normal, uniform};
use nyquist::prelude::*;
use nyquist::record::{Duplicates, Kind, Order, Sampling};

fn of(times: &[f64], rounding: f64) -> Sampling {
    Sampling::of(times, &vec![rounding; times.len()]).expect("positions")
}

fn printed(times: impl Iterator<Item = f64>, decimals: i32) -> Vec<f64> {
    let unit = 10f64.powi(decimals);
    times.map(|t| (t * unit).round() / unit).collect()
}

#[test]
fn a_grid_is_one_whatever_decimals_it_is_printed_with() {
    for (step, decimals) in [(0.01, 2), (1.0 / 3.0, 3), (1.0 / 48_000.0, 6), (1e-9, 9), (0.4, 0), (0.1, 0)] {
        let times = printed((0..1000).map(|k| f64::from(k) * step), decimals);
        let rounding = 0.5 * 10f64.powi(-decimals);
        let sampling = of(&times, rounding);
        assert_eq!(sampling.kind(), Kind::Uniform, "{step} {decimals}");
        let axis = sampling.axis().expect("uniform");
        // the first and the last position may both be off
        assert!((axis.step() - step).abs() <= 2.0 * rounding / 999.0, "{step} {decimals}: {}", axis.step());
        assert_eq!((axis.len(), sampling.duplicates().rows, sampling.gaps().len()), (1000, 0, 0));
    }
    // printed exactly, its numbers are exact
    let sampling = of(&printed((0..500).map(|k| f64::from(k) * 0.002), 3), 0.0005);
    assert_eq!((sampling.step(), sampling.axis().map(|a| a.start())), (Some(0.002), Some(0.0)));
    assert!((sampling.density() - 500.0).abs() < 1e-9 && (sampling.highest_band() - 250.0).abs() < 1e-9);
}

#[test]
fn jitter_above_the_rounding_is_measured() {
    let sigma = 0.02;
    let times: Vec<f64> = (0..5000u64).map(|k| 0.1 * (k as f64 + sigma * normal(1, k, 0))).collect();
    let sampling = of(&times, 1e-9);
    assert_eq!(sampling.kind(), Kind::Jittered);
    // the rms of 5000 normal numbers deviates by 1/√10⁴ of itself; four of these
    assert!((sampling.jitter().rms / (0.1 * sigma) - 1.0).abs() < 0.04);
    assert!(sampling.jitter().most < 0.1 * sigma * 6.0);
    assert!((sampling.step().unwrap() - 0.1).abs() < 1e-6);
    assert!(sampling.axis().is_none());
    // what is printed too coarsely to see it is uniform
    assert_eq!(of(&printed(times.into_iter(), 1), 0.05).kind(), Kind::Uniform);
}

#[test]
fn gaps_are_counted_and_long_ones_part_the_record() {
    let kept = (0..1000).filter(|k| *k != 10 && *k != 500 && *k != 501 && !(700..800).contains(k));
    let times: Vec<f64> = kept.map(|k| 2.0 + 0.5 * f64::from(k)).collect();
    let sampling = of(&times, 0.05);
    assert_eq!(sampling.kind(), Kind::Gaps);
    let missing: Vec<usize> = sampling.gaps().iter().map(|gap| gap.missing).collect();
    assert_eq!(missing, [1, 2, 100]);
    assert_eq!(sampling.gaps()[0].between, [6.5, 7.5]);
    assert_eq!(sampling.stretches(), [0..697, 697..897]);
    assert_eq!(sampling.largest_gap(), (50.5, 696));
    assert_eq!(sampling.safe_band(), 0.5 / 50.5);
    assert!(sampling.axis().is_none() && sampling.axis_of(697..897).is_some_and(|axis| axis.len() == 200));
    // a tenth lost at random, and jitter
    let kept: Vec<u64> = (0..1000).filter(|k| uniform(2, *k, 0) > 0.1).collect();
    let times: Vec<f64> = kept.iter().map(|&k| k as f64 + 0.2 * uniform(2, k, 1)).collect();
    let sampling = of(&times, 1e-9);
    assert_eq!(sampling.kind(), Kind::Jittered);
    let between = (kept[kept.len() - 1] - kept[0] + 1) as usize;
    assert_eq!(sampling.gaps().iter().map(|g| g.missing).sum::<usize>(), between - times.len());
}

#[test]
fn positions_without_a_step_are_irregular() {
    let mut times: Vec<f64> = (0..1000u64).map(|k| 100.0 * uniform(3, k, 0)).collect();
    times.sort_by(f64::total_cmp);
    let sampling = of(&times, 1e-9);
    assert_eq!((sampling.kind(), sampling.step(), sampling.gaps().len()), (Kind::Irregular, None, 0));
    assert_eq!(sampling.stretches().len(), 1);
    let length = times[999] - times[0];
    assert!((sampling.density() - 999.0 / length).abs() < 1e-9 * sampling.density());
}

#[test]
fn disorder_and_duplicates_are_reported_and_put_right() {
    let sampling = of(&[0.0, 1.0, 3.0, 2.0, 4.0, 2.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0], 0.05);
    assert_eq!(sampling.order(), Order::Mixed { falls: 2, first: 3 });
    assert_eq!(sampling.duplicates(), Duplicates { rows: 1, first: 5 });
    assert_eq!(sampling.kind(), Kind::Uniform);
    let values: Vec<f64> = (0..12).map(f64::from).collect();
    let merged = sampling.values(&values).unwrap();
    assert_eq!(merged, [0.0, 1.0, 4.0, 2.0, 4.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0]); // (3 + 5)/2 at 2
    assert_eq!(sampling.disagreements(&values), 1);
    assert_eq!(sampling.disagreements(&[1.0; 12]), 0);
    assert_eq!((sampling.row(2), sampling.row(3)), (3, 2));
    let falling = of(&[3.0, 2.0, 1.0, 0.0], 0.05);
    assert_eq!((falling.order(), falling.kind()), (Order::Falling, Kind::Uniform));
    assert_eq!(falling.values(&[9.0, 8.0, 7.0, 6.0]).unwrap(), [6.0, 7.0, 8.0, 9.0]);
}

#[test]
fn whole_seconds_of_a_faster_record_are_no_duplicates() {
    // ten rows a second, of which only the second is printed
    let times: Vec<f64> = (0..600).map(|k| f64::from(k / 10)).collect();
    let sampling = of(&times, 0.5);
    assert_eq!((sampling.kind(), sampling.duplicates().rows), (Kind::Uniform, 0));
    assert!((sampling.step().unwrap() - 0.1).abs() <= sampling.step_slack());
    // but one row that comes twice is
    let sampling = of(&[0.0, 1.0, 2.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0], 0.5);
    assert_eq!((sampling.kind(), sampling.duplicates().rows, sampling.step()), (Kind::Uniform, 1, Some(1.0)));
}

#[test]
fn what_is_no_record_is_refused() {
    let no = |times: &[f64]| Sampling::of(times, &vec![0.1; times.len()]).unwrap_err();
    assert!(matches!(no(&[]), Error::TooFew { .. }));
    assert!(matches!(no(&[1.0]), Error::TooFew { least: 2, got: 1, .. }));
    assert!(matches!(no(&[1.0, 1.0, 1.0]), Error::TooFew { least: 2, got: 1, .. }));
    assert!(matches!(no(&[0.0, f64::NAN]), Error::NotFiniteAt { index: 1, .. }));
    assert!(matches!(no(&[-f64::MAX, f64::MAX]), Error::Overflow { .. }));
    assert!(matches!(Sampling::of(&[0.0, 1.0], &[0.1]), Err(Error::Length { .. })));
    assert!(matches!(Sampling::of(&[0.0, 1.0], &[0.1, -0.1]), Err(Error::OutOfRange { .. })));
    let sampling = of(&[0.0, 1.0], 0.1);
    assert!(matches!(sampling.values(&[1.0]), Err(Error::Length { .. })));
    assert!(matches!(sampling.values(&[1.0, f64::INFINITY]), Err(Error::NotFiniteAt { .. })));
}
