//! The theorems of the Fourier transform in the plane (V31): pairs, shift, rotation, separability, Parseval, slices.

use crate::axis::Axis;
use crate::error::Result;
use crate::field::grating::Grating;
use crate::field::moved::Moved;
use crate::field::multiplied::Separable;
use crate::field::rotated::Rotated;
use crate::field::spectrum::PlaneSpectrum;
use crate::field::spot::GaussianSpot;
use crate::field::{Field, FourierField};
use crate::grid::Grid;
use crate::image::dft::{forward, inverse};
use crate::image::projection::{line_integral, project};
use crate::image::{Image, ImageBins};
use crate::laws::Law;
use crate::num::mean::mean;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::sampled::dft;
use crate::sampled::dtft::dtft;
use crate::signal::FourierPair;
use crate::signal::gaussian::Gaussian;
use crate::text::Text;

/// The rounding of a transform of `n` values, relative to the root of their sum of squares: `8ε·log₂n` (as in one
/// dimension; Higham 2002, §24.1).
pub fn transform_rounding(n: usize) -> f64 {
    8.0 * f64::EPSILON * (n as f64).log2().max(1.0)
}

/// The closed-form spectrum of a field is what the transform of its samples has at the bins.
///
/// Measured: the largest difference over all bins. Allowed: the rounding of the transform, relative to `ΔxΔy Σ|f|`, plus
/// `tail`, the caller's bound for what lies beyond the grid and for the copies beyond the band.
///
/// ```
/// use nyquist::laws::plane::pair_by_transform;
/// use nyquist::prelude::*;
/// let residual = pair_by_transform(&GaussianSpot::round(1.0)?, Grid::centered(0.25, 64, 64)?, 0.0);
/// assert!(residual.holds() && residual.bound < 1e-12);
/// # Ok::<(), Error>(())
/// ```
pub fn pair_by_transform(field: &impl FourierField, grid: Grid, tail: f64) -> Residual {
    spectrum_by_transform(&Image::of(field, grid), &field.spectrum(), tail)
}

/// The same for samples in hand: the transform of the image has at the bins the density of `spectrum`, and the weight of a
/// line times the area of the image where one stands.
///
/// ```
/// use nyquist::laws::plane::spectrum_by_transform;
/// use nyquist::prelude::*;
/// let grid = Grid::centered(1.0, 32, 32)?;
/// let whole = Grating::new([4.0 / 32.0, 0.0])?; // four periods fill the picture: two bins, and nothing else
/// assert!(spectrum_by_transform(&Image::of(&whole, grid), &whole.spectrum(), 0.0).holds());
/// let between = Grating::new([4.5 / 32.0, 0.0])?; // it leaks into all bins
/// assert!(!spectrum_by_transform(&Image::of(&between, grid), &between.spectrum(), 0.0).holds());
/// # Ok::<(), Error>(())
/// ```
pub fn spectrum_by_transform(image: &Image, spectrum: &PlaneSpectrum, tail: f64) -> Residual {
    let grid = image.grid();
    let expected = ImageBins::with_lines(grid, spectrum);
    let bins = forward(image);
    let differences = bins.values().iter().zip(expected.values()).map(|(f, known)| (f - known).norm());
    let measured = differences.fold(0.0, f64::max);
    let size = grid.pixel_area() * image.values().iter().map(|v| v.abs()).sum::<f64>();
    Residual::at_most("closed-form spectrum = transform", measured, transform_rounding(grid.len()) * size + tail)
}

