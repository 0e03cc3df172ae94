//! Gratings are found in a picture, their moiré is predicted, the picture is shrunk, and the moiré is found in it.

#[cfg(feature = "files")]
use crate::making::fit;
use crate::making::{Stripes, fitted, image};
use nyquist::axis::Edge;
#[cfg(feature = "files")]
use nyquist::inspect::picture::found::found;
use nyquist::inspect::picture::found::shrunk;
use nyquist::inspect::picture::sampler::Moire;
use nyquist::inspect::picture::shrinking::{Shrinking, Tolerance};
use nyquist::inspect::picture::wave::Wave;
use nyquist::inspect::picture::waves::waves;
use nyquist::prelude::*;

/// The part of a shrunk picture where a wave of the old one is, without what the border may have changed.
fn inner(small: &Image, whole: &Image, wave: &Wave, reach: usize) -> ([usize; 2], [usize; 2]) {
    let factor = [small.width() as f64 / whole.width() as f64, small.height() as f64 / whole.height() as f64];
    let corner = [0, 1].map(|i| (wave.corner[i] as f64 * factor[i]).ceil() as usize + reach);
    let end = [0, 1].map(|i| ((wave.corner[i] + wave.size[i]) as f64 * factor[i]).floor() as usize - reach);
    (corner, [end[0] - corner[0], end[1] - corner[1]])
}

/// Every way to a size must leave the amplitude that was predicted at the place that was predicted.
fn all_ways_do_as_predicted(image: &Image, size: [usize; 2], bound: impl Fn(&Moire, &Image) -> f64) {
    let predicted = Shrinking::of(image, size, Tolerance::default(), None).expect("a small picture");
    assert!(!predicted.waves.strongest.is_empty());
    for way in &predicted.ways {
        let small = shrunk(image, size, &way.name, Edge::Mirror).expect("a finite kernel");
        for (wave, moire) in predicted.waves.strongest.iter().zip(&way.moires) {
            // five steps of the widest kernel, the regularised sinc, are 8: they stay off the border
            let (corner, part) = inner(&small, image, wave, 9);
            let amplitude = fitted(&small, moire.frequency, corner, part);
            let off = (amplitude - moire.contrast * wave.mean).abs();
            // a fit over n pixels sees another wave by its Dirichlet kernel, 1/(n·|sin πΔν|) at most along either axis
            let others = predicted.waves.strongest.iter().zip(&way.moires).filter(|(other, _)| *other != wave);
            let leaks = others.map(|(other, at)| {
                let sees = |sign: f64| -> f64 {
                    let along = |i: usize| {
                        let sine = (std::f64::consts::PI * (moire.frequency[i] - sign * at.frequency[i])).sin().abs();
                        (1.0 / (part[i] as f64 * sine)).min(1.0)
                    };
                    along(0) * along(1)
                };
                at.contrast * other.mean * (sees(1.0) + sees(-1.0))
            });
            let bound = bound(moire, &small) + leaks.sum::<f64>();
            assert!(
                off <= bound,
                "{} to {size:?}: {wave:?} {moire:?}: found {amplitude}, off {off:e} > {bound:e}",
                way.name
            );
        }
    }
}

#[test]
fn of_pure_gratings_at_whole_and_broken_factors_for_every_filter() {
    for (frequency, size) in [
        ([0.35, 0.12], [128, 128]),
        ([-0.31, 0.22], [192, 171]),
        ([0.41, -0.43], [128, 256]),
        ([0.27, 0.01], [171, 128]),
    ] {
        let stripes = Stripes { frequency, contrast: 0.4, mean: 0.3 };
        let image = image(512, 512, |x, y| stripes.at(x, y));
        // the frequency is known to 10⁻⁶ bins of 1/512: over 512 pixels its phase strays by 2π·10⁻⁶. At broken factors a way
        // that does not filter leaves images of its own besides, which a fit over n pixels sees by 2/(πn·Δν) each
        all_ways_do_as_predicted(&image, size, |moire, small| {
            let amplitude = 0.4 * 0.3;
            let whole = 512 % size[0] == 0 && 512 % size[1] == 0;
            let images = if whole { 0.0 } else { 0.05 };
            amplitude * (1e-4 + images) + 1e-9 * moire.contrast * small.mean()
        });
    }
}

