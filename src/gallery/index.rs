//! `index.json`: what there is, what it shows, and what was measured.

use crate::figure::params::Kind;
use crate::figure::{Entry, Figure};
use crate::text::{Lang, Text};
use serde_json::{Map, Value, json};

/// A measured or allowed number as it stands in the index: four significant digits, and below 10⁻⁹ the next power of
/// ten above it. Down there is rounding noise, which differs between one mathematics library and the next; the index
/// must not.
///
/// ```
/// use nyquist::gallery::index::settled;
/// assert_eq!(settled(0.0153049), 0.0153);
/// assert_eq!((settled(3.1e-15), settled(7.9e-15), settled(0.0)), (1e-14, 1e-14, 0.0));
/// ```
pub fn settled(value: f64) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    let text = if value.abs() < 1e-9 {
        // nothing measured is better than 10⁻¹⁴: the last bits of numbers around one
        format!("1e{}", value.abs().log10().ceil().max(-14.0))
    } else {
        format!("{value:.3e}")
    };
    text.parse().expect("a number was just printed")
}

/// One figure's entry in the index.
pub fn entry(entry: &Entry, figure: &Figure) -> Value {
    let claims: Vec<Value> = figure
        .claims
        .iter()
        .map(|claim| {
            let r = &claim.residual;
            json!({
                "law": r.law, "says": both(&claim.says),
                "measured": settled(r.measured), "bound": settled(r.bound), "holds": r.holds(),
            })
        })
        .collect();
    let panels: Vec<Value> = figure.panels.iter().map(|p| json!({ "name": p.name, "title": both(&p.title) })).collect();
    let mut value = json!({
        "id": entry.id, "inventory": entry.inventory, "errata": entry.errata,
        "title": both(entry.title), "caption": both(entry.caption),
        "params": entry.params.iter().map(param).collect::<Vec<_>>(),
        "panels": panels, "claims": claims,
    });
    if let (Some(motion), Value::Object(value)) = (&figure.motion, &mut value) {
        value.insert("motion".into(), json!({ "frames": motion.frames.len(), "rate": motion.rate }));
    }
    value
}

/// The whole index: an array in the order of the catalogue.
pub fn json<'a>(figures: impl IntoIterator<Item = (&'a Entry, &'a Figure)>) -> String {
    let entries: Vec<Value> = figures.into_iter().map(|(e, f)| entry(e, f)).collect();
    format!("{:#}\n", Value::Array(entries))
}

fn both(text: &Text) -> Value {
    let pairs = Lang::ALL.map(|lang| (lang.code().to_owned(), json!(text.get(lang))));
    Value::Object(Map::from_iter(pairs))
}

fn param(param: &crate::figure::params::Param) -> Value {
    let mut value = json!({ "name": param.name, "about": both(param.about) });
    let more = match param.kind {
        Kind::Real { default, low, high, unit } => {
            json!({ "kind": "real", "default": default, "low": low, "high": high, "unit": unit })
        }
        Kind::Count { default, low, high } => json!({ "kind": "count", "default": default, "low": low, "high": high }),
        Kind::Choice(of) => json!({ "kind": "choice", "default": of[0], "of": of }),
    };
    if let (Value::Object(value), Value::Object(more)) = (&mut value, more) {
        value.extend(more);
    }
    value
}
