//! Random permutations.

use crate::num::random::{below, word};

/// A random permutation of `0..n`, all `n!` equally likely (up to `n²/2⁶⁴`): the shuffle of Fisher and Yates (1938) with
/// the words of a stream.
///
/// ```
/// use nyquist::pattern::permutation::permutation;
/// let mut shuffled = permutation(7, 5);
/// assert_eq!(shuffled, permutation(7, 5)); // a pure function of the key
/// shuffled.sort_unstable();
/// assert_eq!(shuffled, [0, 1, 2, 3, 4]);
/// ```
pub fn permutation(key: u64, n: usize) -> Vec<u32> {
    let mut order: Vec<u32> = (0..n as u32).collect();
    shuffle(key, &mut order);
    order
}

/// [`permutation`] of what is there.
pub fn shuffle<T>(key: u64, items: &mut [T]) {
    for last in (1..items.len()).rev() {
        items.swap(last, below(word(key, last as u64), last as u64 + 1) as usize);
    }
}
