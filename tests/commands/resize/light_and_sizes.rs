//! What is computed: light, sizes, places.

use crate::resize::material::{folder, grey, opened, plain, resize};
use crate::running::{code, stderr, text};
use nyquist::door::carried::{Carried, Depth};
use nyquist::image::resize::resize as resize_image;
use nyquist::prelude::*;
use std::fs;

#[test]
fn the_command_is_the_library_in_linear_light() {
    let picture = grey(30, 20, |x, y| 0.5 + 0.4 * (0.7 * x).sin() * (0.5 * y).cos());
    let carried = Carried { depth: Depth::Sixteen, ..Carried::default() };
    let (_folder, input, output) = folder(&picture.clone().into(), &carried, "out.png");
    let stored = opened(&fs::read(&input).unwrap()).picture.luminance();
    for (filter, edge_name, edge) in
        [("lanczos-3", "mirror", Edge::Mirror), ("mitchell", "clamp", Edge::Clamp), ("box", "wrap", Edge::Wrap)]
    {
        let done = resize(&[
            text(&input),
            text(&output),
            "--width",
            "13",
            "--height",
            "27",
            "--filter",
            filter,
            "--edge",
            edge_name,
            "--force",
        ]);
        assert_eq!(code(&done), 0, "{}", stderr(&done));
        let written = opened(&fs::read(&output).unwrap());
        assert_eq!(written.carried.depth, Depth::Sixteen, "16 bits stay");
        let kernel = nyquist::kernel::catalog::by_name(filter).unwrap();
        let expected = resize_image(&stored, 13, 27, &kernel, edge).unwrap();
        let bytes = png_bytes(&expected.into(), Depth::Sixteen).unwrap();
        assert_eq!(fs::read(&output).unwrap(), bytes);
    }
}

#[test]
fn a_checkerboard_becomes_the_grey_of_its_light_and_only_on_request_of_its_codes() {
    let checks = Picture::from(grey(16, 16, |x, y| (x.floor() + y.floor()) % 2.0));
    let (_folder, input, output) = plain(&checks, "out.png");
    for (more, expected) in [(&[][..], 188.0), (&["--encoded"], 128.0)] {
        let args = [&[text(&input), text(&output), "--scale", "0.5", "--filter", "box", "--force"], more].concat();
        assert_eq!(code(&resize(&args)), 0);
        let light = opened(&fs::read(&output).unwrap()).picture.luminance();
        assert!(light.values().iter().all(|v| (linear_to_srgb(*v) * 255.0).round() == expected), "{more:?}");
    }
}

#[test]
fn a_constant_stays_its_code_at_every_size_filter_and_depth() {
    for depth in [Depth::Eight, Depth::Sixteen] {
        let most = if depth == Depth::Eight { 255.0 } else { 65_535.0 };
        for value in [1.0, 77.0, 200.0, most] {
            let light = srgb_to_linear(value / most);
            let carried = Carried { depth, ..Carried::default() };
            let (_folder, input, output) = folder(&grey(9, 7, |_, _| light).into(), &carried, "out.png");
            for filter in ["lanczos-3", "gaussian", "none", "cubic:0,0.9"] {
                for scale in ["0.3", "1", "2.7"] {
                    let args = [text(&input), text(&output), "--scale", scale, "--filter", filter, "--force"];
                    assert_eq!(code(&resize(&args)), 0);
                    let written = opened(&fs::read(&output).unwrap()).picture.luminance();
                    assert!(written.values().iter().all(|v| *v == light), "{value} {filter} {scale}");
                }
            }
        }
    }
}

