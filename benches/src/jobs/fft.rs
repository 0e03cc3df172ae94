//! Job a: transforms of the line. Ours put units, phase and order in; the peers give the plain sum.

use crate::jobs::{Job, noise};
use crate::machine::Machine;
use crate::race::{Contender, Outcome, Race};
use num_complex::Complex;
use nyquist::axis::Axis;
use nyquist::engine::fft::{PhysicalFft, PhysicalRealFft};
use nyquist::engine::real::Real;
use realfft::RealFftPlanner;
use rustfft::{FftNum, FftPlanner};
use std::f64::consts::TAU;

pub const JOB: Job = Job { letter: "a", name: "fft", about: "1-D transforms, ours in physical units", run };

/// Powers of two, 10 ms of sound at 44.1 kHz times a hundred, primes.
const LENGTHS: [usize; 7] = [1 << 10, 1 << 16, 44_100, 65_537, 1 << 20, 1_000_003, 1 << 22];

fn run(machine: &Machine, rounds: usize) -> Vec<Outcome> {
    let mut outcomes = Vec::new();
    for n in LENGTHS {
        for threads in [1, 2] {
            outcomes.push(complex::<f64>(n, threads, machine, rounds));
            outcomes.push(complex::<f32>(n, threads, machine, rounds));
            outcomes.push(real::<f64>(n, threads, machine, rounds));
            outcomes.push(real::<f32>(n, threads, machine, rounds));
        }
    }
    outcomes
}

/// A start that is not zero and a step that is no power of two, so that phase and step are work.
fn axis(n: usize) -> Axis {
    Axis::new(-0.3, 0.1, n).expect("all lengths are positive")
}

fn complex<T: Real + FftNum>(n: usize, threads: usize, machine: &Machine, rounds: usize) -> Outcome {
    let input: Vec<Complex<T>> =
        noise(n).zip(noise(2 * n).skip(n)).map(|(re, im)| Complex::new(T::of(re), T::of(im))).collect();
    let sum = direct(&input);
    let turn = |k: i64, value: Complex<f64>| value * physical(n, k);
    let race = Race {
        case: format!("complex, {}, {}", length(n), width::<T>()),
        threads,
        limit: Some(limit::<T>(n, 4.0, 5.0, machine, threads)),
        allowed: allowed::<T>(n),
        contenders: vec![
            Contender::ours(
                "nyquist",
                || (PhysicalFft::new(axis(n)), vec![Complex::default(); n]),
                |(fft, out)| fft.forward(&input, out).expect("the lengths agree"),
                |(_, out), ()| worst(n, |k| wide(out[(k + (n / 2) as i64) as usize]), |k| turn(k, sum(k))),
            ),
            Contender::peer(
                "rustfft 6.4.1",
                || {
                    let fft = FftPlanner::<T>::new().plan_fft_forward(n);
                    let scratch = vec![Complex::default(); fft.get_immutable_scratch_len()];
                    (fft, scratch, vec![Complex::default(); n])
                },
                |(fft, scratch, out)| fft.process_immutable_with_scratch(&input, out, scratch),
                |(.., out), ()| worst(n, |k| wide(out[k.rem_euclid(n as i64) as usize]), &sum),
            ),
        ],
    };
    race.run(JOB.letter, rounds)
}

fn real<T: Real + FftNum>(n: usize, threads: usize, machine: &Machine, rounds: usize) -> Outcome {
    let input: Vec<T> = noise(n).map(T::of).collect();
    let numbers: Vec<Complex<T>> = input.iter().map(|&value| value.into()).collect();
    let sum = direct(&numbers);
    let race = Race {
        case: format!("real, {}, {}", length(n), width::<T>()),
        threads,
        limit: Some(limit::<T>(n, 2.0, 2.5, machine, threads)),
        allowed: allowed::<T>(n),
        contenders: vec![
            Contender::ours(
                "nyquist",
                || (PhysicalRealFft::new(axis(n)), vec![Complex::default(); n / 2 + 1]),
                |(fft, out)| fft.forward(&input, out).expect("the lengths agree"),
                |(_, out), ()| worst(n, |k| wide(out[k as usize]), |k| sum(k) * physical(n, k)),
            ),
            Contender::peer(
                "realfft 3.5.1",
                || {
                    let fft = RealFftPlanner::<T>::new().plan_fft_forward(n);
                    let scratch = fft.make_scratch_vec();
                    (fft, scratch, input.clone(), vec![Complex::default(); n / 2 + 1])
                },
                // it overwrites its input, so that the copy is part of doing the job again and again
                |(fft, scratch, copy, out)| {
                    copy.copy_from_slice(&input);
                    fft.process_with_scratch(copy, out, scratch).expect("the lengths agree");
                },
                |(.., out), ()| worst(n, |k| wide(out[k as usize]), &sum),
            ),
        ],
    };
    race.run(JOB.letter, rounds)
}

