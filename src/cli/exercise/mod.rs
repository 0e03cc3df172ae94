//! `nyquist exercise`: exercises in a folder of one's own, and grading for the teacher.

mod bounded;
mod desk;
mod grade;
mod progress;
mod verdict;
mod workshop;

use crate::cli::Failure;
use bounded::Limits;
use desk::Desk;
use nyquist::text::Lang;
use std::io::Write;
use std::path::PathBuf;

/// Exercises that check themselves.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples, in a new folder:
  nyquist exercise start --lang ru      the first exercise, in Russian
  nyquist exercise check                what was measured, what is allowed
  nyquist exercise hint                 one step further
  nyquist exercise grade submissions    for the teacher: a table of all students")]
pub(super) struct Args {
    #[command(subcommand)]
    command: Command,
    /// The folder of the answers
    #[arg(long, global = true, default_value = ".", value_name = "DIR")]
    dir: PathBuf,
}

/// Which exercise, and in which language.
#[derive(Debug, clap::Args)]
struct Which {
    /// Number (4), name (alias) or file (04_alias.rs); the one that is begun and not solved, if none is given
    exercise: Option<String>,
    /// The language, en or ru; kept for the folder
    #[arg(long)]
    lang: Option<Lang>,
}

#[derive(Debug, clap::Subcommand)]
enum Command {
    /// List the exercises, and which are solved
    List {
        /// The language, en or ru
        #[arg(long)]
        lang: Option<Lang>,
    },
    /// Lay out the file of an exercise: the next one, if none is named
    Start {
        #[command(flatten)]
        which: Which,
        /// Where the crate nyquist is: a folder, or the address of a Git repository. If not given: what the variable
        /// NYQUIST_LIBRARY says, or the folder that this command was built from
        #[arg(long, value_name = "WHERE")]
        library: Option<String>,
    },
    /// Compile and check an answer
    Check {
        #[command(flatten)]
        which: Which,
        #[command(flatten)]
        limits: Limits,
    },
    /// Show the next hint
    Hint {
        #[command(flatten)]
        which: Which,
    },
    /// Show the solution, after a try
    Solution {
        #[command(flatten)]
        which: Which,
        /// Even before a try
        #[arg(long)]
        show: bool,
    },
    /// Check the answers of many students, each in a process with limits
    Grade(grade::Args),
}

pub(super) fn run(args: &Args, out: &mut impl Write) -> Result<(), Failure> {
    let desk = |lang: Option<Lang>| Desk::at(&args.dir, lang);
    match &args.command {
        Command::List { lang } => desk(*lang)?.list(out),
        Command::Start { which, library } => {
            desk(which.lang)?.start(which.exercise.as_deref(), library.as_deref(), out)
        }
        Command::Check { which, limits } => desk(which.lang)?.check(which.exercise.as_deref(), *limits, out),
        Command::Hint { which } => desk(which.lang)?.hint(which.exercise.as_deref(), out),
        Command::Solution { which, show } => desk(which.lang)?.solution(which.exercise.as_deref(), *show, out),
        Command::Grade(args) => grade::run(args, out),
    }
}
