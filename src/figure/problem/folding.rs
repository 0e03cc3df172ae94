//! Frequencies fold (slide «"Заворачивание" частот»).

use crate::axis::Axis;
use crate::comb::{Comb, sample};
use crate::error::Result;
use crate::figure::common::{PIECES, unmarked, values};
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale, Tones};
use crate::num::{cos_pi, sin_pi};
use crate::nyquist::{Alias, fold};
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::sampled::power::periodogram;
use crate::sampled::window::Window;
use crate::signal::lecture::LectureChirp;
use crate::signal::tone::Cosine;
use crate::signal::{Signal, from_fn};
use crate::text;
use crate::text::{Text, number};
use ndarray::Array2;
use num_complex::Complex;
use std::f64::consts::PI;

static RATE: Text = Text::fixed("sampling rate f_{s}", "частота дискретизации f_{s}");
static TONE: Text = Text::fixed("frequency of the tone on the circle", "частота тона на окружности");
static SLOW: Text = Text::fixed("how many times the chirp is slowed down", "во сколько раз замедлен ЛЧМ-сигнал");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[FOLDING];

const FOLDING: Entry = Entry {
    id: "f08-folding",
    inventory: &["F08"],
    errata: &[],
    title: &Text::fixed("Frequencies fold", "«Заворачивание» частот"),
    caption: &Text::fixed(
        "Between two samples a tone turns by 2πf/f_{s}; a turn by the rest of the circle, the other way round, ends at the \
         same point, so f and f_{s} − f cannot be told apart. Measured frequencies of sampled tones therefore run up to \
         f_{s}/2, down to zero and up again, and so does a chirp sampled too slowly (the lecture's \
         1 + cos 4πx², slowed down to let its ridge be narrow).",
        "Между двумя отсчётами тон поворачивается на 2πf/f_{s}; поворот на остаток круга в обратную сторону кончается в \
         той же точке, и f не отличить от f_{s} − f. Поэтому измеренная частота отсчётов растёт до f_{s}/2, падает до нуля \
         и растёт снова; то же делает ЛЧМ-сигнал при слишком редкой дискретизации (1 + cos 4πx² из \
         лекции, замедленный ради узкого гребня).",
    ),
    params: &[
        Param::real("rate", &RATE, 8.0, 6.0, 16.0, ""),
        Param::real("f", &TONE, 7.0, 0.5, 12.0, ""),
        Param::real("slow", &SLOW, 2.0, 1.0, 4.0, ""),
    ],
    build: folding,
};

fn folding(params: &Params) -> Result<Figure> {
    let (rate, f) = (params.real("rate"), params.real("f"));
    let (curve, curve_claims) = triangle(rate)?;
    let (circle, apart) = circle(f, rate)?;
    let (ridge, ridge_claim) = spectrogram(rate, params.real("slow"))?;
    let figure = Figure::new(3).heights([1.25, 1.0]).with(curve).with(circle).with(ridge);
    let figure = curve_claims.into_iter().fold(figure, |figure, (says, residual)| figure.claim(says, residual));
    let alias = Alias::of(f, rate)?;
    Ok(figure
        .claim(
            text!(
                "steps of {}° and of {}° end at the same point of the circle",
                "шаги на {}° и на {}° кончаются в одной точке окружности",
                number(360.0 * f / rate, 4),
                number(360.0 * alias.signed() / rate, 4)
            ),
            // both angles are quotients, each off by ε/2 of itself, times 2π
            Residual::at_most("f and its alias step alike", apart, 4.0 * PI * f64::EPSILON * (1.0 + f / rate)),
        )
        .claim(ridge_claim.0, ridge_claim.1))
}

type Says = (Text, Residual);

