//! Files of pictures: every kind of PNG and JPEG that is read, against another program's files; PNG out and in again code
//! for code; and whatever is truncated, lying, empty or too large refused with a sentence.
#![cfg(feature = "files")]

use nyquist::door::open_picture;
use nyquist::prelude::*;
use std::path::{Path, PathBuf};

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/pictures").join(name)
}

fn bytes(name: &str) -> Vec<u8> {
    std::fs::read(file(name)).expect("the file stands in the repository")
}

fn open(name: &str) -> Picture {
    open_picture(&file(name), Limits::default()).expect("the file is sound")
}

fn planes(picture: &Picture) -> Vec<Image> {
    match picture.color() {
        Color::Grey(grey) => vec![grey.clone()],
        Color::Rgb(rgb) => rgb.planes().to_vec(),
    }
}

/// The light of every code must be exactly that of `code(x, y)` out of `most`.
fn holds_codes(image: &Image, most: f64, code: impl Fn(usize, usize) -> usize) {
    for y in 0..image.height() {
        for x in 0..image.width() {
            assert_eq!(image.at(x, y), srgb_to_linear(code(x, y) as f64 / most), "{x},{y}");
        }
    }
}

#[test]
fn every_kind_of_png_is_read() {
    let rgb: [fn(usize, usize) -> usize; 3] = [|x, _| 60 * x, |_, y| 100 * y, |x, y| 31 * x * y % 256];
    for name in ["rgb8.png", "rgb8-alpha.png"] {
        let picture = open(name);
        assert_eq!(picture.grid(), Grid::pixels(5, 3).unwrap());
        planes(&picture).iter().zip(rgb).for_each(|(plane, code)| holds_codes(plane, 255.0, code));
    }
    assert_eq!(open("rgb8.png").alpha(), None);
    let alpha = open("rgb8-alpha.png").alpha().unwrap().clone();
    assert!((0..5).all(|x| alpha.at(x, 1) == (63 * x) as f64 / 255.0)); // opacity is linear as it is
    holds_codes(&open("grey8.png").luminance(), 255.0, |x, y| 50 * x + y);
    let with_alpha = open("grey8-alpha.png");
    holds_codes(&with_alpha.luminance(), 255.0, |x, _| 50 * x);
    assert_eq!(with_alpha.alpha().unwrap().at(3, 2), 254.0 / 255.0);
    holds_codes(&open("grey16.png").luminance(), 65_535.0, |x, y| 13_000 * x + 257 * y);
    let wide: [fn(usize, usize) -> usize; 3] = [|x, _| 16_000 * x, |_, y| 30_000 * y, |x, y| 257 * x * y];
    planes(&open("rgb16.png")).iter().zip(wide).for_each(|(plane, code)| holds_codes(plane, 65_535.0, code));
    holds_codes(&open("bits1.png").luminance(), 255.0, |x, y| 255 * ((x + y) % 2));
    let palette = [[255, 0, 0], [0, 255, 0], [0, 0, 255], [10, 20, 30]];
    for name in ["palette.png", "palette-transparent.png"] {
        for (channel, plane) in planes(&open(name)).iter().enumerate() {
            holds_codes(plane, 255.0, |x, y| palette[(x + y) % 4][channel]);
        }
    }
    let holes = open("palette-transparent.png").alpha().unwrap().clone();
    assert_eq!([0, 1, 2, 3].map(|x| holes.at(x, 0) * 255.0), [255.0, 128.0, 0.0, 255.0]);
    // a file that says it is linear is
    let linear = open("linear8.png").luminance();
    assert!((0..5).all(|x| linear.at(x, 2) == (50 * x + 2) as f64 / 255.0));
}

#[test]
fn jpegs_are_what_another_decoder_makes_of_them() {
    for name in ["ramp", "ramp-progressive", "ramp-grey", "ramp-sideways"] {
        let (ours, theirs) = (open(&format!("{name}.jpg")), open(&format!("{name}-decoded.png")));
        assert_eq!(ours.grid(), theirs.grid(), "{name} stands upright");
        assert_eq!((ours.grid().width(), ours.grid().height()), (40, 24));
        for (a, b) in planes(&ours).iter().zip(planes(&theirs)) {
            // decoders may differ by one code in each of Y, Cb, Cr (IEEE 1180), and blue is Y + 1.772·Cb, rounded
            let code = |v: f64| linear_to_srgb(v) * 255.0;
            assert!(a.values().iter().zip(b.values()).all(|(a, b)| (code(*a) - code(*b)).abs() < 3.3), "{name}");
        }
    }
}

