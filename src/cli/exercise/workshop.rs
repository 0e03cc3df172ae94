//! A small Cargo project in which answers are compiled together with what judges them.

use crate::cli::{Failure, files};
use serde_json::Value;
use std::collections::BTreeMap;
use std::env;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::Command;

/// How the project's manifest begins, so that nobody else's is taken for it.
const MARK: &str = "# Written by `nyquist exercise`.";

/// How its programs begin.
const OURS: &str = "// Written by `nyquist exercise`";

/// The project.
#[derive(Debug)]
pub(super) struct Workshop {
    root: PathBuf,
}

/// What became of a program: its path, or what the compiler said.
pub(super) type Compiled = Result<PathBuf, String>;

impl Workshop {
    /// The project in that folder, made if it is not there. `library` is where the crate comes from: a folder or the
    /// address of a Git repository; without it, `NYQUIST_LIBRARY`, or the folder that this command was built from.
    pub(super) fn open(root: &Path, library: Option<&str>) -> Result<Self, Failure> {
        let manifest = root.join("Cargo.toml");
        match fs::read_to_string(&manifest) {
            Ok(there) if !there.starts_with(MARK) => {
                let why = "belongs to another project; choose another folder with --dir";
                return Err(Failure::Trouble(format!("{} {why}", manifest.display())));
            }
            Ok(_) if library.is_none() => {}
            Err(error) if error.kind() != ErrorKind::NotFound => {
                return Err(Failure::trouble(format!("cannot read {}", manifest.display()), error));
            }
            Ok(_) | Err(_) => write_manifest(root, library)?,
        }
        Ok(Self { root: root.to_owned() })
    }

    /// Writes a program, if it is not there as it should be: what has not changed is not compiled again.
    pub(super) fn program(&self, name: &str, text: &str) -> Result<(), Failure> {
        let path = self.root.join("src/bin").join(format!("{name}.rs"));
        match fs::read_to_string(&path) {
            Ok(there) if there == text => Ok(()),
            Ok(there) if !there.starts_with(OURS) => {
                let why = "is not of nyquist exercise, and would be replaced; choose another folder with --dir";
                Err(Failure::Trouble(format!("{} {why}", path.display())))
            }
            _ => files::write(&path, text.as_bytes()),
        }
    }

    /// Removes all programs but these.
    pub(super) fn keep(&self, names: &[String]) -> Result<(), Failure> {
        for entry in fs::read_dir(self.root.join("src/bin")).into_iter().flatten().flatten() {
            let name = entry.path().file_stem().unwrap_or_default().to_string_lossy().into_owned();
            if !names.contains(&name) {
                fs::remove_file(entry.path())?;
            }
        }
        Ok(())
    }

    /// Compiles the programs of those names, all in one go.
    pub(super) fn compile(&self, names: &[String]) -> Result<BTreeMap<String, Compiled>, Failure> {
        let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let mut command = Command::new(cargo);
        command.args(["build", "--message-format", "json", "--keep-going"]).current_dir(&self.root);
        for name in names {
            command.args(["--bin", name]);
        }
        let output = command.output().map_err(|error| match error.kind() {
            ErrorKind::NotFound => Failure::Trouble(
                "cargo is not installed; https://rustup.rs installs it (so do `apt install rustup` and `brew install rustup`)".into(),
            ),
            _ => Failure::trouble("cargo cannot be started", error),
        })?;
        // nobody's answer is to blame for what the machine lacks
        if String::from_utf8_lossy(&output.stdout).contains("error: linker `") {
            let why =
                "a C linker is not installed; `apt install build-essential` or `xcode-select --install` installs it";
            return Err(Failure::Trouble(why.into()));
        }
        let mut compiled: BTreeMap<String, Compiled> = BTreeMap::new();
        for message in
            output.stdout.split(|byte| *byte == b'\n').filter_map(|l| serde_json::from_slice::<Value>(l).ok())
        {
            let Some(name) = message["target"]["name"].as_str().filter(|name| names.iter().any(|n| n == name)) else {
                continue;
            };
            let said = message["message"]["rendered"].as_str().filter(|_| message["message"]["level"] == "error");
            let so_far = compiled.remove(name);
            let now = match (message["executable"].as_str(), said, so_far) {
                (Some(program), ..) => Some(Ok(program.into())),
                (None, Some(words), Some(Err(before))) => Some(Err(before + words)),
                (None, Some(words), None) => Some(Err(words.into())),
                (.., so_far) => so_far,
            };
            compiled.extend(now.map(|now| (name.to_owned(), now)));
        }
        if let Some(name) = names.iter().find(|name| !compiled.contains_key(*name)) {
            let said = String::from_utf8_lossy(&output.stderr);
            return Err(Failure::trouble(format!("cargo cannot build {name}"), said.trim()));
        }
        Ok(compiled)
    }
}

fn write_manifest(root: &Path, library: Option<&str>) -> Result<(), Failure> {
    let given = library.map(str::to_owned).or_else(|| env::var("NYQUIST_LIBRARY").ok());
    let git = given.as_ref().filter(|from| from.contains("://") || from.ends_with(".git"));
    let from = if let Some(address) = git {
        format!("git = {}", quoted(address))
    } else {
        let folder = PathBuf::from(given.as_deref().unwrap_or(env!("CARGO_MANIFEST_DIR")));
        let ours = fs::read_to_string(folder.join("Cargo.toml")).is_ok_and(|text| text.contains("name = \"nyquist\""));
        if !ours {
            let why = "is not the folder of nyquist; say where it is with --library DIR";
            return Err(Failure::Trouble(format!("{} {why}", folder.display())));
        }
        let folder = fs::canonicalize(folder)?;
        // the versions that the library was built with are on this machine already: no network is needed
        if let (Ok(lock), false) = (fs::read(folder.join("Cargo.lock")), root.join("Cargo.lock").exists()) {
            files::write(&root.join("Cargo.lock"), &lock)?;
        }
        format!("path = {}", quoted(&folder.to_string_lossy()))
    };
    let manifest = format!(
        "{MARK}\n[package]\nname = \"exercises\"\nversion = \"0.0.0\"\nedition = \"2024\"\npublish = false\n\n[dependencies]\n\
         nyquist = {{ {from}, default-features = false }}\n\n[profile.dev]\ndebug = \"line-tables-only\"\n\n\
         # not a part of the project around it, if there is one\n[workspace]\n"
    );
    files::write(&root.join("Cargo.toml"), manifest.as_bytes())
}

/// As a string of TOML.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}
