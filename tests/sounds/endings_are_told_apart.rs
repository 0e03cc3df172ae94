//! Sound that was upsampled or cut ends otherwise than sound that fades.

use crate::material::{heard, noise, speech, tone};
use nyquist::inspect::sound::Ending;
use nyquist::num::{cos_pi, random};
use nyquist::rate::{Quality, convert};
use nyquist::sampled::dft::{dft, inverse_dft};

const RATE: f64 = 48_000.0;

fn ending(values: &[f64]) -> Ending {
    heard(RATE, values).channels()[0].ending().expect("there is sound")
}

/// Rounded to 16 bits, with triangular dither or without.
fn rounded(values: &[f64], dither: bool) -> Vec<f64> {
    let random = |i: usize, d: u32| random::uniform(31, i as u64, d);
    let with = |i: usize| if dither { random(i, 0) - random(i, 1) } else { 0.0 };
    values.iter().enumerate().map(|(i, v)| (v * 32_768.0 + with(i)).round() / 32_768.0).collect()
}

/// Noise under a density that falls by so many dB an octave from 1 kHz on.
fn fading(decibels: f64, frames: usize) -> Vec<f64> {
    let spectrum = dft(&noise(32, frames)).expect("finite values");
    let weight = |k: usize| {
        let frequency = k.min(frames - k) as f64 * RATE / frames as f64;
        0.3 * (frequency / 1000.0).max(1.0).powf(-decibels / 6.0206)
    };
    inverse_dft(&spectrum.iter().enumerate().map(|(k, z)| z * weight(k)).collect::<Vec<_>>()).expect("finite values")
}

#[test]
fn upsampled_sound_is_cut_where_its_own_nyquist_frequency_was() {
    for (from, enough) in
        [(8_000.0, 8_000), (16_000.0, 16_000), (22_050.0, 22_050), (32_000.0, 32_000), (44_100.0, 44_100)]
    {
        for quality in Quality::ALL {
            let up = convert(&speech(from), from, RATE, quality).unwrap();
            for values in [up.clone(), rounded(&up, true), rounded(&up, false)] {
                let ending = ending(&values);
                assert!(matches!(ending, Ending::Cut { .. }), "{from}, {quality}: {ending:?}");
                assert_eq!(ending.enough(), Some(enough), "{from}, {quality}: {ending:?}");
                // it ends within the transition of the filter
                let (at, nyquist) = (ending.at().unwrap(), 0.5 * from);
                assert!(at < nyquist + 25.0 && at > 0.9 * nyquist, "{from}, {quality}: {at}");
            }
        }
    }
}

#[test]
fn sound_that_fades_is_not_cut() {
    for decibels in [6.0, 12.0, 24.0, 40.0, 60.0] {
        for values in [rounded(&fading(decibels, 240_000), true), rounded(&fading(decibels, 240_000), false)] {
            let ending = ending(&values);
            assert!(!matches!(ending, Ending::Cut { .. }), "{decibels} dB an octave: {ending:?}");
        }
    }
}

#[test]
fn a_fade_ends_where_it_meets_the_floor() {
    // 24 dB an octave from −21 dBFS (0.3²/12, spread over 24 kHz) at 1 kHz to the floor of 16 bits with dither
    let Ending::Falls { at } = ending(&rounded(&fading(24.0, 240_000), true)) else { panic!("it falls") };
    let (start, floor) = (0.3f64.powi(2) / 12.0, 3.0 * (2.0f64.powi(-15)).powi(2) / 12.0);
    // density and floor together stand 6 dB above the floor where the density alone is three times the floor; single bins
    // of some averages scatter beyond that place
    let place = 1000.0 * (start / floor / 3.0).powf(3.0103 / 24.0);
    assert!((at / place - 1.0).abs() < 0.2, "{at} {place}");
}

#[test]
fn tones_alone_end_and_are_not_cut() {
    let values: Vec<f64> =
        (0..96_000).map(|i| tone(0.4, 1_000.3, 0.1, RATE, i) + tone(0.1, 5_000.7, 0.2, RATE, i)).collect();
    for values in [values.clone(), rounded(&values, true)] {
        let ending = ending(&values);
        assert!(matches!(ending, Ending::Falls { at } if (at - 5_000.7).abs() < 60.0), "{ending:?}");
        assert_eq!(ending.enough(), Some(11_025));
    }
}

