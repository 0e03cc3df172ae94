//! `nyquist laws`: every theorem, measured against its bound.

use crate::cli::Failure;
use nyquist::laws::{Law, catalog};
use nyquist::text::Lang;
use serde_json::{Value, json};
use std::io::Write;

/// Check the theorems: what was measured beside what theory allows.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:
  nyquist laws alias-energy V02 --json")]
pub(super) struct Args {
    /// Laws by name (alias-energy) or by the result they state (V07); all if none is given
    names: Vec<String>,
    /// Print JSON instead of a table
    #[arg(long)]
    json: bool,
    /// The language of the statements
    #[arg(long, default_value = "en")]
    lang: Lang,
}

pub(super) fn run(args: &Args, out: &mut impl Write) -> Result<(), Failure> {
    let laws: Vec<&Law> = if args.names.is_empty() {
        catalog::all().collect()
    } else {
        args.names.iter().map(|name| catalog::matching(name)).collect::<Result<Vec<_>, _>>()?.concat()
    };
    let mut held = true;
    let mut report = Vec::new();
    for law in laws {
        let residuals = (law.holds)();
        held &= residuals.iter().all(|r| r.holds());
        if args.json {
            let checks: Vec<Value> = residuals
                .iter()
                .map(|r| json!({ "law": r.law, "measured": r.measured, "bound": r.bound, "holds": r.holds() }))
                .collect();
            let says = json!({ "en": law.says.get(Lang::En), "ru": law.says.get(Lang::Ru) });
            report.push(json!({ "name": law.name, "inventory": law.inventory, "says": says, "checks": checks }));
            continue;
        }
        writeln!(out, "{} ({}): {}", law.name, law.inventory.join(", "), law.says.get(args.lang))?;
        for r in &residuals {
            let mark = if r.holds() { '✓' } else { '✗' };
            writeln!(out, "  {mark}  measured {:9.2e} · allowed {:9.2e}   {}", r.measured, r.bound, r.law)?;
        }
    }
    if args.json {
        writeln!(out, "{:#}", Value::Array(report))?;
    }
    if held { Ok(()) } else { Err(Failure::Check) }
}