/// The folding curve, and what is measured of tones sampled at that rate.
fn triangle(rate: f64) -> Result<(Panel, Vec<Says>)> {
    let bins = 128;
    let axis = Axis::new(0.0, 1.0 / rate, bins)?;
    let bin = rate / bins as f64;
    let tones = 36;
    let mut measured = Vec::with_capacity(tones);
    for j in 0..tones {
        // not on the multiples of f_s/2, where a cosine may vanish
        let f = 3.0 * rate * (j as f64 + 0.4) / tones as f64;
        let samples = Samples::of(&Cosine::new(f)?, axis);
        let powers = periodogram(&samples, Window::Hann);
        let strongest = powers.iter().fold([0.0, 0.0], |best, p| if p[1] > best[1] { *p } else { best });
        measured.push([f, strongest[0].abs()]);
    }
    let line = Layer::curve("folded", Meaning::Theory, 0.0, 3.0 * rate, 3 * 256, |f| fold(f, rate)).thick();
    let worst = measured.iter().map(|p| (p[1] - fold(p[0], rate)).abs()).fold(0.0, f64::max);
    let repeats = line.points().windows(257).map(|w| (w[256][1] - w[0][1]).abs()).fold(0.0, f64::max);
    let slopes = line.points().windows(2).map(|w| (w[1][1] - w[0][1]).abs() / (w[1][0] - w[0][0]));
    let slope = slopes.map(|s| (s - 1.0).abs()).fold(0.0, f64::max);
    let ticks = (0..=6).map(|i| {
        let name = ["0", "f_{s}/2", "f_{s}", "3f_{s}/2", "2f_{s}", "5f_{s}/2", "3f_{s}"][i];
        (0.5 * rate * i as f64, Text::same(name))
    });
    let x = Scale::linear(text!("frequency of the tone", "частота тона"), 0.0, 3.0 * rate).ticks(ticks);
    let y = Scale::linear(text!("frequency seen", "видимая частота"), 0.0, 0.58 * rate).ticks([
        (0.0, Text::same("0")),
        (0.25 * rate, Text::same("f_{s}/4")),
        (0.5 * rate, Text::same("f_{s}/2")),
    ]);
    let panel = Panel::new("folding", text!("the folding curve", "кривая заворачивания"), x, y)
        .legend(Legend::Above)
        .span(2)
        .with(line.label(text!("|f − f_{{s}}·round(f/f_{{s}})|", "|f − f_{{s}}·round(f/f_{{s}})|")))
        .with(Layer::dots("measured", Meaning::Samples, measured).label(text!("measured by DFT", "измерено по ДПФ")));
    let claims = vec![
        (
            text!(
                "the dominant DFT frequency of every sampled tone lies on the curve, within a bin of {}",
                "главная частота ДПФ каждого тона лежит на кривой с точностью до бина {}",
                number(bin, 3)
            ),
            // a bin to either side: half for the grid, half for the window's main lobe near 0 and f_s/2, where the line
            // at −f merges with that at f
            Residual::at_most("measured frequency = folded frequency", worst, bin),
        ),
        (
            text!("the curve has slopes ±1 and repeats after f_{{s}}", "наклоны кривой ±1, период f_{{s}}"),
            // a difference of frequencies up to 3f_s, each rounded, over a step of f_s/256
            Residual::at_most("slopes ±1, period f_s", slope.max(repeats / rate), 4.0 * 3.0 * 256.0 * f64::EPSILON),
        ),
    ];
    Ok((panel, claims))
}

/// The unit circle with the step of the tone and that of its alias, and how far apart they end.
fn circle(f: f64, rate: f64) -> Result<(Panel, f64)> {
    let signed = Alias::of(f, rate)?.signed();
    let on = |turns: f64, radius: f64| [radius * cos_pi(2.0 * turns), radius * sin_pi(2.0 * turns)];
    let arc = |step: f64, radius: f64, grow: f64| {
        let n = 200;
        (0..=n)
            .map(move |i| f64::from(i) / f64::from(n))
            .map(move |t| on(t * step / rate, radius + grow * t * step.abs() / rate))
    };
    let (long, short) = (on(f / rate, 1.0), on(signed / rate, 1.0));
    let apart = (long[0] - short[0]).hypot(long[1] - short[1]);
    let whole = (0..=200).map(|i| on(f64::from(i) / 200.0, 1.0));
    let alias_name = text!("alias {}", "алиас {}", number(signed, 3));
    let scale = || unmarked(-1.75, 1.75);
    let panel = Panel::new("circle", text!("a step between samples", "шаг между отсчётами"), scale(), scale())
        .square()
        .with(Layer::line("circle", Meaning::Guide, whole))
        .with(Layer::line("spokes", Meaning::Guide, [[1.0, 0.0], [0.0, 0.0], long]))
        .with(Layer::line("step", Meaning::Signal, arc(f, 1.12, 0.12)).thick())
        .with(Layer::line("alias", Meaning::Leaked, arc(signed, 0.8, 0.0)).thick())
        .with(Layer::dots("samples", Meaning::Samples, [[1.0, 0.0], long]))
        .with(Layer::notes("step-name", Meaning::Signal, [([0.0, 1.48], text!("f = {}", "f = {}", number(f, 3)))]))
        .with(Layer::notes("alias-name", Meaning::Leaked, [([0.0, -1.48], alias_name)]));
    Ok((panel, apart))
}

