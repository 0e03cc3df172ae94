//! `nyquist interpolate`: band-limited values of a table at other times.

mod words;

use crate::cli::source::Source;
use crate::cli::table;
use crate::cli::working::{note, progress, working};
use crate::cli::{Failure, files};
use clap::ArgGroup;
use nyquist::axis::Edge;
use nyquist::door::table::{Clock, Decimal, Heading, Table, TableWriter};
use nyquist::error::Error;
use nyquist::record::{Interpolated, Interpolator, Method, Moments, Sampling, Wanted};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// Compute band-limited values between the samples of a table.
#[derive(Debug, clap::Args)]
#[command(after_help = AFTER, group(ArgGroup::new("when").required(true).args(["at", "every"])))]
pub(super) struct Args {
    /// The table: times in the first column, values in the others; `-` is standard input
    input: PathBuf,
    /// A table whose times (its first column) are the ones wanted
    #[arg(long, value_name = "TIMES.csv")]
    at: Option<PathBuf>,
    /// Every DT from the first time to the last, in the unit of the times; of dates in seconds
    #[arg(long, value_name = "DT", value_parser = decimal, allow_negative_numbers = true)]
    every: Option<Decimal>,
    /// The table to write, in the dialect of the input; `-` is standard output
    #[arg(short = 'o', long = "out", value_name = "OUT.csv")]
    out: PathBuf,
    /// kaiser, regularised, periodic or least-squares (below) [default: kaiser where samples are equally spaced, elsewhere
    /// least-squares]
    #[arg(long)]
    method: Option<Method>,
    /// How the record goes on beyond its ends: mirror, wrap, and for kernels zero and clamp
    /// [default: mirror]
    #[arg(long)]
    edge: Option<Edge>,
    /// The band of the signal [default: 0.8 of the Nyquist frequency; for least squares up to 0.9 of what the density
    /// supports, as far as that is well conditioned]
    #[arg(long, value_name = "B", allow_negative_numbers = true)]
    band: Option<f64>,
    /// The largest condition number of least squares that is accepted: noise may grow so many times
    /// [default: 10000]
    #[arg(long, value_name = "K", value_parser = condition)]
    most_condition: Option<f64>,
    /// Times outside the record, or in a gap that parts it: error, skip (no row), empty (cells) or extend (as the edge says)
    #[arg(long, value_name = "WHAT", default_value = "error")]
    outside: Outside,
    /// Replace the output if it exists
    #[arg(long)]
    force: bool,
    /// Print what was done as JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    table: table::Options,
}

const AFTER: &str = "Methods:
  kaiser         a sinc under Kaiser's window; the error that is printed holds for tones up
                 to --band, farther from the ends than the kernel is wide
  regularised    a sinc under a Gaussian: twice as wide for the same error, which is proven
  periodic       the trigonometric polynomial through the samples: exact for signals whose
                 period the record is
  least-squares  the nearest signal of the band, for samples at any times, with its
                 condition number

Long gaps (four samples, or 20 median steps where there is no step) part a record; its
pieces are interpolated each on its own.

Examples:
  nyquist interpolate log.csv --every 0.01 -o even.csv
  nyquist interpolate log.csv --at times.csv --outside skip -o values.csv
  nyquist interpolate export.csv --decimal-comma --every 0,5 -o - > even.csv
  nyquist interpolate period.csv --method periodic --edge wrap --every 1e-4 -o fine.csv";

/// What becomes of times outside the record.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outside {
    Error,
    Skip,
    Empty,
    Extend,
}

impl FromStr for Outside {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        match name {
            "error" => Ok(Self::Error),
            "skip" => Ok(Self::Skip),
            "empty" => Ok(Self::Empty),
            "extend" => Ok(Self::Extend),
            _ => Err("known: error, skip, empty, extend".into()),
        }
    }
}

/// A number with all its decimals; its decimal point may be a comma.
fn decimal(text: &str) -> Result<Decimal, String> {
    text.replacen(',', ".", 1).parse().map_err(|_| format!("\"{text}\" is no number of up to 36 digits"))
}

