//! `cargo xtask`: what is derived and never written by hand.

mod notebook;
mod run;
mod source;

use std::path::Path;
use std::process::ExitCode;

const USAGE: &str = "usage: cargo xtask notebooks [--check]
  notebooks           compile and run notebooks-rs/*.rs, write notebooks-rs/{en,ru}/*.ipynb with their outputs
  notebooks --check   exit code 1 if any of them is not what the sources derive";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match arguments[..] {
        ["notebooks"] => notebook::write(root()),
        ["notebooks", "--check"] => notebook::check(root()),
        _ => Err(USAGE.to_owned()),
    };
    match done {
        Ok(words) => {
            println!("{words}");
            ExitCode::SUCCESS
        }
        Err(words) => {
            eprintln!("{words}");
            ExitCode::FAILURE
        }
    }
}

/// The folder of the whole project.
fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("this package lies in the project's folder")
}
