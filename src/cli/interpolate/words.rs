//! What `nyquist interpolate` says: what it did, and why it did not.

use crate::cli::Failure;
use crate::cli::interpolate::{Args, Outside, Record, skipped};
use crate::cli::table::{self, counted, sampling};
use crate::cli::working::note;
use nyquist::door::table::Column;
use nyquist::error::Error;
use nyquist::inspect::table::units;
use nyquist::num::mean::mean;
use nyquist::record::{Interpolated, Interpolator, Kind, Moments, Piece, Wanted, Way, Windowed};
use nyquist::text::{number, plain};
use serde_json::{Value, json};

/// An error about a band, with what the positions allow.
pub(super) fn explained(record: &Record, error: Error) -> Failure {
    let band = matches!(error, Error::OutOfRange { .. } | Error::IllConditioned { .. } | Error::TooFew { .. });
    let sampling = &record.sampling;
    // what the iteration sees of a condition number is never too much
    let error = match error {
        Error::IllConditioned { what, condition, most } => {
            let seen =
                if condition.is_finite() { format!("at least {condition:.3e}") } else { "beyond telling".into() };
            format!("{what}: the condition number is {seen}, above the allowed {most:.3e}")
        }
        other => other.to_string(),
    };
    if !band || sampling.axis().is_some() {
        return Failure::trouble(&record.table.file, error);
    }
    let (gap, position) = sampling.largest_gap();
    let [density, highest] = [sampling.density(), sampling.highest_band()].map(digits);
    let [gap, safe] = [gap, sampling.safe_band()].map(digits);
    let (after, line) = (record.shown(position), record.table.lines[sampling.row(position)]);
    let why = format!(
        "{error}; {density} samples a unit on average support no band above {highest} (Landau), the largest gap, {gap} after \
         {after} (line {line}), every band below {safe} (Gr\u{f6}chenig)"
    );
    Failure::trouble(&record.table.file, why)
}

/// Six digits of a number.
fn digits(value: f64) -> String {
    plain(&number(value, 6))
}

/// A frequency with its unit.
fn frequency(record: &Record, value: f64) -> String {
    let unit = units::frequency(record.clock.unit());
    match unit.strip_prefix("1/") {
        Some(per) => format!("{} per {per}", digits(value)),
        None => format!("{} {unit}", digits(value)).trim_end().to_owned(),
    }
}

/// The error for the first time that is outside.
pub(super) fn refused(
    record: &Record,
    between: &Interpolator,
    moments: &Moments,
    first: usize,
    lines: &[u64],
) -> Failure {
    let time = record.clock.show(moments.at(first));
    let whose = lines.get(first).map_or(String::new(), |line| format!(" (line {line} of the times)"));
    let pieces = between.pieces();
    let ends = |i: usize| [pieces[i].stretch.start, pieces[i].stretch.end - 1].map(|position| record.shown(position));
    let (low, high) = (ends(0)[0].clone(), ends(pieces.len() - 1)[1].clone());
    let since = moments.since(first, record.clock.times[0]);
    let gap = (1..pieces.len()).find(|&i| pieces[i - 1].between[1] < since && since < pieces[i].between[0]);
    let place = match gap {
        Some(i) => format!("lies in the gap between {} and {}", ends(i - 1)[1], ends(i)[0]),
        None => format!("lies outside the record, {low} to {high}"),
    };
    Failure::Trouble(format!("the time {time}{whose} {place}; --outside skip, empty or extend says what then"))
}

/// What was put right, left out or made up.
pub(super) fn tell(record: &Record, between: &Interpolator, outside: usize, what: Outside) {
    table::tell(&record.table, &record.sampling);
    let few: usize = between.left_out().iter().map(|stretch| stretch.len()).sum();
    if few > 0 {
        let few = counted(few, "sample");
        note(&format!("{few} between long gaps, too few to be interpolated, left out"));
    }
    let times = counted(outside, "time");
    match what {
        Outside::Skip if outside > 0 => note(&format!("{times} outside the record or in its gaps left out")),
        Outside::Empty if outside > 0 => note(&format!("{times} outside the record or in its gaps left empty")),
        _ => {}
    }
}

