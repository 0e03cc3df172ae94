//! `nyquist check` of pictures.

use crate::cli::Failure;
use crate::cli::check::{Args, Checked};
use crate::cli::source::Source;

/// What can be said of pictures alone.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Pictures")]
#[group(skip)]
pub(super) struct Options {}

pub(super) fn check(source: Source, _args: &Args) -> Result<Checked, Failure> {
    Err(Failure::trouble(source.name, "pictures cannot be checked yet"))
}
