//! Regular and random places for samples (slides «Стохастический суперсэмплинг»).
//!
//! Here and in [`jitter`](crate::figure::remedy::jitter) the step is one: frequencies are in cycles per step, the rate is 1 and
//! Nyquist ½. The power of `n` points is `(1/n)|Σ e^{−2πiνx}|²` at the harmonics `ν = m/n` of their record.

use crate::axis::Axis;
use crate::beyond::jitter::{Jitter, JitteredComb};
use crate::error::Result;
use crate::figure::common::{frequency, signal_curve, space, values};
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::laws::jitter::jitter_spectrum;
use crate::nyquist::Alias;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::sampled::dft::forward;
use crate::sampled::nonuniform::transform;
use crate::signal::tone::Cosine;
use crate::signal::{FourierPair, Signal};
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[UNIFORM, RANDOM];

/// How many patterns a mean is taken over.
pub(super) const PATTERNS: u32 = 2000;
/// How many standard errors a mean may be off. Six: 2·10⁻⁹ for one normal number, so 10⁻⁵ for all bins and all seeds
/// that a figure offers.
pub(super) const DEVIATIONS: f64 = 6.0;

pub(super) static SEED: Text = Text::fixed("seed of the random numbers", "начальное число генератора");
static CYCLES: Text = Text::fixed("periods of the tone per 16 samples", "периодов синусоиды на 16 отсчётов");
static POINTS: Text = Text::fixed("number of points", "число точек");

/// The powers of impulses at the harmonics `0..=order·n` of a record of `n` steps.
pub(super) fn powers(points: &[[f64; 2]], n: usize, order: usize) -> Vec<f64> {
    transform(points, n as f64, order * n).iter().map(|sum| sum.norm_sqr() / n as f64).collect()
}

/// A mean over patterns, and its standard error.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mean {
    pub(super) value: f64,
    pub(super) error: f64,
}

/// The means of many numbers over [`PATTERNS`] patterns.
pub(super) fn averaged(mut numbers: impl FnMut(u32) -> Vec<f64>) -> Vec<Mean> {
    let mut sums: Vec<[f64; 2]> = Vec::new();
    for pattern in 0..PATTERNS {
        let numbers = numbers(pattern);
        sums.resize(numbers.len(), [0.0; 2]);
        for (sum, v) in sums.iter_mut().zip(numbers) {
            sum[0] += v;
            sum[1] += v * v;
        }
    }
    let n = f64::from(PATTERNS);
    let mean = |[sum, squares]: [f64; 2]| {
        let value = sum / n;
        Mean { value, error: ((squares / n - value * value).max(0.0) / (n - 1.0)).sqrt() }
    };
    sums.into_iter().map(mean).collect()
}

/// How many standard errors the worst of the means is off; a mean without any spread must agree to rounding.
pub(super) fn worst_deviation(means: impl IntoIterator<Item = (Mean, f64)>) -> f64 {
    let deviation = |(mean, expected): (Mean, f64)| {
        let rounding = 1e-12 * expected.abs().max(1.0); // of the sums in `averaged`, 2000·ε
        (mean.value - expected).abs() / (mean.error + rounding)
    };
    means.into_iter().map(deviation).fold(0.0, f64::max)
}

/// Powers at `ν = m/n` for positive and negative `m`; they are even.
pub(super) fn both_sides(powers: &[f64], n: usize) -> Vec<[f64; 2]> {
    let last = powers.len() as i64 - 1;
    (-last..=last).map(|m| [m as f64 / n as f64, powers[m.unsigned_abs() as usize]]).collect()
}

/// The comb's impulses of weight one at those positions.
fn impulses(name: &'static str, title: Text, positions: &[f64]) -> Panel {
    let end = positions.len() as f64;
    Panel::new(name, title, space(-0.5, end), Scale::linear(text!("weight", "вес"), 0.0, 1.25)).with(Layer::arrows(
        "positions",
        Meaning::Samples,
        positions.iter().map(|&x| [x, 1.0]),
    ))
}

const UNIFORM: Entry = Entry {
    id: "f37-uniform",
    inventory: &["F37"],
    errata: &["E10", "E33"],
    title: &Text::fixed("Regular samples: coherent artefacts", "Регулярные отсчёты: когерентные артефакты"),
    caption: &Text::fixed(
        "The spectrum of a regular comb is a comb. Sampling puts a copy of the signal's spectrum on every spike, so a \
         tone above the Nyquist frequency comes back as another pure tone, just as strong: a regular pattern that the \
         eye cannot miss. (The slide multiplies the signal by the comb of the spectrum; it is the comb in space.)",
        "Спектр регулярного гребня — тоже гребень. Дискретизация ставит копию спектра сигнала на каждый его пик, и \
         синусоида выше частоты Найквиста возвращается другой чистой синусоидой той же силы: регулярный узор, который \
         нельзя не заметить. (На слайде сигнал умножают на гребёнку спектра; умножают на гребень в пространстве.)",
    ),
    params: &[Param::count("cycles", &CYCLES, 13, 9, 15)],
    build: |params| uniform(params.count("cycles")),
};

