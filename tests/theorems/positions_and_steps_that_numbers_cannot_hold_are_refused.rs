//! Steps without a rate, positions that coincide, lengths that no memory holds.

use nyquist::prelude::*;

#[test]
fn a_step_has_a_rate() {
    for step in [0.0, -1.0, f64::NAN, f64::INFINITY, 5e-324, 1e-310] {
        assert!(Axis::new(0.0, step, 8).is_err(), "{step:e}");
        assert!(Comb::new(step).is_err(), "{step:e}");
    }
    let axis = Axis::new(0.0, f64::MIN_POSITIVE, 8).expect("the least step");
    assert!(axis.rate().is_finite());
}

#[test]
fn neighbours_are_different_positions() {
    assert!(Axis::new(1e16, 0.1, 4).is_err());
    let axis = Axis::new(1e15, 1.0, 4).expect("the step is above the spacing of numbers there");
    assert!(axis.iter().zip(axis.iter().skip(1)).all(|(a, b)| a < b));
}

#[test]
fn lengths_have_an_end() {
    for len in [0, Axis::MOST + 1, usize::MAX] {
        assert!(Axis::new(0.0, 1.0, len).is_err(), "{len}");
    }
    let tone = Cosine::new(1.0).expect("a frequency").spectrum();
    assert!(tone.replicated(4.0, usize::MAX).is_err());
}
