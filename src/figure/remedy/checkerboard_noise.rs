//! The checkerboard by jittered samples (slide «Jittered vs. Uniform Supersampling»), and the error of every pixel.

use crate::error::Result;
use crate::figure::common::values;
use crate::figure::params::Param;
use crate::figure::remedy::board::{Board, FAR, ROWS, SIDE, bins, enlarged, error_power, frame, map, row_power, whole};
use crate::figure::remedy::stochastic::{DEVIATIONS, SEED};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale, Tones};
use crate::image::Image;
use crate::pattern::cells::Cells;
use crate::pattern::jittered::Jittered;
use crate::pattern::measure::whiteness::{peak_to_mean, white_peak};
use crate::pattern::regular::Regular;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};
use ndarray::Array2;
use std::ops::Range;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[JITTERED, MAP];

const JITTERED: Entry = Entry {
    id: "f40-jittered",
    inventory: &["F40"],
    errata: &["E11"],
    title: &Text::fixed("Jittered and uniform supersampling", "Супер-сэмплинг с джиттером и равномерный"),
    caption: &Text::fixed(
        "Sixteen samples a pixel both times. Jitter has no ghost: where uniform samples draw false squares, there is \
         noise around the right grey, and the error is smaller as well. Its size follows from the area p of white in \
         each of the sixteen cells: Σp(1 − p)/16² in every pixel.",
        "В обоих случаях шестнадцать отсчётов на пиксель. У джиттера нет ложного узора: там, где равномерные отсчёты рисуют \
         ложные клетки, — шум вокруг верного серого, и сама ошибка меньше. Её величина следует из доли белого p в каждой \
         из шестнадцати ячеек: Σp(1 − p)/16² в пикселе.",
    ),
    params: &[Param::count("seed", &SEED, 1, 1, 100)],
    build: |params| jittered(params.count("seed") as u64),
};

const N: usize = 4;
/// The row of pixels with the ghost of four samples: at `√(64/2·4)` = 2.83.
const GHOST: usize = 2;

/// The root mean square of every row's error, at the middles of the rows.
fn by_rows(board: &Board, image: &Image, rows: Range<usize>) -> Vec<[f64; 2]> {
    rows.map(|j| [j as f64 + 0.5, board.error(image, j..j + 1)]).collect()
}

