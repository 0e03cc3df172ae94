//! The checkerboard by jittered samples (slide «Jittered vs. Uniform Supersampling»), and the error of every pixel.

use crate::error::Result;
use crate::figure::common::values;
use crate::figure::params::Param;
use crate::figure::picture::tones;
use crate::figure::remedy::board::{Board, FAR, ROWS, SHOWN, SIDE, UPPER, across, enlarged, outline, row_power, shown};
use crate::figure::remedy::stochastic::{DEVIATIONS, SEED};
use crate::figure::{Bar, Entry, Figure, Layer, Legend, Meaning, Panel, Scale, Tones};
use crate::image::Image;
use crate::pattern::cells::Cells;
use crate::pattern::jittered::Jittered;
use crate::pattern::measure::whiteness::white_peak;
use crate::pattern::regular::Regular;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};
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
    let expected = board.expected(Cells::new([N, N])?)?;
    let errors = |rows: Range<usize>| [&jitter, &uniform].map(|image| board.error(image, rows.clone()));
    let ([error, coherent], far) = (errors(ROWS), errors(FAR));

    let drawn = 1..21;
    let theory = drawn.clone().map(|j| [j as f64 + 0.5, expected.of_row(j).sqrt()]);
    let rows = Panel::new(
        "rows",
        text!("error of each row", "ошибка в каждой строке"),
        Scale::linear(text!("row", "строка"), 0.0, 21.0),
        values("", 0.0, 0.24),
    )
    .legend(Legend::Above)
    .with(
        Layer::line("uniform", Meaning::Leaked, by_rows(&board, &uniform, drawn.clone()))
            .label(text!("uniform", "равномерно")),
    )
    .with(Layer::line("theory", Meaning::Theory, theory).thick().label(text!("theory", "теория")))
    .with(Layer::dots("jittered", Meaning::Samples, by_rows(&board, &jitter, drawn)).label(text!("jitter", "джиттер")));

    // the power of every row's error, in units of what theory gives to jitter's at every frequency
    let relative = |image: &Image, row: usize| -> Result<Vec<[f64; 2]>> {
        let unit = expected.of_row(row);
        Ok(row_power(&board, image, row)?.into_iter().map(|[nu, power]| [nu, power / unit]).collect())
    };
    let highest = |powers: &[[f64; 2]]| powers.iter().map(|p| p[1]).fold(0.0, f64::max);
    let [of_jitter, of_uniform] = [relative(&jitter, GHOST)?, relative(&uniform, GHOST)?];
    let peaks = [highest(&of_jitter), highest(&of_uniform)];
    let power = Panel::new(
        "power",
        text!("power of the error in row {GHOST}", "мощность ошибки в строке {GHOST}"),
        Scale::linear(text!("ν, cycles per pixel", "ν, периодов на пиксель"), 0.0, 0.5),
        values("", 0.0, 1.1 * peaks[1]),
    )
    .legend(Legend::Above)
    .with(Layer::stems("uniform", Meaning::Leaked, of_uniform).label(text!("uniform", "равномерно")))
    .with(Layer::stems("jittered", Meaning::Samples, of_jitter.iter().copied()).label(text!("jitter", "джиттер")));

    // the least that would surprise in one of a hundred pictures, and in one of a hundred thousand
    let count = of_jitter.len();
    let (rarely, never) = (white_peak(count, 0.99)?, white_peak(count, 1.0 - 1e-5)?);
    // near the horizon every row has hundreds of cells with squares in them: their sum is as good as normal
    let over_far = |image: &Image| -> Result<f64> {
        let peaks = FAR.map(|row| Ok(highest(&relative(image, row)?))).collect::<Result<Vec<_>>>()?;
        Ok(peaks.into_iter().fold(0.0, f64::max))
    };
    let [far_jitter, far_uniform] = [over_far(&jitter)?, over_far(&uniform)?];
    let (many, level) = (count * FAR.len(), white_peak(count * FAR.len(), 1.0 - 1e-5)?);
    Ok(Figure::new(2)
        .heights([1.04, 0.76, 0.96])
        .with(shown("jittered", text!("jittered: {}", "с джиттером: {}", number(error, 3)), &jitter, UPPER)?.with(outline()))
        .with(shown("uniform", text!("uniform: {}", "равномерно: {}", number(coherent, 3)), &uniform, UPPER)?.with(outline()))
        .with(enlarged("jittered-far", &jitter)?)
        .with(enlarged("uniform-far", &uniform)?)
        .with(rows)
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
                "row {GHOST}: the error of uniform samples has a line {} times the noise of jitter, which stays below {} in 99 rows of 100",
                "строка {GHOST}: в ошибке равномерных отсчётов есть линия в {} раза мощнее шума джиттера, а он в 99 строках из 100 не выше {}",
                number(peaks[1], 3),
                number(rarely, 3)
            ),
            Residual::at_least("peak of the error's power in the ghost's row, in means of noise", peaks[1], rarely),
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
                "rows 1–10: of {many} powers the highest is {} means with jitter; noise exceeds {} once in 10^{{5}} pictures",
                "строки 1–10: высшая из {many} мощностей с джиттером — {} средних; шум выше {} бывает раз на 10^{{5}} картинок",
                number(far_jitter, 2),
                number(level, 3)
            ),
            Residual::at_most("peak of jitter's error near the horizon, in means of noise", far_jitter, level),
        )
        .claim(
            text!(
                "without jitter it is {}: no noise, but a false picture",
                "без джиттера — {}: это не шум, а ложный узор",
                number(far_uniform, 3)
            ),
            Residual::at_least("peak of the uniform error near the horizon, in means of noise", far_uniform, level),
        ))
}

