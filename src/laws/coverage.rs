//! Exact area and what it is worth: prefiltering by a box (E13, E14, F36), and the ghosts of the zone plate (V27).

use crate::error::Result;
use crate::field::checkerboard::Checkerboard;
use crate::field::disc::Disc;
use crate::field::grating::Grating;
use crate::field::line::ThinLine;
use crate::field::polygon::ConvexPolygon;
use crate::field::zone_plate::ZonePlate;
use crate::field::{ExactMean, Field, from_fn};
use crate::grid::Grid;
use crate::image::Image;
use crate::image::dft::forward;
use crate::laws::Law;
use crate::laws::plane::transform_rounding;
use crate::num::{cos_pi, sinc};
use crate::residual::Residual;
use crate::text::Text;
use std::f64::consts::PI;

/// The gain of exact area for a grating of `cycles` over `pixels` pixels, above Nyquist or below: `|sinc(ν)|`, `ν =
/// cycles/pixels`. Above Nyquist that is what is left of it as an alias (E13).
///
/// Measured: the amplitude at the bin that the grating folds to, against `expected`. Allowed: the rounding of the
/// transform. Without a bin of its own (a multiple of half the pixels) a grating has no amplitude to measure.
///
/// ```
/// use nyquist::laws::coverage::area_gain;
/// let nine_tenths = area_gain(9, 10, nyquist::num::sinc(0.9))?;
/// assert!(nine_tenths.holds()); // 0.1093, not zero
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// No pixels.
pub fn area_gain(cycles: u32, pixels: usize, expected: f64) -> Result<Residual> {
    let nu = f64::from(cycles) / pixels as f64;
    let image = Image::averaged(&Grating::new([nu, 0.0])?, Grid::pixels(pixels, 1)?);
    let amplitude = 2.0 * forward(&image).bin(i64::from(cycles), 0).norm() / pixels as f64;
    let law = format!("gain of exact area at {nu} of the sampling rate");
    Ok(Residual::near(law, amplitude, expected.abs(), transform_rounding(pixels)))
}

/// The means over the pixels of a grid that covers a shape add up to its area, whatever the grid.
///
/// Measured: the relative difference. Allowed: the rounding of the sum and of the clipping, `16ε·(n + s)` with `n` pixels
/// and `s` the longer side of the grid in pixels: coordinates are rounded relative to where they are.
pub fn coverage_adds_up(shape: &impl ExactMean, area: f64, grid: Grid) -> Residual {
    let sum: f64 = Image::averaged(shape, grid).values().iter().sum();
    let side = grid.width().max(grid.height());
    let bound = 16.0 * f64::EPSILON * (grid.len() + side) as f64;
    Residual::at_most("coverage adds up to the area", (sum * grid.pixel_area() / area - 1.0).abs(), bound)
}

/// The exact mean over a cell is what counting `n`×`n` samples of a black-and-white picture comes to.
///
/// Measured: the difference. Allowed: a straight edge cuts at most `2n − 1` of the `n²` small cells, and each errs by at
/// most a half, so `lines/n` for that many edges through the cell; plus `left_out`, what the mean itself leaves out.
pub fn mean_by_counting(
    field: &impl ExactMean,
    [x, y]: [[f64; 2]; 2],
    n: usize,
    lines: f64,
    left_out: f64,
) -> Result<Residual> {
    let count = Image::of(field, Grid::cells(x[0]..x[1], n, y[0]..y[1], n)?).mean();
    let bound = lines / n as f64 + left_out;
    Ok(Residual::near("exact mean = share of the samples", field.mean(x, y), count, bound))
}

/// How many edges of the squares cross a cell of the checkerboard: one for every whole number that `v` or, along the far
/// side, where they are widest, `u` crosses.
pub fn edges_of_checkerboard(board: &Checkerboard, [x, y]: [[f64; 2]; 2]) -> f64 {
    let size = board.field().size();
    let corner = |x: f64, y: f64| board.camera().floor(x, y).unwrap_or([f64::INFINITY; 2]).map(|t| t / size);
    let corners = [corner(x[0], y[0]), corner(x[1], y[0]), corner(x[0], y[1]), corner(x[1], y[1])];
    let crossed = |axis: usize| {
        let ends = corners.map(|c| c[axis]);
        let (low, high) = (ends.into_iter().fold(f64::INFINITY, f64::min), ends.into_iter().fold(f64::MIN, f64::max));
        high.floor() - low.floor() + 1.0
    };
    crossed(0) + crossed(1)
}

