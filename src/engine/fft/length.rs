//! Lengths.

/// The least even length from `n` on whose only prime factors are 2, 3 and 5: transforms of it are fast, and those of real
/// values cost half.
///
/// ```
/// use nyquist::engine::fft::fast_length;
/// assert_eq!([7, 44100, 44101].map(fast_length), [8, 45000, 45000]);
/// ```
pub fn fast_length(n: usize) -> usize {
    fast_multiple(n, 2)
}

/// The least length from `n` on that is a power of two, `2⁵` at least, times 1, 3, 5, 9, 15, 27 or 45: from 1440 on at most
/// an eighth longer than asked for, few factors that are not two, and from 2¹⁸ on a transform of it uses all threads.
///
/// ```
/// use nyquist::engine::fft::long_length;
/// assert_eq!([1, 1_000_000, 1_048_577].map(long_length), [32, 1_048_576, 1_179_648]);
/// ```
pub fn long_length(n: usize) -> usize {
    let least = |odd: usize| odd * n.div_ceil(odd).next_power_of_two().max(32);
    [1, 3, 5, 9, 15, 27, 45].map(least).into_iter().min().expect("there are seven")
}

/// The least multiple of `unit` from `n` on that is `unit` times twos, threes and fives.
pub(in crate::engine) fn fast_multiple(n: usize, unit: usize) -> usize {
    let smooth = |mut m: usize| {
        for p in [2, 3, 5] {
            while m.is_multiple_of(p) {
                m /= p;
            }
        }
        m == 1
    };
    let mut count = n.div_ceil(unit).max(1);
    while !smooth(count) {
        count += 1;
    }
    unit * count
}

/// The largest prime factor.
pub(super) fn largest_prime(mut n: usize) -> usize {
    let mut largest = 1;
    let mut p = 2;
    while p * p <= n {
        while n.is_multiple_of(p) {
            n /= p;
            largest = p;
        }
        p += 1;
    }
    largest.max(n)
}