const MAP: Entry = Entry {
    id: "x-error-map",
    inventory: &["F35", "F40"],
    errata: &["E11"],
    title: &Text::fixed("Where the error is", "Где ошибка"),
    caption: &Text::fixed(
        "The mean square error of every pixel with sixteen samples. Independent samples err wherever \
         there is an edge, by p(1 − p)/16; jittered ones never more than that, and far less where an edge crosses only a \
         few cells. Uniform samples have no noise: their error is always the same, and strongest in the ghosts.",
        "Средний квадрат ошибки каждого пикселя при шестнадцати отсчётах. Независимые отсчёты ошибаются \
         везде, где есть край, на p(1 − p)/16; отсчёты с джиттером — никогда не больше, и намного меньше там, где край \
         задевает лишь часть ячеек. У равномерных шума нет: ошибка всегда одна и та же, сильнее всего — в ложных узорах.",
    ),
    params: &[Param::count("seed", &SEED, 1, 1, 100)],
    build: |params| error_map(params.count("seed") as u64),
};

/// The least error that has a tone of its own, as a power of ten.
const FLOOR: f64 = -5.0;

fn powers_of_ten(name: &'static str, title: Text, errors: &Image) -> Result<Panel> {
    let powers = errors.map(|e| e.max(10f64.powf(FLOOR)).log10());
    Ok(tones(name, title, &across(&powers, SHOWN)?, (FLOOR, -1.0), Tones::Data).bar(Bar::powers_of_ten(Text::EMPTY)))
}

fn error_map(seed: u64) -> Result<Figure> {
    const PICTURES: u64 = 8;
    let board = Board::new()?;
    let independent = board.expected(Cells::new([1, 1])?)?;
    let random = independent.variances.map(|v| v / (N * N) as f64);
    let jitter = board.expected(Cells::new([N, N])?)?;
    let uniform = board.sampled(&Regular::new([N, N])?, 0)?;
    let squares = board.differences(&uniform).map(|d| d * d);
    let samples = Jittered::new([N, N])?;
    let mut seen = squares.map(|_| 0.0);
    for k in 0..PICTURES {
        let error = board.differences(&board.sampled(&samples, seed + 1000 * k)?);
        seen = seen.with(&error, |sum, e| sum + e * e / PICTURES as f64)?;
    }
    let measured = seen.values()[ROWS.start * SIDE..].iter().sum::<f64>() / (ROWS.len() * SIDE) as f64;
    let worse = jitter.variances.values().iter().zip(random.values()).map(|(j, r)| j - r).fold(0.0, f64::max);
    let errors = [independent.mean.sqrt() / N as f64, jitter.mean.sqrt(), board.error(&uniform, ROWS)];
    let shown = errors.map(|error| number(error, 3));
    let [of_random, of_jitter, of_uniform] = &shown;
    Ok(Figure::new(2)
        .with(powers_of_ten("random", text!("independent: {of_random}", "независимые: {of_random}"), &random)?)
        .with(powers_of_ten("jittered", text!("jittered: {of_jitter}", "с джиттером: {of_jitter}"), &jitter.variances)?)
        .with(powers_of_ten("uniform", text!("uniform: {of_uniform}", "равномерные: {of_uniform}"), &squares)?)
        .with(powers_of_ten(
            "measured",
            text!("{PICTURES} jittered pictures", "{PICTURES} картинок с джиттером"),
            &seen,
        )?)
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
