//! The command as a user runs it, and what it says.

use serde_json::Value;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// The command with these arguments, not started yet.
pub(crate) fn command(subcommand: &str, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_nyquist"));
    command.arg(subcommand).args(args);
    command
}

/// What a subcommand says and ends with.
pub(crate) fn run(subcommand: &str, args: &[&str]) -> Output {
    command(subcommand, args).output().expect("the command starts")
}

/// The same for all arguments in one list.
pub(crate) fn nyquist(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_nyquist")).args(args).output().expect("the command starts")
}

/// A subcommand that finds `input` on its standard input.
pub(crate) fn piped(subcommand: &str, args: &[&str], input: &[u8]) -> Output {
    let mut command = command(subcommand, args);
    let pipes = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = pipes.spawn().expect("the command starts");
    let mut stdin = child.stdin.take().expect("there is a pipe");
    let input = input.to_vec();
    // in a thread, as the command may write before it has read all; it may also end before
    let feed = std::thread::spawn(move || drop(stdin.write_all(&input)));
    let output = child.wait_with_output().expect("the command ends");
    feed.join().expect("the pipe was fed");
    output
}

pub(crate) fn code(output: &Output) -> i32 {
    output.status.code().expect("the command was not killed")
}

pub(crate) fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

pub(crate) fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

pub(crate) fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{e}: {}{}", stdout(output), stderr(output)))
}

pub(crate) fn text(path: &Path) -> &str {
    path.to_str().expect("the path is text")
}