fn jittered(seed: u64) -> Result<Figure> {
    let board = Board::new()?;
    let jitter = board.sampled(&Jittered::new([N, N])?, seed)?;
    let uniform = board.sampled(&Regular::new([N, N])?, 0)?;
    let expected = board.expected(Cells::new([N, N])?);
    let errors = |rows: Range<usize>| [&jitter, &uniform].map(|image| board.error(image, rows.clone()));
    let ([error, coherent], far) = (errors(ROWS), errors(FAR));

    let shown = 1..21;
    let theory = expected.variances.rows().into_iter().enumerate().map(|(j, row)| {
        let mean = row.iter().sum::<f64>() / row.len() as f64;
        [j as f64 + 0.5, mean.sqrt()]
    });
    let rows = Panel::new(
        "rows",
        text!("error of each row", "ошибка в каждой строке"),
        Scale::linear(text!("row", "строка"), 0.0, 21.0),
        values("", 0.0, 0.36),
    )
    .legend(Legend::Above)
    .with(
        Layer::line("uniform", Meaning::Leaked, by_rows(&board, &uniform, shown.clone()))
            .label(text!("uniform", "равномерно")),
    )
    .with(Layer::line("theory", Meaning::Theory, theory.skip(1).take(20)).thick().label(text!("theory", "теория")))
    .with(Layer::dots("jittered", Meaning::Samples, by_rows(&board, &jitter, shown)).label(text!("jitter", "джиттер")));

    let [of_jitter, of_uniform] = [row_power(&board, &jitter, GHOST)?, row_power(&board, &uniform, GHOST)?];
    let mean = of_uniform.iter().map(|p| p[1]).sum::<f64>() / of_uniform.len() as f64;
    let in_means = |powers: &[[f64; 2]]| -> Vec<[f64; 2]> { powers.iter().map(|p| [p[0], p[1] / mean]).collect() };
    let top = in_means(&of_uniform).iter().map(|p| p[1]).fold(0.0, f64::max);
    let power = Panel::new(
        "power",
        text!("power of the error in row {GHOST}", "мощность ошибки в строке {GHOST}"),
        Scale::linear(text!("ν, cycles per pixel", "ν, периодов на пиксель"), 0.0, 0.5),
        values("", 0.0, 1.1 * top),
    )
    .legend(Legend::Above)
    .with(Layer::stems("uniform", Meaning::Leaked, in_means(&of_uniform)).label(text!("uniform", "равномерно")))
    .with(Layer::stems("jittered", Meaning::Samples, in_means(&of_jitter)).label(text!("jitter", "джиттер")));

    let peak = |powers: &[[f64; 2]]| peak_to_mean(&powers.iter().map(|p| p[1]).collect::<Vec<_>>());
    let peaks = [peak(&of_jitter)?, peak(&of_uniform)?];
    // the least that would surprise in one of a hundred pictures, and in one of a hundred thousand
    let count = of_jitter.len();
    let (rarely, never) = (white_peak(count, 0.99)?, white_peak(count, 1.0 - 1e-5)?);
    let all = [&jitter, &uniform].map(|image| error_power(&board, image).map(|power| bins(&power)));
    let [all_jitter, all_uniform] = all;
    let (all_jitter, all_uniform) = (all_jitter?, peak_to_mean(&all_uniform?)?);
    let independent = all_jitter.len() / 2;
    Ok(Figure::new(3)
        .heights([1.0, 0.8])
        .with(
            whole("jittered", text!("jittered: {}", "с джиттером: {}", number(error, 3)), &jitter)
                .with(frame()),
        )
        .with(
            whole("uniform", text!("uniform: {}", "равномерно: {}", number(coherent, 3)), &uniform)
                .with(frame()),
        )
        .with(rows)
        .with(enlarged("jittered-far", &jitter))
        .with(enlarged("uniform-far", &uniform))
        .with(power)
        .claim(
            text!(
                "root mean square error {} with jitter, expected {}; {} without",
                "среднеквадратичная ошибка {} с джиттером, ожидается {}; без него {}",
                number(error, 3),
                number(expected.mean.sqrt(), 3),
                number(coherent, 3)
            ),
            Residual::near(
                "mean square error of jitter = Σp(1 − p)/N²",
                error * error,
                expected.mean,
                DEVIATIONS * expected.deviation,
            ),
        )
        .claim(
            text!(
                "uniform samples err more: in all, and in rows 1–10: {} against {}",
                "равномерные отсчёты ошибаются сильнее: в целом и в строках 1–10: {} против {}",
                number(far[1], 4),
                number(far[0], 3)
            ),
            Residual::at_most("error with jitter / without", (error / coherent).max(far[0] / far[1]), 1.0),
        )
        .claim(
            text!(
                "row {GHOST}: the error of uniform samples has a line {} times the mean; noise would stay below {} in 99 of 100 rows",
                "строка {GHOST}: в ошибке равномерных отсчётов есть линия, {} средних; шум в 99 строках из 100 не выше {}",
                number(peaks[1], 3),
                number(rarely, 3)
            ),
            Residual::at_least("peak of the error's power in the ghost's row, in means", peaks[1], rarely),
        )
        .claim(
            text!(
                "with jitter the highest of its {count} powers is {} means: noise",
                "с джиттером высшая из {count} мощностей — {} средних: шум",
                number(peaks[0], 2)
            ),
            Residual::at_most("peak of the noise in the ghost's row, in means", peaks[0], never),
        )
        .claim(
            text!(
                "rows 1–24 together: {} means with jitter, where ln {independent} = {}; without {}: so many rows blur the line",
                "строки 1–24 вместе: {} средних с джиттером при ln {independent} = {}; без него {}: столько строк размывают линию",
                number(peak_to_mean(&all_jitter)?, 2),
                number((independent as f64).ln(), 2),
                number(all_uniform, 2)
            ),
            Residual::at_most(
                "peak of the noise in 24 rows, in means",
                peak_to_mean(&all_jitter)?,
                white_peak(independent, 1.0 - 1e-5)?,
            ),
        ))
}

