//! What figures of rendered pictures share: grey pictures by the mean of every pixel's samples, and their errors.

use crate::antialias::supersample::pixel_seed;
use crate::error::Result;
use crate::figure::{Layer, Panel, Scale, Tones};
use crate::grid::Grid;
use crate::image::{Image, Rgb};
use crate::parallel;
use crate::pattern::Pattern;
use crate::scene::{Scene, ScenePoint};
use crate::text::Text;

/// The luminance at the pixel `(column, row)` of a square picture, seen by one sample.
fn seen(scene: &(impl Scene + ?Sized), size: usize, column: usize, row: usize, sample: [f64; 5]) -> f64 {
    let [x, y, time, u, v] = sample;
    let place = |at: f64| at / size as f64 - 0.5;
    let film = [place(column as f64 + x), place(row as f64 + y)];
    let light = scene.radiance(ScenePoint { film, lens: [u, v], time });
    Rgb::LUMINANCE.iter().zip(light).map(|(weight, part)| weight * part).sum()
}

/// A square picture, each pixel the mean of what `samples` says for its column and row: the box filter.
fn picture<S: AsRef<[[f64; 5]]>>(
    scene: &(impl Scene + ?Sized),
    size: usize,
    samples: impl Fn(i64, i64) -> S + Sync + Send,
) -> Result<Image> {
    let rows = parallel::map(size, |row| {
        let pixel = |column: usize| {
            let samples = samples(column as i64, row as i64);
            let samples = samples.as_ref();
            samples.iter().map(|s| seen(scene, size, column, row, *s)).sum::<f64>() / samples.len() as f64
        };
        (0..size).map(pixel).collect::<Vec<f64>>()
    });
    Image::new(Grid::pixels(size, size)?, rows.concat())
}

/// Every pixel by a pattern of its own seed.
pub(super) fn sampled(
    scene: &(impl Scene + ?Sized),
    size: usize,
    pattern: &dyn Pattern<5>,
    seed: u64,
) -> Result<Image> {
    picture(scene, size, |column, row| pattern.points(pixel_seed(seed, column, row)))
}

/// Every pixel by the same many samples: made once, for references.
pub(super) fn reference(scene: &(impl Scene + ?Sized), size: usize, pattern: &dyn Pattern<5>) -> Result<Image> {
    let samples = pattern.points(0);
    picture(scene, size, |_, _| &samples)
}

/// A mean and its standard error.
#[derive(Debug, Clone, Copy)]
pub(super) struct Measured {
    pub(super) mean: f64,
    pub(super) error: f64,
}

/// The mean squared error of a picture, whose pixels are independent, with the standard error of that mean.
pub(super) fn squared_error(picture: &Image, reference: &Image) -> Result<Measured> {
    let squares = picture.with(reference, |a, b| (a - b) * (a - b))?;
    let mean = squares.mean();
    let n = squares.values().len() as f64;
    let variance = squares.values().iter().map(|s| (s - mean) * (s - mean)).sum::<f64>() / (n - 1.0);
    Ok(Measured { mean, error: (variance / n).sqrt() })
}

/// A panel of a picture, upright and without scales.
pub(super) fn shown(name: &'static str, title: Text, picture: &Image, tones: (f64, f64)) -> Panel {
    let (width, height) = (picture.width() as f64, picture.height() as f64);
    // rows of an image run downwards, those of a raster upwards
    let upright = picture.pixels().slice_axis(ndarray::Axis(0), ndarray::Slice::new(0, None, -1)).to_owned();
    let bare = |range: f64| Scale::linear(Text::EMPTY, 0.0, range).bare();
    Panel::new(name, title, bare(width), bare(height)).square().with(Layer::raster(
        "picture",
        (0.0, width),
        (0.0, height),
        upright,
        tones,
        Tones::Grey,
    ))
}
