//! A picture as the sum of a periodic one and a smooth one: its spectrum without the cross of its border.
//!
//! A discrete transform takes the picture for a tile of a pattern without an end. Where its left side does not meet its
//! right one, or its top its bottom, there is an edge as long as the picture, which no scene has; its spectrum is a cross
//! through zero that falls like `1/ν`. The smooth component has just these jumps and as little else as possible: its
//! Laplacian is zero inside. What is left is periodic without a seam, and every pixel counts as much as before, which a
//! window would not do. Source: Moisan, *Periodic plus smooth image decomposition*, J. Math. Imaging and Vision 39, 2011.

use crate::axis::Axis;
use crate::engine::fft::phase;
use crate::image::dft::{forward, inverse};
use crate::image::{Image, ImageBins};
use crate::sampled::dft::dft;
use ndarray::Array2;
use num_complex::Complex;
use std::f64::consts::TAU;

/// The transform of the periodic component: [`forward`] without the cross.
///
/// The smooth component `s` solves `(2cos 2πk/W + 2cos 2πl/H − 4)·ŝ(k, l) = v̂(k, l)`, `v` the jumps of the border; it has no
/// mean. As `v` stands on the border only, its transform costs one of a row and one of a column.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::image::periodic::periodic_forward;
/// // a ramp is all border: its cross is gone
/// let ramp = Image::of(&field_fn(|x, y| x + 2.0 * y), Grid::pixels(32, 24)?);
/// let (bins, plain) = (periodic_forward(&ramp), image_forward(&ramp));
/// assert!(bins.bin(5, 0).norm() < 0.04 * plain.bin(5, 0).norm());
/// assert!((bins.bin(0, 0) - plain.bin(0, 0)).norm() < 1e-9); // the mean stays
/// # Ok::<(), Error>(())
/// ```
pub fn periodic_forward(image: &Image) -> ImageBins {
    let bins = forward(image);
    let smooth = smooth_forward(image);
    ImageBins::trusted(image.grid(), bins.values() - &smooth)
}

/// The periodic and the smooth component, in this order; their sum is the picture.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::image::periodic::split;
/// let image = Image::of(&field_fn(|x, y| (x * y).sin() + x), Grid::pixels(20, 15)?);
/// let [periodic, smooth] = split(&image);
/// assert!(periodic.with(&smooth, |p, s| p + s)?.rmse(&image)? < 1e-14);
/// // no seam: opposite sides meet as neighbours do
/// let seam = (0..15).map(|j| (periodic.at(19, j) - periodic.at(0, j)).abs()).sum::<f64>();
/// let inside = (0..15).map(|j| (image.at(10, j) - image.at(9, j)).abs()).sum::<f64>();
/// assert!(seam < inside);
/// # Ok::<(), Error>(())
/// ```
pub fn split(image: &Image) -> [Image; 2] {
    let smooth = inverse(&ImageBins::trusted(image.grid(), smooth_forward(image)));
    let periodic = image.with(&smooth, |f, s| f - s).expect("of the same grid");
    [periodic, smooth]
}

/// The transform of the smooth component, in the units and the order of [`forward`].
fn smooth_forward(image: &Image) -> Array2<Complex<f64>> {
    let (w, h) = (image.width(), image.height());
    let row = |j: usize| (0..w).map(move |i| image.at(i, j));
    let column = |i: usize| (0..h).map(move |j| image.at(i, j));
    // how much is missing at the seam, along either side
    let across: Vec<f64> = column(w - 1).zip(column(0)).map(|(last, first)| last - first).collect();
    let down: Vec<f64> = row(h - 1).zip(row(0)).map(|(last, first)| last - first).collect();
    let [across, down] = [across, down].map(|jumps| dft(&jumps).expect("pixels are finite, and a side has one"));
    let (x, y) = (Turns::of(image.grid().x()), Turns::of(image.grid().y()));
    Array2::from_shape_fn((h, w), |(l, k)| {
        let (bk, bl) = ((k + w - w / 2) % w, (l + h - h / 2) % h);
        let curvature = x.curvature[bk] + y.curvature[bl];
        if bk == 0 && bl == 0 {
            return Complex::ZERO;
        }
        // + at the first pixel, − at the last one
        let border = across[bl] * x.jump[bk] + down[bk] * y.jump[bl];
        border / curvature * (x.physical[bk] * y.physical[bl])
    })
}

/// What is needed of the frequencies of one axis, in plain order.
struct Turns {
    /// `2cos(2πk/n) − 2`.
    curvature: Vec<f64>,
    /// `1 − e^{2πik/n}`.
    jump: Vec<Complex<f64>>,
    /// The step and the phase of the start.
    physical: Vec<Complex<f64>>,
}

impl Turns {
    fn of(axis: Axis) -> Self {
        let n = axis.len();
        let angle = |k: usize| TAU * k as f64 / n as f64;
        // 2cos a − 2 = −4sin²(a/2), which does not cancel
        let curvature = (0..n).map(|k| -4.0 * (0.5 * angle(k)).sin().powi(2)).collect();
        let jump = (0..n).map(|k| 1.0 - Complex::cis(angle(k))).collect();
        let signed = |k: usize| if k < n.div_ceil(2) { k as i64 } else { k as i64 - n as i64 };
        let physical = (0..n).map(|k| phase(signed(k), axis) * axis.step()).collect();
        Self { curvature, jump, physical }
    }
}
