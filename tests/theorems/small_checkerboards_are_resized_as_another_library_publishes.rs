//! The published accuracy cases of Pillow's `resize` (its `Tests/test_image_resample.py`): two bright and two dark squares,
//! whose results stand there code for code. Its box, bilinear, Hamming, bicubic (a = −½) and Lanczos filters are the box,
//! tent, Hamming, Catmull–Rom and Lanczos-3 kernels, widened when shrinking and divided by their sum as here.
//!
//! It works on bytes, across first and then down, and rounds and clips to a byte after either; beyond an edge it has nothing,
//! and divides by the sum of the weights that are left. So does this test.

use nyquist::image::resize::resize;
use nyquist::prelude::*;

/// `size × size` codes: `color` in the upper left and lower right squares, `255 − color` in the others.
fn squares(size: usize, color: u8) -> Image {
    let code = |x: usize, y: usize| f64::from(if (x < size / 2) == (y < size / 2) { color } else { 255 - color });
    let codes = (0..size * size).map(|i| code(i % size, i / size)).collect();
    Image::new(Grid::pixels(size, size).expect("small"), codes).expect("codes are finite")
}

/// One pass: what is left of the weights inside, divided by their sum.
fn pass(image: &Image, width: usize, height: usize, kernel: &dyn Kernel) -> Image {
    let part = |image: &Image| resize(image, width, height, kernel, Edge::Zero).expect("a small size");
    let quotient = part(image).with(&part(&image.map(|_| 1.0)), |sum, weights| sum / weights).expect("the same size");
    quotient.map(|v| v.round().clamp(0.0, 255.0))
}

/// The upper left quarter as published, the rest by symmetry.
fn agrees(kernel: &dyn Kernel, from: usize, to: usize, quarter: &[&str]) {
    let both = pass(&pass(&squares(from, 0xe1), to, from, kernel), to, to, kernel);
    for (y, row) in quarter.iter().enumerate() {
        for (x, code) in row.split(' ').enumerate() {
            let code = f64::from(u8::from_str_radix(code, 16).expect("two hexadecimal digits"));
            let (right, below) = (to - 1 - x, to - 1 - y);
            let found = [both.at(x, y), both.at(right, below), both.at(x, below), both.at(right, y)];
            let published = [code, code, 255.0 - code, 255.0 - code];
            assert_eq!(found, published, "{} {from} → {to} at {x}, {y}", kernel.name());
        }
    }
}

#[test]
fn box_cases() {
    agrees(&BoxKernel, 8, 4, &["e1 e1", "e1 e1"]);
    agrees(&BoxKernel, 2, 4, &["e1 e1", "e1 e1"]);
}

#[test]
fn bilinear_cases() {
    agrees(&TentKernel, 8, 4, &["e1 c9", "c9 b7"]);
    agrees(&TentKernel, 2, 4, &["e1 b0", "b0 98"]);
}

#[test]
fn hamming_cases() {
    agrees(&HammingKernel, 8, 4, &["e1 da", "da d3"]);
    agrees(&HammingKernel, 2, 4, &["e1 d2", "d2 c5"]);
}

#[test]
fn bicubic_cases() {
    agrees(&Cubic::catmull_rom(), 12, 6, &["e1 e3 d4", "e3 e5 d6", "d4 d6 c9"]);
    agrees(&Cubic::catmull_rom(), 4, 8, &["e1 e5 ee b9", "e5 e9 f3 bc", "ee f3 fd c1", "b9 bc c1 a2"]);
}

#[test]
fn lanczos_cases() {
    let lanczos = Lanczos::new(3.0).unwrap();
    agrees(&lanczos, 16, 8, &["e1 e0 e4 d7", "e0 df e3 d6", "e4 e3 e7 da", "d7 d6 d9 ce"]);
    let enlarged = [
        "e1 e0 db ed f5 b8",
        "e0 df da ec f3 b7",
        "db db d6 e7 ee b5",
        "ed ec e6 fb ff bf",
        "f5 f4 ee ff ff c4",
        "b8 b7 b4 bf c4 a0",
    ];
    agrees(&lanczos, 6, 12, &enlarged);
}
