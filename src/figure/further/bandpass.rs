//! Sampling a high band slowly (V23).

use crate::axis::Axis;
use crate::beyond::bandpass::BandPass;
use crate::error::Result;
use crate::figure::common::{space, values};
use crate::figure::params::Param;
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::laws::generalised::{band_pass, band_pass_tail};
use crate::num::quadrature::{even_breaks, integrate_pieces};
use crate::nyquist::bandpass_rates;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::raised_cosine::RaisedCosine;
use crate::signal::theorem::Modulated;
use crate::signal::{FourierPair, Signal};
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[BANDPASS];

static RATE: Text = Text::fixed("sampling rate", "частота дискретизации");

const LOW: f64 = 21.0;
const HIGH: f64 = 24.0;
/// Half of the signal's own band around the middle of the pass band.
const HALF: f64 = 1.4;
/// Rates that are tried, slowest first.
const TRIED: [f64; 5] = [6.5, 7.5, 8.2, 9.0, 10.0];
/// Samples to either side of the middle.
const TERMS: usize = 60;

const BANDPASS: Entry = Entry {
    id: "x-bandpass",
    inventory: &[],
    errata: &[],
    title: &Text::fixed("A band from 21 to 24, sampled slowly", "Полоса от 21 до 24 и редкие отсчёты"),
    caption: &Text::fixed(
        "Only copies that overlap do harm. This signal needs no rate of 48: 8.2 is enough, while 9, although faster, is not. \
         The allowed rates lie in wedges; where the copies leave the band free, the error is gone.",
        "Вредят только наложенные копии. Этому сигналу не нужна частота 48: достаточно 8,2, а 9, хотя и выше, не годится. \
         Разрешённые частоты лежат в клиньях; где копии не заходят в полосу, ошибка исчезает.",
    ),
    params: &[Param::real("rate", &RATE, 8.2, 6.2, 14.0, "")],
    build: |params| bandpass(params.real("rate")),
};

fn signal() -> Result<Modulated<RaisedCosine>> {
    Modulated::new(0.5 * (LOW + HIGH), RaisedCosine::new(HALF)?)
}

/// Places within the middle of the record, on no grid of the tried rates.
fn places() -> Vec<f64> {
    (-12..=12).map(|i| 0.0417 * f64::from(i) + 0.007).collect()
}

fn restored(rate: f64) -> Result<BandPass> {
    BandPass::new(Samples::of(&signal()?, Axis::centered(1.0 / rate, 2 * TERMS + 1)?), LOW..HIGH)
}

fn error(rate: f64) -> Result<f64> {
    let (f, back) = (signal()?, restored(rate)?);
    Ok(places().into_iter().map(|x| (f.at(x) - back.at(x)).abs()).fold(0.0, f64::max))
}

/// `∫ Σ_{k≠0} |F(ν − k·rate)| dν` over the pass band: what the copies leak into it, and the most that they can change.
fn leaked(rate: f64) -> Result<f64> {
    let spectrum = signal()?.spectrum();
    let order = (2.0 * HIGH / rate).ceil() as i64;
    let middle = 0.5 * (LOW + HIGH);
    // the copies are smooth between their ends
    let ends = (-order..=order)
        .flat_map(|k| [-middle - HALF, -middle + HALF, middle - HALF, middle + HALF].map(|end| end + k as f64 * rate));
    let mut breaks: Vec<f64> = even_breaks(LOW, HIGH, 0.25).into_iter().chain(ends).collect();
    breaks.retain(|b| (LOW..=HIGH).contains(b));
    breaks.sort_by(f64::total_cmp);
    let copies = |nu: f64| -> f64 {
        let others = (-order..=order).filter(|k| *k != 0);
        others.map(|k| spectrum.density(nu - k as f64 * rate).norm()).sum()
    };
    Ok(2.0 * integrate_pieces(copies, &breaks, 1e-14).value)
}

