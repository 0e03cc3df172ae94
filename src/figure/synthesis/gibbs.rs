//! Where aliasing comes from in pictures: edges and their ringing, small things, textures, highlights (slide «Причины
//! алиасинга в синтезе изображений»).

use crate::axis::{Axis, Edge};
use crate::error::Result;
use crate::figure::common::{signal_curve, space, values};
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel};
use crate::kernel::ideal::Ideal;
use crate::laws::gibbs::{HALF_PEAK, SAMPLED_DIP, SAMPLED_PEAK, low_passed_step, wilbraham_gibbs};
use crate::num::extremum::{Extremum, maximum};
use crate::reconstruct::reconstruct;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::{Signal, from_fn};
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[GIBBS];

static STEP: Text = Text::fixed("sampling step T", "шаг дискретизации T");
static PLACE: Text = Text::fixed("distance from the jump to the next sample, in T", "от скачка до отсчёта, в T");

const GIBBS: Entry = Entry {
    id: "f48-gibbs",
    inventory: &["F48"],
    errata: &["E15"],
    title: &Text::fixed("An edge rings: three overshoots", "Граница «звенит»: три разных выброса"),
    caption: &Text::fixed(
        "The sinc through samples of a step overshoots by 14.1 % of the jump, wherever between two samples the jump is; by \
         3.3 % if a sample sits on it with the value ½. The well-known 8.9 % of Gibbs belongs to the step itself under an \
         ideal low-pass. Not the sinc is to blame: a step has no highest frequency.",
        "Sinc по отсчётам ступеньки даёт выброс 14,1 % скачка, где бы между отсчётами он ни был, и 3,3 %, если на скачок \
         попал отсчёт со значением ½. Известные 8,9 % Гиббса — это сама ступенька за идеальным фильтром низких частот. \
         Виноват не sinc: у ступеньки нет наивысшей частоты.",
    ),
    params: &[Param::real("T", &STEP, 0.125, 0.05, 0.5, ""), Param::real("place", &PLACE, 0.5, 0.05, 0.95, "")],
    build: |params| gibbs(params),
};

/// Samples to either side of the jump; beyond them the record is continued by its ends.
const HALF: usize = 8;

/// One panel: a step, what came out of it, and its highest point.
struct Ringing<'a> {
    name: &'static str,
    title: Text,
    jump: f64,
    samples: Option<&'a Samples>,
    result: &'a dyn Signal,
    top: Extremum,
}

impl Ringing<'_> {
    fn panel(&self, step: f64) -> Panel {
        let (low, high) = (-4.5 * step, 6.5 * step);
        let (jump, overshoot) = (self.jump, self.top.value - 1.0);
        let edge = [[low, 0.0], [jump, 0.0], [jump, 1.0], [high, 1.0]];
        let note = ([self.top.at + 1.2 * step, 1.27], text!("+{} %", "+{} %", number(100.0 * overshoot, 4)));
        let mut panel = Panel::new(self.name, self.title.clone(), space(low, high), values("f(x)", -0.3, 1.4))
            .legend(Legend::Above)
            .with(Layer::horizontals("levels", Meaning::Guide, [1.0]).dashed())
            .with(Layer::line("step", Meaning::Signal, edge).label(text!("step", "ступенька")))
            .with(
                signal_curve("ringing", Meaning::Reconstructed, &self.result, low, high)
                    .thick()
                    .label(text!("result", "результат")),
            );
        if let Some(samples) = self.samples {
            let shown = samples.points().filter(|p| (low..=high).contains(&p[0]));
            panel = panel.with(Layer::dots("samples", Meaning::Samples, shown).label(text!("samples", "отсчёты")));
        }
        panel.with(Layer::dots("top", Meaning::Error, [[self.top.at, self.top.value]])).with(Layer::notes(
            "overshoot",
            Meaning::Error,
            [note],
        ))
    }
}

