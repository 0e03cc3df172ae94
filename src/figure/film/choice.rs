//! How to choose a filter: between blur, alias and ringing (slide «Как выбрать фильтр?»).

use crate::error::Result;
use crate::figure::labels::labels;
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::kernel::box_kernel::BoxKernel;
use crate::kernel::catalog;
use crate::kernel::cubic::Cubic;
use crate::kernel::metrics::{Metrics, smoothing};
use crate::laws::metrics::{TABLE, agrees};
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[CHOICE];

static B: Text = Text::fixed("B of one more cubic", "B ещё одного кубического ядра");
static C: Text = Text::fixed("C of one more cubic", "C ещё одного кубического ядра");

const CHOICE: Entry = Entry {
    id: "f57-choice",
    inventory: &["F57"],
    errata: &[],
    title: &Text::fixed("Choosing a filter: blur, alias or ringing", "Как выбрать фильтр: размытие, алиас или звон"),
    caption: &Text::fixed(
        "Every filter blurs (S), lets images through (P) or rings; the ideal one does not blur and rings by 14 %. \
         Nobody is best in all three. On the curve of cubics with B + 2C = 1 one knob goes from sharp and ringing \
         (Catmull–Rom) to soft and calm (B-spline); Mitchell is the compromise.",
        "Каждый фильтр размывает (S), пропускает копии спектра (P) или звенит; идеальный не \
         размывает, но звенит на 14 %. Лучшего сразу по трём нет. На кривой кубических ядер с B + 2C = 1 одна ручка ведёт от резкого и \
         звенящего (Катмулл–Ром) к мягкому и спокойному (B-сплайн); Митчелл — компромисс.",
    ),
    params: &[Param::real("B", &B, 0.0, 0.0, 1.0, ""), Param::real("C", &C, 0.0, 0.0, 1.0, "")],
    build: |params| choice(params),
};

/// Kernels of one kind: what the kind is called, its colour, and its members by name, with what stands beside their dots.
struct Kind {
    label: Text,
    meaning: Meaning,
    members: &'static [(&'static str, Text)],
}

fn kinds() -> [Kind; 3] {
    const PLAIN: &[(&str, Text)] = &[
        ("box", Text::same("box")),
        ("tent", Text::fixed("tent", "tent")),
        ("gaussian", Text::fixed("Gauss", "Гаусс")),
        ("gaussian-pbrt2", Text::EMPTY),
    ];
    const CUBIC: &[(&str, Text)] = &[
        ("b-spline", Text::fixed("B-spline", "B-сплайн")),
        ("mitchell", Text::fixed("Mitchell", "Митчелл")),
        ("catmull-rom", Text::fixed("Catmull–Rom", "Катмулл–Ром")),
    ];
    const WINDOWED: &[(&str, Text)] = &[
        ("lanczos-3", Text::fixed("Lanczos-3", "Ланцош-3")),
        ("lanczos-2", Text::EMPTY),
        ("lanczos-4", Text::EMPTY),
        ("kaiser", Text::EMPTY),
        ("regularised", Text::EMPTY),
        ("sinc-pbrt2", Text::fixed("pbrt-2's sinc", "sinc из pbrt-2")),
        ("ideal", Text::fixed("ideal", "идеальный")),
    ];
    [
        Kind {
            label: text!("cubics, curve: B + 2C = 1", "кубические, кривая: B + 2C = 1"),
            meaning: Meaning::Kernel,
            members: CUBIC,
        },
        Kind { label: text!("never ring", "не звенят"), meaning: Meaning::Series(2), members: PLAIN },
        Kind {
            label: text!("made of sincs", "на основе sinc"), meaning: Meaning::Series(1), members: WINDOWED
        },
    ]
}

