//! A blue-noise tile ranks every cell once, and every level of it is blue noise; the points are progressive.

use nyquist::pattern::blue_noise::Tile;
use nyquist::pattern::measure::radial::rings;
use nyquist::prelude::*;

#[test]
fn every_rank_once_and_the_same_in_every_run() {
    for side in [16, 24, 64] {
        let tile = Tile::new(side, 3).expect("a multiple of eight");
        let mut ranks: Vec<u32> = (0..side * side).map(|i| tile.rank(i % side, i / side)).collect();
        assert_eq!(tile, Tile::new(side, 3).expect("a multiple of eight"));
        assert_ne!(tile, Tile::new(side, 4).expect("a multiple of eight"));
        assert_eq!(tile.rank(5, 7), tile.rank(5 + side, 7 + 2 * side));
        ranks.sort_unstable();
        assert!(ranks.into_iter().eq(0..(side * side) as u32));
    }
}

#[test]
fn every_level_has_little_noise_at_low_frequencies() {
    let side = 64;
    let tile = Tile::new(side, 0).expect("a multiple of eight");
    for part in [0.05, 0.1, 0.25, 0.5, 0.75] {
        let cells = (0..side * side).map(|i| [i % side, i / side]).filter(|&[x, y]| tile.threshold(x, y) < part);
        let points: Vec<[f64; 2]> = cells.map(|cell| cell.map(|c| (c as f64 + 0.5) / side as f64)).collect();
        assert_eq!(points.len(), (part * (side * side) as f64).round() as usize);
        let low = (0.3 * (points.len() as f64).sqrt().min(side as f64 / 2.0)).floor();
        let found = rings(&Periodogram::of(&points, 32).expect("points"), low).expect("a width")[0];
        // independent cells would have 1 − part
        assert!(found.power < 0.12 * (1.0 - part), "{part}: {found:?}");
    }
}

#[test]
fn beginnings_of_the_points_are_blue_noise_themselves() {
    let points = BlueNoise::new(1024).expect("points").points(2);
    for n in [100, 300, 1024] {
        let found =
            rings(&Periodogram::of(&points[..n], 32).expect("points"), 0.3 * (n as f64).sqrt()).expect("a width")[0];
        assert!(found.power < 0.15, "{n}: {found:?}");
        assert!(min_distance_torus(&points[..n]).expect("points") > 0.3 * most_distance(n), "{n}");
    }
}

#[test]
fn sides_that_are_impossible_are_named() {
    assert!(matches!(Tile::new(60, 0), Err(Error::Count { given: 60, below: 56, above: 64, .. })));
    assert!(Tile::new(8, 0).is_err() && Tile::new(2048, 0).is_err());
    assert!(matches!(BlueNoise::new(BlueNoise::MOST + 1), Err(Error::Overflow { .. })));
}
