//! Jittered sampling (slide «Jittered Sampling»), and the tone that is sampled so.

use crate::axis::Axis;
use crate::beyond::jitter::{Jitter, JitteredComb};
use crate::error::Result;
use crate::figure::common::{frequency, space};
use crate::figure::params::{Param, Params};
use crate::figure::stochastic::{DEVIATIONS, Mean, PATTERNS, SEED, averaged, powers, worst_deviation};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::nyquist::fold;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::sampled::dft::forward;
use crate::sampled::power::power;
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
    let positions = |pattern| comb.positions(JitteredComb::pattern_seed(seed, pattern), COUNT);
    let mean =
        averaged(|pattern| powers(&positions(pattern).iter().map(|&x| [x, 1.0]).collect::<Vec<_>>(), COUNT, ORDER));
    let at = |m: usize| m as f64 / COUNT as f64;

    let (from, to): (Vec<f64>, Vec<f64>) =
        regular.positions(seed, COUNT).into_iter().zip(positions(0)).filter(|(from, _)| *from < 12.0).unzip();
    let cells = from.iter().map(|&k| [k - 0.5 * amount, k + 0.5 * amount]);
    let places = Panel::new("places", Text::EMPTY, space(-1.0, 12.0), Scale::linear(Text::EMPTY, -0.4, 1.4).bare())
        .span(2)
        .legend(Legend::Above)
        .with(
            Layer::spans("cells", Meaning::Kernel, cells.step_by(2))
                .label(text!("every other cell", "ячейки через одну")),
        )
        .with(Layer::pointers("moves", Meaning::Guide, from.iter().zip(&to).map(|(&k, &x)| [[k, 1.0], [x, 0.0]])))
        .with(
            Layer::dots("regular", Meaning::Replica, from.iter().map(|&k| [k, 1.0]))
                .label(text!("regular places", "регулярные позиции")),
        )
        .with(
            Layer::dots("jittered", Meaning::Samples, to.iter().map(|&x| [x, 0.0]))
                .label(text!("jittered places", "позиции с джиттером")),
        );

    let shown = 2.3;
    let lines = |name, comb: &JitteredComb| -> Result<Layer> {
        let spectrum = comb.power_spectrum(2)?;
        Ok(Layer::arrows(name, Meaning::Replica, spectrum.lines().iter().map(|l| [l.at, l.weight.re])))
    };
    let before = Panel::new(
        "before",
        text!("power: regular", "мощность: регулярные"),
        frequency(-shown, shown),
        power_scale(1.2),
    )
    .legend(Legend::Above)
    .with(lines("lines", &regular)?.label(text!("lines", "линии")));
    // at a line the power is noise + φ²·n in the mean, that is 1 + (n − 1)φ²
    let weight = |k: usize| (mean[k * COUNT].value - 1.0) / (COUNT - 1) as f64;
    let measured_lines = (-2..=2i64).map(|k| [k as f64, weight(k.unsigned_abs() as usize)]);
    let floor = || (1..mean.len()).filter(|m| m % COUNT != 0);
    let dots = floor().flat_map(|m| [[at(m), mean[m].value], [-at(m), mean[m].value]]).filter(|p| p[0].abs() < shown);
    let after = Panel::new(
        "after",
        text!("power: jittered", "мощность: с джиттером"),
        frequency(-shown, shown),
        power_scale(1.2),
    )
    .legend(Legend::Above)
    .with(
        Layer::dots("noise", Meaning::Samples, dots)
            .label(text!("mean of {PATTERNS} patterns", "среднее по {PATTERNS}")),
    )
    .with(
        Layer::curve("theory", Meaning::Theory, -shown, shown, 400, |nu| comb.noise(nu))
            .thick()
            .label(Text::same("1 − sinc²(aν)")),
    )
    .with(Layer::arrows("residual", Meaning::Replica, measured_lines).label(text!("lines left", "остаток линий")));

    let noise = worst_deviation(floor().map(|m| (mean[m], comb.noise(at(m)))));
    let residual = |k: usize| comb.characteristic(k as f64).powi(2);
    let all_lines = worst_deviation((1..=ORDER).map(|k| (mean[k * COUNT], 1.0 + (COUNT - 1) as f64 * residual(k))));
    let nyquist = COUNT / 2;
    Ok(Figure::new(2)
        .heights([0.55, 1.0])
        .with(places)
        .with(before)
        .with(after)
        .claim(
            text!(
                "the noise follows 1 − sinc²(aν): {} at ν = ½, theory {}",
                "шум следует кривой 1 − sinc²(aν): {} при ν = ½, теория {}",
                number(mean[nyquist].value, 2),
                number(comb.noise(0.5), 4)
            ),
            Residual::at_most("mean power = 1 − sinc²(aν), in standard errors", noise, DEVIATIONS),
        )
        .claim(
            text!(
                "of the line at the rate sinc²(a) = {} is left",
                "от линии на частоте дискретизации осталось sinc²(a) = {}",
                number(residual(1), 4)
            ),
            Residual::at_most("weights of the lines = sinc²(ak), in standard errors", all_lines, DEVIATIONS),
        ))
}

