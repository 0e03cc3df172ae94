//! Layers: data with a name, a meaning and a mark.

use crate::image::Rgb;
use crate::text::Text;
use ndarray::Array2;

/// What a layer stands for. A meaning has one colour throughout the lecture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Meaning {
    /// The continuous signal or its spectrum.
    Signal,
    /// Samples, weights, impulses of the comb.
    Samples,
    /// Copies of a spectrum that sampling made.
    Replica,
    /// What leaked from one copy into another: the alias.
    Leaked,
    /// The reconstructed signal or its spectrum.
    Reconstructed,
    /// A difference to the truth.
    Error,
    /// A kernel, a filter, a window, a response.
    Kernel,
    /// What theory predicts, over what was measured.
    Theory,
    /// Something of lesser weight: a limit, an edge, a helper line.
    Guide,
    /// The n-th of several things of one kind that are told apart only by colour and dash.
    Series(u8),
}

/// How strongly a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Stroke {
    /// For many lines at once.
    Thin,
    /// As usual.
    #[default]
    Normal,
    /// For the one that matters.
    Thick,
}

/// Something drawn in a panel: data with a name, a meaning and a mark.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// Its name, for tests and exported data.
    pub name: &'static str,
    /// What it stands for.
    pub meaning: Meaning,
    /// The data and the shape they are drawn in.
    pub mark: Mark,
    /// Its entry in the legend; none if empty.
    pub label: Text,
    /// How strongly its lines are drawn.
    pub stroke: Stroke,
    /// Whether its lines are dashed.
    pub dashed: bool,
}

impl Layer {
    fn new(name: &'static str, meaning: Meaning, mark: Mark) -> Self {
        Self { name, meaning, mark, label: Text::EMPTY, stroke: Stroke::default(), dashed: false }
    }

    /// A curve through points.
    pub fn line(name: &'static str, meaning: Meaning, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self::new(name, meaning, Mark::Line(points.into_iter().collect()))
    }

    /// The curve `y = f(x)` over `low..=high` at `n` equal steps.
    pub fn curve(name: &'static str, meaning: Meaning, low: f64, high: f64, n: usize, f: impl Fn(f64) -> f64) -> Self {
        let at = |i: usize| low + (high - low) * i as f64 / n as f64;
        Self::line(name, meaning, (0..=n).map(|i| [at(i), f(at(i))]))
    }

    /// Dots.
    pub fn dots(name: &'static str, meaning: Meaning, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self::new(name, meaning, Mark::Dots(points.into_iter().collect()))
    }

    /// Dots on stems from zero.
    pub fn stems(name: &'static str, meaning: Meaning, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self::new(name, meaning, Mark::Stems(points.into_iter().collect()))
    }

    /// Impulses: arrows from zero whose height is the weight.
    pub fn arrows(name: &'static str, meaning: Meaning, weights: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self::new(name, meaning, Mark::Arrows(weights.into_iter().collect()))
    }

    /// The area between a curve and zero.
    pub fn area(name: &'static str, meaning: Meaning, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self::new(name, meaning, Mark::Area(points.into_iter().map(|[x, y]| [x, 0.0, y]).collect()))
    }

    /// The area between two curves, `[x, lower, upper]`.
    pub fn between(name: &'static str, meaning: Meaning, points: impl IntoIterator<Item = [f64; 3]>) -> Self {
        Self::new(name, meaning, Mark::Area(points.into_iter().collect()))
    }

    /// Bars of that width from zero, centred at their `x`.
    pub fn bars(name: &'static str, meaning: Meaning, width: f64, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self::new(name, meaning, Mark::Bars { width, points: points.into_iter().collect() })
    }

    /// Vertical lines through the whole panel.
    pub fn verticals(name: &'static str, meaning: Meaning, at: impl IntoIterator<Item = f64>) -> Self {
        Self::new(name, meaning, Mark::Verticals(at.into_iter().collect()))
    }

    /// Horizontal lines through the whole panel.
    pub fn horizontals(name: &'static str, meaning: Meaning, at: impl IntoIterator<Item = f64>) -> Self {
        Self::new(name, meaning, Mark::Horizontals(at.into_iter().collect()))
    }

    /// Intervals of the horizontal scale, shaded from bottom to top.
    pub fn spans(name: &'static str, meaning: Meaning, intervals: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self::new(name, meaning, Mark::Spans(intervals.into_iter().collect()))
    }

    /// Pointers from one place to another.
    pub fn pointers(name: &'static str, meaning: Meaning, from_to: impl IntoIterator<Item = [[f64; 2]; 2]>) -> Self {
        Self::new(name, meaning, Mark::Pointers(from_to.into_iter().collect()))
    }

