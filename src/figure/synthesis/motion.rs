//! Motion blur by samples of the shutter's time: moments, strata of time, and what they do to what moves (V29, V30).

use crate::error::Result;
use crate::figure::params::{Param, Params};
use crate::figure::picture::grey;
use crate::figure::synthesis::rendered::{sampled, squared_error};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::laws::hold::{shutter, uniform_transfer};
use crate::laws::jitter::deviations;
use crate::num::{cos_pi, sinc};
use crate::pattern::Pattern;
use crate::pattern::padded::Padded;
use crate::pattern::regular::Regular;
use crate::residual::Residual;
use crate::scene::camera::LensCamera;
use crate::scene::sphere::Sphere;
use crate::scene::sun::Sun;
use crate::scene::surface::Surface;
use crate::scene::world::{Sky, World};
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[MOTION];

static MOMENTS: Text = Text::fixed("moments of the shutter's time", "моментов за время затвора");
static SEED: Text = Text::fixed("seed", "зерно");

const MOTION: Entry = Entry {
    id: "x-motion",
    inventory: &["F47"],
    errata: &[],
    title: &Text::fixed("Motion blur: samples of time", "Смаз движения: отсчёты времени"),
    caption: &Text::fixed(
        "One moment freezes the sphere; a few equal moments show it several times, since what moves by a whole number of \
         periods between two of them passes unblurred. One moment in each stratum, another in every pixel, follows the open \
         shutter, sinc(w) for w periods on the way, and leaves noise. The shutter weakens strobing and does not remove it.",
        "Один момент замораживает шар, несколько равных показывают его несколько раз: что проходит между ними целое число \
         периодов, не смазывается. По одному моменту на страту, своему в каждом пикселе, — это открытый затвор, sinc(w) для \
         w периодов пути, и шум. Затвор ослабляет стробоскопический эффект, но не устраняет.",
    ),
    params: &[Param::count("moments", &MOMENTS, 4, 2, 8), Param::count("seed", &SEED, 1, 1, 100)],
    build: |params| motion(params),
};

/// What is shown black, and what white: darker and brighter than all but the ball's highlight.
const RANGE: (f64, f64) = (0.08, 0.7);
/// Pixels in a row and rows.
const SIZE: usize = 64;
/// Patterns over which the strata are averaged.
const PATTERNS: u32 = 400;
/// Samples in each of them.
const STRATA: usize = 16;

/// A sphere that rolls by on a checkered floor.
fn passing() -> Result<World> {
    let camera = LensCamera::new([0.0, 1.1, -5.0], [0.0, 0.6, 0.0], 30.0)?;
    let sun = Sun::new([-0.4, 0.8, -0.6], 2.0, [1.0; 3])?;
    let sky = Sky::new([0.3; 3], [0.15; 3])?;
    let floor = Surface::checkered([[0.25; 3], [0.45; 3]], 0.5)?;
    let ball = Surface::plain([0.85; 3])?.with_highlight(0.6, 60.0)?;
    let ball = Sphere::new([-0.95, 0.42, 0.0], 0.34, ball)?.moving([1.9, 0.0, 0.0])?;
    Ok(World::new(camera, sun, sky).with_floor(floor).with_sphere(ball))
}

/// What is left of a grating that passes `w` periods on the way while the shutter is open, by samples of time.
fn left(times: impl Iterator<Item = f64>, w: f64) -> f64 {
    let (sum, n) = times.fold((0.0, 0.0), |(sum, n), t| (sum + cos_pi(2.0 * w * (t - 0.5)), n + 1.0));
    sum / n
}