fn wedges() -> Result<Panel> {
    let width = HIGH - LOW;
    let (left, right, low, high) = (12.0, 27.0, 5.5, 12.0);
    let mut panel = Panel::new(
        "wedges",
        text!("which rates will do", "какие частоты годятся"),
        Scale::linear(text!("upper end of a band 3 wide", "верхний край полосы шириной 3"), left, right),
        Scale::linear(text!("rate", "частота"), low, high),
    )
    .legend(Legend::Above);
    for n in 2..=(right / width) as usize {
        // f_s from 2f_H/n to 2(f_H − W)/(n − 1), which meet at f_H = nW
        let rates = |upper: f64| {
            let found = bandpass_rates(upper - width, upper).ok()?;
            let of_n = found.into_iter().find(|r| r.n as usize == n)?;
            Some([upper, of_n.low.max(low), of_n.high.min(high)]).filter(|[_, a, b]| a < b)
        };
        let uppers = (0..=300).map(|i| left + (right - left) * f64::from(i) / 300.0);
        let wedge = Layer::between("wedge", Meaning::Reconstructed, uppers.filter_map(rates));
        panel = panel.with(if n == 2 {
            wedge.label(text!("copies do not overlap", "копии не накладываются"))
        } else {
            wedge
        });
    }
    let (works, fails): (Vec<[f64; 2]>, Vec<[f64; 2]>) =
        TRIED.map(|rate| [HIGH, rate]).into_iter().partition(|p| allowed(p[1]).unwrap_or(false));
    Ok(panel
        .with(Layer::verticals("ours", Meaning::Guide, [HIGH]).dashed())
        .with(Layer::dots("works", Meaning::Reconstructed, works).label(text!("works", "годится")))
        .with(Layer::dots("fails", Meaning::Leaked, fails).label(text!("fails", "нет"))))
}

fn allowed(rate: f64) -> Result<bool> {
    Ok(bandpass_rates(LOW, HIGH)?.iter().any(|interval| interval.contains(rate)))
}

