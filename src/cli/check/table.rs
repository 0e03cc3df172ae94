//! `nyquist check` of tables.

use crate::cli::Failure;
use crate::cli::check::{Args, Checked};
use crate::cli::source::Source;

/// What can be said of tables alone.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Tables")]
#[group(skip)]
pub(super) struct Options {}

pub(super) fn check(source: Source, _args: &Args) -> Result<Checked, Failure> {
    Err(Failure::trouble(source.name, "tables cannot be checked yet"))
}
