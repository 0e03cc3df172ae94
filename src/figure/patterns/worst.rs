//! The worst that stratified patterns can do.

use crate::error::Result;
use crate::figure::params::{Param, Params};
use crate::figure::patterns::square::{SEED, SEEDS, boxes_panel, points_panel};
use crate::figure::{Entry, Figure, Layer, Meaning, Panel, Scale};
use crate::num::random::uniform;
use crate::pattern::Pattern;
use crate::pattern::cells::{Cells, within_cell};
use crate::pattern::measure::discrepancy::star_discrepancy;
use crate::pattern::measure::elementary::unfairness;
use crate::pattern::multi_jittered::MultiJittered;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[WORST];

static SIDE: Text = Text::fixed("cells along a side", "ячеек вдоль стороны");

const WORST: Entry = Entry {
    id: "x-worst-strata",
    inventory: &[],
    errata: &[],
    title: &Text::fixed("The worst that strata allow", "Худшее, что допускают страты"),
    caption: &Text::fixed(
        "Jitter promises one point in every cell, and no more: in the worst case 2n of n × n points have almost the same x, and \
         an edge there is as good as unsampled elsewhere. N rooks excludes that, but may put all points on the diagonal. \
         Multi-jitter keeps both promises. Below: points in a sliding strip of width 1/N.",
        "Джиттер обещает точку в каждой ячейке, и только: в худшем случае у 2n из n × n точек почти одинаковый x, и вертикальный \
         край видят лишь они. N ладей исключают это, но могут встать на диагональ. Мультиджиттер выполняет оба обещания. \
         Внизу — число точек в полосе ширины 1/N, которая скользит по x.",
    ),
    params: &[Param::count("n", &SIDE, 8, 4, 12), Param::count("seed", &SEED, 1, 1, SEEDS)],
    build: |params| worst(params),
};

/// The points with `x` within the strip of width `1/N` whose middle is at the edge between strips `j − 1` and `j`.
fn strips(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let n = points.len();
    let mut counts = vec![0.0; n + 1];
    points.iter().for_each(|p| counts[((p[0] * n as f64 + 0.5) as usize).min(n)] += 1.0);
    counts.into_iter().zip(0..).map(|(count, j)| [f64::from(j) / n as f64, count]).collect()
}

fn worst(params: &Params) -> Result<Figure> {
    let (side, seed) = (params.count("n"), params.count("seed") as u64);
    let cells = Cells::new([side, side])?;
    let n = cells.total();
    let random = |i: usize, d: u32| uniform(seed, i as u64, d);
    // beside the middle line the points stand next to it, elsewhere anywhere in their cells
    let beside = 0.2 / side as f64;
    let fraction = |i: usize| match cells.of(i)[0] {
        column if column + 1 == side / 2 => 1.0 - beside * random(i, 0),
        column if column == side / 2 => beside * random(i, 0),
        _ => random(i, 0),
    };
    let jittered: Vec<[f64; 2]> = (0..n).map(|i| cells.point(i, [fraction(i), random(i, 1)])).collect();
    let rooks: Vec<[f64; 2]> = (0..n).map(|i| [0, 1].map(|d| within_cell(i as u64, n as u64, random(i, d)))).collect();
    let multi = MultiJittered::new([side, side])?.points(seed);
    let top = 2.0 * side as f64;
    let below = |name, points: &[[f64; 2]]| {
        Panel::new(
            name,
            Text::EMPTY,
            Scale::linear(Text::same("x"), 0.0, 1.0),
            Scale::linear(text!("in a strip", "в полосе"), 0.0, 1.15 * top),
        )
        .with(Layer::stems("strips", Meaning::Error, strips(points)))
    };
    let most = |points: &[[f64; 2]]| strips(points).iter().map(|p| p[1]).fold(0.0, f64::max);
    let lines = |points: &[[f64; 2]]| {
        Ok::<_, crate::error::Error>(
            unfairness(points, Cells::new([n, 1])?)?.max(unfairness(points, Cells::new([1, n])?)?),
        )
    };
    let [bad, diagonal, good] = [&jittered, &rooks, &multi].map(|points| star_discrepancy(points));
    let (bad, diagonal, good) = (bad?, diagonal?, good?);
    Ok(Figure::new(3)
        .heights([1.5, 1.0])
        .with(boxes_panel("jittered", text!("jitter, at worst", "джиттер, худший"), [side, side], &jittered))
        .with(points_panel("rooks", text!("N rooks, at worst", "N ладей, худшие"), &rooks))
        .with(boxes_panel("multi", text!("multi-jitter", "мультиджиттер"), [side, side], &multi))
        .with(below("jittered-strips", &jittered))
        .with(below("rooks-strips", &rooks))
        .with(below("multi-strips", &multi))
        .claim(
            text!(
                "jitter: one point in every cell, and {} = 2n points in one strip of width 1/N",
                "джиттер: по точке в каждой ячейке и {} = 2n точек в одной полосе ширины 1/N",
                number(most(&jittered), 3)
            ),
            Residual::near(
                "points in a strip at worst = 2n",
                most(&jittered) + unfairness(&jittered, cells)?,
                top,
                0.0,
            ),
        )
        .claim(
            text!(
                "N rooks and multi-jitter: one point in every column and row, so at most 2 in any such strip",
                "N ладей и мультиджиттер: по точке в каждом столбце и строке — в любой такой полосе не больше 2"
            ),
            Residual::at_most(
                "points of rooks in a strip of width 1/N",
                most(&rooks).max(most(&multi)) + lines(&rooks)? + lines(&multi)?,
                2.0,
            ),
        )
        .claim(
            text!(
                "N rooks on the diagonal have the star discrepancy {}: the lower left quarter holds half of them",
                "звёздное расхождение ладей на диагонали {}: в левой нижней четверти их половина",
                number(diagonal, 2)
            ),
            // [0, x)² with x = k/N holds k of N points: ¼ at x = ½, and no less for the nearest k
            Residual::at_least("D* on the diagonal ≥ ¼ − 1/(4N²)", diagonal, 0.25 - 0.25 / (n as f64).powi(2)),
        )
        .claim(
            text!(
                "multi-jitter fills evenly: D* = {}, below that of the jitter at worst, {}",
                "мультиджиттер равномерен: D* = {}, меньше, чем у худшего джиттера, {}",
                number(good, 2),
                number(bad, 2)
            ),
            // just behind the line stands a whole column of cells too many: the worst jitter has at least 1/n
            Residual::at_most("D* of multi-jitter below that of the worst jitter", good, bad),
        ))
}
