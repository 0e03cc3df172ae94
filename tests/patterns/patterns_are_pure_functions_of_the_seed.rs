//! What every pattern of the catalogue owes: as many points as it says, in the half-open square, the same for the same
//! seed, others for another.

use nyquist::pattern::{MOST_POINTS, catalog};
use nyquist::prelude::*;

const FIXED: [&str; 4] = ["regular", "halton", "hammersley", "sobol"];

#[test]
fn as_many_points_as_they_say_in_the_half_open_square() {
    for n in [4, 16, 64, 1024] {
        for (pattern, name) in catalog::all(n).expect("a square").iter().zip(catalog::names()) {
            let points = pattern.points(7);
            assert_eq!(pattern.name(), name);
            assert!(pattern.count().is_none_or(|count| count == n && points.len() == n), "{name}");
            assert!(points.iter().flatten().all(|c| (0.0..1.0).contains(c)), "{name}");
        }
    }
}

#[test]
fn the_same_points_for_the_same_seed_and_others_for_another() {
    for (pattern, name) in catalog::all(64).expect("a square").iter().zip(catalog::names()) {
        let again = catalog::by_name(name, 64).expect("a known name");
        assert_eq!(pattern.points(7), again.points(7), "{name}");
        assert_eq!(pattern.points(7) == pattern.points(8), FIXED.contains(&name), "{name}");
    }
}

/// Bits that a change of hashing, order or arithmetic would move. No transcendental function takes part.
#[test]
fn the_same_bits_in_every_version() {
    let print = |name| {
        let points: Vec<[f64; 2]> = catalog::by_name(name, 64).expect("a known name").points(1);
        points.iter().flatten().fold(0u64, |hash, c| (hash ^ c.to_bits()).wrapping_mul(0x0100_0000_01b3).rotate_left(7))
    };
    let found: Vec<String> = catalog::names().map(|name| format!("{name} {:016x}", print(name))).collect();
    let known: Vec<&str> = include_str!("bits.txt").lines().collect();
    assert_eq!(found, known, "{}", found.join("\n"));
}

/// Uniform in the mean: each coordinate's average is ½ within `z = 4.5` deviations of independent points, which no
/// stratified pattern exceeds.
#[test]
fn random_patterns_are_uniform() {
    for (pattern, name) in catalog::all(16).expect("a square").iter().zip(catalog::names()) {
        if FIXED.contains(&name) {
            continue;
        }
        let points: Vec<[f64; 2]> = (0..500).flat_map(|seed| pattern.points(seed)).collect();
        let n = points.len() as f64;
        let mean = |f: &dyn Fn(f64) -> f64| points.iter().flatten().map(|c| f(*c)).sum::<f64>() / (2.0 * n);
        // points of a pattern are dependent, and at worst move together: 500 independent numbers
        let deviation = |variance: f64| 4.5 * (variance / 500.0).sqrt();
        assert!((mean(&|c| c) - 0.5).abs() < deviation(1.0 / 12.0), "{name}");
        assert!((mean(&|c| c * c) - 1.0 / 3.0).abs() < deviation(4.0 / 45.0), "{name}");
    }
}

#[test]
fn one_sample_alone_is_the_one_of_the_pattern() {
    let seed = 12;
    let jittered = Jittered::new([7, 5]).expect("cells").with_width(0.3).expect("a width");
    let offset = Regular::new([7, 5]).expect("cells").with_random_offset();
    for (i, (a, b)) in jittered.points(seed).into_iter().zip(offset.points(seed)).enumerate() {
        assert_eq!((a, b), (jittered.sample(i, seed), offset.sample(i, seed)));
    }
    for scrambling in [Scrambling::None, Scrambling::Digits, Scrambling::Owen] {
        let sobol = Sobol::new(300).expect("points").scrambled(scrambling);
        let halton = Halton::new(300).expect("points").scrambled(scrambling);
        let zero_two = ZeroTwo::new(300).expect("points").scrambled(scrambling);
        let (s, h): (Vec<[f64; 7]>, Vec<[f64; 7]>) = (sobol.points(seed), halton.points(seed));
        let z = zero_two.points(seed);
        for i in 0..300usize {
            for d in 0..7 {
                assert_eq!(s[i][d], sobol.sample(i as u32, d, seed).expect("a dimension of the table"));
                assert_eq!(h[i][d], halton.sample(i as u32, d, seed).expect("a dimension of the table"));
            }
            assert_eq!(z[i], zero_two.sample(i as u32, seed));
            assert_eq!(z[i], [s[i][0], s[i][1]]); // the same scramble of the same digits
        }
    }
}

#[test]
fn what_is_impossible_is_named() {
    let count = |given, below, above| move |error: &Error| matches!(error, Error::Count { given: g, below: b, above: a, .. } if (*g, *b, *a) == (given, below, above));
    for name in ["regular", "jittered", "multi-jittered", "jittered:0.5"] {
        assert!(catalog::by_name(name, 50).is_err_and(|e| count(50, 49, 64)(&e)), "{name}");
        assert_eq!(catalog::nearest(name, 50).expect("49 will do").count(), Some(49));
    }
    assert!(Jittered::<3>::with_count(100).is_err_and(|e| count(100, 64, 125)(&e)));
    assert!(Padded::with_count(5).is_err_and(|e| count(5, 4, 9)(&e)));
    for name in catalog::names() {
        assert!(matches!(catalog::by_name(name, 0), Err(Error::TooFew { .. })), "{name}");
        assert!(matches!(catalog::by_name(name, MOST_POINTS + 1), Err(Error::Overflow { .. })), "{name}");
    }
    assert!(matches!(Jittered::new([usize::MAX, usize::MAX]), Err(Error::Overflow { .. })));
    assert!(matches!(Jittered::new([3, 0]), Err(Error::TooFew { .. })));
    for width in [-0.1, 1.1, f64::NAN, f64::INFINITY] {
        assert!(Jittered::new([2, 2]).expect("cells").with_width(width).is_err());
    }
    for radius in [0.0, -1.0, 0.6, 1e-9, f64::NAN] {
        assert!(PoissonDisk::new(radius).is_err());
    }
    assert!(BestCandidate::new(3).expect("points").with_candidates(0).is_err());
    assert!(Sobol::new(4).expect("points").sample(0, 32, 0).is_err());
    assert!(Halton::new(4).expect("points").sample(0, 64, 0).is_err());
    assert!(matches!(catalog::by_name("jittered:wide", 4), Err(Error::Unreadable { .. })));
    assert!(matches!(catalog::by_name("sobl", 4), Err(Error::Unknown { known, .. }) if known[0] == "sobol"));
}