/// `ΔxΔy Σ f² = (1/area) Σ |F|²`, exact for any image.
///
/// Allowed: twice the rounding `η` of the transform, relative, as `‖F‖` is off by `η‖F‖` and its square by twice that. The
/// sums add nothing: sums of `n` squares one after another would be off by up to `nε/2`, where many of them are equal by not
/// much less; [means](mean) are off by about one rounding, and a square and a factor by as much, `8ε` for both sides together.
///
/// ```
/// use nyquist::laws::plane::parseval_of_image;
/// use nyquist::prelude::*;
/// // two values only, so that the roundings of plain sums would all go the same way
/// let wall = BrickWall::new([24.0, 10.0], 1.5, [0.2, 0.8])?;
/// assert!(parseval_of_image(&Image::averaged(&wall, Grid::centered(1.0, 96, 96)?)).holds());
/// # Ok::<(), Error>(())
/// ```
pub fn parseval_of_image(image: &Image) -> Residual {
    parseval_of_bins(image, &forward(image))
}

fn parseval_of_bins(image: &Image, bins: &ImageBins) -> Residual {
    let grid = image.grid();
    let squares: Vec<f64> = image.values().iter().map(|v| v * v).collect();
    let powers: Vec<f64> = bins.values().iter().map(|v| v.norm_sqr()).collect();
    let (space, frequency) = (grid.area() * mean(&squares), mean(&powers) / grid.pixel_area());
    let bound = (2.0 * transform_rounding(grid.len()) + 8.0 * f64::EPSILON) * space;
    Residual::near("ΔxΔy·Σf² = Σ|F|²/area", frequency, space, bound)
}

