//! Independent random places for samples (slide «Неравномерное сэмплирование»).

use crate::beyond::jitter::{Jitter, JitteredComb};
use crate::error::Result;
use crate::figure::common::{frequency, values};
use crate::figure::params::{Param, Params};
use crate::figure::remedy::stochastic::{
    DEVIATIONS, Mean, PATTERNS, SEED, averaged, both_sides, impulses, powers, worst_deviation,
};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::laws::jitter::jitter_spectrum;
use crate::residual::Residual;
use crate::signal::Signal;
use crate::signal::tone::Cosine;
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[RANDOM];

static POINTS: Text = Text::fixed("number of points", "число точек");

const RANDOM: Entry = Entry {
    id: "f38-random",
    inventory: &["F38"],
    errata: &["E11", "E12"],
    title: &Text::fixed("Independent random samples: white noise", "Независимые случайные отсчёты: белый шум"),
    caption: &Text::fixed(
        "Points that know nothing of each other have a spike at zero and, on average, the same power at all other \
         frequencies. A tone sampled so stays where it is, and its alias becomes noise: white, not high-frequency as the \
         slide says. (Nor do random places rule out exact restoration: where they are known it is possible.)",
        "У точек, ничего не знающих друг о друге, — пик в нуле и в среднем одинаковая мощность на всех остальных частотах. \
         Синусоида остаётся на месте, а её алиас становится шумом — белым, а не высокочастотным, как сказано на слайде. \
         (И точному восстановлению случайность не мешает: если позиции известны, оно возможно.)",
    ),
    params: &[Param::count("n", &POINTS, 16, 8, 32), Param::count("seed", &SEED, 1, 1, 100)],
    build: |params| random(params),
};

