//! What the machine can do at most: the yardstick of every limit.

use pulp::{Arch, Simd, WithSimd};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::fs;
use std::hint::black_box;
use std::time::Instant;

/// Rates on one thread and on two.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Machine {
    /// The processor's name.
    pub processor: String,
    /// Bytes a second of `a = b + s·c` over arrays far larger than the caches, counting two reads and one write.
    pub triad: [f64; 2],
    /// Bytes a second that can be read from such an array.
    pub read: [f64; 2],
    /// Additions and multiplications a second in fused pairs, 64 bits.
    pub flops: [f64; 2],
}

/// Doubles in each array: a quarter of a gigabyte.
const LONG: usize = 1 << 25;
/// Times that each rate is measured; the best counts, since it is a limit.
const TRIES: usize = 7;

impl Machine {
    /// Measures it, in some seconds.
    pub fn measured() -> Self {
        let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        let name = info.lines().find(|line| line.starts_with("model name"));
        let processor = name.and_then(|line| line.split(": ").nth(1)).unwrap_or("unknown").to_owned();
        let on = |threads: usize, rate: fn(usize) -> f64| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads can be started");
            pool.install(|| (0..TRIES).map(|_| rate(threads)).fold(0.0, f64::max))
        };
        let both = |rate: fn(usize) -> f64| [on(1, rate), on(2, rate)];
        Self { processor, triad: both(triad), read: both(read), flops: both(flops) }
    }

    /// Seconds to move so many bytes and to do so many operations on `threads` threads, whichever takes longer.
    pub fn least(&self, bytes: f64, operations: f64, threads: usize) -> f64 {
        let i = threads.clamp(1, 2) - 1;
        (bytes / self.triad[i]).max(operations / self.flops[i])
    }
}

fn seconds(work: impl FnOnce()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_secs_f64()
}

// filled with something else than zeros, so that no page is mapped only while it is measured
fn triad(threads: usize) -> f64 {
    let (mut a, b, c) = (vec![0.5; LONG], vec![1.0; LONG], vec![2.0; LONG]);
    let piece = LONG / threads;
    let parts = a.par_chunks_mut(piece).zip(b.par_chunks(piece)).zip(c.par_chunks(piece));
    let time = seconds(|| {
        parts.for_each(|((a, b), c)| {
            for ((a, b), c) in a.iter_mut().zip(b).zip(c) {
                *a = b + 3.0 * c;
            }
        });
    });
    black_box(&a);
    (3 * 8 * LONG) as f64 / time
}

fn read(threads: usize) -> f64 {
    let a = vec![1.0f64; LONG];
    let sum = |part: &[f64]| {
        let mut sums = [0.0; 16];
        for chunk in part.chunks_exact(16) {
            for (sum, value) in sums.iter_mut().zip(chunk) {
                *sum += value;
            }
        }
        sums.iter().sum::<f64>()
    };
    let time = seconds(|| {
        black_box(a.par_chunks(LONG / threads).map(sum).sum::<f64>());
    });
    (8 * LONG) as f64 / time
}

/// Fused multiply-adds on registers alone.
struct Fused;

/// As many independent sums as hide the delay of one.
const SUMS: usize = 10;
const STEPS: usize = 2_000_000;

impl WithSimd for Fused {
    type Output = f64;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> f64 {
        let (factor, term) = (simd.splat_f64s(black_box(0.999_999)), simd.splat_f64s(black_box(1e-6)));
        let mut sums = [simd.splat_f64s(1.0); SUMS];
        for _ in 0..STEPS {
            for sum in &mut sums {
                *sum = simd.mul_add_e_f64s(*sum, factor, term);
            }
        }
        for sum in sums {
            black_box(simd.reduce_sum_f64s(sum));
        }
        let lanes = size_of::<S::f64s>() / size_of::<f64>();
        (2 * lanes * SUMS * STEPS) as f64
    }
}

fn flops(threads: usize) -> f64 {
    let start = Instant::now();
    let done: f64 = (0..threads).into_par_iter().map(|_| Arch::new().dispatch(Fused)).sum();
    done / start.elapsed().as_secs_f64()
}
