//! `nyquist spectrum` of tables.

use crate::cli::Failure;
use crate::cli::source::Source;
use crate::cli::spectrum::{Args, Computed};
use crate::cli::table::{self, sampling};
use crate::cli::working::working;
use nyquist::door::table::{Heading, Table};
use nyquist::error::Error;
use nyquist::figure::report::table::spectrum::Spectra;
use nyquist::inspect::table::{LeastSquaresSpectrum, units};
use nyquist::record::Sampling;
use serde_json::{Value, json};

pub(super) fn spectrum(source: Source, args: &Args) -> Result<Computed, Failure> {
    let (options, name) = (&args.table, source.name.clone());
    let table = options.table.read(source)?;
    let unit = table.clock.as_ref().map_or("s", |clock| clock.unit()).to_owned();
    let computed = working("computing the spectrum", || -> Result<_, Error> {
        let taken = Sampling::of_table(&table, options.table.step())?;
        let columns = columns(&table, &taken)?;
        Ok((Spectra::of(&taken, &unit, &columns, args.window, options.up_to)?, taken))
    });
    let (spectra, taken) = computed.map_err(|error| Failure::trouble(&name, error))?;
    table::tell(&table, &taken);
    Ok(Computed {
        portrait: spectra.portrait(&name, args.quantity),
        columns: spectra.names(args.quantity),
        rows: spectra.rows(args.quantity),
        json: json(&table, &taken, &spectra),
    })
}

fn columns(table: &Table, sampling: &Sampling) -> Result<Vec<(Heading, Vec<f64>)>, Error> {
    table.columns.iter().map(|column| Ok((column.heading.clone(), sampling.values(&column.values)?))).collect()
}

/// Amplitudes, phases (radians, at the first sample) and densities, at `resolution`, `2·resolution`, …
fn json(table: &Table, taken: &Sampling, spectra: &Spectra) -> Value {
    let column = |(heading, spectrum): &(Heading, LeastSquaresSpectrum)| {
        json!({
            "name": heading.name,
            "unit": heading.unit,
            "density_unit": units::density(&heading.unit, &spectra.unit),
            "mean": spectrum.mean(),
            "resolution": spectrum.resolution(),
            "amplitude": spectrum.amplitudes().map(|p| p[1]).collect::<Vec<_>>(),
            "phase": spectrum.phases().map(|p| p[1]).collect::<Vec<_>>(),
            "density": spectrum.densities().map(|p| p[1]).collect::<Vec<_>>(),
        })
    };
    json!({
        "file": table.file,
        "kind": "table",
        "frequency_unit": units::frequency(&spectra.unit),
        "window": spectra.window.to_string(),
        "method": if spectra.uniform { "discrete Fourier transform" } else { "least squares (Lomb, Scargle)" },
        "sampling": sampling(table, taken),
        "columns": spectra.columns.iter().map(column).collect::<Vec<_>>(),
    })
}