fn random(params: &Params) -> Result<Figure> {
    const ORDER: usize = 2;
    let (n, seed) = (params.count("n"), params.count("seed") as u64);
    let count = n as f64;
    let comb = JitteredComb::new(1.0, Jitter::Independent)?;
    let harmonic = (0.8125 * count).round() as usize;
    let tone = Cosine::new(harmonic as f64 / count)?;
    let positions = |pattern| comb.positions(JitteredComb::pattern_seed(seed, pattern), n);
    let plain = |pattern| powers(&positions(pattern).iter().map(|&x| [x, 1.0]).collect::<Vec<_>>(), n, ORDER);
    let weighed = |pattern| powers(&positions(pattern).iter().map(|&x| [x, tone.at(x)]).collect::<Vec<_>>(), n, ORDER);
    let mut pooled = Pooled::new();
    let mean = averaged(|pattern| {
        let powers = plain(pattern);
        pooled.take(&powers[1..]);
        powers
    });
    let of_tone = averaged(weighed);
    let only = |means: &[Mean]| means.iter().map(|m| m.value).collect::<Vec<_>>();

    let power = Scale::linear(text!("power", "мощность"), 0.0, 1.2 * count);
    let label_mean = || text!("mean of {PATTERNS}", "среднее по {PATTERNS}");
    let power_panel =
        Panel::new("power", text!("their power spectrum", "их спектр мощности"), frequency(-2.3, 2.3), power)
            .legend(Legend::Above)
            .with(
                Layer::stems("pattern", Meaning::Samples, both_sides(&plain(0), n))
                    .thin()
                    .label(text!("this pattern", "этот набор")),
            )
            .with(
                Layer::line("mean", Meaning::Theory, both_sides(&only(&mean), n).into_iter().filter(|p| p[0] > 0.0))
                    .label(label_mean()),
            )
            .with(Layer::line(
                "mean-left",
                Meaning::Theory,
                both_sides(&only(&mean), n).into_iter().filter(|p| p[0] < 0.0),
            ));

    let statistics = Panel::new(
        "statistics",
        text!("how often which power", "как часто какая мощность"),
        values("P", 0.0, 6.0),
        Scale::linear(text!("density", "плотность"), 0.0, 1.15),
    )
    .legend(Legend::UpperRight)
    .with(
        Layer::bars("histogram", Meaning::Samples, Pooled::WIDTH, pooled.histogram())
            .label(text!("{PATTERNS} patterns", "{PATTERNS} наборов")),
    )
    .with(
        Layer::curve("theory", Meaning::Theory, 0.0, 6.0, 200, |p: f64| (-p).exp()).thick().label(Text::same("e^{−P}")),
    );

    let expected = |m: usize| if m == harmonic { (count + 1.0) / 4.0 } else { 0.5 };
    let signed = both_sides(&only(&of_tone), n);
    let at_tone = |p: &[f64; 2]| (p[0].abs() * count - harmonic as f64).abs() < 0.5;
    let alias = n - harmonic;
    let at_alias = alias as f64 / count;
    let shown = || signed.iter().copied().filter(|p| p[0].abs() < 1.52);
    let tone_panel = Panel::new(
        "tone",
        text!("a tone sampled so", "синусоида в этих точках"),
        frequency(-1.6, 1.6),
        Scale::linear(text!("power", "мощность"), 0.0, 0.32 * (count + 1.0)),
    )
    .legend(Legend::Above)
    .with(
        Layer::verticals("alias", Meaning::Leaked, [-at_alias, at_alias])
            .dashed()
            .label(text!("the alias, gone", "алиас исчез")),
    )
    .with(Layer::stems("noise", Meaning::Samples, shown().filter(|p| !at_tone(p))).label(text!("noise", "шум")))
    .with(Layer::stems("tone", Meaning::Signal, shown().filter(at_tone)).label(text!("tone", "синусоида")))
    .with(Layer::horizontals("floor", Meaning::Theory, [0.5]).dashed());

    let average = mean[1..].iter().map(|m| m.value).sum::<f64>() / (mean.len() - 1) as f64;
    let deviation = (1.0 - 1.0 / count).sqrt();
    // the variance of an estimated deviation of exponential numbers is (9 − 1)/(4M) of the variance
    let spread = (2.0 / pooled.count as f64).sqrt();
    Ok(Figure::new(2)
        .with(impulses("points", text!("random places", "случайные позиции"), &positions(0)))
        .with(power_panel)
        .with(statistics)
        .with(tone_panel)
        .claim(
            text!("at ν = 0 every pattern has the power {n}", "при ν = 0 мощность каждого набора равна {n}"),
            Residual::near("power at zero = number of points", mean[0].value, count, 1e-12 * count),
        )
        .claim(
            text!(
                "elsewhere the mean power is {average:.2}: white noise",
                "на остальных частотах средняя мощность {average:.2}: белый шум"
            ),
            jitter_spectrum(&comb, &comb, seed, n, PATTERNS, ORDER),
        )
        .claim(
            text!(
                "its standard deviation is {}, as large as the mean (theory: √(1 − 1/n) = {})",
                "её стандартное отклонение {} — почти как само среднее (теория: √(1 − 1/n) = {})",
                number(pooled.deviation(), 2),
                number(deviation, 2)
            ),
            Residual::near("deviation of the power = √(1 − 1/n)", pooled.deviation(), deviation, DEVIATIONS * spread),
        )
        .claim(
            text!(
                "the tone keeps its spike, {}; where its alias stood there is only the floor, {}",
                "синусоида сохранила пик, {}; на месте алиаса — только фон, {}",
                number(of_tone[harmonic].value, 3),
                number(of_tone[alias].value, 2)
            ),
            Residual::at_most(
                "power of a tone at random places: (n+1)/4 and ½, in standard errors",
                worst_deviation(of_tone.iter().enumerate().map(|(m, &mean)| (mean, expected(m)))),
                DEVIATIONS,
            ),
        ))
}

/// All powers of all patterns, counted.
struct Pooled {
    count: usize,
    sum: f64,
    squares: f64,
    bins: [usize; 24],
}

impl Pooled {
    /// The width of a bin of the histogram.
    const WIDTH: f64 = 0.25;

    fn new() -> Self {
        Self { count: 0, sum: 0.0, squares: 0.0, bins: [0; 24] }
    }

    fn take(&mut self, powers: &[f64]) {
        for p in powers {
            self.count += 1;
            self.sum += p;
            self.squares += p * p;
            if let Some(bin) = self.bins.get_mut((p / Self::WIDTH) as usize) {
                *bin += 1;
            }
        }
    }

    fn deviation(&self) -> f64 {
        let n = self.count as f64;
        (self.squares / n - (self.sum / n).powi(2)).sqrt()
    }

    /// The middles of the bins, and the density in each.
    fn histogram(&self) -> Vec<[f64; 2]> {
        let density = |bin: usize| bin as f64 / (self.count as f64 * Self::WIDTH);
        self.bins.iter().zip(0..).map(|(&bin, i)| [(f64::from(i) + 0.5) * Self::WIDTH, density(bin)]).collect()
    }
}
