//! V24: Kadec's quarter theorem, in finite sections.
//!
//! The oracle: Kadec's formula, and eigenvalues of the same matrices as Rayleigh quotients in 80-bit arithmetic (numpy
//! longdouble, entries by the closed form) of the eigenvectors that LAPACK finds.

use nyquist::laws::frames::{gram, kadec_bounds, levinson, riesz_bounds};
use nyquist::num::svd::Svd;
use nyquist::prelude::*;
use std::f64::consts::PI;

#[test]
fn eigenvalues_agree_with_those_of_longer_arithmetic() {
    let known = [
        (20, 0.1, 0.626_714_097_613_285_2, 1.289_822_541_013_962_3),
        (20, 0.2, 0.312_779_041_422_890_54, 1.487_932_645_215_829_7),
        (20, 0.25, 0.198_409_670_315_022_35, 1.524_444_552_307_478),
        (20, 0.3, 0.115_586_311_748_910_3, 1.510_769_761_273_149_4),
        (80, 0.1, 0.583_410_339_158_015_8, 1.350_812_106_489_871_3),
        (80, 0.24, 0.163_680_976_146_341_06, 1.617_698_658_318_800_9),
        (80, 0.25, 0.144_930_718_620_858_82, 1.620_726_748_802_873_6),
    ];
    for (half, deviation, least, greatest) in known {
        let [low, high] = riesz_bounds(&levinson(half, deviation)).expect("positions");
        let rounding = f64::EPSILON * f64::from(2 * half + 1) * greatest;
        assert!(
            (low - least).abs() < rounding && (high - greatest).abs() < rounding,
            "{half} {deviation}: {low} {high}"
        );
    }
}

#[test]
fn below_a_quarter_they_stay_within_the_bounds() {
    for deviation in [0.05, 0.1, 0.2, 0.24] {
        let (cosine, sine) = ((PI * deviation).cos(), (PI * deviation).sin());
        let [least, most] = kadec_bounds(deviation).expect("below a quarter");
        assert!(
            (least - (cosine - sine).powi(2)).abs() < 1e-15 && (most - (2.0 - cosine + sine).powi(2)).abs() < 1e-15
        );
        for half in [5, 20, 60] {
            let [low, high] = riesz_bounds(&levinson(half, deviation)).expect("positions");
            assert!(least <= low && high <= most);
        }
    }
}

#[test]
fn beyond_a_quarter_there_is_nothing_to_stop_the_fall() {
    assert!(kadec_bounds(0.25).expect("a quarter is the limit")[0] < 1e-30);
    assert!(matches!(kadec_bounds(0.26), Err(Error::OutOfRange { .. })));
    // the least eigenvalue keeps falling as the section grows, by a power of its size: at L = 0.4 by √2·… per doubling
    let least = |half| riesz_bounds(&levinson(half, 0.4)).expect("positions")[0];
    let (a, b, c) = (least(10), least(20), least(40));
    assert!(b < 0.7 * a && c < 0.7 * b && c < 0.02);
    // while at L = 0.1 it settles above Kadec's 0.412
    let least = |half| riesz_bounds(&levinson(half, 0.1)).expect("positions")[0];
    assert!(least(40) > 0.94 * least(20) && least(40) > 0.412);
}

#[test]
fn whole_numbers_are_orthonormal_and_coinciding_positions_dependent() {
    assert_eq!(riesz_bounds(&[3.0, -7.0, 0.0]).expect("positions"), [1.0, 1.0]);
    assert!(riesz_bounds(&[0.0, 0.0]).expect("positions")[0] < 1e-15);
    assert!(gram(&[]).is_err() && gram(&[f64::INFINITY]).is_err());
}

#[test]
fn singular_values_and_least_squares_agree_with_lapack() {
    // numpy.linalg.svd and lstsq of a 8 × 5 matrix
    let matrix =
        ndarray::Array2::from_shape_fn((8, 5), |(i, j)| ((i * j) as f64 + 1.0).cos() + f64::from(u8::from(i == j)));
    let svd = Svd::of(&matrix).expect("a tall matrix");
    let known = [3.113_220_73, 2.576_492_51, 1.961_982_37, 1.355_335_24, 1.084_071_39];
    assert!(svd.values().iter().zip(known).all(|(a, b)| (a - b).abs() < 5e-9));
    let squares: Vec<f64> = (0..8).map(|i| f64::from(i * i)).collect();
    let known = [17.873_288_78, 4.620_071_6, -0.985_745_97, -4.206_287_06, -3.453_722];
    let solution = svd.solve(&squares).expect("eight numbers");
    assert!(solution.iter().zip(known).all(|(a, b)| (a - b).abs() < 5e-8), "{solution:?}");
    // the Hilbert matrix of order 6: its smallest singular value, seven digits below the largest, to nine digits
    let hilbert = ndarray::Array2::from_shape_fn((6, 6), |(i, j)| 1.0 / (i + j + 1) as f64);
    let svd = Svd::of(&hilbert).expect("a square matrix");
    assert!((svd.values()[5] / 1.082_799_48e-7 - 1.0).abs() < 1e-8);
    assert!((svd.condition() / 1.495_105_864e7 - 1.0).abs() < 1e-8);
}

#[test]
fn bad_matrices_are_named() {
    use ndarray::Array2;
    assert!(matches!(Svd::of(&Array2::zeros((2, 3))), Err(Error::TooFew { least: 3, got: 2, .. })));
    assert!(matches!(Svd::of(&Array2::zeros((2, 0))), Err(Error::TooFew { .. })));
    assert!(matches!(Svd::of(&Array2::from_elem((2, 1), f64::NAN)), Err(Error::NotFiniteAt { index: 0, .. })));
    let svd = Svd::of(&Array2::eye(2)).expect("a square matrix");
    assert!(matches!(svd.solve(&[1.0]), Err(Error::Length { expected: 2, got: 1, .. })));
    assert!(Svd::of(&Array2::zeros((2, 2))).expect("a square matrix").condition().is_nan());
}
