//! The picture: the spectrum, the limit, what lies beyond, and where it goes.

use super::{Subject, decibels, hertz};
use crate::figure::{Figure, Layer, Legend, Meaning, Panel, Portrait, Scale};
use crate::inspect::sound::{Channel, Ending, Forecast, Outcome, Stretch, Way, dbfs};
use crate::nyquist::fold;
use crate::rate::Quality;
use crate::sampled::welch::PowerSpectrum;
use crate::text;
use crate::text::Text;

/// Points of a curve: as many as the picture has pixels.
pub(super) const COLUMNS: usize = 700;
/// Arrows that are drawn.
const MOST_ARROWS: usize = 5;
/// How far apart they are at least, as a part of the height.
const APART: f64 = 0.1;
/// The most that is shown between top and bottom, in dB.
const DEPTH: f64 = 170.0;

pub(super) fn portrait(subject: &Subject, title: Text) -> Portrait {
    let check = subject.check;
    let channel = &check.sound().channels()[check.worst()];
    let rate = check.rate().filter(|rate| *rate < check.sound().rate());
    match (rate, check.forecasts().get(check.worst())) {
        (Some(_), Some(forecast)) if !channel.silent() => folding(subject, channel, forecast, title),
        _ => alone(subject, channel, title),
    }
}

/// Which channel is meant, counted from zero, where there are several: to be said after a title, in English and in Russian.
pub(super) fn numbered(subject: &Subject, channel: usize) -> [String; 2] {
    let (all, number) = (subject.check.sound().channels().len(), channel + 1);
    if all == 1 {
        return [String::new(), String::new()];
    }
    [format!(" (channel {number} of {all})"), format!(" (канал {number} из {all})")]
}

/// The levels of a picture: its top and its bottom.
fn levels(spectrum: &PowerSpectrum) -> (f64, f64) {
    let of = |k: usize| dbfs(spectrum.tone_power(k));
    let values: Vec<f64> = (1..spectrum.density().len()).map(of).filter(|v| v.is_finite()).collect();
    let top = values.iter().copied().fold(-60.0, f64::max);
    let low = values.iter().copied().fold(top, f64::min);
    let top = (top / 10.0).ceil() * 10.0 + 10.0;
    ((((low - 20.0) / 10.0).floor() * 10.0).max(top - DEPTH), top)
}

/// The largest power of each column of a curve over `0..end`, as level: lines stay visible.
pub(super) fn curve(powers: &[(f64, f64)], end: f64) -> Vec<[f64; 2]> {
    let mut columns = vec![0.0f64; COLUMNS];
    for &(frequency, power) in powers {
        let column = (frequency / end * COLUMNS as f64) as usize;
        if let Some(most) = columns.get_mut(column) {
            *most = most.max(power);
        }
    }
    let place = |i: usize| (i as f64 + 0.5) / COLUMNS as f64 * end;
    let drawn = columns.iter().enumerate().filter(|(_, power)| **power > 0.0);
    drawn.map(|(i, power)| [place(i), dbfs(*power)]).collect()
}

/// Frequencies and the power that a sine would have, weighted.
fn powers(spectrum: &PowerSpectrum, gain: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let at = |k: usize| (spectrum.frequency(k), spectrum.tone_power(k) * gain(spectrum.frequency(k)).powi(2));
    (1..spectrum.density().len()).map(at).collect()
}

pub(super) fn frequencies(end: f64) -> Scale {
    // kHz where the numbers would be long
    let (unit, unit_ru, scale) = if end >= 2000.0 { ("kHz", "кГц", 1e-3) } else { ("Hz", "Гц", 1.0) };
    let step = tick(end * scale) / scale;
    let ticks = (0..).map(|i| f64::from(i) * step).take_while(|at| *at <= end * 1.000_001);
    let ticks: Vec<_> = ticks.map(|at| (at, super::number(short(at * scale)))).collect();
    Scale::linear(text!("frequency, {unit}", "частота, {unit_ru}"), 0.0, end).ticks(ticks)
}

/// A step of 1, 2 or 5 times a power of ten that cuts a length into 5 to 12 pieces.
fn tick(length: f64) -> f64 {
    let ten = 10f64.powf((length / 6.0).log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|step| step * ten);
    steps.into_iter().find(|step| length / step <= 12.0).unwrap_or(10.0 * ten)
}

/// Without digits that are rounding.
fn short(value: f64) -> String {
    let rounded = (value * 1e6).round() * 1e-6;
    format!("{rounded:.3}").trim_end_matches('0').trim_end_matches('.').into()
}

fn decibel_scale(spectrum: &PowerSpectrum, low: f64, top: f64) -> Scale {
    let width = spectrum.noise_bandwidth();
    Scale::linear(text!("dBFS in {} Hz", "dBFS в {} Гц", hertz(width)), low, top)
}