#[test]
fn the_place_the_period_and_the_angle_are_those_of_folding_by_hand() {
    let stripes = Stripes { frequency: [0.35, 0.12], contrast: 0.4, mean: 0.5 };
    let image = image(512, 512, |x, y| stripes.at(x, y));
    let predicted = Shrinking::of(&image, [128, 128], Tolerance::default(), None).unwrap();
    let [wave] = &predicted.waves.strongest[..] else { panic!("one grating") };
    // pointing upwards: v downwards is negative
    assert!((wave.frequency[0] + 0.35).abs() < 1e-7 && (wave.frequency[1] + 0.12).abs() < 1e-7);
    assert!((wave.contrast() - 0.4).abs() < 1e-6 && (wave.mean - 0.5).abs() < 1e-6);
    assert_eq!(wave.size, [512, 512]); // it was followed to the whole picture
    // 4·(−0.35, −0.12) = (−1.4, −0.48) folds to (−0.4, −0.48)
    let moire = predicted.ways[0].moires[0];
    assert!((moire.frequency[0] + 0.4).abs() < 1e-6 && (moire.frequency[1] + 0.48).abs() < 1e-6);
    assert!((moire.period() - 1.0 / 0.4f64.hypot(0.48)).abs() < 1e-5);
    assert!((moire.angle() - (180.0 - 1.2f64.atan().to_degrees())).abs() < 1e-4);
    assert!((moire.contrast - 0.4).abs() < 1e-6);
}

#[test]
fn of_two_gratings_and_a_product_each_is_found() {
    // a product of two gratings is their sum and their difference: (0.31, 0.24) and (0.07, −0.28)
    let [a, b] = [[0.19, -0.02], [0.12, 0.26]].map(|frequency| Stripes { frequency, contrast: 0.8, mean: 1.0 });
    let product = image(512, 384, |x, y| 0.3 * a.at(x, y) * b.at(x, y));
    let found = waves(&product, [0.125, 0.125], 0.01);
    let mut places: Vec<[f64; 2]> = found.strongest.iter().map(|wave| wave.frequency).collect();
    places.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let expected = [[-0.31, -0.24], [-0.12, -0.26], [0.07, -0.28], [0.19, -0.02]];
    assert_eq!(places.len(), expected.len(), "{places:?}");
    for (place, expected) in places.iter().zip(expected) {
        assert!((0..2).all(|i| (place[i] - expected[i]).abs() < 1e-5), "{place:?} {expected:?}");
    }
    let contrast = |u: f64| found.strongest.iter().find(|w| (w.frequency[0] - u).abs() < 1e-3).unwrap().contrast();
    assert!((contrast(0.19) - 0.8).abs() < 1e-4 && (contrast(-0.31) - 0.32).abs() < 1e-4);
    all_ways_do_as_predicted(&product, [128, 96], |_, _| 1e-4);
}

#[test]
fn stripes_in_a_corner_of_an_even_picture_are_found_there() {
    let stripes = Stripes { frequency: [0.27, -0.21], contrast: 1.0, mean: 1.0 };
    let bell = |x: f64, y: f64| (-((x - 380.0).powi(2) + (y - 120.0).powi(2)) / (2.0 * 50f64.powi(2))).exp();
    let image = image(512, 512, |x, y| 0.4 * (1.0 + 0.5 * bell(x, y) * (stripes.at(x, y) - 1.0)));
    let found = waves(&image, [0.25, 0.25], 0.01);
    let wave = &found.strongest[0];
    let [x, y] = wave.middle();
    assert!((x - 380.0).abs() <= 32.0 && (y - 120.0).abs() <= 32.0, "{wave:?}");
    assert!(wave.contrast() > 0.35 && wave.contrast() <= 0.5, "{wave:?}");
    assert!(wave.size[0] <= 128, "it was not followed beyond where it ends: {wave:?}");
}

#[test]
fn an_even_picture_a_ramp_an_edge_and_noise_have_no_gratings() {
    let edge = |x: f64, y: f64| if x + 0.3 * y < 150.0 { 0.1 } else { 0.9 };
    assert!(waves(&image(256, 256, |_, _| 0.5), [0.25, 0.25], 0.001).strongest.is_empty());
    assert!(waves(&image(256, 256, |x, y| 0.002 * (x + y)), [0.25, 0.25], 0.01).strongest.is_empty());
    assert!(waves(&image(256, 256, edge), [0.25, 0.25], 0.01).strongest.is_empty());
    let noise = |i: u64| 0.5 + 0.1 * nyquist::num::random::normal(3, i, 0);
    let noise = Image::new(Grid::pixels(256, 256).unwrap(), (0..1 << 16).map(noise).collect()).unwrap();
    // 49 patches with 1500 bins each: e⁻²⁰ of them have 20 times their mean power, 0.0002 in all; and of small patches seven
    // of nine neighbours would have to
    assert!(waves(&noise, [0.25, 0.25], 0.001).strongest.is_empty());
}

