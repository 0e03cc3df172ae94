//! Programs of notebooks, compiled against the library and run.

use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The compiled library.
pub struct Library {
    rlib: PathBuf,
    work: PathBuf,
}

impl Library {
    /// Compiles it as a release.
    pub fn built(root: &Path) -> Result<Self, String> {
        let arguments = ["build", "--locked", "--release", "--lib", "--message-format", "json-render-diagnostics"];
        let cargo = Command::new(env!("CARGO")).args(arguments).current_dir(root).output();
        let output = cargo.map_err(|error| format!("cargo: {error}"))?;
        if !output.status.success() {
            return Err(String::from_utf8_lossy(&output.stderr).into_owned());
        }
        let messages = String::from_utf8_lossy(&output.stdout).into_owned();
        let artifacts = messages.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
        let library = |message: Value| {
            let ours = message["reason"] == "compiler-artifact" && message["target"]["name"] == "nyquist";
            let files = message["filenames"].as_array()?.iter().filter_map(Value::as_str);
            files.filter(|_| ours).find(|file| file.ends_with(".rlib")).map(PathBuf::from)
        };
        let rlib = artifacts.filter_map(library).next_back().ok_or("cargo did not say where the library is")?;
        let work = rlib.with_file_name("notebooks");
        fs::create_dir_all(&work).map_err(|error| format!("{}: {error}", work.display()))?;
        Ok(Self { rlib, work })
    }

    /// Compiles and runs a program; what each of its cells printed.
    pub fn run(&self, name: &str, program: &str) -> Result<BTreeMap<usize, String>, String> {
        let (source, binary) = (self.work.join(format!("{name}.rs")), self.work.join(name));
        fs::write(&source, program).map_err(|error| format!("{}: {error}", source.display()))?;
        let deps = self.rlib.with_file_name("deps");
        let mut rustc = Command::new("rustc");
        rustc.args(["--edition", "2024", "--crate-name", "notebook", "-O", "--cap-lints", "allow"]).arg(&source);
        rustc.arg("-o").arg(&binary).arg("-L").arg(format!("dependency={}", deps.display()));
        rustc.arg("--extern").arg(format!("nyquist={}", self.rlib.display()));
        finished(&mut rustc, name)?;
        let printed = finished(Command::new(&binary).env("EVCXR_IS_RUNTIME", "1"), name)?;
        let mut cells = BTreeMap::new();
        for part in printed.split('\u{1e}').skip(1) {
            let (index, words) = part.split_once('\n').unwrap_or((part, ""));
            let index = index.parse().map_err(|_| format!("{name}: a cell without a number"))?;
            cells.insert(index, words.to_owned());
        }
        Ok(cells)
    }
}

/// What it prints, if it ends well.
fn finished(command: &mut Command, name: &str) -> Result<String, String> {
    let output = command.output().map_err(|error| format!("{}: {error}", command.get_program().to_string_lossy()))?;
    if !output.status.success() {
        return Err(format!("{name}: {}", String::from_utf8_lossy(&output.stderr)));
    }
    String::from_utf8(output.stdout).map_err(|error| format!("{name}: {error}"))
}
