//! Star discrepancy: of one box, of the worst box, and as points become more.

use crate::error::Result;
use crate::figure::params::{Param, Params};
use crate::figure::patterns::square::{SEED, SEEDS, for_all_seeds, mean, square};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::laws::discrepancy::hammersley_discrepancy;
use crate::pattern::Pattern;
use crate::pattern::catalog::by_name;
use crate::pattern::hammersley::Hammersley;
use crate::pattern::measure::discrepancy::star_discrepancy;
use crate::pattern::measure::periodogram::pattern_seed;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[DISCREPANCY];

static BOX: Text = Text::fixed("side of the box", "сторона ящика");

const DISCREPANCY: Entry = Entry {
    id: "x-discrepancy",
    inventory: &[],
    errata: &[],
    title: &Text::fixed("Star discrepancy: the worst box", "Звёздное расхождение: худший ящик"),
    caption: &Text::fixed(
        "A box at the origin should hold as large a part of the points as its area is. The box of side 0.3 holds one of four \
         points, so it is off by 0.25 − 0.09 = 0.16; the worst of all boxes is the star discrepancy D*. For random points it \
         falls as N^{−1/2}, for jitter as N^{−3/4}, for Halton's and Hammersley's almost as 1/N.",
        "Ящик с углом в начале координат должен содержать такую долю точек, какова его площадь. В ящике со стороной 0,3 одна из \
         четырёх точек: ошибка 0,25 − 0,09 = 0,16; худший из всех ящиков даёт звёздное расхождение D*. У случайных точек оно \
         убывает как N^{−1/2}, у джиттера — как N^{−3/4}, у Холтона и Хаммерсли — почти как 1/N.",
    ),
    params: &[Param::real("b", &BOX, 0.3, 0.05, 0.95, ""), Param::count("seed", &SEED, 1, 1, SEEDS)],
    build: |params| discrepancy(params),
};

/// The part of the points in the box `[0, x) × [0, y)` less its area; `closed` counts points on its upper edges, too.
fn surplus(points: &[[f64; 2]], [x, y]: [f64; 2], closed: bool) -> f64 {
    let inside = |p: &&[f64; 2]| if closed { p[0] <= x && p[1] <= y } else { p[0] < x && p[1] < y };
    points.iter().filter(inside).count() as f64 / points.len() as f64 - x * y
}

/// The worst box, tried at all corners that points name: the textbook's way.
fn worst_box(points: &[[f64; 2]]) -> ([f64; 2], f64) {
    let along = |d: usize| points.iter().map(move |p| p[d]).chain([1.0]);
    let corners = along(0).flat_map(|x| along(1).map(move |y| [x, y]));
    let both = corners.map(|corner| (corner, surplus(points, corner, true).max(-surplus(points, corner, false))));
    both.fold(([1.0; 2], 0.0), |worst, found| if found.1 > worst.1 { found } else { worst })
}

/// The outline of a box at the origin.
fn outline([x, y]: [f64; 2]) -> [[f64; 2]; 5] {
    [[0.0, 0.0], [x, 0.0], [x, y], [0.0, y], [0.0, 0.0]]
}

/// Patterns with their colours, from the least even on.
static KINDS: [(&str, Text, Meaning); 6] = [
    ("random", Text::fixed("random", "случайные"), Meaning::Series(0)),
    ("n-rooks", Text::fixed("N rooks", "N ладей"), Meaning::Series(1)),
    ("jittered", Text::fixed("jitter", "джиттер"), Meaning::Series(2)),
    ("multi-jittered", Text::fixed("multi-jitter", "мультиджиттер"), Meaning::Series(3)),
    ("halton", Text::fixed("Halton", "Холтон"), Meaning::Series(4)),
    ("hammersley", Text::fixed("Hammersley", "Хаммерсли"), Meaning::Series(5)),
];

/// Numbers of points, and of patterns that are averaged.
const COUNTS: [(usize, u32); 4] = [(16, 60), (64, 40), (256, 24), (1024, 12)];

