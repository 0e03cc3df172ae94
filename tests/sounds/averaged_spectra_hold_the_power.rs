//! Welch's mean of periodograms: its parts add up to the mean square, a tone reads its amplitude, noise its density.

use crate::material::{heard, mean_square, noise, tone};
use nyquist::inspect::sound::BETA;
use nyquist::num::{cos_pi, sin_pi};
use nyquist::sampled::segments::{Detrend, Segments};
use nyquist::sampled::welch::{Welch, welch};
use nyquist::sampled::window::Window;

#[test]
fn the_density_of_segments_that_do_not_overlap_adds_up_to_the_mean_square() {
    let values = noise(1, 6 * 500);
    for length in [500, 499] {
        let segments = Segments::new(length, length, Window::Rectangular).unwrap().detrend(Detrend::None);
        let spectrum = welch(&values[..6 * length], 44_100.0, segments).unwrap();
        let whole = mean_square(&values[..6 * length]);
        // sums of a transform: ε·log₂n for each of n values
        assert!((spectrum.total() / whole - 1.0).abs() < 1e-13, "{length}");
        assert!((spectrum.power(0.0, 22_050.0) / whole - 1.0).abs() < 1e-13);
        // and any cut adds up
        let parts: f64 =
            [0.0, 1.0, 700.0, 701.5, 9_000.0, 22_049.0, 22_050.0].windows(2).map(|w| spectrum.power(w[0], w[1])).sum();
        assert!((parts / whole - 1.0).abs() < 1e-13);
    }
}

#[test]
fn noise_reads_its_density_under_every_window() {
    let frames = 1 << 18;
    let values = noise(2, frames);
    for window in [Window::Rectangular, Window::Hann, Window::FlatTop, Window::Kaiser(BETA), Window::Gaussian(0.1)] {
        let spectrum = welch(&values, 48_000.0, Segments::new(1024, 512, window).unwrap()).unwrap();
        let truth = 1.0 / 12.0 / 24_000.0;
        let independent = spectrum.cut().independent(spectrum.segments());
        for k in [20, 100, 300, 511] {
            // five deviations of a mean of so many exponential variables
            let off = (spectrum.density()[k] / truth - 1.0).abs();
            assert!(off < 5.0 / independent.sqrt(), "{window}, bin {k}: {off}");
        }
    }
}

#[test]
fn independent_segments_are_as_many_as_their_mean_says() {
    // the variance of the mean over many bins, each of unit mean: 1/K
    let values = noise(4, 1 << 16);
    for (window, hop) in [(Window::Hann, 256), (Window::Kaiser(BETA), 64), (Window::Rectangular, 512)] {
        let spectrum = welch(&values, 1.0, Segments::new(512, hop, window).unwrap()).unwrap();
        let bins = &spectrum.density()[10..246];
        let mean = bins.iter().sum::<f64>() / bins.len() as f64;
        let variance = bins.iter().map(|p| (p / mean - 1.0).powi(2)).sum::<f64>() / bins.len() as f64;
        let said = spectrum.cut().independent(spectrum.segments());
        // a variance over 236 bins, of which neighbours under a wide window are alike (a tenth independent): √(2·10/236)
        assert!(
            (variance * said - 1.0).abs() < 5.0 * (20.0f64 / 236.0).sqrt(),
            "{window}: {} of {said}",
            1.0 / variance
        );
    }
}

#[test]
fn side_lobes_of_the_window_are_where_they_were_said_to_be() {
    let n = 1024;
    let weights = Window::Kaiser(BETA).values(n);
    let sum: f64 = weights.iter().sum();
    let transform = |bins: f64| {
        let turn = |j: usize| 2.0 * (bins * j as f64 / n as f64).rem_euclid(1.0);
        let (mut re, mut im) = (0.0, 0.0);
        for (j, w) in weights.iter().enumerate() {
            re += w * cos_pi(turn(j));
            im -= w * sin_pi(turn(j));
        }
        20.0 * (f64::hypot(re, im) / sum).log10()
    };
    let half = (1.0 + (BETA / std::f64::consts::PI).powi(2)).sqrt();
    // the first side lobe is the largest, and as narrow as a twentieth of a bin
    let near = (0..1000).map(|i| half + f64::from(i) * 0.002);
    let far = (0..2000).map(|i| half + 2.0 + f64::from(i) * 0.05);
    let worst = near.chain(far).map(transform).fold(f64::NEG_INFINITY, f64::max);
    let said = 20.0 * (0.217_234 * BETA / BETA.sinh()).log10();
    assert!((worst - said).abs() < 0.1 && said < -188.0, "{worst} {said}");
    // below the noise of 24 bits in a bin of 16384: a sine of full scale has ½, q²/12 spreads over 8192 bins 2.8 wide
    let noise = 10.0 * (2.0 * (2.0f64.powi(-23)).powi(2) / 12.0 * 2.8 / 8192.0).log10();
    assert!(worst < noise - 5.0, "{noise}");
}

