//! `nyquist spectrum` of tables.

use crate::cli::Failure;
use crate::cli::source::Source;
use crate::cli::spectrum::{Args, Computed};

/// What can be said of tables alone.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Tables")]
#[group(skip)]
pub(super) struct Options {}

pub(super) fn spectrum(source: Source, _args: &Args) -> Result<Computed, Failure> {
    Err(Failure::trouble(source.name, "the spectrum of tables cannot be computed yet"))
}
