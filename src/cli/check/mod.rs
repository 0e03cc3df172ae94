//! `nyquist check`: is this sampled well enough, and what would alias?

mod picture;
mod sound;
mod table;

use crate::cli::given::Given;
use crate::cli::number::quotient;
use crate::cli::source::Source;
use crate::cli::table::Frequencies;
use crate::cli::{Failure, report};
use nyquist::door::kind::Kind;
use nyquist::figure::report::Report;
use serde_json::Value;
use std::io::Write;
use std::path::PathBuf;

/// Say what band a file occupies, and what would alias, and where to, at another rate or scale.
#[derive(Debug, clap::Args)]
#[command(after_help = after_help())]
pub(super) struct Args {
    /// A WAV, PNG, JPEG or CSV file, told apart by its first bytes; `-` is standard input
    input: PathBuf,
    /// The rate of sounds and tables to sample at, in Hz or per unit of the table's times: 8000, 44.1 or 48000/1.001
    #[arg(short = 'r', long, value_name = "R", help_heading = "Sound and tables", value_parser = quotient, allow_negative_numbers = true)]
    rate: Option<f64>,
    /// The least signal-to-alias ratio in dB: how far below the signal all aliases together must stay
    #[arg(long, value_name = "DB")]
    tolerance: Option<f64>,
    #[command(flatten)]
    report: report::Options,
    #[command(flatten)]
    picture: picture::Options,
    #[command(flatten)]
    table: Frequencies,
}

fn after_help() -> String {
    let exit = "Exit codes: 0 fine, 1 aliases above the tolerance, 2 usage or input/output.";
    [exit, sound::HELP, picture::HELP].join("\n\n")
}

/// What a check found.
struct Checked {
    report: Report,
    json: Value,
    /// Whether all aliases are below the tolerance.
    fine: bool,
}

pub(super) fn run(args: &Args, given: &Given, out: &mut impl Write) -> Result<(), Failure> {
    args.report.checked(&args.input)?;
    let (source, kind) = Source::open_any(&args.input)?;
    given.fit(&source.name, kind)?;
    let checked = match kind {
        Kind::Sound => sound::check(source, args),
        Kind::Picture => picture::check(source, args),
        Kind::Table => table::check(source, args),
    }?;
    args.report.deliver(&checked.report, &checked.json, out)?;
    if checked.fine { Ok(()) } else { Err(Failure::Check) }
}