fn uniform(cycles: usize) -> Result<Figure> {
    const COUNT: usize = 16;
    const ORDER: usize = 2;
    let comb = JitteredComb::new(1.0, Jitter::None)?;
    let positions = comb.positions(0, COUNT);
    let power: Vec<f64> = comb.mean_periodogram(0, COUNT, 1, ORDER).iter().map(|p| p[1]).collect();
    let top = COUNT as f64;
    let power_panel = Panel::new(
        "power",
        text!("its power spectrum", "его спектр мощности"),
        frequency(-2.3, 2.3),
        Scale::linear(text!("power", "мощность"), 0.0, 1.2 * top),
    )
    .with(Layer::stems("power", Meaning::Samples, both_sides(&power, COUNT)));

    let tone = Cosine::new(cycles as f64 / top)?;
    let alias = Alias::of(cycles as f64 / top, 1.0)?;
    let false_tone = Cosine::new(alias.frequency())?;
    let samples = Samples::of(&tone, Axis::new(0.0, 1.0, COUNT)?);
    let space_panel = Panel::new(
        "tone",
        text!("a tone, sampled", "синусоида и отсчёты"),
        space(-0.2, 8.2),
        values("f(x)", -1.2, 1.2),
    )
    .legend(Legend::Above)
    .with(signal_curve("tone", Meaning::Signal, &tone, 0.0, 8.0).label(text!("tone", "синусоида")))
    .with(signal_curve("alias", Meaning::Leaked, &false_tone, 0.0, 8.0).thick().label(text!("alias", "алиас")))
    .with(Layer::dots("samples", Meaning::Samples, samples.points().filter(|p| p[0] <= 8.0)));

    let lines = tone.spectrum().replicated(1.0, ORDER + 1)?;
    let arrows = |name, meaning, keep: &dyn Fn(f64) -> bool| {
        let kept = lines.lines().iter().filter(|l| l.at.abs() < 2.25 && keep(l.at.abs()));
        Layer::arrows(name, meaning, kept.map(|l| [l.at, l.weight.re]))
    };
    let own = cycles as f64 / top;
    let spectrum_panel = Panel::new(
        "spectrum",
        text!("the samples' spectrum", "спектр отсчётов"),
        frequency(-2.3, 2.3),
        values("F(ν)", 0.0, 0.65),
    )
    .legend(Legend::Above)
    .with(Layer::verticals("nyquist", Meaning::Guide, [-0.5, 0.5]).dashed())
    .with(arrows("copies", Meaning::Replica, &|nu| nu > 0.5 && (nu - own).abs() > 1e-9).label(text!("copies", "копии")))
    .with(arrows("own", Meaning::Signal, &|nu| (nu - own).abs() < 1e-9).thick().label(text!("tone", "синусоида")))
    .with(arrows("leaked", Meaning::Leaked, &|nu| nu < 0.5).thick().label(text!("alias", "алиас")));

    // every wave is computed as a power, up to the exponent m = 2n, to 4mε; |S|² ≤ n², hence 2·|δS| in |S|²/n
    let rounding = 8.0 * f64::EPSILON * (COUNT * COUNT * ORDER) as f64;
    let expected = |m: usize| if m.is_multiple_of(COUNT) { top } else { 0.0 };
    let worst = power.iter().enumerate().map(|(m, p)| (p - expected(m)).abs()).fold(0.0, f64::max);
    let same = samples.points().map(|[x, v]| (v - false_tone.at(x)).abs()).fold(0.0, f64::max);
    // the argument 2πνx of the last sample is rounded to ε of itself, in either tone
    let argument = 4.0 * f64::EPSILON * std::f64::consts::PI * top;
    let weight = forward(&samples).near(alias.frequency()).norm() / top;
    // twice the same samples: four times the power of one tone
    let together = samples.points().map(|[x, v]| (v + false_tone.at(x)).powi(2)).sum::<f64>() / top;
    Ok(Figure::new(2)
        .with(impulses("comb", text!("regular places", "регулярные позиции"), &positions))
        .with(power_panel)
        .with(space_panel)
        .with(spectrum_panel)
        .claim(
            text!(
                "the power is {COUNT} at multiples of the rate and 0 at all other frequencies m/{COUNT}",
                "мощность равна {COUNT} на кратных частоты дискретизации и 0 на остальных частотах m/{COUNT}"
            ),
            Residual::at_most("power of a regular comb: n at the rate's multiples, else 0", worst, rounding),
        )
        .claim(
            text!(
                "tones at {} and {} have the same samples",
                "синусоиды с частотами {} и {} имеют одни и те же отсчёты",
                number(own, 4),
                number(alias.frequency(), 4)
            ),
            Residual::at_most("samples of the tone = samples of its alias", same, argument),
        )
        .claim(
            text!(
                "the alias is a line of weight {}, like the tone itself",
                "алиас — линия веса {}, как у самой синусоиды",
                number(weight, 3)
            ),
            Residual::near("weight of the alias", weight, 0.5, argument),
        )
        .claim(
            text!(
                "tone and alias sampled together have the power {}, not ½ + ½: coherent powers do not add up",
                "мощность отсчётов синусоиды вместе с алиасом равна {}, а не ½ + ½: когерентные мощности не складываются",
                number(together, 3)
            ),
            Residual::near("power of a tone with its alias", together, 2.0, 8.0 * argument),
        ))
}

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