const MAP: Entry = Entry {
    id: "x-error-map",
    inventory: &["F35", "F40"],
    errata: &["E11"],
    title: &Text::fixed("Where the error is", "Где ошибка"),
    caption: &Text::fixed(
        "The mean square error of every pixel with sixteen samples, dark below 10^{−5}, yellow from 0.1 on. Independent samples err wherever \
         there is an edge, by p(1 − p)/16; jittered ones never more than that, and far less where an edge crosses only a \
         few cells. Uniform samples have no noise: their error is always the same, and strongest in the ghosts.",
        "Средний квадрат ошибки каждого пикселя при шестнадцати отсчётах: тёмное — меньше 10^{−5}, жёлтое — от 0,1. Независимые отсчёты ошибаются \
         везде, где есть край, на p(1 − p)/16; отсчёты с джиттером — никогда не больше, и намного меньше там, где край \
         задевает лишь часть ячеек. У равномерных шума нет: ошибка всегда одна и та же, сильнее всего — в ложных узорах.",
    ),
    params: &[Param::count("seed", &SEED, 1, 1, 100)],
    build: |params| error_map(params.count("seed") as u64),
};

/// The least error that has a tone of its own, as a power of ten.
const FLOOR: f64 = -5.0;

fn powers_of_ten(name: &'static str, title: Text, errors: &Array2<f64>) -> Panel {
    let powers = errors.mapv(|e| e.max(10f64.powf(FLOOR)).log10());
    map(name, title, &powers, ((FLOOR, -1.0), Tones::Data))
}

fn error_map(seed: u64) -> Result<Figure> {
    const PICTURES: u64 = 8;
    let board = Board::new()?;
    let independent = board.expected(Cells::new([1, 1])?);
    let random = independent.variances.mapv(|v| v / (N * N) as f64);
    let jitter = board.expected(Cells::new([N, N])?);
    let uniform = board.sampled(&Regular::new([N, N])?, 0)?;
    let mut squares = (uniform.pixels() - board.exact.pixels()).mapv(|d| d * d);
    squares.row_mut(0).fill(0.0);
    let samples = Jittered::new([N, N])?;
    let mut seen = Array2::<f64>::zeros(squares.dim());
    for k in 0..PICTURES {
        let error = board.sampled(&samples, seed + 1000 * k)?.pixels() - board.exact.pixels();
        seen.zip_mut_with(&error, |sum, e| *sum += e * e / PICTURES as f64);
    }
    seen.row_mut(0).fill(0.0);
    let measured = seen.sum() / (ROWS.len() * SIDE) as f64;
    let worse = jitter.variances.iter().zip(&random).map(|(j, r)| j - r).fold(0.0, f64::max);
    let errors = [independent.mean.sqrt() / N as f64, jitter.mean.sqrt(), board.error(&uniform, ROWS)];
    let shown = errors.map(|error| number(error, 3));
    let [of_random, of_jitter, of_uniform] = &shown;
    Ok(Figure::new(2)
        .with(powers_of_ten("random", text!("independent: {of_random}", "независимые: {of_random}"), &random))
        .with(powers_of_ten("jittered", text!("jittered: {of_jitter}", "с джиттером: {of_jitter}"), &jitter.variances))
        .with(powers_of_ten("uniform", text!("uniform: {of_uniform}", "равномерные: {of_uniform}"), &squares))
        .with(powers_of_ten(
            "measured",
            text!("{PICTURES} jittered pictures", "{PICTURES} картинок с джиттером"),
            &seen,
        ))
        .claim(
            text!(
                "in no pixel do jittered samples err more than independent ones",
                "ни в одном пикселе отсчёты с джиттером не ошибаются сильнее независимых"
            ),
            // the areas of sixteen cells against that of their pixel, each rounded to ε of the picture's side
            Residual::at_most("Σp(1 − p)/N² − p(1 − p)/N", worse, 16.0 * f64::EPSILON * SIDE as f64),
        )
        .claim(
            text!(
                "{PICTURES} jittered pictures err by {} (root mean square), theory {}",
                "{PICTURES} картинок с джиттером ошибаются на {} (среднеквадратично), теория {}",
                number(measured.sqrt(), 3),
                number(errors[1], 4)
            ),
            Residual::near(
                "mean square error of jittered pictures",
                measured,
                jitter.mean,
                DEVIATIONS * jitter.deviation / (PICTURES as f64).sqrt(),
            ),
        )
        .claim(
            text!(
                "uniform samples err more than independent ones would: {} against {}: ghosts cost more than noise",
                "равномерные отсчёты ошибаются сильнее, чем независимые: {} против {}: узоры дороже шума",
                number(errors[2], 3),
                number(errors[0], 3)
            ),
            Residual::at_least("error of uniform samples / of independent ones", errors[2] / errors[0], 1.0),
        ))
}
