//! The filters of the lecture's source: their graphs, their responses, and what they make of a pulse and of a chirp (V06).

use crate::axis::{Axis, Edge};
use crate::error::Result;
use crate::figure::common::{PIECES, frequency, space, unmarked, values};
use crate::figure::params::Param;
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::kernel::Kernel;
use crate::kernel::catalog::by_name;
use crate::kernel::metrics::overshoot;
use crate::laws::kernels::response_is_transform;
use crate::num::extremum::maximum;
use crate::reconstruct::reconstruct;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::Signal;
use crate::signal::lecture::{LectureChirp, LecturePulse};
use crate::text;
use crate::text::{Lang, Text, number};
use std::f64::consts::PI;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[FILTERS, PULSE_CHIRP];

static GAUSSIAN: Text = Text::fixed("which Gaussian", "какой гауссиан");
static SINC: Text = Text::fixed("which sinc", "какой sinc");
static LAST: Text = Text::fixed("the last filter", "последний фильтр");

/// The filter's name for a reader.
fn called(name: &str) -> Text {
    match name {
        "box" => text!("box", "box"),
        "tent" => text!("tent", "tent"),
        "gaussian" | "gaussian-pbrt2" => text!("Gaussian", "Гауссиан"),
        "mitchell" => text!("Mitchell", "Митчелл"),
        "lanczos-3" => text!("Lanczos-3", "Ланцош-3"),
        "ideal" => text!("ideal sinc", "идеальный sinc"),
        other => Text::of(other, other),
    }
}

const FILTERS: Entry = Entry {
    id: "x-filters",
    inventory: &[],
    errata: &[],
    title: &Text::fixed("Five filters and their responses", "Пять фильтров и их частотные характеристики"),
    caption: &Text::fixed(
        "Narrow in space means wide in frequency. The ideal response is 1 up to ν = ½ and 0 beyond: the Gaussian leaves \
         little beyond and takes much before, the box the other way round; Mitchell and Lanczos come nearer with negative \
         lobes, and pay with ringing.",
        "Узкий в пространстве — широкий по частоте. Идеальная характеристика равна 1 до ν = ½ и 0 дальше: гауссиан мало \
         пропускает дальше, но много теряет до, box — наоборот; Митчелл и Ланцош ближе к идеалу благодаря отрицательным \
         лепесткам и платят за это звоном.",
    ),
    params: &[
        Param::choice("gaussian", &GAUSSIAN, &["gaussian", "gaussian-pbrt2"]),
        Param::choice("sinc", &SINC, &["lanczos-3", "lanczos-2", "kaiser", "sinc-pbrt2"]),
    ],
    build: |params| filters(&["box", "tent", params.choice("gaussian"), "mitchell", params.choice("sinc")]),
};

/// A sentence made for each language.
fn said(sentence: impl Fn(Lang) -> String) -> Text {
    Text::of(sentence(Lang::En), sentence(Lang::Ru))
}

