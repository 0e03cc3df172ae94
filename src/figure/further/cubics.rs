//! The plane of the cubics (B, C): blur, images and ringing as maps (V04, V05, V06).

use crate::axis::Axis;
use crate::error::Result;
use crate::figure::labels::labels;
use crate::figure::params::Param;
use crate::figure::{Entry, Figure, Layer, Mark, Meaning, Panel, Scale, Tones};
use crate::kernel::cubic::Cubic;
use crate::kernel::metrics::Metrics;
use crate::laws::cubics::second_moment;
use crate::laws::kernels::{reproduces_constants, reproduces_lines};
use crate::num::isoline::isoline;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};
use ndarray::Array2;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[PLANE];

static GRID: Text = Text::fixed("cells of the maps along one side", "ячеек карты вдоль стороны");

const PLANE: Entry = Entry {
    id: "x-bc-plane",
    inventory: &[],
    errata: &[],
    title: &Text::fixed("The plane of the cubics", "Плоскость кубических ядер"),
    caption: &Text::fixed(
        "All cubics of Mitchell and Netravali keep constants; only those on the line B + 2C = 1 keep straight lines too. \
         Along it blur trades against ringing. Off it, below, the images of the spectrum come through (P); Mitchell's \
         (⅓, ⅓) stands on the line, a third of the way to the B-spline.",
        "Все кубические ядра Митчелла–Нетравали сохраняют константы; прямые сохраняют только ядра на линии B + 2C = 1. \
         Вдоль неё размытие меняется на звон. В стороне от неё, внизу, проходят копии спектра (P); Митчелл (⅓, ⅓) стоит на \
         линии, на трети пути к B-сплайну.",
    ),
    params: &[Param::count("grid", &GRID, 28, 12, 48)],
    build: |params| plane(params.count("grid")),
};

/// One number of the kernels over the plane, and the values whose lines are drawn.
struct Map {
    name: &'static str,
    title: Text,
    values: Array2<f64>,
    levels: &'static [f64],
}

impl Map {
    fn panel(&self, named: &[[f64; 2]], names: &[Text]) -> Panel {
        let unit = (0.0, 1.0);
        let (low, high) =
            self.values.iter().fold((f64::INFINITY, 0.0f64), |(low, high), v| (low.min(*v), high.max(*v)));
        let mut panel = Panel::new(
            self.name,
            self.title.clone(),
            Scale::linear(Text::same("B"), 0.0, 1.0),
            Scale::linear(Text::same("C"), 0.0, 1.0),
        )
        .with(Layer::raster("map", unit, unit, self.values.clone(), (low, high), Tones::Data));
        let names = labels("names", &panel, 26.0, named, names);
        let named_at: Vec<[f64; 2]> = match &names.mark {
            Mark::Notes(notes) => notes.iter().map(|note| note.0).collect(),
            _ => Vec::new(),
        };
        let mut notes = Vec::new();
        for &level in self.levels {
            let segments = isoline(&self.values, unit, unit, level);
            let pen = segments.iter().flat_map(|[a, b]| [*a, *b, [f64::NAN, f64::NAN]]);
            panel = panel.with(Layer::line("isolines", Meaning::Theory, pen).thin());
            // where the line is farthest from the named kernels, their names and line, other numbers and the frame
            let free = |p: &[f64; 2]| {
                let from = |q: &[f64; 2]| (p[0] - q[0]).abs().max(p[1] - q[1]).max(q[1] - p[1]);
                let kernels = named.iter().map(from).fold(f64::INFINITY, f64::min);
                let others = notes.iter().map(|note: &([f64; 2], Text)| from(&note.0)).fold(f64::INFINITY, f64::min);
                let frame = p[0].min(1.0 - p[0]).min(p[1]).min(1.0 - p[1]);
                let line = (p[0] + 2.0 * p[1] - 1.0).abs() / 3.0;
                // a name is about six times as wide as high
                let off = |q: &[f64; 2]| (0.4 * (p[0] - q[0]).abs()).max((p[1] - q[1]).abs());
                let words = named_at.iter().map(off).fold(f64::INFINITY, f64::min);
                kernels.min(others).min(3.0 * frame).min(2.0 * line).min(1.5 * words)
            };
            let place = segments.iter().map(|s| s[0]).max_by(|a, b| free(a).total_cmp(&free(b)));
            notes.extend(place.map(|p| (p, Text::of(number(level, 2), number(level, 2)))));
        }
        panel
            .with(Layer::line("line", Meaning::Samples, [[0.0, 0.5], [1.0, 0.0]]).thick())
            .with(Layer::dots("named", Meaning::Samples, named.iter().copied()))
            .with(Layer::notes("levels", Meaning::Guide, notes))
            .with(names)
    }
}

