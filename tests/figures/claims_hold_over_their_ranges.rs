//! What a figure claims it claims for every value of its parameters: the ends of the ranges, and what lies between.

use nyquist::figure::Entry;
use nyquist::figure::catalog;
use nyquist::figure::params::{Kind, Param, Params};

/// The values that a parameter is tried at: both ends, the default, and one that is no round number.
fn tried(param: &Param) -> Vec<String> {
    match param.kind {
        Kind::Real { default, low, high, .. } => {
            [low, default, 0.618 * low + 0.382 * high, high].map(|v| v.to_string()).into()
        }
        Kind::Count { default, low, high } => [low, default, high].map(|v| v.to_string()).into(),
        Kind::Choice(of) => of.iter().map(|&name| name.to_owned()).collect(),
    }
}

/// Every combination of the tried values.
fn settings(entry: &Entry) -> Vec<Vec<(&'static str, String)>> {
    entry.params.iter().fold(vec![Vec::new()], |settings, param| {
        let with = |set: &Vec<(&'static str, String)>, value: String| [&set[..], &[(param.name, value)]].concat();
        settings.iter().flat_map(|set| tried(param).into_iter().map(move |value| with(set, value))).collect()
    })
}

#[test]
fn every_claim_holds_for_every_value_of_the_parameters() {
    let mut broken = Vec::new();
    for entry in catalog::all() {
        for setting in settings(entry) {
            let set = setting.iter().map(|(name, value)| (*name, value.as_str()));
            let params = Params::with(entry.params, set).expect("the values are within the ranges");
            let figure = (entry.build)(&params).unwrap_or_else(|e| panic!("{} {setting:?}: {e}", entry.id));
            for claim in &figure.claims {
                let r = &claim.residual;
                if !r.holds() {
                    broken.push(format!("{} {setting:?}: {}: {:e} > {:e}", entry.id, r.law, r.measured, r.bound));
                }
            }
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}