/// The spectrogram of the lecture's chirp `f(x/slow)` sampled at that rate, with the folded local frequency over it.
fn spectrogram(rate: f64, slow: f64) -> Result<(Panel, Says)> {
    // without its mean; the local frequency of f(x) is 4x
    let (chirp, sweep) = (from_fn(|x| LectureChirp.at(x / slow) - 1.0), 4.0 / (slow * slow));
    let end = rate / sweep * 2.0;
    let comb = Comb::new(1.0 / rate)?;
    // the window of e^{−x²/2s²} that shows a chirp of that sweep sharpest: 2π·sweep·s² = 1
    let s = (1.0 / (2.0 * PI * sweep)).sqrt();
    // the ridge is e^{−δ²/2w²} with w = √2/2πs: as wide as from −w to w
    let width = 2.0 * 2f64.sqrt() / (2.0 * PI * s);
    let beyond = 6.0 * s;
    let samples = sample(&chirp, comb, -(beyond * rate) as i64..=((end + beyond) * rate) as i64)?;
    let (columns, rows) = (240, 96);
    let top = 0.5 * rate;
    let at = |i: usize, n: usize, high: f64| high * (i as f64 + 0.5) / n as f64;
    let mut ridge = Vec::with_capacity(columns);
    let mut tones = Array2::zeros((rows, columns));
    for i in 0..columns {
        let x = at(i, columns, end);
        let near: Vec<[f64; 2]> = samples
            .points()
            .filter(|p| (p[0] - x).abs() < beyond)
            .map(|[at, v]| [at, v * (-0.5 * ((at - x) / s).powi(2)).exp()])
            .collect();
        let mut best = [0.0, 0.0];
        for j in 0..rows {
            let nu = at(j, rows, top);
            let sum: Complex<f64> = near.iter().map(|[at, v]| v * Complex::cis(-2.0 * PI * nu * at)).sum();
            let size = sum.norm() / rate / (s * (2.0 * PI).sqrt());
            tones[[j, i]] = size;
            if size > best[1] {
                best = [nu, size];
            }
        }
        ridge.push([x, best[0]]);
    }
    let strays = ridge.iter().map(|[x, nu]| (nu - fold(sweep * x, rate)).abs());
    let worst = strays.fold(0.0, f64::max);
    let most = tones.iter().copied().fold(0.0, f64::max);
    let panel = Panel::new(
        "spectrogram",
        text!("spectrogram of the sampled chirp", "спектрограмма отсчётов ЛЧМ-сигнала"),
        Scale::linear(Text::same("x"), 0.0, end),
        values("ν", 0.0, top),
    )
    .legend(Legend::Above)
    .span(3)
    .with(Layer::raster("power", (0.0, end), (0.0, top), tones, (0.0, most), Tones::Data))
    .with(
        Layer::curve("folded", Meaning::Theory, 0.0, end, PIECES, |x| fold(sweep * x, rate)).thick().dashed().label(
            match sweep {
                1.0 => text!("local frequency x, folded", "местная частота x, завёрнутая"),
                _ => text!("local frequency {}x, folded", "местная частота {}x, завёрнутая", number(sweep, 3)),
            },
        ),
    );
    let says = text!(
        "the ridge follows the folded local frequency, turning at {} and at zero, within its own width {}",
        "гребень следует завёрнутой местной частоте, поворачивая на {} и в нуле, в пределах своей ширины {}",
        number(top, 3),
        number(width, 3)
    );
    let law = "ridge of the spectrogram = folded local frequency";
    // where the chirp turns, the ridge interferes with its own mirror image, and the strongest place is between them or
    // beside them; away from the turns only the rows of the raster, half a row, are between measured and true
    Ok((panel, (says, Residual::at_most(law, worst, width))))
}
