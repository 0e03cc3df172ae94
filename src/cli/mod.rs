//! The command line: one subcommand a file, each from arguments to a library call to text.

mod check;
mod exercise;
mod figures;
mod files;
mod given;
mod interpolate;
mod kernel;
mod laws;
mod number;
mod picture;
mod points;
mod render;
mod report;
mod resample;
mod resize;
mod skipped;
mod sound;
mod source;
mod spectrum;
mod table;
mod unfinished;
mod working;

use crate::cli::given::Given;
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use std::fmt::Display;
use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;

/// Sampling and reconstruction: the lecture's figures, computed, and the theorems behind them, checked.
///
/// Without a subcommand it does the main job: it computes every figure, checks what each claims, and writes SVG, PNG
/// and PDF in both languages into the folder `figures`.
#[derive(Debug, Parser)]
#[command(version, args_conflicts_with_subcommands = true, after_help = AFTER)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    figures: figures::Args,
}

const AFTER: &str = "Exit codes: 0 done, 1 a check failed, 2 usage or input/output.

Examples:
  nyquist                                  every figure, into figures/
  nyquist f28-leak --set T=0.9             one figure with another step
  nyquist laws                             every theorem, measured against its bound
  nyquist render spheres -o spheres.png    a scene, sampled in five dimensions";

#[derive(Debug, Subcommand)]
enum Command {
    /// Compute figures, check their claims, write them as SVG, PNG and PDF
    Figures(figures::Args),
    /// Check the theorems: what was measured beside what theory allows
    Laws(laws::Args),
    /// List the reconstruction kernels, or tabulate one and its response
    Kernel(kernel::Args),
    /// Write the points of a sample pattern, and draw their spectrum
    Points(points::Args),
    /// Render a scene through lens and shutter into a PNG
    Render(render::Args),
    /// Say what band a file occupies, and what would alias at another rate or scale
    Check(check::Args),
    /// Compute the spectrum of a file: as a picture or as numbers
    Spectrum(spectrum::Args),
    /// Compute band-limited values between the samples of a table
    Interpolate(interpolate::Args),
    /// Convert a WAV file to another sampling rate
    Resample(resample::Args),
    /// Resize a picture, in linear light
    Resize(resize::Args),
    /// Exercises that check themselves, and grading for the teacher
    Exercise(exercise::Args),
}

/// Why the exit code is not zero.
#[derive(Debug)]
enum Failure {
    /// A check failed: exit code 1. What failed has been printed.
    Check,
    /// Usage, input or output: exit code 2.
    Trouble(String),
    /// The reader of a pipe has gone: nobody left to tell, and nothing wrong.
    ClosedPipe,
}

impl From<nyquist::error::Error> for Failure {
    fn from(error: nyquist::error::Error) -> Self {
        Self::Trouble(error.to_string())
    }
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        if error.kind() == ErrorKind::BrokenPipe { Self::ClosedPipe } else { Self::Trouble(error.to_string()) }
    }
}

impl Failure {
    fn trouble(what: impl Display, error: impl Display) -> Self {
        Self::Trouble(format!("{what}: {error}"))
    }
}

/// Parses the arguments, runs the command, and says what went wrong.
pub(crate) fn run() -> ExitCode {
    let command = Cli::command();
    let matches = command.clone().get_matches();
    let cli = Cli::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
    let given = matches.subcommand().and_then(|(name, matches)| {
        let command = command.find_subcommand(name)?;
        Some(Given::of(command, matches))
    });
    let given = given.unwrap_or_default();
    unfinished::removed_on_interruption();
    let mut out = io::stdout().lock();
    let done = match cli.command {
        None => figures::run(&cli.figures, &mut out),
        Some(Command::Figures(args)) => figures::run(&args, &mut out),
        Some(Command::Laws(args)) => laws::run(&args, &mut out),
        Some(Command::Kernel(args)) => kernel::run(&args, &mut out),
        Some(Command::Points(args)) => points::run(&args, &mut out),
        Some(Command::Render(args)) => render::run(&args, &mut out),
        Some(Command::Check(args)) => check::run(&args, &given, &mut out),
        Some(Command::Spectrum(args)) => spectrum::run(&args, &given, &mut out),
        Some(Command::Interpolate(args)) => interpolate::run(&args, &mut out),
        Some(Command::Resample(args)) => resample::run(&args, &mut out),
        Some(Command::Resize(args)) => resize::run(&args, &mut out),
        Some(Command::Exercise(args)) => exercise::run(&args, &mut out),
    };
    match done.and_then(|()| Ok(out.flush()?)) {
        Ok(()) | Err(Failure::ClosedPipe) => ExitCode::SUCCESS,
        Err(Failure::Check) => ExitCode::from(1),
        Err(Failure::Trouble(message)) => {
            // if standard error is gone as well, the exit code says it all
            let _ = writeln!(io::stderr(), "error: {message}");
            ExitCode::from(2)
        }
    }
}
