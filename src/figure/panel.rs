//! Panels: a coordinate system with layers in it.

use crate::figure::layer::Layer;
use crate::text::Text;

/// One coordinate direction of a panel.
#[derive(Debug, Clone, PartialEq)]
pub struct Scale {
    /// What is counted along it.
    pub label: Text,
    /// The least and the greatest value shown.
    pub range: (f64, f64),
    /// Whether it is logarithmic (base ten); then the range is positive.
    pub log: bool,
    /// Ticks at these places with these labels; empty for automatic ones.
    pub ticks: Vec<(f64, Text)>,
    /// No ticks, no numbers.
    pub bare: bool,
}

impl Scale {
    /// A linear scale over `low..high`.
    pub fn linear(label: Text, low: f64, high: f64) -> Self {
        Self { label, range: (low, high), log: false, ticks: Vec::new(), bare: false }
    }

    /// A logarithmic scale over `low..high`.
    pub fn log(label: Text, low: f64, high: f64) -> Self {
        Self { log: true, ..Self::linear(label, low, high) }
    }

    /// With ticks of one's own.
    #[must_use]
    pub fn ticks(mut self, ticks: impl IntoIterator<Item = (f64, Text)>) -> Self {
        self.ticks = ticks.into_iter().collect();
        self
    }

    /// Without ticks and numbers.
    #[must_use]
    pub fn bare(mut self) -> Self {
        self.bare = true;
        self
    }
}

/// One coordinate system with layers in it.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Its name, unique in the figure, for tests and file names.
    pub name: &'static str,
    /// What stands above it.
    pub title: Text,
    /// The horizontal scale.
    pub x: Scale,
    /// The vertical scale.
    pub y: Scale,
    /// What is drawn, the first at the bottom.
    pub layers: Vec<Layer>,
    /// Where the list of labelled layers stands.
    pub legend: Legend,
    /// Whether one unit is equally long in both directions.
    pub square: bool,
    /// How many columns of the grid it takes.
    pub span: usize,
    /// What the tones of its raster stand for, drawn as a bar to its right.
    pub bar: Option<Bar>,
}

/// A bar of tones with numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Bar {
    label: Text,
    powers: bool,
}

impl Bar {
    /// Of the raster's values.
    pub fn values(label: Text) -> Self {
        Self { label, powers: false }
    }

    /// Of ten to the power of the raster's values.
    pub fn powers_of_ten(label: Text) -> Self {
        Self { label, powers: true }
    }

    /// Its scale beside a raster whose first and last tone stand for these values.
    pub fn scale(&self, (low, high): (f64, f64)) -> Scale {
        if self.powers {
            Scale::log(self.label.clone(), 10f64.powf(low), 10f64.powf(high))
        } else {
            Scale::linear(self.label.clone(), low, high)
        }
    }
}

/// Where a panel's legend stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Legend {
    /// In the upper right corner.
    #[default]
    UpperRight,
    /// In the upper left corner.
    UpperLeft,
    /// In the lower right corner.
    LowerRight,
    /// In the lower left corner.
    LowerLeft,
    /// In a row between the title and the plot: never over the data.
    Above,
}

impl Panel {
    /// An empty panel.
    pub fn new(name: &'static str, title: Text, x: Scale, y: Scale) -> Self {
        Self { name, title, x, y, layers: Vec::new(), legend: Legend::default(), square: false, span: 1, bar: None }
    }

    /// With one more layer on top.
    #[must_use]
    pub fn with(mut self, layer: Layer) -> Self {
        self.layers.push(layer);
        self
    }

    /// With the legend elsewhere.
    #[must_use]
    pub fn legend(mut self, legend: Legend) -> Self {
        self.legend = legend;
        self
    }

    /// With equal units in both directions.
    #[must_use]
    pub fn square(mut self) -> Self {
        self.square = true;
        self
    }

    /// Over several columns.
    #[must_use]
    pub fn span(mut self, columns: usize) -> Self {
        self.span = columns;
        self
    }

    /// With a bar that says which tone of its raster stands for which value.
    ///
    /// ```
    /// use nyquist::figure::{Bar, Layer, Panel, Scale, Tones};
    /// use nyquist::text::Text;
    /// let side = || Scale::linear(Text::EMPTY, 0.0, 1.0);
    /// let exponents = Layer::raster("errors", (0.0, 1.0), (0.0, 1.0), ndarray::arr2(&[[-4.0, -1.0]]), (-4.0, 0.0), Tones::Data);
    /// let panel = Panel::new("map", Text::EMPTY, side(), side()).with(exponents).bar(Bar::powers_of_ten(Text::EMPTY));
    /// // from −4 to 0, read as numbers from 0.0001 to 1
    /// assert_eq!(panel.bar.map(|bar| bar.scale((-4.0, 0.0)).range), Some((1e-4, 1.0)));
    /// ```
    #[must_use]
    pub fn bar(mut self, bar: Bar) -> Self {
        self.bar = Some(bar);
        self
    }

    /// The layer of that name.
    pub fn layer(&self, name: &str) -> Option<&Layer> {
        self.layers.iter().find(|l| l.name == name)
    }
}
