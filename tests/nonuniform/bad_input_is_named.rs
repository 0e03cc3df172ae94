//! What cannot be is refused in a sentence.

use num_complex::Complex;
use nyquist::engine::nonuniform::{Nufft, PeriodicInterpolator, PlaneNufft};
use nyquist::error::Error;

#[test]
fn plans_that_cannot_be() {
    for tolerance in [0.0, -1.0, 1e-14, 0.5, f64::NAN] {
        assert!(Nufft::<f64>::new(10, 1, tolerance).is_err());
        assert!(PlaneNufft::<f64>::new([10, 10], [1, 1], tolerance).is_err());
        assert!(PeriodicInterpolator::<f64>::new(10, tolerance).is_err());
    }
    assert!(matches!(Nufft::<f32>::new(10, 1, 1e-6), Err(Error::OutOfRange { .. })));
    assert!(matches!(Nufft::<f64>::new(usize::MAX, 1, 1e-6), Err(Error::OutOfRange { .. })));
    assert!(matches!(Nufft::<f64>::new(10, 0, 1e-6), Err(Error::OutOfRange { .. })));
    assert!(matches!(PlaneNufft::<f64>::new([10, 1 << 20], [1, 1], 1e-6), Err(Error::OutOfRange { .. })));
    assert!(matches!(PeriodicInterpolator::<f64>::new(0, 1e-6), Err(Error::OutOfRange { .. })));
}

#[test]
fn points_weights_and_room_that_do_not_fit() {
    let nufft = Nufft::<f64>::new(10, 1, 1e-6).unwrap();
    let error = nufft.place(&[0.5, f64::NAN]).unwrap_err();
    assert_eq!(error.to_string(), "the positions of a transform must be finite, but number 1 (counted from 0) is NaN");
    let infinite = nufft.place(&[(0, 0.5), (0, f64::INFINITY)]);
    assert!(matches!(infinite, Err(Error::NotFiniteAt { index: 1, value: f64::INFINITY, .. })));
    let placed = nufft.place(&[0.5, 0.75]).unwrap();
    assert_eq!((placed.len(), placed.is_empty()), (2, false));
    assert!(matches!(nufft.spectrum(&placed, &[1.0]), Err(Error::Length { expected: 2, got: 1, .. })));
    assert!(matches!(nufft.values(&[Complex::ONE], &placed), Err(Error::Length { expected: 11, got: 1, .. })));
    let other = Nufft::<f64>::new(500, 1, 1e-6).unwrap();
    assert!(matches!(other.spectrum(&placed, &[1.0, 1.0]), Err(Error::Unsupported(_))));
    assert!(other.place_into(&[0.5], &mut nufft.place(&[0.5]).unwrap()).is_err());
    let plane = PlaneNufft::<f64>::new([3, 3], [1, 1], 1e-6).unwrap();
    let infinite = plane.place(&[[0.0, f64::NEG_INFINITY]]);
    assert!(matches!(infinite, Err(Error::NotFiniteAt { index: 0, value: f64::NEG_INFINITY, .. })));
    assert!(plane.spectrum(&plane.place(&[[0.0, 0.0]]).unwrap(), &[]).is_err());
    let between = PeriodicInterpolator::<f64>::new(4, 1e-6).unwrap();
    assert!(between.values(&[1.0; 5], &between.place(&[0.0]).unwrap()).is_err());
}

#[test]
fn no_points_have_no_spectrum_and_no_values() {
    let nufft = Nufft::<f64>::new(2, 1, 1e-6).unwrap();
    let none = nufft.place::<f64>(&[]).unwrap();
    assert_eq!(nufft.spectrum(&none, &[]).unwrap(), [Complex::ZERO; 3]);
    assert_eq!(nufft.values(&[Complex::ONE; 3], &none).unwrap(), [0.0; 0]);
    let plane = PlaneNufft::<f64>::new([1, 1], [1, 1], 1e-6).unwrap();
    assert_eq!(plane.spectrum(&plane.place::<f64>(&[]).unwrap(), &[]).unwrap(), [Complex::ZERO; 6]);
}
