//! `nyquist spectrum` of pictures.

use crate::cli::Failure;
use crate::cli::picture::{Most, open, seen, short};
use crate::cli::source::Source;
use crate::cli::spectrum::{Args, Computed};
use nyquist::door::carried::Light;
use nyquist::door::table::Heading;
use nyquist::figure::report::picture::spectrum::portrait;
use nyquist::image::radial::radial_mean;
use nyquist::inspect::picture::power::{Border, PowerSpectrum};
use serde_json::json;

/// What can be said of pictures alone.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Pictures")]
#[group(skip)]
pub(super) struct Options {
    /// Against the cross of the border: periodic (a smooth picture is taken away: Moisan 2011), a window (hann, hamming,
    /// blackman, blackman-harris), or none
    #[arg(long, default_value = "periodic")]
    border: Border,
    /// All of the plane as numbers, u,v,power, instead of means over rings
    #[arg(long)]
    plane: bool,
    #[command(flatten)]
    most: Most,
}

pub(super) fn spectrum(source: Source, args: &Args) -> Result<Computed, Failure> {
    let Options { border, plane, most } = args.picture;
    let name = source.name.clone();
    let opened = open(source, most, Light::Linear)?;
    let image = seen(&opened);
    let (width, height) = (image.width(), image.height());
    let spectrum = PowerSpectrum::of(&image, border);
    let power = spectrum.power();
    let headings = |names: [&str; 3]| names.map(Heading::read).to_vec();
    let (columns, rows) = if plane {
        let grid = power.grid().iter().zip(power.values());
        let rows = grid.map(|([u, v], p)| vec![u, v, *p]).collect();
        (headings(["u [cycles/px]", "v [cycles/px]", "power [white^2 px^2]"]), rows)
    } else {
        // as many rings as the shorter side has bins from zero to its Nyquist frequency
        let rings = (power.width().min(power.height()) / 2).max(1);
        let rings = radial_mean(power, rings)?;
        let rows = rings.into_iter().map(|ring| vec![ring.frequency, ring.power, ring.bins as f64]).collect();
        (headings(["frequency [cycles/px]", "power [white^2 px^2]", "bins"]), rows)
    };
    let json = json!({
        "file": name, "kind": "picture", "light": "linear", "width": width, "height": height,
        "mean": spectrum.mean(), "deviation": spectrum.deviation(), "blocks": spectrum.blocks(),
        "size": [power.width(), power.height()], "columns": columns.iter().map(Heading::to_string).collect::<Vec<_>>(), "rows": rows,
    });
    Ok(Computed { portrait: portrait(short(&name), &spectrum), columns, rows, json })
}
