//! Job h: scattered samples into pixels. No crate does it: the peer is the loop that everybody writes; see `python/film.py`
//! for libraries.

use crate::jobs::{Job, noise};
use crate::machine::Machine;
use crate::race::{Contender, Outcome, Race};
use nyquist::engine::film::{Film, Sample};
use nyquist::kernel::Kernel;
use nyquist::kernel::cubic::Cubic;
use nyquist::kernel::gaussian::GaussianKernel;

pub const JOB: Job = Job { letter: "h", name: "film", about: "16 scattered samples a pixel into n² pixels", run };

fn run(machine: &Machine, rounds: usize) -> Vec<Outcome> {
    let mut outcomes = Vec::new();
    for n in [256, 512, 1024] {
        for threads in [1, 2] {
            outcomes.push(film(n, &GaussianKernel::pbrt2(), threads, machine, rounds));
            outcomes.push(film(n, &Cubic::mitchell(), threads, machine, rounds));
        }
    }
    outcomes
}

fn film(n: usize, kernel: &dyn Kernel, threads: usize, machine: &Machine, rounds: usize) -> Outcome {
    let count = 16 * n * n;
    let numbers: Vec<f32> = noise(3 * count).map(|u| 0.5 * (u as f32 + 1.0)).collect();
    let place = |u: f32| u * n as f32;
    let samples: Vec<_> =
        numbers.chunks_exact(3).map(|u| Sample { at: [place(u[0]), place(u[1])], light: [u[2]] }).collect();
    let table: Vec<f32> = (0..=TABLE).map(|i| kernel.at(2.0 * i as f64 / TABLE as f64) as f32).collect();
    let exact = loops(n, &samples, |t| kernel.at(f64::from(t)));
    let error = |pixels: &mut dyn Iterator<Item = f32>| {
        pixels.zip(&exact).map(|(found, known)| (f64::from(found) - known).abs()).fold(0.0, f64::max)
    };
    let limit = machine.least(12.0 * count as f64, 0.5 * 2.0 * 2.0 * 16.0 * count as f64, threads);
    let race = Race {
        case: format!("{}, {n}²", kernel.name()),
        threads,
        limit: Some((limit, "samples read once; two fused multiply-adds of 32 bits a sample and pixel".to_owned())),
        // two sums of 256 numbers in single precision, and as much for tables
        allowed: 4.0 * 256.0 * f64::from(f32::EPSILON),
        contenders: vec![
            Contender::ours(
                "nyquist, f32",
                || Film::<f32>::new([n, n], kernel.radius(), |t| kernel.at(t)).expect("a kernel of radius two"),
                |plan| plan.develop(&samples).expect("places are finite"),
                |_, developed| error(&mut developed.planes[0].iter().copied()),
            ),
            Contender::peer(
                "a plain loop, weights from a table",
                || (),
                |()| loops(n, &samples, |t| weight(&table, t)),
                |(), pixels| error(&mut pixels.into_iter().map(|v| v as f32)),
            ),
        ],
    };
    race.run(JOB.letter, rounds)
}

/// Steps of the table from zero to the radius.
const TABLE: usize = 1 << 14;

fn weight(table: &[f32], t: f32) -> f32 {
    table.get((t.abs() * (0.5 * TABLE as f32) + 0.5) as usize).copied().unwrap_or(0.0)
}

/// One sample after the other, on one thread, in the precision of the weights.
fn loops<T>(n: usize, samples: &[Sample<f32, 1>], weight: impl Fn(f32) -> T) -> Vec<f64>
where
    T: Copy + Default + std::ops::Mul<Output = T> + std::ops::AddAssign + From<f32> + Into<f64>,
{
    let mut pixels = vec![[T::default(); 2]; n * n];
    for sample in samples {
        let [x, y] = sample.at.map(|c| c - 0.5);
        let first = |c: f32| (c - 2.0).ceil();
        let across: [T; 4] = std::array::from_fn(|i| weight(first(x) + i as f32 - x));
        let down: [T; 4] = std::array::from_fn(|j| weight(first(y) + j as f32 - y));
        for (row, down) in (first(y) as i64..).zip(down) {
            for (column, across) in (first(x) as i64..).zip(across) {
                if (0..n as i64).contains(&row) && (0..n as i64).contains(&column) {
                    let pixel = &mut pixels[row as usize * n + column as usize];
                    pixel[0] += across * down;
                    pixel[1] += across * down * T::from(sample.light[0]);
                }
            }
        }
    }
    pixels.into_iter().map(|[weight, light]| light.into() / weight.into()).collect()
}
