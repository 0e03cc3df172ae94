//! How fast means over points converge.

use crate::error::Result;
use crate::field::checkerboard::Checkerboard;
use crate::field::{ExactMean, Field};
use crate::figure::params::Param;
use crate::figure::patterns::square::{SEED, SEEDS, for_all_seeds};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::laws::variance::{jitter_edge_constant, random_edge};
use crate::num::random::uniform;
use crate::pattern::catalog::by_name;
use crate::pattern::measure::integration::{Errors, Rate, errors, rate};
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[CONVERGENCE];

const CONVERGENCE: Entry = Entry {
    id: "x-convergence",
    inventory: &[],
    errata: &[],
    title: &Text::fixed("Mean square error against N", "Средний квадрат ошибки и число точек N"),
    caption: &Text::fixed(
        "What a pattern is worth depends on the function. Random points give 1/N for all. Jitter gives N^{−2} for a smooth \
         function, but N^{−3/2} for edges in any direction and for a pixel of the perspective checkerboard. Scrambled nets win \
         most where the function is smooth. Poisson disks look best, but in the end gain only a constant factor on random points.",
        "Чего стоит узор, зависит от функции. Случайные точки дают 1/N для любой. Джиттер — N^{−2} для гладкой, но N^{−3/2} для \
         границ любого направления и для пикселя шахматной доски в перспективе. Перемешанные сети выигрывают больше всего на \
         гладкой. Диски Пуассона красивее всех, но в конце концов выигрывают у случайных лишь постоянный множитель.",
    ),
    params: &[Param::count("seed", &SEED, 1, 1, SEEDS)],
    build: |params| convergence(params.count("seed") as u64),
};

/// Numbers of points, and of patterns tried with each.
const COUNTS: [(usize, u32); 4] = [(16, 240), (64, 240), (256, 160), (1024, 100)];

/// Patterns with their colours; Poisson disks take longer to make, so fewer are tried.
static KINDS: [(&str, Text, Meaning); 4] = [
    ("random", Text::fixed("random", "случайные"), Meaning::Series(0)),
    ("poisson-disk", Text::fixed("Poisson disk", "диски Пуассона"), Meaning::Series(1)),
    ("jittered", Text::fixed("jitter", "джиттер"), Meaning::Series(2)),
    ("sobol-owen", Text::fixed("Sobol', Owen", "Соболь, Оуэн"), Meaning::Series(3)),
];

/// `e^{x+y}`; its mean square gradient makes `N²·Var → (e² − 1)²/24` of jitter.
fn smooth(_: u64) -> (impl Fn([f64; 2]) -> f64, f64) {
    (|p: [f64; 2]| (p[0] + p[1]).exp(), 1f64.exp_m1().powi(2))
}

fn series<F: Fn([f64; 2]) -> f64>(
    name: &str,
    seed: u64,
    problem: impl Fn(u64) -> (F, f64) + Copy,
) -> Result<Vec<Errors>> {
    let measure = |(n, trials): (usize, u32)| {
        let trials = if name == "poisson-disk" { trials / 3 } else { trials };
        errors(&*by_name(name, n)?, seed, trials, problem)
    };
    COUNTS.into_iter().map(measure).collect()
}

/// One of the three panels: its errors by pattern.
struct Problem {
    name: &'static str,
    title: Text,
    measured: Vec<Vec<Errors>>,
}

impl Problem {
    fn new<F: Fn([f64; 2]) -> f64>(
        name: &'static str,
        title: Text,
        seed: u64,
        problem: impl Fn(u64) -> (F, f64) + Copy,
    ) -> Result<Self> {
        let measured = KINDS.iter().map(|(kind, ..)| series(kind, seed, problem)).collect::<Result<_>>()?;
        Ok(Self { name, title, measured })
    }

    /// The power law that fits a pattern from 64 points on.
    fn rate(&self, kind: &str) -> Result<Rate> {
        rate(&self.of(kind)[1..])
    }

    fn of(&self, kind: &str) -> &[Errors] {
        let index = KINDS.iter().position(|(known, ..)| *known == kind).unwrap_or_default();
        &self.measured[index]
    }

    fn panel(&self) -> Panel {
        let all = || self.measured.iter().flatten().map(|e| e.mean_square);
        let (low, high) = (all().fold(f64::INFINITY, f64::min), all().fold(0.0, f64::max));
        let panel = Panel::new(
            self.name,
            self.title.clone(),
            Scale::log(Text::same("N"), 12.0, 1400.0),
            Scale::log(text!("mean square error", "средний квадрат ошибки"), 0.4 * low, 2.5 * high),
        )
        .legend(Legend::LowerLeft);
        KINDS.iter().zip(&self.measured).fold(panel, |panel, ((name, label, meaning), measured)| {
            let places = || measured.iter().map(|e| [e.points, e.mean_square]);
            let label = if self.name == "smooth" { label.clone() } else { Text::EMPTY };
            panel.with(Layer::line(name, *meaning, places()).thick().label(label)).with(Layer::dots(
                "measured",
                *meaning,
                places(),
            ))
        })
    }
}

