//! `nyquist interpolate` as a user meets it.

use crate::running::{code, piped, run, stderr, stdout, text};
use nyquist::num::random::uniform;
use std::f64::consts::PI;
use std::fs;
use std::path::PathBuf;
use std::process::Output;
use tempfile::TempDir;

fn interpolate(args: &[&str]) -> Output {
    run("interpolate", args)
}

/// A folder with a table in it.
fn folder(table: &str) -> (TempDir, PathBuf, PathBuf) {
    let folder = TempDir::new().expect("a temporary folder");
    let (input, output) = (folder.path().join("in.csv"), folder.path().join("out.csv"));
    fs::write(&input, table).expect("written");
    (folder, input, output)
}

/// Times and the values of the first column, without the header.
fn rows(csv: &str) -> Vec<(String, Option<f64>)> {
    let row = |line: &str| {
        let (time, value) = line.split_once(',').expect("two cells");
        (time.to_owned(), value.split(',').next().and_then(|cell| cell.parse().ok()))
    };
    csv.lines().skip(1).map(row).collect()
}

fn signal(t: f64) -> f64 {
    2.0 + (2.0 * PI * 3.1 * t).cos() + 0.3 * (2.0 * PI * 11.7 * t + 0.5).cos()
}

/// The signal at a hundred samples in a unit of time, with some decimals of time.
fn table(n: i32) -> String {
    let row = |k: i32| format!("{:.2},{}\n", f64::from(k) / 100.0, signal(f64::from(k) / 100.0));
    format!("time [s],U [V]\n{}", (0..n).map(row).collect::<String>())
}

