//! A Gaussian before the samples.

use crate::axis::Edge;
use crate::error::{Result, within};
use crate::image::Image;
use crate::image::convolution::convolve_separable;
use crate::num::cos_pi;

/// A blur by a Gaussian of standard deviation `σ` in pixels: taps `e^{−i²/2σ²}`, divided by their sum, up to `5σ`, where they
/// have sunk below `4·10⁻⁶`.
#[derive(Debug, Clone, PartialEq)]
pub struct Blur {
    sigma: f64,
    /// From the middle outwards.
    half: Vec<f64>,
}

impl Blur {
    /// The widest.
    pub const MOST: f64 = 1024.0;

    /// Of a standard deviation in pixels.
    ///
    /// # Errors
    /// One that is not finite, or outside `0.05..=1024`.
    pub fn new(sigma: f64) -> Result<Self> {
        within("the standard deviation of a blur", sigma, 0.05, Self::MOST)?;
        let raw: Vec<f64> =
            (0..=(5.0 * sigma).ceil() as usize).map(|i| (-0.5 * (i as f64 / sigma).powi(2)).exp()).collect();
        let sum = raw[0] + 2.0 * raw[1..].iter().sum::<f64>();
        Ok(Self { sigma, half: raw.into_iter().map(|w| w / sum).collect() })
    }

    /// The standard deviation.
    pub fn sigma(&self) -> f64 {
        self.sigma
    }

    /// What is left of a frequency in cycles a pixel: the sum over the taps, `e^{−2π²σ²ν²}` and its copies around every
    /// whole number.
    ///
    /// ```
    /// use nyquist::inspect::picture::blur::Blur;
    /// let blur = Blur::new(1.0)?;
    /// let continuous = |nu: f64| (-2.0 * std::f64::consts::PI.powi(2) * nu * nu).exp();
    /// // the taps end at 5σ, which leaves 2·10⁻⁶ at most
    /// assert!((blur.gain(0.3) - continuous(0.3) - continuous(0.7)).abs() < 4e-6);
    /// assert!(blur.gain(0.5) > 1.9 * continuous(0.5)); // two copies meet
    /// # Ok::<(), nyquist::error::Error>(())
    /// ```
    pub fn gain(&self, nu: f64) -> f64 {
        let sides: f64 = self.half[1..].iter().zip(1..).map(|(w, i)| w * cos_pi(2.0 * nu * f64::from(i))).sum();
        self.half[0] + 2.0 * sides
    }

    /// The picture, blurred in both directions.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// use nyquist::inspect::picture::blur::Blur;
    /// let stripes = Image::of(&Grating::new([0.25, 0.0])?, Grid::pixels(64, 1)?);
    /// let (blur, gain) = (Blur::new(0.8)?, Blur::new(0.8)?.gain(0.25));
    /// let soft = blur.apply(&stripes, Edge::Wrap)?;
    /// assert!(soft.rmse(&stripes.map(|v| gain * v))? < 1e-15);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// None: the taps are numbers.
    pub fn apply(&self, image: &Image, edge: Edge) -> Result<Image> {
        let taps: Vec<f64> = self.half[1..].iter().rev().chain(&self.half).copied().collect();
        convolve_separable(image, &taps, &taps, edge)
    }
}
