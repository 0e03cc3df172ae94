//! The command line as a user meets it: exit codes, messages, files.

use crate::running::{code, nyquist, stderr};
use std::fs;
use std::path::Path;
use std::process::Command;

#[test]
fn a_figure_is_written_in_every_format_and_language_and_the_exit_code_is_zero() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = folder.path().to_str().expect("the path is text");
    let output = nyquist(&["figures", "f28-leak", "--out", out]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    for lang in ["en", "ru"] {
        for (format, magic) in [("svg", "<svg"), ("png", "\u{fffd}PNG"), ("pdf", "%PDF-")] {
            let bytes = fs::read(folder.path().join(lang).join(format!("f28-leak.{format}"))).expect("written");
            let head = String::from_utf8_lossy(&bytes[..bytes.len().min(400)]).into_owned();
            assert!(head.contains(magic), "{lang} {format} begins with {head}");
        }
    }
    let left: Vec<_> = fs::read_dir(folder.path().join("en")).expect("readable").flatten().collect();
    assert_eq!(left.len(), 3, "no temporary file is left: {left:?}");
}

#[test]
fn another_step_makes_another_picture_beside_the_lectures_own() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = folder.path().to_str().expect("the path is text");
    let args = ["f28-leak", "--set", "T=0.9", "--out", out, "--format", "svg", "--lang", "en"];
    assert_eq!(code(&nyquist(&args)), 0);
    assert_eq!(code(&nyquist(&["f28-leak", "--out", out, "--format", "svg", "--lang", "en"])), 0);
    let read = |name: &str| fs::read(folder.path().join("en").join(name)).expect("written");
    assert_ne!(read("f28-leak@T=0.9.svg"), read("f28-leak.svg"));
}

#[test]
fn every_layer_can_be_had_as_numbers() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = folder.path().to_str().expect("the path is text");
    assert_eq!(code(&nyquist(&["f28-leak", "--data", "--out", out, "--format", "svg"])), 0);
    let csv = fs::read_to_string(folder.path().join("data/f28-leak/space.samples.csv")).expect("written");
    let rows: Vec<&str> = csv.lines().collect();
    assert_eq!((rows[0], rows.len()), ("x,y", 6));
    let json = fs::read_to_string(folder.path().join("data/f28-leak.json")).expect("written");
    let json: serde_json::Value = serde_json::from_str(&json).expect("well-formed JSON");
    assert_eq!(json["panels"][1]["layers"][2]["rows"].as_array().expect("rows").len(), 5);
}

#[test]
fn the_list_as_json_has_captions_panels_and_measured_claims() {
    let output = nyquist(&["figures", "F28", "--list", "--json"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let list: serde_json::Value = serde_json::from_slice(&output.stdout).expect("well-formed JSON");
    let figure = &list[0];
    assert_eq!(figure["id"], "f28-leak");
    assert_eq!(figure["inventory"][0], "F28");
    for lang in ["en", "ru"] {
        assert!(figure["title"][lang].is_string() && figure["caption"][lang].is_string());
    }
    assert_eq!(figure["panels"].as_array().expect("panels").len(), 2);
    for claim in figure["claims"].as_array().expect("claims") {
        assert!(claim["law"].is_string() && claim["bound"].is_number() && claim["holds"] == true, "{claim}");
        assert!(claim["measured"].as_f64().expect("a number") <= claim["bound"].as_f64().expect("a number"));
    }
}

#[test]
fn unknown_names_are_errors_that_list_the_known_ones_with_the_nearest_first() {
    for (args, nearest) in [
        (&["figures", "f28-leek"][..], "known: f28-leak"),
        (&["laws", "alias-enrgy"], "known: alias-energy"),
        (&["kernel", "michell"], "known: mitchell"),
        (&["figures", "f28-leak", "--format", "pgn"], "known: png"),
        (&["figures", "f28-leak", "--lang", "rus"], "known: ru"),
        (&["figures", "f28-leak", "--theme", "drak"], "known: dark"),
        (&["figures", "f28-leak", "--set", "t=1"], "known: T"),
    ] {
        let output = nyquist(args);
        assert_eq!(code(&output), 2, "{args:?}");
        assert!(stderr(&output).contains(nearest), "{args:?}: {}", stderr(&output));
        assert!(output.stdout.is_empty(), "{args:?}");
    }
}

#[test]
fn values_out_of_range_are_errors_that_name_the_range() {
    for value in ["9", "-1", "NaN", "inf", "one", ""] {
        let output = nyquist(&["f28-leak", "--set", &format!("T={value}")]);
        assert_eq!(code(&output), 2, "T={value}");
        assert!(stderr(&output).contains('T'), "T={value}: {}", stderr(&output));
    }
    let output = nyquist(&["f28-leak", "--set", "T=9"]);
    assert!(stderr(&output).contains("between 0.5 and 2"), "{}", stderr(&output));
}

#[test]
fn zero_jobs_is_an_error() {
    let output = nyquist(&["figures", "f28-leak", "--jobs", "0"]);
    assert_eq!(code(&output), 2);
    assert!(stderr(&output).contains("--jobs"), "{}", stderr(&output));
}

#[test]
fn a_folder_that_cannot_be_written_is_named_and_what_is_there_stays() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("occupied");
    fs::write(&file, "precious").expect("written");
    let out = file.to_str().expect("the path is text");
    let output = nyquist(&["f28-leak", "--out", out, "--format", "svg"]);
    assert_eq!(code(&output), 2);
    assert!(stderr(&output).contains("occupied"), "{}", stderr(&output));
    assert_eq!(fs::read_to_string(&file).expect("still there"), "precious");
}

#[test]
fn a_stale_file_fails_the_check_and_a_fresh_one_passes_for_any_number_of_threads() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = folder.path().to_str().expect("the path is text");
    assert_eq!(code(&nyquist(&["f28-leak", "f27-overlap", "--out", out, "--format", "svg", "--jobs", "1"])), 0);
    assert_eq!(code(&nyquist(&["f28-leak", "f27-overlap", "--out", out, "--check", "--jobs", "3"])), 0);
    let picture = folder.path().join("en/f28-leak.svg");
    fs::write(&picture, "<svg/>").expect("written");
    let output = nyquist(&["f28-leak", "--out", out, "--check"]);
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).contains("f28-leak.svg differs"), "{}", stderr(&output));
    assert_eq!(fs::read_to_string(&picture).expect("still there"), "<svg/>", "a check writes nothing");
}