fn folding(subject: &Subject, channel: &Channel, forecast: &Forecast, title: Text) -> Portrait {
    let spectrum = channel.whole();
    let (low, top) = levels(spectrum);
    let (own, nyquist) = (0.5 * spectrum.rate(), 0.5 * forecast.rate);
    let all = powers(spectrum, |_| 1.0);
    let whole = curve(&all, own);
    let (inside, beyond): (Vec<_>, Vec<_>) = whole.into_iter().partition(|p| p[0] < nyquist);
    let ground = |points: Vec<[f64; 2]>| points.into_iter().map(|[x, y]| [x, low, y.max(low)]).collect::<Vec<_>>();
    let arrows = arrows(spectrum, forecast, (low, top));
    // behind the tail of each
    let notes: Vec<([f64; 2], Text)> = arrows
        .iter()
        .map(|[from, to]| {
            // where there is no room behind it, before it
            let side = if from[0] > 0.85 * own { -0.08 } else { 0.08 };
            let place = [from[0] + side * own, from[1] + if side < 0.0 { 0.035 * (top - low) } else { 0.0 }];
            (place, text!("{} → {}", "{} → {}", hertz(from[0]), hertz(to[0])))
        })
        .collect();
    let [en, ru] = numbered(subject, subject.check.worst());
    let limit = hertz(nyquist);
    let before = Panel::new(
        "before",
        text!("before: what lies beyond {limit} Hz folds{en}", "до: всё выше {limit} Гц заворачивается{ru}"),
        frequencies(own),
        decibel_scale(spectrum, low, top),
    )
    .legend(Legend::Above)
    .span(2)
    .with(Layer::spans("beyond", Meaning::Leaked, [[nyquist, own]]))
    .with(Layer::between("lost", Meaning::Leaked, ground(beyond.clone())).label(text!("will alias", "станет алиасом")))
    .with(Layer::line("signal", Meaning::Signal, inside).label(text!("stays", "останется")))
    .with(Layer::line("outside", Meaning::Leaked, beyond).thin())
    .with(
        Layer::verticals("nyquist", Meaning::Guide, [nyquist])
            .dashed()
            .label(text!("new Nyquist frequency", "новая частота Найквиста")),
    )
    .with(Layer::pointers("folds", Meaning::Samples, arrows).label(text!("where it lands", "куда попадёт")))
    .with(Layer::notes("folds-from-to", Meaning::Samples, notes));
    let mut figure = Figure::new(2).heights([1.5, 1.0]).with(before);
    let quality = Way::Filtered(Quality::High);
    for (name, way) in [("after-plain", Way::Plain), ("after-high", quality)] {
        figure = figure.with(after(name, way, channel, forecast, (low, top)));
    }
    let outcome = &forecast.outcomes[0];
    let caption = text!(
        "Above the spectrum of the sound as it is, with the new Nyquist frequency {} Hz; arrows show where the strongest \
         components beyond it land. Below what is there afterwards: sampled plainly, aliases {} dB below the signal; through \
         the filter of quality high, at least {} dB.",
        "Вверху спектр звука как он есть и новая частота Найквиста {} Гц; стрелки показывают, куда попадут самые сильные \
         составляющие выше неё. Внизу — что получится: при простой выборке алиасы на {} дБ ниже сигнала, через фильтр \
         качества high — не менее чем на {} дБ.",
        hertz(nyquist),
        decibels(outcome.ratio()),
        decibels(forecast.outcomes[2].ratio())
    );
    Portrait { title, caption, figure }
}

/// From the strongest lines beyond the limit to where they land; where there are none, from the stretches. One under
/// another, from a place on the line, so that each can be seen.
fn arrows(spectrum: &PowerSpectrum, forecast: &Forecast, (low, top): (f64, f64)) -> Vec<[[f64; 2]; 2]> {
    let lines = forecast.folded.iter().map(|f| (f.line.frequency, f.alias.frequency(), dbfs(f.line.power())));
    let mut shown: Vec<_> = lines.filter(|(_, _, level)| *level > low).take(MOST_ARROWS).collect();
    if shown.is_empty() {
        let mut stretches = forecast.stretches.clone();
        stretches.sort_by(|a, b| b.power.total_cmp(&a.power));
        let middle = |[a, b]: [f64; 2]| 0.5 * (a + b);
        let arrow = |stretch: &Stretch| {
            let from = middle(stretch.landing.from);
            let level = dbfs(spectrum.tone_power((from / spectrum.step()).round() as usize));
            (from, middle(stretch.landing.to), level)
        };
        let strongest = stretches.iter().take(MOST_ARROWS - 1).map(arrow);
        shown = strongest.filter(|(_, _, level)| *level > low).collect();
    }
    let mut height = f64::INFINITY;
    let placed = shown.into_iter().map(|(from, to, level)| {
        height = level.min(height - APART * (top - low));
        [[from, height], [to, height]]
    });
    placed.filter(|arrow| arrow[0][1] > low).collect()
}