#[test]
fn every_orientation_of_a_camera_is_turned_upright() {
    let upright = open("ramp-sideways.jpg").luminance();
    let mut file = bytes("ramp-sideways.jpg");
    let exif = file.windows(6).position(|w| w == b"Exif\0\0").unwrap();
    // the value of the only entry of the directory
    let at = exif + 6 + 8 + 2 + 8;
    let six = file[at..at + 2].iter().position(|b| *b == 6).unwrap() + at;
    let mut read = |orientation: u8| {
        file[six] = orientation;
        read_picture("turned.jpg", &file, Limits::default()).unwrap().luminance()
    };
    assert_eq!(read(6), upright);
    let stored = read(1);
    assert_eq!((stored.width(), stored.height()), (24, 40));
    let (w, h) = (23, 39);
    assert!((0..24).all(|x| (0..40).all(|y| {
        let value = stored.at(x, y);
        // where TIFF 6.0 puts the stored pixel: 6 turns the picture clockwise, 8 the other way
        upright.at(h - y, x) == value
    })));
    assert_eq!(read(2).at(w, 5), stored.at(0, 5));
    assert_eq!(read(3).at(w, h), stored.at(0, 0));
    assert_eq!(read(4).at(7, h), stored.at(7, 0));
    assert_eq!(read(5).at(9, 4), stored.at(4, 9));
    assert_eq!(read(7).at(h, w), stored.at(0, 0));
    assert_eq!(read(8).at(0, w), stored.at(0, 0));
    assert_eq!(read(9), stored); // no such orientation: as it is
}

#[test]
fn pictures_survive_the_way_out_and_in_code_for_code() {
    let limits = Limits::default();
    for name in ["rgb8.png", "rgb8-alpha.png", "grey8.png", "grey8-alpha.png", "grey16.png", "rgb16.png", "ramp.jpg"] {
        let picture = open(name);
        let depth = if name.contains("16") { Depth::Sixteen } else { Depth::Eight };
        let bytes = png_bytes(&picture, depth).unwrap();
        assert_eq!(read_picture(name, &bytes, limits).unwrap(), picture, "{name}");
        assert_eq!(png_bytes(&picture, depth).unwrap(), bytes);
    }
    // all codes, and the two ends for what lies beyond them
    for (depth, side, most) in [(Depth::Eight, 16, 255.0), (Depth::Sixteen, 256, 65_535.0)] {
        let grid = Grid::pixels(side, side).unwrap();
        let light = (0..side * side).map(|code| srgb_to_linear(code as f64 / most)).collect();
        let all = Picture::from(Image::new(grid, light).unwrap());
        assert_eq!(read_picture("all.png", &png_bytes(&all, depth).unwrap(), limits).unwrap(), all);
    }
    let beyond = Image::new(Grid::pixels(3, 1).unwrap(), vec![-0.5, 1e300, 1.0]).unwrap();
    let back = read_picture("b.png", &png_bytes(&beyond.into(), Depth::Eight).unwrap(), limits).unwrap();
    assert_eq!(back.luminance().values(), [0.0, 1.0, 1.0]);
    let nothing = Image::of(&field_fn(|_, _| f64::NAN), Grid::pixels(1, 1).unwrap());
    assert!(matches!(png_bytes(&nothing.into(), Depth::Eight), Err(Error::NotFiniteAt { .. })));
}

fn reason(name: &str, bytes: &[u8], limits: Limits) -> String {
    match read_picture(name, bytes, limits) {
        Err(Error::Format { file, reason }) if file == name && !reason.is_empty() => reason,
        other => panic!("{name}: {other:?}"),
    }
}

#[test]
fn truncated_files_are_refused_wherever_they_are_cut() {
    for name in ["rgb8.png", "palette.png", "grey16.png", "ramp.jpg", "ramp-progressive.jpg", "ramp-grey.jpg"] {
        let whole = bytes(name);
        for cut in 0..whole.len() {
            reason(name, &whole[..cut], Limits::default());
        }
    }
}

