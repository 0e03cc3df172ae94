//! The spectrum of a table as a figure.

use crate::door::table::Heading;
use crate::error::Result;
use crate::figure::report::Quantity;
use crate::figure::report::table::with_unit;
use crate::figure::{Figure, Layer, Legend, Meaning, Panel, Portrait, Scale};
use crate::inspect::table::{LeastSquaresSpectrum, units};
use crate::record::Sampling;
use crate::sampled::window::Window;
use crate::text;
use crate::text::Text;

/// Points of a curve that can be told apart on a slide.
pub(super) const DRAWN: usize = 1600;
/// The range of amplitudes shown: a millionth of the largest.
const RANGE: f64 = 1e-6;

/// The spectra of a table's columns.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectra {
    /// The unit of the positions.
    pub unit: String,
    /// The columns and their spectra.
    pub columns: Vec<(Heading, LeastSquaresSpectrum)>,
    /// The window that they were taken under.
    pub window: Window,
    /// Whether the positions are equally spaced.
    pub uniform: bool,
}

impl Spectra {
    /// Of columns of values, each at the positions of `sampling`, which are counted in `unit`.
    ///
    /// # Errors
    /// As [`LeastSquaresSpectrum::of`].
    pub fn of(
        sampling: &Sampling,
        unit: &str,
        columns: &[(Heading, Vec<f64>)],
        window: Window,
        up_to: Option<f64>,
    ) -> Result<Self> {
        let of = |(heading, values): &(Heading, Vec<f64>)| {
            Ok((heading.clone(), LeastSquaresSpectrum::of(sampling, values, window, up_to)?))
        };
        let columns = columns.iter().map(of).collect::<Result<Vec<_>>>()?;
        Ok(Self { unit: unit.to_owned(), columns, window, uniform: sampling.axis().is_some() })
    }

    /// Frequencies in ascending order, each with the quantity of every column.
    pub fn rows(&self, quantity: Quantity) -> Vec<Vec<f64>> {
        let columns: Vec<Vec<[f64; 2]>> = self.columns.iter().map(|(_, s)| values(s, quantity)).collect();
        let count = columns.first().map_or(0, Vec::len);
        let row = |i: usize| {
            let frequency = columns[0][i][0];
            std::iter::once(frequency).chain(columns.iter().map(|column| column[i][1])).collect()
        };
        (0..count).map(row).collect()
    }

    /// The names of the columns of [`Spectra::rows`], with their units.
    pub fn names(&self, quantity: Quantity) -> Vec<Heading> {
        let first = Heading { name: "frequency".into(), unit: units::frequency(&self.unit) };
        let name = |heading: &Heading| Heading {
            name: format!("{quantity} of {}", heading.name),
            unit: unit(&heading.unit, &self.unit, quantity),
        };
        std::iter::once(first).chain(self.columns.iter().map(|(heading, _)| name(heading))).collect()
    }

    /// The picture.
    pub fn portrait(&self, file: &str, quantity: Quantity) -> Portrait {
        let (resolution, window) = (self.columns.first().map_or(0.0, |(_, s)| s.resolution()), self.window);
        let resolution = with_unit(resolution, &units::frequency(&self.unit), 4);
        let what = match quantity {
            Quantity::Amplitude => text!("amplitudes", "амплитуды"),
            Quantity::Density => text!("power densities", "спектральные плотности мощности"),
        };
        let how = match self.uniform {
            true => text!(
                "Discrete Fourier transform of equally spaced samples under the window {window}, every {resolution}.",
                "Дискретное преобразование Фурье равноотстоящих отсчётов с окном {window}, шаг {resolution}."
            ),
            false => text!(
                "At every multiple of {resolution} the sinusoid nearest to the irregular samples, weighted by the window {window} \
                 (Lomb and Scargle).",
                "На каждой частоте, кратной {resolution}, — синусоида, ближайшая к нерегулярным отсчётам с весами окна {window} \
                 (Ломб и Скаргл)."
            ),
        };
        let named = Text::of(format!("{file}: "), format!("{file}: "));
        Portrait { title: named.and(&what), caption: how, figure: Figure::new(1).with(self.panel(quantity)) }
    }

