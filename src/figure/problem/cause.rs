//! What goes wrong, and why (slides «Анти-алиасинг», «Что является причиной алиасинга?»).
//!
//! The slide «Анти-алиасинг» has lost its pictures; two readings fit its labels. Here is the one in one dimension: a
//! scene, sampled, and sampled again at half the rate, without and with a low-pass before every step. The reading in two
//! dimensions, an image decimated, belongs to the image figures.

use crate::axis::{Axis, Edge};
use crate::error::Result;
use crate::figure::common::{PIECES, signal_curve, space, unmarked};
use crate::figure::params::Param;
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel};
use crate::kernel::ideal::Ideal;
use crate::num::{cos_pi, sin_pi};
use crate::nyquist::{Alias, fold};
use crate::reconstruct::reconstruct;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::sampled::dft::{forward, inverse};
use crate::signal::gaussian::Gaussian;
use crate::signal::theorem::{Modulated, Shifted};
use crate::signal::tone::Cosine;
use crate::signal::{FourierPair, Signal, from_fn};
use crate::text;
use crate::text::{Text, number};
use std::f64::consts::PI;

static FAST_PACKET: Text = Text::fixed("frequency of the fast packet", "частота быстрого пакета");
static SLOW: Text = Text::fixed("frequency of the slow tone", "частота медленного тона");
static FAST: Text = Text::fixed("frequency of the fast tone", "частота быстрого тона");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[ANTIALIASING, CAUSE];

const ANTIALIASING: Entry = Entry {
    id: "f04-antialiasing",
    inventory: &["F04"],
    errata: &[],
    title: &Text::fixed("Aliasing and antialiasing", "Алиасинг и антиалиасинг"),
    caption: &Text::fixed(
        "Left: a scene is sampled, then sampled again at half the rate. What is too fast for the rate does not vanish: it \
         comes back as a slow wave that the scene never had. Right: a low-pass filter before every step. What cannot be \
         shown is gone, what is shown is true.",
        "Слева сцена дискретизуется, затем ещё раз с половинной частотой. Слишком быстрое не исчезает: оно возвращается \
         медленной волной, которой в сцене не было. Справа перед каждым шагом стоит фильтр низких частот: чего нельзя \
         показать, того нет, а что показано — правда.",
    ),
    params: &[Param::real("f", &FAST_PACKET, 0.875, 0.6, 0.95, "cycles per sample")],
    build: |params| antialiasing(params.real("f")),
};

/// Where the wave packets stand, and how wide they are, in samples of the first picture; multiples of both steps, so that
/// a packet and its alias are both even about its middle.
const MIDDLES: [f64; 3] = [16.0, 48.0, 80.0];
const DEVIATION: f64 = 6.0;
/// How long the record is, and how far the scene is shown.
const RECORD: f64 = 160.0;
const WIDTH: f64 = 96.0;

type Packet = Shifted<Modulated<Gaussian>>;

fn packet(middle: f64, frequency: f64) -> Result<Packet> {
    Shifted::new(middle, Modulated::new(frequency, Gaussian::with_deviation(DEVIATION)?)?)
}

