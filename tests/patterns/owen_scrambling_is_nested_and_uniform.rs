//! Owen's scrambling, by the definition of 1995: points that share their first `k` digits share them still, their next
//! digits remain different and uniform, and all digits after that are independent.

use nyquist::pattern::radical::radical_inverse;
use nyquist::prelude::*;

const SEEDS: u64 = 4000;

/// Whether counts of equally likely events are: χ² below its mean plus five deviations, `d + 5√(2d)`.
fn equally_likely(counts: &[usize]) -> bool {
    let expected = counts.iter().sum::<usize>() as f64 / counts.len() as f64;
    let chi: f64 = counts.iter().map(|&c| (c as f64 - expected).powi(2) / expected).sum();
    let freedom = counts.len() as f64 - 1.0;
    chi < freedom + 5.0 * (2.0 * freedom).sqrt()
}

fn digit(x: f64, base: u32, place: i32) -> usize {
    let scaled = x * f64::from(base).powi(place);
    ((scaled - scaled.floor()) * f64::from(base)) as usize
}

/// The scrambled values of two indices in one dimension, for many seeds.
fn pairs(dimension: usize, scrambling: Scrambling, a: u32, b: u32) -> Vec<[f64; 2]> {
    let halton = Halton::new(1).expect("a point").scrambled(scrambling);
    let sample = |index, seed| halton.sample(index, dimension, seed).expect("a dimension of the table");
    (0..SEEDS).map(|seed| [sample(a, seed), sample(b, seed)]).collect()
}

#[test]
fn common_digits_stay_common_and_the_next_ones_different() {
    // bases 2, 3 and 5; indices whose lowest three digits agree, and the fourth does not
    for (dimension, base, places) in [(0, 2u32, 3), (1, 3, 3), (2, 5, 3)] {
        let cube = base.pow(3);
        let (a, b) = (7 % cube, 7 % cube + cube);
        for [x, y] in pairs(dimension, Scrambling::Owen, a, b) {
            assert!((0..places).all(|k| digit(x, base, k) == digit(y, base, k)));
            assert_ne!(digit(x, base, places), digit(y, base, places));
        }
    }
}

#[test]
fn digits_are_uniform_and_after_the_first_difference_independent() {
    for (dimension, base) in [(0, 2usize), (1, 3), (2, 5)] {
        let cube = base.pow(3) as u32;
        let found = pairs(dimension, Scrambling::Owen, 7 % cube, 7 % cube + cube);
        for place in 0..9 {
            let mut single = vec![0; base];
            found.iter().for_each(|[x, _]| single[digit(*x, base as u32, place)] += 1);
            assert!(equally_likely(&single), "base {base}, place {place}");
        }
        // the first different digits: all ordered pairs of different digits alike
        let mut first = vec![0; base * base];
        found.iter().for_each(|[x, y]| first[digit(*x, base as u32, 3) * base + digit(*y, base as u32, 3)] += 1);
        let different: Vec<usize> = (0..base * base).filter(|i| i / base != i % base).map(|i| first[i]).collect();
        assert!(equally_likely(&different) && different.iter().sum::<usize>() == SEEDS as usize);
        // later digits: all pairs alike
        for place in 4..9 {
            let mut both = vec![0; base * base];
            let index = |x: f64| digit(x, base as u32, place);
            found.iter().for_each(|[x, y]| both[index(*x) * base + index(*y)] += 1);
            assert!(equally_likely(&both), "base {base}, place {place}");
        }
    }
}

#[test]
fn digits_of_different_dimensions_and_places_are_independent() {
    let sobol = Sobol::new(1).expect("a point").scrambled(Scrambling::Owen);
    let mut all = vec![0; 256];
    for seed in 0..SEEDS * 4 {
        let [x, y] = [0, 1].map(|d| sobol.sample(13, d, seed).expect("a dimension of the table"));
        all[(x * 16.0) as usize * 16 + (y * 16.0) as usize] += 1;
    }
    assert!(equally_likely(&all));
}

#[test]
fn one_word_for_all_points_is_not_nested() {
    // permuted digits: where two indices have the same digit, the scrambled ones are the same after any difference
    for [x, y] in pairs(0, Scrambling::Digits, 7, 15) {
        assert!((4..20).all(|k| digit(x, 2, k) == digit(y, 2, k)));
    }
}

#[test]
fn without_scrambling_the_values_are_the_exact_fractions() {
    let halton = Halton::new(1).expect("a point");
    for (dimension, base) in [2u32, 3, 5, 7, 11].into_iter().enumerate() {
        for index in (0..3000).chain([u32::MAX - 1, u32::MAX]) {
            let exact = radical_inverse(base, index).expect("a base");
            // digits one by one, from the last
            let (mut rest, mut digits) = (index, Vec::new());
            while rest > 0 {
                digits.push(rest % base);
                rest /= base;
            }
            let value = digits.iter().rev().fold(0.0, |sum, &d| (sum + f64::from(d)) / f64::from(base));
            assert!((exact.value() - value).abs() <= digits.len() as f64 * f64::EPSILON / 2.0);
            assert_eq!(halton.sample(index, dimension, 5).expect("a dimension of the table"), exact.value());
            assert!(exact.denominator == u64::from(base).pow(digits.len() as u32));
        }
    }
}
