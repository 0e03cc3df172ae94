//! E06, E34, E35: kernels and prefilters that are not scaled with the step.

use nyquist::num::sinc;
use nyquist::prelude::*;
use std::f64::consts::PI;

fn signal() -> impl Signal {
    from_fn(|x| (1.3 * x).sin() + 0.4 * (2.1 * x + 1.0).cos())
}

/// The lecture's `f̃ = T Σ f(iT) r(x − iT)`, literally, over `|i| ≤ 400`.
fn literally(f: &impl Signal, step: f64, r: impl Fn(f64) -> f64, x: f64) -> f64 {
    (-400..=400).map(|i| step * f.at(f64::from(i) * step) * r(x - f64::from(i) * step)).sum()
}

fn tent(x: f64) -> f64 {
    (1.0 - x.abs()).max(0.0)
}

#[test]
fn e06_the_unscaled_tent_is_right_for_a_step_of_one_only() {
    let f = signal();
    for i in 0..40 {
        let x = -1.93 + 0.1 * f64::from(i);
        let (k, part) = (x.floor(), x - x.floor());
        let linear = (1.0 - part) * f.at(k) + part * f.at(k + 1.0);
        assert!((literally(&f, 1.0, tent, x) - linear).abs() < 1e-14);
    }
    // at T = ½ it does not even pass through the samples: it smooths
    let at_samples = (-4..=4).map(|i| 0.5 * f64::from(i));
    let worst = at_samples.map(|x| (literally(&f, 0.5, tent, x) - f.at(x)).abs()).fold(0.0, f64::max);
    assert!(worst > 0.1, "{worst}");
}

#[test]
fn e06_scaled_with_the_step_the_tent_interpolates() {
    let f = signal();
    let samples = Samples::of(&f, Axis::centered(0.5, 41).unwrap());
    let back = reconstruct(&samples, TentKernel);
    for i in 0..40 {
        let x = -1.93 + 0.1 * f64::from(i);
        let (k, part) = ((x / 0.5).floor() * 0.5, (x / 0.5).fract().rem_euclid(1.0));
        let linear = (1.0 - part) * f.at(k) + part * f.at(k + 0.5);
        assert!((back.at(x) - linear).abs() < 1e-14);
        // r(x) = k(x/T)/T in the lecture's own formula
        assert!((literally(&f, 0.5, |x| tent(x / 0.5) / 0.5, x) - linear).abs() < 1e-14);
        // and the unscaled tent is the widened kernel, whatever one thinks of it
        let unscaled = reconstruct(&samples, Widened::new(TentKernel, 2.0).unwrap());
        assert!((unscaled.at(x) - literally(&f, 0.5, tent, x)).abs() < 1e-14);
    }
}

#[test]
fn e06_the_ideal_filter_is_sinc_of_x_over_t_divided_by_t() {
    // (1/T)·sinc(x/T) has the response of the unit box of width 1/T; sinc(x/T) has T times it: the chain's gain is T
    let f = RaisedCosine::new(0.9).unwrap();
    let step = 0.5;
    for x in [0.0, 0.2, 0.77] {
        let right = literally(&f, step, |x| sinc(x / step) / step, x);
        let without = literally(&f, step, |x| sinc(x / step), x);
        // left out: 8B/(9π²)·(2BT·400)⁻³, twice
        assert!((right - f.at(x)).abs() < 1e-8);
        assert!((without - step * f.at(x)).abs() < 1e-8 && (without - f.at(x)).abs() > 0.1);
    }
}

#[test]
fn e35_the_printed_sinc_series_works_for_a_step_of_one_only() {
    // printed: f̃ = Σ sinc(x − Ti)·f(Ti); right: Σ sinc(x/T − i)·f(iT)
    let f = RaisedCosine::new(0.5).unwrap();
    let series = |step: f64, x: f64, weight: &dyn Fn(f64) -> f64| -> f64 {
        (-4000..=4000).map(|i| f.at(step * f64::from(i)) * weight(x - step * f64::from(i))).sum()
    };
    for x in [0.1, 0.25, 0.9, 1.6] {
        assert!((series(1.0, x, &sinc) - f.at(x)).abs() < 1e-12);
        let (printed, right) = (series(0.5, x, &sinc), series(0.5, x, &|y| sinc(y / 0.5)));
        assert!((right - f.at(x)).abs() < 1e-10);
        assert!((printed - 2.0 * f.at(x)).abs() < 1e-10, "twice as many terms of the same width: {printed}");
        let samples = Samples::of(&f, Axis::centered(0.5, 8001).unwrap());
        assert!((reconstruct(&samples, Ideal).at(x) - right).abs() < 1e-14);
    }
    // and sinc_T(x) = sinc(Tx) gets narrower as the step grows: its zeros stand at 1/T, not at the samples
    let step = 0.5;
    assert!(sinc(step * step).abs() > 0.8 && sinc(step / step) == 0.0);
}

#[test]
fn e34_to_stop_what_is_above_half_the_rate_the_prefilter_is_the_rate_times_sinc_of_the_rate_times_x() {
    let rate = 4.0;
    // a burst e^{−π(y/5)²}·cos(2πνy), all of it within 0.8/5 of ν; the convolution by the trapezoid rule, which is exact
    // to rounding here: the integrand's band is below ν + 0.8 + rate < 1/(2h), its tail beyond 20 is e^{−50}
    let filtered = |nu: f64, filter: &dyn Fn(f64) -> f64, x: f64| -> f64 {
        let h = 1.0 / 64.0;
        (-1280..=1280)
            .map(|i| {
                let y = h * f64::from(i);
                h * (-PI * (y / 5.0).powi(2)).exp() * (2.0 * PI * nu * y).cos() * filter(x - y)
            })
            .sum()
    };
    let burst = |nu: f64, x: f64| (-PI * (x / 5.0f64).powi(2)).exp() * (2.0 * PI * nu * x).cos();
    let right = |x: f64| rate * sinc(rate * x);
    let printed = |x: f64| sinc(2.0 * rate * x);
    for x in [0.0, 0.1, 0.33] {
        // below half the rate: kept by the right one, scaled by 1/(2·rate) by the printed one
        assert!((filtered(1.0, &right, x) - burst(1.0, x)).abs() < 1e-8);
        assert!((filtered(1.0, &printed, x) - burst(1.0, x) / (2.0 * rate)).abs() < 1e-8);
        // between half the rate and the rate: it would alias; removed by the right one, passed by the printed one
        assert!(filtered(3.2, &right, x).abs() < 1e-8);
        assert!((filtered(3.2, &printed, x) - burst(3.2, x) / (2.0 * rate)).abs() < 1e-8);
    }
    // as a kernel: in units of the step the right one is the ideal kernel, the printed one that of half the width
    let half = Widened::new(Ideal, 0.5).unwrap();
    assert_eq!([Ideal.response(0.8), half.response(0.8)], [0.0, 1.0]);
    assert!((half.at(0.3 * rate) / (2.0 * rate) * rate - printed(0.3)).abs() < 1e-15 * rate);
}
