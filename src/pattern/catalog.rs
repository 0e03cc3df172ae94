//! All patterns of the plane by name.

use crate::error::{Error, Result, unknown};
use crate::pattern::Pattern;
use crate::pattern::best_candidate::BestCandidate;
use crate::pattern::blue_noise::BlueNoise;
use crate::pattern::halton::Halton;
use crate::pattern::hammersley::Hammersley;
use crate::pattern::jittered::Jittered;
use crate::pattern::multi_jittered::MultiJittered;
use crate::pattern::n_rooks::NRooks;
use crate::pattern::poisson_disk::PoissonDisk;
use crate::pattern::random::Random;
use crate::pattern::regular::Regular;
use crate::pattern::scrambling::Scrambling::{Digits, Owen};
use crate::pattern::sobol::Sobol;
use crate::pattern::zero_two::ZeroTwo;

type Boxed = Box<dyn Pattern<2>>;
type Make = fn(usize) -> Result<Boxed>;

/// The patterns with their names, from the simplest on.
const NAMED: &[(&str, Make)] = &[
    ("regular", |n| Ok(Box::new(Regular::with_count(n)?))),
    ("regular-offset", |n| Ok(Box::new(Regular::with_count(n)?.with_random_offset()))),
    ("random", |n| Ok(Box::new(Random::new(n)?))),
    ("jittered", |n| Ok(Box::new(Jittered::with_count(n)?))),
    ("n-rooks", |n| Ok(Box::new(NRooks::new(n)?))),
    ("multi-jittered", |n| Ok(Box::new(MultiJittered::with_count(n)?))),
    ("multi-jittered-correlated", |n| Ok(Box::new(MultiJittered::with_count(n)?.correlated()))),
    ("halton", |n| Ok(Box::new(Halton::new(n)?))),
    ("halton-permuted", |n| Ok(Box::new(Halton::new(n)?.scrambled(Digits)))),
    ("halton-owen", |n| Ok(Box::new(Halton::new(n)?.scrambled(Owen)))),
    ("hammersley", |n| Ok(Box::new(Hammersley::new(n)?))),
    ("sobol", |n| Ok(Box::new(Sobol::new(n)?))),
    ("sobol-owen", |n| Ok(Box::new(Sobol::new(n)?.scrambled(Owen)))),
    ("zero-two", |n| Ok(Box::new(ZeroTwo::new(n)?))),
    ("best-candidate", |n| Ok(Box::new(BestCandidate::new(n)?))),
    ("poisson-disk", |n| Ok(Box::new(PoissonDisk::with_about(n)?))),
    ("blue-noise", |n| Ok(Box::new(BlueNoise::new(n)?))),
];

/// The families that take a parameter, and what it is.
pub const FAMILIES: &[&str] = &["jittered:WIDTH", "best-candidate:CANDIDATES"];

/// The names, in order.
pub fn names() -> impl ExactSizeIterator<Item = &'static str> {
    NAMED.iter().map(|entry| entry.0)
}

/// All patterns with `count` points, in order.
///
/// # Errors
/// A number that not all of them can have; the squares from 4 to 65 536 will do.
pub fn all(count: usize) -> Result<Vec<Boxed>> {
    NAMED.iter().map(|entry| (entry.1)(count)).collect()
}

/// The pattern of that name with `count` points (`poisson-disk`: about so many), or a member of one of the [`FAMILIES`].
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::pattern::catalog::by_name;
/// assert_eq!(by_name("jittered", 64)?.points(1), Jittered::new([8, 8])?.points(1));
/// assert_eq!(by_name("jittered:0.5", 64)?.name(), "jittered:0.5");
/// let error = by_name("jittered", 1000).unwrap_err();
/// assert!(error.to_string().ends_with("1000 is impossible; the nearest numbers are 961 and 1024"));
/// let error = by_name("poison-disk", 64).unwrap_err();
/// assert!(error.to_string().starts_with("no pattern is called \"poison-disk\"; known: poisson-disk"));
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// [`Error::Unknown`] with the nearest names first; [`Error::Unreadable`] where a parameter is no number;
/// [`Error::Count`] where a pattern cannot have so many points, with the nearest numbers that it can.
pub fn by_name(name: &str, count: usize) -> Result<Boxed> {
    if let Some(entry) = NAMED.iter().find(|entry| entry.0 == name) {
        return (entry.1)(count);
    }
    let unreadable = |given: &str, wanted| Error::Unreadable {
        what: format!("pattern {}", name.split(':').next().unwrap_or(name)),
        given: given.to_owned(),
        wanted,
    };
    match name.split_once(':') {
        Some(("jittered", width)) => {
            let width = width.parse().map_err(|_| unreadable(width, "a width"))?;
            Ok(Box::new(Jittered::with_count(count)?.with_width(width)?))
        }
        Some(("best-candidate", candidates)) => {
            let candidates = candidates.parse().map_err(|_| unreadable(candidates, "a number of candidates"))?;
            Ok(Box::new(BestCandidate::new(count)?.with_candidates(candidates)?))
        }
        _ => Err(unknown("pattern", name, names().chain(FAMILIES.iter().copied()))),
    }
}

/// [`by_name`] with the number of points nearest to `count` that the pattern can have.
///
/// ```
/// use nyquist::pattern::catalog::nearest;
/// assert_eq!(nearest("jittered", 1000)?.count(), Some(1024));
/// assert_eq!(nearest("sobol", 1000)?.count(), Some(1000));
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// As [`by_name`], but for the number.
pub fn nearest(name: &str, count: usize) -> Result<Boxed> {
    match by_name(name, count) {
        Err(Error::Count { given, below, above, .. }) => {
            by_name(name, if below == 0 || given - below > above - given { above } else { below })
        }
        other => other,
    }
}
