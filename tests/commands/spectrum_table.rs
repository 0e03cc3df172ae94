//! `nyquist spectrum` of tables, as a user meets it.

use crate::running::{code, run, stderr, stdout, text};
use serde_json::Value;
use std::f64::consts::PI;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;
use tempfile::TempDir;

fn spectrum(input: &Path, args: &[&str]) -> Output {
    run("spectrum", &[&[text(input)], args].concat())
}

fn folder(header: &str, rows: impl Iterator<Item = (f64, f64)>) -> (TempDir, PathBuf) {
    let folder = TempDir::new().expect("a temporary folder");
    let input = folder.path().join("in.csv");
    let body: String = rows.map(|(t, v)| format!("{t:.6},{v}\n")).collect();
    fs::write(&input, format!("{header}\n{body}")).expect("written");
    (folder, input)
}

fn rows(csv: &str) -> Vec<Vec<f64>> {
    csv.lines().skip(1).map(|l| l.split(',').map(|c| c.parse().expect("a number")).collect()).collect()
}

fn tone(t: f64) -> f64 {
    1.0 + 3.0 * (2.0 * PI * 12.0 * t + 0.4).cos()
}

#[test]
fn amplitudes_and_densities_with_their_units() {
    let (_folder, input) = folder("time [s],U [V]", (0..500).map(|k| f64::from(k) / 100.0).map(|t| (t, tone(t))));
    let output = spectrum(&input, &["-o", "-"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    assert!(stdout(&output).starts_with("frequency [Hz],amplitude of U [V]\n0.2,"), "{}", &stdout(&output)[..60]);
    let amplitudes = rows(&stdout(&output));
    // 12 Hz is the 60th multiple of 1/5 Hz; Hann's window leaves half of it on either side, and nothing farther
    assert_eq!((amplitudes.len(), amplitudes[59][0]), (250, 12.0));
    assert!((amplitudes[59][1] - 3.0).abs() < 1e-12 && (amplitudes[58][1] - 1.5).abs() < 1e-12);
    assert!(amplitudes[40][1] < 1e-12);
    let density = spectrum(&input, &["-o", "-", "--quantity", "density", "--window", "rectangular"]);
    assert!(stdout(&density).starts_with("frequency [Hz],density of U [V²/Hz]\n"), "{}", &stdout(&density)[..60]);
    // all of the tone's mean square, 4.5, in one bin of 0.2 Hz
    let line = &rows(&stdout(&density))[59];
    assert!((line[1] - 4.5 / 0.2).abs() < 1e-10, "{line:?}");
}

#[test]
fn irregular_times_by_least_squares_up_to_a_frequency() {
    let time = |k: u32| 0.01 * f64::from(k) + 0.006 * f64::from(k * 7919 % 1009) / 1009.0;
    let (folder, input) = folder("time [ms],v", (0..800).map(|k| 1e-6 * (1e6 * time(k)).round()).map(|t| (t, tone(t))));
    let output = spectrum(&input, &["-o", "-", "--up-to", "20", "--window", "hann"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    assert!(stdout(&output).starts_with("frequency [kHz],amplitude of v\n"));
    let rows = rows(&stdout(&output));
    assert!(rows.last().unwrap()[0] <= 20.0 && rows.last().unwrap()[0] > 19.8);
    let top = rows.iter().max_by(|a, b| a[1].total_cmp(&b[1])).unwrap();
    assert!((top[0] - 12.0).abs() < 0.1 && (top[1] - 3.0).abs() < 0.05, "{top:?}");
    let json_file = folder.path().join("s.json");
    assert_eq!(code(&spectrum(&input, &["-o", text(&json_file), "--up-to", "20"])), 0);
    let json: Value = serde_json::from_slice(&fs::read(&json_file).unwrap()).unwrap();
    assert_eq!((&json["sampling"]["kind"], &json["window"]), (&"jittered".into(), &"hann".into()));
    assert!(json["method"].as_str().unwrap().contains("Lomb"));
    assert_eq!(json["columns"][0]["amplitude"].as_array().unwrap().len(), rows.len());
    let far = spectrum(&input, &["-o", "-", "--up-to", "1e9"]);
    assert!(code(&far) == 2 && stderr(&far).contains("overflows"), "{}", stderr(&far));
}

#[test]
fn pictures_of_one_column_and_of_several() {
    let folder = TempDir::new().unwrap();
    let input = folder.path().join("in.csv");
    let body: String =
        (0..300).map(|k| f64::from(k) / 100.0).map(|t| format!("{t:.2};{};{}\n", tone(t), -tone(2.0 * t))).collect();
    fs::write(&input, format!("t [s];\"a,b [V]\";c [A]\n{body}")).unwrap();
    for (name, args) in [
        ("one.svg", &["--column", "c"][..]),
        ("two.svg", &[]),
        ("density.pdf", &["--quantity", "density"]),
        ("dark.png", &["--theme", "dark"]),
    ] {
        let out = folder.path().join(name);
        let output = spectrum(&input, &[&["-o", text(&out), "--lang", "ru"], args].concat());
        assert_eq!(code(&output), 0, "{name}: {}", stderr(&output));
        assert!(fs::read(&out).unwrap().len() > 1000);
        let again = spectrum(&input, &[&["-o", text(&out)], args].concat());
        assert!(code(&again) == 2 && stderr(&again).contains("--force"));
    }
    // names are quoted where they must be
    let csv = stdout(&spectrum(&input, &["-o", "-"]));
    assert!(csv.starts_with("frequency [Hz],\"amplitude of a,b [V]\",amplitude of c [A]\n"), "{}", &csv[..80]);
}

#[test]
fn bad_wishes_are_one_sentence() {
    let (folder, input) = folder("t,v", (0..100).map(|k| (f64::from(k), tone(f64::from(k)))));
    for (args, message) in [
        (&["-o", "s.txt"][..], ".svg, .png, .pdf, .csv or .json"),
        (&["-o", "-", "--window", "han"], "known: hann"),
        (&["-o", "-", "--quantity", "power"], "known: "),
        (&["-o", "-", "--up-to", "-1"], "must be greater than zero"),
        (&["-o", "-", "--up-to", "0.001"], "the highest frequency must lie between"),
        (&["-o", text(&input), "--force"], "never overwritten"),
    ] {
        let output = spectrum(&input, args);
        assert!(code(&output) == 2 && stderr(&output).contains(message), "{args:?}: {}", stderr(&output));
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn rows_that_were_sorted_or_merged_are_noted() {
    let rows = (0..50).chain([60, 55]).chain((50..200).filter(|k| ![55, 60].contains(k))).chain([30]);
    let (_folder, input) = folder("t [s],v", rows.map(|k| f64::from(k) / 100.0).map(|t| (t, tone(t))));
    let output = spectrum(&input, &["-o", "-"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    for note in
        ["note: 3 rows are earlier than the row before, the first on line 53", "note: 1 row has a time that stood"]
    {
        assert!(stderr(&output).contains(note), "{note}: {}", stderr(&output));
    }
}
