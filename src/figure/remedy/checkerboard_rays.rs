//! One ray a pixel, four, and so many that the picture can be compared with (slides «Изображение для сравнения (256 лучей
//! на пиксель)», «1 луч с джиттерингом»).

use crate::error::Result;
use crate::figure::common::unmarked;
use crate::figure::params::Param;
use crate::figure::picture::grey;
use crate::figure::remedy::board::{
    Board, ERRING, ROWS, SHOWN, SIDE, UPPER, across, bins, enlarged, error_power, outline, shown,
};
use crate::figure::remedy::stochastic::{DEVIATIONS, SEED};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale, Tones};
use crate::image::Image;
use crate::pattern::cells::Cells;
use crate::pattern::jittered::Jittered;
use crate::pattern::measure::whiteness::{peak_to_mean, white_peak};
use crate::pattern::regular::Regular;
use crate::residual::Residual;
use crate::text;
use crate::text::{Lang, Text, number};
use std::f64::consts::PI;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[REFERENCE, ONE_RAY];

const REFERENCE: Entry = Entry {
    id: "f50-reference",
    inventory: &["F50"],
    errata: &[],
    title: &Text::fixed(
        "A picture to compare with: 256 rays a pixel",
        "Изображение для сравнения: 256 лучей на пиксель",
    ),
    caption: &Text::fixed(
        "16 × 16 jittered rays a pixel. For this scene the exact picture is known, so that one sees what such a reference \
         is worth: what is left is noise, strongest at the horizon. Along edges jitter gains as N^{−3/4}; near the horizon, \
         where every cell holds many squares, only as N^{−1/2}.",
        "16 × 16 лучей с джиттером на пиксель. Для этой сцены известна точная картинка, и видно, чего стоит такой эталон: \
         остался шум, сильнее всего у горизонта. На краях ошибка с джиттером падает как N^{−3/4}, а у горизонта, где в \
         каждой ячейке много клеток, — лишь как N^{−1/2}.",
    ),
    params: &[Param::count("seed", &SEED, 1, 1, 100)],
    build: |params| reference(params.count("seed") as u64),
};

fn reference(seed: u64) -> Result<Figure> {
    let board = Board::new()?;
    let mut jitter = Vec::new();
    let mut last = None;
    for n in [1, 2, 4, 8, 16] {
        let image = board.sampled(&Jittered::new([n, n])?, seed)?;
        jitter.push([(n * n) as f64, board.error(&image, ROWS)]);
        last = Some(image);
    }
    let image = last.unwrap_or_else(|| board.exact.clone());
    let mut regular = Vec::new();
    for n in [1, 2, 4, 8] {
        regular.push([(n * n) as f64, board.error(&board.sampled(&Regular::new([n, n])?, 0)?, ROWS)]);
    }
    let expected = |n: usize| board.expected(Cells::new([n, n])?);
    let (one, sixteen, many) = (expected(1)?, expected(4)?, expected(16)?);
    let error = board.error(&image, ROWS);
    let difference = across(&board.differences(&image), UPPER)?;
    let sixteenth = 1.0 / 16.0;
    let slope = |from: f64, power: f64| {
        let sigma = from.sqrt();
        (0..=4).map(move |k| 4f64.powi(k)).map(move |n| [n, sigma * n.powf(-power)])
    };
    let rates = Panel::new(
        "rates",
        text!("error against N", "ошибка в зависимости от N"),
        Scale::log(text!("rays per pixel N", "лучей на пиксель N"), 0.7, 370.0)
            .ticks([1.0, 4.0, 16.0, 64.0, 256.0].map(|n| (n, text!("{n}", "{n}")))),
        Scale::log(Text::EMPTY, 1.5e-3, 0.3),
    )
    .legend(Legend::Above)
    .with(Layer::line("slow", Meaning::Guide, slope(one.mean, 0.5)).dashed().label(Text::same("N^{−1/2}")))
    .with(Layer::line("fast", Meaning::Theory, slope(one.mean, 0.75)).dashed().label(Text::same("N^{−3/4}")))
    .with(Layer::line("regular-line", Meaning::Leaked, regular.iter().copied()).thin())
    .with(Layer::dots("regular", Meaning::Leaked, regular).label(text!("regular", "регулярно")))
    .with(Layer::line("jitter-line", Meaning::Samples, jitter.iter().copied()).thin())
    .with(Layer::dots("jitter", Meaning::Samples, jitter.iter().copied()).label(text!("jitter", "джиттер")));
    Ok(Figure::new(2)
        .heights([0.85, 1.0])
        .with(shown("reference", text!("256 rays", "256 лучей"), &image, UPPER)?)
        .with(grey("difference", text!("difference × 16", "разность × 16"), &difference, (-sixteenth, sixteenth)))
        .with(rates.span(2))
        .claim(
            text!(
                "256 rays are within {} (root mean square) of exact area, expected {}",
                "256 лучей отличаются от точной площади на {} (среднеквадратично), ожидается {}",
                number(error, 3),
                number(many.mean.sqrt(), 3)
            ),
            Residual::near(
                "mean square error of 256 jittered rays",
                error * error,
                many.mean,
                DEVIATIONS * many.deviation,
            ),
        )
        .claim(
            text!(
                "from 1 to 256 rays the error falls {} times: more than √256 = 16, less than 256^{{3/4}} = 64",
                "от 1 до 256 лучей отношение ошибок {}: больше, чем √256 = 16, и меньше, чем 256^{{3/4}} = 64",
                number(one.mean.sqrt() / error, 2)
            ),
            Residual::near(
                "ln of the gain, between ln 16 and ln 64",
                (one.mean.sqrt() / error).ln(),
                32f64.ln(),
                2f64.ln(),
            ),
        )
        .claim(
            text!(
                "16 rays: measured {}, expected {}",
                "16 лучей: измерено {}, ожидается {}",
                number(jitter[2][1], 3),
                number(sixteen.mean.sqrt(), 3)
            ),
            Residual::near(
                "mean square error of 16 jittered rays",
                jitter[2][1].powi(2),
                sixteen.mean,
                DEVIATIONS * sixteen.deviation,
            ),
        ))
}

