//! E18: «all sensors integrate over an area» and «sampling is reading a signal at points» are one statement only together:
//! a sensor is a prefilter (the pixel's area, the shutter, …) followed by point sampling. A renderer's pinhole is not.

use nyquist::num::sinc;
use nyquist::prelude::*;
use std::f64::consts::PI;

/// What a pixel of width `a` around `x` sees of `cos(2πνx)`, from the primitive of the cosine.
fn seen(nu: f64, x: f64, a: f64) -> f64 {
    let primitive = |x: f64| (2.0 * PI * nu * x).sin() / (2.0 * PI * nu);
    (primitive(x + 0.5 * a) - primitive(x - 0.5 * a)) / a
}

#[test]
fn what_pixels_integrate_are_point_samples_of_the_filtered_signal_and_not_of_the_signal() {
    for fill in [1.0, 0.5] {
        for nu in [0.2, 0.5, 0.9] {
            // the signal behind a box as wide as the pixel's sensitive part: its only change is a factor
            let filtered = Scaled::new(sinc(nu * fill), Cosine::new(nu).unwrap()).unwrap();
            let original = Cosine::new(nu).unwrap();
            for i in 0..20 {
                let x = f64::from(i);
                assert!((seen(nu, x, fill) - filtered.at(x)).abs() < 1e-14);
                let printed = (seen(nu, x, fill) - original.at(x)).abs(); // «sampling is reading the signal»
                assert!((printed - original.at(x).abs() * (1.0 - sinc(nu * fill))).abs() < 1e-14);
            }
        }
    }
    // at Nyquist a full pixel keeps 0.637, half a pixel 0.900
    assert!(
        (seen(0.5, 0.0, 1.0) - std::f64::consts::FRAC_2_PI).abs() < 1e-14
            && (seen(0.5, 0.0, 0.5) - 0.900_32).abs() < 5e-6
    );
}

#[test]
fn the_same_in_the_plane() {
    let (grid, nu) = (Grid::pixels(10, 1).unwrap(), 0.9);
    let grating = Grating::new([nu, 0.0]).unwrap();
    let sensor = Image::averaged(&grating, grid);
    let pinhole = Image::of(&grating, grid);
    for (seen, read) in sensor.values().iter().zip(pinhole.values()) {
        assert!((seen - sinc(nu) * read).abs() < 1e-14);
    }
}
