//! `cargo run --release -p peers [JOB…]`: nyquist beside other libraries, the same job in one run.
//!
//! Before a race the results of all contenders are compared with a reference; who errs more than the job allows is
//! shown, but does not count. Then they take turns, and medians are compared.

mod jobs;
mod machine;
mod memory;
mod race;
mod table;

use machine::Machine;
use race::Outcome;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

const USAGE: &str = "usage: peers [--rounds N] [--list] [--machine] [--report] [JOB...]
  JOB       a name or letter from --list; all if none is given
  --rounds  how often the contenders take turns (default 15)
  --machine only measure what the machine can do
  --report  only write RESULTS.md anew from what was measured last";

fn main() -> ExitCode {
    memory::prepare();
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::from(2)
        }
    }
}

fn run() -> Result<(), String> {
    let (mut rounds, mut wanted, mut report) = (15, Vec::<String>::new(), false);
    let mut arguments = env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--rounds" => {
                let given = arguments.next().and_then(|n| n.parse().ok()).filter(|&n| n > 0);
                rounds = given.ok_or_else(|| USAGE.to_owned())?;
            }
            "--list" => {
                for job in jobs::ALL {
                    println!("{} {:<14} {}", job.letter, job.name, job.about);
                }
                return Ok(());
            }
            "--machine" => return measured().map(drop),
            "--report" => report = true,
            name if name.starts_with('-') => return Err(USAGE.to_owned()),
            name => wanted.push(name.to_owned()),
        }
    }
    if !report {
        measure(rounds, &wanted)?;
    }
    write_results()
}

fn measure(rounds: usize, wanted: &[String]) -> Result<(), String> {
    let named = |name: &String| jobs::ALL.iter().find(|job| job.name == name || job.letter == name);
    let chosen: Vec<_> = if wanted.is_empty() {
        jobs::ALL.iter().collect()
    } else {
        let found = wanted.iter().map(|name| named(name).ok_or(format!("no job is called {name}; see --list")));
        found.collect::<Result<_, _>>()?
    };
    let machine = measured()?;
    for job in chosen {
        let outcomes = (job.run)(&machine, rounds);
        println!("\n{}: {}\n\n{}", job.name, job.about, table::details(&outcomes));
        save(&format!("rust-{}.json", job.name), &outcomes)?;
    }
    Ok(())
}

fn measured() -> Result<Machine, String> {
    let machine = Machine::measured();
    println!("{}", describe(&machine));
    save("machine.json", &machine)?;
    Ok(machine)
}

fn describe(machine: &Machine) -> String {
    let giga = |pair: [f64; 2]| format!("{:.1} / {:.1}", pair[0] / 1e9, pair[1] / 1e9);
    format!(
        "{}, on one thread / on two: triad {} GB/s, reading {} GB/s, fused multiply-adds {} GFLOP/s (f64)",
        machine.processor,
        giga(machine.triad),
        giga(machine.read),
        giga(machine.flops)
    )
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("results")
}

fn save(name: &str, value: &impl serde::Serialize) -> Result<(), String> {
    let text = serde_json::to_string_pretty(value).map_err(|error| error.to_string())?;
    let path = folder().join(name);
    fs::create_dir_all(folder())
        .and_then(|()| fs::write(&path, text + "\n"))
        .map_err(|e| format!("{}: {e}", path.display()))
}

/// `RESULTS.md` from all that was measured, by this program and by the scripts in `python/`.
fn write_results() -> Result<(), String> {
    let mut names: Vec<PathBuf> =
        fs::read_dir(folder()).map_err(|e| e.to_string())?.flatten().map(|entry| entry.path()).collect();
    names.sort();
    let mut outcomes: Vec<Outcome> = Vec::new();
    let mut machine = String::new();
    for path in names {
        let text = fs::read_to_string(&path).map_err(|e| e.to_string())?;
        let unreadable = |e: serde_json::Error| format!("{}: {e}", path.display());
        if path.ends_with("machine.json") {
            machine = describe(&serde_json::from_str(&text).map_err(unreadable)?);
        } else {
            outcomes.extend(serde_json::from_str::<Vec<Outcome>>(&text).map_err(unreadable)?);
        }
    }
    outcomes.sort_by(|a, b| a.job.cmp(&b.job));
    let text = format!(
        "{}{machine}\n\n{}\n## Every run\n\n{}{}",
        include_str!("head.md"),
        table::summary(&outcomes),
        table::table(&outcomes),
        foot(&outcomes)
    );
    let path = folder().with_file_name("RESULTS.md");
    fs::write(&path, text).map_err(|e| format!("{}: {e}", path.display()))
}

fn foot(outcomes: &[Outcome]) -> String {
    let limits = table::limits(outcomes);
    format!("\n## What the limits count\n\n{limits}\n## Everybody\n\n{}", table::details(outcomes))
}