fn filters(names: &[&'static str]) -> Result<Figure> {
    let (reach, beyond) = (3.2, 2.0);
    let mut graphs = Panel::new(
        "kernels",
        text!("in space", "в пространстве"),
        Scale::linear(Text::same("t"), -reach, reach),
        values("k(t)", -0.3, 1.2),
    )
    .legend(Legend::Above);
    let ideal = [[0.0, 1.0], [0.5, 1.0], [0.5, 0.0], [beyond, 0.0]];
    let mut responses =
        Panel::new("responses", text!("in frequency", "по частоте"), frequency(0.0, beyond), values("K(ν)", -0.3, 1.2))
            .legend(Legend::Above)
            .with(Layer::line("ideal", Meaning::Guide, ideal).dashed().label(text!("ideal", "идеальная")));
    let mut figure = Figure::new(2);
    for (&name, n) in names.iter().zip(0..) {
        let (kernel, title) = (by_name(name)?, called(name));
        let graph = Layer::curve(name, Meaning::Series(n), -reach, reach, 1280, |t| kernel.at(t));
        graphs = graphs.with(graph.label(title.clone()));
        responses = responses.with(Layer::curve(name, Meaning::Series(n), 0.0, beyond, 200, |nu| kernel.response(nu)));
        let lowest = -maximum(|t| -kernel.at(t), 0.0, kernel.radius(), 64).value;
        let lobes = match kernel.claims().nonnegative {
            true => text!("no negative lobes", "отрицательных лепестков нет"),
            false => text!("negative lobes down to {}", "отрицательные лепестки до {}", number(lowest, 3)),
        };
        let half = number(kernel.response(0.5), 3);
        figure = figure.claim(
            said(|lang| format!("{}: K(½) = {half}, {}", title.get(lang), lobes.get(lang))),
            response_is_transform(&kernel, &[0.0, 0.25, 0.5, 1.0, 1.5]),
        );
    }
    Ok(figure.with(graphs).with(responses))
}

const PULSE_CHIRP: Entry = Entry {
    id: "x-filters-pulse-chirp",
    inventory: &[],
    errata: &["E15"],
    title: &Text::fixed("Five filters on a pulse and a chirp", "Пять фильтров: импульс и растущая частота"),
    caption: &Text::fixed(
        "The same 32 samples each time. Above (numbers: the overshoot): box and tent never leave the range of the samples, Mitchell rings a little, \
         the sinc a lot; the Gaussian blurs. Every value is divided by the sum of its weights. Below: the sharper the \
         filter, the longer it follows the chirp, up to x = 1, where Nyquist is reached.",
        "Каждый раз одни и те же 32 отсчёта. Сверху (числа — выброс): box и tent не выходят за пределы отсчётов, Митчелл немного звенит, sinc \
         сильно; гауссиан размывает. Каждое значение делится на сумму весов. Снизу: чем резче фильтр, тем дольше он следует за \
         растущей частотой — до x = 1, где она достигает частоты Найквиста.",
    ),
    params: &[Param::choice("last", &LAST, &["lanczos-3", "ideal"])],
    build: |params| pulse_chirp(&["box", "tent", "gaussian", "mitchell", params.choice("last")]),
};

fn pulse_chirp(names: &[&'static str; 5]) -> Result<Figure> {
    const STEP: f64 = 0.125;
    const ABOVE: [&str; 5] = ["pulse-1", "pulse-2", "pulse-3", "pulse-4", "pulse-5"];
    const BELOW: [&str; 5] = ["chirp-1", "chirp-2", "chirp-3", "chirp-4", "chirp-5"];
    let pulse = Samples::of(&LecturePulse, Axis::new(0.0, STEP, 32)?);
    // 16 samples are one period: the chirp has been there before x = 0 and goes on after x = 2
    let chirp = Samples::of(&LectureChirp, Axis::new(0.0, STEP, 16)?);
    let (low, high, end) = (0.6, 2.4, 1.5);
    let edge = [[low, 0.0], [1.0, 0.0], [1.0, 1.0], [2.0, 1.0], [2.0, 0.0], [high, 0.0]];
    let mut figure = Figure::new(names.len());
    let mut lower = Vec::new();
    for (i, name) in names.iter().enumerate() {
        let (kernel, title) = (by_name(name)?, called(name));
        let of_pulse = reconstruct(&pulse, &kernel);
        let of_chirp = reconstruct(&chirp, &kernel).edge(Edge::Wrap);
        // as a film does, and the metric: divided by the sum of the weights
        let divided = |signal: &dyn Signal, x: f64| signal.at(x) / kernel.periodic(x / STEP, 1);
        let top = (maximum(|x| divided(&of_pulse, x), 1.0, 1.45, 230).value - 1.0).max(0.0);
        let percent = if top < 1e-9 { "0".to_owned() } else { number(100.0 * top, 3) };
        let sign = if percent == "0" { "" } else { "+" };
        let scale = |low, high| if i == 0 { values("f(x)", low, high) } else { unmarked(low, high) };
        let back = |signal: &dyn Signal, low, high| {
            Layer::curve("back", Meaning::Reconstructed, low, high, PIECES, |x| divided(signal, x)).thick()
        };
        let upper = Panel::new(ABOVE[i], title.clone(), space(low - 0.05, high + 0.05), scale(-0.3, 1.3))
            .with(Layer::line("pulse", Meaning::Signal, edge).thin())
            .with(back(&of_pulse, low, high))
            .with(Layer::dots("samples", Meaning::Samples, pulse.points().filter(|p| (low..=high).contains(&p[0]))))
            .with(Layer::notes(
                "overshoot",
                Meaning::Error,
                [([1.5, 0.5], text!("{sign}{percent} %", "{sign}{percent} %"))],
            ));
        figure = figure.with(upper);
        lower.push(
            Panel::new(BELOW[i], Text::EMPTY, space(0.0, end), scale(-0.4, 2.4))
                .with(Layer::curve("chirp", Meaning::Signal, 0.0, end, 600, |x| LectureChirp.at(x)).thin())
                .with(Layer::verticals("nyquist", Meaning::Guide, [1.0]).dashed())
                .with(back(&of_chirp, 0.0, end)),
        );
        // the pulse's other edge is 8 samples away: beyond the radius of all but the ideal sinc, whose ringing is below
        // 1/(πd) after d samples, and d ≥ 4 here. Else rounding, 16 weights below one and the place of the maximum
        let other = if kernel.radius().is_finite() { 64.0 * f64::EPSILON } else { 1.0 / (4.0 * PI) };
        figure = figure.claim(
            said(|lang| format!("{}: {} {percent} %", title.get(lang), text!("overshoot", "выброс").get(lang))),
            Residual::near("overshoot of the pulse = that of a step", top, overshoot(&kernel), other),
        );
    }
    Ok(lower.into_iter().fold(figure, Figure::with))
}
