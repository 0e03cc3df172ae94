//! Bands, floors and levels of sounds whose making is known.

use crate::material::{heard, noise, tone};
use nyquist::inspect::sound::{Check, Ending, Meter, TOLERANCE, dbfs};

const RATE: f64 = 48_000.0;

#[test]
fn occupied_bands_end_where_the_power_does() {
    // 0.99, 0.0099 and 0.00009 of the power and a rest, at four frequencies
    let parts = [(0.99f64, 300.0), (0.0099, 2_000.0), (0.000_09, 7_000.0), (0.000_01, 15_000.0)];
    let values: Vec<f64> =
        (0..96_000).map(|i| parts.iter().map(|(p, f)| tone(0.5 * p.sqrt(), *f, 0.1, RATE, i)).sum()).collect();
    let sound = heard(RATE, &values);
    let channel = &sound.channels()[0];
    // a line is 7.7 bins of 2.93 Hz wide to either side
    let width = 8.0 * channel.spectrum().step();
    for (fraction, at) in [(0.98, 300.0), (0.995, 2_000.0), (0.999_95, 7_000.0), (0.999_995, 15_000.0)] {
        let band = channel.occupied(fraction).unwrap().unwrap();
        assert!((band - at).abs() < width, "{fraction}: {band}");
    }
    assert!(channel.occupied(1.0).is_err() && channel.occupied(0.0).is_err() && channel.occupied(f64::NAN).is_err());
}

#[test]
fn levels_are_those_of_full_scale_sines() {
    let values: Vec<f64> = (0..48_000).map(|i| 0.25 + tone(0.5, 1_000.0, 0.0, RATE, i)).collect();
    let levels = heard(RATE, &values).channels()[0].levels();
    // sums of 48000 values, of partial sums: 48000·ε at most
    let most = 48_000.0 * f64::EPSILON;
    assert!((levels.mean - 0.25).abs() < most && (levels.power - 0.125).abs() < most);
    assert_eq!(levels.peak(), 0.75);
    assert!((dbfs(levels.power) + 6.0206).abs() < 1e-4);
    // a large offset does not drown what is quiet: ε of the offset in each value, and not in its square
    let quiet: Vec<f64> = values.iter().map(|v| 1e6 + (v - 0.25) * 1e-3).collect();
    let levels = heard(RATE, &quiet).channels()[0].levels();
    // of each value half of it at most, and twice that in the quotient by the root mean square
    let most = 1e6 * f64::EPSILON / 1.25e-7f64.sqrt();
    assert!((levels.power / 1.25e-7 - 1.0).abs() < most, "{}", levels.power);
}

#[test]
fn the_noise_floor_is_that_of_the_rounding() {
    let signal = |i: usize| tone(0.5, 997.0, 0.1, RATE, i) + tone(0.3, 3_001.0, 0.7, RATE, i);
    let dither = noise(21, 400_000);
    for bits in [8, 12, 16, 20, 24] {
        let step = 2.0f64.powi(1 - bits);
        // uniform dither of one step: rounding is noise of q²/12, and so is the dither
        let values: Vec<f64> = (0..200_000).map(|i| ((signal(i) / step + dither[i]).round()) * step).collect();
        let floor = heard(RATE, &values).channels()[0].floor().unwrap();
        // twice q²/12 is half a bit; the quietest of 64 medians of about 128 bins, each a mean over 12·1.5 segments
        let said = f64::from(bits) - 0.5;
        assert!((floor.bits() - said).abs() < 0.12, "{bits}: {}", floor.bits());
    }
}

#[test]
fn the_floor_does_not_see_lines() {
    let hiss = noise(22, 200_000);
    let lines = |i: usize| (1..120).map(|k| tone(0.003, 199.0 * f64::from(k), 0.2, RATE, i)).sum::<f64>();
    let floor = |with: f64| {
        let values: Vec<f64> = (0..200_000).map(|i| 1e-4 * hiss[i] + with * lines(i)).collect();
        dbfs(heard(RATE, &values).channels()[0].floor().unwrap().density)
    };
    // a tenth of a bit, as above
    let truth = dbfs(1e-8 / 12.0 / 24_000.0);
    assert!((floor(0.0) - truth).abs() < 0.6 && (floor(1.0) - truth).abs() < 0.6, "{} {}", floor(0.0), floor(1.0));
}

