//! Stratification in five dimensions (E17, slide "Стратификация в многомерном случае"): four strata in each dimension are
//! 4⁵ cells, four in each group of dimensions are four samples, associated at random.

use nyquist::prelude::*;

fn quarter(s: &[f64; 5], d: usize) -> usize {
    (2.0 * s[d]) as usize + 2 * ((2.0 * s[d + 1]) as usize)
}

/// The strata that a sample is in: image, time, lens.
fn strata(s: &[f64; 5]) -> [usize; 3] {
    [quarter(s, 0), (4.0 * s[2]) as usize, quarter(s, 3)]
}

#[test]
fn four_strata_in_each_dimension_are_1024_samples_and_in_each_group_four() {
    let dimensions = Jittered::new([4; 5]).expect("cells");
    assert_eq!((dimensions.count(), dimensions.points(1).len()), (Some(1024), 1024));
    for seed in 0..200 {
        let groups = Padded::new(2).expect("samples").points(seed);
        assert_eq!(groups.len(), 4);
        for group in 0..3 {
            let mut found: Vec<usize> = groups.iter().map(|s| strata(s)[group]).collect();
            found.sort_unstable();
            assert_eq!(found, [0, 1, 2, 3]);
        }
    }
}

#[test]
fn all_576_associations_are_equally_likely() {
    const DRAWS: usize = 100_000;
    let index = |order: [usize; 4]| {
        // the number of a permutation: how many of the later ones are smaller, in mixed radix
        (0..4).fold(0, |sum, i| sum * (4 - i) + order[i + 1..].iter().filter(|j| **j < order[i]).count())
    };
    let pattern = Padded::new(2).expect("samples");
    let mut counts = vec![0usize; 576];
    for seed in 0..DRAWS as u64 {
        let samples = pattern.points(seed);
        let of = |group: usize| std::array::from_fn(|i| strata(&samples[i])[group]);
        assert_eq!(of(0), [0, 1, 2, 3]);
        counts[index(of(1)) * 24 + index(of(2))] += 1;
    }
    let expected = DRAWS as f64 / 576.0;
    let chi: f64 = counts.iter().map(|&c| (c as f64 - expected).powi(2) / expected).sum();
    // χ² with 575 degrees of freedom: mean 575, deviation √1150
    assert!((chi - 575.0).abs() < 4.0 * 1150f64.sqrt(), "{chi}");
}

#[test]
fn without_shuffling_image_and_lens_go_together() {
    let correlation = |pattern: Padded| {
        let pairs: Vec<[f64; 2]> = (0..500)
            .flat_map(|seed| pattern.points(seed))
            .map(|s| [strata(&s)[0], strata(&s)[2]].map(|k| k as f64 - 1.5))
            .collect();
        pairs.iter().map(|[a, b]| a * b).sum::<f64>() / pairs.iter().map(|[a, _]| a * a).sum::<f64>()
    };
    let pattern = Padded::new(2).expect("samples");
    assert_eq!(correlation(pattern.associated(Association::InOrder)), 1.0);
    // shuffled, the correlation of four has the variance 1/3: 500 of them
    assert!(correlation(pattern).abs() < 4.0 / 1500f64.sqrt());
}

#[test]
fn strata_in_every_single_coordinate_do_not_stratify_the_groups() {
    // four rooks in five dimensions fill the four quarters of (x, y) in 2/3 of all cases: 16 of 24 permutations
    const DRAWS: u32 = 3000;
    let rooks = NRooks::new(4).expect("points");
    let fills = |seed: u64| {
        let points: Vec<[f64; 5]> = rooks.points(seed);
        let found: std::collections::HashSet<usize> = points.iter().map(|s| quarter(s, 0)).collect();
        found.len() == 4
    };
    let part = (0..DRAWS.into()).filter(|seed| fills(*seed)).count() as f64 / f64::from(DRAWS);
    assert!((part - 2.0 / 3.0).abs() < 4.0 * (2.0 / 9.0 / f64::from(DRAWS)).sqrt(), "{part}");
}

#[test]
fn groups_that_are_not_stratified_are_independent_points() {
    let pattern = Padded::new(4).expect("samples").stratified(true, false, false);
    let empty = |group: usize| {
        let count = |seed: u64| {
            let found: std::collections::HashSet<usize> = pattern
                .points(seed)
                .iter()
                .map(|s| match group {
                    0 => (4.0 * s[0]) as usize + 4 * ((4.0 * s[1]) as usize),
                    1 => (16.0 * s[2]) as usize,
                    _ => (4.0 * s[3]) as usize + 4 * ((4.0 * s[4]) as usize),
                })
                .collect();
            16 - found.len()
        };
        (0..500).map(count).sum::<usize>() as f64 / 8000.0
    };
    // (15/16)^16 = 0.356 of the strata stay empty; one count of 16 deviates by less than 2
    assert_eq!(empty(0), 0.0);
    let known = (15.0f64 / 16.0).powi(16);
    assert!([1, 2].iter().all(|&g| (empty(g) - known).abs() < 4.0 * 2.0 / (16.0 * 500f64.sqrt())));
}
