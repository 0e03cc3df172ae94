//! The checkerboard by one sample, by uniform supersampling and by exact area (slides «Point vs. Supersampled», «Analytic
//! vs. Supersampled»).

use crate::error::Result;
use crate::field::{ExactMean, Field};
use crate::figure::common::values;
use crate::figure::params::Param;
use crate::figure::remedy::board::{Board, NEAR_HORIZON, ROWS, SHOWN, SIDE, UPPER, enlarged, outline, shown};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::image::Image;
use crate::laws::coverage::{area_gain, edges_of_checkerboard, mean_by_counting};
use crate::num::sinc;
use crate::pattern::regular::Regular;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[UNIFORM, AREA];

static COUNT: Text = Text::fixed("samples per pixel, n × n", "отсчётов на пиксель, n × n");

const UNIFORM: Entry = Entry {
    id: "f35-checkerboard",
    inventory: &["F35"],
    errata: &[],
    title: &Text::fixed(
        "One sample a pixel, and uniform supersampling",
        "Один отсчёт на пиксель и равномерный супер-сэмплинг",
    ),
    caption: &Text::fixed(
        "An endless checkerboard (after T. Duff). One sample a pixel makes false squares near the horizon. Uniform \
         supersampling smooths the edges, but it has ghosts of its own, nearer to the horizon: in the row where the \
         squares pass as fast as the samples (dashed), all samples of a pixel see the same colour.",
        "Бесконечная шахматная доска (по Т. Даффу). Один отсчёт на пиксель рисует у горизонта ложные клетки. Равномерный \
         супер-сэмплинг сглаживает края, но у него свои ложные узоры, ближе к горизонту: в строке, где клетки идут с \
         частотой отсчётов (пунктир), все отсчёты пикселя видят один цвет.",
    ),
    // with these the ghosts' rows fall where whole rows of pixels show them
    params: &[Param::choice("n", &COUNT, &["4", "2", "8"])],
    build: |params| match params.choice("n") {
        "2" => uniform(2),
        "8" => uniform(8),
        _ => uniform(4),
    },
};

/// The pixels right of the middle: below the first row they see one row of squares only, `⌊u⌋ = 0`.
const MIDDLE: usize = SIDE / 2;

/// The row where the squares pass at the rate of `m` samples a pixel: along the middle line the pattern has the frequency
/// `hf/2y²`, since two squares make a period; `f` is half the side.
fn ghost_row(m: usize) -> f64 {
    (0.25 * SIDE as f64 / m as f64).sqrt()
}

/// How far from a ghost's row the samples keep in step: the phase between them and the squares departs as `m·d²/y`, and by
/// half a period at this distance.
fn ghost_height(m: usize) -> f64 {
    (0.5 * ghost_row(m) / m as f64).sqrt()
}

/// From where to where the longest run of equal samples down the middle line goes, where they are `1/m` apart and too
/// coarse: beyond the rows that twice the rate would resolve, on this side of those with another ghost. A sample stands
/// for half a step to either side.
fn longest_run(board: &Board, m: usize) -> [f64; 2] {
    let (step, row) = (1.0 / m as f64, ghost_row(m));
    let inside = |y: &f64| (row / 2f64.sqrt()..row * 2f64.sqrt()).contains(y);
    let places = (0..SIDE * m).map(|k| (k as f64 + 0.5) * step).filter(inside);
    let seen: Vec<[f64; 2]> = places.map(|y| [y, board.scene.at(MIDDLE as f64 + 0.5 * step, y)]).collect();
    let runs = seen.chunk_by(|a, b| a[1] == b[1]);
    let longest = runs.max_by_key(|run| run.len()).unwrap_or_default();
    match (longest.first(), longest.last()) {
        (Some(first), Some(last)) => [first[0] - 0.5 * step, last[0] + 0.5 * step],
        _ => [f64::NAN; 2],
    }
}