fn bandpass(rate: f64) -> Result<Figure> {
    let spectrum = signal()?.spectrum();
    let (from, to) = (6.2, 12.0);
    let rates = (0..=116).map(|i| from + (to - from) * f64::from(i) / 116.0);
    let errors = rates.map(|rate| Ok([rate, error(rate)?])).collect::<Result<Vec<[f64; 2]>>>()?;
    let intervals = bandpass_rates(LOW, HIGH)?;
    let error_panel = Panel::new(
        "error",
        text!("error of the reconstruction", "ошибка восстановления"),
        Scale::linear(text!("rate", "частота"), from, to),
        values("max |f̃ − f|", -0.08, 1.6),
    )
    .legend(Legend::Above)
    .with(
        Layer::spans(
            "allowed",
            Meaning::Reconstructed,
            intervals.iter().map(|i| [i.low.max(from), i.high.min(to)]).filter(|i| i[0] < i[1]),
        )
        .label(text!("allowed rates", "разрешено")),
    )
    .with(Layer::line("error", Meaning::Error, errors).label(text!("error", "ошибка")))
    .with(Layer::verticals("rate", Meaning::Samples, [rate]).label(text!("this rate", "эта частота")));

    let order = (2.0 * HIGH / rate).ceil() as i64;
    let mut copies_panel = Panel::new(
        "copies",
        text!("copies at this rate", "копии при этой частоте"),
        Scale::linear(Text::same("ν"), 14.0, 31.0),
        values("F(ν)", 0.0, 0.65),
    )
    .legend(Legend::Above)
    .with(Layer::spans("band", Meaning::Guide, [[LOW, HIGH]]).label(text!("pass band", "полоса")));
    let meets =
        |k: i64, sign: f64| (sign * 0.5 * (LOW + HIGH) + k as f64 * rate - 0.5 * (LOW + HIGH)).abs() < 2.0 * HALF;
    let mut named = [false; 2];
    for k in (-order..=order).filter(|k| *k != 0) {
        for sign in [1.0, -1.0] {
            let middle = sign * 0.5 * (LOW + HIGH) + k as f64 * rate;
            let copy = (0..=60).map(|i| middle + HALF * (f64::from(i) / 30.0 - 1.0));
            let copy = copy.map(|nu| [nu, spectrum.density(nu - k as f64 * rate).re]);
            let hit = meets(k, sign);
            let meaning = if hit { Meaning::Leaked } else { Meaning::Replica };
            let layer = Layer::area("copy", meaning, copy);
            let label = if hit { text!("leaks", "протекает") } else { text!("copies", "копии") };
            let first = !std::mem::replace(&mut named[usize::from(hit)], true);
            copies_panel = copies_panel.with(if first { layer.label(label) } else { layer });
        }
    }
    let copies_panel = copies_panel.with(
        Layer::curve("own", Meaning::Signal, LOW, HIGH, 200, |nu| spectrum.density(nu).re)
            .thick()
            .label(text!("signal", "сигнал")),
    );

    let (f, back) = (signal()?, restored(rate)?);
    let end = 0.62;
    let space_panel = Panel::new(
        "space",
        text!("few samples, fast waves", "мало отсчётов, быстрые волны"),
        space(-end, end),
        values("f(x)", -1.6, 1.6),
    )
    .legend(Legend::Above)
    .with(Layer::curve("signal", Meaning::Signal, -end, end, 900, |x| f.at(x)).label(text!("signal", "сигнал")))
    .with(
        Layer::curve("restored", Meaning::Reconstructed, -end, end, 900, |x| back.at(x))
            .dashed()
            .label(text!("restored", "восстановлен")),
    )
    .with(
        Layer::dots("samples", Meaning::Samples, back.samples().points().filter(|p| p[0].abs() <= end))
            .label(text!("samples", "отсчёты")),
    );

    let tail = |rate: f64| band_pass_tail(HALF, 1.0 / rate, TERMS);
    let law = |rate: f64| band_pass(&f, LOW..HIGH, rate, TERMS, &places(), tail(rate));
    let mut works = 0.0f64;
    let mut fails = f64::INFINITY;
    for rate in TRIED {
        let residual = law(rate)?;
        if allowed(rate)? {
            works = works.max(residual.measured / residual.bound);
        } else {
            fails = fails.min(residual.measured);
        }
    }
    let here = law(rate)?;
    let most = leaked(rate)?;
    let says = if most == 0.0 {
        text!(
            "at {} no copy enters the band: the signal is restored",
            "при {} ни одна копия не заходит в полосу: сигнал восстановлен",
            number(rate, 3)
        )
    } else {
        text!(
            "at {} copies leak into the band: error {}, at most {}",
            "при {} копии протекают в полосу: ошибка {}, не больше {}",
            number(rate, 3),
            number(here.measured, 2),
            number(most, 2)
        )
    };
    Ok(Figure::new(2)
        .with(wedges()?)
        .with(error_panel)
        .with(copies_panel)
        .with(space_panel)
        .claim(
            text!(
                "8.2 and 10 restore the signal, but for the ends of the record",
                "8,2 и 10 восстанавливают сигнал с точностью до краёв записи"
            ),
            Residual::at_most("error at the allowed rates, in units of its bound", works, 1.0),
        )
        .claim(
            text!(
                "6.5, 7.5 and 9 do not: errors of {} at least, of a signal of height {}",
                "6,5, 7,5 и 9 — нет: ошибки не меньше {} при высоте сигнала {}",
                number(fails, 2),
                number(f.at(0.0), 2)
            ),
            // what the law allows at the allowed rates is below a hundredth of that
            Residual::at_least("least error at the other rates", fails, 100.0 * law(TRIED[2])?.bound),
        )
        .claim(says, Residual::at_most("error = what the copies leak into the band", here.measured, most + here.bound)))
}
