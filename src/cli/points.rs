//! `nyquist points`: sample patterns as numbers.

use crate::cli::Failure;
use crate::cli::files::{self, Prepared};
use nyquist::figure::patterns::portrait::portrait;
use nyquist::pattern::cloud::{Cloud, Dimensions, MOST_DIMENSIONS, known};
use nyquist::pattern::measure::summary::Summary;
use nyquist::plot::{Format, Style, draw};
use nyquist::text::Lang;
use serde_json::{Value, json};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Write the points of a sample pattern as CSV, and draw their spectrum.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  nyquist points jittered -n 256 -o jittered.csv --spectrum jittered.svg
  nyquist points halton -n 1000 --dim 5 > halton.csv
  nyquist points poisson-disk -n 1000 --json
  nyquist points --list")]
pub(super) struct Args {
    /// The pattern: one of those that --list shows
    #[arg(required_unless_present = "list")]
    pattern: Option<String>,
    /// How many points; a pattern that cannot have so many says which numbers it can
    #[arg(short = 'n', long = "count", value_name = "N", required_unless_present = "list")]
    count: Option<usize>,
    /// How many coordinates a point has
    #[arg(long, value_name = "D", default_value_t = 2)]
    dim: usize,
    /// The seed of the random numbers: equal seeds give equal points
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// The file to write the points into, as CSV; `-`, or nothing, is standard output
    #[arg(short = 'o', long = "out", value_name = "OUT.csv")]
    out: Option<PathBuf>,
    /// Also draw points, power spectrum, radial mean and anisotropy into this file: .svg, .png or .pdf (--dim 2)
    #[arg(long, value_name = "FILE")]
    spectrum: Option<PathBuf>,
    /// The language of the picture: en or ru
    #[arg(long, default_value = "en")]
    lang: Lang,
    /// Replace files that exist
    #[arg(long)]
    force: bool,
    /// Print the measures as JSON; the points then go only where -o says
    #[arg(long)]
    json: bool,
    /// List the patterns and the dimensions that they come in
    #[arg(long, conflicts_with_all = ["count", "out", "spectrum"])]
    list: bool,
}

pub(super) fn run(args: &Args, out: &mut impl Write) -> Result<(), Failure> {
    let (Some(name), Some(count), false) = (&args.pattern, args.count, args.list) else {
        return list(args.json, out);
    };
    let to_file = args.out.as_deref().filter(|path| *path != Path::new("-"));
    let to_output = if args.json { args.out.is_some() && to_file.is_none() } else { to_file.is_none() };
    if args.json && to_output {
        return Err(Failure::Trouble("-o - and --json would mix points and measures on standard output".into()));
    }
    if let (Some(spectrum), Some(out)) = (&args.spectrum, &args.out)
        && files::same(spectrum, out)
    {
        return Err(Failure::Trouble("-o and --spectrum name the same file".into()));
    }
    for path in [to_file, args.spectrum.as_deref()].into_iter().flatten() {
        files::vacant(path, args.force)?;
    }
    let format = args.spectrum.as_deref().map(format_of).transpose()?;
    let cloud = Cloud::new(name, args.dim, count, args.seed)?;
    if cloud.len() != count {
        // if standard error is closed there is nobody to tell
        let _ = writeln!(io::stderr(), "{name} gives {} points with this seed, not {count}", cloud.len());
    }
    let summary = if args.json || format.is_some() { Some(Summary::of(&cloud)?) } else { None };
    // both are written before either is put in its place
    let mut files = Vec::new();
    if let (Some(path), Some(format), Some(summary)) = (&args.spectrum, format, &summary) {
        let drawn = portrait(name, &cloud, summary)?;
        let style = Style { lang: args.lang, ..Style::default() };
        let scene = draw(&drawn.title, &drawn.caption, &drawn.figure, &style);
        files.push(Prepared::new(path, |file| file.write_all(&scene.write(format)))?);
    }
    if let Some(path) = to_file {
        files.push(Prepared::new(path, |file| csv(&cloud, file))?);
    }
    files.into_iter().try_for_each(Prepared::place)?;
    if to_output {
        csv(&cloud, &mut io::BufWriter::new(&mut *out))?;
    }
    match summary {
        Some(summary) if args.json => Ok(writeln!(out, "{:#}", report(name, args, &summary))?),
        _ => Ok(()),
    }
}

/// The format that the name of a file ends with.
fn format_of(path: &Path) -> Result<Format, Failure> {
    let extension = path.extension().map(|e| e.to_string_lossy().into_owned()).unwrap_or_default();
    Ok(extension.parse()?)
}

/// What the coordinates are called.
fn names(dimensions: usize) -> Vec<String> {
    match dimensions {
        1..=3 => ["x", "y", "z"][..dimensions].iter().map(|&name| name.into()).collect(),
        _ => (1..=dimensions).map(|d| format!("x{d}")).collect(),
    }
}

/// A line for each point; every number is the shortest that reads back as the same.
fn csv(cloud: &Cloud, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "{}", names(cloud.dimensions()).join(","))?;
    for point in cloud.iter() {
        for (d, coordinate) in point.iter().enumerate() {
            write!(out, "{}{coordinate}", if d == 0 { "" } else { "," })?;
        }
        writeln!(out)?;
    }
    out.flush()
}

fn report(name: &str, args: &Args, summary: &Summary) -> Value {
    let spectrum = summary.spectrum.as_ref().map(|spectrum| {
        let ring = |r: &nyquist::pattern::measure::radial::Ring| {
            json!({ "frequency": r.frequency, "power": r.power, "anisotropy": r.anisotropy, "bins": r.bins })
        };
        let rings: Vec<Value> = spectrum.rings.iter().map(ring).collect();
        json!({ "reach": spectrum.periodogram.reach(), "mean": spectrum.mean(), "rings": rings })
    });
    json!({
        "pattern": name,
        "points": summary.points,
        "dimensions": args.dim,
        "seed": args.seed,
        "star_discrepancy": summary.star_discrepancy,
        "least_distance": summary.least_distance,
        "least_distance_torus": summary.least_distance_torus,
        "spectrum": spectrum,
    })
}

fn list(as_json: bool, out: &mut impl Write) -> Result<(), Failure> {
    let known = known();
    if as_json {
        let entry = |k: &nyquist::pattern::cloud::Known| {
            let (least, most) = match k.dimensions {
                Dimensions::Any => (1, MOST_DIMENSIONS),
                Dimensions::Only(d) => (d, d),
            };
            json!({ "name": k.name, "dimensions": { "least": least, "most": most } })
        };
        return Ok(writeln!(out, "{:#}", Value::Array(known.iter().map(entry).collect()))?);
    }
    for k in known {
        let dimensions = match k.dimensions {
            Dimensions::Any => format!("1 to {MOST_DIMENSIONS} dimensions"),
            Dimensions::Only(d) => format!("{d} dimensions"),
        };
        writeln!(out, "{:<28} {dimensions}", k.name)?;
    }
    writeln!(out, "{:<28} 2 dimensions", nyquist::pattern::catalog::FAMILIES.join(", "))?;
    Ok(())
}
