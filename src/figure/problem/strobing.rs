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
        "A wheel of eight equal spokes at 2.9 turns a second, filmed with 24 frames a second: from frame to frame the \
         blue spoke runs on by almost one spoke's distance. The eye takes the nearest one (red) for it, and the wheel \
         creeps backwards. A shutter that stays open half of the time blurs the spokes but leaves most of the alias.",
        "Колесо с восемью одинаковыми спицами, 2,9 оборота в секунду, 24 кадра в секунду: от кадра к кадру синяя спица \
         проходит почти расстояние между спицами. Глаз принимает за неё ближайшую (красную), и колесо ползёт назад. \
         Затвор, открытый половину времени, смазывает спицы, но бо́льшая часть алиаса остаётся.",
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
                "{} спиц в секунду, {} кадра: видны {} спицы в секунду",
                number(frequency, 4),
                number(RATE, 2),
                number(alias.signed(), 3)
            ),
            Residual::at_most("frames of the wheel = frames of the slow one", apart, rounding),
        )
        .claim(
            text!(
                "the wheel makes {} turns a second and seems to make {}",
                "колесо делает {} оборота в секунду, а кажется, что {}",
                number(turns, 3),
                number(apparent, 3)
            ),
            // at half the rate both directions are as near
            Residual::at_most("apparent speed = folded speed", (seconds - seconds.round()).abs(), rounding),
        )
        .claim(
            text!(
                "a shutter open half of the time leaves sinc(f·τ) = {} of the spokes, and all of that aliases",
                "затвор, открытый половину времени, оставляет sinc(f·τ) = {} от спиц, и всё это — алиас",
                number(sinc(frequency * OPEN), 3)
            ),
            shutter(frequency, OPEN, sinc(frequency * OPEN))?,
        )
        .moving(motion(turns, spokes, &path), 12))
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

/// The wheel in slow motion beside what the camera saw last.
fn motion(turns: f64, spokes: usize, path: &[[f64; 2]]) -> Vec<Figure> {
    const PARTS: usize = 3;
    const SEEN: usize = 10;
    let wheel = |turned: f64| Wheel { middle: [0.0, 0.0], spokes, turned };
    let panel = |name, title, turned: f64, spoke: (Meaning, f64)| {
        let wheel = wheel(turned);
        let scale = || unmarked(-1.2, 1.2);
        Panel::new(name, title, scale(), scale())
            .square()
            .with(Layer::line("start", Meaning::Theory, [[0.0, 1.0], [0.0, 1.2]]).thick())
            .with(Layer::line("wheel", Meaning::Guide, wheel.outline()).thick())
            .with(Layer::line("spoke", spoke.0, [[0.0, 0.0], wheel.on(spoke.1, 1.0)]).thick())
    };
    let frame = |j: usize| {
        let turned = turns * j as f64 / (PARTS as f64 * RATE);
        let [at, seen] = path[j / PARTS];
        let left = text!("the wheel, {} turns/s", "колесо, {} об/с", number(turns, 3));
        let right = text!("24 frames a second: no. {}", "24 кадра в секунду: № {}", j / PARTS);
        Figure::new(2).with(panel("wheel", left, turned, (Meaning::Signal, turned))).with(panel(
            "camera",
            right,
            at,
            (Meaning::Leaked, seen),
        ))
    };
    (0..PARTS * SEEN).map(frame).collect()
}