fn choice(params: &Params) -> Result<Figure> {
    let mine = Cubic::new(params.real("B"), params.real("C"))?;
    let own = Metrics::of(&mine);
    let measured = |kind: &Kind| {
        let of = |member: &(&'static str, Text)| Ok((member.0, Metrics::of(&*catalog::by_name(member.0)?)));
        kind.members.iter().map(of).collect::<Result<Vec<_>>>()
    };
    let kinds = kinds();
    let named: Vec<Vec<(&str, Metrics)>> = kinds.iter().map(measured).collect::<Result<_>>()?;
    const PARTS: u32 = 24;
    let on_line = (0..=PARTS).map(|i| {
        let b = f64::from(i) / f64::from(PARTS);
        Ok(Metrics::of(&Cubic::new(b, 0.5 * (1.0 - b))?))
    });
    let on_line = on_line.collect::<Result<Vec<_>>>()?;

    let horizontal = || Scale::linear(text!("blur S", "размытие S"), -0.03, 0.62);
    let images = Panel::new(
        "images",
        text!("blur and alias", "размытие и алиас"),
        horizontal(),
        Scale::log(text!("images P", "копии P"), 3e-5, 0.6),
    );
    let ringing = Panel::new(
        "ringing",
        text!("blur and ringing", "размытие и звон"),
        horizontal(),
        Scale::linear(text!("overshoot, %", "выброс, %"), -5.0, 17.0),
    );
    let of_images = |m: &Metrics| [m.smoothing, m.postaliasing];
    let of_ringing = |m: &Metrics| [m.smoothing, 100.0 * m.overshoot];
    let fill = |panel: Panel, place: &dyn Fn(&Metrics) -> [f64; 2]| {
        let shown = |p: &[f64; 2]| !panel.y.log || p[1] > panel.y.range.0;
        let line = Layer::line("cubics", Meaning::Kernel, on_line.iter().map(place));
        let mut filled = panel.clone().legend(Legend::Above).with(line);
        let (mut dots, mut names) = (Vec::new(), Vec::new());
        for (kind, members) in kinds.iter().zip(&named) {
            let places = || members.iter().map(|(_, metrics)| place(metrics));
            let layer = Layer::dots("kernels", kind.meaning, places().filter(shown)).label(kind.label.clone());
            filled = filled.with(layer);
            let beside = places().zip(kind.members).filter(|(p, _)| shown(p));
            beside.for_each(|(p, (_, name))| {
                dots.push(p);
                names.push(name.clone());
            });
        }
        dots.push(place(&own));
        names.push(text!("({}; {})", "({}; {})", number(mine.b(), 2), number(mine.c(), 2)));
        // names keep off the curve, too
        dots.extend(on_line.iter().map(place));
        names.resize(dots.len(), Text::EMPTY);
        filled
            .with(Layer::dots("mine", Meaning::Error, [place(&own)]))
            .with(labels("names", &panel, 32.0, &dots, &names))
    };

    let all = || named.iter().flatten();
    let of = |name: &str| all().find(|(known, _)| *known == name).map_or(own, |(_, metrics)| *metrics);
    let (boxed, mitchell) = (of("box"), of("mitchell"));
    // rounding of the weights' sum that overshoots are divided by
    let calm = all().filter(|(_, m)| m.overshoot <= 64.0 * f64::EPSILON).map(|(_, m)| m.smoothing);
    let least = calm.fold(f64::INFINITY, f64::min);
    let rows = TABLE.iter().map(|row| Ok(agrees(&*catalog::by_name(row.name)?, row)));
    let rows = rows.collect::<Result<Vec<_>>>()?;
    let worst = rows.iter().flatten().map(|r| r.measured / r.bound).fold(0.0, f64::max);
    let falling = on_line.windows(2).map(|w| {
        let (sharper, softer) = (&w[0], &w[1]);
        (softer.smoothing - sharper.smoothing).min(sharper.overshoot - softer.overshoot)
    });
    Ok(Figure::new(2)
        .with(fill(images, &of_images))
        .with(fill(ringing, &of_ringing))
        .claim(
            text!(
                "of these filters, none that does not ring blurs less than the box: S ≥ {}; but the box lets through P = {}",
                "среди этих фильтров ни один без звона не размывает меньше, чем box: S ≥ {}; но box пропускает P = {}",
                number(least, 4),
                number(boxed.postaliasing, 4)
            ),
            // both are the same quadrature, to 1e-13
            Residual::near("least blur without ringing = the blur of the box", least, smoothing(&BoxKernel), 1e-12),
        )
        .claim(
            text!(
                "along B + 2C = 1 blur grows and ringing falls; Mitchell: S = {}, P = {}, overshoot {} %",
                "вдоль B + 2C = 1 размытие растёт, а звон убывает; Митчелл: S = {}, P = {}, выброс {} %",
                number(mitchell.smoothing, 4),
                number(mitchell.postaliasing, 4),
                number(100.0 * mitchell.overshoot, 3)
            ),
            // towards the B-spline the overshoot is zero already, up to rounding
            Residual::at_least("blur grows and overshoot falls along the line", falling.fold(1.0, f64::min), -1e-12),
        )
        .claim(
            text!(
                "the numbers of nine filters are those of the independent table",
                "числа девяти фильтров совпадают с независимой таблицей"
            ),
            Residual::at_most("S, P, K(½), K(1), ripple, overshoot in half units of the last digit", worst, 1.0),
        ))
}
