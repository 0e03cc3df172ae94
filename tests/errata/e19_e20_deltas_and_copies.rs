//! E19, E20: what convolution with deltas does, and when the low-pass may cut.

use num_complex::Complex;
use nyquist::prelude::*;

fn bump() -> Spectrum {
    RaisedCosine::new(0.4).expect("the band is positive").spectrum()
}

#[test]
fn e19_a_delta_elsewhere_shifts_and_its_weight_multiplies() {
    // as an integral: the delta as ever narrower Gaussians of area w at a
    let (a, w) = (0.7, 1.5);
    let f = |nu: f64| bump().density(nu).re;
    let narrow = |width: f64, nu: f64| -> f64 {
        let n = 4000;
        let h = 12.0 * width / f64::from(n);
        (0..=n)
            .map(|i| -6.0 * width + h * f64::from(i))
            .map(|s| {
                h * w / (width * (2.0 * std::f64::consts::PI).sqrt())
                    * (-0.5 * (s / width).powi(2)).exp()
                    * f(nu - a - s)
            })
            .sum()
    };
    let shifted = bump().convolved(&Spectrum::of_lines([Impulse::new(a, w)]).unwrap()).unwrap();
    for nu in [0.4, 0.7, 0.85] {
        // the error of the narrow Gaussian is width²/2·|f″| ≤ width²/2·w·(π/0.4)²/2
        let width = 1e-3;
        assert!((narrow(width, nu) - shifted.density(nu).re).abs() < width * width * w * 16.0);
        assert!((shifted.density(nu).re - w * f(nu - a)).abs() < 1e-15);
        // «свертка с дельта-функцией есть сигнал», as printed, is right for a delta at zero only
        assert!((shifted.density(nu).re - f(nu)).abs() > 0.1);
    }
    let same = bump().convolved(&Spectrum::of_lines([Impulse::new(0.0, 1.0)]).unwrap()).unwrap();
    assert!((-9..=9).all(|i| same.density(0.05 * f64::from(i)) == bump().density(0.05 * f64::from(i))));
}

#[test]
fn e19_deltas_with_deltas_add_their_places_and_multiply_their_weights() {
    let f = Spectrum::of_lines([Impulse::new(-1.0, 2.0), Impulse::new(3.0, Complex::new(0.0, 1.0))]).unwrap();
    let g = Spectrum::of_lines([Impulse::new(0.5, 0.25)]).unwrap();
    let both: Vec<_> = f.convolved(&g).unwrap().lines().iter().map(|l| (l.at, l.weight)).collect();
    assert_eq!(both, [(-0.5, Complex::new(0.5, 0.0)), (3.5, Complex::new(0.0, 0.25))]);
}

/// The largest distance between the low-passed sum of the copies and the spectrum itself, off the edges.
fn after_the_cut(spectrum: &Spectrum, rate: f64) -> f64 {
    let cut = spectrum
        .replicated(rate, 8)
        .expect("the rate is positive")
        .low_passed(0.5 * rate)
        .expect("the rate is positive");
    (-200..=200)
        .map(|i| 0.00501 * f64::from(i))
        .map(|nu| (cut.density(nu) - spectrum.density(nu)).norm())
        .fold(0.0, f64::max)
}

#[test]
fn e20_cutting_with_the_box_works_if_the_copies_do_not_overlap() {
    for rate in [0.8, 1.0, 3.0] {
        assert!(after_the_cut(&bump(), rate) < 1e-15, "rate {rate}"); // the band is 0.4
    }
}

#[test]
fn e20_cutting_with_the_box_does_not_help_where_copies_overlap() {
    for rate in [0.75, 0.6, 0.4] {
        assert!(after_the_cut(&bump(), rate) > 1e-3, "rate {rate}");
    }
    // the overlap of the source's figure: e^{−8ν²} one apart, twice its due at ν = ½ before the cut
    let gaussian = Gaussian::with_spectrum(8.0).unwrap().spectrum();
    let copies = gaussian.replicated(1.0, 4).unwrap();
    assert!((copies.density(0.5).re - 0.270_67).abs() < 5e-6 && (gaussian.density(0.5).re - 0.1353).abs() < 5e-5);
    // in space: the reconstruction goes through the samples and nowhere else
    let f = Gaussian::with_spectrum(8.0).unwrap();
    let samples = Samples::of(&f, Axis::centered(1.0, 201).unwrap());
    let back = reconstruct(&samples, Ideal);
    assert!((back.at(0.5) - 0.476_01).abs() < 5e-6 && (f.at(0.5) - 0.460_34).abs() < 5e-6 && back.at(0.0) == f.at(0.0));
}
