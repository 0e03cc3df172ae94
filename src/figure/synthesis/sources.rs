//! Where aliasing comes from in pictures, one dimension at a time (slide «Причины алиасинга в синтезе изображений»).

use crate::axis::Axis;
use crate::comb::Comb;
use crate::error::Result;
use crate::figure::common::{signal_curve, space, values};
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::num::cos_pi;
use crate::num::quadrature::{even_breaks, integrate_pieces};
use crate::num::special::si;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::boxcar::Boxcar;
use crate::signal::{Signal, from_fn};
use crate::text;
use crate::text::{Text, number};
use std::f64::consts::PI;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[SOURCES];

static WIDTH: Text = Text::fixed("width of a post, in pixels", "ширина столба, в пикселях");
static SHININESS: Text = Text::fixed("exponent of the highlight", "показатель блика");

const SOURCES: Entry = Entry {
    id: "f48-sources",
    inventory: &["F48"],
    errata: &["E21"],
    title: &Text::fixed("Sources of aliasing in images", "Причины алиасинга в изображениях"),
    caption: &Text::fixed(
        "Edges: twice as many samples make the error only √2 times smaller, since the spectrum falls like 1/ν (it has no \
         end, but no «infinite frequencies» either). Small objects fall between the samples. Textures become finer \
         than pixels towards the horizon. Highlights narrower than a pixel flash.",
        "Границы: вдвое больше отсчётов — ошибка меньше лишь в √2 раз, ведь спектр убывает как 1/ν (он бесконечен, но \
         «бесконечных частот» нет). Мелкие предметы попадают между отсчётами. Текстура к горизонту становится мельче \
         пикселя. Блики уже пикселя вспыхивают.",
    ),
    params: &[Param::real("width", &WIDTH, 0.3, 0.05, 0.9, "px"), Param::count("shininess", &SHININESS, 200, 50, 800)],
    build: |params| sources(params),
};

/// `‖f̃ − f‖²` for a pulse of width 1 from `start`, sampled at the multiples of `step` and reconstructed by the sinc:
/// `T Σ f² − 2 Σ f(kT)·g_k + 1`, `g_k` the pulse's scalar product with the sinc at `kT`, two sine integrals.
fn pulse_error(start: f64, step: f64) -> f64 {
    let (first, last) = ((start / step).ceil() as i64, ((start + 1.0) / step).floor() as i64);
    let count = (last - first + 1) as f64;
    let product = |k: i64| {
        let primitive = |x: f64| step / PI * si(PI * (x / step - k as f64));
        primitive(start + 1.0) - primitive(start)
    };
    step * count - 2.0 * (first..=last).map(product).sum::<f64>() + 1.0
}

/// The root mean square of the error over all places of the pulse relative to the samples.
fn edge_error(step: f64) -> f64 {
    const PLACES: u32 = 16;
    let place = |i: u32| (f64::from(i) + 0.5) / f64::from(PLACES) * step;
    ((0..PLACES).map(|i| pulse_error(place(i), step)).sum::<f64>() / f64::from(PLACES)).sqrt()
}

fn edge() -> (Panel, Vec<[f64; 2]>) {
    let errors: Vec<[f64; 2]> = (2..=7).map(|k| 1.0 / f64::from(1 << k)).map(|step| [step, edge_error(step)]).collect();
    // both jumps lose T/π² beyond Nyquist and get as much folded in: 4T/π² for the pulse
    let theory = |step: f64| 2.0 / PI * step.sqrt();
    let panel = Panel::new(
        "edge",
        text!("edges: the error falls like √T", "границы: ошибка убывает как √T"),
        Scale::log(Text::same("T"), 0.006, 0.33),
        Scale::log(text!("error", "ошибка"), 0.03, 0.6),
    )
    .legend(Legend::UpperLeft)
    .with(Layer::curve("theory", Meaning::Theory, 0.0065, 0.3, 100, theory).label(Text::same("2√T/π")))
    .with(
        Layer::dots("errors", Meaning::Error, errors.iter().copied())
            .label(text!("error of a pulse", "ошибка импульса")),
    );
    (panel, errors)
}

