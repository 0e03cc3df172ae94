//! Laws: functions that return what was measured and what theory allows.
//!
//! Tests, figures, the command line, notebooks and exercises all call them. A law that cannot fail is no law: each is
//! also run on an object that breaks it.

pub mod alias;
pub mod catalog;
pub mod coverage;
pub mod cubics;
pub mod discrepancy;
pub mod film;
pub mod frames;
pub mod generalised;
pub mod gibbs;
pub mod hold;
pub mod integration;
pub mod jitter;
pub mod kernels;
pub mod lattices;
pub mod metrics;
pub mod nonuniform;
pub mod plane;
pub mod point_spectra;
pub mod poisson;
pub mod scene;
pub mod spacing;
pub mod theorems;
pub mod truncation;
pub mod variance;

use crate::residual::Residual;
use crate::text::Text;

/// A theorem of the lecture that the library checks in numbers.
#[derive(Debug, Clone, Copy)]
pub struct Law {
    /// Its name, as the command line takes it: `alias-energy`.
    pub name: &'static str,
    /// Which results of the lecture's inventory it states: `V07`.
    pub inventory: &'static [&'static str],
    /// The statement.
    pub says: &'static Text,
    /// Runs it on objects for which it must hold: every residual holds.
    pub holds: fn() -> Vec<Residual>,
    /// Runs the same functions on objects that break its premise: no residual holds.
    pub breaks: fn() -> Vec<Residual>,
}