fn antialiasing(fast: f64) -> Result<Figure> {
    let frequencies = [0.05, 0.375, fast];
    let rates = [1.0, 0.5];
    let packets = [0, 1, 2].map(|i| packet(MIDDLES[i], frequencies[i]));
    let [slow, middle, quick] = packets;
    let (slow, middle, quick) = (slow?, middle?, quick?);
    let scene = from_fn(|x| slow.at(x) + middle.at(x) + quick.at(x));
    // a record that the packets have left at both ends: e^{−½·8²} of their height is there
    let fine = Samples::of(&scene, Axis::nodes(-32.0..RECORD - 32.0, 8 * RECORD as usize)?);
    let plain = fine.decimated(8)?;
    let plain_half = plain.decimated(2)?;
    let filtered = inverse(&forward(&fine).low_passed(0.5 * rates[0])?).decimated(8)?;
    let filtered_half = inverse(&forward(&filtered).low_passed(0.5 * rates[1])?).decimated(2)?;

    // what each packet is after sampling: itself, or its alias
    let seen = |rate: f64| {
        let f = frequencies.map(|f| fold(f, rate));
        Ok((packet(MIDDLES[0], f[0])?, packet(MIDDLES[1], f[1])?, packet(MIDDLES[2], f[2])?))
    };
    let parts = |signal: &dyn Fn(f64) -> f64, wrong: bool, rate: f64| {
        let is_wrong = |x: f64| frequencies[((x / 32.0) as usize).min(2)] > 0.5 * rate;
        let n = 2 * PIECES;
        (0..=n)
            .map(|i| WIDTH * i as f64 / n as f64)
            .map(|x| [x, if is_wrong(x) == wrong { signal(x) } else { f64::NAN }])
            .collect::<Vec<_>>()
    };
    let shown = |s: &Samples| s.points().filter(|[x, _]| (0.0..=WIDTH).contains(x)).collect::<Vec<_>>();
    let panel = |name, title, last: bool| {
        let x = if last { space(0.0, WIDTH) } else { unmarked(0.0, WIDTH) };
        Panel::new(name, title, x, unmarked(-1.3, 1.3)).legend(Legend::Above)
    };
    let source = |name, title| {
        let curve = Layer::curve("scene", Meaning::Signal, 0.0, WIDTH, 4 * PIECES, |x| scene.at(x));
        panel(name, title, false).with(curve)
    };
    let named = |layer: Layer, last: bool, label: Text| if last { layer } else { layer.label(label) };
    let aliased = |name, title, samples: &Samples, rate: f64, last: bool| -> Result<Panel> {
        let (a, b, c) = seen(rate)?;
        let sum = |x: f64| a.at(x) + b.at(x) + c.at(x);
        let right = Layer::line("true", Meaning::Reconstructed, parts(&sum, false, rate));
        let wrong = Layer::line("false", Meaning::Leaked, parts(&sum, true, rate)).thick();
        let dots = Layer::dots("samples", Meaning::Samples, shown(samples));
        Ok(panel(name, title, last)
            .with(named(right, last, text!("as it was", "как было")))
            .with(named(wrong, last, text!("alias", "алиас")))
            .with(named(dots, last, text!("samples", "отсчёты"))))
    };
    let honest = |name, title, samples: &Samples, last: bool| {
        let back = reconstruct(samples, Ideal).edge(Edge::Wrap);
        let kept = signal_curve("kept", Meaning::Reconstructed, &back, 0.0, WIDTH);
        let dots = Layer::dots("samples", Meaning::Samples, shown(samples));
        panel(name, title, last).with(named(kept, last, text!("what is left", "что осталось"))).with(named(
            dots,
            last,
            text!("samples", "отсчёты"),
        ))
    };

    let alias = packet(MIDDLES[2], fold(fast, rates[0]))?;
    let there = |[x, _]: &[f64; 2]| (64.0..=WIDTH).contains(x);
    let ghost = |s: &Samples| s.points().filter(there).map(|[_, v]| v.abs()).fold(0.0, f64::max);
    let wrong = plain.points().map(|[x, v]| (v - slow.at(x) - middle.at(x) - alias.at(x)).abs()).fold(0.0, f64::max);
    let kept = filtered.points().map(|[x, v]| (v - slow.at(x) - middle.at(x)).abs()).fold(0.0, f64::max);
    let seconds = [(&middle, frequencies[1]), (&quick, fast)];
    let kept_half = filtered_half.points().map(|[x, v]| (v - slow.at(x)).abs()).fold(0.0, f64::max);
    Ok(Figure::new(2)
        .with(source("scene", text!("Aliasing: the scene", "Алиасинг: сцена")))
        .with(source("scene-again", text!("Antialiasing: the scene", "Антиалиасинг: сцена")))
        .with(aliased("sampled", text!("↓ sample", "↓ дискретизация"), &plain, rates[0], false)?)
        .with(honest("filtered", text!("↓ filter, ↓ sample", "↓ фильтр, ↓ дискретизация"), &filtered, false))
        .with(aliased("sampled-again", text!("↓ sample again", "↓ ещё раз"), &plain_half, rates[1], true)?)
        .with(honest("filtered-again", text!("↓ filter, ↓ sample again", "↓ фильтр, ↓ ещё раз"), &filtered_half, true))
        .claim(
            text!(
                "sampled once, the fast packet of frequency {} is a packet of frequency {}, in every sample",
                "после первой дискретизации быстрый пакет частоты {} во всех отсчётах равен пакету частоты {}",
                number(fast, 4),
                number(fold(fast, rates[0]), 4)
            ),
            // both cosines reduce 2fx, off by ε/2 of itself, at |x − middle| ≤ 112
            Residual::at_most("samples of the packet = samples of its alias", wrong, 4.0 * PI * f64::EPSILON * 112.0),
        )
        .claim(
            text!(
                "without a filter the ghost has the full contrast {}",
                "без фильтра контраст ложной волны полный: {}",
                number(ghost(&plain), 3)
            ),
            // the tails of two neighbours, 32 samples away
            Residual::near(
                "the ghost is as strong as the packet",
                ghost(&plain),
                1.0,
                2.0 * (-0.5 * (32.0 / DEVIATION).powi(2)).exp(),
            ),
        )
        .claim(
            text!(
                "with a filter first, less than a thousandth of the fast packet is left, and the others are untouched",
                "с фильтром от быстрого пакета остаётся меньше тысячной, а остальные не тронуты"
            ),
            Residual::at_most("filtered samples = slow + middle packet", kept, strays(&seconds, 0.5)),
        )
        .claim(
            text!(
                "the same after the second filter: only the slow packet is left",
                "то же после второго фильтра: остаётся только медленный пакет"
            ),
            Residual::at_most(
                "twice filtered samples = slow packet",
                kept_half,
                strays(&seconds, 0.5) + strays(&[(&middle, frequencies[1])], 0.25),
            ),
        ))
}

