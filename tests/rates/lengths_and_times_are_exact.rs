//! Of n samples there come round(n·R/R₀), each at its own time.

use nyquist::error::Error;
use nyquist::rate::{Converter, Quality, Ratio, convert};
use std::f64::consts::PI;

#[test]
fn lengths_are_rounded_products() {
    // (from, to, n, round(n·to/from)), by hand
    let known = [
        (44_100.0, 48_000.0, 44_100, 48_000),
        (44_100.0, 48_000.0, 1, 1),
        (48_000.0, 44_100.0, 1, 1),
        (48_000.0, 8_000.0, 2, 0),
        (48_000.0, 8_000.0, 3, 1),
        (48_000.0, 8_000.0, 9, 2),
        (8_000.0, 48_000.0, 7, 42),
        (1.0, PI, 1_000, 3_142),
        (PI, 1.0, 1_000, 318),
        (44_100.0, 44_101.0, 100_000, 100_002),
        (48_000.0, 48_000.0, 17, 17),
        (44_100.0, 48_000.0, 0, 0),
        (1.0, 999.0, 5, 4_995),
    ];
    for (from, to, n, expected) in known {
        let out = convert(&vec![0.5; n], from, to, Quality::Fast).unwrap();
        assert_eq!(out.len(), expected, "{from} → {to}, {n}");
        assert_eq!(Ratio::new(from, to).unwrap().frames(n as u64), expected as u64);
    }
    // far beyond what floats count: 10¹⁵ frames
    assert_eq!(Ratio::new(44_100.0, 48_000.0).unwrap().frames(4_410_000_000_000_007), 4_800_000_000_000_008);
}

#[test]
fn an_impulse_stays_where_it_is_and_its_response_is_symmetric() {
    for (from, to) in [(44_100.0, 48_000.0), (48_000.0, 44_100.0), (1.0, 0.5 * PI), (8_000.0, 48_000.0)] {
        for quality in Quality::ALL {
            // the impulse stands where both rates have a sample, if they have any in common
            let mut record = vec![0.0; 20_000];
            let ratio = Ratio::new(from, to).unwrap();
            let at = ratio.terms().map_or(0, |(_, down)| 8_000 / down * down);
            if at == 0 {
                continue;
            }
            record[at] = 1.0;
            let out = convert(&record, from, to, quality).unwrap();
            let (up, down) = ratio.terms().unwrap();
            let centre = at / down * up;
            let largest = out.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            assert_eq!(out[centre], largest, "{from} → {to}, {quality}");
            // the far ends of the response lie in other windows, whose spectra were cut where the stop-band begins
            let most = 10f64.powf(-quality.promise().rejection / 20.0);
            assert!((1..3_000).all(|k| (out[centre + k] - out[centre - k]).abs() <= most));
        }
    }
}

#[test]
fn times_do_not_drift_over_long_records() {
    // an irrational ratio after 2·10⁶ samples: a phase error of 10⁻¹⁰ samples would be seen
    let (from, to) = (44_100.0, 14_700.0 * PI);
    let ratio = to / from;
    let mut converter = Converter::new(from, to, 1, Quality::Best).unwrap();
    let cycles = 0.2; // a sample of the input, exactly periodic over five
    let value = |t: f64| (2.0 * PI * (cycles * (t % 5.0))).sin();
    let (mut out, mut done, mut worst) = (Vec::new(), 0usize, 0.0f64);
    for block in 0..200 {
        let samples: Vec<f64> = (0..10_000).map(|i| value((block * 10_000 + i) as f64)).collect();
        converter.push(&samples, &mut out).unwrap();
        for v in out.drain(..) {
            if done > 5_000 {
                // m/ratio loses digits: the remainder modulo five in two parts
                let t = done as f64 / ratio;
                let correction = (-ratio).mul_add(t, done as f64) / ratio;
                worst = worst.max((v - value(t % 5.0 + correction)).abs());
            }
            done += 1;
        }
    }
    assert!(done > 2_000_000 && worst < 2e-10, "{done} {worst:e}");
}

#[test]
fn frames_are_given_as_soon_as_was_said() {
    for (from, to) in [(44_100.0, 48_000.0), (48_000.0, 44_100.0), (8_000.0, 8_000.0), (1.0, 0.5 * PI), (7.0, PI)] {
        for quality in Quality::ALL {
            let mut converter = Converter::<f32>::new(from, to, 2, quality).unwrap();
            let (delay, ratio) = (converter.delay() as u64, converter.ratio());
            let (mut out, mut longest) = (Vec::new(), 0);
            for taken in (100..60_000u64).step_by(100) {
                converter.push(&[0.25; 200], &mut out).unwrap();
                let given = out.len() as u64 / 2;
                let behind = taken - (given as f64 / ratio.value()).floor().min(taken as f64) as u64;
                longest = longest.max(behind);
                assert!(
                    given >= ratio.frames(taken.saturating_sub(delay)),
                    "{from} → {to}, {quality}: {given} of {taken}"
                );
            }
            // and not much sooner: blocks of a hundred frames are what is not seen
            assert!(longest + 200 >= delay, "{from} → {to}, {quality}: {longest} of {delay}");
        }
    }
}

