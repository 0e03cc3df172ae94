//! Jittered sampling (slide «Jittered Sampling»), and the tone that is sampled so.

use crate::beyond::jitter::{Jitter, JitteredComb};
use crate::error::Result;
use crate::figure::common::{frequency, space};
use crate::figure::params::{Param, Params};
use crate::figure::remedy::stochastic::{DEVIATIONS, PATTERNS, SEED, averaged, powers, worst_deviation};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::laws::jitter::{deviations, displayed_on_the_grid, jitter_spectrum, jittered_tone};
use crate::nyquist::fold;
use crate::residual::Residual;
use crate::signal::Signal;
use crate::signal::tone::Cosine;
use crate::spectrum::{Impulse, Spectrum};
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[JITTER, TONE];

static AMOUNT: Text = Text::fixed("amount of jitter, in steps", "величина джиттера, в шагах");
static CYCLES: Text = Text::fixed("periods of the tone per 40 samples", "периодов синусоиды на 40 отсчётов");

const JITTER: Entry = Entry {
    id: "f39-jitter",
    inventory: &["F39"],
    errata: &["E11", "E32"],
    title: &Text::fixed("Jittered sampling", "Сэмплирование с джиттером"),
    caption: &Text::fixed(
        "Every place of the comb is moved at random within its cell. The lines of the regular comb give their power to \
         noise, P(ν) = 1 − sinc²(aν): almost none at low frequencies, all of it beyond the rate. With a = 1 only the line \
         at zero is left. (A popular book prints the same curve over angular frequencies: at ν = ½ the floor is 0.59.)",
        "Каждая позиция гребня случайно сдвигается в пределах своей ячейки. Линии регулярного гребня отдают мощность \
         шуму, P(ν) = 1 − sinc²(aν): на низких частотах его почти нет, за частотой дискретизации он весь. При a = 1 \
         остаётся только линия в нуле. (В известной книге ось угловая: на самом деле при ν = ½ уровень шума 0,59.)",
    ),
    params: &[Param::real("a", &AMOUNT, 1.0, 0.05, 1.0, ""), Param::count("seed", &SEED, 1, 1, 100)],
    build: |params| jitter(params),
};

/// Power densities and weights of lines on one scale.
fn power_scale(top: f64) -> Scale {
    Scale::linear(text!("power", "мощность"), 0.0, top)
}

fn jitter(params: &Params) -> Result<Figure> {
    const COUNT: usize = 32;
    const ORDER: usize = 3;
    let (amount, seed) = (params.real("a"), params.count("seed") as u64);
    let regular = JitteredComb::new(1.0, Jitter::None)?;
    let comb = JitteredComb::new(1.0, Jitter::Uniform { width: amount })?;
    let moved = comb.positions(JitteredComb::pattern_seed(seed, 0), COUNT);
    let mean = comb.mean_periodogram(seed, COUNT, PATTERNS, ORDER);

    let (from, to): (Vec<f64>, Vec<f64>) =
        regular.positions(seed, COUNT).into_iter().zip(moved).filter(|(from, _)| *from < 12.0).unzip();
    let cells = from.iter().map(|&k| [k - 0.5 * amount, k + 0.5 * amount]);
    let places = Panel::new("places", Text::EMPTY, space(-1.0, 12.0), Scale::linear(Text::EMPTY, -0.4, 1.4).bare())
        .span(2)
        .legend(Legend::Above)
        .with(
            Layer::spans("cells", Meaning::Kernel, cells.step_by(2))
                .label(text!("its cell (every other)", "её ячейка (через одну)")),
        )
        .with(Layer::pointers("moves", Meaning::Guide, from.iter().zip(&to).map(|(&k, &x)| [[k, 1.0], [x, 0.0]])))
        .with(
            Layer::dots("regular", Meaning::Replica, from.iter().map(|&k| [k, 1.0]))
                .label(text!("regular place", "регулярная позиция")),
        )
        .with(
            Layer::dots("jittered", Meaning::Samples, to.iter().map(|&x| [x, 0.0]))
                .label(text!("jittered", "с джиттером")),
        );

    let shown = 2.3;
    let lines = regular.power_spectrum(2)?;
    let lines = lines.lines().iter().map(|l| [l.at, l.weight.re]);
    let before = Panel::new(
        "before",
        text!("power: regular", "мощность: регулярно"),
        frequency(-shown, shown),
        power_scale(1.2),
    )
    .legend(Legend::Above)
    .with(Layer::arrows("lines", Meaning::Replica, lines).label(text!("lines", "линии")));
    // at a line the power is noise + φ²·n in the mean, that is 1 + (n − 1)φ²
    let weight = |k: usize| (mean[k * COUNT][1] - 1.0) / (COUNT - 1) as f64;
    let measured_lines = (-2..=2i64).map(|k| [k as f64, weight(k.unsigned_abs() as usize)]);
    let floor = (1..mean.len()).filter(|m| m % COUNT != 0).map(|m| mean[m]);
    let dots = floor.flat_map(|[nu, power]| [[nu, power], [-nu, power]]).filter(|p| p[0].abs() < shown - 0.08);
    let after =
        Panel::new("after", text!("power: jittered", "мощность: джиттер"), frequency(-shown, shown), power_scale(1.2))
            .legend(Legend::Above)
            .with(
                Layer::dots("noise", Meaning::Samples, dots)
                    .label(text!("mean of {PATTERNS}", "среднее по {PATTERNS}")),
            )
            .with(
                Layer::curve("theory", Meaning::Theory, -shown, shown, 400, |nu| comb.noise(nu))
                    .thick()
                    .label(Text::same("1 − sinc²(aν)")),
            )
            .with(Layer::arrows("residual", Meaning::Replica, measured_lines));

    let (line, under) = (comb.characteristic(1.0).powi(2), comb.noise(1.0));
    // the line beats with the noise under it, 2√(n·φ²·P), and the noise deviates by √(2P² + 4P/n), both over (n − 1)√R
    let count = COUNT as f64;
    let beat = 2.0 * (count * line * under).sqrt() + (2.0 * under * under + 4.0 * under / count).sqrt();
    let allowed = deviations(1) * beat / ((count - 1.0) * f64::from(PATTERNS).sqrt()) + 1e-12;
    Ok(Figure::new(2)
        .heights([0.55, 1.0])
        .with(places)
        .with(before)
        .with(after)
        .claim(
            text!(
                "the noise follows 1 − sinc²(aν): {} at ν = ½, theory {}",
                "шум следует кривой 1 − sinc²(aν): {} при ν = ½, теория {}",
                number(mean[COUNT / 2][1], 2),
                number(comb.noise(0.5), 4)
            ),
            jitter_spectrum(&comb, &comb, seed, COUNT, PATTERNS, ORDER),
        )
        .claim(
            match line {
                0.0 => text!("the line at the rate is gone", "линия на частоте дискретизации исчезла"),
                _ => text!(
                    "of the line at the rate sinc²(a) = {} is left",
                    "от линии на частоте дискретизации осталось sinc²(a) = {}",
                    number(line, 4)
                ),
            },
            Residual::near("weight of the line at the rate = sinc²(a)", weight(1), line, allowed),
        ))
}

