//! `nyquist check` of tables, as a user meets it.

use crate::running::{code, json, nyquist, piped, stderr, stdout, text};
use std::f64::consts::PI;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;
use tempfile::TempDir;

fn check(input: &Path, args: &[&str]) -> Output {
    nyquist(&[&["check", text(input)], args].concat())
}

fn folder(table: &str) -> (TempDir, PathBuf) {
    let folder = TempDir::new().expect("a temporary folder");
    let input = folder.path().join("in.csv");
    fs::write(&input, table).expect("written");
    (folder, input)
}

const TONES: [(f64, f64); 3] = [(7.3, 1.0), (61.7, 0.3), (90.2, 0.05)];

fn signal(t: f64) -> f64 {
    TONES.iter().map(|(nu, a)| a * (2.0 * PI * nu * t + nu).cos()).sum()
}

fn table() -> String {
    let row = |k: i32| format!("{:.3},{}\n", f64::from(k) / 500.0, signal(f64::from(k) / 500.0));
    format!("time [s],U [V]\n{}", (0..2000).map(row).collect::<String>())
}

/// Amplitude at a frequency, of samples of a table at a rate: by the sums over cosine and sine under Hann's window, whose
/// sidelobes leave 10⁻⁵ of lines ten bins away.
fn amplitude(values: &[f64], rate: f64, frequency: f64) -> f64 {
    let n = values.len() as f64;
    let (mut re, mut im) = (0.0, 0.0);
    for (k, v) in values.iter().enumerate() {
        let window = 1.0 - (2.0 * PI * k as f64 / n).cos();
        let turn = 2.0 * PI * (frequency * k as f64 / rate).rem_euclid(1.0);
        re += window * v * turn.cos();
        im += window * v * turn.sin();
    }
    2.0 * re.hypot(im) / n
}

#[test]
fn aliases_are_found_in_the_table_that_interpolation_takes_at_the_new_rate() {
    let (folder, input) = folder(&table());
    for (rate, step) in [("80", "0.0125"), ("100", "0.01"), ("125", "0.008")] {
        let checked = check(&input, &["--rate", rate, "--json"]);
        let found = json(&checked);
        let aliases = found["columns"][0]["at_rate"]["aliases"].as_array().unwrap().clone();
        assert_eq!((code(&checked), aliases.len()), (1, if rate == "125" { 1 } else { 2 }), "{found:#}");
        let taken = folder.path().join("taken.csv");
        let args = ["interpolate", text(&input), "--every", step, "-o", text(&taken), "--force"];
        assert_eq!(code(&nyquist(&args)), 0);
        let csv = fs::read_to_string(&taken).unwrap();
        let values: Vec<f64> = csv.lines().skip(1).map(|l| l.split_once(',').unwrap().1.parse().unwrap()).collect();
        let rate: f64 = rate.parse().unwrap();
        for alias in aliases {
            let (at, a) = (alias["lands_at"].as_f64().unwrap(), alias["amplitude"].as_f64().unwrap());
            let frequency = alias["frequency"].as_f64().unwrap();
            // what folding says, from the closed form
            let known = TONES.iter().find(|(nu, _)| (nu - frequency).abs() < 1e-6).expect("a tone of the signal");
            let folded = (known.0 - rate * (known.0 / rate).round()).abs();
            assert!((at - folded).abs() < 1e-6 && (a - known.1).abs() < 1e-6, "{alias}");
            // and it is there: Hann's sidelobes, and the ends of the kernels, are below a thousandth
            let there = amplitude(&values, rate, at);
            assert!((there - a).abs() < 1e-3, "{rate}: {at}: {there} {a}");
            // while nothing is half-way to the next line
            assert!(amplitude(&values, rate, at + 3.1) < 0.01 * a + 1e-3);
        }
    }
}

#[test]
fn exit_codes_are_verdicts() {
    let (_folder, input) = folder(&table());
    assert_eq!(code(&check(&input, &[])), 0);
    assert_eq!(code(&check(&input, &["--rate", "200"])), 0);
    assert_eq!(code(&check(&input, &["--rate", "100"])), 1);
    // 0.3² + 0.05² below 1: 10.3 dB
    assert_eq!(code(&check(&input, &["--rate", "100", "--tolerance", "10"])), 0);
    let said = stdout(&check(&input, &["--rate", "100"]));
    assert!(said.contains("at 100 Hz aliases are only 10.3 dB below the signal"), "{said}");
    assert!(said.contains("61.7 Hz") && said.contains("38.3 Hz") && said.contains("9.8 Hz"), "{said}");
    assert!(said.contains("without a filter a rate above 180.4 Hz would do"), "{said}");
    for (args, message) in [
        (&["--rate", "0"][..], "the new rate must be greater than zero"),
        (&["--rate", "-5"], "the new rate must be greater than zero"),
        (&["--rate", "nan"], "the new rate must be finite"),
        (&["--rate", "fast"], "\"fast\" is no number"),
        (&["--rate", "80", "--tolerance", "inf"], "the tolerance must be finite"),
        (&["-o", "report.doc"], ".svg, .png, .pdf or .html"),
        (&["--up-to", "0.1"], "the highest frequency must lie between"),
        (&["--column", "I"], "no column is called \"I\""),
    ] {
        let refused = check(&input, args);
        assert_eq!(code(&refused), 2, "{args:?}");
        assert!(stderr(&refused).contains(message), "{args:?}: {}", stderr(&refused));
    }
}

