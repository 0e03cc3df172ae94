//! What a picture's file says beside its pixels, and what is left out.

use crate::resize::material::{fixture, folder, grey, opened, plain, resize, with_chunk};
use crate::running::{code, piped, stderr, text};
use nyquist::door::carried::{Carried, Density, Depth, Per, Space};
use nyquist::door::transfer::{Curve, Transfer};
use nyquist::door::{Format, write_file};
use nyquist::prelude::*;
use std::fs;
use tempfile::TempDir;

#[test]
fn opacity_weighs_colours_and_white_stands_behind_a_jpeg() {
    // opaque red beside transparent green
    let plane = |values: Vec<f64>| Image::new(Grid::pixels(2, 1).unwrap(), values).unwrap();
    let rgb = Rgb::new([plane(vec![1.0, 0.0]), plane(vec![0.0, 1.0]), plane(vec![0.0, 0.0])]).unwrap();
    let picture = Picture::from(rgb).with_alpha(plane(vec![1.0, 0.0])).unwrap();
    let (folder, input, output) = plain(&picture, "out.png");
    let done = resize(&[text(&input), text(&output), "--width", "1", "--filter", "box"]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    let small = opened(&fs::read(&output).unwrap()).picture;
    let Color::Rgb(rgb) = small.color() else { panic!("colour") };
    assert_eq!(rgb.planes().each_ref().map(|p| p.at(0, 0)), [1.0, 0.0, 0.0]);
    assert_eq!(small.alpha().map(|a| a.at(0, 0)), Some(128.0 / 255.0));
    let jpeg = folder.path().join("out.jpg");
    let done = resize(&[text(&input), text(&jpeg), "--scale", "1", "--filter", "tent", "--quality", "100"]);
    assert_eq!(code(&done), 0);
    assert!(stderr(&done).contains("JPEG has no opacity"), "{}", stderr(&done));
    let Color::Rgb(rgb) = opened(&fs::read(&jpeg).unwrap()).picture.color().clone() else { panic!("colour") };
    assert!(rgb.planes().iter().all(|p| p.at(1, 0) > 0.95), "white behind what is transparent");
}

#[test]
fn profile_gamma_density_and_depth_are_carried_over() {
    let picture = Picture::from(grey(8, 8, |x, y| (x + y) / 20.0));
    // a profile of grey with the plain power 1.8, the least that has a curve
    let profile = {
        let mut bytes = vec![0u8; 128];
        bytes[16..20].copy_from_slice(b"GRAY");
        bytes[36..40].copy_from_slice(b"acsp");
        bytes.extend(1u32.to_be_bytes());
        bytes.extend(b"kTRC");
        bytes.extend(144u32.to_be_bytes());
        bytes.extend(14u32.to_be_bytes());
        bytes.extend(b"curv\0\0\0\0\0\0\0\x01");
        bytes.extend(((1.8f64 * 256.0).round() as u16).to_be_bytes());
        bytes
    };
    let density = Some(Density { x: 11_811.0, y: 5_906.0, per: Per::Metre });
    let gamma = 1.8f64.mul_add(256.0, 0.0).round() / 256.0;
    let curves = |curve: Curve| Transfer::Curves(Box::new([curve.clone(), curve.clone(), curve]));
    for (space, transfer) in [
        (Space::Unmarked, Transfer::Srgb),
        (Space::Srgb(1), Transfer::Srgb),
        (
            Space::Measured {
                gamma: Some(100_000),
                chromaticities: Some([31_270, 32_900, 64_000, 33_000, 30_000, 60_000, 15_000, 6_000]),
            },
            Transfer::Power(1.0),
        ),
        (Space::Profile(profile.clone()), curves(Curve::Power(gamma))),
        (Space::CodePoints([1, 13, 0, 1]), Transfer::Srgb),
    ] {
        for depth in [Depth::Eight, Depth::Sixteen] {
            let carried =
                Carried { depth, space: space.clone(), transfer: transfer.clone(), density, ..Carried::default() };
            let (_folder, input, output) = folder(&picture, &carried, "out.png");
            let done = resize(&[text(&input), text(&output), "--scale", "0.5", "--filter", "box"]);
            assert_eq!(code(&done), 0, "{}", stderr(&done));
            assert_eq!(stderr(&done), "");
            let written = opened(&fs::read(&output).unwrap());
            assert_eq!(written.carried, carried);
            // light is what the curve says: the mean of four pixels
            let (before, after) = (opened(&fs::read(&input).unwrap()).picture.luminance(), written.picture.luminance());
            let mean = (before.at(0, 0) + before.at(1, 0) + before.at(0, 1) + before.at(1, 1)) / 4.0;
            let step = if depth == Depth::Eight { 1.0 / 255.0 } else { 1.0 / 65_535.0 };
            // half a code, times the steepest slope of these curves
            assert!((after.at(0, 0) - mean).abs() <= 0.5 * step * 2.4, "{space:?} {depth:?}");
        }
    }
}

#[test]
fn long_profiles_and_densities_of_a_jpeg_are_carried_over_too() {
    let picture = Picture::from(grey(24, 16, |x, y| (x + y) / 50.0));
    // longer than one segment of 64 KiB; without curves, which is said
    let mut profile = vec![7u8; 150_000];
    profile[36..40].copy_from_slice(b"acsp");
    profile[128..132].copy_from_slice(&0u32.to_be_bytes());
    let density = Some(Density { x: 300.0, y: 150.0, per: Per::Inch });
    let carried = Carried { space: Space::Profile(profile), density, ..Carried::default() };
    let folder = TempDir::new().unwrap();
    let [input, jpeg, png] = ["in.jpg", "out.jpeg", "out.png"].map(|name| folder.path().join(name));
    fs::write(&input, write_file(&picture, &carried, Format::Jpeg(95)).unwrap()).unwrap();
    for output in [&jpeg, &png] {
        let done = resize(&[text(&input), text(output), "--width", "12"]);
        assert_eq!(code(&done), 0, "{}", stderr(&done));
        assert!(stderr(&done).contains("no tone curves: the curve of sRGB is assumed"), "{}", stderr(&done));
        let written = opened(&fs::read(output).unwrap());
        assert_eq!(written.carried.space, carried.space);
        let inches = written.carried.density.unwrap().per_inch();
        assert!((inches.x - 300.0).abs() < 0.02 && (inches.y - 150.0).abs() < 0.02, "{inches:?}");
    }
}

#[test]
fn what_is_left_out_is_named() {
    let bytes = png_bytes(&grey(6, 6, |x, _| x / 6.0).into(), Depth::Eight).unwrap();
    let bytes = with_chunk(&bytes, b"tEXt", b"Comment\0hello");
    let bytes = with_chunk(&bytes, b"tIME", &[7, 234, 1, 1, 0, 0, 0]);
    let done = piped("resize", &["-", "-", "--scale", "2"], &bytes);
    assert_eq!(code(&done), 0);
    let said = stderr(&done);
    assert!(said.contains("note: tEXt (13 bytes) is not carried over") && said.contains("tIME (7 bytes)"), "{said}");
    // an animation: two frames, of which the still one is taken
    let bytes = png_bytes(&grey(6, 6, |x, _| x / 6.0).into(), Depth::Eight).unwrap();
    let mut control = vec![0; 26];
    control[7] = 6;
    control[11] = 6;
    let animated = with_chunk(&bytes, b"fcTL", &control);
    let animated = with_chunk(&animated, b"acTL", &[0, 0, 0, 1, 0, 0, 0, 0]);
    let done = piped("resize", &["-", "-", "--scale", "2"], &animated);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    assert!(stderr(&done).contains("an animation of 1 frames: only its still picture"), "{}", stderr(&done));
    // a JPEG that was held sideways
    let output = TempDir::new().unwrap();
    let file = output.path().join("out.png");
    let done = resize(&[text(&fixture("ramp-sideways.jpg")), text(&file), "--scale", "1", "--json"]);
    assert_eq!(code(&done), 0);
    assert!(stderr(&done).contains("turned upright") && stderr(&done).contains("EXIF"), "{}", stderr(&done));
    let report: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    assert_eq!((report["output"]["width"].as_u64(), report["output"]["height"].as_u64()), (Some(40), Some(24)));
    assert_eq!(report["skipped"][0]["name"], "EXIF");
}

#[test]
fn pipes_are_files_and_palettes_and_bits_become_colours() {
    for name in ["palette.png", "palette-transparent.png", "bits1.png", "ramp.jpg"] {
        let folder = TempDir::new().unwrap();
        let output = folder.path().join("out.png");
        let input = fixture(name);
        let done = resize(&[text(&input), text(&output), "--scale", "2", "--filter", "tent"]);
        assert_eq!(code(&done), 0, "{}", stderr(&done));
        let through = piped("resize", &["-", "-", "--scale", "2", "--filter", "tent"], &fs::read(&input).unwrap());
        assert_eq!((code(&through), &through.stdout), (0, &fs::read(&output).unwrap()));
        let (before, after) = (opened(&fs::read(&input).unwrap()), opened(&through.stdout));
        assert_eq!(before.picture.alpha().is_some(), after.picture.alpha().is_some());
    }
}
