//! Exercises that check themselves.
//!
//! An exercise is one source (`exercises/NN_id.rs`): its text and hints in two languages, the answer, whose body to
//! hide is marked, wrong answers that are often given, and what is asked of an answer. From it are derived the
//! student's file ([`Exercise::stub`]) and the program that judges it ([`Exercise::program`]). What is asked is a list
//! of [`Line`]s: cases with the truth from elsewhere than the answer, and the error that is allowed. An answer that
//! gives the values of a [`Mistake`] is told what it forgot.

pub mod catalog;
mod line;
mod report;
mod source;

pub use line::{Case, Line};
pub use report::{Mistake, Report, judge, tell};
pub use source::Exercise;
