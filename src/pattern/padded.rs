//! Points in five dimensions: image, time and lens, stratified in groups.

use crate::error::{Error, Result};
use crate::num::random::{bits, uniform};
use crate::pattern::cells::{Cells, within_cell};
use crate::pattern::permutation::permutation;
use crate::pattern::{Pattern, countable};

/// Which stratum of one group goes with which of another.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Association {
    /// At random: independent permutations, all equally likely.
    #[default]
    Shuffled,
    /// The first with the first, the second with the second, …: a lens point for each place in the pixel, and with it a
    /// pattern in the picture.
    InOrder,
}

/// Samples of the generalised scene function `L(x, y, t, u, v)`: image, time and lens each stratified by itself, and
/// associated at random (Cook, Porter, Carpenter 1984; slide "Стратификация в многомерном случае").
///
/// With `N = side²` samples the groups `(x, y)` and `(u, v)` are jittered over `side × side` strata and `t` over `N`, and
/// sample `i` takes stratum `i` of the image and strata `π(i)`, `ρ(i)` of time and lens with random permutations. So each
/// group by itself is as good as jitter with all `N` samples, at `N` samples in all. Four strata in *each* of the five
/// dimensions would need `4⁵ = 1024` samples; four strata in each *group* need four (E17).
///
/// Order: of the image's strata, along x first.
///
/// ```
/// use nyquist::prelude::*;
/// let four = Padded::new(2)?.points(1);
/// assert_eq!((four.len(), Pattern::<5>::count(&Jittered::new([4; 5])?)), (4, Some(1024)));
/// let quarter = |s: &[f64; 5], d| (2.0 * s[d]) as usize + 2 * ((2.0 * s[d + 1]) as usize);
/// let sorted = |mut strata: Vec<usize>| { strata.sort_unstable(); strata };
/// assert_eq!(sorted(four.iter().map(|s| quarter(s, 0)).collect()), [0, 1, 2, 3]); // (x, y)
/// assert_eq!(sorted(four.iter().map(|s| (4.0 * s[2]) as usize).collect()), [0, 1, 2, 3]); // t
/// assert_eq!(sorted(four.iter().map(|s| quarter(s, 3)).collect()), [0, 1, 2, 3]); // (u, v)
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Padded {
    side: usize,
    association: Association,
    stratified: [bool; 3],
}

impl Padded {
    /// `side²` samples, all groups stratified, associated at random.
    ///
    /// # Errors
    /// No samples, or more than [`MOST_POINTS`](crate::pattern::MOST_POINTS).
    pub fn new(side: usize) -> Result<Self> {
        countable(side.saturating_mul(side))?;
        Ok(Self { side, association: Association::Shuffled, stratified: [true; 3] })
    }

    /// `count` samples.
    ///
    /// # Errors
    /// [`Error::Count`] with the nearest squares unless `count` is one.
    pub fn with_count(count: usize) -> Result<Self> {
        let cells = Cells::<2>::with_count(count).map_err(|error| match error {
            Error::Count { given, below, above, .. } => {
                Error::Count { what: "samples stratified in groups", given, below, above }
            }
            other => other,
        })?;
        Self::new(cells.along()[0])
    }

    /// The same with another association of the groups.
    #[must_use]
    pub fn associated(self, association: Association) -> Self {
        Self { association, ..self }
    }

    /// The same with only those of the groups image, time and lens stratified; the others are independent points.
    #[must_use]
    pub fn stratified(self, image: bool, time: bool, lens: bool) -> Self {
        Self { stratified: [image, time, lens], ..self }
    }
}

impl Pattern<5> for Padded {
    fn name(&self) -> String {
        "padded".into()
    }

    fn count(&self) -> Option<usize> {
        Some(self.side * self.side)
    }

    fn points(&self, seed: u64) -> Vec<[f64; 5]> {
        let (side, n) = (self.side, self.side * self.side);
        let partners = |group: u32| match self.association {
            Association::Shuffled => permutation(bits(seed, group.into(), 5), n),
            Association::InOrder => (0..n as u32).collect(),
        };
        let (times, lenses) = (partners(1), partners(2));
        let sample = |i: usize| {
            let place = |dimension: u32| uniform(seed, i as u64, dimension);
            let square = |stratum: usize, first: u32, stratified: bool| {
                let within = |stratum: usize, dimension| {
                    let place = place(dimension);
                    if stratified { within_cell(stratum as u64, side as u64, place) } else { place }
                };
                [within(stratum % side, first), within(stratum / side, first + 1)]
            };
            let [image, time, lens] = self.stratified;
            let [x, y] = square(i, 0, image);
            let t = if time { within_cell(times[i].into(), n as u64, place(2)) } else { place(2) };
            let [u, v] = square(lenses[i] as usize, 3, lens);
            [x, y, t, u, v]
        };
        (0..n).map(sample).collect()
    }
}