fn discrepancy(params: &Params) -> Result<Figure> {
    let (side, seed) = (params.real("b"), params.count("seed") as u64);
    let four: Vec<[f64; 2]> = Hammersley::new(4)?.points(0);
    let (corner, worst) = worst_box(&four);
    let own = surplus(&four, [side, side], false);
    let held = four.iter().filter(|p| p[0] < side && p[1] < side).count();
    let boxes = square("box", text!("four points and boxes", "четыре точки и ящики"))
        .legend(Legend::Above)
        .with(Layer::line("own", Meaning::Signal, outline([side, side])).thick().label(text!("b × b", "b × b")))
        .with(Layer::line("worst", Meaning::Error, outline(corner)).dashed().label(text!("the worst", "худший")))
        .with(Layer::dots("points", Meaning::Samples, four.iter().copied()));

    let mut growth = Panel::new(
        "growth",
        text!("star discrepancy against N", "звёздное расхождение и N"),
        Scale::log(Text::same("N"), 12.0, 1400.0),
        Scale::log(Text::same("D*"), 0.003, 0.6),
    )
    .span(2)
    .legend(Legend::LowerLeft);
    let mut found: Vec<Vec<[f64; 2]>> = Vec::new();
    for (name, label, meaning) in &KINDS {
        let mut means = Vec::new();
        for (n, trials) in COUNTS {
            let pattern = by_name(name, n)?;
            // without chance one is as good as many
            let trials = if matches!(*name, "halton" | "hammersley") { 1 } else { trials };
            let each = (0..trials).map(|t| star_discrepancy(&pattern.points(pattern_seed(seed, t))));
            means.push(mean(&each.collect::<Result<Vec<_>>>()?));
        }
        let places = || means.iter().zip(COUNTS).map(|([d, _], (n, _))| [n as f64, *d]);
        growth = growth.with(Layer::line(name, *meaning, places()).thick().label(label.clone())).with(Layer::dots(
            "means",
            *meaning,
            places(),
        ));
        found.push(means);
    }
    let of = |name: &str| &found[KINDS.iter().position(|(known, ..)| *known == name).unwrap_or_default()];
    let z = for_all_seeds(3);
    // slopes from 64 to 1024, and how far chance may turn them
    let slope = |name: &str| {
        let [[a, a_error], [b, b_error]] = [of(name)[1], of(name)[3]];
        ((b / a).ln() / 16f64.ln(), z * (a_error / a).hypot(b_error / b) / 16f64.ln())
    };
    let (random, random_error) = slope("random");
    let (jitter, jitter_error) = slope("jittered");
    let at_last = |name: &str| of(name)[3];
    let order = ["hammersley", "multi-jittered", "jittered", "random"].map(at_last);
    let excess = order.windows(2).map(|w| (w[0][0] + z * w[0][1]) / (w[1][0] - z * w[1][1])).fold(0.0, f64::max);
    Ok(Figure::new(3)
        .with(boxes)
        .with(growth)
        .claim(
            text!(
                "the box of side {} holds {held} of 4 points: |{held}/4 − {}| = {}",
                "в ящике со стороной {} точек: {held} из 4; |{held}/4 − {}| = {}",
                number(side, 3),
                number(side * side, 3),
                number(own.abs(), 3)
            ),
            Residual::at_most("one box is off by no more than the worst", own.abs(), worst + 4.0 * f64::EPSILON),
        )
        .claim(
            text!(
                "the worst box, tried one by one, is off by D* = {}",
                "худший ящик, найденный перебором, даёт D* = {}",
                number(worst, 3)
            ),
            Residual::near("worst box = star discrepancy", worst, star_discrepancy(&four)?, 4.0 * f64::EPSILON),
        )
        .claim(
            text!(
                "exponents of N: random {}, jitter {} (theory −1/2 and −3/4, with a logarithm)",
                "показатели при N: случайные {}, джиттер {} (теория −1/2 и −3/4, с логарифмом)",
                number(random, 2),
                number(jitter, 2)
            ),
            // √ln N in the law of jitter adds ln(ln 1024/ln 64)/(2 ln 16) = 0.09 to its slope; random points have none
            Residual::at_most(
                "slopes of D*, in units of the bound",
                ((random + 0.5).abs() / (random_error + 0.09)).max((jitter + 0.75).abs() / (jitter_error + 0.09)),
                1.0,
            ),
        )
        .claim(
            text!(
                "at N = 1024: random {}, jitter {}, multi-jitter {}, Hammersley {}",
                "при N = 1024: случайные {}, джиттер {}, мультиджиттер {}, Хаммерсли {}",
                number(at_last("random")[0], 2),
                number(at_last("jittered")[0], 2),
                number(at_last("multi-jittered")[0], 2),
                number(at_last("hammersley")[0], 2)
            ),
            Residual::at_most("each is more even than the next, with its statistical error", excess, 1.0),
        )
        .claim(
            text!(
                "Hammersley's points: the value of Halton and Zaremba",
                "точки Хаммерсли: значение Холтона и Зарембы"
            ),
            hammersley_discrepancy(&Hammersley::new(1024)?.points(0))?,
        ))
}
