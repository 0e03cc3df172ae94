//! The sphere out of focus (slide «Пример: разфокусированная сфера»): strata of the lens are what helps.

use crate::error::Result;
use crate::figure::params::{Param, Params};
use crate::figure::picture::{colors, grey};
use crate::figure::synthesis::rendered::{Measured, Repeated, colored, sampled, squared_error};
use crate::figure::{Bar, Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::image::Image;
use crate::laws::jitter::deviations;
use crate::pattern::Pattern;
use crate::pattern::padded::{Association, Padded};
use crate::pattern::random::Random;
use crate::residual::Residual;
use crate::scene::catalog::defocus as scene;
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[DEFOCUS];

static APERTURE: Text = Text::fixed("diameter of the lens", "диаметр линзы");
static SEED: Text = Text::fixed("seed", "зерно");

const DEFOCUS: Entry = Entry {
    id: "f53-defocus",
    inventory: &["F53"],
    errata: &["E17"],
    title: &Text::fixed("A sphere out of focus", "Расфокусированная сфера"),
    caption: &Text::fixed(
        "The same 16 rays a pixel: at random, and in strata of the image and of the lens. What varies within a pixel \
         is the place on the lens, so the strata of the lens make the gain, and it grows with the number of rays; strata of \
         the image alone gain nothing. Groups that are not shuffled look as good at once, but err the same way each time.",
        "Те же 16 лучей на пиксель: случайно и по стратам изображения и линзы. Внутри пикселя меняется в основном точка \
         линзы, поэтому выигрыш дают страты линзы, и он растёт с числом лучей; страты одного изображения не дают ничего. \
         Без перемешивания картинка с виду не хуже, но ошибается каждый раз одинаково.",
    ),
    params: &[Param::real("A", &APERTURE, 1.0, 0.95, 1.3, ""), Param::count("seed", &SEED, 1, 1, 100)],
    build: |params| defocus(params),
};

/// Pixels in a row and rows.
const SIZE: usize = 48;
/// Samples of the reference: 55².
const MANY: usize = 3025;
/// Samples that are compared.
const COUNTS: [usize; 3] = [4, 16, 64];
/// Pictures that are averaged to see what does not average out.
const PICTURES: u64 = 16;

/// A way to take the samples.
type Way = fn(usize) -> Result<Box<dyn Pattern<5>>>;

const RANDOM: Way = |n| Ok(Box::new(Random::new(n)?));
const IMAGE: Way = |n| Ok(Box::new(Padded::with_count(n)?.stratified(true, false, false)));
const STRATIFIED: Way = |n| Ok(Box::new(Padded::with_count(n)?));
const IN_ORDER: Way = |n| Ok(Box::new(Padded::with_count(n)?.associated(Association::InOrder)));

/// The ratio of two mean squared errors, with its standard error to first order.
fn ratio(a: Measured, b: Measured) -> Measured {
    let mean = a.mean / b.mean;
    Measured { mean, error: mean * (a.error / a.mean).hypot(b.error / b.mean) }
}

/// The mean over all pixels of how much a picture varies within one: of a slope `g` over a pixel's width `g²/12`, along
/// each axis. Of the variance of `N` rays, strata of the image remove the share `1 − 1/N` of it (V17), and leave the rest,
/// which is the lens'.
fn across_pixels(picture: &Image) -> f64 {
    let (n, at) = (SIZE - 2, |i: usize, j: usize| picture.at(i, j));
    let inner = (1..=n).flat_map(|j| (1..=n).map(move |i| (i, j)));
    let slope = |(i, j): (usize, usize)| {
        let [across, down] = [0.5 * (at(i + 1, j) - at(i - 1, j)), 0.5 * (at(i, j + 1) - at(i, j - 1))];
        (across * across + down * down) / 12.0
    };
    inner.map(slope).sum::<f64>() / (n * n) as f64
}

/// The mean of several pictures of different seeds.
fn averaged(pictures: impl Iterator<Item = Result<Image>>) -> Result<Image> {
    let mut sum: Option<Image> = None;
    for picture in pictures {
        let picture = picture?.map(|v| v / PICTURES as f64);
        sum = Some(match sum {
            None => picture,
            Some(sum) => sum.with(&picture, |a, b| a + b)?,
        });
    }
    Ok(sum.expect("there is more than one picture"))
}

fn defocus(params: &Params) -> Result<Figure> {
    let (aperture, seed) = (params.real("A"), params.count("seed") as u64);
    let world = scene()?;
    let camera = world.camera().with_lens(aperture, world.camera().lens().focus())?;
    let world = world.seen_by(camera);
    let seen = colored(&world, SIZE, &Repeated::new(&Padded::with_count(MANY)?), 0)?;
    let truth = seen.luminance();
    let render = |way: Way, count: usize, seed: u64| sampled(&world, SIZE, &way(count)?, seed);

    let ways: [(&str, Way, Meaning, Text); 3] = [
        ("random", RANDOM, Meaning::Leaked, text!("random", "случайно")),
        ("image", IMAGE, Meaning::Replica, text!("image", "изображение")),
        ("stratified", STRATIFIED, Meaning::Reconstructed, text!("image and lens", "изобр. и линза")),
    ];
    let mut errors = Vec::new();
    let mut plot = Panel::new(
        "errors",
        text!("error, strata of …", "ошибка, страты …"),
        Scale::log(text!("rays a pixel", "лучей на пиксель"), 3.0, 90.0)
            .ticks(COUNTS.map(|n| (n as f64, Text::of(n.to_string(), n.to_string())))),
        Scale::log(text!("mean squared error", "средний квадрат ошибки"), 3e-7, 3e-3),
    )
    .legend(Legend::LowerLeft);
    for (name, way, meaning, label) in ways {
        let mut measured = Vec::new();
        for count in COUNTS {
            measured.push(squared_error(&render(way, count, seed)?, &truth)?);
        }
        let points: Vec<[f64; 2]> = COUNTS.iter().zip(&measured).map(|(n, m)| [*n as f64, m.mean]).collect();
        let line = Layer::line(name, meaning, points.clone()).label(label);
        plot = plot
            .with(if name == "image" { line.dashed() } else { line })
            .with(Layer::dots("measured", meaning, points));
        errors.push(measured);
    }
    let [random, stratified] = [0, 2].map(|i| &errors[i]);
    let gains = [0, 1, 2].map(|i| ratio(random[i], stratified[i]));

    // many pictures of other seeds: noise averages out, what is tied together does not
    let seeds = || (1..=PICTURES).map(|i| seed + 1000 * i);
    let several = |way: Way| averaged(seeds().map(|seed| render(way, 16, seed)));
    let (shuffled, in_order) = (several(STRATIFIED)?, several(IN_ORDER)?);
    let left = |mean: &Image, way: Way| -> Result<Measured> {
        Ok(ratio(squared_error(mean, &truth)?, squared_error(&render(way, 16, seed)?, &truth)?))
    };
    let (left_shuffled, left_in_order) = (left(&shuffled, STRATIFIED)?, left(&in_order, IN_ORDER)?);
    let error_of = |mean: &Image| mean.with(&truth, |a, b| a - b);
    let worst = 0.02;
    let shown = |way: Way| colored(&world, SIZE, &way(16)?, seed);

    // strata of the image alone: the squared error over many pictures, and what theory says that they gain
    let over = |way: Way| -> Result<Measured> {
        let each = seeds().map(|seed| squared_error(&render(way, 16, seed)?, &truth)).collect::<Result<Vec<_>>>()?;
        let sum = |of: &dyn Fn(&Measured) -> f64| each.iter().map(of).sum::<f64>() / PICTURES as f64;
        Ok(Measured { mean: sum(&|m| m.mean), error: (sum(&|m| m.error * m.error) / PICTURES as f64).sqrt() })
    };
    let (many_random, many_image) = (over(RANDOM)?, over(IMAGE)?);
    let nothing = ratio(many_image, many_random);
    let gained = across_pixels(&truth) * (1.0 - 1.0 / 16.0) / (16.0 * many_random.mean);

    let confusion = camera.circle_of_confusion(4.0) * SIZE as f64;
    let expected = 1.0 / PICTURES as f64;
    let z = deviations(4);
    Ok(Figure::new(3)
        .with(colors("reference", text!("{MANY} rays a pixel", "{MANY} лучей на пиксель"), &seen))
        .with(colors("random", text!("16 at random", "16 случайных"), &shown(RANDOM)?))
        .with(colors("stratified", text!("16 in strata", "16 по стратам"), &shown(STRATIFIED)?))
        .with(plot)
        .with(grey(
            "in-order",
            text!("mean error, not shuffled", "ошибка без перемешивания"),
            &error_of(&in_order)?,
            (-worst, worst),
        ))
        .with(
            grey("shuffled", text!("mean error, shuffled", "ошибка с ним"), &error_of(&shuffled)?, (-worst, worst))
                .bar(Bar::values(Text::EMPTY)),
        )
        .claim(
            text!(
                "the circle of confusion is {} pixels",
                "ширина кружка нерезкости в пикселях: {}",
                number(confusion, 3)
            ),
            Residual::at_least("diameter of the circle of confusion in pixels", confusion, 10.0),
        )
        .claim(
            text!(
                "16 rays in strata of image and lens: the squared error is {} times less than at random",
                "16 лучей по стратам изображения и линзы: квадрат ошибки в {} раза меньше, чем у случайных",
                number(gains[1].mean, 2)
            ),
            Residual::at_least("gain of strata with 16 rays", gains[1].mean, 3.0),
        )
        .claim(
            text!(
                "the gain grows with the number of rays: {}, {}, {} for 4, 16, 64",
                "выигрыш растёт с числом лучей: {}, {}, {} для 4, 16, 64",
                number(gains[0].mean, 2),
                number(gains[1].mean, 2),
                number(gains[2].mean, 2)
            ),
            Residual::at_least(
                "least growth of the gain for four times the rays",
                (gains[1].mean / gains[0].mean).min(gains[2].mean / gains[1].mean),
                1.0,
            ),
        )
        .claim(
            text!(
                "strata of the image alone leave {} of the squared error of random rays; theory says {}",
                "страты одного изображения оставляют {} квадрата ошибки случайных лучей; теория — {}",
                number(nothing.mean, 3),
                number(1.0 - gained, 3)
            ),
            Residual::near("strata of the image / random", nothing.mean, 1.0 - gained, z * nothing.error),
        )
        .claim(
            text!(
                "shuffled, the mean of {PICTURES} pictures keeps 1/{PICTURES} of the squared error",
                "с перемешиванием у среднего {PICTURES} картинок остаётся 1/{PICTURES} квадрата ошибки"
            ),
            Residual::near("error left, shuffled", left_shuffled.mean, expected, z * left_shuffled.error),
        )
        .claim(
            text!(
                "not shuffled, {} of it is left: the error is the same in all pictures",
                "без перемешивания остаётся {}: ошибка во всех картинках одна и та же",
                number(left_in_order.mean, 2)
            ),
            Residual::at_least("error left, in order", left_in_order.mean, expected + z * left_in_order.error),
        ))
}
