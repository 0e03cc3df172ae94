//! Highlights sparkle (slide «Проблемы сэмплирования в компьютерной графике»).

use crate::error::Result;
use crate::figure::common::values;
use crate::figure::params::{Param, Params};
use crate::figure::picture::picture;
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::grid::Grid;
use crate::image::Image;
use crate::image::dft::forward;
use crate::num::random::uniform;
use crate::num::{cos_pi, sin_pi};
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};

static POWER: Text = Text::fixed("exponent p of the highlight", "показатель p блика");
static SEED: Text = Text::fixed("seed of the bumps", "начальное число рельефа");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[HIGHLIGHTS];

const HIGHLIGHTS: Entry = Entry {
    id: "f03-highlights",
    inventory: &["F03"],
    errata: &[],
    title: &Text::fixed("Sampling problems: highlights sparkle", "Проблемы сэмплирования: мерцание бликов"),
    caption: &Text::fixed(
        "A bumpy mirror, max(0, n·h)^{p}, whose highlights are narrower than a pixel, in three frames of a slow motion. \
         One sample a pixel: each frame finds other highlights, and even the total sparkles. With the mean over pixels \
         the highlights stay, dimmer and still, and the total is constant.",
        "Бугристое зеркало, max(0, n·h)^{p}, с бликами уже пикселя, в трёх кадрах медленного движения. Один отсчёт на пиксель: в \
         каждом кадре находятся другие блики, и мерцает даже сумма. При усреднении по пикселям блики остаются на местах, \
         слабее и спокойно, а сумма постоянна.",
    ),
    params: &[Param::count("p", &POWER, 1500, 300, 3000), Param::count("seed", &SEED, 1, 1, 20)],
    build: highlights,
};

/// The picture's side in pixels; the surface has that period too, so that what leaves on one side comes in on the other.
const SIDE: usize = 48;
/// Places in a pixel, along each axis, at which the light is computed.
const FINE: usize = 16;
const WAVES: u64 = 7;
/// How far the surface moves from frame to frame, in those places.
const STEP: [usize; 2] = [3, 1];
const FRAMES: usize = 24;
/// The frames that are shown.
const SHOWN: [usize; 3] = [0, 2, 4];

/// The light of the surface at `SIDE·FINE` places a side.
fn light(power: usize, seed: u64) -> Result<Image> {
    let n = SIDE * FINE;
    // slopes are sums of waves of 5 to 9 pixels in all directions; each is separable
    let mut slopes = vec![[0.0f64; 2]; n * n];
    for wave in 0..WAVES {
        let turn = (wave as f64 + uniform(seed, wave, 0)) / WAVES as f64;
        let cycles = SIDE as f64 / (5.0 + 4.0 * uniform(seed, wave, 1));
        let [k, l] = [cos_pi(turn), sin_pi(turn)].map(|part| (cycles * part).round());
        let length = k.hypot(l);
        let phase = 2.0 * uniform(seed, wave, 2);
        let table = |cycles: f64, phase: f64| {
            let turns = (0..n).map(move |i| 2.0 * cycles * (i as f64 + 0.5) / n as f64 + phase);
            turns.map(|t| [cos_pi(t), sin_pi(t)]).collect::<Vec<_>>()
        };
        let (across, down) = (table(k, phase), table(l, 0.0));
        for (row, [cy, sy]) in slopes.chunks_exact_mut(n).zip(&down) {
            for (slope, [cx, sx]) in row.iter_mut().zip(&across) {
                let height = 0.17 * (cx * cy - sx * sy);
                slope[0] += height * k / length;
                slope[1] += height * l / length;
            }
        }
    }
    let h = [0.25, 0.15, 1.0];
    let size = h.iter().map(|c| c * c).sum::<f64>().sqrt();
    let shine = |[sx, sy]: &[f64; 2]| {
        let cosine = (h[2] - h[0] * sx - h[1] * sy) / (size * (1.0 + sx * sx + sy * sy).sqrt());
        cosine.max(0.0).powi(power as i32)
    };
    let step = 1.0 / FINE as f64;
    let across = 0.0..n as f64 * step;
    Image::new(Grid::cells(across.clone(), n, across, n)?, slopes.iter().map(shine).collect())
}

/// What the pixels show of the light when the surface has moved by `[across, down]` places: point samples and means.
fn pixels(light: &Image, [across, down]: [usize; 2]) -> Result<[Image; 2]> {
    let n = SIDE * FINE;
    let at = |i: usize, j: usize| light.at((i + n - across) % n, (j + n - down) % n);
    let grid = Grid::pixels(SIDE, SIDE)?;
    let every = |f: &dyn Fn(usize, usize) -> f64| {
        let values = (0..SIDE).flat_map(|j| (0..SIDE).map(move |i| (i * FINE, j * FINE))).map(|(i, j)| f(i, j));
        Image::new(grid, values.collect())
    };
    let mean = |i: usize, j: usize| {
        let sum: f64 = (0..FINE).flat_map(|b| (0..FINE).map(move |a| (a, b))).map(|(a, b)| at(i + a, j + b)).sum();
        sum / (FINE * FINE) as f64
    };
    Ok([every(&|i, j| at(i + FINE / 2, j + FINE / 2))?, every(&mean)?])
}

