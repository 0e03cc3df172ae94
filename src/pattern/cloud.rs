//! Points of any number of dimensions, by the name of their pattern.

use crate::error::{Error, Result, unknown, within};
use crate::pattern::halton::Halton;
use crate::pattern::hammersley::Hammersley;
use crate::pattern::jittered::Jittered;
use crate::pattern::n_rooks::NRooks;
use crate::pattern::padded::{Association, Padded};
use crate::pattern::random::Random;
use crate::pattern::regular::Regular;
use crate::pattern::scrambling::Scrambling::{Digits, Owen};
use crate::pattern::sobol::Sobol;
use crate::pattern::{MOST_POINTS, Pattern, catalog};

/// The most dimensions that a pattern is made in by its name; types go further.
pub const MOST_DIMENSIONS: usize = 16;

/// The most coordinates that all points together may have: a gigabyte, as for the most points of the plane.
const MOST_NUMBERS: usize = 2 * MOST_POINTS;

/// The dimensions in which there is a pattern of some name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimensions {
    /// From one to [`MOST_DIMENSIONS`].
    Any,
    /// This number alone.
    Only(usize),
}

/// A pattern of the catalogue: what is known of it before there are points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Known {
    /// Its name.
    pub name: &'static str,
    /// The dimensions in which there is one.
    pub dimensions: Dimensions,
}

/// The patterns of five dimensions: image, time and lens.
const GROUPED: [(&str, Association); 2] =
    [("padded", Association::Shuffled), ("padded-in-order", Association::InOrder)];

type Make<const D: usize> = fn(usize) -> Result<Box<dyn Pattern<D>>>;

/// The patterns that are the same idea in every dimension.
fn spatial<const D: usize>() -> [(&'static str, Make<D>); 11] {
    [
        ("regular", |n| Ok(Box::new(Regular::with_count(n)?))),
        ("regular-offset", |n| Ok(Box::new(Regular::with_count(n)?.with_random_offset()))),
        ("random", |n| Ok(Box::new(Random::new(n)?))),
        ("jittered", |n| Ok(Box::new(Jittered::with_count(n)?))),
        ("n-rooks", |n| Ok(Box::new(NRooks::new(n)?))),
        ("halton", |n| Ok(Box::new(Halton::new(n)?))),
        ("halton-permuted", |n| Ok(Box::new(Halton::new(n)?.scrambled(Digits)))),
        ("halton-owen", |n| Ok(Box::new(Halton::new(n)?.scrambled(Owen)))),
        ("hammersley", |n| Ok(Box::new(Hammersley::new(n)?))),
        ("sobol", |n| Ok(Box::new(Sobol::new(n)?))),
        ("sobol-owen", |n| Ok(Box::new(Sobol::new(n)?.scrambled(Owen)))),
    ]
}

/// All patterns with the dimensions that they come in: those of the plane first.
pub fn known() -> Vec<Known> {
    let any = |name| spatial::<2>().iter().any(|entry| entry.0 == name);
    let of = |name| Known { name, dimensions: if any(name) { Dimensions::Any } else { Dimensions::Only(2) } };
    let grouped = GROUPED.iter().map(|entry| Known { name: entry.0, dimensions: Dimensions::Only(5) });
    catalog::names().map(of).chain(grouped).collect()
}

/// Points of a pattern in a number of dimensions that is known only when the program runs.
#[derive(Debug, Clone, PartialEq)]
pub struct Cloud {
    dimensions: usize,
    coordinates: Vec<f64>,
}

impl Cloud {
    /// The points of the pattern of that name, `count` of them (`poisson-disk`: about so many) in the unit cube of
    /// `dimensions` dimensions. In the plane, all of [`catalog`]; beyond it, those that are the same idea there.
    ///
    /// ```
    /// use nyquist::pattern::cloud::Cloud;
    /// use nyquist::prelude::*;
    /// let cloud = Cloud::new("sobol", 3, 4, 0)?;
    /// assert_eq!(cloud.iter().nth(2), Some(&[0.25, 0.75, 0.75][..]));
    /// let error = Cloud::new("poisson-disk", 3, 64, 0).unwrap_err();
    /// assert_eq!(error.to_string(), "dimensions of the pattern poisson-disk: only 2 are possible, not 3");
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`catalog::by_name`]; a number of dimensions that the pattern does not have.
    pub fn new(name: &str, dimensions: usize, count: usize, seed: u64) -> Result<Self> {
        if let Some((_, association)) = GROUPED.iter().find(|entry| entry.0 == name) {
            only(name, 5, dimensions)?;
            return Ok(Self::of(Padded::with_count(count)?.associated(*association).points(seed)));
        }
        if dimensions == 2 && (known().iter().any(|k| k.name == name) || name.contains(':')) {
            return Ok(Self::of(catalog::by_name(name, count)?.points(seed)));
        }
        let family = name.split(':').next().unwrap_or(name);
        match known().iter().find(|k| k.name == family) {
            None => {
                return Err(unknown(
                    "pattern",
                    name,
                    known().iter().map(|k| k.name).chain(catalog::FAMILIES.iter().copied()),
                ));
            }
            Some(Known { dimensions: Dimensions::Only(own), .. }) => only(name, *own, dimensions)?,
            Some(_) if name != family => only(name, 2, dimensions)?,
            Some(_) => {}
        }
        within("the number of dimensions", dimensions as f64, 1.0, MOST_DIMENSIONS as f64)?;
        let numbers = count.saturating_mul(dimensions);
        if numbers > MOST_NUMBERS {
            let what = "the number of coordinates of all points";
            return Err(Error::Overflow { what, value: numbers as f64, most: MOST_NUMBERS as f64 });
        }
        macro_rules! in_dimensions {
            ($($d:literal)*) => {
                match dimensions {
                    $($d => Self::spatial::<$d>(name, count, seed),)*
                    _ => unreachable!("the number of dimensions has been checked"),
                }
            };
        }
        in_dimensions!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16)
    }

    fn spatial<const D: usize>(name: &str, count: usize, seed: u64) -> Result<Self> {
        let table = spatial::<D>();
        let entry = table.iter().find(|entry| entry.0 == name);
        let (_, make) = entry.ok_or_else(|| unknown("pattern", name, table.iter().map(|entry| entry.0)))?;
        Ok(Self::of(make(count)?.points(seed)))
    }

    fn of<const D: usize>(points: Vec<[f64; D]>) -> Self {
        Self { dimensions: D, coordinates: points.into_flattened() }
    }

    /// How many coordinates a point has.
    pub fn dimensions(&self) -> usize {
        self.dimensions
    }

    /// How many points there are: at least one.
    #[allow(clippy::len_without_is_empty, reason = "no pattern is empty")]
    pub fn len(&self) -> usize {
        self.coordinates.len() / self.dimensions
    }

    /// The points, in the order of their pattern.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        self.coordinates.chunks_exact(self.dimensions)
    }

    /// The points of a line, if this is one.
    pub fn line(&self) -> Option<&[f64]> {
        (self.dimensions == 1).then_some(&self.coordinates)
    }

    /// The points of the plane, if this is one.
    pub fn plane(&self) -> Option<&[[f64; 2]]> {
        (self.dimensions == 2).then_some(self.coordinates.as_chunks().0)
    }
}

fn only(name: &str, own: usize, dimensions: usize) -> Result<()> {
    if dimensions == own {
        return Ok(());
    }
    Err(Error::Dimensions { pattern: name.to_owned(), own, given: dimensions })
}
