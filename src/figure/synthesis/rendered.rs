//! What figures of rendered pictures share: the box filter, luminance, and errors.

use crate::error::Result;
use crate::image::{Image, Rgb};
use crate::kernel::box_kernel::BoxKernel;
use crate::pattern::Pattern;
use crate::scene::Scene;
use crate::scene::render::render;

/// A square picture, every pixel the mean of the samples of a pattern of its own seed.
pub(super) fn colored(scene: &(impl Scene + ?Sized), size: usize, pattern: &dyn Pattern<5>, seed: u64) -> Result<Rgb> {
    render(scene, size, size, pattern, &BoxKernel, seed)
}

/// Its luminance.
pub(super) fn sampled(
    scene: &(impl Scene + ?Sized),
    size: usize,
    pattern: &dyn Pattern<5>,
    seed: u64,
) -> Result<Image> {
    Ok(colored(scene, size, pattern, seed)?.luminance())
}

/// The same samples in every pixel: made once, for references.
#[derive(Debug)]
pub(super) struct Repeated(Vec<[f64; 5]>);

impl Repeated {
    pub(super) fn new(pattern: &dyn Pattern<5>) -> Self {
        Self(pattern.points(0))
    }
}

impl Pattern<5> for Repeated {
    fn name(&self) -> String {
        "repeated".into()
    }

    fn count(&self) -> Option<usize> {
        Some(self.0.len())
    }

    fn points(&self, _: u64) -> Vec<[f64; 5]> {
        self.0.clone()
    }
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