fn highlights(params: &Params) -> Result<Figure> {
    let light = light(params.count("p"), params.count("seed") as u64)?;
    let mut frames = Vec::with_capacity(FRAMES);
    for k in 0..FRAMES {
        frames.push(pixels(&light, STEP.map(|step| step * k))?);
    }
    let mean = light.mean();
    let totals = |way: usize| -> Vec<[f64; 2]> {
        frames.iter().enumerate().map(|(k, f)| [k as f64, f[way].mean() / mean]).collect()
    };
    let [point, area] = [totals(0), totals(1)];
    let top = 1.15 * point.iter().map(|p| p[1]).fold(1.0, f64::max);
    let chart = |name, title, layer: Layer| {
        let along = Scale::linear(text!("frame", "кадр"), -0.5, FRAMES as f64 - 0.5);
        Panel::new(name, title, along, values("", 0.0, top))
            .legend(Legend::Above)
            .with(Layer::horizontals("mean", Meaning::Guide, [1.0]).dashed())
            .with(layer)
    };
    let total = || text!("total", "сумма");
    let names = [["point-0", "point-1", "point-2"], ["area-0", "area-1", "area-2"]];
    let row = |figure: Figure, way: usize| {
        SHOWN.iter().zip(names[way]).fold(figure, |figure, (&k, name)| {
            let title = match way {
                0 => text!("point, frame {k}", "точки, кадр {k}"),
                _ => text!("area, frame {k}", "площадь, кадр {k}"),
            };
            figure.with(picture(name, title, &frames[k][way]))
        })
    };
    let figure = row(Figure::new(4), 0);
    let figure = figure.with(chart("point-total", total(), Layer::line("point", Meaning::Leaked, point).thick()));
    let figure = row(figure, 1);
    let figure =
        figure.with(chart("area-total", total(), Layer::line("area", Meaning::Reconstructed, area.clone()).thick()));

    // all places that a sample can have in its pixel
    let n = SIDE * FINE;
    let sampled = |a: usize, b: usize| {
        let all = (0..SIDE).flat_map(|j| (0..SIDE).map(move |i| (i * FINE + a, j * FINE + b)));
        all.map(|(i, j)| light.at(i, j)).sum::<f64>() / (SIDE * SIDE) as f64
    };
    let places: Vec<f64> = (0..FINE).flat_map(|b| (0..FINE).map(move |a| (a, b))).map(|(a, b)| sampled(a, b)).collect();
    let unbiased = places.iter().sum::<f64>() / places.len() as f64;
    let variance = places.iter().map(|p| (p - mean) * (p - mean)).sum::<f64>() / places.len() as f64;
    // V12: the lines of the light at multiples of the sampling rate fold onto zero
    let bins = forward(&light);
    let orders = -(FINE as i64) / 2..FINE as i64 / 2;
    let lines = orders.clone().flat_map(|l| orders.clone().map(move |k| [k, l])).filter(|o| *o != [0, 0]);
    let period = (SIDE * SIDE) as f64; // the area of the picture: its integral over it is the mean
    let folded: f64 = lines.map(|[k, l]| (bins.bin(k * SIDE as i64, l * SIDE as i64) / period).norm_sqr()).sum();
    let still = area.iter().map(|p| (p[1] - 1.0).abs()).fold(0.0, f64::max);
    // sums of n² positive numbers, pairwise or not
    let rounding = f64::EPSILON * (n * n) as f64;
    Ok(figure
        .claim(
            text!(
                "one sample a pixel: the total sparkles by σ = {} % of its mean, the lines that fold onto zero",
                "один отсчёт на пиксель: сумма мерцает на σ = {} % от среднего; это линии, попавшие в нуль",
                number(100.0 * variance.sqrt() / mean, 3)
            ),
            Residual::near(
                "variance of the total = power at the multiples of the rate",
                variance / (mean * mean),
                folded / (mean * mean),
                2.0 * rounding,
            ),
        )
        .claim(
            text!(
                "on average over all places of the samples nothing is lost",
                "в среднем по всем положениям отсчётов ничего не теряется"
            ),
            Residual::near("mean of the totals = light", unbiased / mean, 1.0, 2.0 * rounding),
        )
        .claim(
            text!(
                "means over pixels: the total is the same in every frame",
                "средние по пикселям: сумма одна во всех кадрах"
            ),
            Residual::at_most("total of means − light", still, 2.0 * rounding),
        ))
}
