//! White and blue noise: masks, their spectra, and what they make of a grey.

use crate::axis::Axis;
use crate::error::Result;
use crate::figure::params::{Param, Params};
use crate::figure::patterns::square::{SEED, SEEDS, for_all_seeds, tones_panel};
use crate::figure::picture::picture;
use crate::figure::{Bar, Entry, Figure, Panel};
use crate::grid::Grid;
use crate::image::Image;
use crate::image::dft::forward;
use crate::num::random::bits;
use crate::pattern::blue_noise::Tile;
use crate::pattern::permutation::permutation;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};
use ndarray::Array2;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[NOISE];

static SIDE: Text = Text::fixed("cells along a side of the mask", "ячеек вдоль стороны маски");

const NOISE: Entry = Entry {
    id: "x-blue-noise",
    inventory: &[],
    errata: &["E11"],
    title: &Text::fixed("White noise and blue noise", "Белый шум и синий шум"),
    caption: &Text::fixed(
        "The same grey values in two orders. White noise has equal power at all frequencies; in the blue-noise mask (void and \
         cluster) none is left at low ones. A ramp turned into black and white by either has the same mean grey, but the eye, \
         which averages over neighbours, sees clumps in the first and an even grey in the second.",
        "Одни и те же значения серого в двух порядках. У белого шума равная мощность на всех частотах, у маски синего шума \
         (void and cluster) на низких её нет. Градиент, превращённый ими в чёрное и белое, в среднем одинаково сер, но глаз, \
         усредняя по соседям, видит в первом комки, а во втором — ровный серый.",
    ),
    params: &[Param::choice("side", &SIDE, &["64", "96", "128"]), Param::count("seed", &SEED, 1, 1, SEEDS)],
    build: |params| noise(params),
};

/// Thresholds of a square of cells, each of `(rank + ½)/side²` once.
type Mask = Array2<f64>;

fn white(side: usize, seed: u64) -> Mask {
    let ranks = permutation(bits(seed, 0, 0), side * side);
    Mask::from_shape_fn((side, side), |(y, x)| (f64::from(ranks[y * side + x]) + 0.5) / (side * side) as f64)
}

fn blue(side: usize, seed: u64) -> Result<Mask> {
    let tile = Tile::new(side, seed)?;
    Ok(Mask::from_shape_fn((side, side), |(y, x)| tile.threshold(x, y)))
}

/// The power of a mask at all frequencies, in units of its mean; zero at zero frequency, in the middle.
fn power(mask: &Mask) -> Result<Array2<f64>> {
    let side = mask.ncols();
    let axis = Axis::new(0.0, 1.0, side)?;
    let image = Image::new(Grid::new(axis, axis)?, mask.iter().map(|v| v - 0.5).collect())?;
    let power = forward(&image).power().pixels().clone();
    let mean = power.sum() / (power.len() - 1) as f64;
    Ok(power / mean)
}

/// The mean power below a frequency in cycles per cell, and how many independent bins there are.
fn low(power: &Array2<f64>, below: f64) -> (f64, usize) {
    let side = power.ncols();
    let frequency = |i: usize| (i as f64 - (side / 2) as f64) / side as f64;
    let inside = |(y, x): (usize, usize)| (0.0..below).contains(&frequency(y).hypot(frequency(x)));
    let values: Vec<f64> = power.indexed_iter().filter(|(at, p)| inside(*at) && **p > 0.0).map(|(_, p)| *p).collect();
    (values.iter().sum::<f64>() / values.len() as f64, values.len() / 2)
}

/// A ramp of greys from left to right, and its black and white by a mask that repeats.
fn ramp(side: usize, x: usize) -> f64 {
    (x as f64 + 0.5) / side as f64
}

fn dithered(mask: &Mask, side: usize) -> Array2<f64> {
    let own = mask.ncols();
    Array2::from_shape_fn((side, side), |(y, x)| f64::from(u8::from(mask[[y % own, x % own]] < ramp(side, x))))
}

