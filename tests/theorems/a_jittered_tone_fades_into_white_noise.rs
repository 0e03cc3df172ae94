//! V11: values taken at jittered positions and displayed at regular ones.

use nyquist::laws::jitter::{displayed_on_the_grid, jittered_tone};
use nyquist::prelude::*;
use std::f64::consts::PI;

fn comb(jitter: Jitter) -> JitteredComb {
    JitteredComb::new(1.0, jitter).expect("a comb")
}

#[test]
fn a_tone_of_100_in_512_leaves_a_line_of_0_22016_and_noise_of_0_05968() {
    let nu = 100.0 / 512.0;
    let phi = (PI * nu).sin() / (PI * nu);
    let (line, noise) = (0.25 * phi * phi, 0.5 * (1.0 - phi * phi));
    assert!((line - 0.220_16).abs() < 5e-6 && (noise - 0.059_68).abs() < 5e-6); // the inventory's theory
    let found = displayed_on_the_grid(&comb(Jitter::Uniform { width: 1.0 }), 1, 512, 2000, 100).expect("a tone");
    // four standard deviations: of the mean of a million squares below 4, and of the amplitude times φ
    let count: f64 = 512.0 * 2000.0;
    assert!((found.noise - noise).abs() < 4.0 * (4.0 * noise / count).sqrt(), "{}", found.noise);
    assert!((found.line - line).abs() < 4.0 * phi * (noise / count).sqrt(), "{}", found.line);
    // energy is conserved, not removed: two lines, and noise in all bins
    assert!((2.0 * found.line + found.noise - 0.5).abs() < 1e-3);
}

#[test]
fn the_noise_is_white_and_not_blue() {
    let found = displayed_on_the_grid(&comb(Jitter::Uniform { width: 1.0 }), 1, 512, 2000, 100).expect("a tone");
    let mean = |bins: std::ops::Range<usize>| {
        let len = bins.len() as f64;
        found.bins[bins].iter().sum::<f64>() / len
    };
    // the lowest and the highest 64 frequencies; 64 bins of 2000 patterns each deviate by √(2/(64·2000)) = 0.4 %
    let (low, high) = (mean(1..65), mean(192..256));
    assert!((low / high - 1.0).abs() < 4.0 * 2f64.sqrt() * 0.004, "{low} {high}");
    // a comb's own spectrum is blue: in the first bins there is nothing
    assert!(comb(Jitter::Uniform { width: 1.0 }).noise(1.0 / 512.0) < 2e-5);
}

#[test]
fn without_jitter_nothing_fades_and_with_independent_positions_everything_does() {
    let found = displayed_on_the_grid(&comb(Jitter::None), 1, 512, 1, 100).expect("a tone");
    assert!((found.line - 0.25).abs() < 1e-15 && found.noise < 1e-28);
    let found = displayed_on_the_grid(&comb(Jitter::Independent), 1, 512, 500, 100).expect("a tone");
    assert!(found.line < 1e-4 && (found.noise - 0.5).abs() < 0.01);
    assert!(jittered_tone(&comb(Jitter::None), &comb(Jitter::None), 1, 512, 1, 256).is_err());
}