fn uniform(n: usize) -> Result<Figure> {
    let board = Board::new()?;
    let point = board.sampled(&Regular::new([1, 1])?, 0)?;
    let means = board.sampled(&Regular::new([n, n])?, 0)?;
    let [one, many] = [&point, &means].map(|image| board.error(image, ROWS));
    let ghost = |m: usize| Layer::horizontals("ghost", Meaning::Leaked, [ghost_row(m)]).dashed();
    let title = |n: usize, error: f64| match n {
        1 => text!("1 sample, error {}", "1 отсчёт, ошибка {}", number(error, 3)),
        _ => text!("{0} × {0}, error {1}", "{0} × {0}, ошибка {1}", n, number(error, 3)),
    };
    let contrast = |image: &Image, j: usize| (image.at(MIDDLE, j) - 0.5).abs();
    let excess = |j: &usize| contrast(&means, *j) - contrast(&board.exact, *j);
    let falsest = ROWS.max_by(|a, b| excess(a).total_cmp(&excess(b))).unwrap_or_default();
    let mut figure = Figure::new(2)
        .heights([1.0, 0.72])
        .with(shown("point", title(1, one), &point, SHOWN)?.with(outline()))
        .with(shown("uniform", title(n, many), &means, SHOWN)?.with(outline()))
        .with(enlarged("point-far", &point)?.with(ghost(1)))
        .with(enlarged("uniform-far", &means)?.with(ghost(n)))
        .claim(
            text!(
                "root mean square errors to exact area: {} by one sample, {} by {} × {}",
                "среднеквадратичная ошибка относительно точной площади: {} для одного отсчёта, {} для {} × {}",
                number(one, 4),
                number(many, 3),
                n,
                n
            ),
            Residual::at_most("error of n × n samples, as a part of that of one", many / one, 1.0),
        )
        .claim(
            text!(
                "an edge would gain a factor {n} from {n} × {n} samples; the picture gains only {}: its ghosts stay",
                "на одном крае {n} × {n} отсчётов дали бы выигрыш {n}; у картинки он лишь {}: узоры остаются",
                number(one / many, 3)
            ),
            Residual::at_least("n times the error of n × n samples", n as f64 * many, one),
        );
    for m in [1, n, 2 * n] {
        let (row, [from, to]) = (ghost_row(m), longest_run(&board, m));
        figure = figure.claim(
            text!(
                "{m} samples a pixel: expected at row {}; the longest run of equal samples goes from row {} to {}",
                "отсчётов на сторону пикселя {m}: ложный узор ожидается в строке {}; самая длинная серия равных — от {} до {}",
                number(row, 3),
                number(from, 3),
                number(to, 3)
            ),
            Residual::at_most("the ghost's row, outside the longest run", (from - row).max(row - to), 0.0),
        );
    }
    Ok(figure.claim(
        text!(
            "of the picture of {n} × {n} samples, pixel row {falsest} is the falsest: it covers rows {falsest} to {}",
            "в картинке {n} × {n} отсчётов сильнее всех врёт строка пикселей {falsest}, от {falsest} до {}",
            falsest + 1
        ),
        // half a pixel from its middle to its edge
        Residual::near("row with most false contrast", falsest as f64 + 0.5, ghost_row(n), 0.5 + ghost_height(n)),
    ))
}

const AREA: Entry = Entry {
    id: "f36-exact-area",
    inventory: &["F36"],
    errata: &["E13"],
    title: &Text::fixed("Exact area and uniform supersampling", "Точная площадь и равномерный супер-сэмплинг"),
    caption: &Text::fixed(
        "Exact area has no ghosts of the samples' rate: far away it is grey. But it is a box filter and no more. In the \
         first rows beyond Nyquist (left of the dashed line in the chart) the squares are still seen, dimmed and partly \
         inverted: a tone at 0.9 of the rate keeps 0.11.",
        "У точной площади нет ложных узоров с частотой отсчётов: вдали она серая. Но это бокс-фильтр, и только. В первых \
         строках за Найквистом (слева от пунктира на графике) клетки ещё видны, ослабленные и частью вывернутые: от тона \
         на 0,9 частоты дискретизации остаётся 0,11.",
    ),
    params: &[Param::count("n", &COUNT, 4, 2, 8)],
    build: |params| area(params.count("n")),
};

/// How many samples are counted in a pixel across and down, by brute force.
const COUNTED: usize = 1500;

/// The mean of the square wave `q(f/y)` of the middle line over `y0..y1`, square by square.
fn mean_of_squares(y0: f64, y1: f64) -> f64 {
    let focal = 0.5 * SIDE as f64;
    let (first, last) = ((focal / y1).floor() as u32, (focal / y0).ceil() as u32);
    let signed = (first..last).map(|k| {
        let (far, near) = ((focal / f64::from(k + 1)).max(y0), (focal / f64::from(k)).min(y1));
        (near - far).max(0.0) * if k % 2 == 0 { 1.0 } else { -1.0 }
    });
    signed.sum::<f64>() / (y1 - y0)
}

