//! What figures claim holds for every value of their parameters, not only for the defaults: tried at both ends of every
//! range, at every choice, and at a value inside.

use nyquist::figure::catalog;
use nyquist::figure::params::{Kind, Param, Params};

/// The values at which a parameter is tried.
fn values(param: &Param) -> Vec<String> {
    match param.kind {
        Kind::Real { low, high, .. } => [low, high, 0.63 * low + 0.37 * high].map(|v| v.to_string()).into(),
        Kind::Count { low, high, .. } => [low, high, (2 * low + high) / 3].map(|v| v.to_string()).into(),
        Kind::Choice(of) => of.iter().map(|v| (*v).to_owned()).collect(),
    }
}

fn tried(ids: &[&str]) {
    for entry in catalog::all().into_iter().filter(|e| ids.iter().any(|id| e.id.starts_with(id))) {
        for param in entry.params {
            for value in values(param) {
                let set = Params::with(entry.params, [(param.name, value.as_str())]).expect("within the range");
                let figure = (entry.build)(&set).unwrap_or_else(|e| panic!("{} {}={value}: {e}", entry.id, param.name));
                for claim in &figure.claims {
                    let r = &claim.residual;
                    assert!(
                        r.holds(),
                        "{} with {} = {value}: {}: measured {:e}, allowed {:e}",
                        entry.id,
                        param.name,
                        r.law,
                        r.measured,
                        r.bound
                    );
                }
            }
        }
    }
}

#[test]
fn of_stochastic_and_adaptive_sampling() {
    tried(&["f37", "f38", "f39", "f41"]);
}

#[test]
fn of_sample_patterns() {
    tried(&["f49", "f52", "f54"]);
}

#[test]
fn of_edges_and_filters() {
    tried(&["f48", "f55", "f57"]);
}

#[test]
fn of_the_checkerboard_and_the_film() {
    tried(&["f35", "f36", "f40", "f42", "f50", "f51", "f56", "f58"]);
}

#[test]
fn of_what_goes_beyond_the_lecture() {
    tried(&["x-"]);
}

/// Every combination of the values, for figures whose parameters act on one another.
fn tried_together(ids: &[&str]) {
    for entry in catalog::all().into_iter().filter(|e| ids.iter().any(|id| e.id.starts_with(id))) {
        let mut settings = vec![Vec::new()];
        for param in entry.params {
            let with = |set: &Vec<(&'static str, String)>, value| [&set[..], &[(param.name, value)]].concat();
            settings = settings.iter().flat_map(|set| values(param).into_iter().map(|v| with(set, v))).collect();
        }
        for setting in settings {
            let set = setting.iter().map(|(name, value)| (*name, value.as_str()));
            let params = Params::with(entry.params, set).expect("within the ranges");
            let figure = (entry.build)(&params).unwrap_or_else(|e| panic!("{} {setting:?}: {e}", entry.id));
            for claim in &figure.claims {
                let r = &claim.residual;
                let (id, law) = (entry.id, &r.law);
                assert!(r.holds(), "{id} {setting:?}: {law}: measured {:e}, allowed {:e}", r.measured, r.bound);
            }
        }
    }
}

#[test]
fn of_the_formal_part() {
    tried(&["f06", "f09", "f10", "f11", "f12", "f13", "f14", "f17", "f18", "f19", "f20", "f21"]);
}

#[test]
fn of_the_problem() {
    tried_together(&["f01", "f02", "f03", "f04", "f05", "f07", "f08"]);
}

#[test]
fn of_reconstruction() {
    tried_together(&["f15", "f16", "f23", "f24", "f25", "f26"]);
}

#[test]
fn of_aliasing_and_its_remedies() {
    tried_together(&["f27", "f28", "f29", "f30", "f31", "f32", "f33"]);
}

#[test]
fn of_lens_and_shutter() {
    tried(&["f47", "f53"]);
}

#[test]
fn of_pictures_and_their_spectra() {
    tried(&["f43", "f44", "f45", "f46", "f59"]);
}
