//! The energy that stays and the energy that folds, blurs that are enough, and what is advised.

use crate::making::{Stripes, image};
use nyquist::axis::Edge;
use nyquist::image::periodic::split;
use nyquist::image::resize::over;
use nyquist::inspect::picture::blur::Blur;
use nyquist::inspect::picture::found::shrunk;
use nyquist::inspect::picture::power::{Border, PowerSpectrum};
use nyquist::inspect::picture::sampler::Sampler;
use nyquist::inspect::picture::shrinking::{Shrinking, Tolerance};
use nyquist::inspect::picture::texture::{WIDTH, textures};
use nyquist::prelude::*;

/// Pseudo-random pixels in bands: noise through a filter.
fn texture(n: usize, filter: &Filter) -> Image {
    let noise = |i: u64| nyquist::num::random::normal(21, i, 0);
    let grid = Grid::pixels(n, n).expect("small");
    let white = Image::new(grid, (0..(n * n) as u64).map(noise).collect()).expect("normal numbers are finite");
    filter.apply(&white)
}

/// The part of a periodic picture whose frequencies `wanted` wants.
fn part_of(image: &Image, wanted: impl Fn(f64, f64) -> bool) -> Image {
    image_inverse(&image_forward(image).times(|u, v| if wanted(u, v) { 1.0.into() } else { 0.0.into() }))
}

fn variance(image: &Image) -> f64 {
    let mean = image.mean();
    image.values().iter().map(|v| (v - mean).powi(2)).sum::<f64>() / image.values().len() as f64
}

#[test]
fn what_lies_beyond_the_box_is_found_in_the_shrunk_picture_as_so_much_energy() {
    let noise = texture(256, &Filter::high_pass(0.02, Shape::Gaussian).unwrap());
    let spectrum = PowerSpectrum::of(&noise, Border::Window(Window::Rectangular));
    for (size, factor) in [([128, 128], 2), ([64, 64], 4)] {
        let grid = over(noise.grid(), size[0], size[1]).unwrap();
        let limit = 0.5 / f64::from(factor);
        let beyond = part_of(&noise, |u, v| u.abs() > limit || v.abs() > limit);
        let within = part_of(&noise, |u, v| u.abs() <= limit && v.abs() <= limit);
        for name in ["none", "box", "tent", "mitchell", "lanczos-3", "b-spline"] {
            let sampler = match name {
                "none" => Sampler::none(noise.grid(), grid),
                name => Sampler::kernel(noise.grid(), grid, &nyquist::kernel::catalog::by_name(name).unwrap()).unwrap(),
            };
            let passed = sampler.passed(&spectrum);
            let [folded, kept] =
                [&beyond, &within].map(|part| variance(&shrunk(part, size, name, Edge::Wrap).unwrap()));
            // several frequencies land on one place with random phases: of k places the energy strays by √(2/k), five times
            let strays = 5.0 * (2.0 / (size[0] * size[1]) as f64).sqrt();
            assert!((folded / passed.folded - 1.0).abs() < strays, "{name} {size:?}: {folded} {passed:?}");
            assert!((kept / passed.kept - 1.0).abs() < strays, "{name} {size:?}: {kept} {passed:?}");
        }
    }
}

#[test]
fn images_of_what_is_inside_count_as_folded_where_the_factor_is_broken() {
    // a soft picture, all inside; nearest pixels at a broken factor are a box read at all phases
    let soft = texture(240, &Filter::low_pass(0.08, Shape::Butterworth(6)).unwrap());
    let spectrum = PowerSpectrum::of(&soft, Border::Window(Window::Rectangular));
    let size = [89, 89];
    let grid = over(soft.grid(), 89, 89).unwrap();
    let passed = Sampler::none(soft.grid(), grid).passed(&spectrum);
    let small = shrunk(&soft, size, "none", Edge::Wrap).unwrap();
    // what stays is the picture itself between its pixels, through the box: sinc(u)·sinc(v) of it
    let bins = image_forward(&soft);
    let truth = bins.times(|u, v| (nyquist::num::sinc(u) * nyquist::num::sinc(v)).into());
    let at = |x: f64, y: f64| -> f64 {
        let mut sum = 0.0;
        for l in -40i64..=40 {
            for k in -40i64..=40 {
                let (u, v) = (k as f64 / 240.0, l as f64 / 240.0);
                let wave = num_complex::Complex::cis(std::f64::consts::TAU * (u * x + v * y));
                sum += (truth.bin(k, l) * wave).re;
            }
        }
        sum / (240.0 * 240.0)
    };
    let places: Vec<(usize, usize)> = (0..400).map(|i| (i * 7 % 89, i * 31 % 89)).collect();
    let strays = places.iter().map(|&(i, j)| {
        let [x, y] = grid.at(i as i64, j as i64);
        (small.at(i, j) - at(x, y)).powi(2)
    });
    let strays = strays.sum::<f64>() / places.len() as f64;
    // 400 places: √(2/400), five times
    assert!((strays / passed.folded - 1.0).abs() < 5.0 * (2.0f64 / 400.0).sqrt(), "{strays} {passed:?}");
}

