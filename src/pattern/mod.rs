//! Sample patterns: where to look when one looks at finitely many places.
//!
//! A [`Pattern`] is a recipe for points in the unit cube; one kind, one file. The lecture's methods differ in nothing
//! else: regular, random and jittered supersampling are three patterns with the same weights (slides
//! "Стохастический суперсэмплинг", "Стратифицированный сэмплинг", "Другие методы сэмплирования"). [`catalog`] knows
//! them by name, [`measure`] says in numbers what they are good for:
//!
//! | pattern | points | spectrum | for |
//! | --- | --- | --- | --- |
//! | [`regular`] | any grid | lines: aliases are copies | smooth periodic functions |
//! | [`random`] | any | white | nothing but proofs |
//! | [`jittered`] | any grid | `1 − sinc²·sinc²` | edges, unknown functions |
//! | [`n_rooks`] | any | white off the axes, low on them | functions that are sums of functions of one coordinate |
//! | [`multi_jittered`] | any grid | jitter, and low on the axes | edges in any direction |
//! | [`halton`], [`hammersley`], [`sobol`], [`zero_two`] | any | structured, or scrambled | smooth functions, many dimensions |
//! | [`best_candidate`], [`poisson_disk`] | any; about as many as asked | blue: a ring, and a low plateau inside | images |
//! | [`blue_noise`] | any; a tile of thresholds | blue, progressive | images, dithering |
//! | [`padded`], [`grouped`] | squares; any | per group | image, time and lens together |

pub mod best_candidate;
pub mod blue_noise;
mod board;
mod buckets;
pub mod catalog;
pub mod cells;
pub mod cloud;
pub mod directions;
pub mod grouped;
pub mod halton;
pub mod hammersley;
pub mod jittered;
pub mod measure;
pub mod multi_jittered;
pub mod n_rooks;
pub mod padded;
pub mod permutation;
pub mod poisson_disk;
pub mod radical;
pub mod random;
pub mod regular;
pub mod scrambling;
pub mod sobol;
pub mod void_cluster;
pub mod zero_two;

use crate::error::{Error, Result};

/// The most points that a pattern may have: `2²⁶`, a gigabyte of points in the plane.
pub const MOST_POINTS: usize = 1 << 26;

/// A recipe for points in the unit cube `[0, 1)^D`.
///
/// Points are a pure function of the pattern and the seed: the same bits in every run, and patterns of different seeds
/// are independent. Patterns that have nothing random in them ignore the seed. Each kind documents the order of its
/// points.
///
/// ```
/// use nyquist::prelude::*;
/// // a pattern of one's own: the golden-ratio lattice
/// #[derive(Debug)]
/// struct Golden(usize);
/// impl Pattern<2> for Golden {
///     fn name(&self) -> String { "golden".into() }
///     fn count(&self) -> Option<usize> { Some(self.0) }
///     fn points(&self, _: u64) -> Vec<[f64; 2]> {
///         let turn = 0.5 * (5f64.sqrt() - 1.0);
///         (0..self.0).map(|i| [(i as f64 + 0.5) / self.0 as f64, (i as f64 * turn).fract()]).collect()
///     }
/// }
/// // better spread than as many jittered points
/// let [golden, jittered] = [Golden(256).points(0), Jittered::<2>::new([16, 16])?.points(0)];
/// assert!(star_discrepancy(&golden)? < 0.5 * star_discrepancy(&jittered)?);
/// # Ok::<(), Error>(())
/// ```
pub trait Pattern<const D: usize>: std::fmt::Debug + Send + Sync {
    /// The field's name for it, as the command line takes it: `multi-jittered`.
    fn name(&self) -> String;

    /// How many points there are, or nothing where that depends on the seed.
    fn count(&self) -> Option<usize>;

    /// The points, in the order that the kind documents.
    fn points(&self, seed: u64) -> Vec<[f64; D]>;
}

/// A reference to a pattern and a boxed pattern are patterns too.
macro_rules! forward {
    ($of:ty) => {
        impl<const D: usize, P: Pattern<D> + ?Sized> Pattern<D> for $of {
            fn name(&self) -> String {
                (**self).name()
            }
            fn count(&self) -> Option<usize> {
                (**self).count()
            }
            fn points(&self, seed: u64) -> Vec<[f64; D]> {
                (**self).points(seed)
            }
        }
    };
}
forward!(&P);
forward!(Box<P>);

/// `count` if there can be so many points.
///
/// # Errors
/// No points, or more than [`MOST_POINTS`].
pub fn countable(count: usize) -> Result<usize> {
    match count {
        0 => Err(Error::TooFew { what: "points of a pattern", least: 1, got: 0 }),
        n if n > MOST_POINTS => {
            let what = "the number of points of a pattern";
            Err(Error::Overflow { what, value: n as f64, most: MOST_POINTS as f64 })
        }
        n => Ok(n),
    }
}