#[test]
fn silence_has_no_band_and_nothing_to_alias() {
    for offset in [0.0, 0.1, -1.0] {
        let sound = heard(RATE, &[offset; 10_000]);
        let channel = &sound.channels()[0];
        assert!(channel.silent() && channel.floor().is_none() && channel.ending().is_none());
        assert!(channel.lines().is_empty() && channel.occupied(0.99).unwrap().is_none());
        assert_eq!((channel.power_within(0.0, RATE), channel.edge_power(), channel.levels().power), (0.0, 0.0, 0.0));
        assert!(channel.loudest_beyond(0.0).is_none());
        for rate in [None, Some(8_000.0)] {
            let check = Check::new(sound.clone(), rate, TOLERANCE).unwrap();
            assert!(check.fine() && check.ratio() == f64::INFINITY && check.ending().is_none());
        }
    }
}

#[test]
fn a_silent_channel_does_not_hide_the_other() {
    let frames: Vec<f64> = (0..48_000).flat_map(|i| [0.0, tone(0.5, 9_000.0, 0.0, RATE, i)]).collect();
    let mut meter = Meter::new(RATE, 2).unwrap();
    meter.push(&frames).unwrap();
    let check = Check::new(meter.finish().unwrap(), Some(16_000.0), TOLERANCE).unwrap();
    assert!(!check.fine() && check.worst() == 1);
}

#[test]
fn full_scale_noise_is_flat_and_runs_into_its_nyquist_frequency() {
    let values: Vec<f64> = noise(23, 300_000).iter().map(|v| 2.0 * v).collect();
    let check = Check::new(heard(RATE, &values), None, TOLERANCE).unwrap();
    assert!(!check.fine());
    // a sixteenth of the power in the last sixteenth, known to 5·√(2/(300000/16))
    assert!((check.ratio() - 12.04).abs() < 0.25, "{}", check.ratio());
    assert_eq!(check.ending(), Some(Ending::Flat));
    assert!(check.sound().channels()[0].lines().is_empty());
}

#[test]
fn too_few_frames_are_refused() {
    for frames in [0, 1, 63] {
        let mut meter = Meter::new(RATE, 1).unwrap();
        meter.push(&noise(24, frames)).unwrap();
        let error = meter.finish().unwrap_err().to_string();
        assert!(error.contains("at least 64 needed"), "{error}");
    }
    assert!(Meter::new(RATE, 0).is_err() && Meter::new(f64::NAN, 1).is_err() && Meter::new(0.0, 1).is_err());
    let mut meter = Meter::new(RATE, 2).unwrap();
    assert!(meter.push(&[1.0]).is_err() && meter.push(&[1.0, f64::INFINITY]).is_err());
    assert!(meter.finish().is_err(), "nothing was taken");
}

#[test]
fn a_low_tone_alone_is_a_tone_and_noise_that_rises_towards_zero_is_none() {
    for (frequency, frames) in [(10.0, 240_000), (20.0, 240_000), (33.3, 240_000), (33.3, 96_000), (100.0, 48_000)] {
        let values: Vec<f64> = (0..frames).map(|i| tone(0.9, frequency, 0.3, RATE, i)).collect();
        let sound = heard(RATE, &values);
        let channel = &sound.channels()[0];
        let lines = channel.lines();
        let line = lines.first().expect("there is a tone");
        // without any noise the side lobes of the window are seen, 188 dB down
        let lobes = lines[1..].iter().all(|other| other.amplitude < 10f64.powf(-188.0 / 20.0) * line.amplitude);
        assert!(lobes, "{frequency} Hz: {lines:?}");
        // beside zero to a bin and 1 dB
        assert!((line.frequency - frequency).abs() < channel.spectrum().step(), "{frequency} Hz: {line:?}");
        assert!((20.0 * (line.amplitude / 0.9).log10()).abs() < 1.0, "{frequency} Hz: {line:?}");
    }
    // steps that are summed: 6 dB an octave; and a ramp, which no mean takes away
    let walk = noise(5, 240_000).into_iter().scan(0.0, |sum, v| {
        *sum += 1e-3 * v;
        Some(*sum)
    });
    let ramp = noise(6, 240_000).into_iter().enumerate().map(|(i, v)| 1e-6 * i as f64 + 1e-4 * v);
    for values in [walk.collect::<Vec<_>>(), ramp.collect()] {
        assert!(heard(RATE, &values).channels()[0].lines().is_empty());
    }
}

#[test]
fn sounds_whose_squares_overflow_or_vanish_are_refused() {
    let tone = |size: f64| (0..4096).map(|i| size * (0.3 * f64::from(i)).sin()).collect::<Vec<f64>>();
    let mut meter = Meter::new(8000.0, 1).unwrap();
    assert!(meter.push(&tone(1e200)).is_err());
    meter.push(&tone(1.0)).unwrap(); // nothing of what was refused is left
    let mut faint = Meter::new(8000.0, 1).unwrap();
    faint.push(&tone(1e-200)).unwrap();
    assert!(faint.finish().is_err());
}