fn gibbs(params: &Params) -> Result<Figure> {
    let (step, place) = (params.real("T"), params.real("place"));
    let axis = Axis::centered(step, 2 * HALF)?;
    let jump = -place * step;
    let between = Samples::of(&from_fn(|x| f64::from(x > jump)), axis);
    // on the axis zero stands at index HALF exactly
    let on = Samples::of(&from_fn(|x: f64| 0.5 + 0.5 * if x == 0.0 { 0.0 } else { x.signum() }), axis);
    let ringing = reconstruct(&between, Ideal).edge(Edge::Clamp);
    let tamed = reconstruct(&on, Ideal).edge(Edge::Clamp);
    let low_passed = low_passed_step(0.5 / step);

    let top = |f: &dyn Signal, from: f64, to: f64| maximum(|x| f.at(x), from * step, to * step, 64);
    let views = [
        Ringing {
            name: "between",
            title: text!("jump between samples", "скачок между отсчётами"),
            jump,
            samples: Some(&between),
            result: &ringing,
            top: top(&ringing, 0.0, 3.0),
        },
        Ringing {
            name: "on",
            title: text!("a sample on the jump: ½", "отсчёт на скачке: ½"),
            jump: 0.0,
            samples: Some(&on),
            result: &tamed,
            top: top(&tamed, 0.0, 3.0),
        },
        Ringing {
            name: "low-passed",
            title: text!("the step itself, low-passed", "фильтр самой ступеньки"),
            jump: 0.0,
            samples: None,
            result: &low_passed,
            top: top(&low_passed, 0.0, 3.0),
        },
    ];
    let [first, second, third] = views.each_ref().map(|v| v.top);
    let dip = maximum(|x| -ringing.at(x), step, 2.0 * step, 32);
    // a value is a sum of 2·HALF terms and two closed tails, all below one
    let rounding = 8.0 * HALF as f64 * f64::EPSILON;
    // ringing of period 2T: above one in the first interval after the jump, below in the second, and so on
    let alternating = (0..HALF - 2).map(|k| {
        let excess = ringing.at((k as f64 + 0.5) * step) - 1.0;
        if k.is_multiple_of(2) { excess } else { -excess }
    });
    let figure = views.iter().fold(Figure::new(3), |figure, view| figure.with(view.panel(step)));
    Ok(figure
        .claim(
            text!(
                "between samples: +{} % of the jump, {} T after the first sample inside",
                "между отсчётами: +{} % скачка, через {} T после первого отсчёта внутри",
                number(100.0 * (first.value - 1.0), 5),
                number(first.at / step, 3)
            ),
            Residual::near("overshoot of a sampled step", first.value, SAMPLED_PEAK.value, rounding),
        )
        .claim(
            text!("then −{} %", "затем −{} %", number(100.0 * (1.0 + dip.value), 3)),
            Residual::near("undershoot after it", -dip.value, SAMPLED_DIP.value, rounding),
        )
        .claim(
            text!(
                "the ringing has the period 2T: above 1 and below it in turn",
                "период колебаний 2T: интервалы по очереди выше и ниже 1"
            ),
            Residual::at_least("sign of the ringing", alternating.fold(f64::INFINITY, f64::min), 0.0),
        )
        .claim(
            text!(
                "with a sample of ½ on the jump: +{} %, {} T after it",
                "с отсчётом ½ на скачке: +{} %, через {} T после него",
                number(100.0 * (second.value - 1.0), 4),
                number(second.at / step, 4)
            ),
            Residual::near("overshoot with ½ on the jump", second.value, HALF_PEAK.value, rounding),
        )
        .claim(
            text!(
                "the low-passed step: +{} %, at T: Gibbs",
                "ступенька за фильтром: +{} %, на расстоянии T: Гиббс",
                number(100.0 * (third.value - 1.0), 4)
            ),
            Residual::near("overshoot of the low-passed step", third.value, 0.5 + 0.5 * wilbraham_gibbs(), rounding),
        ))
}