const TONE: Entry = Entry {
    id: "f39-tone",
    inventory: &["F39"],
    errata: &["E11"],
    title: &Text::fixed("A tone above Nyquist, sampled three ways", "Синусоида выше Найквиста: три способа"),
    caption: &Text::fixed(
        "Regular samples fold the tone into a false one. Jittered samples, left at their places, keep the tone and turn \
         the alias into noise that grows with the distance from the tone. But an image shows every value at its pixel's \
         centre: then part of the alias stays, and the noise is white, not high-frequency.",
        "Регулярные отсчёты превращают синусоиду в ложную. Отсчёты с джиттером на своих местах сохраняют её, а алиас \
         становится шумом, растущим с удалением от неё. Но изображение показывает значения в центрах пикселей: тогда часть \
         алиаса остаётся, а шум — белый, а не высокочастотный.",
    ),
    params: &[
        Param::count("cycles", &CYCLES, 26, 21, 39),
        Param::real("a", &AMOUNT, 1.0, 0.05, 1.0, ""),
        Param::count("seed", &SEED, 1, 1, 100),
    ],
    build: |params| tone(params),
};

fn tone(params: &Params) -> Result<Figure> {
    const COUNT: usize = 40;
    let (cycles, amount, seed) = (params.count("cycles"), params.real("a"), params.count("seed") as u64);
    let at = |m: usize| m as f64 / COUNT as f64;
    let nu = at(cycles);
    let tone = Cosine::new(nu)?;
    let comb = JitteredComb::new(1.0, Jitter::Uniform { width: amount })?;
    let regular = JitteredComb::new(1.0, Jitter::None)?;
    let placed = averaged(|pattern| {
        let positions = comb.positions(JitteredComb::pattern_seed(seed, pattern), COUNT);
        powers(&positions.into_iter().map(|x| [x, tone.at(x)]).collect::<Vec<_>>(), COUNT, 1)
    });
    let displayed = displayed_on_the_grid(&comb, seed, COUNT, PATTERNS, cycles)?;

    // the tone's power is a line of ¼ on either side; with independent places powers are convolved, in the mean
    let own = Spectrum::of_lines([Impulse::new(-nu, 0.25), Impulse::new(nu, 0.25)])?;
    let of_regular = own.convolved(&regular.power_spectrum(2)?)?;
    let of_placed = own.convolved(&comb.power_spectrum(2)?)?;
    let kept = comb.characteristic(nu).powi(2);
    let lost = 0.5 * (1.0 - kept);

    let alias = fold(nu, 1.0);
    let lines = lines_of(&of_regular);
    // at a line n times its weight stands on top of the noise
    let weight = |m: usize| (placed[m].value - of_placed.density(at(m)).re) / COUNT as f64;
    let in_place: Vec<[f64; 2]> =
        lines_of(&of_placed).iter().map(|line| [line[0], weight((line[0] * COUNT as f64).round() as usize)]).collect();
    let in_pixels = [[alias, displayed.line], [nu, displayed.line]];
    let noise = |power: &dyn Fn(usize) -> f64| -> Vec<[f64; 2]> {
        let all = (0..=COUNT).map(|m| [at(m), power(m)]);
        all.filter(|p| p[1].is_finite() && !lines.iter().any(|line| near(line[0], p[0]))).collect()
    };
    let views = [
        View {
            name: "regular", title: text!("regular", "регулярно"), lines: &lines, noise: vec![], theory: &|_| 0.0
        },
        View {
            name: "placed",
            title: text!("jittered, in place", "джиттер, на местах"),
            lines: &in_place,
            noise: noise(&|m| placed[m].value),
            theory: &|nu| of_placed.density(nu).re,
        },
        View {
            name: "displayed",
            title: text!("jittered, in pixels", "джиттер, в пикселях"),
            lines: &in_pixels,
            noise: noise(&|m| displayed.bins[m % COUNT]),
            theory: &|_| lost,
        },
    ];

    let expected = |m: usize| {
        let line = lines_of(&of_placed).into_iter().filter(|l| near(l[0], at(m))).map(|l| l[1]).sum::<f64>();
        of_placed.density(at(m)).re + COUNT as f64 * line
    };
    let worst = worst_deviation(placed.iter().enumerate().map(|(m, &mean)| (mean, expected(m))));
    let [line, power, white] = jittered_tone(&comb, &comb, seed, COUNT, PATTERNS, cycles)?;
    let figure = views.iter().fold(Figure::new(3), |figure, view| figure.with(view.panel(nu)));
    Ok(figure
        .claim(
            text!(
                "in place: the noise is P(ν − ν₀)/4 + P(ν + ν₀)/4, {} where the alias stood",
                "на местах: шум равен P(ν − ν₀)/4 + P(ν + ν₀)/4, на месте алиаса {}",
                number(of_placed.density(alias).re, 3)
            ),
            Residual::at_most("power of the jittered tone, in standard errors", worst, DEVIATIONS),
        )
        .claim(
            text!(
                "in pixels: the alias keeps sinc²(aν₀) = {} of its power",
                "в пикселях: алиас сохраняет sinc²(aν₀) = {} мощности",
                number(kept, 3)
            ),
            line,
        )
        .claim(
            text!(
                "in pixels: the rest, {} of ½, has become noise: nothing is removed",
                "в пикселях: остальное, {} из ½, стало шумом: ничего не удалено",
                number(lost, 3)
            ),
            power,
        )
        .claim(text!("in pixels: this noise is white", "в пикселях: этот шум белый"), white))
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}

