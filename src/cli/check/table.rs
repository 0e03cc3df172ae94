//! `nyquist check` of tables.

use crate::cli::Failure;
use crate::cli::check::{Args, Checked};
use crate::cli::source::Source;
use crate::cli::table::{self, sampling};
use crate::cli::working::working;
use nyquist::figure::report::table::report;
use nyquist::inspect::table::{ColumnCheck, Landing, Line, Look, Prediction, TOLERANCE, TableCheck, units};
use serde_json::{Value, json};

pub(super) fn check(source: Source, args: &Args) -> Result<Checked, Failure> {
    let (options, name) = (&args.table, source.name.clone());
    let table = options.table.read(source)?;
    let look = Look { up_to: options.up_to, ..Look::default() };
    let tolerance = args.tolerance.unwrap_or(TOLERANCE);
    let check =
        working("looking into the table", || TableCheck::new(table, options.table.step(), look, args.rate, tolerance));
    let check = check.map_err(|error| Failure::trouble(name, error))?;
    table::tell(&check.table, &check.sampling);
    Ok(Checked { report: report(&check), json: json(&check), fine: check.fine() })
}

/// The findings; frequencies in the unit that is named, phases in radians at the first sample, `null` for what is not
/// resolved or infinite.
fn json(check: &TableCheck) -> Value {
    let predictions = check.predictions();
    let column = |(i, column): (usize, &ColumnCheck)| self::column(column, predictions.get(i), check.tolerance);
    json!({
        "file": check.table.file,
        "kind": "table",
        "time_unit": check.unit(),
        "frequency_unit": units::frequency(check.unit()),
        "sampling": sampling(&check.table, &check.sampling),
        "checked_rate": check.rate,
        "tolerance_db": check.tolerance,
        "fine": check.fine(),
        "columns": check.columns.iter().enumerate().map(column).collect::<Vec<_>>(),
    })
}

fn column(column: &ColumnCheck, prediction: Option<&Prediction<'_>>, tolerance: f64) -> Value {
    let found = &column.found;
    let energy = &found.energy;
    let finite = |value: f64| value.is_finite().then_some(value);
    let prediction = prediction.map(|prediction| {
        let landings = prediction.landings.iter();
        json!({
            "ratio_db": finite(prediction.signal_to_alias()),
            "aliased_energy": prediction.aliased(),
            "of_it_in_no_line": prediction.aliased_rest(),
            "smallest_rate": prediction.rate_for(tolerance),
            "aliases": landings.map(alias).collect::<Vec<_>>(),
        })
    });
    json!({
        "name": column.heading.name,
        "unit": column.heading.unit,
        "looked_at": { "from": found.looked_at.start, "to": found.looked_at.end },
        "mean": found.mean,
        "rms": found.rms,
        "disagreements": column.disagreements,
        "lines": found.lines.iter().map(line).collect::<Vec<_>>(),
        "rest_rms": found.rest,
        "band": { "p99": energy.occupied(0.99), "p999": energy.occupied(0.999), "p9999": energy.occupied(0.9999),
            "resolution": found.spectrum.resolution(), "looked_up_to": found.spectrum.highest() },
        "energy": { "total": energy.total(), "unresolved": energy.unresolved(), "resolved_up_to": finite(energy.band()) },
        "likenesses": found.likenesses.iter().map(|l| json!({ "shift": l.shift, "height": l.height })).collect::<Vec<_>>(),
        "at_rate": prediction,
    })
}

fn line(line: &Line) -> Value {
    json!({ "frequency": line.frequency, "amplitude": line.amplitude, "phase": line.phase, "clearance": line.clearance })
}

fn alias(landing: &Landing) -> Value {
    json!({
        "frequency": landing.line.frequency,
        "lands_at": landing.alias.frequency(),
        "amplitude": landing.line.amplitude,
        "phase": landing.phase(0.0),
        "mirrored": landing.alias.conjugated(),
    })
}