#[test]
fn kinds_of_sampling_are_named_in_words() {
    let row = |t: f64| format!("{t:.6},{:.6}\n", signal(t));
    let jitter = |k: u32| f64::from(k * 7919 % 1009) / 1009.0 - 0.5;
    let uniform: String = (0..1000).map(|k| row(f64::from(k) / 500.0)).collect();
    let jittered: String = (0..1000).map(|k| row(f64::from(k) / 500.0 + 2e-4 * jitter(k) + 1.0)).collect();
    let gaps: String =
        (0..1000).filter(|k| k % 50 != 7 && !(300..330).contains(k)).map(|k| row(f64::from(k) / 500.0)).collect();
    let mut random: Vec<f64> = (0..1000).map(|k| 2.0 * nyquist::num::random::uniform(1, k, 0)).collect();
    random.sort_by(f64::total_cmp);
    let random: String = random.into_iter().map(row).collect();
    let reversed: String = uniform.lines().rev().map(|l| l.to_owned() + "\n").collect();
    let doubled = uniform.clone() + "0.500000,9\n0.502000,9\n";
    for (name, body, said, kind) in [
        (
            "uniform",
            uniform,
            &["0.002 s apart: a rate of 500 Hz", "are equally spaced", "Nyquist frequency 250 Hz"][..],
            "uniform",
        ),
        (
            "jittered",
            jittered,
            &["about 0.002 s apart", "stray from that grid", "Landau", "Gröchenig", "mirror image"],
            "jittered",
        ),
        (
            "gaps",
            gaps,
            &["Missing samples: 49", "the most in a row are 30", "2 stretches", "after 0.598000 (line 295)"],
            "gaps",
        ),
        ("random", random, &["irregular times", "No step underlies them"], "irregular"),
        ("reversed", reversed, &["run backwards"], "uniform"),
        (
            "doubled",
            doubled,
            &["time stood there before: 2, the first on line 1002", "values differ: 2", "out of order: 1 is earlier"],
            "uniform",
        ),
    ] {
        let (_folder, input) = folder(&format!("time [s],U [V]\n{body}"));
        let output = check(&input, &[]);
        assert_eq!(code(&output), 0, "{name}: {}", stderr(&output));
        for words in said {
            assert!(stdout(&output).contains(words), "{name}: {words}\n{}", stdout(&output));
        }
        assert_eq!(json(&check(&input, &["--json"]))["sampling"]["kind"], kind, "{name}");
        let noted =
            stderr(&output).contains("note: 2 rows have a time that stood there before, the first on line 1002");
        assert_eq!(noted, name == "doubled", "{name}: {}", stderr(&output));
        let russian = check(&input, &["--lang", "ru"]);
        assert!(stdout(&russian).contains("Дискретизация") && !stdout(&russian).contains("Sampling"), "{name}");
    }
}