#[test]
fn values_between_samples_are_those_of_the_signal_and_times_are_exact() {
    let (_folder, input, output) = folder(&table(401));
    let done = interpolate(&[text(&input), "--every", "0.0025", "-o", text(&output)]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    let written = fs::read_to_string(&output).unwrap();
    assert!(written.starts_with("time [s],U [V]\n0.0000,"), "{}", &written[..40]);
    let rows = rows(&written);
    assert_eq!(rows.len(), 1601);
    assert_eq!((rows[1].0.as_str(), rows[1600].0.as_str()), ("0.0025", "4.0000"));
    // kernels of 33 steps, made for 40 Hz: 10⁻⁹ of both amplitudes, but for 0.33 from the ends
    for (time, value) in &rows[140..1460] {
        let t: f64 = time.parse().unwrap();
        assert!((value.unwrap() - signal(t)).abs() < 1.3e-9, "{t}");
    }
    assert!(
        stdout(&done).contains("1601 rows") && stdout(&done).contains("kaiser, 33 steps to either side"),
        "{}",
        stdout(&done)
    );
    assert!(stdout(&done).contains("error below"), "{}", stdout(&done));
}

#[test]
fn what_is_beyond_the_band_is_said() {
    let (_folder, input, output) = folder(&table(401));
    let said = |band: &str| {
        stdout(&interpolate(&[text(&input), "--every", "0.5", "--band", band, "-o", text(&output), "--force"]))
    };
    assert!(!said("20").contains("beyond the band"), "{}", said("20"));
    // 0.3² of 1 + 0.3²: the tone at 11.7
    assert!(said("9").contains("U: 8.2") && said("9").contains("% of its energy is beyond the band"), "{}", said("9"));
}

#[test]
fn times_of_a_file_are_written_as_they_stand_there_in_their_order() {
    let (folder, input, output) = folder(&table(401));
    let times = folder.path().join("times.csv");
    fs::write(&times, "when,note\n2.000001,a\n1.5000,b\n1.5000,c\n# no\n\n3e0,d\n").unwrap();
    let done = interpolate(&[text(&input), "--at", text(&times), "-o", text(&output)]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    let rows = rows(&fs::read_to_string(&output).unwrap());
    let said: Vec<&str> = rows.iter().map(|(time, _)| time.as_str()).collect();
    assert_eq!(said, ["2.000001", "1.5000", "1.5000", "3"]);
    for (time, value) in &rows {
        assert!((value.unwrap() - signal(time.parse().unwrap())).abs() < 1.3e-9, "{time}");
    }
}

#[test]
fn the_dialect_of_the_input_is_that_of_the_output() {
    let german = table(401).replace(',', ";").replace('.', ",");
    let (_folder, input, output) = folder(&german);
    let done = interpolate(&[text(&input), "--decimal-comma", "--every", "0,5", "-o", text(&output)]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    let written = fs::read_to_string(&output).unwrap();
    assert!(written.starts_with("time [s];U [V]\n0,00;") && written.contains("\n0,50;"), "{written}");
    let there = written.lines().nth(3).unwrap().split_once(';').unwrap().1.replace(',', ".");
    assert!((there.parse::<f64>().unwrap() - signal(1.0)).abs() < 1e-12);
    // without a header there is none, and tabs stay tabs
    let bare = table(101).lines().skip(1).map(|l| l.replace(',', "\t") + "\n").collect::<String>();
    fs::write(&input, bare).unwrap();
    let piped = interpolate(&[text(&input), "--every", "0.25", "-o", "-"]);
    assert_eq!(code(&piped), 0);
    assert!(stdout(&piped).starts_with("0.00\t") && stdout(&piped).lines().count() == 5, "{}", stdout(&piped));
}

#[test]
fn pipes_are_files() {
    let (_folder, input, output) = folder(&table(201));
    assert_eq!(code(&interpolate(&[text(&input), "--every", "0.003", "-o", text(&output)])), 0);
    let done = piped("interpolate", &["-", "--every", "0.003", "-o", "-"], table(201).as_bytes());
    assert_eq!((code(&done), stdout(&done)), (0, fs::read_to_string(&output).unwrap()));
    assert!(stderr(&done).contains("kaiser"), "{}", stderr(&done));
}

#[test]
fn dates_come_back_as_dates() {
    let row = |k: u32| format!("2026-01-31T23:59:{:02}.{}00Z,{}\n", 50 + k / 10, k % 10, signal(0.1 * f64::from(k)));
    let text_in = format!("when,U\n{}", (0..100).map(row).collect::<String>());
    let (folder, input, output) = folder(&text_in);
    let done = interpolate(&[text(&input), "--every", "0.25", "-o", text(&output)]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    let rows = rows(&fs::read_to_string(&output).unwrap());
    assert_eq!((rows[0].0.as_str(), rows[1].0.as_str()), ("2026-01-31T23:59:50.000Z", "2026-01-31T23:59:50.250Z"));
    assert_eq!(rows.len(), 40);
    let times = folder.path().join("times.csv");
    fs::write(&times, "2026-01-31T23:59:55.5Z\n").unwrap();
    let done = interpolate(&[text(&input), "--at", text(&times), "-o", "-"]);
    assert!(stdout(&done).contains("2026-01-31T23:59:55.5Z,"), "{}{}", stdout(&done), stderr(&done));
    fs::write(&times, "5.5\n").unwrap();
    let mixed = interpolate(&[text(&input), "--at", text(&times), "-o", "-"]);
    assert!(code(&mixed) == 2 && stderr(&mixed).contains("dates and numbers"), "{}", stderr(&mixed));
}

#[test]
fn times_since_1970_keep_their_microseconds() {
    let at = |k: i64| signal(k as f64 * 1e-5);
    let row = |k: i64| format!("1769860800.{:06},{}\n", 10 * k, at(k));
    let (folder, input, _) = folder(&(0..2000).map(row).collect::<String>());
    let times = folder.path().join("times.csv");
    fs::write(&times, "1769860800.010005000\n1769860800.010005001\n").unwrap();
    let done = interpolate(&[text(&input), "--at", text(&times), "-o", "-"]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    let values: Vec<f64> = stdout(&done).lines().map(|l| l.split_once(',').unwrap().1.parse().unwrap()).collect();
    assert!(stdout(&done).starts_with("1769860800.010005000,"));
    // f64 would round the time by 10⁻⁷, and the values by 3·10⁻⁶
    assert!((values[0] - signal(0.010_005)).abs() < 1e-9 && (values[1] - signal(0.010_005_001)).abs() < 1e-9);
    assert_ne!(values[0], values[1]);
}

#[test]
fn the_periodic_method_is_exact_for_a_period() {
    let period = |t: f64| (2.0 * PI * 7.0 * t / 50.0).cos() - 0.5 * (2.0 * PI * 24.0 * t / 50.0).sin() + 1.0;
    let rows_in: String = (0..50).map(|k| format!("{k},{}\n", period(f64::from(k)))).collect();
    let (_folder, input, output) = folder(&format!("t,v\n{rows_in}"));
    let args = ["--method", "periodic", "--every", "0.37", "--outside", "extend", "-o", text(&output)];
    let done = interpolate(&[&[text(&input)], &args[..]].concat());
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    let rows = rows(&fs::read_to_string(&output).unwrap());
    assert_eq!(rows.len(), 133);
    for (time, value) in rows {
        assert!((value.unwrap() - period(time.parse().unwrap())).abs() < 1e-13, "{time}");
    }
}

#[test]
fn irregular_samples_say_their_condition_number() {
    // a decaying oscillation, well below half the density, at times that jitter
    let pulse = |t: f64| (-0.5 * ((t - 20.0) / 2.0f64).powi(2)).exp() * (2.0 * PI * 1.5 * t).cos();
    let time = |k: u32| 0.1 * f64::from(k) + 0.03 * f64::from(k * 7919 % 97) / 97.0;
    let rows_in: String = (0..400).map(|k| format!("{:.9},{}\n", time(k), pulse(time(k)))).collect();
    let (_folder, input, output) = folder(&format!("t,v\n{rows_in}"));
    let done = interpolate(&[text(&input), "--every", "0.05", "--json", "-o", text(&output)]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    let json: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    assert_eq!(json["sampling"]["kind"], "jittered");
    let way = &json["pieces"][0]["way"];
    assert_eq!(way["method"], "least-squares");
    let (condition, band) = (way["condition"].as_f64().unwrap(), way["band"].as_f64().unwrap());
    assert!(condition > 1.0 && condition < 10.0 && band > 4.0, "{way}");
    // times are rounded to 10⁻⁹: the pulse changes by 10⁻⁸ at most in that
    for (time, value) in rows(&fs::read_to_string(&output).unwrap()) {
        let t: f64 = time.parse().unwrap();
        assert!((value.unwrap() - pulse(t)).abs() < condition * 1e-8, "{t}");
    }
    let said = interpolate(&[text(&input), "--every", "0.05", "--band", "2.5", "-o", text(&output), "--force"]);
    assert!(
        stdout(&said).contains("band of 2.49") && stdout(&said).contains("condition number at least 1."),
        "{}",
        stdout(&said)
    );
}

#[test]
fn a_band_that_the_density_does_not_support_is_refused_with_the_numbers() {
    let rows_in: String = (0..400)
        .filter(|k| k % 4 != 1 || k % 3 == 0)
        .map(|k| format!("{},{}\n", f64::from(k) + 0.2 * f64::from(k % 5), k % 7))
        .collect();
    let (_folder, input, output) = folder(&format!("t,v\n{rows_in}"));
    let done = interpolate(&[text(&input), "--every", "0.5", "--band", "0.48", "-o", text(&output)]);
    assert_eq!(code(&done), 2);
    let said = stderr(&done);
    assert!(
        said.contains("must lie between 0 and 0.41") && said.contains("Landau") && said.contains("Gröchenig"),
        "{said}"
    );
    assert!(!output.exists());
    let done =
        interpolate(&[text(&input), "--every", "0.5", "--band", "0.4", "--most-condition", "2", "-o", text(&output)]);
    assert!(code(&done) == 2 && stderr(&done).contains("condition number is at least"), "{}", stderr(&done));
    let method = interpolate(&[text(&input), "--every", "0.5", "--method", "kaiser", "-o", text(&output)]);
    assert!(code(&method) == 2 && stderr(&method).contains("equally spaced"), "{}", stderr(&method));
}

#[test]
fn times_outside_are_refused_left_out_left_empty_or_extended() {
    let (folder, input, output) = folder(&table(301));
    let times = folder.path().join("times.csv");
    fs::write(&times, "t\n1.0\n3.5\n2.0\n").unwrap();
    let at = |extra: &[&str]| {
        let args = [text(&input), "--at", text(&times), "-o", text(&output), "--force"];
        interpolate(&[&args[..], extra].concat())
    };
    let refused = at(&[]);
    assert_eq!(code(&refused), 2);
    assert!(
        stderr(&refused).contains("the time 3.5 (line 3 of the times) lies outside the record, 0.00 to 3.00"),
        "{}",
        stderr(&refused)
    );
    assert!(!output.exists());
    let skipped = at(&["--outside", "skip"]);
    assert!(code(&skipped) == 0 && stderr(&skipped).contains("1 time outside"), "{}", stderr(&skipped));
    assert_eq!(rows(&fs::read_to_string(&output).unwrap()).len(), 2);
    assert_eq!(code(&at(&["--outside", "empty"])), 0);
    assert_eq!(rows(&fs::read_to_string(&output).unwrap())[1], ("3.5".into(), None));
    // the mirror stands half a step beyond the last sample: 3.005
    assert_eq!(code(&at(&["--outside", "extend"])), 0);
    let beyond = rows(&fs::read_to_string(&output).unwrap())[1].1.unwrap();
    fs::write(&times, "2.51\n").unwrap();
    assert_eq!(code(&at(&[])), 0);
    let written = fs::read_to_string(&output).unwrap();
    assert!((beyond - rows(&written)[0].1.unwrap()).abs() < 1e-12);
    assert_eq!(code(&at(&["--outside", "guess"])), 2);
}

#[test]
fn long_gaps_are_not_filled() {
    let kept = table(1).lines().next().unwrap().to_owned() + "\n";
    let body: String = table(601)
        .lines()
        .skip(1)
        .enumerate()
        .filter(|(k, _)| !(200..260).contains(k))
        .map(|(_, l)| l.to_owned() + "\n")
        .collect();
    let (_folder, input, output) = folder(&(kept + &body));
    let refused = interpolate(&[text(&input), "--every", "0.1", "-o", text(&output)]);
    assert_eq!(code(&refused), 2);
    assert!(stderr(&refused).contains("2.00 lies in the gap between 1.99 and 2.60"), "{}", stderr(&refused));
    let done = interpolate(&[text(&input), "--every", "0.1", "--outside", "skip", "-o", text(&output)]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    let rows = rows(&fs::read_to_string(&output).unwrap());
    assert_eq!(rows.len(), 61 - 6);
    assert!(
        stdout(&done).contains("0.00 to 1.99, 200 samples") && stdout(&done).contains("2.60 to 6.00"),
        "{}",
        stdout(&done)
    );
}

#[test]
fn bad_wishes_and_bad_tables_are_one_sentence_and_nothing_is_written() {
    let (folder, input, output) = folder("");
    let times = folder.path().join("times.csv");
    let good = table(101);
    for (content, args, message) in [
        (good.as_str(), &["--every", "0"][..], "must be greater than zero, got 0"),
        (&good, &["--every", "-1"], "must be greater than zero, got -1"),
        (&good, &["--every", "1e-300"], "the number of times asked for overflows"),
        (&good, &["--every", "soon"], "\"soon\" is no number"),
        (&good, &["--every", "1", "--at", "x.csv"], "cannot be used with"),
        (&good, &[], "<--at <TIMES.csv>|--every <DT>>"),
        (&good, &["--every", "1", "--method", "spline"], "no method is called \"spline\""),
        (&good, &["--every", "1", "--edge", "loop"], "no edge is called \"loop\""),
        (&good, &["--every", "1", "--band", "50"], "at this rate must lie between 0 and 49.95"),
        (&good, &["--every", "1", "--column", "I"], "no column is called \"I\"; known: "),
        (&good, &["--at", "missing.csv"], "missing.csv"),
        ("t,v\n0,1\n1,oops\n2,2\n", &["--every", "1"], "line 3, column 2 (v): \"oops\" is no number"),
        ("t,v\n0,1\n1,1e999\n", &["--every", "1"], "line 3, column 2 (v): \"1e999\" is too large"),
        ("t,v\n0,1\n1,\n2,2\n", &["--every", "1"], "line 3, column 2 (v): the cell is empty (--skip-missing"),
        ("t,v\n0,1\n1\n", &["--every", "1"], "line 3: 1 cell, but 2 in the first line"),
        ("t,v\n0,1\n", &["--every", "1"], "at least 2 needed, got 1"),
        ("t,v\n1,1\n1,2\n1,3\n", &["--every", "1"], "all are the same"),
        ("t,v\n", &["--every", "1"], "a header and no row"),
        ("", &["--every", "1"], "blank lines"),
        ("v\n1\n2\n", &["--every", "1"], "--dt says how many seconds"),
        ("\u{feff}", &["--every", "1"], "blank lines"),
    ] {
        fs::write(&input, content).unwrap();
        let done = interpolate(&[&[text(&input)], args, &["-o", text(&output)]].concat());
        assert_eq!(code(&done), 2, "{args:?}");
        assert!(stderr(&done).contains(message), "{args:?}: {}", stderr(&done));
        assert!(done.stdout.is_empty() && !output.exists(), "{args:?}");
    }
    fs::write(&input, &good).unwrap();
    for (content, message) in [
        ("t\n0.5\nnoon\n", "times.csv: line 3, column 1 (t): \"noon\" is no number"),
        ("t\n", "a header and no row"),
        ("t\n0.5\n7\n", "the time 7 (line 3 of the times) lies outside"),
        ("t\n1e999\n", "is too large"),
    ] {
        fs::write(&times, content).unwrap();
        let done = interpolate(&[text(&input), "--at", text(&times), "-o", text(&output)]);
        assert!(code(&done) == 2 && stderr(&done).contains(message), "{content:?}: {}", stderr(&done));
        assert!(!output.exists());
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2, "no temporary file is left");
}

#[test]
fn inputs_are_never_overwritten_and_outputs_only_by_force() {
    let (folder, input, output) = folder(&table(101));
    let own = interpolate(&[text(&input), "--every", "0.5", "-o", text(&input), "--force"]);
    assert!(code(&own) == 2 && stderr(&own).contains("never overwritten"), "{}", stderr(&own));
    let times = folder.path().join("times.csv");
    fs::write(&times, "0.5\n").unwrap();
    let other = interpolate(&[text(&input), "--at", text(&times), "-o", text(&times), "--force"]);
    assert!(code(&other) == 2 && stderr(&other).contains("never overwritten"), "{}", stderr(&other));
    fs::write(&output, "precious").unwrap();
    let refused = interpolate(&[text(&input), "--every", "0.5", "-o", text(&output)]);
    assert!(code(&refused) == 2 && stderr(&refused).contains("--force"));
    assert_eq!(fs::read_to_string(&output).unwrap(), "precious");
    assert_eq!(code(&interpolate(&[text(&input), "--every", "0.5", "-o", text(&output), "--force"])), 0);
    assert_ne!(fs::read_to_string(&output).unwrap(), "precious");
}

#[test]
fn values_without_times_are_so_many_seconds_apart() {
    let values: String = (0..401).map(|k| format!("{}\n", signal(f64::from(k) / 100.0))).collect();
    let (_folder, input, output) = folder(&format!("U [V]\n{values}"));
    let done = interpolate(&[text(&input), "--dt", "1/100", "--every", "0.125", "-o", text(&output)]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    let written = fs::read_to_string(&output).unwrap();
    assert!(written.starts_with("t [s],U [V]\n0"), "{written}");
    let there = &rows(&written)[16];
    assert!(there.0 == "2.000" && (there.1.unwrap() - signal(2.0)).abs() < 1e-9, "{there:?}");
    assert_eq!(code(&interpolate(&[text(&input), "--dt", "0", "--every", "1", "-o", "-"])), 2);
}

#[test]
fn what_is_put_right_is_said() {
    let shuffled = "t,v\n0,1\n2,3\n1,2\n3,4\n3,6\n4,\n5,6\n6,7\n7,8\n8,9\n9,1\n10,2\n11,3\n12,4\n13,5\n14,6\n";
    let (_folder, input, output) = folder(shuffled);
    let done = interpolate(&[text(&input), "--skip-missing", "--every", "1", "-o", text(&output)]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    for said in [
        "1 row with missing values left out, the first on line 7",
        "1 row is earlier",
        "first on line 4",
        "stood there before, the first on line 6",
    ] {
        assert!(stderr(&done).contains(said), "{said}: {}", stderr(&done));
    }
    let rows = rows(&fs::read_to_string(&output).unwrap());
    assert_eq!(rows.len(), 15);
    fs::write(&input, b"t;T [\xb0C]\n0;1\n1;2\n2;1\n").unwrap();
    let done = interpolate(&[text(&input), "--every", "1", "-o", "-"]);
    assert!(stderr(&done).contains("Latin-1") && stdout(&done).starts_with("t;T [°C]\n"), "{}", stdout(&done));
}

#[test]
fn pictures_and_sounds_are_told_to_be_none_of_numbers() {
    let (_folder, input, output) = folder("");
    for (bytes, message) in [
        (&b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR"[..], "this is a picture (PNG or JPEG), and no table"),
        (b"RIFF\x24\0\0\0WAVEfmt ", "this is a sound (WAV), and no table"),
        (b"\x7fELF\x02\x01\x01\0\0\0", "nor text, by its first bytes"),
    ] {
        fs::write(&input, bytes).unwrap();
        let done = interpolate(&[text(&input), "--every", "1", "-o", text(&output)]);
        assert!(code(&done) == 2 && stderr(&done).contains(message), "{message}: {}", stderr(&done));
    }
}

#[test]
fn options_without_effect_are_refused() {
    let (_folder, input, output) = folder(&table(101));
    let random: String =
        (0..40).map(|k| format!("{:.4},{}\n", uniform(2, k, 0) + f64::from(k as u32 / 2), k % 7)).collect();
    for (args, message) in [
        (&["--method", "periodic", "--edge", "zero"][..], "--edge has no effect on the method periodic"),
        (&["--method", "periodic", "--band", "3"], "--band has no effect on the method periodic"),
        (&["--method", "kaiser", "--most-condition", "9"], "--most-condition has no effect on the method kaiser"),
        (&["--most-condition", "9"], "--most-condition has no effect on the method kaiser"),
        (&["--most-condition", "nan"], "\"nan\" is no number from one on"),
    ] {
        let done = interpolate(&[&[text(&input), "--every", "0.5", "-o", text(&output)], args].concat());
        assert!(code(&done) == 2 && stderr(&done).contains(message), "{args:?}: {}", stderr(&done));
        assert!(!output.exists());
    }
    // and where it has one, it is felt
    fs::write(&input, format!("t,v\n{random}")).unwrap();
    let at = |most: &str| {
        let args = ["--band", "0.8", "--most-condition", most, "--every", "1", "-o", text(&output), "--force"];
        interpolate(&[&[text(&input)], &args[..]].concat())
    };
    let (strict, lax) = (at("2"), at("1e9"));
    assert!(stderr(&strict).contains("above the allowed 2.000e0"), "{}", stderr(&strict));
    let said = stderr(&lax) + &stdout(&lax);
    assert!(!said.contains("inf") && said.contains("at least"), "{said}");
}