/// The root mean square of the error in blocks of 8 × 8, as large as what an eye may average over.
fn blocks(dithered: &Array2<f64>) -> f64 {
    const BLOCK: usize = 8;
    let side = dithered.ncols();
    let squares = dithered.exact_chunks((BLOCK, BLOCK)).into_iter().enumerate().map(|(i, block)| {
        let first = i % (side / BLOCK) * BLOCK;
        let grey = (first..first + BLOCK).map(|x| ramp(side, x)).sum::<f64>() / BLOCK as f64;
        (block.sum() / (BLOCK * BLOCK) as f64 - grey).powi(2)
    });
    let squares: Vec<f64> = squares.collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

fn noise(params: &Params) -> Result<Figure> {
    const PICTURE: usize = 160;
    const LOW: f64 = 0.15;
    let seed = params.count("seed") as u64;
    let side: usize = match params.choice("side") {
        "96" => 96,
        "128" => 128,
        _ => 64,
    };
    let masks = [white(side, seed), blue(side, seed)?];
    let powers = [power(&masks[0])?, power(&masks[1])?];
    let pictures = [dithered(&masks[0], PICTURE), dithered(&masks[1], PICTURE)];
    let shown = |name, title, values: &Array2<f64>| -> Result<Panel> {
        let (rows, columns) = values.dim();
        Ok(picture(name, title, &Image::trusted(Grid::pixels(columns, rows)?, values.clone())))
    };
    let spectrum = |name, power: &Array2<f64>| {
        // an odd number of bins, symmetric about zero, as many as make large cells
        let inner = Array2::from_shape_fn((side - 3, side - 3), |(y, x)| power[[y + 2, x + 2]]);
        tones_panel(name, text!("its power", "его мощность"), inner, side as f64, (0.0, 2.0))
            .bar(Bar::values(Text::EMPTY))
    };
    let [[p_white, p_blue], [e_white, e_blue]] =
        [[low(&powers[0], LOW).0, low(&powers[1], LOW).0], [blocks(&pictures[0]), blocks(&pictures[1])]];
    let bins = low(&powers[0], LOW).1 as f64;
    let [m_white, m_blue] = [0, 1].map(|i| pictures[i].sum() / (PICTURE * PICTURE) as f64);
    // the ramp takes each mask's thresholds at its own greys: the variance of a pixel is p(1 − p), ⅙ in the mean; in a mask
    // that is repeated every cell stands for (PICTURE/side)² pixels, or, where a copy is cut, for more or less than that:
    // with 1¼ copies along a side the variance is (1.75/1.25²)² = 1.25 times as much, with more less
    let pixels = (side * side) as f64 / 1.26;
    Ok(Figure::new(3)
        .with(shown("white", text!("white noise", "белый шум"), &masks[0])?)
        .with(spectrum("white-power", &powers[0]))
        .with(shown("white-ramp", text!("dithered by it", "градиент через него"), &pictures[0])?)
        .with(shown("blue", text!("blue noise", "синий шум"), &masks[1])?)
        .with(spectrum("blue-power", &powers[1]))
        .with(shown("blue-ramp", text!("dithered by it", "градиент через него"), &pictures[1])?)
        .claim(
            text!(
                "white: the power below {LOW} cycles per cell is {} of the mean",
                "белый: мощность ниже {LOW} периода на ячейку — {} от средней",
                number(p_white, 2)
            ),
            // powers are exponential; thresholds are drawn without putting back, a part 1/side² less
            Residual::near("low power of white noise", p_white, 1.0, for_all_seeds(1) / bins.sqrt()),
        )
        .claim(
            text!("blue: {}, less than a tenth of it", "синий: {}, меньше десятой доли", number(p_blue, 2)),
            Residual::at_most("low power of blue noise relative to white noise", p_blue, 0.1),
        )
        .claim(
            text!(
                "errors of the ramp in blocks of 8 × 8: white {}, blue {}, less than half",
                "ошибка градиента в блоках 8 × 8: белый {}, синий {} — меньше половины",
                number(e_white, 2),
                number(e_blue, 2)
            ),
            Residual::at_most("error of blue noise in blocks relative to white noise", e_blue / e_white, 0.5),
        )
        .claim(
            text!("both keep the mean grey of the ramp, ½", "оба сохраняют средний серый тон градиента, ½"),
            Residual::at_most(
                "mean of the dithered ramp − ½",
                (m_white - 0.5).abs().max((m_blue - 0.5).abs()),
                for_all_seeds(2) * (1.0 / (6.0 * pixels)).sqrt(),
            ),
        ))
}
