//! The discrete spectrum of an image.

use crate::axis::Axis;
use crate::error::{Error, Result, finite};
use crate::field::spectrum::PlaneSpectrum;
use crate::grid::Grid;
use crate::image::Image;
use ndarray::Array2;
use num_complex::Complex;

/// Samples of a spectrum in the plane: `F(u_k, v_l)` at the frequencies of [`ImageBins::grid`], which rise along both
/// axes and have zero at column `width/2` and row `height/2`.
///
/// Like [`Bins`](crate::sampled::Bins) they keep the grid of the image that they came from.
#[derive(Debug, Clone, PartialEq)]
pub struct ImageBins {
    space: Grid,
    values: Array2<Complex<f64>>,
}

impl ImageBins {
    /// Values, row by row, of the spectrum of an image on `space`.
    ///
    /// # Errors
    /// A number of values other than the grid has positions; values that are not finite.
    pub fn new(space: Grid, values: Vec<Complex<f64>>) -> Result<Self> {
        if values.len() != space.len() {
            return Err(Error::Length { what: "bins on a grid", expected: space.len(), got: values.len() });
        }
        if let Some(index) = values.iter().position(|v| !v.is_finite()) {
            return Err(Error::NotFiniteAt { what: "bins, row by row,", index, value: values[index].norm() });
        }
        let shape = (space.height(), space.width());
        let values = Array2::from_shape_vec(shape, values).expect("there are as many values as positions");
        Ok(Self { space, values })
    }

    /// A spectrum in closed form at the bins of an image on `space`: what [`inverse`](crate::image::dft::inverse) makes
    /// a picture of.
    pub fn of(space: Grid, spectrum: impl Fn(f64, f64) -> Complex<f64>) -> Self {
        let frequencies = space.dual();
        let values = Array2::from_shape_fn((space.height(), space.width()), |(l, k)| {
            let [u, v] = frequencies.at(k as i64, l as i64);
            spectrum(u, v)
        });
        Self { space, values }
    }

    /// What an image on `space` has at its bins if its spectrum is this one: the density, and the weight of a line times the
    /// area of the image at the bin nearest to it.
    ///
    /// A line takes one bin alone if it stands on it, that is if its wave fits into the image a whole number of times.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// let wave = Grating::new([1.0 / 8.0, 0.0])?;
    /// let bins = ImageBins::with_lines(Grid::centered(1.0, 32, 32)?, &wave.spectrum());
    /// assert_eq!((bins.bin(4, 0).re, bins.bin(5, 0).re), (512.0, 0.0)); // N²/2
    /// # Ok::<(), Error>(())
    /// ```
    pub fn with_lines(space: Grid, spectrum: &PlaneSpectrum) -> Self {
        let mut bins = Self::of(space, |u, v| spectrum.density(u, v));
        let nearest = |nu: f64, axis: Axis| {
            let n = axis.len() as i64;
            ((nu * axis.span()).round() as i64 + n / 2).rem_euclid(n) as usize
        };
        for line in spectrum.lines() {
            bins.values[[nearest(line.at[1], space.y()), nearest(line.at[0], space.x())]] += line.weight * space.area();
        }
        bins
    }

    /// Values that are known to fit.
    pub(crate) fn trusted(space: Grid, values: Array2<Complex<f64>>) -> Self {
        debug_assert_eq!(values.dim(), (space.height(), space.width()));
        Self { space, values }
    }

    /// The grid of the image in space.
    pub fn space(&self) -> Grid {
        self.space
    }

    /// The frequencies of the bins.
    pub fn grid(&self) -> Grid {
        self.space.dual()
    }

    /// All values, `[[row, column]]`.
    pub fn values(&self) -> &Array2<Complex<f64>> {
        &self.values
    }

    /// The bin `(k, l)` counted from zero frequency, which is `(0, 0)`; modulo the size of the image.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// let wave = Image::of(&Grating::new([1.0 / 8.0, 0.0])?, Grid::centered(1.0, 32, 32)?);
    /// let bins = image_forward(&wave);
    /// assert!((bins.bin(4, 0).re - 512.0).abs() < 1e-11); // four cycles across the picture: N²/2
    /// assert!((bins.bin(-4, 0) - bins.bin(28, 32)).norm() < 1e-11);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn bin(&self, k: i64, l: i64) -> Complex<f64> {
        let wrap = |k: i64, n: usize| (k + n as i64 / 2).rem_euclid(n as i64) as usize;
        self.values[[wrap(l, self.space.height()), wrap(k, self.space.width())]]
    }

    /// Every bin times the response of a filter at its frequency.
    #[must_use]
    pub fn times(&self, response: impl Fn(f64, f64) -> Complex<f64>) -> Self {
        let (u, v) = (self.grid().x(), self.grid().y());
        let mut values = self.values.clone();
        for (mut row, v) in values.rows_mut().into_iter().zip(v.iter()) {
            row.iter_mut().zip(u.iter()).for_each(|(value, u)| *value *= response(u, v));
        }
        Self { space: self.space, values }
    }

    /// The power spectrum `|F|²/area`, whose sum times the area of a bin is the mean square of the image (Parseval).
    pub fn power(&self) -> Image {
        let area = self.space.area();
        Image::trusted(self.grid(), self.values.mapv(|value| value.norm_sqr() / area))
    }

    /// The picture of a spectrum: `20·log₁₀(|F|/max|F|)` from `floor` decibels (black, 0) to 0 dB (white, 1), zero
    /// frequency in the middle. All black where the spectrum is zero.
    ///
    /// ```
    /// use nyquist::prelude::*;
    /// let wave = Image::of(&Grating::new([1.0 / 8.0, 0.0])?, Grid::pixels(32, 32)?);
    /// let view = image_forward(&wave).log_magnitude(-60.0)?;
    /// assert_eq!((view.at(16, 16), view.at(20, 16)), (0.0, 1.0)); // no mean, and a peak four bins to the right
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// A floor that is not finite, or not negative.
    pub fn log_magnitude(&self, floor: f64) -> Result<Image> {
        finite("the floor of a log magnitude", floor)?;
        crate::error::positive("the depth of a log magnitude, in decibels,", -floor)?;
        let peak = self.values.iter().map(|v| v.norm()).fold(0.0, f64::max);
        let shade = |value: &Complex<f64>| {
            let decibels = 20.0 * (value.norm() / peak).log10();
            if peak == 0.0 { 0.0 } else { (1.0 - decibels / floor).max(0.0) }
        };
        Ok(Image::trusted(self.grid(), self.values.map(shade)))
    }
}