fn convergence(params_seed: u64) -> Result<Figure> {
    let board = Checkerboard::lecture(128)?;
    // pixels of the fourth row: three squares above each other, seen from a random column
    let pixel = move |seed: u64| {
        let column = (128.0 * uniform(seed, 0, 95)).floor();
        let mean = board.mean([column, column + 1.0], [4.0, 5.0]);
        (move |p: [f64; 2]| board.at(column + p[0], 4.0 + p[1]), mean)
    };
    let problems = [
        Problem::new("smooth", text!("smooth: e^{{x + y}}", "гладкая: e^{{x + y}}"), params_seed, smooth)?,
        Problem::new("edge", text!("an edge, any direction", "край любого направления"), params_seed, random_edge)?,
        Problem::new("pixel", text!("a checkerboard's pixel", "пиксель шахматной доски"), params_seed, pixel)?,
    ];
    let figure = problems.iter().fold(Figure::new(3), |figure, problem| figure.with(problem.panel()));
    let z = for_all_seeds(4);
    let slope = |problem: &Problem, kind: &str, expected: f64, bias: f64| {
        let fit = problem.rate(kind)?;
        let law = format!("{}: exponent of {kind}", problem.name);
        Ok::<_, crate::error::Error>((
            fit.exponent,
            Residual::near(law, fit.exponent, expected, z * fit.deviation + bias),
        ))
    };
    // a next term of relative size c/n, with n² points, adds less than ln(1 + c/8)/ln 16 to the slope from 64 to 1024;
    // one edge: c = 1, three of them and more: c = 4
    let bias = |c: f64| (1.0 + c / 8.0).ln() / 16f64.ln();
    let randoms = problems.iter().map(|p| Ok(slope(p, "random", -1.0, 0.0)?.1)).collect::<Result<Vec<_>>>()?;
    let worst = randoms.iter().map(|r| r.measured / r.bound).fold(0.0, f64::max);
    let [a, b, c] = [
        slope(&problems[0], "jittered", -2.0, bias(1.0))?,
        slope(&problems[1], "jittered", -1.5, bias(1.0))?,
        slope(&problems[2], "jittered", -1.5, bias(4.0))?,
    ];
    let last = |problem: &Problem| problem.of("jittered")[3];
    let (of_smooth, of_edge) = (last(&problems[0]), last(&problems[1]));
    let constant = 2f64.exp_m1().powi(2) / 24.0;
    let (nets, _) = slope(&problems[0], "sobol-owen", -3.0, 0.0)?;
    Ok(figure
        .claim(
            text!("random points: 1/N for all three", "случайные точки: 1/N для всех трёх"),
            Residual::at_most("exponent −1 of random points, in units of the bound", worst, 1.0),
        )
        .claim(
            text!(
                "jitter, smooth: exponent {}, theory −2 (scrambled Sobol': {})",
                "джиттер, гладкая: показатель {}, теория −2 (перемешанный Соболь: {})",
                number(a.0, 2),
                number(nets, 2)
            ),
            a.1,
        )
        .claim(
            text!(
                "jitter, edge: exponent {}, theory −3/2",
                "джиттер, край: показатель {}, теория −3/2",
                number(b.0, 2)
            ),
            b.1,
        )
        .claim(
            text!(
                "jitter, checkerboard: exponent {}, theory −3/2",
                "джиттер, шахматная доска: показатель {}, теория −3/2",
                number(c.0, 2)
            ),
            c.1,
        )
        .claim(
            text!(
                "jitter of e^{{x + y}}: N²·MSE = {}, theory (e² − 1)²/24 = {}",
                "джиттер для e^{{x + y}}: N²·MSE = {}, теория (e² − 1)²/24 = {}",
                number(of_smooth.mean_square * of_smooth.points.powi(2), 2),
                number(constant, 4)
            ),
            // the sum over cells is a midpoint rule: a correction of the relative order 1/n²
            Residual::near(
                "N²·MSE of jitter",
                of_smooth.mean_square,
                constant / of_smooth.points.powi(2),
                z * of_smooth.deviation + constant / of_smooth.points.powi(3),
            ),
        )
        .claim(
            text!(
                "jitter of an edge: N^{{3/2}}·MSE = {}, theory {}",
                "джиттер для края: N^{{3/2}}·MSE = {}, теория {}",
                number(of_edge.mean_square * of_edge.points.powf(1.5), 2),
                number(jitter_edge_constant(), 4)
            ),
            // cells at the square's edge are crossed as others are: a correction of the relative order 1/n
            Residual::near(
                "N^{3/2}·MSE of jitter",
                of_edge.mean_square,
                jitter_edge_constant() / of_edge.points.powf(1.5),
                z * of_edge.deviation + jitter_edge_constant() / of_edge.points.powi(2),
            ),
        ))
}
