//! Transforms in vectors as wide as the processor has them, real and imaginary parts apart.
//!
//! Many transforms of a few points ([`points`]) side by side: of one long row in passes ([`Passes`]), of the columns of an
//! image where they stand ([`Abreast`]). Products and sums are fused where the processor can.

mod abreast;
mod aligned;
mod number;
mod passes;
mod points;
mod streams;

pub(super) use abreast::Abreast;
pub(super) use aligned::line_start;
pub(super) use number::Number;
pub(super) use passes::Passes;
pub(super) use streams::{InTurn, InTurnTo, Output};