/// A condition number: one or more.
fn condition(text: &str) -> Result<f64, String> {
    let value = text.parse().ok().filter(|value: &f64| *value >= 1.0);
    value.ok_or_else(|| format!("\"{text}\" is no number from one on"))
}

impl Args {
    /// What is wanted, if every option has an effect on it.
    fn wanted(&self, sampling: &Sampling) -> Result<Wanted, Failure> {
        let even = sampling.axis().is_some();
        let method = self.method.unwrap_or(if even { Method::Kaiser } else { Method::LeastSquares });
        let refused = |option: &str, why: &str| {
            Err(Failure::Trouble(format!("{option} has no effect on the method {}, {why}", method.name())))
        };
        match method {
            Method::Periodic if self.edge.is_some_and(|edge| edge != Edge::Wrap) => {
                return refused("--edge", "which continues the record as a period (wrap)");
            }
            Method::Periodic if self.band.is_some() => return refused("--band", "which passes through all samples"),
            Method::LeastSquares => {}
            _ if self.most_condition.is_some() => {
                return refused("--most-condition", "which solves no equations; it is for least-squares");
            }
            _ => {}
        }
        let usual = Wanted::default();
        Ok(Wanted {
            method: self.method,
            edge: self.edge.unwrap_or(usual.edge),
            band: self.band,
            most_condition: self.most_condition.unwrap_or(usual.most_condition),
        })
    }
}

/// A table, how it was sampled, and the times in it.
struct Record {
    table: Table,
    sampling: Sampling,
    clock: Clock,
}

pub(super) fn run(args: &Args, out: &mut impl Write) -> Result<(), Failure> {
    let piped = args.out == Path::new("-");
    if piped && args.json {
        return Err(Failure::Trouble(
            "the output - and --json would mix values and findings on standard output".into(),
        ));
    }
    if !piped {
        for input in [Some(&args.input), args.at.as_ref()].into_iter().flatten() {
            files::distinct(input, &args.out)?;
        }
        files::vacant(&args.out, args.force)?;
    }
    if args.at.as_deref() == Some(Path::new("-")) && args.input == Path::new("-") {
        return Err(Failure::Trouble("the table and the times cannot both be standard input".into()));
    }
    let record = record(args)?;
    let wanted = args.wanted(&record.sampling)?;
    let (moments, lines) = moments(args, &record)?;
    let failed = |error: Error| words::explained(&record, error);
    let between = working("preparing", || Interpolator::new(&record.sampling, wanted)).map_err(failed)?;
    let columns = working("solving", || -> Result<Vec<Interpolated<'_>>, Error> {
        let of = |values: &[f64]| between.of(&record.sampling, &record.sampling.values(values)?);
        record.table.columns.iter().map(|column| of(&column.values)).collect()
    });
    let columns = columns.map_err(failed)?;
    let origin = record.clock.times[0];
    let beyond = |i: &usize| !between.covers(moments.since(*i, origin));
    let outside = if args.outside == Outside::Extend { 0 } else { (0..moments.len()).filter(beyond).count() };
    if outside > 0 && args.outside == Outside::Error {
        let first = (0..moments.len()).find(beyond).unwrap_or(0);
        return Err(words::refused(&record, &between, &moments, first, &lines));
    }
    let fill = |sink: &mut dyn Write| write(&record, &between, &columns, &moments, args.outside, sink);
    if piped {
        fill(&mut *out)?;
    } else {
        files::write_with(&args.out, fill)?;
    }
    words::tell(&record, &between, outside, args.outside);
    if args.json {
        return Ok(writeln!(out, "{:#}", words::json(args, &record, &between, &columns, &moments, outside))?);
    }
    let rows = table::counted(moments.len() - skipped(outside, args.outside), "row");
    let mut said = vec![format!("{}: {rows}", args.out.display())];
    said.extend(between.pieces().iter().take(MOST_SAID).map(|piece| words::way(&record, piece)));
    if between.pieces().len() > MOST_SAID {
        said.push(format!("and {} more", table::counted(between.pieces().len() - MOST_SAID, "piece")));
    }
    said.extend(words::misfits(&record, &columns));
    if piped {
        said[1..].iter().for_each(|words| note(words));
        return Ok(());
    }
    Ok(writeln!(out, "{}", said.join("\n  "))?)
}

