//! Strobing: the wheel that turns backwards (slide «Проблемы сэмплирования в компьютерной графике»).

use crate::error::Result;
use crate::figure::common::{unmarked, values};
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::laws::hold::shutter;
use crate::num::{cos_pi, sin_pi, sinc};
use crate::nyquist::Alias;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};

static TURNS: Text = Text::fixed("turns of the wheel in a second", "оборотов колеса в секунду");
static SPOKES: Text = Text::fixed("number of spokes", "число спиц");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[STROBING];

const STROBING: Entry = Entry {
    id: "f03-strobing",
    inventory: &["F03"],
    errata: &[],
    title: &Text::fixed("Sampling problems: strobing", "Проблемы сэмплирования: стробирование"),
    caption: &Text::fixed(
        "A wheel with equal spokes, filmed with 24 frames a second. From frame to frame the blue spoke runs on; the eye \
         takes the nearest one (red) for it. Eight spokes at 2.9 turns a second run on by almost one spoke's distance: the \
         wheel creeps backwards. A shutter that stays open half of the time blurs the spokes but leaves most of the alias. (The \
         animation is slowed down, or the screen would do to the wheel what the camera does.)",
        "Колесо с одинаковыми спицами, 24 кадра в секунду. От кадра к кадру синяя спица уходит вперёд, а глаз принимает за \
         неё ближайшую (красную). Восемь спиц при 2,9 оборота в секунду проходят почти расстояние между спицами, и колесо \
         ползёт назад. Затвор, открытый половину времени, смазывает спицы, но бо́льшая часть алиаса остаётся. (Анимация замедлена, \
         иначе экран сделал бы с колесом то же, что камера.)",
    ),
    params: &[Param::real("turns", &TURNS, 2.9, 0.3, 6.2, "1/s"), Param::count("spokes", &SPOKES, 8, 3, 12)],
    build: strobing,
};

/// Frames a second.
const RATE: f64 = 24.0;
/// How many frames are followed, and every how many of them are shown.
const FRAMES: usize = 22;
const EVERY: usize = 3;
/// How long the shutter is open: half of the time between two frames.
const OPEN: f64 = 0.5 / RATE;

/// A wheel, in turns clockwise from the top.
#[derive(Clone, Copy)]
struct Wheel {
    middle: [f64; 2],
    spokes: usize,
    turned: f64,
}

impl Wheel {
    fn on(&self, turns: f64, radius: f64) -> [f64; 2] {
        [self.middle[0] + radius * sin_pi(2.0 * turns), self.middle[1] + radius * cos_pi(2.0 * turns)]
    }

    /// The angle of a spoke, in turns.
    fn spoke(&self, i: usize) -> f64 {
        self.turned + i as f64 / self.spokes as f64
    }

    /// The rim, and the spokes from the hub to it.
    fn outline(&self) -> Vec<[f64; 2]> {
        let rim = (0..=60).map(|i| self.on(f64::from(i) / 60.0, 1.0)).chain([[f64::NAN; 2]]);
        let spokes = (0..self.spokes).map(|i| self.spoke(i));
        rim.chain(spokes.flat_map(|t| [self.on(t, 0.12), self.on(t, 1.0), [f64::NAN; 2]])).collect()
    }
}

/// The wheel as frames show it: where the painted spoke is, and where the one is that the eye takes for it, in turns.
fn followed(turns: f64, spokes: usize) -> Vec<[f64; 2]> {
    let pitch = 1.0 / spokes as f64;
    let mut seen = 0.0f64;
    let places = (0..FRAMES).map(|k| turns * k as f64 / RATE);
    let follow = |at: f64| {
        // of the spokes at `at` + a multiple of the pitch, the nearest to the last one followed
        let ahead = (at - seen) / pitch;
        seen += (ahead - ahead.round()) * pitch;
        [at, seen]
    };
    places.map(follow).collect()
}

