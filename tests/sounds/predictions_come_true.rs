//! Whatever a forecast says of another rate is found when it is done: each tone at its place and as strong as said, no more
//! of it where a filter was promised, and as much power in all.

use crate::material::{fitted, heard, mean_square, noise, speech, tone};
use nyquist::axis::Axis;
use nyquist::inspect::sound::{Check, Sound, Way};
use nyquist::nyquist::fold;
use nyquist::rate::convert;
use nyquist::sampled::Samples;
use nyquist::sampled::dft::{forward, inverse};

const OWN: f64 = 48_000.0;

/// Amplitude, frequency, phase: three tones that stay at all rates here, and five that fold.
const TONES: [[f64; 3]; 8] = [
    [0.3, 440.3, 0.1],
    [0.1, 1_234.5, 0.7],
    [0.05, 2_998.7, 0.4],
    [0.02, 9_123.4, 0.3],
    [0.01, 12_345.6, 0.9],
    [0.003, 17_777.7, 0.2],
    [0.001, 19_191.9, 0.6],
    [0.0001, 22_222.2, 0.5],
];

/// Rates below, in whole and in no ratio to 48 kHz; at 7000 Hz tones fold up to six times.
const RATES: [f64; 6] = [16_000.0, 12_000.0, 8_000.0, 11_025.0, 7_000.0, 15_915.494_309_189_535];

fn tones(rate: f64, frames: usize) -> Vec<f64> {
    (0..frames).map(|i| TONES.iter().map(|[a, f, p]| tone(*a, *f, *p, rate, i)).sum()).collect()
}

fn multitone() -> Sound {
    heard(OWN, &tones(OWN, 96_000))
}

#[test]
fn each_tone_is_found_where_it_was_said_to_land_and_as_strong() {
    let sound = multitone();
    for rate in RATES {
        let forecast = &sound.sampled_at(rate).unwrap()[0];
        assert_eq!(forecast.folded.len(), 5, "{rate}");
        // the values at the new times: every third sample and so on where the ratio is whole
        let sampled = match OWN / rate {
            step if step.fract() == 0.0 => tones(OWN, 96_000).into_iter().step_by(step as usize).collect(),
            _ => tones(rate, (2.0 * rate) as usize),
        };
        let stay = sound.channels()[0].lines().into_iter().filter(|line| line.frequency < 0.5 * rate);
        let places: Vec<f64> =
            stay.map(|l| l.frequency).chain(forecast.folded.iter().map(|f| f.alias.frequency())).collect();
        let (amplitudes, rest) = fitted(&sampled, rate, &places);
        for (folded, amplitude) in forecast.folded.iter().zip(&amplitudes[3..]) {
            // side lobes of the strongest tone, 188 dB down, beside this one: in the amplitude, and in its frequency as a
            // part of a bin, which is worth at most so much amplitude over the record
            let leak = 10f64.powf(-188.0 / 20.0) * 0.3;
            let bins = leak / folded.line.amplitude;
            let off = std::f64::consts::PI * bins * OWN / 8192.0 * 2.0 * folded.line.amplitude;
            let found = (amplitude - folded.line.amplitude).abs();
            println!("{rate}: {:.1} → {:.3}, {found:e}", folded.line.frequency, folded.alias.frequency());
            assert!(found <= leak + off, "{rate}: {} ≠ {amplitude}", folded.line.amplitude);
        }
        // and there is nothing else: what is left are the errors of eight frequencies
        assert!(rest <= 8.0 * 1e-8f64.powi(2), "{rate}: {rest:e}");
        // in the closed form too
        for folded in &forecast.folded {
            let nearest = |f: &[f64; 3]| (f[1] - folded.line.frequency).abs();
            let truth = TONES.iter().min_by(|a, b| nearest(a).total_cmp(&nearest(b))).unwrap();
            assert!((folded.alias.frequency() - fold(truth[1], rate)).abs() < 1e-3);
            assert!((folded.line.amplitude / truth[0] - 1.0).abs() < 1e-3);
        }
    }
}

#[test]
fn filters_leave_at_most_what_was_said() {
    let sound = multitone();
    let values = tones(OWN, 96_000);
    for rate in RATES {
        let forecast = &sound.sampled_at(rate).unwrap()[0];
        for (way, outcome) in Way::ALL.into_iter().zip(forecast.outcomes).skip(1) {
            let Way::Filtered(quality) = way else { unreachable!("plain was skipped") };
            // transforms round to 2·10⁻¹³ of the loudest tone, tables of irrational ratios err by 2·10⁻¹² of it
            let rounding = 3e-12;
            for (folded, [a, f, p]) in forecast.folded.iter().zip(&TONES[3..]) {
                let alone: Vec<f64> = (0..96_000).map(|i| tone(*a, *f, *p, OWN, i)).collect();
                let converted = convert(&alone, OWN, rate, quality).unwrap();
                let middle = &converted[converted.len() / 4..converted.len() * 3 / 4];
                let worst = middle.iter().map(|v| v.abs()).fold(0.0, f64::max);
                let said = folded.line.amplitude * forecast.gain(way, folded.line.frequency);
                println!("{rate}, {}: {f} Hz {worst:e} ≤ {said:e}", way.name());
                assert!(worst <= said + a * rounding, "{rate}, {}: {worst:e} > {said:e}", way.name());
            }
            let converted = convert(&values, OWN, rate, quality).unwrap();
            // away from the ends, where silence begins
            let middle = &converted[converted.len() / 4..converted.len() * 3 / 4];
            let stay = [440.3, 1_234.5, 2_998.7];
            // all that is left beside the three tones, images of the ratio among it: below the promise for each
            let (_, rest) = fitted(middle, rate, &stay);
            let images = (0.45 * 10f64.powf(-quality.promise().rejection / 20.0)).powi(2);
            assert!(rest <= outcome.aliases + images + (0.45 * rounding).powi(2), "{rate}, {}: {rest:e}", way.name());
        }
    }
}