/// Posts a little farther apart than pixels, so that each stands elsewhere in its pixel.
fn posts(width: f64) -> Result<(Panel, f64)> {
    const DISTANCE: f64 = 1.37;
    const POSTS: u32 = 7;
    let post = Boxcar::new(width)?;
    let place = |i: u32| 0.8 + DISTANCE * f64::from(i);
    let fence = from_fn(|x: f64| (0..POSTS).map(|i| post.at(x - place(i))).sum());
    let corners = |i: u32| {
        let (left, right) = (place(i) - 0.5 * width, place(i) + 0.5 * width);
        [[left, 0.0], [left, 1.0], [right, 1.0], [right, 0.0]]
    };
    let end = 10.0;
    let samples = Samples::of(&fence, Axis::new(0.0, 1.0, end as usize + 1)?);
    // the share of places relative to the samples at which a post is seen: of 4000 places
    let tried: Vec<f64> = (0..4000).map(|i| (f64::from(i) + 0.5) / 4000.0).collect();
    let seen = |u: &&f64| (-1..=1).any(|k| post.at(f64::from(k) - **u) > 0.0);
    let share = tried.iter().filter(seen).count() as f64 / tried.len() as f64;
    let panel = Panel::new(
        "posts",
        text!("small objects: hit or miss", "мелкие предметы: попал или нет"),
        space(-0.5, end + 0.5),
        values("f(x)", -0.1, 1.3),
    )
    .legend(Legend::Above)
    .with(Layer::line("posts", Meaning::Signal, (0..POSTS).flat_map(corners)).label(text!("posts", "столбы")))
    .with(Layer::stems("samples", Meaning::Samples, samples.points()).label(text!("samples", "отсчёты")));
    Ok((panel, share))
}

/// `cos(2πd²/Y)`: a floor of stripes in perspective; `Y` rows under the horizon a row spans `d²/Y²` stripes.
fn texture() -> Result<(Panel, f64, f64)> {
    const ROW: f64 = 60.0;
    let floor = from_fn(|y: f64| cos_pi(2.0 * ROW * ROW / y));
    // at whole rows `Y` adds whole turns: the same samples, and slow where a row spans one stripe
    let seen = from_fn(|y: f64| cos_pi(2.0 * (ROW * ROW / y + y)));
    let (low, high) = (48.0, 76.0);
    let samples = Samples::of(&floor, Axis::new(low, 1.0, 29)?);
    let panel = Panel::new(
        "texture",
        text!("textures: false wide stripes", "текстуры: ложные полосы"),
        Scale::linear(text!("rows under the horizon", "строк ниже горизонта"), low - 0.5, high + 0.5),
        values("f", -1.25, 1.25),
    )
    .legend(Legend::Above)
    .with(
        Layer::curve("floor", Meaning::Signal, low, high, 1600, |y| floor.at(y))
            .thin()
            .label(text!("stripes", "полосы")),
    )
    .with(signal_curve("seen", Meaning::Leaked, &seen, low, high).thick().label(text!("what is seen", "что видно")))
    .with(Layer::dots("samples", Meaning::Samples, samples.points()).label(text!("samples", "отсчёты")));
    let beside = floor.at(ROW - 1.0).min(floor.at(ROW + 1.0));
    Ok((panel, ROW, beside))
}

