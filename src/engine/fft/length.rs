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
