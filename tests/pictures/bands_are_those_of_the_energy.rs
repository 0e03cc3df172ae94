//! Bands, floors, cliffs, and the border that leaves no cross.

use crate::making::image;
use nyquist::image::periodic::{periodic_forward, split};
use nyquist::image::resize::resize;
use nyquist::inspect::picture::band::{Band, Fall};
use nyquist::inspect::picture::power::{Border, PowerSpectrum};
use nyquist::prelude::*;

fn wave(u: f64, v: f64, x: f64, y: f64) -> f64 {
    (std::f64::consts::TAU * (u * x + v * y)).cos()
}

#[test]
fn the_band_that_holds_a_part_of_the_energy_is_where_the_gratings_are() {
    // energies 1, 0.09 and 0.01, at whole numbers of periods
    let (n, m) = (128.0, 96.0);
    let at = [[8.0 / n, 3.0 / m], [-20.0 / n, 30.0 / m], [50.0 / n, 10.0 / m]];
    let picture = image(128, 96, |x, y| {
        wave(at[0][0], at[0][1], x, y) + 0.3 * wave(at[1][0], at[1][1], x, y) + 0.1 * wave(at[2][0], at[2][1], x, y)
    });
    // the smooth component of the border takes a few percent of waves that run across it
    for border in [Border::Periodic, Border::Window(Window::Rectangular)] {
        let spectrum = PowerSpectrum::of(&picture, border);
        let band = |part| Band::of(&spectrum, part).unwrap();
        let close = |a: f64, b: f64| (a - b).abs() < 1e-12;
        assert!(close(band(0.9).across, 8.0 / n) && close(band(0.9).down, 3.0 / m));
        assert!(close(band(0.98).across, 20.0 / n) && close(band(0.98).down, 30.0 / m));
        assert!(close(band(0.98).radial, (20.0 / n).hypot(30.0 / m)) && close(band(0.98).square, 30.0 / m));
        assert!(close(band(0.995).across, 50.0 / n));
        assert!((spectrum.energy() / (0.5 * 1.1) - 1.0).abs() < if border == Border::Periodic { 0.1 } else { 1e-12 });
    }
    let spectrum = PowerSpectrum::of(&picture, Border::Periodic);
    assert!(Band::of(&spectrum, 1.0).is_err() && Band::of(&spectrum, f64::NAN).is_err());
}

#[test]
fn the_border_of_a_picture_makes_no_cross() {
    // a gradient and one grating: without care the cross hides all but the grating
    let picture = image(200, 160, |x, y| 0.004 * x - 0.002 * y + 0.01 * wave(0.3, 0.2, x, y));
    let away = |border| {
        let spectrum = match border {
            Border::Window(Window::Hann) => PowerSpectrum::welch(&picture),
            border => PowerSpectrum::of(&picture, border),
        };
        let on_axes =
            spectrum.energies().filter(|([u, v], _)| (u.abs() > 0.1) != (v.abs() > 0.1) && (*u == 0.0 || *v == 0.0));
        on_axes.map(|(_, e)| e).sum::<f64>()
    };
    assert!(away(Border::Periodic) < 1e-3 * away(Border::Window(Window::Rectangular)));
    assert!(away(Border::Window(Window::Hann)) < 1e-3 * away(Border::Window(Window::Rectangular)));
}

#[test]
fn the_smooth_component_has_the_jumps_of_the_border_and_no_curvature_inside() {
    let picture = image(24, 17, |x, y| (0.3 * x).sin() * (0.2 * y * y).cos() + 0.1 * x);
    let [_, smooth] = split(&picture);
    let (w, h) = (24i64, 17i64);
    let at = |image: &Image, x: i64, y: i64| image.at(x.rem_euclid(w) as usize, y.rem_euclid(h) as usize);
    for y in 0..h {
        for x in 0..w {
            let laplacian =
                at(&smooth, x + 1, y) + at(&smooth, x - 1, y) + at(&smooth, x, y + 1) + at(&smooth, x, y - 1)
                    - 4.0 * at(&smooth, x, y);
            // the jumps to the other side, on the border only (Moisan 2011, definition 1)
            let mut jumps = 0.0;
            if x == 0 || x == w - 1 {
                jumps += at(&picture, w - 1 - x, y) - at(&picture, x, y);
            }
            if y == 0 || y == h - 1 {
                jumps += at(&picture, x, h - 1 - y) - at(&picture, x, y);
            }
            assert!((laplacian - jumps).abs() < 1e-13, "{x} {y}: {laplacian} {jumps}");
        }
    }
    assert!(smooth.mean().abs() < 1e-14);
    // a picture without jumps is left alone
    let mirrored = image(16, 12, |x, _| if x < 8.0 { x } else { 16.0 - x });
    let difference = periodic_forward(&mirrored).values() - image_forward(&mirrored).values();
    assert!(difference.iter().all(|d| d.norm() < 1e-12));
}