const TONE: Entry = Entry {
    id: "f39-tone",
    inventory: &[],
    errata: &["E11", "E33"],
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
        Param::count("cycles", &CYCLES, 32, 21, 39),
        Param::real("a", &AMOUNT, 1.0, 0.05, 1.0, ""),
        Param::count("seed", &SEED, 1, 1, 100),
    ],
    build: |params| tone(params),
};

fn tone(params: &Params) -> Result<Figure> {
    const COUNT: usize = 40;
    let (cycles, amount, seed) = (params.count("cycles"), params.real("a"), params.count("seed") as u64);
    let nu = cycles as f64 / COUNT as f64;
    let tone = Cosine::new(nu)?;
    let comb = JitteredComb::new(1.0, Jitter::Uniform { width: amount })?;
    let regular = JitteredComb::new(1.0, Jitter::None)?;
    let positions = |pattern| comb.positions(JitteredComb::pattern_seed(seed, pattern), COUNT);
    let placed =
        averaged(|pattern| powers(&positions(pattern).iter().map(|&x| [x, tone.at(x)]).collect::<Vec<_>>(), COUNT, 1));
    let axis = Axis::new(0.0, 1.0, COUNT)?;
    let displayed = averaged(|pattern| {
        let values = positions(pattern).iter().map(|&x| tone.at(x)).collect();
        // the powers at 0..=½ and, mirrored, up to 1
        let half: Vec<f64> =
            power(&forward(&Samples::trusted(axis, values)))[..=COUNT / 2].iter().map(|p| p[1]).collect();
        half.iter().rev().chain(&half[1..]).copied().collect()
    });

    // the tone's power is a line of ¼ on either side; at independent places powers are convolved, in the mean
    let own = Spectrum::of_lines([Impulse::new(-nu, 0.25), Impulse::new(nu, 0.25)])?;
    let of_regular = own.convolved(&regular.power_spectrum(2)?)?;
    let of_placed = own.convolved(&comb.power_spectrum(2)?)?;
    let kept = comb.characteristic(nu).powi(2);
    let white = Spectrum::density_of(f64::INFINITY, move |_| (0.5 * (1.0 - kept)).into());
    let of_displayed = own.scaled(kept).replicated(1.0, 2)?.plus(&white);

    let regular_panel =
        Views { name: "regular", title: text!("regular", "регулярно"), theory: &of_regular, nu };
    let placed_panel =
        Views {
            name: "placed", title: text!("jittered, in place", "джиттер, на местах"), theory: &of_placed, nu
        };
    let displayed_panel = Views {
        name: "displayed",
        title: text!("jittered, in pixels", "джиттер, в пикселях"),
        theory: &of_displayed,
        nu,
    };
    let alias = fold(nu, 1.0);
    let off = |views: &Views<'_>, means: &[Mean]| {
        worst_deviation(means.iter().enumerate().map(|(m, &mean)| (mean, views.expected(m, COUNT))))
    };
    let residual_alias = 4.0 * of_displayed.lines().iter().find(|l| near(l.at, alias)).map_or(0.0, |l| l.weight.re);
    Ok(Figure::new(3)
        .with(regular_panel.panel(&[], COUNT))
        .with(placed_panel.panel(&placed, COUNT))
        .with(displayed_panel.panel(&displayed, COUNT))
        .claim(
            text!(
                "in place: the noise is P(ν − ν₀)/4 + P(ν + ν₀)/4, {} at the alias' place",
                "на местах: шум равен P(ν − ν₀)/4 + P(ν + ν₀)/4, на месте алиаса {}",
                number(of_placed.density(alias).re, 3)
            ),
            Residual::at_most(
                "power of the jittered tone, in standard errors",
                off(&placed_panel, &placed),
                DEVIATIONS,
            ),
        )
        .claim(
            text!(
                "in pixels: the alias keeps sinc²(aν₀) = {} of its power, the rest is white noise of {}",
                "в пикселях: алиас сохраняет sinc²(aν₀) = {} мощности, остальное — белый шум {}",
                number(residual_alias, 3),
                number(of_displayed.density(alias).re, 3)
            ),
            Residual::at_most(
                "power of the displayed tone, in standard errors",
                off(&displayed_panel, &displayed),
                DEVIATIONS,
            ),
        )
        .claim(
            text!(
                "in pixels no power is lost: line and noise together make ½",
                "в пикселях мощность не теряется: линия и шум вместе дают ½"
            ),
            Residual::at_most(
                "mean square of the displayed values is ½, in standard errors",
                worst_deviation([(total(&displayed), 0.5)]),
                DEVIATIONS,
            ),
        ))
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}

