//! What a kernel claims of itself holds, what it does not claim fails; bad kernels cannot be made; all have stable names.

use nyquist::kernel::catalog::{self, by_name};
use nyquist::laws::kernels::{claims, even, silences, zero_past_radius};
use nyquist::prelude::*;

/// `max_x |Σ i^p k(x−i) − x^p|`, summed naively at places that are no simple fractions.
fn worst(kernel: &dyn Kernel, power: i32) -> f64 {
    (1..20)
        .map(|j| {
            let x = 0.0473 * f64::from(j);
            let sum: f64 = (-20..=20).map(|i| f64::from(i).powi(power) * kernel.at(x - f64::from(i))).sum();
            (sum - x.powi(power)).abs()
        })
        .fold(0.0, f64::max)
}

#[test]
fn the_claims_about_constants_and_lines_are_true_and_the_silences_too() {
    for kernel in catalog::all().iter().filter(|k| k.radius().is_finite()) {
        let claims = kernel.claims();
        assert_eq!(claims.reproduces_constants, worst(&**kernel, 0) < 1e-13, "{}", kernel.name());
        assert_eq!(claims.reproduces_lines, worst(&**kernel, 1) < 1e-12, "{}", kernel.name());
    }
}

#[test]
fn the_laws_agree_for_kernels_that_stand_in_no_catalogue() {
    let kernels: Vec<Box<dyn Kernel>> = vec![
        Box::new(Cubic::new(0.2, 0.4).unwrap()),
        Box::new(Cubic::new(0.3, 0.3).unwrap()),
        Box::new(Cubic::new(1.5, 0.0).unwrap()),
        Box::new(Cubic::new(1.2, -0.1).unwrap()),
        Box::new(Cubic::new(3.5, -0.2).unwrap()),
        Box::new(GaussianKernel::new(0.7, 3.0).unwrap()),
        Box::new(Lanczos::new(2.5).unwrap()),
        Box::new(Kaiser::new(6.5, 3.0).unwrap()),
        Box::new(Regularised::new(4.0, 1.2).unwrap()),
        Box::new(Widened::new(TentKernel, 3.0).unwrap()),
        Box::new(Widened::new(Cubic::catmull_rom(), 2.0).unwrap()),
        Box::new(Widened::new(Cubic::mitchell(), 1.3).unwrap()),
        Box::new(PbrtSinc::new(3.0, 2.0).unwrap()),
    ];
    for kernel in &kernels {
        let checked = claims(kernel).into_iter().chain(silences(kernel)).collect::<Vec<_>>();
        assert_eq!(checked.len(), 5);
        for r in checked.into_iter().chain([even(kernel), zero_past_radius(kernel)]) {
            assert!(r.holds(), "{}: {}: measured {:e}, allowed {:e}", kernel.name(), r.law, r.measured, r.bound);
        }
    }
}

#[test]
fn off_the_line_b_plus_2c_the_cubics_bend_straight_lines() {
    assert!((worst(&Cubic::new(0.0, 0.0).unwrap(), 1) - 0.096).abs() < 5e-4);
    assert!(worst(&Cubic::mitchell(), 1) < 1e-13);
}

#[test]
fn a_kernel_is_found_again_by_its_own_name() {
    let families = [
        "cubic:0.3,0.35",
        "gaussian:0.6,2.5",
        "kaiser:15,12",
        "lanczos-5",
        "lanczos-2.5",
        "regularised:12,3.5",
        "sinc-pbrt2:3,2",
    ];
    for name in catalog::names().chain(families) {
        let kernel = by_name(name).unwrap();
        assert_eq!(kernel.name(), name);
        assert_eq!(kernel.at(0.3), by_name(&kernel.name()).unwrap().at(0.3));
    }
    assert_eq!(by_name("cubic:0,0.5").unwrap().name(), "catmull-rom");
}

#[test]
fn an_unknown_or_unreadable_name_is_refused_with_a_sentence() {
    let sentence = |name: &str| by_name(name).err().unwrap().to_string();
    assert!(sentence("michell").starts_with("no kernel is called \"michell\"; known: mitchell, "));
    assert!(sentence("").starts_with("no kernel is called \"\"; known: "));
    assert_eq!(sentence("cubic:1"), "kernel cubic: cannot read \"1\" as two numbers with a comma between");
    assert_eq!(sentence("cubic:a,b"), "kernel cubic: cannot read \"a,b\" as two numbers with a comma between");
    assert_eq!(sentence("kaiser:0,5"), "the radius of a Kaiser kernel must lie between 0.5 and 4096, got 0");
    assert_eq!(sentence("lanczos-nan"), "the lobes of a Lanczos kernel must be finite, got NaN");
}

#[test]
fn kernels_with_impossible_parameters_cannot_be_made() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(Cubic::new(bad, 0.0).is_err() && Cubic::new(0.0, bad).is_err());
        assert!(GaussianKernel::new(bad, 1.0).is_err() && GaussianKernel::new(0.5, bad).is_err());
        assert!(Lanczos::new(bad).is_err() && PbrtSinc::new(bad, 3.0).is_err() && PbrtSinc::new(4.0, bad).is_err());
        assert!(Kaiser::new(bad, 8.0).is_err() && Kaiser::new(4.0, bad).is_err());
        assert!(Regularised::new(bad, 1.0).is_err() && Regularised::new(4.0, bad).is_err());
        assert!(Regularised::for_band(8.0, bad).is_err() && Widened::new(TentKernel, bad).is_err());
    }
    for bad in [0.0, -1.0] {
        assert!(GaussianKernel::new(bad, 1.0).is_err() && GaussianKernel::new(0.5, bad).is_err());
        assert!(GaussianKernel::from_alpha(bad, 1.0).is_err());
        assert!(Lanczos::new(bad).is_err() && PbrtSinc::new(bad, 3.0).is_err() && PbrtSinc::new(4.0, bad).is_err());
        assert!(Kaiser::new(bad, 8.0).is_err() && Regularised::new(bad, 1.0).is_err());
        assert!(Regularised::new(4.0, bad).is_err() && Widened::new(BoxKernel, bad).is_err());
    }
    assert!(Kaiser::new(4.0, -1.0).is_err() && Regularised::for_band(8.0, 1.0).is_err());
}

#[test]
fn a_kernel_has_a_value_and_a_response_everywhere() {
    for kernel in catalog::all() {
        for t in [0.0, 1e-300, 1e-9, 0.5, 1.0, 1e6, 1e300, f64::MAX] {
            assert!(kernel.at(t).is_finite() && kernel.at(-t) == kernel.at(t), "{}({t})", kernel.name());
            assert!(kernel.response(t.min(1e6)).is_finite(), "response of {} at {t}", kernel.name());
        }
        assert_eq!(kernel.at(f64::INFINITY), 0.0, "{}(∞)", kernel.name());
        assert!(kernel.at(f64::NAN).is_nan(), "{}(NaN)", kernel.name());
        assert!(kernel.response(f64::NAN).is_nan(), "response of {} at NaN", kernel.name());
    }
}