/// How a piece was interpolated, in words.
pub(super) fn way(record: &Record, piece: &Piece) -> String {
    let ends = [piece.stretch.start, piece.stretch.end - 1].map(|position| record.shown(position));
    let n = piece.stretch.len();
    let start = format!("{} to {}, {}: ", ends[0], ends[1], counted(n, "sample"));
    start
        + &match &piece.way {
            Way::Kernel { axis, kernel, edge, band, error } => {
                let name = match kernel {
                    Windowed::Kaiser(_) => "kaiser",
                    Windowed::Regularised(_) => "regularised",
                };
                let radius = kernel.kernel().radius();
                let reach = digits(radius * axis.step());
                let [band, nyquist] = [*band, axis.nyquist()].map(|f| frequency(record, f));
                format!(
                    "{name}, {radius} steps to either side, for a band of {band} (Nyquist frequency {nyquist}); error below \
                     {error:.1e} of the amplitudes in it, but for {reach} from either end, where the edge ({}) counts",
                    edge.name()
                )
            }
            Way::Periodic { .. } => "the trigonometric polynomial of this period, exact if it is one".into(),
            Way::LeastSquares(recoverable) => format!(
                "least squares in a band of {}, condition number at least {}",
                frequency(record, recoverable.band()),
                plain(&number(recoverable.condition(), 3))
            ),
        }
}

/// Parts of the energy beyond the band from which on they are spoken of: amplitudes of a thousandth.
const SPOKEN_OF: f64 = 1e-6;

/// What the values have that was not interpolated: frequencies beyond the band of kernels, distances from what was fitted.
pub(super) fn misfits(record: &Record, columns: &[Interpolated<'_>]) -> Vec<String> {
    let of = |(column, fitted): (&Column, &Interpolated<'_>)| {
        let (name, unit) = (&column.heading.name, &column.heading.unit);
        let beyond = fitted.beyond_band();
        let damped = (beyond > SPOKEN_OF).then(|| {
            let share = digits(100.0 * beyond);
            format!(
                "{name}: {share} % of its energy is beyond the band, where the kernel damps it and errs; a wider --band, \
                 --method periodic or least-squares keep more"
            )
        });
        let fit = fitted.misfit().map(|misfit| {
            let square: f64 = {
                let mean = mean(&column.values);
                column.values.iter().map(|v| (v - mean).powi(2)).sum()
            };
            let rms = (square / column.values.len() as f64).sqrt();
            let share = if rms > 0.0 { 100.0 * misfit / rms } else { 0.0 };
            let much = if share > 10.0 { ": there is more in them than this band, or noise" } else { "" };
            let misfit = format!("{} {unit}", digits(misfit));
            let (misfit, share) = (misfit.trim_end(), digits(share));
            format!("{name}: samples are {misfit} from it in the root mean square, {share} % of theirs{much}")
        });
        [damped, fit]
    };
    record.table.columns.iter().zip(columns).flat_map(of).flatten().collect()
}

pub(super) fn json(
    args: &Args,
    record: &Record,
    between: &Interpolator,
    columns: &[Interpolated<'_>],
    moments: &Moments,
    outside: usize,
) -> Value {
    let piece = |piece: &Piece| {
        let way = match &piece.way {
            Way::Kernel { kernel, edge, band, error, .. } => json!({
                "method": kernel.kernel().name(), "radius": kernel.kernel().radius(), "edge": edge.name(), "band": band,
                "error": error,
            }),
            Way::Periodic { .. } => json!({ "method": "periodic" }),
            Way::LeastSquares(recoverable) => json!({
                "method": "least-squares", "edge": args.edge.unwrap_or(Wanted::default().edge).name(), "band": recoverable.band(),
                "condition": recoverable.condition(),
            }),
        };
        json!({ "from": record.shown(piece.stretch.start), "to": record.shown(piece.stretch.end - 1),
            "samples": piece.stretch.len(), "way": way })
    };
    let names = record.table.columns.iter().map(|column| column.heading.name.as_str());
    let misfits = names.zip(columns).map(
        |(name, fitted)| json!({ "name": name, "misfit_rms": fitted.misfit(), "beyond_band": fitted.beyond_band() }),
    );
    json!({
        "input": record.table.file,
        "output": args.out.display().to_string(),
        "rows": moments.len() - skipped(outside, args.outside),
        "outside": outside,
        "sampling": sampling(&record.table, &record.sampling),
        "uniform": record.sampling.kind() == Kind::Uniform,
        "pieces": between.pieces().iter().map(piece).collect::<Vec<_>>(),
        "columns": misfits.collect::<Vec<_>>(),
    })
}