/// A highlight `max(0, cos θ)^p` that wanders over pixels while the normal turns by half a radian in each.
fn highlight(shininess: usize) -> Result<(Panel, [f64; 2], f64)> {
    const TURN: f64 = 0.5;
    let lobe = move |x: f64| if (TURN * x).abs() < 0.5 * PI { (TURN * x).cos().powi(shininess as i32) } else { 0.0 };
    let reach = 0.5 * PI / TURN;
    let centres = Comb::new(1.0)?.axis(-10..=14)?;
    let point = |at: f64| centres.iter().map(|x| lobe(x - at)).sum::<f64>();
    let area = |at: f64| {
        let breaks = even_breaks(-reach, reach, 0.125);
        let pixel = |x: f64| {
            let inside: Vec<f64> = breaks.iter().map(|b| b + at).filter(|b| (b - x).abs() < 0.5).collect();
            let edges = [vec![x - 0.5], inside, vec![x + 0.5]].concat();
            integrate_pieces(|y| lobe(y - at), &edges, 1e-15).value
        };
        centres.iter().map(pixel).sum::<f64>()
    };
    let (low, high) = (0.0, 4.0);
    let areas: Vec<[f64; 2]> = (0..=32).map(|i| f64::from(i) / 8.0).map(|at| [at, area(at)]).collect();
    let panel = Panel::new(
        "highlight",
        text!("highlights flash", "блики вспыхивают"),
        Scale::linear(text!("where the highlight is, px", "место блика, пиксели"), low, high),
        Scale::linear(text!("brightness", "яркость"), 0.0, 1.3),
    )
    .legend(Legend::Above)
    .with(
        Layer::curve("points", Meaning::Leaked, low, high, 400, point)
            .thick()
            .label(text!("a point a pixel", "точка на пиксель")),
    )
    .with(
        Layer::line("areas", Meaning::Reconstructed, areas.iter().copied()).thick().label(text!("its area", "площадь")),
    );
    let spread = areas.iter().map(|p| (p[1] - areas[0][1]).abs()).fold(0.0, f64::max);
    Ok((panel, [point(0.5), point(0.0)], spread))
}

fn sources(params: &Params) -> Result<Figure> {
    let (width, shininess) = (params.real("width"), params.count("shininess"));
    let (edge_panel, errors) = edge();
    let (posts_panel, share) = posts(width)?;
    let (texture_panel, row, beside) = texture()?;
    let (highlight_panel, [dark, bright], spread) = highlight(shininess)?;
    let slope = (errors[0][1] / errors[5][1]).ln() / (errors[0][0] / errors[5][0]).ln();
    // |F|² = (1 − cos 2πν)/(2π²ν²): the cosine changes the energy beyond Nyquist by T/π of itself at most (by parts)
    let ripple = errors[0][0] / PI;
    Ok(Figure::new(2)
        .with(edge_panel)
        .with(posts_panel)
        .with(texture_panel)
        .with(highlight_panel)
        .claim(
            text!(
                "edges: the error falls like T^{} (theory ½): four times the samples for half of the error",
                "границы: ошибка убывает как T^{} (теория ½): вчетверо больше отсчётов ради вдвое меньшей ошибки",
                format!("{{{}}}", number(slope, 2))
            ),
            Residual::near("slope of the error of an edge", slope, 0.5, ripple / 32f64.ln()),
        )
        .claim(
            text!(
                "a post {} px wide is seen with the probability {}",
                "столб шириной {} пикселя виден с вероятностью {}",
                number(width, 3),
                number(share, 2)
            ),
            // 4000 places: each of the two ends counts one place too many or too few
            Residual::near("probability to hit a post = its width", share, width, 2.0 / 4000.0),
        )
        .claim(
            text!(
                "texture: {row} rows under the horizon a row spans one stripe, and neighbours see the same ({} and 1)",
                "текстура: в {row} строках под горизонтом на строку приходится одна полоса, и соседи видят одно и то же \
                 ({} и 1)",
                number(beside, 3)
            ),
            // a row above d²/(d − 1) = d + 1 + 1/(d − 1) stripes: 1/(d − 1) of one beyond a whole number
            Residual::at_least("neighbours' values where a row spans one stripe", beside, cos_pi(2.0 / (row - 1.0)) - 1e-13),
        )
        .claim(
            text!(
                "a highlight flashes between {} and {}; averaged over areas its brightness is constant",
                "блик вспыхивает: от {} до {}; при усреднении по площади его яркость постоянна",
                number(dark, 2),
                number(bright, 2)
            ),
            Residual::at_most("variation of the area-sampled highlight", spread, 25.0 * 32.0 * f64::EPSILON + 1e-13),
        ))
}
