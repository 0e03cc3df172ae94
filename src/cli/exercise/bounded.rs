//! Programs of others: run with limits of time and memory.

use crate::cli::Failure;
use std::io::Read;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::{Arc, Mutex};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// What a program may use.
#[derive(Debug, Clone, Copy, clap::Args)]
pub(super) struct Limits {
    /// How long an answer may take
    #[arg(long, default_value_t = 10, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=3600))]
    seconds: u64,
    /// How much memory it may use, in megabytes (where the system has a shell with `ulimit -v`)
    #[arg(long, default_value_t = 1024, value_name = "MB", value_parser = clap::value_parser!(u64).range(64..=1_048_576))]
    memory: u64,
}

/// How a program ended.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum End {
    /// By itself, whatever its exit code.
    Ended,
    /// It was stopped when its time was over.
    Slow(u64),
    /// It asked for more memory than it may use.
    Greedy(u64),
    /// It called itself until its stack was full.
    Deep,
    /// It panicked, with these words.
    Panicked(String),
    /// Something else ended it.
    Killed(String),
}

/// What a program printed and how it ended.
#[derive(Debug)]
pub(super) struct Run {
    pub(super) end: End,
    pub(super) printed: String,
}

/// Runs a program with one argument.
pub(super) fn run(program: &Path, argument: &Path, limits: Limits) -> Result<Run, Failure> {
    let mut command = limited(program, limits);
    command.env("RUST_BACKTRACE", "0").arg(argument).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let cannot = |error| Failure::trouble(format!("{} cannot be run", program.display()), error);
    let mut child = command.spawn().map_err(cannot)?;
    let (out, err) = (Kept::of(child.stdout.take()), Kept::of(child.stderr.take()));
    let deadline = Instant::now() + Duration::from_secs(limits.seconds);
    let status = loop {
        if let Some(status) = child.try_wait().map_err(cannot)? {
            break Some(status);
        }
        if Instant::now() >= deadline {
            // it may have ended just now; then there is nothing to stop
            let _ = child.kill();
            child.wait().map_err(cannot)?;
            break None;
        }
        thread::sleep(Duration::from_millis(5));
    };
    let (printed, said) = (out.words(), err.words());
    let panic = said.find("thread '").filter(|_| said.contains("panicked at "));
    let end = match status {
        None => End::Slow(limits.seconds),
        Some(_) if said.contains("memory allocation of ") || said.contains("capacity overflow") => {
            End::Greedy(limits.memory)
        }
        Some(_) if said.contains("has overflowed its stack") => End::Deep,
        Some(_) if panic.is_some() => {
            let words = said[panic.unwrap_or(0)..].lines().filter(|line| !line.starts_with("note: "));
            End::Panicked(words.collect::<Vec<_>>().join("\n").trim().to_owned())
        }
        Some(status) if status.code().is_none() => End::Killed(status.to_string()),
        Some(_) => End::Ended,
    };
    // what `dbg!` says is for whoever wrote it; what a panic says is in its end
    let printed = if end == End::Ended { printed + &said } else { printed };
    Ok(Run { end, printed })
}

/// Through a shell, which has the limit of memory set for itself and what it becomes. Where it cannot, the limit of time
/// remains.
#[cfg(unix)]
fn limited(program: &Path, limits: Limits) -> Command {
    const SCRIPT: &str = "ulimit -v \"$0\" 2>/dev/null; ulimit -c 0 2>/dev/null; exec \"$@\"";
    let mut command = Command::new("sh");
    command.args(["-c", SCRIPT, &(limits.memory * 1024).to_string()]).arg(program);
    command
}

#[cfg(not(unix))]
fn limited(program: &Path, _: Limits) -> Command {
    Command::new(program)
}

/// What comes out of a pipe, the first of it kept: a program may print without end.
struct Kept {
    bytes: Arc<Mutex<Vec<u8>>>,
    reader: JoinHandle<()>,
}

impl Kept {
    const MOST: usize = 1 << 16;

    fn of(pipe: Option<impl Read + Send + 'static>) -> Self {
        let bytes = Arc::new(Mutex::new(Vec::new()));
        let kept = Arc::clone(&bytes);
        let reader = thread::spawn(move || {
            let (mut pipe, mut buffer) = (pipe, [0; 8192]);
            while let Some(n) = pipe.as_mut().and_then(|pipe| pipe.read(&mut buffer).ok()).filter(|n| *n > 0) {
                let Ok(mut kept) = kept.lock() else { return };
                let room = Self::MOST.saturating_sub(kept.len()).min(n);
                kept.extend_from_slice(&buffer[..room]);
            }
        });
        Self { bytes, reader }
    }

    /// What was read. A process that the program has left behind may hold the pipe open: it is not waited for.
    fn words(self) -> String {
        let patience = Instant::now() + Duration::from_millis(500);
        while !self.reader.is_finished() && Instant::now() < patience {
            thread::sleep(Duration::from_millis(1));
        }
        self.bytes.lock().map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).unwrap_or_default()
    }
}