#[test]
fn a_side_that_is_not_said_keeps_the_shape() {
    let (_folder, input, output) = plain(&grey(64, 48, |x, _| x / 64.0).into(), "out.png");
    for (args, size) in [
        (&["--width", "32"][..], (32, 24)),
        (&["--height", "12"], (16, 12)),
        (&["--width", "10", "--height", "20"], (10, 20)),
        (&["--scale", "0.25"], (16, 12)),
        (&["--scale", "1.5"], (96, 72)),
        (&["--scale", "0.001"], (1, 1)),
        (&["--width", "1"], (1, 1)),
    ] {
        let done = resize(&[&[text(&input), text(&output), "--force"], args].concat());
        assert_eq!(code(&done), 0, "{}", stderr(&done));
        let grid = opened(&fs::read(&output).unwrap()).picture.grid();
        assert_eq!((grid.width(), grid.height()), size, "{args:?}");
        assert!(String::from_utf8_lossy(&done.stdout).contains(&format!("{} × {}", size.0, size.1)));
    }
}

#[test]
fn nothing_is_shifted_by_half_a_pixel() {
    // the centre of gravity of a spot stays, in parts of the picture
    let spot = grey(60, 60, |x, y| (-((x - 23.0).powi(2) + (y - 31.0).powi(2)) / 50.0).exp());
    let carried = Carried { depth: Depth::Sixteen, ..Carried::default() };
    let (_folder, input, output) = folder(&spot.into(), &carried, "out.png");
    for scale in ["0.5", "0.3", "2", "3.1"] {
        for filter in ["box", "tent", "mitchell", "lanczos-3"] {
            let args = [text(&input), text(&output), "--scale", scale, "--filter", filter, "--force"];
            assert_eq!(code(&resize(&args)), 0);
            let image = opened(&fs::read(&output).unwrap()).picture.luminance();
            let total: f64 = image.values().iter().sum();
            let [mut x, mut y] = [0.0, 0.0];
            for j in 0..image.height() {
                for i in 0..image.width() {
                    x += (i as f64 + 0.5) * image.at(i, j) / total;
                    y += (j as f64 + 0.5) * image.at(i, j) / total;
                }
            }
            let (w, h) = (image.width() as f64, image.height() as f64);
            // 16 bits, lobes cut off at black, and the spot's own sampling: a twentieth of an old pixel
            assert!((x / w * 60.0 - 23.0).abs() < 0.05 && (y / h * 60.0 - 31.0).abs() < 0.05, "{scale} {filter}");
        }
    }
}

#[test]
fn a_blur_before_decimation_is_the_blur_and_the_decimation() {
    let picture = grey(64, 64, |x, y| 0.5 + 0.3 * (2.2 * x).sin() + 0.1 * (0.3 * y).cos());
    let carried = Carried { depth: Depth::Sixteen, ..Carried::default() };
    let (_folder, input, output) = folder(&picture.into(), &carried, "out.png");
    let args = [text(&input), text(&output), "--scale", "0.5", "--filter", "none", "--blur", "1.2"];
    assert_eq!(code(&resize(&args)), 0);
    let stored = opened(&fs::read(&input).unwrap()).picture.luminance();
    let soft = nyquist::inspect::picture::blur::Blur::new(1.2).unwrap().apply(&stored, Edge::Mirror).unwrap();
    let grid = nyquist::image::resize::over(soft.grid(), 32, 32).unwrap();
    let expected = nyquist::image::resize::nearest(&soft, grid, Edge::Mirror);
    assert_eq!(fs::read(&output).unwrap(), png_bytes(&expected.into(), Depth::Sixteen).unwrap());
}

#[test]
fn one_pixel_one_row_and_one_column_can_be_resized() {
    for (w, h) in [(1, 1), (1, 9), (9, 1)] {
        let (_folder, input, output) = plain(&grey(w, h, |x, y| (x + y) / 20.0).into(), "out.png");
        for (args, size) in [(&["--scale", "3"][..], (3 * w, 3 * h)), (&["--width", "4", "--height", "5"], (4, 5))] {
            let done = resize(&[&[text(&input), text(&output), "--force"], args].concat());
            assert_eq!(code(&done), 0, "{}", stderr(&done));
            let grid = opened(&fs::read(&output).unwrap()).picture.grid();
            assert_eq!((grid.width(), grid.height()), size);
        }
    }
}