/// How much the ideal low-pass may err: what packets from above the cut-off have below it, and the others above it,
/// summed over the bins of the record, plus the rounding of the transforms.
fn strays(packets: &[(&Packet, f64)], cutoff: f64) -> f64 {
    let bin = 1.0 / RECORD;
    let wrong = |(packet, frequency): &(&Packet, f64)| {
        let spectrum = packet.spectrum();
        let last = (spectrum.extent().max(cutoff) / bin).ceil() as i64;
        let bins = (-last..=last).map(|k| k as f64 * bin);
        let astray = bins.filter(|nu| nu.abs() == cutoff || (nu.abs() < cutoff) == (*frequency > cutoff));
        astray.map(|nu| spectrum.density(nu).norm() * bin).sum::<f64>()
    };
    packets.iter().map(wrong).sum::<f64>() + 64.0 * f64::EPSILON
}

const CAUSE: Entry = Entry {
    id: "f07-cause",
    inventory: &["F07"],
    errata: &[],
    title: &Text::fixed("What causes aliasing", "Что является причиной алиасинга?"),
    caption: &Text::fixed(
        "The rate is one sample per unit. A slow tone has more than two samples a period and is the slowest curve \
         through them. Through the samples of a fast tone a slower one passes as well, and the samples cannot tell which \
         it was; a sine comes back with its sign turned over where a cosine does not.",
        "Берётся один отсчёт на единицу. У медленного тона больше двух отсчётов на период, и он — самая медленная кривая \
         через них. Через отсчёты быстрого тона проходит и более медленный, и по отсчётам их не различить; синус при этом \
         может вернуться с обратным знаком, косинус — нет.",
    ),
    params: &[
        Param::real("slow", &SLOW, 0.4, 0.05, 0.45, "cycles per sample"),
        Param::real("fast", &FAST, 0.9, 0.55, 1.45, "cycles per sample"),
    ],
    build: |params| cause(params.real("slow"), params.real("fast")),
};

