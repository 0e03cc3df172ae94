//! The jobs, one a file.

mod fft;
mod film;
mod plane;
mod points;
mod resize;
mod resize_peers;
mod sound;

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
pub static ALL: &[Job] = &[fft::JOB, plane::JOB, sound::JOB, resize::JOB, points::JOB, film::JOB];

/// Numbers between −1 and 1 that look random, the same in every run (SplitMix64: Steele, Lea, Flood 2014).
fn noise(n: usize) -> impl Iterator<Item = f64> {
    (1..=n as u64).map(|i| {
        let z = i.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    })
}