/// The part of a record within frequencies, by the transform of the whole: the record begins and ends in silence.
fn band(values: &[f64], rate: f64, from: f64, to: f64) -> Vec<f64> {
    let samples = Samples::new(
        Axis::new(0.0, 1.0 / rate, values.len()).expect("finite values at a positive rate"),
        values.to_vec(),
    )
    .expect("finite values at a positive rate");
    let bins = forward(&samples);
    let below = |cutoff: f64| inverse(&bins.low_passed(cutoff).expect("finite values at a positive rate"));
    let (upper, lower) = (below(to), below(from));
    upper.values().iter().zip(lower.values()).map(|(a, b)| a - b).collect()
}

#[test]
fn speech_folds_as_much_as_was_said_and_where() {
    let values = speech(OWN);
    let sound = heard(OWN, &values);
    let within = |found: f64, said: f64, most: f64| {
        let off = 10.0 * (found / said).log10();
        println!("{off:+.3} dB of {most:.3}");
        assert!(off.abs() <= most, "{found:e} ≠ {said:e}");
    };
    for step in [3usize, 4, 6] {
        let rate = OWN / step as f64;
        let forecast = &sound.sampled_at(rate).unwrap()[0];
        let high = band(&values, OWN, 0.5 * rate, OWN);
        // squared windows add up to within 0.013 dB; the share of what crosses the edge is within the width of a line, 23 Hz
        // of some thousand
        let windows = 0.013 + 10.0 * (1.0f64 + 46.0 / 4000.0).log10();
        within(mean_square(&high), forecast.outcomes[0].aliases, windows);
        within(mean_square(&values) - mean_square(&high), forecast.outcomes[0].signal, windows);
        // and done: of a third of the values the mean square is known to √(2/n), of hiss that sounds for 0.4 s; five of these
        let dropped: Vec<f64> = high.iter().copied().step_by(step).collect();
        let statistics = 10.0 * (1.0 + 5.0 * (2.0 / (0.2 * rate)).sqrt()).log10();
        within(mean_square(&dropped), forecast.outcomes[0].aliases, windows + statistics);
        // each stretch lands where it was said to: found there in the samples that were kept
        for stretch in &forecast.stretches {
            let [from, to] = stretch.landing.from;
            let alone: Vec<f64> = band(&values, OWN, from, to).into_iter().step_by(step).collect();
            let [a, b] = stretch.landing.to;
            let there = if a.min(b) == 0.0 { alone.clone() } else { band(&alone, rate, a.min(b), a.max(b)) };
            let inside = mean_square(&there) / mean_square(&alone);
            assert!(inside > 0.999, "{from}–{to} Hz: {inside} of it within {a}–{b}");
            let statistics = 10.0 * (1.0 + 5.0 * (2.0 / (0.4 * (to - from))).sqrt()).log10();
            within(mean_square(&alone), stretch.power, windows + statistics);
        }
    }
}

#[test]
fn the_smallest_rate_is_enough_and_the_next_lower_is_not() {
    let sound = multitone();
    let power = |rate: f64| {
        let (below, beyond): (Vec<&[f64; 3]>, Vec<_>) = TONES.iter().partition(|t| t[1] < 0.5 * rate);
        let sum = |tones: Vec<&[f64; 3]>| tones.iter().map(|t| t[0] * t[0]).sum::<f64>();
        10.0 * (sum(below) / sum(beyond)).log10()
    };
    for (tolerance, enough, lower) in [(20.0, 8_000, 7_000.0), (25.0, 22_050, 16_000.0), (45.0, 44_100, 32_000.0)] {
        assert_eq!(sound.smallest_rate(tolerance), Some(enough));
        assert!(power(f64::from(enough)) >= tolerance && (enough == 8_000 || power(lower) < tolerance));
        assert!(Check::new(sound.clone(), Some(f64::from(enough)), tolerance).unwrap().fine());
        assert_eq!(Check::new(sound.clone(), Some(lower), tolerance).unwrap().fine(), power(lower) >= tolerance);
    }
    // 22222.2 Hz at −80 dBFS beside 0.3: 70 dB; nothing standard below 48 kHz holds it
    assert_eq!(sound.smallest_rate(90.0), None);
}