/// A PNG file with another IHDR, whose checksum is right: a lie that only the data can give away.
fn with_header(width: u32, height: u32) -> Vec<u8> {
    let mut file = bytes("rgb8.png");
    file[16..20].copy_from_slice(&width.to_be_bytes());
    file[20..24].copy_from_slice(&height.to_be_bytes());
    let crc = !file[12..29].iter().fold(!0u32, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |c, _| if c & 1 == 1 { 0xedb8_8320 ^ (c >> 1) } else { c >> 1 })
    });
    file[29..33].copy_from_slice(&crc.to_be_bytes());
    file
}

#[test]
fn headers_that_lie_or_ask_for_too_much_are_refused_before_anything_is_decoded() {
    let limits = Limits::default();
    assert!(read_picture("same.png", &with_header(5, 3), limits).is_ok());
    for (w, h) in [(5, 4), (6, 3), (5, 1000), (1, 100)] {
        reason("longer.png", &with_header(w, h), limits);
    }
    for (w, h) in [(0, 3), (5, 0), (0, 0)] {
        reason("empty.png", &with_header(w, h), limits);
    }
    // 2³¹ − 1 squared and the like: at once, and without the memory
    for (w, h) in [(i32::MAX as u32, i32::MAX as u32), (u32::MAX, u32::MAX), (1 << 20, 1 << 10)] {
        reason("bomb.png", &with_header(w, h), limits);
    }
    assert!(
        reason("bomb.png", &with_header(40_000, 40_000), limits).contains("1600000000 pixels, more than the 67108864")
    );
    // the limit is the caller's
    let tight = Limits { pixels: 14 };
    assert!(reason("rgb8.png", &bytes("rgb8.png"), tight).contains("15 pixels, more than the 14 allowed"));
    assert!(reason("ramp.jpg", &bytes("ramp.jpg"), tight).contains("40 × 24 = 960 pixels"));
    assert!(read_picture("rgb8.png", &bytes("rgb8.png"), Limits { pixels: 15 }).is_ok());
    // a JPEG that says it is larger than its data
    let mut taller = bytes("ramp-grey.jpg");
    let frame = taller.windows(2).position(|w| w == [0xff, 0xc0]).unwrap();
    taller[frame + 5..frame + 7].copy_from_slice(&2400u16.to_be_bytes());
    reason("taller.jpg", &taller, limits);
    taller[frame + 5..frame + 7].copy_from_slice(&[0, 0]);
    reason("flat.jpg", &taller, limits);
}

#[test]
fn other_kinds_and_missing_files_are_named() {
    let limits = Limits::default();
    assert_eq!(reason("nothing.png", &[], limits), "the file is empty");
    assert!(reason("x.gif", b"GIF89a....", limits).contains("neither a PNG nor a JPEG"));
    assert!(reason("ramp-cmyk.jpg", &bytes("ramp-cmyk.jpg"), limits).contains("CMYK"));
    let error = open_picture(Path::new("/no/such/file.png"), limits).unwrap_err();
    assert!(matches!(&error, Error::Io { file, .. } if file == "/no/such/file.png"), "{error}");
}

#[test]
fn damaged_files_give_an_error_or_a_picture_and_never_a_panic() {
    for name in
        ["rgb8.png", "palette-transparent.png", "rgb16.png", "ramp.jpg", "ramp-progressive.jpg", "ramp-sideways.jpg"]
    {
        let whole = bytes(name);
        for i in 0..600u64 {
            let mut damaged = whole.clone();
            for k in 0..=i % 5 {
                let random = |d: u32| nyquist::num::random::bits(13, 8 * i + k, d);
                let at = random(0) as usize % damaged.len();
                damaged[at] = random(1) as u8;
            }
            if let Ok(picture) = read_picture(name, &damaged, Limits { pixels: 1 << 16 }) {
                assert!(picture.grid().len() <= 1 << 16);
                assert!(planes(&picture).iter().all(|plane| plane.values().iter().all(|v| (0.0..=1.0).contains(v))));
            }
        }
    }
}

#[test]
fn transparent_pixels_do_not_colour_their_neighbours() {
    let picture = open("palette-transparent.png");
    let small = picture.each(|image| nyquist::image::resize::resize(image, 1, 1, &BoxKernel, Edge::Clamp)).unwrap();
    // blue is fully transparent: what is left of it comes from the dark entry alone
    let [_, _, blue] = [0, 1, 2].map(|c| planes(&small)[c].at(0, 0));
    assert!(blue < srgb_to_linear(30.0 / 255.0));
    let over = picture.over(1.0);
    assert_eq!(over.alpha(), None);
    assert_eq!(planes(&over)[0].at(2, 0), 1.0); // the white behind the hole
}

