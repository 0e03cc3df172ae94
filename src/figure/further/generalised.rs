//! Half the rate, twice the knowledge: values with slopes, and pairs of samples (V22).

use crate::axis::Axis;
use crate::beyond::derivative::DerivativeSamples;
use crate::beyond::interlaced::Interlaced;
use crate::error::Result;
use crate::figure::common::{signal_curve, space, values};
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::kernel::ideal::Ideal;
use crate::laws::generalised::{derivative_tail, interlaced_noise, interlaced_tail};
use crate::laws::jitter::deviations;
use crate::num::random::normal;
use crate::num::sin_pi;
use crate::reconstruct::reconstruct;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::raised_cosine::RaisedCosine;
use crate::signal::theorem::{Scaled, Shifted, Sum};
use crate::signal::{Differentiable, Signal};
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[PAPOULIS];

static OFFSET: Text = Text::fixed("distance within a pair, in steps", "расстояние в паре, в шагах");
static SEED: Text = Text::fixed("seed of the random numbers", "начальное число генератора");

const PAPOULIS: Entry = Entry {
    id: "x-papoulis",
    inventory: &[],
    errata: &[],
    title: &Text::fixed("Half the Nyquist rate, two facts each time", "Половина частоты Найквиста, но по два числа"),
    caption: &Text::fixed(
        "One value a step is too little for this signal: the sinc through them goes elsewhere (red). One value and one slope \
         are enough, and so are two values, however close together. The price of closeness is noise: its power grows by \
         1/sin²(πa).",
        "Одного значения на шаг этому сигналу мало: sinc по ним уходит в сторону (красная). Значения и производной \
         достаточно; достаточно и двух значений, сколь угодно близких. Плата за близость — шум: его мощность растёт в \
         1/sin²(πa) раз.",
    ),
    params: &[Param::real("a", &OFFSET, 0.25, 0.05, 0.5, ""), Param::count("seed", &SEED, 1, 1, 100)],
    build: |params| papoulis(params),
};

/// The band of the signal; the step is one, so that Nyquist asks for a rate of twice that.
const BAND: f64 = 0.9;
/// Samples to either side.
const TERMS: usize = 200;
/// The pulses of the signal: where they stand and how much they weigh. They alternate, so that much of their sum is above
/// the Nyquist frequency ½ of one comb.
const PULSES: [[f64; 2]; 4] = [[-1.35, 1.0], [-0.45, -1.2], [0.4, 1.4], [1.3, -1.0]];

fn signal() -> Result<impl Differentiable> {
    let pulse = |[at, weight]: [f64; 2]| Scaled::new(weight, Shifted::new(at, RaisedCosine::new(BAND)?)?);
    let [a, b, c, d] = PULSES;
    Ok(Sum(Sum(pulse(a)?, pulse(b)?), Sum(pulse(c)?, pulse(d)?)))
}