#[test]
fn squared_windows_a_hop_apart_add_up_to_a_constant() {
    let n = 1024;
    let weights = Window::Kaiser(BETA).values(n);
    let sums: Vec<f64> = (0..n / 8).map(|j| (0..8).map(|i| weights[j + i * n / 8].powi(2)).sum()).collect();
    let (low, high) = sums.iter().fold((f64::INFINITY, 0.0), |(a, b): (f64, f64), &v| (a.min(v), b.max(v)));
    assert!(10.0 * (high / low).log10() < 2.0 * 0.013, "{low} {high}");
}

#[test]
fn lines_are_found_to_a_small_part_of_a_bin_in_noise_too() {
    let rate = 48_000.0;
    let hiss = noise(5, 192_000);
    let values: Vec<f64> = (0..192_000).map(|i| tone(0.1, 3_141.59, 0.3, rate, i) + 0.01 * hiss[i]).collect();
    let lines = heard(rate, &values).channels()[0].lines();
    assert_eq!(lines.len(), 1);
    // the noise of a bin is −48 dB of the line; of a frequency from neighbouring bins that is some thousandths of a bin,
    // of an amplitude some thousandths of it, less the root of the number of averages
    let bin = rate / 16_384.0;
    assert!((lines[0].frequency - 3_141.59).abs() < 0.01 * bin, "{lines:?}");
    assert!((lines[0].amplitude / 0.1 - 1.0).abs() < 0.01, "{lines:?}");
}

#[test]
fn a_record_shorter_than_a_segment_is_one() {
    let values = noise(6, 100);
    let whole = welch(&values, 1.0, Segments::new(100, 100, Window::Hann).unwrap()).unwrap();
    let mut welch = Welch::new(1.0, 1, Segments::new(1000, 500, Window::Hann).unwrap()).unwrap();
    welch.push(&values[..40]).unwrap();
    welch.push(&values[40..]).unwrap();
    let short = welch.finish().unwrap().remove(0);
    assert_eq!((short.density(), short.segments()), (whole.density(), 1));
    let one = Segments::new(8, 4, Window::Hann).unwrap();
    assert!(Welch::new(1.0, 1, one).unwrap().finish().is_err());
    assert_eq!(nyquist::sampled::welch::welch(&[3.0], 1.0, one).unwrap().density(), [0.0]);
}

#[test]
fn nonsense_is_refused_and_nothing_taken() {
    assert!(Segments::new(1, 1, Window::Hann).is_err());
    assert!(Segments::new(8, 0, Window::Hann).is_err());
    assert!(Segments::new(8, 9, Window::Hann).is_err());
    assert!(Segments::new(1 << 25, 1, Window::Hann).is_err());
    let segments = Segments::new(8, 4, Window::Hann).unwrap();
    assert!(Welch::new(0.0, 1, segments).is_err() && Welch::new(1.0, 0, segments).is_err());
    let mut welch = Welch::new(1.0, 2, segments).unwrap();
    assert!(welch.push(&[1.0; 3]).is_err());
    assert!(welch.push(&[1.0, f64::NAN]).is_err());
    // a power that would be infinite
    assert!(welch.push(&[1e200; 16]).is_err());
    assert!(welch.finish().is_err());
}

#[test]
fn means_of_loud_constants_are_taken_away_to_the_last_bit() {
    // a plain sum of 8192 times 0.1, divided, is not 0.1
    let constant = vec![0.1; 8_192];
    // of the mean under the window one rounding of 0.1 may be left
    for (detrend, most) in [(Detrend::Mean, 0.0), (Detrend::WindowedMean, 0.1 * f64::EPSILON)] {
        let segments = Segments::new(8_192, 8_192, Window::Hann).unwrap().detrend(detrend);
        let spectrum = welch(&constant, 48_000.0, segments).unwrap();
        assert!(spectrum.amplitude(0) <= most, "{detrend:?}: {:e}", spectrum.amplitude(0));
    }
}
