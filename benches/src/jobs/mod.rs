//! The jobs, one a file.

mod fft;
mod plane;

use crate::machine::Machine;
use crate::race::Outcome;

/// A job: its letter, its name on the command line, and how it is run.
pub struct Job {
    /// The letter in the table.
    pub letter: &'static str,
    /// Its name.
    pub name: &'static str,
    /// What is done.
    pub about: &'static str,
    /// Runs all its cases: the machine, how often the contenders take turns.
    pub run: fn(&Machine, usize) -> Vec<Outcome>,
}

/// All of them.
pub static ALL: &[Job] = &[fft::JOB, plane::JOB];

/// Numbers between −1 and 1 that look random, the same in every run: the fractional parts of multiples of the golden ratio.
fn noise(n: usize) -> impl Iterator<Item = f64> {
    (1..=n).map(|i| 2.0 * (i as f64 * 0.618_033_988_749_894_9).fract() - 1.0)
}