#[test]
fn a_figure_in_motion_is_also_an_animation_where_pixels_are_asked_for() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = folder.path().to_str().expect("the path is text");
    let moving = folder.path().join("en/f03-strobing.apng");
    assert_eq!(code(&nyquist(&["f03-strobing", "--out", out, "--format", "svg", "--lang", "en"])), 0);
    assert!(!moving.exists());
    assert_eq!(code(&nyquist(&["f03-strobing", "--out", out, "--format", "png,svg", "--lang", "en"])), 0);
    let bytes = fs::read(&moving).expect("written");
    assert!(bytes.len() < 1 << 20 && bytes.windows(4).any(|w| w == b"acTL"), "{} bytes", bytes.len());
    assert_eq!(code(&nyquist(&["f03-strobing", "--out", out, "--check", "--lang", "en"])), 0);
    fs::write(&moving, "stale").expect("written");
    let output = nyquist(&["f03-strobing", "--out", out, "--check", "--lang", "en"]);
    assert!(code(&output) == 1 && stderr(&output).contains("f03-strobing.apng differs"), "{}", stderr(&output));
    let output = nyquist(&["f03-strobing", "--list", "--json"]);
    let list: serde_json::Value = serde_json::from_slice(&output.stdout).expect("well-formed JSON");
    // 23.2 spokes a second are 29 in 30 frames of the camera, and each of these is shown in three pieces
    assert_eq!(list[0]["motion"]["frames"], 90);
}

#[test]
fn laws_print_what_was_measured_and_what_is_allowed() {
    let output = nyquist(&["laws", "alias-energy"]);
    assert_eq!(code(&output), 0);
    let table = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(table.contains("measured") && table.contains("allowed") && table.contains('✓'), "{table}");
    let output = nyquist(&["laws", "V07", "--json"]);
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).expect("well-formed JSON");
    assert_eq!(json[0]["name"], "alias-energy");
    assert!(json[0]["checks"].as_array().expect("checks").iter().all(|c| c["holds"] == true));
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_nyquist"))
        .args(["kernel", "mitchell", "--rows", "1000000"])
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .expect("the command starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("the command ends");
    assert_eq!(code(&output), 0, "{}", stderr(&output));
}

#[test]
fn the_readme_names_commands_that_exist() {
    let readme = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md")).expect("readable");
    let commands = readme.lines().filter_map(|line| line.strip_prefix("cargo run --release -- "));
    let mut seen = 0;
    for command in commands {
        let words: Vec<&str> = command.split('#').next().expect("split yields one").split_whitespace().collect();
        let help = nyquist(&[&words[..], &["--help"]].concat());
        assert_eq!(code(&help), 0, "{command}: {}", stderr(&help));
        seen += 1;
    }
    assert!(seen > 3, "the readme shows commands");
}

#[test]
fn a_name_of_the_inventory_means_all_that_cover_it() {
    let ids = |name: &str| {
        let output = nyquist(&["figures", name, "--list"]);
        String::from_utf8_lossy(&output.stdout)
            .lines()
            .map(|l| l[..l.find(' ').unwrap_or(l.len())].to_owned())
            .collect()
    };
    let f13: Vec<String> = ids("F13");
    assert!(f13.contains(&"f13-pairs".to_owned()) && f13.len() > 1, "{f13:?}");
    let output = nyquist(&["laws", "V31", "--json"]);
    let laws: serde_json::Value = serde_json::from_slice(&output.stdout).expect("well-formed JSON");
    assert!(laws.as_array().expect("laws").len() > 5);
}

#[test]
fn one_language_or_the_dark_theme_can_be_checked_alone_and_an_index_is_written_only_for_what_it_shows() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = folder.path().to_str().expect("the path is text");
    for options in [&["--lang", "ru"][..], &["--theme", "dark"]] {
        let write = [&["figures", "--out", out, "--format", "svg"][..], options].concat();
        assert_eq!(code(&nyquist(&write)), 0);
        let check = [&["figures", "--out", out, "--check"][..], options].concat();
        let output = nyquist(&check);
        assert_eq!(code(&output), 0, "{options:?}: {}", stderr(&output));
    }
    assert!(!folder.path().join("index.html").exists());
    fs::write(folder.path().join("ru/f99-stray.svg"), "<svg/>").expect("written");
    let output = nyquist(&["figures", "--out", out, "--check", "--lang", "ru"]);
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).contains("f99-stray.svg belongs to no figure"), "{}", stderr(&output));
}