fn strobing(params: &Params) -> Result<Figure> {
    let (turns, spokes) = (params.real("turns"), params.count("spokes"));
    let frequency = turns * spokes as f64;
    let alias = Alias::of(frequency, RATE)?;
    let path = followed(turns, spokes);
    let span = (FRAMES - 1) as f64 / RATE;
    let apparent = path[FRAMES - 1][1] / span;

    let wheels: Vec<Wheel> = (0..FRAMES)
        .step_by(EVERY)
        .enumerate()
        .map(|(i, k)| Wheel { middle: [2.5 * i as f64, 0.0], spokes, turned: path[k][0] })
        .collect();
    let shown = |which: usize| {
        let places = wheels.iter().zip(path.iter().step_by(EVERY)).collect::<Vec<_>>();
        places.into_iter().flat_map(move |(w, at)| [w.middle, w.on(at[which], 1.0), [f64::NAN; 2]])
    };
    let times = wheels.iter().enumerate().map(|(i, w)| {
        let frame = i * EVERY;
        ([w.middle[0], -1.45], text!("frame {frame}", "кадр {frame}"))
    });
    let width = 2.5 * (wheels.len() - 1) as f64;
    let film = Panel::new(
        "film",
        text!("every third frame", "каждый третий кадр"),
        unmarked(-1.3, width + 1.3),
        unmarked(-1.8, 1.15),
    )
    .square()
    .span(2)
    .legend(Legend::Above)
    .with(Layer::line("wheels", Meaning::Guide, wheels.iter().flat_map(Wheel::outline)))
    .with(
        Layer::line("painted", Meaning::Signal, shown(0)).thick().label(text!("the same spoke", "одна и та же спица")),
    )
    .with(
        Layer::line("followed", Meaning::Leaked, shown(1))
            .thick()
            .label(text!("the one that the eye follows", "за которой следит глаз")),
    )
    .with(Layer::notes("frames", Meaning::Guide, times));

    let figure = Figure::new(2)
        .heights([0.9, 1.0])
        .with(film)
        .with(positions(frequency, alias.signed(), &path, spokes))
        .with(gains(frequency, alias));
    let pitch = 1.0 / spokes as f64;
    // the frames of the wheel, and those of one that turns as slowly as it seems to
    let slow = alias.signed() / spokes as f64;
    let apart = path.iter().enumerate().map(|(k, at)| {
        let ahead = (at[0] - slow * k as f64 / RATE) / pitch;
        (ahead - ahead.round()).abs()
    });
    let apart = apart.fold(0.0, f64::max);
    // angles up to turns·span, rounded and divided by the pitch
    let rounding = 8.0 * f64::EPSILON * (1.0 + frequency * span);
    let seconds = (apparent - slow) * spokes as f64 / RATE;
    Ok(figure
        .claim(
            text!(
                "{} spokes a second, {} frames: the spokes are seen at {} a second",
                "спицы в секунду: {}, кадры: {}; видимые спицы в секунду: {}",
                number(frequency, 4),
                number(RATE, 2),
                number(alias.signed(), 3)
            ),
            Residual::at_most("frames of the wheel = frames of the slow one", apart, rounding),
        )
        .claim(
            text!(
                "the wheel makes {} turns a second and seems to make {}",
                "обороты колеса в секунду: {}, а видны: {}",
                number(turns, 3),
                number(apparent, 3)
            ),
            // at half the rate both directions are as near
            Residual::at_most("apparent speed = folded speed", (seconds - seconds.round()).abs(), rounding),
        )
        .claim(
            if frequency > 0.5 * RATE {
                text!(
                    "a shutter open half of the time leaves sinc(f·τ) = {} of the spokes, and all of that aliases",
                    "затвор, открытый половину времени, оставляет sinc(f·τ) = {} от спиц, и всё это — алиас",
                    number(sinc(frequency * OPEN), 3)
                )
            } else {
                text!(
                    "a shutter open half of the time leaves sinc(f·τ) = {} of the spokes: slow enough, no alias",
                    "затвор, открытый половину времени, оставляет sinc(f·τ) = {} от спиц: частота мала, алиаса нет",
                    number(sinc(frequency * OPEN), 3)
                )
            },
            shutter(frequency, OPEN, sinc(frequency * OPEN))?,
        )
        .moving(motion(turns, spokes), RATE as u16))
}