    fn panel(&self, quantity: Quantity) -> Panel {
        let all: Vec<Vec<[f64; 2]>> = self.columns.iter().map(|(_, s)| values(s, quantity)).collect();
        let label = match (self.columns.as_slice(), quantity) {
            ([(heading, _)], _) => {
                let unit = unit(&heading.unit, &self.unit, quantity);
                let shown = Heading { name: heading.name.clone(), unit }.to_string();
                Text::of(shown.clone(), shown)
            }
            (_, Quantity::Amplitude) => text!("amplitude", "амплитуда"),
            (_, Quantity::Density) => text!("power density", "плотность мощности"),
        };
        let mut panel =
            empty(&self.unit, label, &all, if quantity == Quantity::Density { RANGE * RANGE } else { RANGE });
        const NAMES: [&str; 8] = ["c1", "c2", "c3", "c4", "c5", "c6", "c7", "c8"];
        for (i, ((heading, _), points)) in self.columns.iter().zip(&all).enumerate() {
            let meaning = if self.columns.len() == 1 { Meaning::Signal } else { Meaning::Series((i % 8) as u8) };
            let layer = Layer::line(NAMES[i % 8], meaning, thinned(points)).thin();
            let label = if self.columns.len() == 1 { Text::EMPTY } else { text!("{heading}", "{heading}") };
            panel = panel.with(layer.label(label));
        }
        panel
    }
}

/// The amplitudes of one column, as a panel.
pub(super) fn panel(unit: &str, heading: &Heading, spectrum: &LeastSquaresSpectrum) -> Panel {
    let points = values(spectrum, Quantity::Amplitude);
    let shown = heading.to_string();
    let label = Text::of(format!("amplitude, {shown}"), format!("амплитуда, {shown}"));
    let title = match heading.name.as_str() {
        "" => text!("spectrum", "спектр"),
        name => text!("spectrum of {name}", "спектр: {name}"),
    };
    let mut panel = empty(unit, label, std::slice::from_ref(&points), RANGE);
    panel.title = title;
    panel.with(Layer::line("spectrum", Meaning::Signal, thinned(&points)).thin())
}

fn empty(unit: &str, label: Text, all: &[Vec<[f64; 2]>], depth: f64) -> Panel {
    let top = all.iter().flatten().map(|p| p[1]).fold(0.0, f64::max);
    let least = all.iter().flatten().map(|p| p[1]).filter(|v| *v > 0.0).fold(top, f64::min);
    let (low, high) = if top > 0.0 { (0.7 * least.max(depth * top), 2.0 * top) } else { (0.1, 1.0) };
    let highest = all.iter().flatten().map(|p| p[0]).fold(0.0, f64::max);
    let unit = units::frequency(unit);
    let named = if unit.is_empty() {
        text!("frequency", "частота")
    } else {
        text!("frequency, {unit}", "частота, {unit}")
    };
    let x = Scale::linear(named, 0.0, 1.02 * highest);
    Panel::new("spectrum", Text::EMPTY, x, Scale::log(label, low, high)).legend(Legend::Above)
}

fn values(spectrum: &LeastSquaresSpectrum, quantity: Quantity) -> Vec<[f64; 2]> {
    match quantity {
        Quantity::Amplitude => spectrum.amplitudes().collect(),
        Quantity::Density => spectrum.densities().collect(),
    }
}

fn unit(values: &str, positions: &str, quantity: Quantity) -> String {
    match quantity {
        Quantity::Amplitude => values.to_owned(),
        Quantity::Density => units::density(values, positions),
    }
}

/// The least and the greatest of each group of neighbours, where there are more points than can be drawn.
pub(super) fn thinned(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let group = (2 * points.len()).div_ceil(DRAWN).max(2);
    if points.len() <= DRAWN {
        return points.to_vec();
    }
    let ends = |group: &[[f64; 2]]| {
        let by = |a: &&[f64; 2], b: &&[f64; 2]| a[1].total_cmp(&b[1]);
        let mut ends: Vec<[f64; 2]> =
            group.iter().min_by(by).into_iter().chain(group.iter().max_by(by)).copied().collect();
        ends.sort_by(|a, b| a[0].total_cmp(&b[0]));
        ends
    };
    points.chunks(group).flat_map(ends).collect()
}