fn cause(slow: f64, fast: f64) -> Result<Figure> {
    let end = 10.0;
    let axis = Axis::nodes(0.0..end + 1.0, end as usize + 1)?;
    let alias = Alias::of(fast, axis.rate())?;
    let panel = |name, title, signal: &dyn Fn(f64) -> f64, slowest: &dyn Fn(f64) -> f64, meaning, label| {
        let dots = axis.iter().map(|x| [x, signal(x)]);
        // the last panel has the scale, and those above it the legends
        let last = name == "sine";
        let x = if last { space(0.0, end) } else { unmarked(0.0, end) };
        let named = |layer: Layer, label: Text| if last { layer } else { layer.label(label) };
        Panel::new(name, title, x, unmarked(-1.25, 1.25))
            .legend(Legend::Above)
            .with(named(Layer::curve("tone", Meaning::Signal, 0.0, end, 2 * PIECES, signal), text!("tone", "тон")))
            .with(named(Layer::curve("slowest", meaning, 0.0, end, PIECES, slowest).thick().dashed(), label))
            .with(named(Layer::dots("samples", Meaning::Samples, dots), text!("samples", "отсчёты")))
    };
    let slowest = |frequency: f64| text!("slowest curve: {}", "самая медленная кривая: {}", number(frequency, 4));
    let tone = Cosine::new(slow)?;
    let stays = fold(slow, axis.rate());
    let (quick, seen) = (|x: f64| cos_pi(2.0 * fast * x), |x: f64| cos_pi(2.0 * alias.frequency() * x));
    let (odd, odd_seen) = (|x: f64| sin_pi(2.0 * fast * x), |x: f64| sin_pi(2.0 * alias.signed() * x));
    let apart =
        |a: &dyn Fn(f64) -> f64, b: &dyn Fn(f64) -> f64| axis.iter().map(|x| (a(x) - b(x)).abs()).fold(0.0, f64::max);
    // both tones reduce 2fx, which is off by ε/2 of itself, and are as steep as π
    let rounding = 2.0 * PI * f64::EPSILON * (fast + 1.0) * end;
    let sine_sign = if alias.conjugated() { -1.0 } else { 1.0 };
    Ok(Figure::new(1)
        .with(panel(
            "slow",
            text!("cosine of frequency {}: fast enough a rate", "косинус частоты {}: частоты хватает", number(slow, 4)),
            &|x| tone.at(x),
            &|x| cos_pi(2.0 * stays * x),
            Meaning::Reconstructed,
            slowest(stays),
        ))
        .with(panel(
            "fast",
            text!("cosine of frequency {}: too slow a rate", "косинус частоты {}: частоты не хватает", number(fast, 4)),
            &quick,
            &seen,
            Meaning::Leaked,
            slowest(alias.frequency()),
        ))
        .with(panel(
            "sine",
            match alias.conjugated() {
                true => text!("sine of frequency {}: sign flipped", "синус частоты {}: знак обратный", number(fast, 4)),
                false => text!("sine of frequency {}: sign kept", "синус частоты {}: знак сохранён", number(fast, 4)),
            },
            &odd,
            &odd_seen,
            Meaning::Leaked,
            slowest(alias.frequency()),
        ))
        .claim(
            text!(
                "the cosine of frequency {} is itself the slowest curve through its samples",
                "косинус частоты {} сам и есть самая медленная кривая через свои отсчёты",
                number(slow, 4)
            ),
            Residual::near("a frequency below Nyquist stays", stays, slow, 0.0),
        )
        .claim(
            text!(
                "the cosines of frequencies {} and {} have the same samples",
                "у косинусов частот {} и {} одни и те же отсчёты",
                number(fast, 4),
                number(alias.frequency(), 4)
            ),
            Residual::at_most("cos: samples of the tone = samples of its alias", apart(&quick, &seen), rounding),
        )
        .claim(
            match alias.conjugated() {
                true => text!("for the sine the alias has the opposite sign", "у синуса алиас имеет обратный знак"),
                false => text!("for the sine the alias keeps its sign", "у синуса алиас сохраняет знак"),
            },
            Residual::at_most(
                "sin: samples of the tone = ± samples of its alias",
                apart(&odd, &|x| sine_sign * sin_pi(2.0 * alias.frequency() * x)),
                rounding,
            ),
        ))
}
