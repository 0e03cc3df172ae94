//! The plain complex sum of any length, in the order in which it comes.

use crate::engine::fft::butterflies::{Butterflies, Short};
use crate::engine::fft::chirp::Chirp;
use crate::engine::fft::length::largest_prime;
use crate::engine::fft::order::{Frequencies, InOrder, Order, pieces};
use crate::engine::fft::pool::Pool;
use crate::engine::fft::radix::RADIX;
use crate::engine::fft::rows::Source;
use crate::engine::fft::streams::Streams;
use crate::engine::real::Real;
use crate::engine::simd::vectorised;
use num_complex::Complex;

/// From how many numbers on a transform is cut into sixteen.
const LARGE: usize = 1 << 17;

/// A prime factor above this makes a large transform a convolution.
const LARGE_PRIME: usize = 1 << 12;

/// A way to `X_k = Σ_j x_j e^{−2πijk/n}`.
#[derive(Debug)]
pub(super) struct Core<T> {
    n: usize,
    way: Way<T>,
    stores: Pool<T>,
    rooms: Pool<T>,
}

#[derive(Debug)]
enum Way<T> {
    /// In one piece.
    Whole(Short<T>),
    /// As sixteen rows.
    Streams(Streams<T>),
    /// As a convolution.
    Chirp(Chirp<T>),
}

impl<T: Real> Core<T> {
    /// For `n` numbers, of whose frequencies the first `kept` are wanted.
    pub(super) fn new(n: usize, kept: usize, butterflies: Butterflies) -> Self {
        let way = if n < LARGE {
            Way::Whole(Short::new(n, butterflies))
        } else if largest_prime(n) > LARGE_PRIME {
            Way::Chirp(Chirp::new(n, kept, butterflies))
        } else if n.is_multiple_of(RADIX) {
            Way::Streams(Streams::new(n, butterflies))
        } else {
            Way::Whole(Short::new(n, butterflies))
        };
        Self { n, way, stores: Pool::new(), rooms: Pool::new() }
    }

    /// How many numbers.
    pub(super) fn len(&self) -> usize {
        self.n
    }

    /// Whether it is done in one piece, in the place of its result.
    pub(super) fn is_whole(&self) -> bool {
        matches!(self.way, Way::Whole(_))
    }

    /// The transform of numbers in their own place, if it is done in one piece.
    pub(super) fn run_standing(&self, numbers: &mut [Complex<T>]) {
        match &self.way {
            Way::Whole(short) => self.rooms.lend(short.room(), |room| short.run(numbers, room)),
            _ => unreachable!("only what is whole stands"),
        }
    }

    /// Whether it is done in one piece and in passes of vectors.
    pub(super) fn has_passes(&self) -> bool {
        matches!(self.way, Way::Whole(Short::Passes(_)))
    }

    /// Whether it has all frequencies, not only those that were wanted.
    pub(super) fn keeps_all(&self) -> bool {
        !matches!(self.way, Way::Chirp(_))
    }

    /// The transform of what `source` has, and `f` of it.
    pub(super) fn run<S: Source<T>, R>(&self, source: &S, f: impl FnOnce(Frequencies<'_, T>) -> R) -> R {
        let n = self.n;
        match &self.way {
            Way::Whole(short) => self.stores.lend(n, |store| {
                self.whole(short, source, store);
                f(Frequencies::new(store, Order::Plain, n))
            }),
            Way::Streams(streams) => self.stores.lend(streams.room(), |store| {
                streams.columns(source, store);
                streams.rows(store, |_, _| {});
                f(Frequencies::new(store, Order::Columns(streams.stride()), n))
            }),
            Way::Chirp(chirp) => self.stores.lend(chirp.streams().room(), |store| {
                chirp.run(source, store);
                let order = Order::Rows(chirp.streams().len(), chirp.streams().stride());
                f(Frequencies::new(store, order, n))
            }),
        }
    }

    /// In one piece.
    fn whole(&self, short: &Short<T>, source: &impl Source<T>, out: &mut [Complex<T>]) {
        match source.in_a_row() {
            Some(values) => self.rooms.lend(short.room_beside(), |room| short.run_beside(values, out, room)),
            None => {
                source.read_all(out);
                self.rooms.lend(short.room(), |room| short.run(out, room));
            }
        }
    }

    /// The transform in order.
    pub(super) fn run_to<S: Source<T>>(&self, source: &S, out: &mut [Complex<T>]) {
        if let Way::Whole(short) = &self.way {
            return self.whole(short, source, out);
        }
        self.run(source, |frequencies| {
            pieces(out, |first, out| vectorised(InOrder { frequencies, first, shift: 0, factors: None, out }));
        });
    }
}