/// The spectrum after a way: what stayed, and what folded onto it.
fn after(name: &'static str, way: Way, channel: &Channel, forecast: &Forecast, (low, top): (f64, f64)) -> Panel {
    let spectrum = channel.whole();
    let nyquist = 0.5 * forecast.rate;
    let gains = |frequency: f64| forecast.gain(way, frequency);
    let (inside, beyond): (Vec<_>, Vec<_>) =
        powers(spectrum, gains).into_iter().partition(|(frequency, _)| *frequency < nyquist);
    // several bins fold onto one
    let mut folded = vec![0.0; (nyquist / spectrum.step()).ceil() as usize + 1];
    for (frequency, power) in beyond {
        let at = fold(frequency, forecast.rate) / spectrum.step();
        if let Some(sum) = folded.get_mut(at.round() as usize) {
            *sum += power;
        }
    }
    let folded: Vec<_> = folded.into_iter().enumerate().map(|(k, p)| (k as f64 * spectrum.step(), p)).collect();
    let outcome = forecast.outcomes.iter().find(|outcome| outcome.way == way);
    let ratio = decibels(outcome.map_or(f64::INFINITY, Outcome::ratio));
    let title = match way {
        Way::Plain => text!("after, plainly sampled: {ratio} dB", "после простой выборки: {ratio} дБ"),
        Way::Filtered(quality) => {
            text!(
                "after, resample --quality {quality}: ≥ {ratio} dB",
                "после resample --quality {quality}: ≥ {ratio} дБ"
            )
        }
    };
    let aliases = curve(&folded, nyquist);
    let seen = aliases.iter().any(|p| p[1] > low);
    let area = aliases.iter().map(|[x, y]| [*x, low, y.max(low)]);
    let mut panel = Panel::new(name, title, frequencies(nyquist), decibel_scale(spectrum, low, top))
        .legend(Legend::Above)
        .with(Layer::line("kept", Meaning::Signal, curve(&inside, nyquist)).label(text!("signal", "сигнал")))
        .with(Layer::between("aliases", Meaning::Leaked, area).label(text!("aliases", "алиасы")))
        .with(Layer::line("aliases-edge", Meaning::Leaked, aliases).thin());
    if !seen {
        let at = [0.5 * nyquist, low + 0.06 * (top - low)];
        let below = text!("aliases: below {low:.0} dBFS", "алиасы: ниже {low:.0} dBFS");
        panel = panel.with(Layer::notes("nothing", Meaning::Leaked, [(at, below)]));
    }
    panel
}

/// The spectrum of a sound at its own rate.
fn alone(subject: &Subject, channel: &Channel, title: Text) -> Portrait {
    let spectrum = channel.whole();
    let (low, top) = levels(spectrum);
    let own = 0.5 * spectrum.rate();
    let [en, ru] = numbered(subject, subject.check.worst());
    let name = text!("spectrum{en}", "спектр{ru}");
    let mut panel =
        Panel::new("spectrum", name, frequencies(own), decibel_scale(spectrum, low, top)).legend(Legend::UpperRight);
    if let (Some(floor), Some(ending)) = (channel.floor(), channel.ending()) {
        if let Ending::Cut { at, .. } = ending {
            panel = panel.with(Layer::spans("empty", Meaning::Error, [[at, own]]).label(text!("empty", "пусто")));
        }
        let bands = [0.99, 0.999, 0.9999].map(|f| channel.occupied(f).ok().flatten().unwrap_or_default());
        let names = [Text::same("99 %"), text!("99.9 %", "99,9 %"), text!("99.99 %", "99,99 %")];
        let height = |i: usize| top - (0.05 + 0.055 * i as f64) * (top - low);
        let notes = bands.iter().zip(names).enumerate().map(|(i, (at, name))| ([*at, height(i)], name));
        panel = panel
            .with(Layer::line("signal", Meaning::Signal, curve(&powers(spectrum, |_| 1.0), own)))
            .with(
                Layer::verticals("bands", Meaning::Reconstructed, bands)
                    .thin()
                    .label(text!("so much of the power lies below", "ниже — столько мощности")),
            )
            .with(
                Layer::horizontals("floor", Meaning::Guide, [dbfs(floor.density * spectrum.noise_bandwidth())])
                    .dashed()
                    .label(text!("noise floor", "уровень шума")),
            )
            .with(Layer::notes("band-names", Meaning::Reconstructed, notes.collect::<Vec<_>>()));
    }
    let sixteenth = Layer::spans("edge", Meaning::Leaked, [channel.edge()]);
    let figure =
        Figure::new(1).with(panel.with(sixteenth.label(text!(
            "last sixteenth before the Nyquist frequency",
            "последняя шестнадцатая до частоты Найквиста"
        ))));
    let caption = text!(
        "The spectrum of {} up to its Nyquist frequency {} Hz: where 99, 99.9 and 99.99 % of the power lie below, the noise \
         floor, and the last sixteenth, whose power says how much may have folded.",
        "Спектр {} до частоты Найквиста {} Гц: границы 99, 99,9 и 99,99 % мощности, уровень шума и последняя шестнадцатая, \
         по мощности которой видно, сколько могло завернуться.",
        subject.name,
        hertz(own)
    );
    Portrait { title, caption, figure }
}