fn motion(params: &Params) -> Result<Figure> {
    let (moments, seed) = (params.count("moments"), params.count("seed") as u64);
    let world = passing()?;
    let regular = Regular::new([3, 3, moments, 1, 1])?;
    let frozen = sampled(&world, SIZE, &Regular::new([3, 3, 1, 1, 1])?, seed)?;
    let strobed = sampled(&world, SIZE, &regular, seed)?;
    let strata = sampled(&world, SIZE, &Padded::with_count(STRATA)?, seed)?;
    let blurred = sampled(&world, SIZE, &Padded::with_count(256)?, seed)?;

    // periods on the way, and what is left of them
    let most = 1.5 * moments as f64;
    let ways: Vec<f64> = (0..=24).map(|i| most * f64::from(i) / 24.0).collect();
    let times: Vec<f64> = regular.points(seed).iter().map(|s| s[2]).collect();
    let by_moments: Vec<[f64; 2]> = ways.iter().map(|&w| [w, left(times.iter().copied(), w)]).collect();
    let patterns: Vec<Vec<[f64; 5]>> = {
        let padded = Padded::with_count(STRATA)?;
        (0..u64::from(PATTERNS)).map(|i| padded.points(1000 * seed + i)).collect()
    };
    let of_patterns = |w: f64| {
        let each: Vec<f64> = patterns.iter().map(|p| left(p.iter().map(|s| s[2]), w)).collect();
        let mean = each.iter().sum::<f64>() / each.len() as f64;
        let variance = each.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / (each.len() - 1) as f64;
        (mean, (variance / each.len() as f64).sqrt())
    };
    let by_strata: Vec<(f64, f64, f64)> = ways.iter().map(|&w| (w, of_patterns(w).0, of_patterns(w).1)).collect();

    let plot = Panel::new(
        "transfer",
        text!("what is left of moving bars", "что остаётся от движущихся полос"),
        Scale::linear(text!("periods on the way, w", "периодов на пути, w"), 0.0, most),
        Scale::linear(Text::EMPTY, -1.2, 1.2),
    )
    .span(2)
    .legend(Legend::Above)
    .with(Layer::curve("open", Meaning::Theory, 0.0, most, 300, sinc).label(Text::same("sinc(w)")))
    .with(
        Layer::curve("moments", Meaning::Leaked, 0.0, most, 300, |w| uniform_transfer(moments as u32, w))
            .label(text!("{moments} moments", "моментов: {moments}")),
    )
    .with(Layer::dots("by-moments", Meaning::Leaked, by_moments.iter().copied()))
    .with(
        Layer::dots("by-strata", Meaning::Reconstructed, by_strata.iter().map(|s| [s.0, s.1]))
            .label(text!("{STRATA} strata", "страт: {STRATA}")),
    );

    let worst_moments =
        by_moments.iter().map(|[w, value]| (value - uniform_transfer(moments as u32, *w)).abs()).fold(0.0, f64::max);
    // deviations of the mean of the patterns; where all strata agree nothing deviates but the rounding of cosines
    let rounding = 64.0 * f64::EPSILON;
    let worst_strata =
        by_strata.iter().map(|(w, mean, error)| (mean - sinc(*w)).abs() / (error + rounding)).fold(0.0, f64::max);
    let [of_moments, of_strata] = [squared_error(&strobed, &blurred)?, squared_error(&strata, &blurred)?];
    Ok(Figure::new(3)
        .heights([1.0, 1.12])
        .with(grey("frozen", text!("one moment", "один момент"), &frozen, RANGE))
        .with(grey("strobed", text!("{moments} equal moments", "равных моментов: {moments}"), &strobed, RANGE))
        .with(grey("strata", text!("{STRATA} strata of time", "{STRATA} страт времени"), &strata, RANGE))
        .with(plot)
        .with(grey("blurred", text!("256 strata of time", "256 страт времени"), &blurred, RANGE))
        .claim(
            text!(
                "{moments} equal moments keep D_{{n}}(w), and bars of {moments} periods on the way fully",
                "равных моментов {moments}: остаётся D_{{n}}(w), а полосы с {moments} периодами на пути — целиком"
            ),
            Residual::at_most(
                "transfer of equal moments = D(w)",
                worst_moments,
                // the rounding of some cosines, and of the places of the moments that they multiply by w
                f64::EPSILON * (8.0 + 16.0 * std::f64::consts::PI * most),
            ),
        )
        .claim(
            text!("strata follow the open shutter, sinc(w)", "страты следуют открытому затвору, sinc(w)"),
            Residual::at_most("deviations of strata from sinc(w)", worst_strata, deviations(ways.len())),
        )
        .claim(
            text!(
                "with {STRATA} strata the squared error is {} times less than with {moments} moments and nine places",
                "с {STRATA} стратами квадрат ошибки в {} раза меньше, чем при моментах ({moments}) и девяти местах",
                number(of_moments.mean / of_strata.mean, 2)
            ),
            Residual::at_least("gain of strata over moments", of_moments.mean / of_strata.mean, 1.0),
        )
        .claim(
            text!(
                "spokes at 23.2 Hz before 24 frames a second, open for half of each: {} is left",
                "спицы с частотой 23.2 Гц, 24 кадра в секунду, открыто полкадра: остаётся {}",
                number(sinc(23.2 / 48.0), 3)
            ),
            shutter(23.2, 1.0 / 48.0, sinc(23.2 / 48.0))?,
        ))
}