/// V27: the samples of a zone plate at the integers repeat with the period `M`, if it is even.
///
/// Measured: the largest difference between samples a period apart, to the right and down, over `|x|, |y| ≤ reach`. Allowed:
/// the rounding of the phase, `πε·r²/M` with the farthest `r`.
///
/// # Errors
/// A period of zero.
pub fn ghosts_repeat(period: u32, reach: i32) -> Result<Residual> {
    let (m, n) = (f64::from(period), f64::from(reach));
    let plate = ZonePlate::new(m)?;
    let range = || (-reach..=reach).map(f64::from);
    let worst = |y: f64| {
        let differences = range().map(|x| {
            let here = plate.at(x, y);
            (plate.at(x + m, y) - here).abs().max((plate.at(x, y + m) - here).abs())
        });
        differences.fold(0.0, f64::max)
    };
    let bound = PI * f64::EPSILON * ((n + m).powi(2) + n * n) / m;
    Ok(Residual::at_most("samples of a zone plate repeat", range().map(worst).fold(0.0, f64::max), bound))
}

/// E13 on the zone plate: its exact means are `½ + ½cos(πr²/M)·sinc(x/M)·sinc(y/M)`, the box's gain at the local frequency:
/// every ghost is still there, dimmed.
///
/// Measured: the largest difference over the grid of an image of `ZP(M)`. Allowed: within a pixel the phase departs from a
/// plane wave by at most `πs²/M`, on average `π/12M` in each direction, so that the picture errs by `π/(12M)`; plus
/// rounding.
///
/// # Errors
/// A period that is not positive and finite.
pub fn dimmed_ghosts(image: &Image, period: f64) -> Result<Residual> {
    let model = from_fn(|x, y| 0.5 + 0.5 * cos_pi((x * x + y * y) / period) * sinc(x / period) * sinc(y / period));
    let grid = image.grid();
    crate::error::positive("the period of a zone plate", period)?;
    let differences = grid.iter().zip(image.values()).map(|([x, y], v)| (v - model.at(x, y)).abs());
    let measured = differences.fold(0.0, f64::max);
    let bound = PI / (12.0 * period) * grid.x().step().max(grid.y().step()).powi(2) + 64.0 * f64::EPSILON * period;
    Ok(Residual::at_most("exact area of a zone plate = ½ + ½cos·sinc·sinc", measured, bound))
}

/// Somebody who takes one sample for the mean.
struct OneSample<F>(F);

impl<F: Field> Field for OneSample<F> {
    fn at(&self, x: f64, y: f64) -> f64 {
        self.0.at(x, y)
    }
}

impl<F: Field> ExactMean for OneSample<F> {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        self.at(0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1]))
    }
}