/// Frequencies that are looked at.
fn probes(n: usize) -> impl Iterator<Item = i64> {
    let half = (n / 2) as i64;
    [0, 1, 2, 3, half / 7, half / 3, half - 1].into_iter()
}

/// `Σ x_j e^{−2πijk/n}` term by term in `f64`, whole turns dropped exactly before the sine is taken; the sum of each
/// thousand terms is added to those before, so that rounding grows with the thousands.
fn direct<T: Real>(input: &[Complex<T>]) -> impl Fn(i64) -> Complex<f64> {
    let (n, input): (usize, Vec<Complex<f64>>) = (input.len(), input.iter().map(|&z| wide(z)).collect());
    move |k| {
        let k = k.rem_euclid(n as i64) as u128;
        let root = |j: usize| Complex::cis(-TAU * ((j as u128 * k % n as u128) as f64 / n as f64));
        let thousand = |(i, part): (usize, &[Complex<f64>])| {
            part.iter().enumerate().map(|(j, z)| z * root(1000 * i + j)).sum::<Complex<f64>>()
        };
        input.chunks(1000).enumerate().map(thousand).sum()
    }
}

/// `T·e^{−2πiν_k·start}`: what makes the sum a sample of the transform.
fn physical(n: usize, k: i64) -> Complex<f64> {
    0.1 * Complex::cis(TAU * (k as f64 * 0.3 / (0.1 * n as f64)))
}

/// The root of the mean square of the errors at the probed frequencies over that of the values there.
fn worst(n: usize, got: impl Fn(i64) -> Complex<f64>, want: impl Fn(i64) -> Complex<f64>) -> f64 {
    let [errors, values] = probes(n).fold([0.0; 2], |[errors, values], k| {
        let wanted = want(k);
        [errors + (got(k) - wanted).norm_sqr(), values + wanted.norm_sqr()]
    });
    (errors / values).sqrt()
}

fn wide<T: Real>(z: Complex<T>) -> Complex<f64> {
    let [re, im] = [z.re, z.im].map(|part| part.to_f64().expect("every number is one of 64 bits"));
    Complex::new(re, im)
}

/// Three transforms of up to `4n` numbers follow on one another where the length is a prime (Bluestein 1970), each with
/// errors up to `8ε·log₂` of the mean of all values; the mean of the seven that are looked at can be a third of it.
fn allowed<T: Real>(n: usize) -> f64 {
    let epsilon = T::epsilon().to_f64().expect("every number is one of 64 bits");
    3.0 * 8.0 * epsilon * 3.0 * (4.0 * n as f64).log2()
}

/// Numbers read and written once, and `operations·n·log₂n` additions and multiplications; those of 32 bits count half.
fn limit<T: Real>(n: usize, numbers: f64, operations: f64, machine: &Machine, threads: usize) -> (f64, String) {
    let (size, n) = (size_of::<T>() as f64, n as f64);
    let work = operations * n * n.log2() * size / 8.0;
    let counted = "input and result moved once; 5n·log₂n operations, half for real input";
    (machine.least(numbers * n * size, work, threads), counted.to_owned())
}

fn length(n: usize) -> String {
    if n.is_power_of_two() { format!("2^{}", n.ilog2()) } else { n.to_string() }
}

fn width<T>() -> &'static str {
    if size_of::<T>() == 8 { "f64" } else { "f32" }
}
