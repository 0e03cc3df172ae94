//! `nyquist check` and `nyquist spectrum` of pictures as a user meets them.

use crate::running::{code, nyquist, stderr, stdout, text};
use nyquist::prelude::*;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

fn photograph() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data/camera.png")
}

/// A folder with a picture of 16 bits in it, and its name.
fn picture(width: usize, height: usize, f: impl Fn(f64, f64) -> f64) -> (TempDir, PathBuf) {
    let folder = TempDir::new().expect("a temporary folder");
    let file = folder.path().join("in.png");
    let image = Image::of(&field_fn(f), Grid::pixels(width, height).expect("small"));
    fs::write(&file, png_bytes(&image.into(), Depth::Sixteen).expect("a picture")).expect("written");
    (folder, file)
}

fn stripes(x: f64, y: f64) -> f64 {
    0.4 + 0.2 * (std::f64::consts::TAU * (0.35 * x + 0.12 * y)).cos()
}

fn json(args: &[&str]) -> (i32, Value) {
    let output = nyquist(args);
    (code(&output), serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{}", stderr(&output))))
}

#[test]
fn the_moiré_of_a_grating_is_predicted_and_the_advice_is_good() {
    let (folder, file) = picture(256, 256, stripes);
    let (exit, report) = json(&["check", text(&file), "--scale", "0.25", "--json"]);
    assert_eq!((exit, report["fine"].as_bool()), (1, Some(false)));
    let shrinking = &report["shrinking"];
    let grating = &shrinking["gratings"][0];
    assert!((grating["contrast"].as_f64().unwrap() - 0.5).abs() < 1e-4);
    let plain = &shrinking["filters"][0];
    assert_eq!(plain["filter"], "none");
    // −1.4, −0.48 folds to −0.4, −0.48
    let place = &plain["moires"][0]["frequency"];
    assert!((place[0].as_f64().unwrap() + 0.4).abs() < 1e-4 && (place[1].as_f64().unwrap() + 0.48).abs() < 1e-4);
    assert!((grating["found"]["none"].as_f64().unwrap() - 0.5).abs() < 0.01);
    // what is advised is done, and checked again at the new size: no grating is left that was not there
    let best = shrinking["best"].as_str().expect("some filter is fine");
    let small = folder.path().join("small.png");
    let done = nyquist(&["resize", text(&file), text(&small), "--scale", "0.25", "--filter", best, "--bits", "16"]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    let light = read_picture("small", &fs::read(&small).unwrap(), Limits::default()).unwrap().luminance();
    let spread = light.map(|v| (v / 0.4 - 1.0).abs());
    let inner = (8..56).flat_map(|y| (8..56).map(move |x| (x, y))).map(|(x, y)| spread.at(x, y)).fold(0.0, f64::max);
    assert!(inner <= 0.01, "{best}: {inner}");
    // judged by that filter it is fine
    let (exit, report) = json(&["check", text(&file), "--scale", "0.25", "--filter", best, "--json"]);
    assert_eq!((exit, report["judged"].as_str()), (0, Some(best)));
    // and so is a blur
    let sigma = shrinking["blur"].as_f64().expect("a blur is enough").to_string();
    let blurred = folder.path().join("blurred.png");
    let args = [
        "resize",
        text(&file),
        text(&blurred),
        "--scale",
        "0.25",
        "--filter",
        "none",
        "--blur",
        &sigma,
        "--bits",
        "16",
    ];
    assert_eq!(code(&nyquist(&args)), 0);
    let light = read_picture("blurred", &fs::read(&blurred).unwrap(), Limits::default()).unwrap().luminance();
    let inner = (8..56).flat_map(|y| (8..56).map(move |x| (x, y))).map(|(x, y)| (light.at(x, y) / 0.4 - 1.0).abs());
    assert!(inner.fold(0.0, f64::max) <= 0.0105);
}

#[test]
fn what_is_printed_says_what_to_do_in_both_languages() {
    let (_folder, file) = picture(256, 256, stripes);
    for (lang, words) in [
        ("en", ["cycles/pixel", "no filter", "plain decimation", "in.png OUT.png --width 64 --height 64 --filter"]),
        (
            "ru",
            ["периодов на пиксель", "без фильтра", "прореживание", "in.png OUT.png --width 64 --height 64 --filter"],
        ),
    ] {
        let output = nyquist(&["check", text(&file), "--scale", "0.25", "--lang", lang]);
        assert_eq!(code(&output), 1, "{}", stderr(&output));
        for word in words {
            assert!(stdout(&output).contains(word), "{word}: {}", stdout(&output));
        }
    }
}

#[test]
fn a_tolerance_and_a_scale_decide() {
    let (_folder, file) = picture(256, 256, stripes);
    let exit = |more: &[&str]| code(&nyquist(&[&["check", text(&file)], more].concat()));
    assert_eq!(exit(&[]), 0, "nothing is asked for");
    assert_eq!(exit(&["--scale", "1"]), 0, "nothing folds");
    assert_eq!(exit(&["--scale", "0.9,1", "--filter", "lanczos-3"]), 0, "0.35 is below 0.45");
    assert_eq!(exit(&["--scale", "0.9,1"]), 1, "without a filter a broken factor leaves images");
    assert_eq!(exit(&["--scale", "0.5,1"]), 1);
    assert_eq!(exit(&["--scale", "1,0.5"]), 0, "0.12 is below 0.25");
    assert_eq!(exit(&["--scale", "2"]), 0);
    assert_eq!(exit(&["--scale", "0.25", "--filter", "b-spline"]), 0);
    assert_eq!(exit(&["--scale", "0.25", "--filter", "b-spline", "--tolerance", "150"]), 1);
}

#[test]
fn reports_are_written_in_every_form_and_never_over_something() {
    let (folder, file) = picture(96, 64, stripes);
    for (name, starts) in
        [("r.svg", "<svg"), ("r.png", "\u{fffd}PNG"), ("r.pdf", "%PDF"), ("r.html", "<!DOCTYPE html>")]
    {
        let report = folder.path().join(name);
        for (theme, lang) in [("light", "en"), ("dark", "ru")] {
            let args = [
                "check",
                text(&file),
                "--scale",
                "0.5",
                "-o",
                text(&report),
                "--theme",
                theme,
                "--lang",
                lang,
                "--force",
            ];
            assert_eq!(code(&nyquist(&args)), 1);
            let bytes = fs::read(&report).unwrap();
            assert!(String::from_utf8_lossy(&bytes[..20]).starts_with(starts), "{name}");
        }
        let again = nyquist(&["check", text(&file), "-o", text(&report)]);
        assert!(code(&again) == 2 && stderr(&again).contains("--force"));
    }
}

#[test]
fn nonsense_is_one_sentence() {
    let (_folder, file) = picture(32, 32, stripes);
    let file = text(&file);
    for (args, words) in [
        (&["check", file, "--scale", "0"][..], "greater than zero"),
        (&["check", file, "--scale", "nan"], "greater than zero"),
        (&["check", file, "--scale", "half"], "\"half\" is no number"),
        (&["check", file, "--scale", "1,2,3"], "is no number"),
        (&["check", file, "--scale", "1e9"], "would be more than"),
        (&["check", file, "--scale", "0.5", "--tolerance", "nan"], "the tolerance in dB must be finite"),
        (&["check", file, "--scale", "0.5", "--filter", "lanczos"], "known: lanczos-"),
        (&["check", file, "--scale", "0.5", "--filter", "ideal"], "needs every pixel"),
        (&["check", file, "--scale", "0.5", "--filter", "nome"], "known: none, "),
        (&["check", file, "--scale", "0.5", "--max-pixels", "NaN"], "room for a pixel"),
        (&["check", file, "--filter", "box"], "--scale"),
        (&["spectrum", file, "-o", "x.bmp"], "a spectrum ends with"),
        (&["spectrum", file, "-o", "x.csv", "--border", "han"], "known: hann"),
        (&["spectrum", "/no/such.png", "-o", "x.csv"], "/no/such.png"),
    ] {
        let output = nyquist(args);
        assert_eq!(code(&output), 2, "{args:?}: {}", stdout(&output));
        assert!(stderr(&output).contains(words), "{args:?}: {}", stderr(&output));
        assert!(output.stdout.is_empty(), "{args:?}");
    }
}

#[test]
fn pictures_of_any_kind_can_be_checked() {
    for name in
        ["rgb8-alpha.png", "palette.png", "grey16.png", "bits1.png", "ramp.jpg", "ramp-sideways.jpg", "linear8.png"]
    {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/pictures").join(name);
        let output = nyquist(&["check", text(&file), "--scale", "0.5", "--json"]);
        assert!(code(&output) <= 1, "{name}: {}", stderr(&output));
        let report: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        assert_eq!(report["kind"], "picture");
    }
    for (w, h) in [(1, 1), (1, 40), (40, 1), (3, 3)] {
        let (folder, file) = picture(w, h, stripes);
        let svg = folder.path().join("r.svg");
        let output = nyquist(&["check", text(&file), "--scale", "0.5", "-o", text(&svg)]);
        assert!(code(&output) <= 1, "{w} × {h}: {}", stderr(&output));
        let output = nyquist(&["spectrum", text(&file), "-o", "-"]);
        assert_eq!(code(&output), 0, "{w} × {h}: {}", stderr(&output));
    }
    let (_folder, even) = picture(40, 30, |_, _| 0.3);
    let output = nyquist(&["check", text(&even), "--scale", "0.5"]);
    assert!(code(&output) == 0 && stdout(&output).contains("All pixels are equal"), "{}", stdout(&output));
}

#[test]
fn a_spectrum_as_numbers_adds_up_to_the_variance() {
    let photograph = photograph();
    let light = nyquist::door::open_picture(&photograph, Limits::default()).unwrap().luminance();
    let mean = light.mean();
    let variance = light.values().iter().map(|v| (v - mean).powi(2)).sum::<f64>() / light.values().len() as f64;
    let sum = |border: &str| {
        let output = nyquist(&["spectrum", text(&photograph), "-o", "-", "--plane", "--border", border]);
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        let csv = stdout(&output);
        assert!(csv.starts_with("u [cycles/px],v [cycles/px],power [white^2 px^2]\n"));
        let powers = csv.lines().skip(1).map(|line| line.rsplit(',').next().unwrap().parse::<f64>().unwrap());
        powers.sum::<f64>() / (512.0 * 512.0)
    };
    // Parseval, without a window; the smooth component takes what differs from side to side
    assert!((sum("none") / variance - 1.0).abs() < 1e-9);
    assert!((0.4..1.1).contains(&(sum("periodic") / variance)));
    let rings = nyquist(&["spectrum", text(&photograph), "-o", "-"]);
    let lines: Vec<String> = stdout(&rings).lines().map(str::to_owned).collect();
    assert_eq!(lines[0], "frequency [cycles/px],power [white^2 px^2],bins");
    assert!(lines.len() > 250);
    let bins: f64 = lines[1..].iter().map(|line| line.rsplit(',').next().unwrap().parse::<f64>().unwrap()).sum();
    // the disc of radius ½ has π/4 of all bins
    assert!((bins / (512.0 * 512.0) / std::f64::consts::FRAC_PI_4 - 1.0).abs() < 0.02, "{bins}");
}

#[test]
fn a_spectrum_is_drawn_in_both_languages_and_themes() {
    let folder = TempDir::new().unwrap();
    for (lang, theme) in [("en", "light"), ("ru", "dark")] {
        let svg = folder.path().join(format!("{lang}.svg"));
        let args =
            ["spectrum", &photograph().display().to_string(), "-o", text(&svg), "--lang", lang, "--theme", theme];
        let output = nyquist(&args);
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        assert!(fs::read_to_string(&svg).unwrap().starts_with("<svg"));
    }
    let json = folder.path().join("s.json");
    assert_eq!(code(&nyquist(&["spectrum", text(&photograph()), "-o", text(&json)])), 0);
    let report: Value = serde_json::from_slice(&fs::read(&json).unwrap()).unwrap();
    assert_eq!((report["size"][0].as_u64(), report["light"].as_str()), (Some(512), Some("linear")));
}

#[test]
fn what_is_found_beside_a_prediction_says_why_it_differs() {
    let photograph = photograph();
    // texture of the photograph lands where its grating does
    for scale in ["0.25", "0.5"] {
        let (_, report) = json(&["check", text(&photograph), "--scale", scale, "--json"]);
        let gratings = report["shrinking"]["gratings"].as_array().unwrap();
        let fine = gratings.iter().find(|g| (g["frequency"][0].as_f64().unwrap() - 0.313).abs() < 1e-3).unwrap();
        // by more than a fifth, to which a grating is even
        assert!(0.8 * fine["found"]["none"].as_f64().unwrap() > fine["alone"]["none"].as_f64().unwrap(), "{fine}");
        assert_eq!(fine["differs"]["none"], "more: texture lands there as well");
        // and what folds to zero is no moiré
        let plain = &report["shrinking"]["filters"][0];
        assert_eq!((plain["moires"][0]["even"].as_bool(), plain["moires"][0]["period"].is_null()), (Some(true), true));
        assert!(plain["contrast"].as_f64().unwrap() < 0.01 && plain["brightness"].as_f64().unwrap() > 0.02);
    }
    for (lang, words, even) in [
        ("en", "more: texture lands there as well", "becomes an even change of brightness"),
        ("ru", "больше: туда же попадает текстура", "становится ровным изменением яркости"),
    ] {
        let said = stdout(&nyquist(&["check", text(&photograph), "--scale", "0.25", "--lang", lang]));
        assert!(said.contains(words) && said.contains(even), "{said}");
    }
    // a whole ratio has nothing to say of a pure grating, and one that slips has
    let (_folder, file) = picture(256, 256, stripes);
    for (scale, differs) in [("0.25", Value::Null), ("0.333333333,0.3", "ratio not whole".into())] {
        let (_, report) = json(&["check", text(&file), "--scale", scale, "--filter", "none", "--json"]);
        let grating = &report["shrinking"]["gratings"][0];
        assert_eq!(grating["differs"]["none"], differs, "{grating}");
        let [found, alone] = ["found", "alone"].map(|name| grating[name]["none"].as_f64().unwrap());
        assert!((found / alone - 1.0).abs() < 0.01, "{grating}");
    }
}

#[test]
fn enlarging_has_a_sentence_of_its_own() {
    let (_folder, file) = picture(64, 64, stripes);
    let said = stdout(&nyquist(&["check", text(&file), "--scale", "2"]));
    assert!(
        said.contains("nothing aliases") && !said.contains("decimated") && !said.contains("what would alias"),
        "{said}"
    );
}

#[test]
fn commands_to_copy_have_the_name_of_the_file() {
    let (folder, file) = picture(64, 64, stripes);
    let spaced = folder.path().join("two words.png");
    fs::copy(&file, &spaced).unwrap();
    let said = stdout(&nyquist(&["check", text(&spaced), "--scale", "0.25"]));
    assert!(said.contains(&format!("nyquist resize '{}' OUT.png --width 16", text(&spaced))), "{said}");
}
