//! Job b: the power spectrum of an image. The peer is the known way: real rows, columns gathered in blocks.

use crate::jobs::{Job, noise};
use crate::machine::Machine;
use crate::race::{Contender, Outcome, Race};
use num_complex::Complex;
use nyquist::axis::Axis;
use nyquist::engine::fft::PlaneFft;
use nyquist::engine::real::Real;
use nyquist::grid::Grid;
use rayon::prelude::*;
use realfft::{RealFftPlanner, RealToComplex};
use rustfft::{Fft, FftNum, FftPlanner};
use std::sync::Arc;

pub const JOB: Job = Job { letter: "b", name: "plane", about: "power spectra of images of n × n", run };

fn run(machine: &Machine, rounds: usize) -> Vec<Outcome> {
    let mut outcomes = Vec::new();
    for n in [1024, 2048, 4096] {
        for threads in [1, 2] {
            outcomes.push(power::<f64>(n, threads, machine, rounds));
            outcomes.push(power::<f32>(n, threads, machine, rounds));
        }
    }
    outcomes
}

fn power<T: Real + FftNum>(n: usize, threads: usize, machine: &Machine, rounds: usize) -> Outcome {
    let image: Vec<T> = noise(n * n).map(T::of).collect();
    let axis = Axis::new(0.0, 1.0, n).expect("sizes are positive");
    let grid = Grid::new(axis, axis).expect("the image fits into memory");
    // each against the other: the oracles of both are in the tests of the library
    let mut half = vec![T::default(); n * (n / 2 + 1)];
    Known::new(n).power(&image, &mut half);
    let size = |value: T| value.to_f64().expect("every number is one of 64 bits");
    let differ = |out: &[T]| {
        let scale = (n * n) as f64;
        let at = |k: usize, l: usize| size(out[(l + n / 2) % n * n + (k + n / 2) % n]) * scale;
        let largest = half.iter().map(|&p| size(p)).fold(0.0, f64::max);
        let pairs = (0..n).flat_map(|l| (0..n / 2).map(move |k| (k, l)));
        pairs.map(|(k, l)| (at(k, l) - size(half[k * n + l])).abs()).fold(0.0, f64::max) / largest
    };
    let mut whole = vec![T::default(); n * n];
    PlaneFft::new(grid).power(&image, &mut whole).expect("the sizes agree");
    let theirs = differ(&whole);
    drop(whole);
    let pixels = (n * n) as f64;
    let width = size_of::<T>() as f64;
    let limit = machine.least(pixels * width * (1.0 + 2.0 + 1.0), 2.5 * pixels * pixels.log2() * width / 8.0, threads);
    let race = Race {
        case: format!("{n}², {}", if width == 8.0 { "f64" } else { "f32" }),
        threads,
        limit: Some((limit, "image, half plane out and in, and result moved once; 2.5n²·log₂n² operations".to_owned())),
        // two transforms of n numbers, squared
        allowed: 2.0 * 2.0 * 8.0 * size(T::epsilon()) * pixels.log2(),
        contenders: vec![
            Contender::ours(
                "nyquist",
                || (PlaneFft::new(grid), vec![T::default(); n * n]),
                |(fft, out)| fft.power(&image, out).expect("the sizes agree"),
                |(_, out), ()| differ(out),
            ),
            Contender::peer(
                "realfft + rustfft in blocks (half plane only)",
                || (Known::new(n), vec![T::default(); n * (n / 2 + 1)]),
                |(known, out)| known.power(&image, out),
                |_, ()| theirs,
            ),
        ],
    };
    race.run(JOB.letter, rounds)
}

/// Columns that are gathered at once.
const BLOCK: usize = 16;

/// Rows by realfft, columns by rustfft in blocks, all threads of the pool; the half plane, column after column.
struct Known<T> {
    rows: Arc<dyn RealToComplex<T>>,
    columns: Arc<dyn Fft<T>>,
    half: Vec<Complex<T>>,
    n: usize,
}

impl<T: Real + FftNum> Known<T> {
    fn new(n: usize) -> Self {
        let rows = RealFftPlanner::new().plan_fft_forward(n);
        let columns = FftPlanner::new().plan_fft_forward(n);
        Self { rows, columns, half: vec![Complex::default(); n * (n / 2 + 1)], n }
    }

    fn power(&mut self, image: &[T], out: &mut [T]) {
        let (n, width) = (self.n, self.n / 2 + 1);
        let rows = image.par_chunks(BLOCK * n).zip(self.half.par_chunks_mut(BLOCK * width));
        rows.for_each_init(
            || (vec![T::default(); n], self.rows.make_scratch_vec()),
            |(row, scratch), (pixels, bins)| {
                for (pixels, bins) in pixels.chunks(n).zip(bins.chunks_mut(width)) {
                    row.copy_from_slice(pixels);
                    self.rows.process_with_scratch(row, bins, scratch).expect("the lengths agree");
                }
            },
        );
        let half = &self.half;
        out.par_chunks_mut(BLOCK * n).enumerate().for_each_init(
            || (vec![Complex::default(); BLOCK * n], vec![Complex::default(); self.columns.get_inplace_scratch_len()]),
            |(gathered, scratch), (block, out)| {
                let count = out.len() / n;
                for (y, row) in half.chunks(width).enumerate() {
                    for (x, &value) in row[BLOCK * block..][..count].iter().enumerate() {
                        gathered[x * n + y] = value;
                    }
                }
                self.columns.process_with_scratch(&mut gathered[..count * n], scratch);
                for (power, value) in out.iter_mut().zip(&*gathered) {
                    *power = value.norm_sqr();
                }
            },
        );
    }
}