fn kite() -> ConvexPolygon {
    ConvexPolygon::new(&[[1.3, 0.7], [8.2, 2.1], [7.1, 6.6], [3.0, 7.9], [0.9, 4.4]]).expect("it is convex")
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "area-is-a-box",
        inventory: &["E13", "V30"],
        says: &Text::fixed(
            "Exact area is a box prefilter: a frequency ν keeps sinc(ν), 0.109 at 0.9 of the rate; it is not free of aliasing",
            "Точная площадь есть бокс-фильтр: от частоты ν остаётся sinc(ν), при 0,9 частоты дискретизации 0,109; алиасинг не исчезает",
        ),
        holds: || {
            [(1, 10), (3, 10), (9, 10), (13, 10), (143, 100), (39, 10)]
                .map(|(k, n)| area_gain(k, n as usize, sinc(f64::from(k) / f64::from(n))).expect("there are pixels"))
                .into()
        },
        // the claim that it removes what is above Nyquist
        breaks: || [9, 13].map(|k| area_gain(k, 10, 0.0).expect("there are pixels")).into(),
    },
    Law {
        name: "coverage-adds-up",
        inventory: &["E14"],
        says: &Text::fixed(
            "Prefiltering is possible for polygons, discs and lines: their coverage of the pixels adds up to their area",
            "Для многоугольников, кругов и линий префильтрация возможна: покрытия пикселей в сумме дают площадь",
        ),
        holds: || {
            let grid = |nx, ny| Grid::cells(0.0..9.0, nx, 0.0..9.0, ny).expect("the ranges rise");
            let disc = Disc::new([4.4, 4.6], 3.3).expect("positive");
            let line = ThinLine::new([0.5, 1.0], [8.0, 6.5], 0.05).expect("it has a length");
            let mut residuals = Vec::new();
            for (nx, ny) in [(1, 1), (9, 9), (10, 7), (64, 64)] {
                residuals.push(coverage_adds_up(&kite(), kite().area(), grid(nx, ny)));
                residuals.push(coverage_adds_up(&disc, PI * 3.3 * 3.3, grid(nx, ny)));
                residuals.push(coverage_adds_up(&line, line.outline().area(), grid(nx, ny)));
            }
            residuals
        },
        breaks: || {
            let grid = Grid::cells(0.0..9.0, 9, 0.0..9.0, 9).expect("the ranges rise");
            let line = ThinLine::new([0.5, 1.0], [8.0, 6.5], 0.05).expect("it has a length");
            let area = line.outline().area();
            vec![
                coverage_adds_up(&OneSample(kite()), kite().area(), grid),
                coverage_adds_up(&OneSample(line), area, grid),
            ]
        },
    },
    Law {
        name: "checkerboard-area",
        inventory: &["F36"],
        says: &Text::fixed(
            "The exact pixel of the checkerboard in perspective is what counting samples comes to",
            "Точный пиксель шахматной доски в перспективе есть предел подсчёта сэмплов",
        ),
        holds: || {
            let board = Checkerboard::lecture(128).expect("it has pixels");
            [[60.0, 32.0], [3.0, 21.0], [90.0, 12.0], [64.0, 9.0], [127.0, 5.0], [10.0, 0.0]]
                .map(|[x, y]| {
                    let cell = [[x, x + 1.0], [y, y + 1.0]];
                    // in the row at the horizon there is no end of edges: count only what is below the hundredth square
                    let cell = if y == 0.0 { [cell[0], [0.64, 1.0]] } else { cell };
                    let lines = edges_of_checkerboard(&board, cell);
                    let left_out = board.mean_error(cell[0], cell[1]);
                    mean_by_counting(&board, cell, 600, lines, left_out).expect("there are samples")
                })
                .into()
        },
        breaks: || {
            let board = OneSample(Checkerboard::lecture(128).expect("it has pixels"));
            let cell = [[10.0, 11.0], [5.0, 6.0]];
            let lines = edges_of_checkerboard(&board.0, cell);
            vec![mean_by_counting(&board, cell, 600, lines, 0.0).expect("there are samples")]
        },
    },
    Law {
        name: "zone-plate-ghosts",
        inventory: &["V27", "E13"],
        says: &Text::fixed(
            "Samples of a zone plate repeat with its period M, if M is even; exact area dims the ghosts by sinc·sinc and no more",
            "Отсчёты зонной пластинки повторяются с её периодом M, если M чётно; точная площадь лишь ослабляет ложные центры в sinc·sinc раз",
        ),
        holds: || {
            let mut residuals: Vec<Residual> = [2, 16, 30, 128].map(|m| ghosts_repeat(m, 80).expect("positive")).into();
            for period in [64.0, 100.0] {
                let grid = Grid::centered(1.0, 257, 257).expect("finite");
                let image = Image::averaged(&ZonePlate::new(period).expect("positive"), grid);
                residuals.push(dimmed_ghosts(&image, period).expect("positive"));
            }
            residuals
        },
        breaks: || {
            // an odd period turns every second ghost into its negative, and samples do not dim anything
            let samples =
                Image::of(&ZonePlate::new(64.0).expect("positive"), Grid::centered(1.0, 129, 129).expect("finite"));
            vec![ghosts_repeat(15, 40).expect("positive"), dimmed_ghosts(&samples, 64.0).expect("positive")]
        },
    },
];