#[test]
fn the_rings_of_a_zone_plate_are_gratings_that_bend() {
    // local frequency r/M: beyond ⅛ from r = 64 on, and nowhere beyond ½
    let plate = ZonePlate::new(512.0).unwrap();
    let rings = Image::of(&plate, Grid::centered(1.0, 360, 360).unwrap()).map(|v| 0.25 + 0.5 * v);
    let found = waves(&rings, [0.125, 0.125], 0.05);
    assert!(found.strongest.len() == 8 && found.others > 8, "{found:?}");
    for wave in &found.strongest {
        let [x, y] = wave.middle().map(|at| (at - 180.0) / 512.0);
        // across a patch of 32 pixels the frequency changes by a bin and a half to either side
        let bin = 1.0 / wave.size[0] as f64;
        let [u, v] = wave.frequency;
        let off = (u.abs() - x.abs()).abs().max((v.abs() - y.abs()).abs());
        assert!(off <= 1.5 * bin && u * x * v * y >= -bin * bin, "{wave:?}");
        // the contrast is ½; what bends loses some of it under the window
        assert!((0.3..=0.55).contains(&wave.contrast()), "{wave:?}");
    }
}

#[test]
fn the_checkerboard_of_single_pixels_becomes_a_grey_that_depends_on_where_it_is_sampled() {
    let checks = image(128, 128, |x, y| if (x.floor() + y.floor()) % 2.0 == 0.0 { 1.0 } else { 0.0 });
    let predicted = Shrinking::of(&checks, [64, 64], Tolerance::default(), None).unwrap();
    let [wave] = &predicted.waves.strongest[..] else { panic!("one grating: {:?}", predicted.waves) };
    assert!(wave.frequency.iter().all(|nu| (nu.abs() - 0.5).abs() < 1e-6), "{wave:?}");
    assert!((wave.contrast() - 1.0).abs() < 1e-6, "{wave:?}");
    let moire = predicted.ways[0].moires[0];
    assert!(moire.even && predicted.ways[0].worst().is_none() && predicted.ways[0].contrast() == 0.0);
    assert!((predicted.ways[0].brightness() - 1.0).abs() < 1e-6 && !predicted.ways[0].fine);
    assert!(moire.period() > 1e5 && (moire.contrast - 1.0).abs() < 1e-6);
    // as it is: black or white all over
    let small = shrunk(&checks, [64, 64], "none", Edge::Mirror).unwrap();
    assert!(small.values().iter().all(|v| *v == small.at(0, 0)));
    // and with the box grey, as predicted
    assert!(predicted.way("box").unwrap().brightness() < 1e-12);
}

#[cfg(feature = "files")]
#[test]
fn a_photograph_has_what_was_predicted_and_what_else_lands_there() {
    use std::f64::consts::PI;
    let photograph = crate::making::photograph();
    let mut looked = 0;
    // whole ratios: at others images of the grating land beside it
    for size in [[256, 256], [128, 128], [256, 128], [128, 256]] {
        let predicted = Shrinking::of(&photograph, size, Tolerance::new(50.0).unwrap(), None).unwrap();
        for name in ["none", "box", "tent"] {
            let way = predicted.way(name).unwrap();
            for (wave, moire) in predicted.waves.strongest.iter().zip(&way.moires) {
                let look = |image: &Image| found(image, wave, moire, size, name).unwrap();
                let Some(seen) = look(&photograph) else { continue };
                // the photograph is the grating, as it is under a Hann window, and the rest
                let hann = |t: f64| (PI * t).sin().powi(2);
                let [a, b] = fit(&photograph, wave.frequency, wave.corner, wave.size, hann);
                // eight bins from zero and farther, as what is beyond ⅛ of a patch of 64 is, the mean leaks by 1/(8π·63) at
                // most, and the fit shares the square of that
                assert!((a.hypot(b) / wave.amplitude - 1.0).abs() < 1e-6, "{wave:?}");
                let [u, v] = wave.frequency;
                let grating = image(512, 512, |x, y| {
                    let (sin, cos) = (2.0 * PI * (u * x + v * y).rem_euclid(1.0)).sin_cos();
                    a * cos + b * sin
                });
                let rest = look(&photograph.with(&grating, |f, g| f - g).unwrap()).expect("of the same size");
                // what belongs to the new size is cut out first, and that takes of a grating beyond it the tails of a sinc,
                // from 32 pixels outside of the part on: 1/(32π·sin π(|ν| − limit)) on either side at most, and as much
                // again for what a transform puts there; along an axis where the grating is not beyond, all, and 18 % (Gibbs)
                let tail = |i: usize| {
                    let beyond = wave.frequency[i].abs() - predicted.limit[i];
                    if beyond > 0.0 { (4.0 / (32.0 * PI * (PI * beyond).sin())).min(1.18) } else { 1.18 }
                };
                let cut = tail(0) * tail(1) * wave.contrast();
                let said = format!("{name} {size:?} {wave:?} {moire:?}: {seen:?}, {rest:?}, {cut}");
                assert!((seen.alone - moire.contrast).abs() <= cut, "{said}");
                // all of this is linear, and two sides of a triangle are as long as the third
                assert!((seen.contrast - moire.contrast).abs() <= rest.contrast + cut, "{said}");
                looked += 1;
            }
        }
    }
    assert!(looked >= 12, "{looked}");
}
