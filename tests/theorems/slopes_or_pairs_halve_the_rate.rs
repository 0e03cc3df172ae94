//! V22: values with slopes, or pairs of samples, determine a signal at half the Nyquist rate.
//!
//! The oracle: the closed form of the signal, and plain sinc series summed here.

use nyquist::beyond::Interlaced;
use nyquist::prelude::*;
use std::f64::consts::PI;

/// `sinc⁴(x/20)·cos(2π·0.9x)`: the band is 0.9 + 4/40 = 1, the decay x⁻⁴.
struct Carried;

fn sinc(t: f64) -> f64 {
    if t == 0.0 { 1.0 } else { (PI * t).sin() / (PI * t) }
}

impl Signal for Carried {
    fn at(&self, x: f64) -> f64 {
        sinc(x / 20.0).powi(4) * (1.8 * PI * x).cos()
    }
}

impl Differentiable for Carried {
    fn slope(&self, x: f64) -> f64 {
        let t = x / 20.0;
        let sinc_slope = if t.abs() < 1e-6 { -PI * PI * t / 3.0 } else { ((PI * t).cos() - sinc(t)) / t };
        let envelope = 4.0 * sinc(t).powi(3) * sinc_slope / 20.0;
        envelope * (1.8 * PI * x).cos() - sinc(t).powi(4) * 1.8 * PI * (1.8 * PI * x).sin()
    }
}

fn places() -> impl Iterator<Item = f64> {
    (-100..100).map(|i| 0.0731 * f64::from(i))
}

fn worst(restored: impl Fn(f64) -> f64) -> f64 {
    places().map(|x| (restored(x) - Carried.at(x)).abs()).fold(0.0, f64::max)
}

/// What is allowed. Rounding: 8001 terms of which each is known to `ε·8001·2π` (the index times the steepest slope of a
/// kernel of band 1) of its value or slope, which add up to at most 13 and 13·2π: 10⁻⁹. The tail is nothing beside it:
/// `|f| ≤ (20/πx)⁴`, kernels fall as `1/(πk)`, and `2(20/π)⁴·2·Σ_{k>4000} k⁻⁵ < 10⁻¹¹`.
const TAIL: f64 = 1e-9;

#[test]
fn a_plain_series_at_rate_b_is_wrong() {
    let plain = |x: f64| -> f64 { (-4000..=4000).map(|k| Carried.at(f64::from(k)) * sinc(x - f64::from(k))).sum() };
    assert!(worst(plain) > 0.8, "{}", worst(plain));
}

#[test]
fn slopes_make_it_right() {
    let samples = DerivativeSamples::of(&Carried, Axis::centered(1.0, 8001).expect("an axis"));
    assert_eq!(samples.band(), 1.0);
    assert!(worst(|x| samples.at(x)) < TAIL, "{}", worst(|x| samples.at(x)));
    // at the nodes value and slope are reproduced by themselves
    let h = 1e-4;
    assert_eq!(samples.at(7.0), Carried.at(7.0));
    let slope = (samples.at(7.0 + h) - samples.at(7.0 - h)) / (2.0 * h);
    assert!((slope - Carried.slope(7.0)).abs() < 1e-5); // f‴h²/6, with f‴ ≤ (2π)³
}

#[test]
fn pairs_make_it_right_at_any_distance_and_for_a_price() {
    // the inventory's table of the price
    for (offset, gain) in [(0.5, 1.0), (0.25, 2.0), (0.1, 10.5), (0.01, 1014.0)] {
        let pairs = Interlaced::of(&Carried, Axis::centered(1.0, 8001).expect("an axis"), offset).expect("an offset");
        assert!((pairs.noise_gain() / gain - 1.0).abs() < 0.005);
        assert!((pairs.noise_gain() - (PI * offset).sin().powi(-2)).abs() < 1e-10);
        // the tail grows as the kernels do, by 1/sin(πa)
        let allowed = TAIL / (PI * offset).sin();
        assert!(worst(|x| pairs.at(x)) < allowed, "{offset}: {} {allowed}", worst(|x| pairs.at(x)));
    }
}

#[test]
fn half_way_pairs_are_uniform_samples_at_twice_the_rate() {
    let pairs = Interlaced::of(&Carried, Axis::centered(1.0, 401).expect("an axis"), 0.5).expect("an offset");
    let uniform: Vec<[f64; 2]> = pairs.points().collect();
    for x in places() {
        let series: f64 = uniform.iter().map(|[at, v]| v * sinc(2.0 * (x - at))).sum();
        assert!((pairs.at(x) - series).abs() < 1e-12);
    }
}

#[test]
fn the_kernel_is_one_at_its_node_and_zero_at_all_others() {
    for offset in [0.5, 0.25, 0.1, 0.01, 0.99] {
        for k in -5..=5 {
            let at_first = Interlaced::kernel(f64::from(k), offset);
            assert_eq!(at_first, f64::from(u8::from(k == 0)));
            let at_second = Interlaced::kernel(f64::from(k) + offset, offset);
            assert!(at_second.abs() < 1e-15 / offset.min(1.0 - offset));
        }
    }
}

#[test]
fn bad_input_is_named() {
    let axis = Axis::new(0.0, 1.0, 3).expect("an axis");
    assert!(matches!(Interlaced::of(&Carried, axis, 0.0), Err(Error::OutOfRange { .. })));
    assert!(matches!(Interlaced::of(&Carried, axis, 1.0), Err(Error::OutOfRange { .. })));
    assert!(matches!(Interlaced::new(axis, 0.5, vec![0.0; 3], vec![0.0; 2]), Err(Error::Length { .. })));
    assert!(matches!(DerivativeSamples::new(axis, vec![0.0; 3], vec![f64::NAN; 3]), Err(Error::NotFiniteAt { .. })));
}
