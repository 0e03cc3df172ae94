//! Transforms of prime lengths as convolutions with a chirp.

use crate::engine::fft::butterflies::Butterflies;
use crate::engine::fft::radix::RADIX;
use crate::engine::fft::roots::Turns;
use crate::engine::fft::rows::{Line, Numbers, Source, WIDTH};
use crate::engine::fft::streams::Streams;
use crate::engine::real::Real;
use crate::engine::simd::{Loop, vectorised};
use num_complex::Complex;

/// `X_k = c_k Σ_j (x_j c_j) c̄_{k−j}` with the chirp `c_j = e^{−πij²/n}`, since `2jk = j² + k² − (k−j)²` (Bluestein 1970):
/// a convolution, by transforms of a length that is easy.
///
/// Whoever wants only the first `kept` frequencies, as of real numbers, needs `n + kept − 1` numbers of it instead of
/// `2n − 1`. The spectrum of the middle never leaves the order in which it comes: no transposition.
#[derive(Debug)]
pub(super) struct Chirp<T> {
    streams: Streams<T>,
    /// `c_j`.
    chirp: Vec<Complex<T>>,
    /// The transform of the other chirp over the length of the convolution, in the order in which it comes.
    spectrum: Vec<Complex<T>>,
}

/// The numbers times the chirp, and zeros behind them.
struct Chirped<'a, T, S> {
    source: &'a S,
    chirp: &'a [Complex<T>],
}

impl<T: Real, S: Source<T>> Source<T> for Chirped<'_, T, S> {
    #[inline(always)]
    fn read(&self, at: usize, count: usize, line: &mut Line<T>) {
        let count = count.min(self.chirp.len().saturating_sub(at));
        if count < WIDTH {
            *line = Line::default();
        }
        if count > 0 {
            let mut chirp = Line::default();
            chirp.read(&self.chirp[at..at + count]);
            self.source.read(at, count, line);
            line.times(&chirp);
        }
    }
}

impl<T: Real> Chirp<T> {
    pub(super) fn new(n: usize, kept: usize, butterflies: Butterflies) -> Self {
        let padded = easy_length(n + kept - 1);
        let streams = Streams::new(padded, butterflies);
        let turns = Turns::<T>::roots(2 * n, 2 * n);
        // j² modulo 2n, by differences
        let chirp: Vec<_> = (0..n)
            .scan(0, |square, j| {
                let now = *square;
                *square = (now + 2 * j + 1) % (2 * n);
                Some(turns.at(now))
            })
            .collect();
        let mut other = vec![Complex::default(); padded];
        let gain = T::of(1.0 / padded as f64);
        for (j, c) in chirp.iter().enumerate() {
            let value = c.conj() * gain;
            if j < kept {
                other[j] = value;
            }
            if j > 0 {
                other[padded - j] = value;
            }
        }
        let mut spectrum = vec![Complex::default(); streams.room()];
        streams.columns(&Numbers(&other), &mut spectrum);
        streams.rows(&mut spectrum, |_, _| {});
        Self { streams, chirp, spectrum }
    }

    /// The sixteen streams of the convolution.
    pub(super) fn streams(&self) -> &Streams<T> {
        &self.streams
    }

    /// The transform, its frequencies row after row.
    pub(super) fn run(&self, source: &impl Source<T>, store: &mut [Complex<T>]) {
        let (streams, stride) = (&self.streams, self.streams.stride());
        streams.columns(&Chirped { source, chirp: &self.chirp }, store);
        streams.rows(store, |k, row| {
            vectorised(Product { row: &mut *row, other: &self.spectrum[k * stride..] });
            streams.transform_row(row);
            streams.twist_row(k, row);
        });
        streams.columns_back(&self.chirp, store);
    }
}

/// A row times that of the chirp's spectrum, conjugated.
struct Product<'a, T> {
    row: &'a mut [Complex<T>],
    other: &'a [Complex<T>],
}

impl<T: Real> Loop for Product<'_, T> {
    #[inline(always)]
    fn run(self) {
        let (mut line, mut by) = (Line::default(), Line::default());
        for (row, other) in self.row.chunks_mut(WIDTH).zip(self.other.chunks(WIDTH)) {
            line.read(row);
            by.read(other);
            line.times(&by);
            line.conjugate();
            line.write(row);
        }
    }
}

/// The least length from `n` on that is a multiple of sixteen and has no prime factors but 2 and, at most twice, 3.
fn easy_length(n: usize) -> usize {
    let power = |odd: usize| odd * n.div_ceil(odd).next_power_of_two().max(RADIX);
    [1, 3, 9].map(power).into_iter().min().expect("there are three")
}
