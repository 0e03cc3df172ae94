//! Figures as data: panels, named layers and claims. How they are drawn is no concern of theirs.
//!
//! A figure is built by a pure function of its [`Params`](params::Params); tests ask the data
//! (`figure.layer("alias")`), and what its caption states is a list of [`Claim`]s, each a residual computed from the
//! same data that is drawn.
//!
//! The folders are the chapters of the lecture, the files in them families of figures, and [`catalog`] knows them all.

mod layer;
mod motion;
mod panel;
pub mod params;
mod portrait;

pub mod common;
pub mod labels;
pub mod picture;

pub mod alias;
pub mod film;
pub mod formal;
pub mod further;
pub mod images;
pub mod patterns;
pub mod problem;
pub mod reconstruction;
pub mod remedy;
pub mod report;
pub mod synthesis;

pub mod catalog;

pub use layer::{Layer, Mark, Meaning, Stroke, Tones};
pub use motion::Motion;
pub use panel::{Bar, Legend, Panel, Scale};
pub use portrait::Portrait;

use crate::residual::Residual;
use crate::text::Text;

/// A figure: panels in a grid, and what is claimed of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// How many columns the grid has.
    pub columns: usize,
    /// The panels, row by row; a panel may span several columns.
    pub panels: Vec<Panel>,
    /// The relative heights of the rows; empty for equal ones.
    pub heights: Vec<f64>,
    /// What the caption states, checked.
    pub claims: Vec<Claim>,
    /// The same in motion, where a still picture does not do.
    pub motion: Option<Motion>,
}

impl Figure {
    /// A figure without panels yet, in a grid of `columns` columns.
    pub fn new(columns: usize) -> Self {
        Self { columns, panels: Vec::new(), heights: Vec::new(), claims: Vec::new(), motion: None }
    }

    /// With one more panel.
    #[must_use]
    pub fn with(mut self, panel: Panel) -> Self {
        self.panels.push(panel);
        self
    }

    /// With relative row heights.
    #[must_use]
    pub fn heights(mut self, heights: impl Into<Vec<f64>>) -> Self {
        self.heights = heights.into();
        self
    }

    /// With one more claim.
    #[must_use]
    pub fn claim(mut self, says: Text, residual: Residual) -> Self {
        self.claims.push(Claim { says, residual });
        self
    }

    /// Also in motion: these frames, so many in a second.
    #[must_use]
    pub fn moving(mut self, frames: Vec<Figure>, rate: u16) -> Self {
        self.motion = Some(Motion { frames, rate });
        self
    }

    /// The panel of that name.
    pub fn panel(&self, name: &str) -> Option<&Panel> {
        self.panels.iter().find(|p| p.name == name)
    }

    /// The first layer of that name in any panel.
    pub fn layer(&self, name: &str) -> Option<&Layer> {
        self.panels.iter().flat_map(|p| &p.layers).find(|l| l.name == name)
    }

    /// Whether every claim holds.
    pub fn holds(&self) -> bool {
        self.claims.iter().all(|c| c.residual.holds())
    }
}

/// A sentence about a figure and the number that proves it.
#[derive(Debug, Clone, PartialEq)]
pub struct Claim {
    /// What is claimed, with the measured value in it where that helps.
    pub says: Text,
    /// What was measured in the drawn data, and what theory allows.
    pub residual: Residual,
}

/// One figure of the lecture: what it is called, what it shows, and how it is computed.
#[derive(Debug, Clone, Copy)]
pub struct Entry {
    /// Its name: `f28-leak`.
    pub id: &'static str,
    /// Which entries of the lecture's inventory it covers: `F28`.
    pub inventory: &'static [&'static str],
    /// Which errata it demonstrates: `E30`.
    pub errata: &'static [&'static str],
    /// What stands above it.
    pub title: &'static Text,
    /// What stands below it: what to see, and why.
    pub caption: &'static Text,
    /// What can be set, in the order in which to explain it.
    pub params: &'static [params::Param],
    /// Computes it.
    pub build: fn(&params::Params) -> crate::error::Result<Figure>,
}

impl Entry {
    /// The figure with the default values of its parameters.
    ///
    /// # Errors
    /// Whatever its computation reports; with the defaults of the catalogue, nothing.
    pub fn figure(&self) -> crate::error::Result<Figure> {
        (self.build)(&params::Params::defaults(self.params))
    }
}