/// Pieces of a record that are described one by one.
const MOST_SAID: usize = 8;

fn skipped(outside: usize, what: Outside) -> usize {
    if what == Outside::Skip { outside } else { 0 }
}

fn record(args: &Args) -> Result<Record, Failure> {
    let source = Source::open(&args.input)?;
    let table = args.table.read(source)?;
    let failed = |error| Failure::trouble(&table.file, error);
    let sampling = Sampling::of_table(&table, args.table.step()).map_err(failed)?;
    let clock = match (&table.clock, args.table.step()) {
        (Some(clock), _) => clock.clone(),
        (None, step) => {
            let step = Decimal::of(step.unwrap_or(1.0));
            let time = |i: u64| step.and_then(|step| step.times(i));
            let times: Option<Vec<Decimal>> = (0..table.rows() as u64).map(time).collect();
            let times = times.ok_or_else(|| Failure::Trouble("--dt has too many digits".into()))?;
            Clock { heading: Heading::read("t [s]"), calendar: None, times }
        }
    };
    Ok(Record { table, sampling, clock })
}

impl Record {
    /// The time of a position, as the table writes it.
    fn shown(&self, position: usize) -> String {
        self.clock.show(self.clock.times[self.sampling.row(position)])
    }
}

/// The times asked for, and on which lines of their file they stand.
fn moments(args: &Args, record: &Record) -> Result<(Moments, Vec<u64>), Failure> {
    let path = match (args.every, &args.at) {
        (Some(step), _) => return Ok((Moments::every(step, &record.clock)?, Vec::new())),
        (None, Some(path)) => path,
        (None, None) => return Err(Failure::Trouble("neither --at nor --every says when".into())),
    };
    let table = args.table.read_times(Source::open(path)?)?;
    let Some(clock) = table.clock else { return Err(Failure::trouble(table.file, "there are no times in it")) };
    if clock.calendar.is_some() != record.clock.calendar.is_some() {
        let why = "dates and numbers: the times asked for and those of the table must both be the one or the other";
        return Err(Failure::trouble(table.file, why));
    }
    Ok((Moments::of(&clock), table.lines))
}

/// Rows in the dialect of the input, with progress on a terminal.
fn write(
    record: &Record,
    between: &Interpolator,
    columns: &[Interpolated<'_>],
    moments: &Moments,
    outside: Outside,
    sink: &mut dyn Write,
) -> io::Result<()> {
    const CHUNK: usize = 1 << 16;
    let progress = progress(Some(moments.len() as u64), "rows");
    let mut writer = TableWriter::new(record.table.dialect);
    if record.table.headed {
        let values = record.table.columns.iter().map(|column| column.heading.clone());
        writer.header(&std::iter::once(record.clock.heading.clone()).chain(values).collect::<Vec<_>>());
    }
    let origin = record.clock.times[0];
    for start in (0..moments.len()).step_by(CHUNK) {
        let chunk = start..(start + CHUNK).min(moments.len());
        let places: Vec<f64> = chunk.clone().map(|i| moments.since(i, origin)).collect();
        let values: Vec<Vec<f64>> = columns.iter().map(|column| column.at_all(&places)).collect();
        for (row, (i, place)) in chunk.zip(&places).enumerate() {
            let covered = outside == Outside::Extend || between.covers(*place);
            if !covered && outside == Outside::Skip {
                continue;
            }
            let cells = values.iter().map(|column| if covered { column[row] } else { f64::NAN });
            writer.row(Some(&record.clock.show(moments.at(i))), &cells.collect::<Vec<_>>());
        }
        sink.write_all(writer.take().as_bytes())?;
        progress.set_position((start + places.len()) as u64);
    }
    progress.finish_and_clear();
    sink.write_all(writer.take().as_bytes())
}