fn papoulis(params: &Params) -> Result<Figure> {
    let (offset, seed) = (params.real("a"), params.count("seed") as u64);
    let f = signal()?;
    let axis = Axis::centered(1.0, 2 * TERMS + 1)?;
    let plain = Samples::of(&f, axis);
    let slopes = DerivativeSamples::of(&f, axis);
    let pairs = Interlaced::of(&f, axis, offset)?;
    let (low, high) = (-3.3, 3.3);
    let top = 1.2 * (0..=264).map(|i| f.at(low + (high - low) * f64::from(i) / 264.0).abs()).fold(0.0, f64::max);
    let plot = |name, title| {
        Panel::new(name, title, space(low, high), values("f(x)", -top, top))
            .legend(Legend::Above)
            .with(signal_curve("signal", Meaning::Signal, &f, low, high).thick().label(text!("signal", "сигнал")))
    };
    let shown = |p: &[f64; 2]| p[0] > low && p[0] < high;
    let tangents = axis.iter().zip(slopes.values().iter().zip(slopes.slopes())).filter(|(x, _)| x.abs() < high);
    let tangents = tangents.flat_map(|(x, (v, s))| {
        // as long on the slide whatever the slope
        let half = 0.32 / (1.0 + s * s).sqrt();
        [[x - half, v - half * s], [x + half, v + half * s], [f64::NAN, f64::NAN]]
    });
    let false_curve = reconstruct(&plain, Ideal);
    let restored = |signal: &dyn Signal| {
        Layer::curve("restored", Meaning::Reconstructed, low, high, 264, |x| signal.at(x))
            .dashed()
            .label(text!("restored", "восстановлен"))
    };
    let slopes_panel = plot("slopes", text!("a value and a slope", "значение и производная"))
        .with(
            Layer::curve("plain", Meaning::Leaked, low, high, 264, |x| false_curve.at(x))
                .label(text!("values alone", "по значениям")),
        )
        .with(restored(&slopes))
        .with(Layer::line("tangents", Meaning::Samples, tangents).thick())
        .with(Layer::dots("values", Meaning::Samples, plain.points().filter(shown)));
    let pairs_panel = plot("pairs", text!("two values", "два значения")).with(restored(&pairs)).with(
        Layer::dots("values", Meaning::Samples, pairs.points().filter(shown)).label(text!(
            "pairs, a = {}",
            "пары, a = {}",
            number(offset, 2)
        )),
    );

    let offsets = [0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5];
    let noises = noises(seed);
    let gain = |a: f64| sin_pi(a).powi(-2);
    let measured: Vec<[f64; 2]> = offsets.iter().map(|&a| [a, noise_power(&noises, a)]).collect();
    let noise_panel = Panel::new(
        "noise",
        text!("what closeness costs", "чего стоит близость"),
        Scale::linear(text!("distance a", "расстояние a"), 0.0, 0.53),
        Scale::log(text!("noise power", "мощность шума"), 0.5, 1000.0),
    )
    .legend(Legend::Above)
    .with(Layer::curve("theory", Meaning::Theory, 0.0125, 0.5, 200, gain).label(Text::same("1/sin²(πa)")))
    .with(Layer::dots("measured", Meaning::Error, measured.iter().copied()).label(text!("measured", "измерено")));

    let places: Vec<f64> = (0..=264).map(|i| low + (high - low) * f64::from(i) / 264.0).collect();
    let off = |g: &dyn Signal| places.iter().map(|&x| (g.at(x) - f.at(x)).abs()).fold(0.0, f64::max);
    // seen from each pulse, the record still reaches TERMS − 2 steps to either side
    let (seen, weight) = (TERMS - 3, PULSES.iter().map(|p| p[1].abs()).sum::<f64>());
    // the kernels are no larger than 1/sin πa, values below one, and terms fall at least like 1/k
    let rounding = 64.0 * f64::EPSILON * (TERMS as f64).ln() / sin_pi(offset);
    let of_slopes = weight * derivative_tail(BAND, 1.0, seen) + rounding;
    let of_pairs = weight * interlaced_tail(BAND, 1.0, seen, offset) + rounding;
    let wrong = off(&false_curve);
    // a mean over TRIALS squares of normal numbers, at places that may all tell the same. Samples beyond the record take
    // 2/(π²·HALF) of the power at most, and as much for the second comb
    let beyond = 4.0 / (std::f64::consts::PI.powi(2) * HALF as f64);
    let allowed = deviations(offsets.len()) * (2.0 / f64::from(TRIALS)).sqrt() + beyond;
    let worst = measured.iter().map(|[a, power]| (power / gain(*a) - 1.0).abs()).fold(0.0, f64::max);
    Ok(Figure::new(3)
        .with(slopes_panel)
        .with(pairs_panel)
        .with(noise_panel)
        .claim(
            text!(
                "values alone: an error of {}; with slopes the signal is restored",
                "только значения: ошибка {}; с производными сигнал восстановлен",
                number(wrong, 2)
            ),
            Residual::at_most("error of values with slopes, but for the record's end", off(&slopes), of_slopes),
        )
        .claim(
            text!(
                "pairs {} apart restore the signal",
                "пары с расстоянием {} восстанавливают сигнал",
                number(offset, 2)
            ),
            Residual::at_most("error of pairs, but for the record's end", off(&pairs), of_pairs),
        )
        .claim(
            text!(
                "and multiply the power of noise by 1/sin²(πa) = {}",
                "и умножают мощность шума на 1/sin²(πa) = {}",
                number(gain(offset), 3)
            ),
            interlaced_noise(offset, 1000, gain(offset))?,
        )
        .claim(
            text!("the measured powers follow this curve", "измеренные мощности следуют этой кривой"),
            Residual::at_most("measured noise relative to 1/sin²(πa)", worst, allowed),
        ))
}

/// How often noise is reconstructed, and how many pairs to either side take part.
const TRIALS: u32 = 2000;
const HALF: usize = 40;

/// Pairs of normal numbers of power one, again and again.
fn noises(seed: u64) -> Vec<Vec<[f64; 2]>> {
    let pairs = 2 * HALF as u64 + 1;
    let pair = |index: u64| [normal(seed, index, 0), normal(seed, index, 1)];
    (0..u64::from(TRIALS)).map(|trial| (0..pairs).map(|k| pair(trial * pairs + k)).collect()).collect()
}

/// The mean power of what they become between pairs `offset` apart.
fn noise_power(noises: &[Vec<[f64; 2]>], offset: f64) -> f64 {
    const PLACES: u32 = 8;
    let half = HALF as i64;
    let power_at = |x: f64| {
        let pair = |k: i64| {
            let t = x - k as f64;
            [Interlaced::kernel(t, offset), Interlaced::kernel(t - offset, -offset)]
        };
        let weights: Vec<[f64; 2]> = (-half..=half).map(pair).collect();
        let value = |noise: &Vec<[f64; 2]>| weights.iter().zip(noise).map(|(w, v)| w[0] * v[0] + w[1] * v[1]).sum();
        noises.iter().map(|noise| -> f64 { value(noise) }).map(|v: f64| v * v).sum::<f64>() / f64::from(TRIALS)
    };
    (0..PLACES).map(|i| power_at((f64::from(i) + 0.5) / f64::from(PLACES))).sum::<f64>() / f64::from(PLACES)
}
