//! A pattern of the plane for five dimensions.

use crate::error::{Error, Result, unknown};
use crate::num::random::{bits, uniform};
use crate::pattern::cells::within_cell;
use crate::pattern::padded::Padded;
use crate::pattern::permutation::permutation;
use crate::pattern::random::Random;
use crate::pattern::{Pattern, catalog};

/// A pattern of the plane used twice, for the image and for the lens, with one stratum of time for every sample; the three
/// groups are associated at random, as in [`Padded`].
///
/// Where a pattern has not the same number of points for every seed, the image's decides, and points of the lens are left
/// out or used again. A pattern that ignores the seed has the same points in every pixel, in another order.
///
/// Order: of the image's pattern.
///
/// ```
/// use nyquist::prelude::*;
/// let samples = Grouped::new(Sobol::new(16)?).points(1);
/// // the image has the pattern itself, the lens the same points in another order, and time one sample per sixteenth
/// let image: Vec<[f64; 2]> = Sobol::new(16)?.points(1);
/// assert!(samples.iter().zip(&image).all(|(s, p)| [s[0], s[1]] == *p));
/// assert!(image.iter().all(|p| samples.iter().any(|s| [s[3], s[4]] == *p)));
/// let mut times: Vec<usize> = samples.iter().map(|s| (16.0 * s[2]) as usize).collect();
/// times.sort_unstable();
/// assert!(times.into_iter().eq(0..16));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grouped<P> {
    plane: P,
}

impl<P: Pattern<2>> Grouped<P> {
    /// `plane` for image and lens.
    pub fn new(plane: P) -> Self {
        Self { plane }
    }
}

impl<P: Pattern<2>> Pattern<5> for Grouped<P> {
    fn name(&self) -> String {
        self.plane.name()
    }

    fn count(&self) -> Option<usize> {
        self.plane.count()
    }

    fn points(&self, seed: u64) -> Vec<[f64; 5]> {
        let image = self.plane.points(seed);
        let n = image.len();
        let lens = self.plane.points(bits(seed, 1, 5));
        let (times, lenses) = (permutation(bits(seed, 2, 5), n), permutation(bits(seed, 3, 5), n));
        let sample = |(i, [x, y]): (usize, [f64; 2])| {
            let t = within_cell(times[i].into(), n as u64, uniform(seed, i as u64, 2));
            let [u, v] = if lens.is_empty() { [0.5; 2] } else { lens[lenses[i] as usize % lens.len()] };
            [x, y, t, u, v]
        };
        image.into_iter().enumerate().map(sample).collect()
    }
}

/// The names of all patterns for image, time and lens: `padded`, and those of the [catalogue](catalog).
pub fn names() -> impl Iterator<Item = &'static str> {
    std::iter::once("padded").chain(catalog::names())
}

/// The pattern of that name for image, time and lens, with `count` samples: [`Padded`], independent points in all five
/// dimensions for `random`, or one of the plane's, [`Grouped`].
///
/// ```
/// use nyquist::pattern::grouped::by_name;
/// assert_eq!(by_name("sobol-owen", 13)?.count(), Some(13));
/// let error = by_name("padded", 13).unwrap_err();
/// assert!(error.to_string().ends_with("13 is impossible; the nearest numbers are 9 and 16"));
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// As [`catalog::by_name`]: an unknown name, a number of samples that the pattern cannot have.
pub fn by_name(name: &str, count: usize) -> Result<Box<dyn Pattern<5>>> {
    match name {
        "padded" => Ok(Box::new(Padded::with_count(count)?)),
        "random" => Ok(Box::new(Random::new(count)?)),
        _ => match catalog::by_name(name, count) {
            Ok(plane) => Ok(Box::new(Grouped::new(plane))),
            Err(Error::Unknown { .. }) => {
                Err(unknown("pattern", name, names().chain(catalog::FAMILIES.iter().copied())))
            }
            Err(other) => Err(other),
        },
    }
}