#[test]
fn a_square_wave_made_carelessly_runs_into_its_nyquist_frequency() {
    // sign of a sine of 1003 Hz: harmonics beyond 24 kHz have folded
    let values: Vec<f64> = (0..144_000).map(|i| 0.5 * tone(1.0, 1_003.0, 0.1, RATE, i).signum()).collect();
    assert_eq!(ending(&values), Ending::Runs);
    // and a band-limited one does not, if it stops before
    let series = |i: usize| {
        (0..10).map(|k| tone(0.6 / f64::from(2 * k + 1), 1_003.0 * f64::from(2 * k + 1), 0.0, RATE, i)).sum::<f64>()
    };
    let limited: Vec<f64> = (0..144_000).map(series).collect();
    assert!(matches!(ending(&rounded(&limited, true)), Ending::Falls { at } if (at - 19_057.0).abs() < 60.0));
}

#[test]
fn a_sweep_that_stops_is_cut_there() {
    // 0 to 10 kHz in four seconds, linearly; t² in turns, reduced
    let sweep = |i: usize| {
        let t = i as f64 / RATE;
        cos_pi(2.0 * (0.5 * 2_500.0 * t * t).fract())
    };
    // faded out at the end: a tone that is torn off has no end
    let fade = |i: usize| ((192_000.0 - i as f64) / 4_800.0).min(1.0);
    let mut values: Vec<f64> = (0..192_000).map(|i| 0.5 * sweep(i) * (0.5 - 0.5 * cos_pi(fade(i)))).collect();
    values.extend([0.0; 24_000]);
    let ending = ending(&rounded(&values, true));
    assert!(matches!(ending, Ending::Cut { at, .. } if (9_900.0..10_600.0).contains(&at)), "{ending:?}");
}

#[test]
fn a_loud_beginning_does_not_hide_a_cut() {
    let mut struck = noise(33, 48_000);
    struck.iter_mut().enumerate().for_each(|(i, v)| *v *= 0.5 * (-(i as f64) / 400.0).exp() + 0.01);
    let up = convert(&struck, 16_000.0, RATE, Quality::High).unwrap();
    let ending = ending(&rounded(&up, true));
    assert!(matches!(ending, Ending::Cut { .. }), "{ending:?}");
    assert_eq!(ending.enough(), Some(16_000));
}

#[test]
fn what_only_sounds_in_the_last_moment_is_an_end_too() {
    // from 20 Hz to 20 kHz in five seconds, exponentially: the last half octave takes a quarter of a second
    let octaves = 1000.0f64.log2();
    let turns = |t: f64| 20.0 * 5.0 / (octaves * std::f64::consts::LN_2) * ((octaves * t / 5.0).exp2() - 1.0);
    let values: Vec<f64> = (0..240_000).map(|i| 0.5 * cos_pi(2.0 * turns(i as f64 / RATE).fract())).collect();
    let sound = heard(RATE, &rounded(&values, true));
    let channel = &sound.channels()[0];
    // of the power 1/octaves lies in an octave: 99.9 % below 20 kHz/2^{0.01}
    let band = channel.occupied(0.999).unwrap().unwrap();
    assert!((band - 20_000.0 * (-0.001 * octaves).exp2()).abs() < 500.0, "{band}");
    assert!(channel.ending().unwrap().at().is_none_or(|at| at > 19_500.0), "{:?}", channel.ending());
}

#[test]
fn no_end_is_below_the_highest_tone_nor_below_nearly_all_of_the_power() {
    for (frequency, frames) in [
        (300.0, 96_000),
        (300.0, 20_000),
        (997.3, 240_000),
        (1_234.5, 48_000),
        (1_500.0, 240_000),
        (5_000.2, 144_000),
        (7_903.4, 50_000),
        (20_000.0, 48_000),
    ] {
        let values: Vec<f64> = (0..frames).map(|i| tone(0.9, frequency, 0.1, RATE, i)).collect();
        for values in [values.clone(), rounded(&values, true)] {
            let sound = heard(RATE, &values);
            let channel = &sound.channels()[0];
            let ending = channel.ending().expect("there is sound");
            assert!(!matches!(ending, Ending::Cut { .. }), "{frequency} Hz, {frames} frames: {ending:?}");
            let at = ending.at().expect("it ends");
            // a tone of the whole record is known to 10⁻⁴ of a bin, that in noise to a hundredth
            let step = channel.spectrum().step();
            assert!(at > frequency - 0.01 * step && at < frequency + 8.0 * step, "{frequency} Hz: {at}");
            let band = channel.occupied(0.99).unwrap().unwrap();
            assert!(at >= band, "{frequency} Hz: {at} < {band}");
        }
    }
}
