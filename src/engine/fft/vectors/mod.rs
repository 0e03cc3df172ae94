//! Transforms in vectors: the passes of Stockham.

mod abreast;
mod aligned;
mod number;
mod passes;
mod points;
mod streams;

pub(super) use number::Number;
pub(super) use passes::Passes;
pub(super) use abreast::Abreast;
pub(super) use aligned::line_start;
pub(super) use streams::{InTurn, InTurnTo, Input, Output};