/// Where the pattern of spokes stands, in distances of spokes, against time.
fn positions(frequency: f64, alias: f64, path: &[[f64; 2]], spokes: usize) -> Panel {
    const SHOWN: usize = 13;
    let end = (SHOWN - 1) as f64 / RATE;
    let wrapped = |v: f64| v - v.round();
    // the pen is lifted where the next spoke comes in
    let saw = |speed: f64| {
        let n = 1200;
        let all = (0..=n).map(move |i| end * f64::from(i) / f64::from(n));
        let mut points: Vec<[f64; 2]> = Vec::new();
        for t in all {
            let y = wrapped(speed * t);
            if points.last().is_some_and(|p| (p[1] - y).abs() > 0.5) {
                points.push([f64::NAN; 2]);
            }
            points.push([t, y]);
        }
        points
    };
    let dots = path.iter().take(SHOWN).enumerate();
    let dots = dots.map(|(k, at)| [k as f64 / RATE, wrapped(at[1] * spokes as f64)]);
    let time = Scale::linear(text!("time, s", "время, с"), -0.01, end + 0.01);
    Panel::new(
        "positions",
        text!("place between two spokes", "место между двумя спицами"),
        time,
        values("", -0.55, 0.55),
    )
    .legend(Legend::Above)
    .with(Layer::line("true", Meaning::Signal, saw(frequency)).label(text!("wheel", "колесо")))
    .with(Layer::line("alias", Meaning::Leaked, saw(alias)).thick().label(text!("seen", "видно")))
    .with(Layer::dots("frames", Meaning::Samples, dots).label(text!("frames", "кадры")))
}

/// The spokes' frequency, its alias, and what the shutter leaves of both.
fn gains(frequency: f64, alias: Alias) -> Panel {
    let end = (1.25 * frequency).max(30.0);
    let left = sinc(frequency * OPEN).abs();
    let scale = Scale::linear(text!("spokes in a second", "спиц в секунду"), 0.0, end);
    Panel::new("gains", text!("shutter open half the time", "затвор открыт полпериода"), scale, values("", 0.0, 1.15))
        .legend(Legend::Above)
        .with(Layer::verticals("nyquist", Meaning::Guide, [0.5 * RATE]).dashed())
        .with(
            Layer::curve("shutter", Meaning::Kernel, 0.0, end, 400, |f| sinc(f * OPEN).abs())
                .label(text!("it keeps |sinc(fτ)|", "оставляет |sinc(fτ)|")),
        )
        .with(Layer::arrows("spokes", Meaning::Signal, [[frequency, left]]).thick().label(text!("spokes", "спицы")))
        .with(
            Layer::arrows("alias", Meaning::Leaked, [[alias.frequency(), left]])
                .thick()
                .label(text!("seen as", "видны как")),
        )
}

/// How many pieces the time from one frame of the camera to the next is shown in: so many that the wheel itself moves by a
/// third of the distance of its spokes at most, and is seen as it turns; the animation is that many times slower than the
/// wheel.
fn slowness(frequency: f64) -> usize {
    (3.0 * frequency / RATE).ceil().max(3.0) as usize
}

/// After how many frames the spokes stand where they stood, or nearest to it: the longest such time that is not too long.
fn period(frequency: f64, most: usize) -> usize {
    let off = |frames: usize| {
        let passed = frequency * frames as f64 / RATE;
        // to what decides nothing but the last bits
        ((passed - passed.round()).abs() * 1e6).round() as u32
    };
    (1..=most).rev().min_by_key(|frames| off(*frames)).unwrap_or(1)
}

/// The wheel in slow motion beside what the camera saw last. No spoke is marked: it would not be back when the others are.
fn motion(turns: f64, spokes: usize) -> Vec<Figure> {
    const MOST: usize = 90;
    let frequency = turns * spokes as f64;
    let slow = slowness(frequency);
    let panel = |name, title, meaning: Meaning, turned: f64| {
        let wheel = Wheel { middle: [0.0, 0.0], spokes, turned };
        let scale = || unmarked(-1.2, 1.2);
        Panel::new(name, title, scale(), scale())
            .square()
            .with(Layer::line("start", Meaning::Theory, [[0.0, 1.0], [0.0, 1.2]]).thick())
            .with(Layer::line("wheel", meaning, wheel.outline()).thick())
    };
    let frame = |j: usize| {
        let at = |pieces: usize| turns * pieces as f64 / (slow as f64 * RATE);
        let left = text!("the wheel, {slow} times slower", "колесо, замедление × {slow}");
        let right = text!("as 24 frames a second show it", "при 24 кадрах в секунду");
        Figure::new(2).with(panel("wheel", left, Meaning::Signal, at(j))).with(panel(
            "camera",
            right,
            Meaning::Leaked,
            at(j - j % slow),
        ))
    };
    (0..slow * period(frequency, (MOST / slow).max(1))).map(frame).collect()
}