#[test]
fn blocks_of_a_large_picture_have_the_spectrum_of_the_whole() {
    // white noise of variance one on 2500 × 1200 pixels: 3 × 2 blocks
    let noise = |i: u64| nyquist::num::random::normal(9, i, 0);
    let picture = Image::new(Grid::pixels(2500, 1200).unwrap(), (0..2500 * 1200).map(noise).collect()).unwrap();
    let spectrum = PowerSpectrum::of(&picture, Border::Periodic);
    assert_eq!((spectrum.blocks(), spectrum.power().width(), spectrum.power().height()), (6, 1024, 1024));
    // 3 million squares, some of them counted twice: five deviations of √(2/1.5·10⁶)
    assert!((spectrum.energy() - 1.0).abs() < 5.0 * (2.0f64 / 1.5e6).sqrt(), "{}", spectrum.energy());
}

#[test]
fn a_white_spectrum_is_its_own_floor_and_a_soft_one_ends_where_noise_begins() {
    let noise = |i: u64| nyquist::num::random::normal(9, i, 0);
    let white = Image::new(Grid::pixels(256, 256).unwrap(), (0..1 << 16).map(noise).collect()).unwrap();
    let [floor, band] = Fall::radial(&PowerSpectrum::of(&white, Border::Periodic)).floor();
    assert!((floor - 1.0).abs() < 0.2 && band < 0.03, "{floor} {band}");
    // a Gaussian spot of σ = 4 px has fallen by 60 dB (amplitude 10⁻³) where 2π²σ²ν² = ln 1000
    let spot = |x: f64, y: f64| 40.0 * (-((x - 128.0).powi(2) + (y - 128.0).powi(2)) / 32.0).exp();
    let soft = image(256, 256, spot);
    let noisy = soft.with(&white, |a, b| a + 1e-3 * b).unwrap();
    let [_, band] = Fall::radial(&PowerSpectrum::of(&noisy, Border::Periodic)).floor();
    // |F|²/area = (40·32π)²·e^{−4π²·16ν²}/2¹⁶ meets 10⁻⁶ where
    let power = (40.0 * 32.0 * std::f64::consts::PI).powi(2) / 65_536.0;
    let meets = ((power / 1e-6).ln() / (4.0 * std::f64::consts::PI.powi(2) * 16.0)).sqrt();
    assert!((band - meets).abs() < 1.5 / 128.0, "{band} {meets}");
}

#[test]
fn an_enlarged_picture_looks_enlarged_and_a_sharp_or_a_blurred_one_does_not() {
    // a scene whose amplitude falls as 1/ν, as scenes do: sum of waves of random direction and phase
    let scene = {
        let grid = Grid::pixels(256, 256).unwrap();
        let bins = ImageBins::of(grid, |u, v| {
            let rho = u.hypot(v).max(1.0 / 256.0);
            let index = ((u + 0.5) * 256.0).round() as u64 * 256 + ((v + 0.5) * 256.0).round() as u64;
            let phase = nyquist::num::random::uniform(4, index, 0);
            num_complex::Complex::cis(std::f64::consts::TAU * phase) / rho
        });
        image_inverse(&bins)
    };
    let cliffs = |image: &Image| {
        let spectrum = PowerSpectrum::welch(image);
        [0, 1].map(|axis| Fall::typical(&spectrum, axis).cliff())
    };
    assert_eq!(cliffs(&scene), [None, None]);
    for (name, factor) in [("lanczos-3", 2.0), ("catmull-rom", 2.0), ("lanczos-3", 1.5), ("mitchell", 3.0)] {
        let kernel = nyquist::kernel::catalog::by_name(name).unwrap();
        let n = (256.0 * factor) as usize;
        let large = resize(&scene, n, n, &kernel, Edge::Mirror).unwrap();
        for cliff in cliffs(&large) {
            let cliff = cliff.unwrap_or_else(|| panic!("{name} by {factor} is seen"));
            assert!((cliff * factor / 0.5 - 1.0).abs() < 0.35, "{name} by {factor}: {cliff}");
        }
    }
    let blurred = nyquist::inspect::picture::blur::Blur::new(0.7).unwrap().apply(&scene, Edge::Mirror).unwrap();
    assert_eq!(cliffs(&blurred), [None, None]);
}

#[test]
fn pictures_of_one_pixel_a_row_and_a_column_have_spectra_too() {
    for (w, h) in [(1, 1), (1, 7), (9, 1), (2, 2), (3, 5)] {
        let picture = image(w, h, |x, y| x * 0.1 + y * y * 0.03);
        for border in ["periodic", "hann", "none"] {
            let spectrum = PowerSpectrum::of(&picture, border.parse().unwrap());
            assert!(spectrum.energies().all(|(_, e)| e.is_finite() && e >= 0.0), "{w} {h} {border}");
            let falls = [Fall::radial(&spectrum), Fall::along(&spectrum, 0), Fall::along(&spectrum, 1)];
            assert!(falls.iter().all(|fall| fall.floor().iter().all(|v| v.is_finite()) && fall.cliff().is_none()));
        }
    }
}