/// A profile of the matrix kind as far as its curves go: the same tag for red, green and blue.
fn profile(curve: &[u8]) -> Vec<u8> {
    let mut bytes = vec![0u8; 128];
    bytes[16..20].copy_from_slice(b"RGB ");
    bytes[36..40].copy_from_slice(b"acsp");
    bytes.extend(3u32.to_be_bytes());
    for name in [b"rTRC", b"gTRC", b"bTRC"] {
        bytes.extend(name);
        bytes.extend((128u32 + 4 + 36).to_be_bytes());
        bytes.extend(u32::try_from(curve.len()).expect("short").to_be_bytes());
    }
    bytes.extend(curve);
    bytes
}

#[test]
fn light_is_what_the_curves_of_a_profile_say() {
    use nyquist::door::carried::{Carried, Light, Space};
    use nyquist::door::{Format, read_file, write_file};
    let fixed = |v: f64| ((v * 65_536.0).round() as i32).to_be_bytes();
    let formula = |kind: u16, parameters: &[f64]| {
        let mut tag = b"para\0\0\0\0".to_vec();
        tag.extend(kind.to_be_bytes());
        tag.extend([0, 0]);
        parameters.iter().for_each(|p| tag.extend(fixed(*p)));
        tag
    };
    let table = |values: &[u16]| {
        let mut tag = b"curv\0\0\0\0".to_vec();
        tag.extend(u32::try_from(values.len()).unwrap().to_be_bytes());
        values.iter().for_each(|v| tag.extend(v.to_be_bytes()));
        tag
    };
    let srgb = [2.4, 1.0 / 1.055, 0.055 / 1.055, 1.0 / 12.92, 0.04045];
    let grid = Grid::pixels(16, 16).unwrap();
    let codes: Vec<f64> = (0..256).map(|i| f64::from(i) / 255.0).collect();
    let plane = Image::new(grid, codes.clone()).unwrap();
    let rgb = Picture::from(Rgb::new([plane.clone(), plane.clone(), plane]).unwrap());
    type Case = (&'static str, Vec<u8>, fn(f64) -> f64);
    let cases: [Case; 6] = [
        ("sRGB as a formula", formula(3, &srgb), srgb_to_linear),
        ("a power", formula(0, &[1.8]), |v| v.powf(1.8)),
        ("an offset power", formula(1, &[2.0, 0.9, 0.1]), |v| (0.9 * v + 0.1).powi(2)),
        ("Adobe RGB", table(&[(2.199_218_75 * 256.0) as u16]), |v| v.powf(2.199_218_75)),
        ("identity", table(&[]), |v| v),
        ("a table of three", table(&[0, 16_384, 65_535]), |v| {
            if v < 0.5 { v * 2.0 * 0.25 } else { 0.25 + (v - 0.5) * 1.5 }
        }),
    ];
    for (name, curve, light) in cases {
        // written with codes as they are, and read as light
        let carried = Carried { space: Space::Profile(profile(&curve)), light: Light::Encoded, ..Carried::default() };
        let bytes = write_file(&rgb, &carried, Format::Png).unwrap();
        let read = read_file(name, &bytes, Limits::default(), Light::Linear).unwrap();
        assert!(read.remarks.is_empty(), "{name}: {:?}", read.remarks);
        for plane in planes(&read.picture) {
            for (value, code) in plane.values().iter().zip(&codes) {
                // parameters are fixed-point of 16 bits, and so are tables
                assert!((value - light(*code)).abs() < 1e-4, "{name} {code}: {value}");
            }
        }
        // and back, code for code
        let again = write_file(&read.picture, &read.carried, Format::Png).unwrap();
        assert_eq!(again, bytes, "{name}");
    }
    // curves that fall, or are no curves, are not taken
    for curve in [table(&[65_535, 0]), formula(9, &[1.0]), b"none".to_vec(), formula(3, &[2.4])] {
        let carried = Carried { space: Space::Profile(profile(&curve)), light: Light::Encoded, ..Carried::default() };
        let bytes = write_file(&rgb, &carried, Format::Png).unwrap();
        let read = read_file("odd.png", &bytes, Limits::default(), Light::Linear).unwrap();
        assert_eq!(read.remarks, ["the colour profile has no tone curves: the curve of sRGB is assumed"]);
        assert_eq!(read.carried.space, carried.space);
    }
}