/// Places and weights of the lines between zero and the rate.
fn lines_of(spectrum: &Spectrum) -> Vec<[f64; 2]> {
    let all = spectrum.lines().iter().map(|l| [l.at, l.weight.re]);
    all.filter(|p| p[0] > 0.0 && p[0] < 1.0).collect()
}

/// The power of the tone sampled in one way: its lines, and the noise beside what theory says of it.
struct View<'a> {
    name: &'static str,
    title: Text,
    lines: &'a [[f64; 2]],
    noise: Vec<[f64; 2]>,
    theory: &'a dyn Fn(f64) -> f64,
}

impl View<'_> {
    fn panel(&self, nu: f64) -> Panel {
        let mut panel = Panel::new(self.name, self.title.clone(), frequency(-0.04, 1.04), power_scale(0.6))
            .legend(Legend::Above)
            .with(Layer::verticals("nyquist", Meaning::Guide, [0.5]).dashed());
        if !self.noise.is_empty() {
            panel = panel
                .with(Layer::dots("noise", Meaning::Samples, self.noise.iter().copied()).label(text!("noise", "шум")))
                .with(Layer::curve("theory", Meaning::Theory, 0.0, 1.0, 200, self.theory));
        }
        let (own, others): (Vec<[f64; 2]>, Vec<[f64; 2]>) = self.lines.iter().partition(|p| near(p[0], nu));
        panel = panel.with(Layer::arrows("own", Meaning::Signal, own).thick().label(text!("tone", "тон")));
        if others.is_empty() {
            return panel;
        }
        panel.with(Layer::arrows("alias", Meaning::Leaked, others).thick().label(text!("alias", "алиас")))
    }
}