#[test]
fn small_and_odd_tables_have_an_answer_or_a_sentence() {
    let constant: String = (0..100).map(|k| format!("{k},5.5\n")).collect();
    let (_folder, input) = folder(&format!("t,v\n{constant}"));
    let output = check(&input, &["--rate", "0.1"]);
    assert!(code(&output) == 0 && stdout(&output).contains("The values are constant: 5.5"), "{}", stdout(&output));
    assert!(stdout(&output).contains("Nothing aliases"), "{}", stdout(&output));
    let huge: String = (0..100).map(|k| format!("{k},{}\n", if k % 2 == 0 { 1e308 } else { -1e308 })).collect();
    let noise: String = (0..100u32).map(|k| format!("{k},{}\n", k.wrapping_mul(2_654_435_761) % 1000)).collect();
    fs::write(&input, format!("t,v\n{noise}")).unwrap();
    assert_eq!(code(&check(&input, &[])), 0);
    fs::write(&input, format!("t,v\n{huge}")).unwrap();
    let output = check(&input, &[]);
    assert!(code(&output) == 2 && stderr(&output).contains("the size of the largest value"), "{}", stderr(&output));
    // two bursts a day apart, on one grid of microseconds
    let bursts = (0..400).map(|k| if k < 300 { f64::from(k) } else { 8.64e10 + f64::from(k) });
    let rows: String = bursts.map(|us| format!("{:.6},{:.9}\n", 1e-6 * us, (2.0 * PI * 0.1234 * us).cos())).collect();
    fs::write(&input, format!("t [s],v\n{rows}")).unwrap();
    let output = check(&input, &["--rate", "2e5"]);
    assert!(
        code(&output) == 1 && stdout(&output).contains("nearly all gaps"),
        "{}{}",
        stdout(&output),
        stderr(&output)
    );
    assert!(stdout(&output).contains("123400 Hz"), "{}", stdout(&output));
    for (content, message) in [
        ("t,v\n0,1\n", "at least 2 needed, got 1"),
        ("t,v\n0,1\n1,2\n2,3\n", "at least 8 needed, got 3"),
        ("t,v\n0,1\n0,2\n0,3\n", "all are the same"),
        ("t,v\n", "a header and no row"),
        ("# only\n", "blank lines"),
        ("1\n2\n3\n4\n5\n6\n7\n8\n9\n", "--dt says how many seconds"),
        ("t,v\n0,1\n1,x\n", "line 3, column 2 (v)"),
    ] {
        fs::write(&input, content).unwrap();
        let output = check(&input, &["--rate", "1"]);
        assert!(code(&output) == 2 && stderr(&output).contains(message), "{content:?}: {}", stderr(&output));
        assert!(output.stdout.is_empty() && stderr(&output).lines().count() == 1, "{}", stderr(&output));
    }
    fs::write(&input, "").unwrap();
    assert!(stderr(&check(&input, &[])).contains("empty"));
    fs::write(&input, b"\xff\xd8").unwrap();
    assert!(stderr(&check(&input, &[])).contains("it may be no text"), "{}", stderr(&check(&input, &[])));
    fs::write(&input, b"\xff\xfet\0,\0v\0\n\0").unwrap();
    assert!(stderr(&check(&input, &[])).contains("UTF-16"));
    let values: String = (0..500).map(|k| format!("{}\n", signal(f64::from(k) / 500.0))).collect();
    fs::write(&input, values).unwrap();
    let output = check(&input, &["--dt", "1/500"]);
    assert!(code(&output) == 0 && stdout(&output).contains("a rate of 500 Hz"), "{}", stderr(&output));
}

#[test]
fn all_columns_are_looked_into_and_one_bad_is_bad() {
    let row = |k: i32| {
        let t = f64::from(k) / 500.0;
        format!("{t:.3};{};{}\n", (2.0 * PI * 9.1 * t).sin(), (2.0 * PI * 77.7 * t).sin())
    };
    let body: String = (0..1000).map(row).collect();
    let (_folder, input) = folder(&format!("t [s];slow [V];fast [A]\n{}", body.replace('.', ",")));
    let all = check(&input, &["--decimal-comma", "--rate", "50"]);
    assert!(code(&all) == 1 && stdout(&all).contains("Column slow [V]") && stdout(&all).contains("fast at 50 Hz"));
    assert_eq!(code(&check(&input, &["--decimal-comma", "--rate", "50", "--column", "slow"])), 0);
    let hint = check(&input, &["--rate", "50"]);
    assert!(code(&hint) == 2 && stderr(&hint).contains("(with --decimal-comma it is 0.000"), "{}", stderr(&hint));
}

#[test]
fn the_report_is_written_in_every_form_and_from_a_pipe() {
    let (folder, input) = folder(&table());
    for name in ["r.svg", "r.png", "r.pdf", "r.html"] {
        let report = folder.path().join(name);
        let args = ["--rate", "80", "-o", text(&report), "--lang", "ru", "--theme", "dark"];
        let output = check(&input, &args);
        assert_eq!(code(&output), 1, "{name}: {}", stderr(&output));
        let bytes = fs::read(&report).unwrap();
        assert!(bytes.len() > 1000, "{name}");
        if name == "r.html" {
            let page = String::from_utf8(bytes).unwrap();
            assert!(page.contains("Столбец U [V]") && page.contains("61,7 Hz") && page.contains("<svg"));
        }
        let again = check(&input, &args);
        assert!(code(&again) == 2 && stderr(&again).contains("--force"));
    }
    let fed = piped("check", &["-", "--rate", "80"], table().as_bytes());
    assert!(code(&fed) == 1 && stdout(&fed).starts_with("standard input: 2000 samples"), "{}", stdout(&fed));
}