fn area(n: usize) -> Result<Figure> {
    let board = Board::new()?;
    let means = board.sampled(&Regular::new([n, n])?, 0)?;
    let error = board.error(&means, ROWS);
    let far_error = board.error(&means, NEAR_HORIZON.start + 1..NEAR_HORIZON.end);

    // down the middle: what a pixel would be wherever it stood, and what the pixels are
    let end = 20.0;
    let middle = [MIDDLE as f64, MIDDLE as f64 + 1.0];
    let slid = |y: f64| board.scene.mean(middle, [y - 0.5, y + 0.5]);
    let pixels = |image: &Image| -> Vec<[f64; 2]> {
        ROWS.map(|j| [j as f64 + 0.5, image.at(MIDDLE, j)]).filter(|p| p[0] < end).collect()
    };
    let exact_pixels = pixels(&board.exact);
    let nyquist = ghost_row(1) * 2f64.sqrt();
    let column = Panel::new(
        "column",
        text!("down the middle", "вдоль середины"),
        Scale::linear(text!("row", "строка"), 0.0, end),
        values("", -0.1, 1.1),
    )
    .legend(Legend::Above)
    .with(Layer::verticals("nyquist", Meaning::Guide, [nyquist]).dashed())
    .with(Layer::curve("area", Meaning::Signal, 1.5, end, 740, slid).label(text!("exact", "точно")))
    .with(Layer::dots("exact", Meaning::Signal, exact_pixels.clone()))
    .with(Layer::dots("uniform", Meaning::Leaked, pixels(&means)).label(text!("{n} × {n}", "{n} × {n}")));

    // every mean is a sum of some 2·64/y² pieces, each rounded to a few ε of its place
    let rounding = 256.0 * f64::EPSILON * SIDE as f64;
    let known = |y: f64| 0.5 - 0.5 * mean_of_squares(y - 0.5, y + 0.5);
    let worst = exact_pixels.iter().map(|p| (p[1] - known(p[0])).abs()).fold(0.0, f64::max);
    let beyond = exact_pixels.iter().filter(|p| p[0] + 0.5 <= nyquist);
    let lowest = |p: &[f64; 2]| 0.25 * SIDE as f64 / (p[0] + 0.5).powi(2);
    let grey = beyond.clone().map(|p| (p[1] - 0.5).abs() * 4.0 * lowest(p)).fold(0.0, f64::max);
    let strongest =
        beyond.max_by(|a, b| (a[1] - 0.5).abs().total_cmp(&(b[1] - 0.5).abs())).copied().unwrap_or([0.5; 2]);
    let counted = [[60.0, 32.0], [3.0, 21.0], [90.0, 12.0], [64.0, 9.0], [127.0, 5.0]].map(|[x, y]| {
        let cell = [[x, x + 1.0], [y, y + 1.0]];
        mean_by_counting(&board.scene, cell, COUNTED, edges_of_checkerboard(&board.scene, cell), 0.0)
    });
    let counted = counted.into_iter().collect::<Result<Vec<_>>>()?;
    let parts = counted.iter().map(|r| r.measured / r.bound).fold(0.0, f64::max);
    let off = counted.iter().map(|r| r.measured).fold(0.0, f64::max);
    Ok(Figure::new(2)
        .heights([1.04, 0.76, 0.96])
        .with(shown("exact", text!("exact area", "точная площадь"), &board.exact, UPPER)?.with(outline()))
        .with(shown("uniform", text!("{n} × {n} samples", "отсчёты {n} × {n}"), &means, UPPER)?.with(outline()))
        .with(enlarged("exact-far", &board.exact)?)
        .with(enlarged("uniform-far", &means)?)
        .with(column.span(2))
        .claim(
            text!(
                "brute force, {COUNTED} × {COUNTED} samples in each of five pixels, agrees to {}",
                "перебор, {COUNTED} × {COUNTED} отсчётов в каждом из пяти пикселей, совпадает до {}",
                number(off, 1)
            ),
            Residual::at_most("differences to counted samples, in bounds of counting", parts, 1.0),
        )
        .claim(
            text!(
                "down the middle exact area is the mean of the square wave q(f/y), square by square",
                "вдоль середины точная площадь равна среднему меандра q(f/y), сосчитанному по клеткам"
            ),
            Residual::at_most("exact pixels = sums over squares", worst, rounding),
        )
        .claim(
            text!(
                "towards the horizon exact area goes to grey as 1/4ν, without a ghost at the samples' rate",
                "к горизонту точная площадь переходит в серый как 1/4ν, без ложного узора на частоте отсчётов"
            ),
            // alternating squares that grow downwards: their sum is at most the last, half a period of 1/2ν
            Residual::at_most("|v − ½|·4ν beyond Nyquist, ν the pixel's lowest frequency", grey, 1.0),
        )
        .claim(
            text!(
                "exact area is a box: row {} is beyond Nyquist and still {} where grey is 0.5",
                "точная площадь — бокс-фильтр: строка {} за Найквистом, а значение в ней {} вместо серого 0,5",
                number(strongest[0] - 0.5, 2),
                number(strongest[1], 3)
            ),
            Residual::near("strongest row beyond Nyquist", strongest[1], known(strongest[0]), rounding),
        )
        .claim(
            text!(
                "of a tone at 0.9 of the rate it keeps {}",
                "от тона на 0,9 частоты дискретизации остаётся {}",
                number(sinc(0.9), 4)
            ),
            area_gain(9, 10, sinc(0.9))?,
        )
        .claim(
            text!(
                "{n} × {n} samples are {} off in all rows, and {} in the fifteen nearest to the horizon",
                "{n} × {n} отсчётов ошибаются на {} в среднем, а в пятнадцати строках у горизонта — на {}",
                number(error, 4),
                number(far_error, 3)
            ),
            Residual::at_least("error near the horizon / error in all rows", far_error / error, 1.0),
        ))
}
