//! Random numbers without state: a pure function of (seed, index, dimension).

/// 2⁶⁴ divided by the golden ratio, odd.
const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// The finaliser of SplitMix64, a bijection.
#[inline(always)]
fn mix(z: u64) -> u64 {
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// 64 well-mixed bits for one (seed, index, dimension).
///
/// Three rounds of the finaliser of SplitMix64 (Steele, Lea, Flood, *Fast splittable pseudorandom number generators*,
/// 2014), one for each argument. The same bits on every machine, in every order, for any number of threads.
pub fn bits(seed: u64, index: u64, dimension: u32) -> u64 {
    let z = mix(seed.wrapping_add(GOLDEN));
    let z = mix(z ^ index.wrapping_mul(GOLDEN).wrapping_add(1));
    mix(z ^ u64::from(dimension).wrapping_mul(GOLDEN).wrapping_add(2))
}

/// The `index`-th word of SplitMix64's stream that starts at `key`: one round instead of the three of [`bits`].
///
/// For inner loops: a key is made once, by [`bits`] of seed and dimension, and the words of its stream are as good as
/// those of the generator, which passes the usual batteries of tests.
#[inline(always)]
pub fn word(key: u64, index: u64) -> u64 {
    mix(key.wrapping_add(index.wrapping_add(1).wrapping_mul(GOLDEN)))
}

/// The 53 high bits of a word as a number from `[0, 1)`.
#[inline(always)]
pub fn unit(word: u64) -> f64 {
    const ULP: f64 = 1.0 / (1u64 << 53) as f64;
    (word >> 11) as f64 * ULP
}

/// A whole number from `0..n` made of a word: its high part times `n` (Lemire 2019). Every number has the same
/// probability up to `n/2⁶⁴`; zero for `n = 0`.
pub fn below(word: u64, n: u64) -> u64 {
    ((u128::from(word) * u128::from(n)) >> 64) as u64
}

/// A number from `[0, 1)`: a multiple of 2⁻⁵³, all equally likely.
///
/// ```
/// use nyquist::num::random::uniform;
/// let mean = (0..10_000).map(|i| uniform(1, i, 0)).sum::<f64>() / 10_000.0;
/// assert!((mean - 0.5).abs() < 4.0 / (12.0 * 10_000.0f64).sqrt()); // four standard deviations
/// assert_eq!(uniform(1, 7, 0), uniform(1, 7, 0));
/// ```
pub fn uniform(seed: u64, index: u64, dimension: u32) -> f64 {
    unit(bits(seed, index, dimension))
}

/// A standard normal number, by Box and Muller (1958); it uses the dimensions `2·dimension` and `2·dimension + 1`.
pub fn normal(seed: u64, index: u64, dimension: u32) -> f64 {
    let radius = (-2.0 * (1.0 - uniform(seed, index, 2 * dimension)).ln()).sqrt();
    radius * crate::num::cos_pi(2.0 * uniform(seed, index, 2 * dimension + 1))
}