    /// Sentences at places, centred there.
    pub fn notes(name: &'static str, meaning: Meaning, notes: impl IntoIterator<Item = ([f64; 2], Text)>) -> Self {
        Self::new(name, meaning, Mark::Notes(notes.into_iter().collect()))
    }

    /// Values on a grid: `values[[iy, ix]]`, row 0 at the lowest `y`, drawn as equal cells over `x × y`, each cell of
    /// one even tone, from `low` to `high`.
    pub fn raster(
        name: &'static str,
        x: (f64, f64),
        y: (f64, f64),
        values: Array2<f64>,
        (low, high): (f64, f64),
        tones: Tones,
    ) -> Self {
        Self::new(name, Meaning::Signal, Mark::Raster { x, y, values, low, high, tones })
    }

    /// A picture in colours, drawn as equal cells over `x × y`, row 0 at the lowest `y`.
    pub fn colors(name: &'static str, x: (f64, f64), y: (f64, f64), picture: &Rgb) -> Self {
        let light = Box::new(picture.planes().each_ref().map(|plane| plane.pixels().clone()));
        Self::new(name, Meaning::Signal, Mark::Colors { x, y, light })
    }

    /// With an entry in the legend.
    #[must_use]
    pub fn label(mut self, label: Text) -> Self {
        self.label = label;
        self
    }

    /// Thin.
    #[must_use]
    pub fn thin(mut self) -> Self {
        self.stroke = Stroke::Thin;
        self
    }

    /// Thick.
    #[must_use]
    pub fn thick(mut self) -> Self {
        self.stroke = Stroke::Thick;
        self
    }

    /// Dashed.
    #[must_use]
    pub fn dashed(mut self) -> Self {
        self.dashed = true;
        self
    }

    /// The places `[x, y]` of marks that are one place per datum (lines, dots, stems, arrows, bars); empty for others.
    pub fn points(&self) -> &[[f64; 2]] {
        match &self.mark {
            Mark::Line(p) | Mark::Dots(p) | Mark::Stems(p) | Mark::Arrows(p) | Mark::Bars { points: p, .. } => p,
            _ => &[],
        }
    }
}

/// The tones that values of a raster are shown in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tones {
    /// Black to white, linear in light: for images. Encoded as sRGB when drawn.
    Grey,
    /// Dark blue over green to yellow, even to the eye: for data.
    Data,
}

/// The data of a layer and the shape they are drawn in.
#[derive(Debug, Clone, PartialEq)]
pub enum Mark {
    /// A curve; a point with a NaN lifts the pen.
    Line(Vec<[f64; 2]>),
    /// Dots.
    Dots(Vec<[f64; 2]>),
    /// Dots on stems from zero.
    Stems(Vec<[f64; 2]>),
    /// Arrows from zero to the weight.
    Arrows(Vec<[f64; 2]>),
    /// `[x, lower, upper]`, filled between.
    Area(Vec<[f64; 3]>),
    /// Bars from zero.
    Bars {
        /// How wide each is, in units of x.
        width: f64,
        /// Where their middles and tops are.
        points: Vec<[f64; 2]>,
    },
    /// Vertical lines at these `x`.
    Verticals(Vec<f64>),
    /// Horizontal lines at these `y`.
    Horizontals(Vec<f64>),
    /// Shaded intervals of `x`.
    Spans(Vec<[f64; 2]>),
    /// Pointers `[from, to]`.
    Pointers(Vec<[[f64; 2]; 2]>),
    /// Sentences centred at places.
    Notes(Vec<([f64; 2], Text)>),
    /// A grid of values.
    Raster {
        /// The horizontal interval it covers.
        x: (f64, f64),
        /// The vertical interval it covers.
        y: (f64, f64),
        /// The values, row 0 at the lowest y.
        values: Array2<f64>,
        /// The value of the first tone.
        low: f64,
        /// The value of the last tone.
        high: f64,
        /// The tones.
        tones: Tones,
    },
    /// A grid of colours in linear light, from 0 to 1.
    Colors {
        /// The horizontal interval it covers.
        x: (f64, f64),
        /// The vertical interval it covers.
        y: (f64, f64),
        /// Red, green and blue, row 0 at the lowest y.
        light: Box<[Array2<f64>; 3]>,
    },
}

impl Mark {
    /// Whether it is a grid of cells that cover what lies below.
    pub fn is_image(&self) -> bool {
        matches!(self, Self::Raster { .. } | Self::Colors { .. })
    }

    /// Rows and columns of a grid of cells; none for other marks.
    pub fn cells(&self) -> (usize, usize) {
        match self {
            Self::Raster { values, .. } => values.dim(),
            Self::Colors { light, .. } => light[0].dim(),
            _ => (0, 0),
        }
    }
}
