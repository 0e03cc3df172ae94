//! Filters in frequency, convolution, decimation and resizing: against direct sums, closed forms and the one-dimensional
//! reconstruction.

use nyquist::image::convolution::{convolve, convolve_separable};
use nyquist::image::decimate::decimate;
use nyquist::image::radial::radial_power;
use nyquist::image::resize::{resample, resize};
use nyquist::kernel::catalog;
use nyquist::prelude::*;

fn noise(nx: usize, ny: usize) -> Image {
    let values = (0..(nx * ny) as u64).map(|i| nyquist::num::random::normal(11, i, 0)).collect();
    Image::new(Grid::pixels(nx, ny).expect("small"), values).expect("normal numbers are finite")
}

fn worst(a: &Image, b: &Image) -> f64 {
    assert_eq!((a.width(), a.height()), (b.width(), b.height()));
    a.values().iter().zip(b.values()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn finite_kernels() -> impl Iterator<Item = Box<dyn Kernel>> {
    catalog::all().into_iter().filter(|kernel| kernel.radius().is_finite())
}

#[test]
fn a_constant_stays_the_constant_to_the_last_bit_for_every_kernel_size_and_edge() {
    // no power of two among them: products with weights would be rounded
    for (value, (nx, ny)) in [(0.7, (7, 5)), (1.0 / 3.0, (97, 61)), (srgb_to_linear(0.2), (1, 40))] {
        let grey = Image::new(Grid::pixels(nx, ny).unwrap(), vec![value; nx * ny]).unwrap();
        for kernel in finite_kernels() {
            for (w, h) in [(7, 5), (3, 2), (1, 1), (14, 11), (5, 230)] {
                for edge in [Edge::Clamp, Edge::Wrap, Edge::Mirror] {
                    let resized = resize(&grey, w, h, &kernel, edge).unwrap();
                    assert!(resized.values().iter().all(|v| *v == value), "{} {w}×{h} {edge:?}", kernel.name());
                }
            }
        }
    }
}

#[test]
fn the_same_size_returns_the_image_where_the_kernel_interpolates() {
    let image = noise(9, 6);
    for kernel in finite_kernels() {
        let same = resize(&image, 9, 6, &kernel, Edge::Mirror).unwrap();
        assert_eq!(worst(&same, &image) < 1e-15, kernel.claims().interpolating, "{}", kernel.name());
    }
}

#[test]
fn enlarging_is_the_reconstruction_along_either_axis() {
    // kernels whose weights need no division are exactly the one-dimensional reconstruction, twice
    let image = noise(8, 1);
    let samples = Samples::new(image.grid().x(), image.values().to_vec()).unwrap();
    for kernel in finite_kernels().filter(|kernel| kernel.claims().reproduces_constants) {
        for edge in [Edge::Clamp, Edge::Wrap, Edge::Mirror] {
            let finer = resize(&image, 27, 1, &kernel, edge).unwrap();
            let line = reconstruct(&samples, &kernel).edge(edge).onto(finer.grid().x());
            for (a, b) in finer.values().iter().zip(line.values()) {
                assert!((a - b).abs() < 1e-13, "{} {edge:?}", kernel.name());
            }
        }
    }
}

#[test]
fn rows_and_columns_may_be_resized_in_either_order() {
    let image = noise(13, 10);
    // of interpolating kernels, which leave alone the axis that keeps its size
    for kernel in finite_kernels().filter(|kernel| kernel.claims().interpolating) {
        let both = resize(&image, 5, 17, &kernel, Edge::Clamp).unwrap();
        let across = resize(&image, 5, 10, &kernel, Edge::Clamp).unwrap();
        let down = resize(&image, 13, 17, &kernel, Edge::Clamp).unwrap();
        assert!(worst(&resize(&across, 5, 17, &kernel, Edge::Clamp).unwrap(), &both) < 1e-13);
        assert!(worst(&resize(&down, 5, 17, &kernel, Edge::Clamp).unwrap(), &both) < 1e-13);
    }
}

#[test]
fn shrinking_by_a_whole_factor_with_the_box_is_the_mean_of_the_block() {
    let image = noise(12, 9);
    let small = resize(&image, 4, 3, &BoxKernel, Edge::Clamp).unwrap();
    for j in 0..3 {
        for i in 0..4 {
            let block = (0..9).map(|k| image.at(3 * i + k % 3, 3 * j + k / 3));
            assert!((small.at(i, j) - block.sum::<f64>() / 9.0).abs() < 1e-15);
        }
    }
    // a grating above the new Nyquist frequency is damped by the widened kernel, and not by a narrow one
    let fine = Image::of(&Grating::new([0.45, 0.0]).unwrap(), Grid::pixels(400, 1).unwrap());
    let inner = |image: &Image| (10..90).map(|i| image.at(i, 0).powi(2)).sum::<f64>().sqrt();
    let filtered = resize(&fine, 100, 1, &Lanczos::new(3.0).unwrap(), Edge::Mirror).unwrap();
    let dropped = decimate(&fine, [4, 1]).unwrap();
    assert!(inner(&filtered) < 0.02 * inner(&dropped));
}

#[test]
fn outside_the_image_the_edge_decides() {
    let image = Image::new(Grid::pixels(2, 1).unwrap(), vec![1.0, 3.0]).unwrap();
    let beside = Grid::cells(-1.0..0.0, 1, 0.0..1.0, 1).unwrap();
    let at = |edge| resample(&image, beside, &TentKernel, edge).unwrap().at(0, 0);
    assert_eq!(Edge::ALL.map(at), [0.0, 1.0, 3.0, 1.0]);
    // half of the weight stands on nothing
    let half = Grid::cells(-0.5..0.5, 1, 0.0..1.0, 1).unwrap();
    assert_eq!(resample(&image, half, &TentKernel, Edge::Zero).unwrap().at(0, 0), 0.5);
}

#[test]
fn bad_sizes_and_kernels_are_refused_by_name() {
    let image = noise(4, 4);
    assert!(matches!(resize(&image, 0, 4, &TentKernel, Edge::Clamp), Err(Error::TooFew { .. })));
    assert!(matches!(resize(&image, 1 << 20, 1 << 20, &TentKernel, Edge::Clamp), Err(Error::Overflow { .. })));
    assert!(matches!(resize(&image, 3, 3, &Ideal, Edge::Clamp), Err(Error::Unsupported(_))));
    let huge = Grid::cells(0.0..1e300, 2, 0.0..1.0, 1).unwrap();
    assert!(matches!(resample(&image, huge, &TentKernel, Edge::Wrap), Err(Error::Overflow { .. })));
    assert!(matches!(decimate(&image, [0, 1]), Err(Error::TooFew { .. })));
    assert!(matches!(Filter::low_pass(-1.0, Shape::Ideal), Err(Error::NotPositive { .. })));
    assert!(matches!(Filter::band_pass(0.3, 0.2, Shape::Ideal), Err(Error::NotPositive { .. })));
    assert!(matches!(Filter::low_pass(0.1, Shape::Butterworth(0)), Err(Error::TooFew { .. })));
    assert!(convolve_separable(&image, &[], &[1.0], Edge::Zero).is_err());
    assert!(convolve_separable(&image, &[f64::NAN], &[1.0], Edge::Zero).is_err());
    let other = Image::of(&Flat::new(1.0).unwrap(), Grid::centered(0.5, 3, 3).unwrap());
    assert!(matches!(convolve(&image, &other), Err(Error::Unsupported(_))));
    // a factor beyond the size leaves the first pixel
    assert_eq!(decimate(&image, [9, 1 << 60]).unwrap().values(), [image.at(0, 0)]);
}

#[test]
fn convolution_by_fft_is_the_double_sum() {
    let (f, g) = (noise(7, 5), noise(4, 6));
    let h = convolve(&f, &g).unwrap();
    assert_eq!((h.width(), h.height()), (10, 10));
    assert_eq!(h.grid().at(0, 0), [1.0, 1.0]); // ½ + ½
    for y in 0..10i64 {
        for x in 0..10i64 {
            let value = |image: &Image, x: i64, y: i64| {
                let inside = (0..image.width() as i64).contains(&x) && (0..image.height() as i64).contains(&y);
                if inside { image.at(x as usize, y as usize) } else { 0.0 }
            };
            let sum: f64 = (0..35).map(|k| value(&f, k % 7, k / 7) * value(&g, x - k % 7, y - k / 7)).sum();
            assert!((h.at(x as usize, y as usize) - sum).abs() < 1e-13);
        }
    }
}

#[test]
fn a_separable_convolution_is_the_convolution_with_the_product() {
    let image = noise(9, 8);
    let (across, down) = ([0.1, 0.5, -0.2, 0.7, 0.3], [0.25, 0.5, 0.25]);
    let taps = (0..15).map(|k| across[k % 5] * down[k / 5]).collect();
    let kernel = Image::new(Grid::centered(1.0, 5, 3).unwrap(), taps).unwrap();
    let (direct, by_fft) =
        (convolve_separable(&image, &across, &down, Edge::Zero).unwrap(), convolve(&image, &kernel).unwrap());
    for j in 0..8 {
        for i in 0..9 {
            assert!((direct.at(i, j) - by_fft.at(i + 2, j + 1)).abs() < 1e-14);
        }
    }
    // taps that add up to one leave a constant alone, but at an edge with nothing beyond
    let grey = image.map(|_| 2.0);
    for edge in [Edge::Clamp, Edge::Wrap, Edge::Mirror] {
        assert_eq!(convolve_separable(&grey, &down, &down, edge).unwrap(), grey);
    }
    assert_eq!(convolve_separable(&grey, &down, &down, Edge::Zero).unwrap().at(0, 0), 2.0 * 0.75 * 0.75);
}

#[test]
fn an_ideal_low_pass_keeps_what_is_below_and_nothing_above() {
    let grid = Grid::centered(1.0, 64, 48).unwrap();
    let wave = |u: f64, v: f64| Image::of(&Grating::new([u / 64.0, v / 48.0]).unwrap(), grid);
    let low = Filter::low_pass(0.2, Shape::Ideal).unwrap();
    for (u, v, gain) in [(8.0, 5.0, 1.0), (-3.0, 9.0, 1.0), (13.0, 0.0, 0.0), (11.0, 7.0, 0.0), (32.0, 24.0, 0.0)] {
        let image = wave(u, v);
        let rho = f64::hypot(u / 64.0, v / 48.0);
        assert_eq!(low.response(u / 64.0, v / 48.0), gain, "{rho}");
        assert!(worst(&low.apply(&image), &image.map(|value| gain * value)) < 1e-13);
    }
    for shape in [Shape::Ideal, Shape::Gaussian, Shape::Butterworth(1), Shape::Butterworth(4)] {
        let [low, band, high] = [
            Filter::low_pass(0.1, shape).unwrap(),
            Filter::band_pass(0.1, 0.3, shape).unwrap(),
            Filter::high_pass(0.3, shape).unwrap(),
        ];
        assert_eq!(low.response(0.0, 0.1), 0.5);
        assert_eq!((low.response(0.0, 0.0), high.response(0.0, 0.0)), (1.0, 0.0));
        let image = noise(20, 15);
        let sum = low.apply(&image).with(&band.apply(&image), |a, b| a + b).unwrap();
        assert!(worst(&sum.with(&high.apply(&image), |a, b| a + b).unwrap(), &image) < 1e-13);
    }
}

#[test]
fn rings_of_a_gaussian_spectrum_have_its_power() {
    let spot = GaussianSpot::round(3.0).unwrap();
    let grid = Grid::centered(1.0, 96, 96).unwrap();
    for ring in radial_power(&image_forward(&Image::of(&spot, grid)), 24).unwrap() {
        let power = spot.spectrum().density(ring.frequency, 0.0).norm_sqr() / grid.area();
        // over a ring 1/48 wide the power e^{−2π²9ρ²} bends by at most (Δρ)²/24·|P″|, P″ ≤ 4π²·9·P(0)
        let bend = (1.0f64 / 48.0).powi(2) / 24.0 * 4.0 * std::f64::consts::PI.powi(2) * 9.0;
        let top = spot.spectrum().density(0.0, 0.0).norm_sqr() / grid.area();
        assert!((ring.power - power).abs() <= 2.0 * bend * top, "{ring:?} {power}");
    }
}
