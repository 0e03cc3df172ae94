//! Rows to columns.

use crate::engine::simd::Loop;

/// Numbers on a side of the squares that are turned in registers.
const SQUARE: usize = 8;

const WHOLE: &str = "matrices consist of whole squares";

/// A matrix turned: `to[c·to_stride + r] = from[r·stride + c]`, for multiples of eight of rows and columns.
#[derive(Debug)]
pub struct Turn<'a, T> {
    /// What is turned.
    pub from: &'a [T],
    /// From one of its rows to the next.
    pub stride: usize,
    /// How many rows it has.
    pub rows: usize,
    /// How many columns it has, which become rows.
    pub columns: usize,
    /// Where it goes.
    pub to: &'a mut [T],
    /// From one row there to the next.
    pub to_stride: usize,
}

impl<T: Copy> Turn<'_, T> {
    /// By a way to turn one square.
    #[inline(always)]
    fn by(self, square: impl Fn([&[T; SQUARE]; SQUARE]) -> [[T; SQUARE]; SQUARE]) {
        let Self { from, stride, rows, columns, to, to_stride } = self;
        // a line of the cache holds two squares: neighbours are read and written while it is at hand
        for c in (0..columns).step_by(SQUARE) {
            for r in (0..rows).step_by(SQUARE) {
                let line = |i: usize| from[(r + i) * stride + c..].first_chunk().expect(WHOLE);
                for (i, line) in square(std::array::from_fn(line)).into_iter().enumerate() {
                    *to[(c + i) * to_stride + r..].first_chunk_mut().expect(WHOLE) = line;
                }
            }
        }
    }
}

impl<T: Copy> Loop for Turn<'_, T> {
    #[inline(always)]
    fn run(self) {
        self.by(|square| std::array::from_fn(|i| std::array::from_fn(|j| square[j][i])));
    }
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use crate::engine::simd::turn::{SQUARE, Turn};
    use pulp::x86::V3;
    use pulp::{NullaryFnOnce, cast};

    /// Of `f32`, by the instructions that there are for it.
    pub(super) struct Shuffled<'a>(pub(super) V3, pub(super) Turn<'a, f32>);

    impl NullaryFnOnce for Shuffled<'_> {
        type Output = ();

        #[inline(always)]
        fn call(self) {
            let Self(v3, turn) = self;
            turn.by(|square| turned(v3, square));
        }
    }

    /// Pairs, pairs of pairs, halves: three rounds of eight shuffles.
    #[inline(always)]
    fn turned(v3: V3, square: [&[f32; SQUARE]; SQUARE]) -> [[f32; SQUARE]; SQUARE] {
        let avx = v3.avx;
        let m = square.map(|line| cast(*line));
        let low = |i: usize, j: usize| avx._mm256_unpacklo_ps(m[i], m[j]);
        let high = |i: usize, j: usize| avx._mm256_unpackhi_ps(m[i], m[j]);
        let (t0, t1, t2, t3) = (low(0, 1), high(0, 1), low(2, 3), high(2, 3));
        let (t4, t5, t6, t7) = (low(4, 5), high(4, 5), low(6, 7), high(6, 7));
        let first = |a, b| avx._mm256_shuffle_ps::<0x44>(a, b);
        let second = |a, b| avx._mm256_shuffle_ps::<0xEE>(a, b);
        let (s0, s1, s2, s3) = (first(t0, t2), second(t0, t2), first(t1, t3), second(t1, t3));
        let (s4, s5, s6, s7) = (first(t4, t6), second(t4, t6), first(t5, t7), second(t5, t7));
        let lower = |a, b| cast(avx._mm256_permute2f128_ps::<0x20>(a, b));
        let upper = |a, b| cast(avx._mm256_permute2f128_ps::<0x31>(a, b));
        [
            lower(s0, s4),
            lower(s1, s5),
            lower(s2, s6),
            lower(s3, s7),
            upper(s0, s4),
            upper(s1, s5),
            upper(s2, s6),
            upper(s3, s7),
        ]
    }
}

/// `f32`, with shuffles where the processor has them.
pub(super) fn turn_f32(turn: Turn<'_, f32>) {
    #[cfg(target_arch = "x86_64")]
    if let Some(v3) = pulp::x86::V3::try_new() {
        return pulp::Arch::V3(v3).dispatch(x86::Shuffled(v3, turn));
    }
    crate::engine::simd::vectorised(turn);
}