/// `inverse(forward(f)) = f`. Measured: the largest difference. Allowed: the rounding of two transforms.
pub fn round_trip_of_image(image: &Image) -> Residual {
    let back = inverse(&forward(image));
    let worst = image.values().iter().zip(back.values()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let size = image.values().iter().map(|v| v * v).sum::<f64>().sqrt();
    Residual::at_most("inverse(forward(f)) = f", worst, transform_rounding(image.grid().len()) * size)
}

/// The transform of the sum down the columns is the row `v = 0` of the image's transform: a slice.
///
/// Measured: the largest difference of the two along row `row` counted from zero frequency (0 is the theorem). Allowed: the
/// rounding of both transforms, relative to `ΔxΔy Σ|f|`.
pub fn projection_slice(image: &Image, row: i64) -> Residual {
    let (line, plane) = (dft::forward(&project(image)), forward(image));
    let middle = image.width() as i64 / 2;
    let differences = (0..).zip(line.values()).map(|(k, v)| (v - plane.bin(k - middle, row)).norm());
    let measured = differences.fold(0.0, f64::max);
    let size = image.grid().pixel_area() * image.values().iter().map(|v| v.abs()).sum::<f64>();
    let bound = 2.0 * transform_rounding(image.grid().len()) * size;
    Residual::at_most("transform of the projection = slice of the transform", measured, bound)
}

/// The same at any angle, for a field with a closed-form spectrum: the line integrals along `angle`, by quadrature, at the
/// places of `axis`, transformed, against `F(ν cos θ, ν sin θ)`.
///
/// Allowed: the error of the quadratures and the rounding of the sum, plus `tail`, the caller's bound for what lies beyond
/// the axis and for the copies.
pub fn projection_slice_at(
    field: &impl FourierField,
    angle: f64,
    slice: f64,
    axis: Axis,
    frequencies: &[f64],
    tail: f64,
) -> Result<Residual> {
    let reach = 0.5 * axis.span();
    let lines: Vec<_> = axis.iter().map(|s| line_integral(field, angle, s, reach, 1.0)).collect();
    let error = axis.step() * lines.iter().map(|line| line.error).sum::<f64>();
    let projection = Samples::new(axis, lines.iter().map(|line| line.value).collect())?;
    let (spectrum, (sin, cos)) = (field.spectrum(), slice.sin_cos());
    let differences =
        frequencies.iter().map(|&nu| (dtft(&projection, nu) - spectrum.density(nu * cos, nu * sin)).norm());
    let measured = differences.fold(0.0, f64::max);
    let size = axis.step() * projection.values().iter().map(|v| v.abs()).sum::<f64>();
    let bound = error + crate::laws::poisson::sum_rounding(axis.len(), size) + tail;
    Ok(Residual::at_most("transform of the line integrals = slice at their angle", measured, bound))
}

/// A field with somebody else's spectrum: what the laws must catch.
struct Mismatched<F> {
    field: F,
    spectrum: PlaneSpectrum,
}

impl<F: Field> Field for Mismatched<F> {
    fn at(&self, x: f64, y: f64) -> f64 {
        self.field.at(x, y)
    }
}

impl<F: Field> FourierField for Mismatched<F> {
    fn spectrum(&self) -> PlaneSpectrum {
        self.spectrum.clone()
    }
}

/// A field given by two signals, with the product of their spectra.
struct Pairs(Separable<Gaussian, Gaussian>);

impl Field for Pairs {
    fn at(&self, x: f64, y: f64) -> f64 {
        self.0.at(x, y)
    }
}

impl FourierField for Pairs {
    fn spectrum(&self) -> PlaneSpectrum {
        PlaneSpectrum::separable(&self.0.0.spectrum(), &self.0.1.spectrum()).expect("both are densities")
    }
}

/// `e^{−x²/a² − y²/b²}`, a = 1, b = 1.6, turned: within 13 of zero to e^{−64}, and within the frequency 2.2.
fn spot() -> GaussianSpot {
    GaussianSpot::turned([1.0, 1.6], 0.5).expect("the radii are positive")
}

/// ±14.4 with a step of 0.2, whose Nyquist frequency is 2.5; not symmetric, and of sizes with a factor 3 and 5.
fn wide() -> Grid {
    Grid::cells(-14.4..14.4, 144, -15.0..15.0, 150).expect("the ranges rise")
}

fn noise(nx: usize, ny: usize) -> Image {
    let grid = Grid::cells(-1.3..2.0, nx, 0.5..4.0, ny).expect("the ranges rise");
    let values = (0..(nx * ny) as u64).map(|i| crate::num::random::normal(7, i, 0)).collect();
    Image::new(grid, values).expect("normal numbers are finite")
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "plane-pairs",
        inventory: &["V31", "F43", "F46"],
        says: &Text::fixed(
            "The transform of an image has the closed-form spectrum of its field, also moved: the phases turn",
            "Преобразование изображения есть спектр поля в замкнутом виде, и после сдвига тоже: поворачиваются фазы",
        ),
        holds: || {
            let moved = Moved::new([0.7, -0.3], spot()).expect("finite");
            vec![pair_by_transform(&spot(), wide(), 0.0), pair_by_transform(&moved, wide(), 0.0)]
        },
        breaks: || {
            let moved = Moved::new([0.7, -0.3], spot()).expect("finite");
            let back = Moved::new([-0.7, 0.3], spot()).expect("finite").spectrum();
            vec![pair_by_transform(&Mismatched { field: moved, spectrum: back }, wide(), 0.0)]
        },
    },
    Law {
        name: "rotation",
        inventory: &["V31", "F46"],
        says: &Text::fixed(
            "A field turned by an angle has its spectrum turned by the same angle",
            "У поля, повёрнутого на угол, спектр повёрнут на тот же угол",
        ),
        holds: || {
            let oblong = GaussianSpot::new([1.0, 1.6]).expect("positive");
            [0.3, std::f64::consts::FRAC_PI_4, 2.0]
                .map(|angle| pair_by_transform(&Rotated::new(angle, oblong).expect("finite"), wide(), 0.0))
                .into()
        },
        breaks: || {
            let oblong = GaussianSpot::new([1.0, 1.6]).expect("positive");
            let field = Rotated::new(0.3, oblong).expect("finite");
            let other_way = Rotated::new(-0.3, oblong).expect("finite").spectrum();
            vec![pair_by_transform(&Mismatched { field, spectrum: other_way }, wide(), 0.0)]
        },
    },
    Law {
        name: "separability",
        inventory: &["V31"],
        says: &Text::fixed("f(x)·g(y) ↔ F(u)·G(v)", "f(x)·g(y) ↔ F(u)·G(v)"),
        holds: || {
            let width = |w: f64| Gaussian::new(w).expect("positive");
            vec![pair_by_transform(&Pairs(Separable(width(1.5), width(2.4))), wide(), 0.0)]
        },
        breaks: || {
            let width = |w: f64| Gaussian::new(w).expect("positive");
            let spectrum = Pairs(Separable(width(2.4), width(1.5))).spectrum();
            let field = Separable(width(1.5), width(2.4));
            vec![pair_by_transform(&Mismatched { field, spectrum }, wide(), 0.0)]
        },
    },
    Law {
        name: "parseval-of-images",
        inventory: &["V31"],
        says: &Text::fixed(
            "ΔxΔy·Σf² = Σ|F|²/area, and the inverse returns the image, for any size",
            "ΔxΔy·Σf² = Σ|F|²/площадь, и обратное преобразование возвращает изображение любого размера",
        ),
        holds: || {
            let sizes = [(1, 1), (1, 8), (7, 1), (16, 12), (15, 12), (16, 9), (31, 33)];
            sizes
                .iter()
                .flat_map(|&(w, h)| [parseval_of_image(&noise(w, h)), round_trip_of_image(&noise(w, h))])
                .collect()
        },
        breaks: || {
            // bins that are read with another start are those of another image
            let image = noise(16, 12);
            let elsewhere = image.on(Grid::cells(0.0..3.3, 16, 0.0..3.5, 12).expect("rises")).expect("the same size");
            let bins = forward(&elsewhere);
            let read = ImageBins::trusted(image.grid(), bins.values().clone());
            let error = inverse(&read).rmse(&image).expect("the same size");
            // and without its mean, in the bin at zero, an image has less energy
            let less = forward(&image).times(|u, v| if u.hypot(v) < 0.1 { 0.0.into() } else { 1.0.into() });
            vec![
                Residual::at_most("bins read with another start", error, transform_rounding(192)),
                parseval_of_bins(&image, &less),
            ]
        },
    },
    Law {
        name: "projection-slice",
        inventory: &["V31"],
        says: &Text::fixed(
            "The transform of a projection is the slice of the transform at its angle",
            "Преобразование проекции есть сечение преобразования под тем же углом",
        ),
        holds: || {
            let axis = Axis::centered(0.2, 145).expect("finite");
            let frequencies = [0.0, 0.1, -0.25, 0.4, 1.0];
            vec![
                projection_slice(&noise(16, 12), 0),
                projection_slice(&noise(15, 9), 0),
                projection_slice_at(&spot(), 0.9, 0.9, axis, &frequencies, 0.0).expect("finite"),
                projection_slice_at(&spot(), -0.4, -0.4, axis, &frequencies, 0.0).expect("finite"),
            ]
        },
        breaks: || {
            let axis = Axis::centered(0.2, 145).expect("finite");
            vec![
                projection_slice(&noise(16, 12), 1),
                projection_slice_at(&spot(), 0.9, 0.0, axis, &[0.25], 0.0).expect("finite"),
            ]
        },
    },
    Law {
        name: "lines-of-gratings",
        inventory: &["F43", "F44"],
        says: &Text::fixed(
            "A grating of k whole cycles across N pixels has two bins of the size N²/2 and nothing else",
            "Решётка из k целых периодов на N пикселях даёт два отсчёта величины N²/2 и больше ничего",
        ),
        holds: || [[4.0, 0.0], [0.0, 8.0], [3.0, -5.0]].map(|k| two_bins(k, 64)).into(),
        breaks: || vec![two_bins([4.5, 0.0], 64)], // between two bins it leaks
    },
];

/// The bins of a grating of `cycles` over `n`×`n` pixels: `n²/2` at the two lines, zero elsewhere.
fn two_bins(cycles: [f64; 2], n: usize) -> Residual {
    let grid = Grid::centered(1.0, n, n).expect("the sizes are small");
    pair_by_transform(&Grating::new(cycles.map(|k| k / n as f64)).expect("finite"), grid, 0.0)
}