#[test]
fn silence_and_constants_stay() {
    for (from, to) in [(44_100.0, 48_000.0), (48_000.0, 11_025.0), (1.0, PI)] {
        let silent = convert(&[0.0; 5_000], from, to, Quality::High).unwrap();
        assert!(silent.iter().all(|&v| v == 0.0));
        let constant = convert(&[1.0; 5_000], from, to, Quality::Fast).unwrap();
        let middle = &constant[constant.len() / 4..constant.len() * 3 / 4];
        assert!(middle.iter().all(|v| (v - 1.0).abs() < 1e-5), "{from} → {to}");
    }
}

#[test]
fn equal_rates_copy() {
    let record: Vec<f64> = (0..1000).map(|i| f64::from(i).sin()).collect();
    assert_eq!(convert(&record, 44_100.0, 44_100.0, Quality::Best).unwrap(), record);
}

#[test]
fn what_cannot_be_is_refused() {
    let new = |from, to, channels| Converter::<f64>::new(from, to, channels, Quality::Best).unwrap_err();
    assert!(matches!(new(0.0, 1.0, 1), Error::NotPositive { .. }));
    assert!(matches!(new(1.0, f64::NAN, 1), Error::NotFinite { .. }));
    assert!(matches!(new(1.0, 2_000.0, 1), Error::OutOfRange { .. }));
    assert!(matches!(new(1.0, 1e-300, 1), Error::OutOfRange { .. }));
    assert!(matches!(new(1.0, 2.0, 0), Error::TooFew { .. }));
    assert!(matches!(new(44_100.0, 48_000.0, 65_535), Error::Overflow { .. }));
    let mut converter = Converter::new(1.0, 2.0, 2, Quality::Fast).unwrap();
    let mut out = Vec::new();
    assert!(matches!(converter.push(&[0.0; 3], &mut out), Err(Error::Length { expected: 4, got: 3, .. })));
    assert!(matches!(converter.whole(&[0.0; 4], &mut [0.0; 6]), Err(Error::Length { expected: 8, got: 6, .. })));
    let mut record = vec![0.0; 10_000];
    record[9_999] = f64::INFINITY;
    let found = converter.whole(&record, &mut [0.0; 20_000]);
    assert!(matches!(found, Err(Error::NotFiniteAt { index: 9_999, .. })));
    // a record too short for any output is read all the same
    let none = convert(&[f64::NAN], 48_000.0, 8_000.0, Quality::Fast);
    assert!(matches!(none, Err(Error::NotFiniteAt { index: 0, .. })));
    // sums that are too large are no fault of the samples
    let told = converter.whole(&[f64::MAX; 10_000], &mut [0.0; 20_000]);
    assert!(matches!(told, Err(Error::Overflow { .. })));
    assert!(matches!(converter.push(&[0.0, f64::NAN], &mut out), Err(Error::NotFiniteAt { index: 1, .. })));
}

#[test]
fn sums_that_overflow_are_told_and_not_taken_for_bad_input() {
    // a constant; and a tone, whose values add up to nothing
    let tone = [f64::MAX, f64::MAX, -f64::MAX, -f64::MAX].repeat(12_000);
    for loud in [vec![f64::MAX; 48_000], tone] {
        for quality in Quality::ALL {
            let mut out = vec![0.0; 44_100];
            let mut converter = Converter::new(48_000.0, 44_100.0, 1, quality).unwrap();
            let told = converter.whole(&loud, &mut out);
            assert!(matches!(told, Err(Error::Overflow { .. })), "{quality:?}: {told:?}");
            let told = converter.push(&loud, &mut Vec::new());
            assert!(matches!(told, Err(Error::Overflow { .. })), "{quality:?}, as a stream: {told:?}");
        }
    }
    // in the first of several blocks, between rates that are no ratio
    let mut early = vec![0.0; 200_000];
    early[..1_000].fill(f64::MAX);
    let mut converter = Converter::new(1.0, 0.3 * PI, 1, Quality::Fast).unwrap();
    let mut out = vec![0.0; converter.ratio().frames(200_000) as usize];
    let told = converter.whole(&early, &mut out);
    assert!(matches!(told, Err(Error::Overflow { .. })), "{told:?}");
}