fn plane(grid: usize) -> Result<Figure> {
    let axis = Axis::cells(0.0..1.0, grid)?;
    let mut metrics = Vec::with_capacity(grid * grid);
    for c in axis.iter() {
        for b in axis.iter() {
            metrics.push(Metrics::of(&Cubic::new(b, c)?));
        }
    }
    let map = |name, title, levels, of: &dyn Fn(&Metrics) -> f64| Map {
        name,
        title,
        values: Array2::from_shape_fn((grid, grid), |(iy, ix)| of(&metrics[iy * grid + ix])),
        levels,
    };
    let maps = [
        map("blur", text!("blur S", "размытие S"), &[0.2, 0.25, 0.3, 0.35, 0.4, 0.45], &|m| m.smoothing),
        map("images", text!("images P", "копии P"), &[0.01, 0.02, 0.03, 0.05, 0.08], &|m| m.postaliasing),
        map("ringing", text!("overshoot, %", "выброс, %"), &[1.0, 3.0, 6.0, 9.0, 12.0], &|m| 100.0 * m.overshoot),
    ];
    let named = [Cubic::b_spline(), Cubic::mitchell(), Cubic::catmull_rom()];
    let dots = named.map(|kernel| [kernel.b(), kernel.c()]);
    let names = [
        Text::fixed("B-spline", "B-сплайн"),
        Text::fixed("Mitchell", "Митчелл"),
        Text::fixed("Catmull–Rom", "Катмулл–Ром"),
    ];

    let ratio = |r: Residual| r.measured / r.bound;
    let places = || (0..=8).map(|i| f64::from(i) / 8.0);
    let mut constants = 0.0f64;
    for b in places() {
        for c in places() {
            constants = constants.max(ratio(reproduces_constants(&Cubic::new(b, c)?)));
        }
    }
    let on_line = places().map(|b| Cubic::new(b, 0.5 * (1.0 - b))).collect::<Result<Vec<_>>>()?;
    let lines = on_line.iter().map(|kernel| ratio(reproduces_lines(kernel))).fold(0.0, f64::max);
    let moments = on_line.iter().map(|kernel| ratio(second_moment(kernel).0)).fold(0.0, f64::max);
    let off = reproduces_lines(&Cubic::new(0.0, 0.0)?).measured;
    Ok(maps
        .iter()
        .fold(Figure::new(3), |figure, map| figure.with(map.panel(&dots, &names)))
        .claim(
            text!("every (B, C) keeps constants", "любое (B, C) сохраняет константы"),
            Residual::at_most("Σk(x−i) = 1 over the plane, in units of rounding", constants, 1.0),
        )
        .claim(
            text!(
                "on B + 2C = 1 straight lines are kept; at (0, 0) they are off by {}",
                "на B + 2C = 1 сохраняются прямые; в точке (0, 0) ошибка {}",
                number(off, 2)
            ),
            Residual::at_most("Σi·k(x−i) = x on the line, in units of rounding", lines, 1.0),
        )
        .claim(
            text!(
                "there Σi²k(x−i) − x² is constant too: errors of third order",
                "там же постоянна Σi²k(x−i) − x²: ошибка третьего порядка"
            ),
            Residual::at_most("Σi²k(x−i) − x² is constant on the line, in units of rounding", moments, 1.0),
        ))
}
