//! `nyquist render` as a user meets it: pictures, reports, refusals.

use crate::running::{code, run, stderr, stdout};
use nyquist::prelude::*;
use std::fs;
use std::process::{Command, Output};

fn render(args: &[&str]) -> Output {
    run("render", args)
}

const SMALL: [&str; 6] = ["--width", "24", "--height", "16", "--spp", "4"];

#[test]
fn every_scene_becomes_a_picture_of_the_size_asked_for() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for entry in nyquist::scene::catalog::all() {
        let file = folder.path().join(entry.name).with_extension("png");
        let output = render(&[&[entry.name, "-o", file.to_str().expect("text")], &SMALL[..]].concat());
        assert_eq!(code(&output), 0, "{}: {}", entry.name, stderr(&output));
        assert!(stdout(&output).contains("24 × 16, 4 samples a pixel (padded, mitchell)"), "{}", stdout(&output));
        let picture = read_picture(entry.name, &fs::read(&file).expect("written"), Limits::default()).expect("a PNG");
        let grey = picture.luminance();
        assert_eq!((grey.width(), grey.height()), (24, 16));
        let (low, high) = grey.values().iter().fold((1.0f64, 0.0f64), |(l, h), &v| (l.min(v), h.max(v)));
        assert!(high - low > 0.05, "{}: something is to be seen", entry.name);
    }
    let left = fs::read_dir(folder.path()).expect("readable").count();
    assert_eq!(left, nyquist::scene::catalog::all().len(), "no temporary file is left");
}

#[test]
fn the_same_seed_makes_the_same_bytes_for_any_number_of_threads_and_another_seed_others() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let bytes = |name: &str, options: &[&str]| {
        let file = folder.path().join(name);
        let output = render(&[&["spheres", "-o", file.to_str().expect("text")], &SMALL[..], options].concat());
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        fs::read(&file).expect("written")
    };
    let one = bytes("one.png", &["--threads", "1"]);
    assert_eq!(one, bytes("three.png", &["--threads", "3"]));
    assert_ne!(one, bytes("other.png", &["--seed", "2"]));
}

#[test]
fn the_report_says_what_was_used() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("a.png");
    let options = ["--pattern", "sobol-owen", "--filter", "box", "--json"];
    let output = render(&[&["defocus", "-o", file.to_str().expect("text")], &SMALL[..], &options].concat());
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).expect("well-formed JSON");
    for (key, value) in [("scene", "defocus"), ("pattern", "sobol-owen"), ("filter", "box")] {
        assert_eq!(report[key], value);
    }
    assert_eq!((report["spp"].as_u64(), report["width"].as_u64()), (Some(4), Some(24)));
    assert!(report["seconds"].as_f64().expect("a number") >= 0.0);
}

#[test]
fn what_cannot_be_rendered_is_refused_with_the_reason_and_nothing_is_written() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("a.png");
    let file = file.to_str().expect("the path is text");
    let beyond = folder.path().join("nowhere/a.png");
    for (args, says) in [
        (&["sphere", "-o", file][..], "known: spheres"),
        (&["spheres", "-o", file, "--pattern", "paded"], "known: padded"),
        (&["spheres", "-o", file, "--filter", "michell"], "known: mitchell"),
        (&["spheres", "-o", file, "--spp", "0"], "at least 1 needed, got 0"),
        (&["spheres", "-o", file, "--spp", "10"], "10 is impossible; the nearest numbers are 9 and 16"),
        (&["spheres", "-o", file, "--spp", "99999999999"], "overflows"),
        (&["spheres", "-o", file, "--filter", "ideal"], "infinite radius"),
        (&["spheres", "-o", file, "--filter", "lanczos-4000"], "must lie between 0 and 32, got 4000"),
        (&["spheres", "-o", file, "--width", "0"], "at least 1 needed, got 0"),
        (&["spheres", "-o", file, "--height", "0"], "at least 1 needed, got 0"),
        (&["spheres", "-o", file, "--width", "4294967296", "--height", "4294967296"], "overflows"),
        (&["spheres", "-o", file, "--width", "1000000", "--height", "1000"], "overflows"),
        (&["spheres", "-o", file, "--width", "1000000", "--height", "1", "--spp", "10000"], "overflows"),
        (&["spheres", "-o", file, "--width=-3"], "--width"),
        (&["spheres", "-o", file, "--threads", "0"], "--threads"),
        (&["spheres", "-o", beyond.to_str().expect("text")], "its folder does not exist"),
        (&["spheres", "-o", folder.path().to_str().expect("text")], "does not end with .png"),
        (&["spheres"], "--out"),
    ] {
        let output = render(args);
        assert_eq!(code(&output), 2, "{args:?}: {}", stderr(&output));
        assert!(stderr(&output).contains(says), "{args:?}: {}", stderr(&output));
        assert!(output.stdout.is_empty(), "{args:?}");
    }
    assert_eq!(fs::read_dir(folder.path()).expect("readable").count(), 0);
}

#[test]
fn a_file_that_is_there_is_replaced_only_by_force() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("a.png");
    fs::write(&file, "precious").expect("written");
    let args = [&["star", "-o", file.to_str().expect("text")], &SMALL[..]].concat();
    let output = render(&args);
    assert_eq!(code(&output), 2);
    assert!(stderr(&output).contains("--force"), "{}", stderr(&output));
    assert_eq!(fs::read_to_string(&file).expect("still there"), "precious");
    assert_eq!(code(&render(&[&args[..], &["--force"]].concat())), 0);
    assert!(fs::read(&file).expect("written").starts_with(b"\x89PNG"));
}

#[test]
fn the_list_names_what_can_be_rendered_in_both_languages_and_as_json() {
    let [en, ru] = ["en", "ru"].map(|lang| stdout(&render(&["--list", "--lang", lang])));
    assert!(en.contains("moving spheres") && ru.contains("движущиеся шары"));
    assert!(en.contains("padded") && en.contains("mitchell") && !en.contains("ideal"));
    let json: serde_json::Value = serde_json::from_slice(&render(&["--list", "--json"]).stdout).expect("JSON");
    let scenes = json["scenes"].as_array().expect("scenes");
    assert_eq!(scenes.len(), nyquist::scene::catalog::all().len());
    assert!(scenes.iter().all(|s| s["about"]["ru"].is_string()));
}

#[cfg(unix)]
#[test]
fn what_is_no_plain_file_is_never_replaced_not_even_by_force() {
    use std::os::unix::fs::FileTypeExt;
    let folder = tempfile::tempdir().expect("a temporary folder");
    let pipe = folder.path().join("pipe.png");
    assert!(Command::new("mkfifo").arg(&pipe).status().expect("mkfifo starts").success());
    let output = render(&[&["spheres", "--force", "-o", pipe.to_str().expect("text")], &SMALL[..]].concat());
    assert_eq!(code(&output), 2);
    assert!(stderr(&output).contains("is not a file that could be replaced"), "{}", stderr(&output));
    assert!(fs::metadata(&pipe).expect("still there").file_type().is_fifo());
}

#[test]
fn the_name_says_png_and_a_minus_is_standard_output() {
    let output = render(&[&["spheres", "-o", "picture.jpg"], &SMALL[..]].concat());
    assert!(code(&output) == 2 && stderr(&output).contains("picture.jpg does not end with .png"));
    let output = render(&[&["spheres", "-o", "-"], &SMALL[..]].concat());
    assert_eq!(code(&output), 0);
    assert!(read_picture("-", &output.stdout, Limits::default()).is_ok());
}