/// The power of all bins of one period, which is the mean square of the values.
fn total(bins: &[Mean]) -> Mean {
    let n = (bins.len() - 1) as f64;
    let whole = &bins[1..];
    Mean {
        value: whole.iter().map(|m| m.value).sum::<f64>() / n,
        // the bins of one period depend on each other: at worst their errors add up
        error: whole.iter().map(|m| m.error).sum::<f64>() / n,
    }
}

/// One way to sample the tone.
struct Views<'a> {
    name: &'static str,
    title: Text,
    theory: &'a Spectrum,
    nu: f64,
}

impl Views<'_> {
    /// The mean power at `m/n`: the noise, and `n` times the weight of a line that stands there.
    fn expected(&self, m: usize, n: usize) -> f64 {
        let at = m as f64 / n as f64;
        let lines = self.theory.lines().iter().filter(|l| near(l.at, at)).map(|l| l.weight.re);
        self.theory.density(at).re + n as f64 * lines.sum::<f64>()
    }

    fn panel(&self, means: &[Mean], n: usize) -> Panel {
        let lines = || self.theory.lines().iter().map(|l| [l.at, l.weight.re]).filter(|p| (0.0..=1.0).contains(&p[0]));
        let is_own = |p: &[f64; 2]| near(p[0], self.nu);
        let is_line = |at: f64| lines().any(|p| near(p[0], at));
        let dots =
            means.iter().enumerate().map(|(m, mean)| [m as f64 / n as f64, mean.value]).filter(|p| !is_line(p[0]));
        let mut panel = Panel::new(self.name, self.title.clone(), frequency(0.0, 1.0), power_scale(0.6))
            .legend(Legend::Above)
            .with(Layer::verticals("nyquist", Meaning::Guide, [0.5]).dashed());
        if !means.is_empty() {
            panel = panel
                .with(Layer::dots("noise", Meaning::Samples, dots).label(text!("noise", "шум")))
                .with(Layer::curve("theory", Meaning::Theory, 0.0, 1.0, 200, |nu| self.theory.density(nu).re));
        }
        panel
            .with(Layer::arrows("own", Meaning::Signal, lines().filter(is_own)).thick().label(text!("tone", "тон")))
            .with(
                Layer::arrows("alias", Meaning::Leaked, lines().filter(|p| !is_own(p)))
                    .thick()
                    .label(text!("alias", "алиас")),
            )
    }
}