#[test]
fn a_burst_in_a_long_sound_is_not_drowned_in_the_mean() {
    // ten seconds of a tone, and for 20 ms hiss of a twentieth of its power
    let (frames, burst) = (480_000, 300_000..300_960);
    let hiss = noise(3, frames);
    let values: Vec<f64> = (0..frames)
        .map(|i| tone(0.5, 700.0, 0.0, OWN, i) + if burst.contains(&i) { 0.27 * hiss[i] } else { 0.0 })
        .collect();
    let check = Check::new(heard(OWN, &values), Some(16_000.0), 40.0).unwrap();
    assert!(check.fine(), "{}", check.ratio());
    let loudest = check.forecasts()[0].loudest.unwrap();
    assert!((loudest.time - 6.26).abs() < 0.02, "{}", loudest.time);
    // two thirds of the hiss lie beyond 8 kHz: 0.27²/12·⅔ = −21.0 dB of the tone's ½·0.5²; a moment is a mean over about 400
    // values, known to 5·√(2/400), and may lie half in the burst
    let ratio = check.burst().expect("the burst is above the tolerance");
    assert!((14.0..25.0).contains(&ratio), "{ratio}");
}

#[test]
fn nothing_folds_at_its_own_rate_and_above() {
    let sound = multitone();
    for rate in [48_000.0, 48_000.5, 96_000.0, 4e7] {
        let check = Check::new(sound.clone(), Some(rate), 300.0).unwrap();
        assert!(check.fine() && check.ratio() == f64::INFINITY && check.burst().is_none());
        assert!(check.forecasts()[0].folded.is_empty() && check.forecasts()[0].stretches.is_empty());
        assert_eq!(check.forecasts()[0].outcomes[0].aliases, 0.0);
    }
}

#[test]
fn rates_that_are_none_are_refused() {
    let sound = multitone();
    for rate in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e308, 40.0, 1e-300] {
        assert!(sound.sampled_at(rate).is_err(), "{rate}");
    }
    for tolerance in [-1.0, f64::NAN, 301.0] {
        assert!(Check::new(sound.clone(), None, tolerance).is_err());
    }
}

#[test]
fn what_sounds_at_the_very_beginning_or_end_counts() {
    // hiss that dies away within 20 ms, from the first sample on or up to the last, beside a tone
    let hiss = noise(8, 144_000);
    let attack = |i: usize| hiss[i] * (-(i as f64) / 960.0).exp();
    for reversed in [false, true] {
        let values: Vec<f64> = (0..144_000)
            .map(|i| tone(0.1, 1_000.0, 0.25, OWN, i) + attack(if reversed { 143_999 - i } else { i }))
            .collect();
        let forecast = &heard(OWN, &values).sampled_at(16_000.0).unwrap()[0];
        // two thirds of its power lie beyond 8 kHz
        let truth = 2.0 / 3.0 * (0..144_000).map(|i| attack(i).powi(2)).sum::<f64>() / 144_000.0;
        let off = 10.0 * (forecast.outcomes[0].aliases / truth).log10();
        // the effective number of values is that of 10 ms, 480: five deviations of a mean of two thirds of them
        assert!(off.abs() < 10.0 * (1.0 + 5.0 * (2.0 / 320.0f64).sqrt()).log10(), "{off} dB");
    }
}

#[test]
fn a_tone_that_is_cut_off_stays_a_tone() {
    // begins and ends anywhere in its period, 100 Hz below the new Nyquist frequency
    for phase in [0.0, 0.13, 0.5, 0.77] {
        let values: Vec<f64> = (0..50_000).map(|i| tone(0.5, 7_900.0, phase, OWN, i)).collect();
        let sound = heard(OWN, &values);
        assert!(sound.plain_ratio(16_000.0) > 150.0, "{}", sound.plain_ratio(16_000.0));
        let band = sound.channels()[0].occupied(0.9999).unwrap().unwrap();
        assert!((band - 7_900.0).abs() < 50.0, "{band}");
        // no moment is loud beyond the limit, though a stretch of 512 samples sees a tone 722 Hz wide to either side
        let check = Check::new(sound, Some(16_000.0), 60.0).unwrap();
        assert!(check.fine() && check.burst().is_none(), "{:?}", check.burst());
    }
}

#[test]
fn tones_beyond_the_limit_leave_nothing_below_it() {
    // rounded to 24 bits; their plain mean over a segment, taken away, would stand at 0 Hz: 97 dB below full scale
    let values: Vec<f64> = (0..96_000)
        .map(|i| tone(0.3, 4_103.7, 0.2, OWN, i) + tone(0.2, 9_871.3, 0.1, OWN, i))
        .map(|v| (v * 8_388_608.0).round() / 8_388_608.0)
        .collect();
    let outcome = heard(OWN, &values).sampled_at(8_000.0).unwrap()[0].outcomes[0];
    // the rounding of 24 bits: q²/12, a sixth of it below 4 kHz; twice as much for what of it is in lines
    let rounding = 2.0f64.powi(-46) / 12.0 / 6.0;
    assert!(outcome.signal < 2.0 * rounding, "{:e} of {rounding:e}", outcome.signal);
}