#[test]
fn a_region_of_texture_has_the_contrast_of_what_a_filter_cuts_out_there() {
    let noise = texture(256, &Filter::band_pass(0.3, 0.4, Shape::Ideal).unwrap()).map(|v| 2.0 + 0.2 * v);
    let spectrum = PowerSpectrum::of(&noise, Border::Periodic);
    let periodic = split(&noise)[0].clone();
    for texture in textures(&spectrum, [0.25, 0.25], &[], 4) {
        let cell = texture.frequency.map(|nu| (nu / WIDTH).floor() * WIDTH);
        let inside = |nu: f64, low: f64| nu >= low && nu < low + WIDTH;
        let cut = part_of(&periodic, |u, v| {
            let beyond = u.abs() > 0.25 || v.abs() > 0.25;
            beyond && (inside(u, cell[0]) && inside(v, cell[1]) || inside(-u, cell[0]) && inside(-v, cell[1]))
        });
        let contrast = variance(&cut).sqrt() / noise.mean();
        assert!((texture.contrast - contrast).abs() < 1e-2 * contrast, "{texture:?} {contrast}");
    }
}

#[test]
fn the_blur_that_is_advised_is_enough_and_hardly_more() {
    let stripes = Stripes { frequency: [0.4, 0.17], contrast: 0.5, mean: 0.4 };
    let picture = image(256, 256, |x, y| stripes.at(x, y) + 0.1 * (0.05 * x).sin());
    let tolerance = Tolerance::default();
    let shrinking = Shrinking::of(&picture, [128, 128], tolerance, None).unwrap();
    assert!(!shrinking.ways[0].fine);
    let sigma = shrinking.blur.expect("a blur is enough");
    let contrast = |sigma: f64| {
        let blurred = Blur::new(sigma).unwrap().apply(&picture, Edge::Mirror).unwrap();
        let small = shrunk(&blurred, [128, 128], "none", Edge::Mirror).unwrap();
        let moire = shrinking.ways[0].moires[0];
        crate::making::fitted(&small, moire.frequency, [16, 16], [96, 96]) / small.mean()
    };
    // the slow sine is the other part of the picture: it adds less than a thousandth at that frequency
    assert!(contrast(sigma) <= tolerance.contrast() + 1e-3, "{sigma}: {}", contrast(sigma));
    assert!(contrast(0.9 * sigma) > tolerance.contrast(), "{sigma}: {}", contrast(0.9 * sigma));
}

#[test]
fn the_best_filter_is_fine_and_keeps_most_of_those_that_are() {
    let stripes = Stripes { frequency: [0.35, 0.0], contrast: 0.3, mean: 0.4 };
    let detail = texture(256, &Filter::low_pass(0.1, Shape::Gaussian).unwrap());
    let picture = image(256, 256, |x, y| stripes.at(x, y)).with(&detail, |a, b| a + 0.05 * b).unwrap();
    let shrinking = Shrinking::of(&picture, [128, 128], Tolerance::default(), None).unwrap();
    let best = shrinking.best().expect("some filter is fine");
    assert!(best.fine && best.name != "none");
    assert!(shrinking.ways.iter().filter(|way| way.fine).all(|way| way.passed.kept <= best.passed.kept));
    // nothing needs to be done for what is soft
    let soft = image(256, 256, |x, y| 0.5 + 0.2 * (0.1 * x).sin() * (0.07 * y).cos());
    let shrinking = Shrinking::of(&soft, [128, 128], Tolerance::default(), None).unwrap();
    assert_eq!((shrinking.best().map(|way| way.name.as_str()), shrinking.blur), (Some("none"), None));
    // a filter of one's own is judged as well
    let own = nyquist::kernel::catalog::by_name("kaiser:6,6").unwrap();
    let shrinking = Shrinking::of(&picture, [128, 128], Tolerance::default(), Some(&*own)).unwrap();
    assert!(shrinking.way("kaiser:6,6").is_some());
}

#[test]
fn nonsense_is_refused() {
    let picture = image(16, 16, |x, _| x);
    assert!(Shrinking::of(&picture, [0, 4], Tolerance::default(), None).is_err());
    assert!(Shrinking::of(&picture, [4, 4], Tolerance::default(), Some(&Ideal)).is_err());
    assert!(Tolerance::new(f64::NAN).is_err() && Tolerance::new(-1.0).is_err());
    assert!(Blur::new(0.0).is_err() && Blur::new(f64::INFINITY).is_err());
    for size in [[1, 1], [16, 16], [40, 3]] {
        assert!(Shrinking::of(&picture, size, Tolerance::default(), None).is_ok(), "{size:?}");
    }
}