/// The Euler–Mascheroni constant γ: what the mean of the greatest of many exponential numbers has beyond the logarithm of
/// their count.
const EULER: f64 = 0.577_215_664_901_532_9;

const ONE_RAY: Entry = Entry {
    id: "f51-one-ray",
    inventory: &["F51"],
    errata: &["E11"],
    title: &Text::fixed("One ray a pixel: false squares or noise", "Один луч на пиксель: ложные клетки или шум"),
    caption: &Text::fixed(
        "A jittered ray turns the false squares into noise. It does not make the error smaller: for one ray a pixel the \
         root mean square error even rises. But the bright spots in the spectrum of the error (below, in multiples of the \
         mean) are gone, and with them the structure that the eye finds. Four jittered rays do reduce the error.",
        "Луч с джиттером превращает ложные клетки в шум. Ошибку он не уменьшает: при одном луче на пиксель \
         среднеквадратичная ошибка даже растёт. Но яркие точки в спектре ошибки (внизу, в единицах среднего) исчезают, а с \
         ними структура, которую находит глаз. Четыре луча с джиттером уменьшают и ошибку.",
    ),
    params: &[Param::count("seed", &SEED, 1, 1, 100)],
    build: |params| one_ray(params.count("seed") as u64),
};

fn one_ray(seed: u64) -> Result<Figure> {
    const PICTURES: u64 = 16;
    let board = Board::new()?;
    let (one, four) = (Jittered::new([1, 1])?, Jittered::new([2, 2])?);
    let regular = board.sampled(&Regular::new([1, 1])?, 0)?;
    let images = [regular, board.sampled(&one, seed)?, board.sampled(&four, seed)?];
    let errors = images.each_ref().map(|image| board.error(image, ROWS));
    let expected = [board.expected(Cells::new([1, 1])?)?, board.expected(Cells::new([2, 2])?)?];
    let four_regular = board.error(&board.sampled(&Regular::new([2, 2])?, 0)?, ROWS);
    let peak = |image: &Image| peak_to_mean(&bins(&error_power(&board, image)?));
    let others = (0..PICTURES).map(|k| peak(&board.sampled(&one, seed + 1000 * k)?)).collect::<Result<Vec<_>>>()?;
    let mean_peak = others.iter().sum::<f64>() / PICTURES as f64;
    let names = [
        text!("1, regular", "1, регулярно"),
        text!("1, jittered", "1, с джиттером"),
        text!("4, jittered", "4, с джиттером"),
    ];
    let mut figure = Figure::new(3).heights([1.05, 0.63, 1.0]);
    for (((image, name), id), error) in images.iter().zip(&names).zip(["regular", "one", "four"]).zip(errors) {
        let [en, ru] = Lang::ALL.map(|lang| format!("{}: {}", name.get(lang), number(error, 3)));
        figure = figure.with(shown(id, text!("{en}", "{ru}"), image, SHOWN)?.with(outline()));
    }
    for (image, id) in images.iter().zip(["regular-far", "one-far", "four-far"]) {
        figure = figure.with(enlarged(id, image)?);
    }
    let mut peaks = Vec::new();
    for (image, id) in images.iter().zip(["regular-power", "one-power", "four-power"]) {
        let power = error_power(&board, image)?;
        let others = bins(&power);
        let mean = others.iter().sum::<f64>() / others.len() as f64;
        let top = peak_to_mean(&others)?;
        peaks.push(top);
        let title = text!("peak: {} means", "пик: {} средних", number(top, 3));
        let ticks = [-0.25, 0.0, 0.25].map(|v| (v, text!("{v}", "{v}")));
        let across = Scale::linear(text!("ν across", "ν по горизонтали"), -0.5, 0.5).ticks(ticks);
        let panel = Panel::new(id, title, across, unmarked(-0.5, 0.5));
        let mut relative = power.pixels().mapv(|p| p / mean);
        relative[[ERRING.len() / 2, SIDE / 2]] = 0.0;
        figure = figure.with(panel.with(Layer::raster(
            "power",
            (-0.5, 0.5),
            (-0.5, 0.5),
            relative,
            (0.0, 14.0),
            Tones::Data,
        )));
    }
    let independent = ERRING.len() * SIDE / 2;
    let (rarely, level) = (white_peak(independent, 0.99)?, (independent as f64).ln());
    Ok(figure
        .claim(
            text!(
                "one jittered ray errs by {} (expected {}), one regular ray by {}: jitter does not lower the error",
                "один луч с джиттером ошибается на {} (ожидается {}), регулярный — на {}: джиттер не уменьшает ошибку",
                number(errors[1], 4),
                number(expected[0].mean.sqrt(), 3),
                number(errors[0], 4)
            ),
            Residual::at_least("error of one jittered ray / of a regular one", errors[1] / errors[0], 1.0),
        )
        .claim(
            text!(
                "one ray: the mean square error is the mean of p(1 − p), p the white area of the pixel",
                "один луч: средний квадрат ошибки — среднее p(1 − p), где p — доля белого в пикселе"
            ),
            Residual::near(
                "mean square error of one jittered ray",
                errors[1].powi(2),
                expected[0].mean,
                DEVIATIONS * expected[0].deviation,
            ),
        )
        .claim(
            text!(
                "four jittered rays err by {} (expected {}), four regular ones by {}",
                "четыре луча с джиттером ошибаются на {} (ожидается {}), четыре регулярных — на {}",
                number(errors[2], 3),
                number(expected[1].mean.sqrt(), 3),
                number(four_regular, 3)
            ),
            Residual::near(
                "mean square error of four jittered rays",
                errors[2].powi(2),
                expected[1].mean,
                DEVIATIONS * expected[1].deviation,
            ),
        )
        .claim(
            text!(
                "regular: the error has a line of {} means; of noise 99 in 100 pictures stay below {}",
                "регулярно: в спектре ошибки линия в {} средних; у шума 99 картинок из 100 не выше {}",
                number(peaks[0], 3),
                number(rarely, 3)
            ),
            Residual::at_least("peak of the regular error's power, in means", peaks[0], rarely),
        )
        .claim(
            text!(
                "jittered: {} means on average over {PICTURES} pictures, as for white noise: ln {independent} + 0.58 = {}",
                "с джиттером: в среднем по {PICTURES} картинкам {} средних, как у белого шума: ln {independent} + 0,58 = {}",
                number(mean_peak, 2),
                number(level + EULER, 3)
            ),
            // the greatest of many exponential numbers deviates by π/√6 around ln M + γ (Gumbel)
            Residual::near(
                "mean peak of the noise = ln M + γ",
                mean_peak,
                level + EULER,
                DEVIATIONS * PI / (6.0 * PICTURES as f64).sqrt(),
            ),
        ))
}
