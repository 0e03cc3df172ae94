//! `nyquist points` as a user meets it.

use crate::running::{code, run, stderr, stdout, text};
use nyquist::pattern::catalog::by_name;
use std::fs;
use std::process::Output;

fn points(args: &[&str]) -> Output {
    run("points", args)
}

/// The numbers of a table, without its header.
fn rows(csv: &str) -> Vec<Vec<f64>> {
    let numbers = |line: &str| line.split(',').map(|n| n.parse().expect("a number")).collect();
    csv.lines().skip(1).map(numbers).collect()
}

#[test]
fn the_points_are_those_of_the_library_to_the_last_bit() {
    let output = points(&["jittered", "-n", "64", "--seed", "7"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    assert!(stdout(&output).starts_with("x,y\n"));
    let expected = by_name("jittered", 64).expect("64 is a square").points(7);
    assert_eq!(rows(&stdout(&output)), expected.iter().map(|p| p.to_vec()).collect::<Vec<_>>());
}

#[test]
fn a_minus_is_standard_output_too() {
    let [named, unnamed] = [points(&["sobol", "-n", "8", "-o", "-"]), points(&["sobol", "-n", "8"])];
    assert_eq!(stdout(&named), stdout(&unnamed));
    assert_eq!(rows(&stdout(&named)).len(), 8);
}

#[test]
fn any_number_of_dimensions_that_the_pattern_has() {
    for (args, header, count) in [
        (&["halton", "-n", "10", "--dim", "1"][..], "x", 10),
        (&["jittered", "-n", "27", "--dim", "3"], "x,y,z", 27),
        (&["padded", "-n", "16", "--dim", "5"], "x1,x2,x3,x4,x5", 16),
        (&["sobol-owen", "-n", "5", "--dim", "16"], "x1,x2,x3,x4,x5,x6,x7,x8,x9,x10,x11,x12,x13,x14,x15,x16", 5),
    ] {
        let output = points(args);
        assert_eq!(code(&output), 0, "{args:?}: {}", stderr(&output));
        assert_eq!(stdout(&output).lines().next(), Some(header));
        let rows = rows(&stdout(&output));
        assert_eq!(rows.len(), count, "{args:?}");
        assert!(rows.iter().flatten().all(|c| (0.0..1.0).contains(c)), "{args:?}");
    }
}

#[test]
fn bad_wishes_are_errors_that_say_what_is_possible_and_nothing_is_written() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (csv, svg) = (folder.path().join("out.csv"), folder.path().join("out.svg"));
    for (args, message) in [
        (&["jittered", "-n", "1000"][..], "the nearest numbers are 961 and 1024"),
        (&["jittered", "-n", "999", "--dim", "3", "--json"], "the nearest numbers are 729 and 1000"),
        (&["sobol", "-n", "0"], "at least 1 needed, got 0"),
        (&["poisson-disk", "-n", "2"], "at least 3 needed, got 2"),
        (&["sobol", "-n", "99999999999"], "is more than 67108864"),
        (&["halton", "-n", "60000000", "--dim", "16"], "is more than 134217728"),
        (&["jitered", "-n", "16"], "known: jittered"),
        (&["poisson-disk", "-n", "64", "--dim", "3"], "only 2 are possible, not 3"),
        (&["padded", "-n", "16"], "only 5 are possible, not 2"),
        (&["halton", "-n", "16", "--dim", "17"], "between 1 and 16"),
        (&["halton", "-n", "16", "--dim", "0"], "between 1 and 16"),
        (&["jittered:2", "-n", "16"], "between 0 and 1"),
        (&["halton", "-n", "16", "--dim", "3"], "two dimensions"), // of the spectrum
    ] {
        let files = ["-o", text(&csv), "--spectrum", text(&svg)];
        let output = points(&[args, &files[..]].concat());
        assert_eq!(code(&output), 2, "{args:?}");
        assert!(stderr(&output).contains(message), "{args:?}: {}", stderr(&output));
        assert!(output.stdout.is_empty(), "{args:?}");
        assert_eq!(fs::read_dir(folder.path()).expect("readable").count(), 0, "{args:?}");
    }
}

#[test]
fn a_pattern_that_gives_another_number_says_so() {
    let output = points(&["poisson-disk", "-n", "100"]);
    assert_eq!(code(&output), 0);
    let given = rows(&stdout(&output)).len();
    assert!(stderr(&output).contains(&format!("poisson-disk gives {given} points with this seed, not 100")));
}

#[test]
fn files_that_exist_are_replaced_only_by_force() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("precious.csv");
    fs::write(&file, "precious").expect("written");
    let refused = points(&["halton", "-n", "4", "-o", text(&file)]);
    assert_eq!(code(&refused), 2);
    assert!(stderr(&refused).contains("--force"), "{}", stderr(&refused));
    assert_eq!(fs::read_to_string(&file).expect("still there"), "precious");
    // nor are points written where the picture cannot be
    let other = folder.path().join("new.csv");
    let picture = folder.path().join("picture.svg");
    fs::write(&picture, "precious").expect("written");
    assert_eq!(code(&points(&["halton", "-n", "4", "-o", text(&other), "--spectrum", text(&picture)])), 2);
    assert!(!other.exists());
    assert_eq!(code(&points(&["halton", "-n", "4", "-o", text(&file), "--force"])), 0);
    assert_eq!(rows(&fs::read_to_string(&file).expect("written")).len(), 4);
    let folder_itself = points(&["halton", "-n", "4", "-o", text(folder.path()), "--force"]);
    assert_eq!(code(&folder_itself), 2);
}

#[test]
fn the_spectrum_is_drawn_with_the_measures_in_its_title_and_caption() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (csv, svg) = (folder.path().join("points.csv"), folder.path().join("spectrum.svg"));
    let args = ["regular", "-n", "256", "-o", text(&csv), "--spectrum", text(&svg), "--lang", "ru"];
    let output = points(&args);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let drawn = fs::read_to_string(&svg).expect("written");
    assert!(drawn.contains("N = 256: D* = 0,0615, наименьшее расстояние 0,0625"));
    assert!(drawn.contains("среднее радиального спектра"));
    assert_eq!(rows(&fs::read_to_string(&csv).expect("written")).len(), 256);
    assert_eq!(fs::read_dir(folder.path()).expect("readable").count(), 2, "no temporary file is left");
    let unknown = points(&["regular", "-n", "16", "--spectrum", text(&folder.path().join("spectrum.bmp"))]);
    assert_eq!(code(&unknown), 2);
    assert!(stderr(&unknown).contains("svg"), "{}", stderr(&unknown));
    assert!(unknown.stdout.is_empty());
}

#[test]
fn the_measures_as_json() {
    let output = points(&["regular", "-n", "256", "--json"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).expect("well-formed JSON");
    assert_eq!(json["points"], 256);
    assert_eq!(json["star_discrepancy"], 0.0615234375);
    assert_eq!(json["least_distance"], 0.0625);
    assert!(json["spectrum"]["rings"].as_array().is_some_and(|rings| rings.len() > 8));
    let output = points(&["random", "-n", "100", "--dim", "4", "--json"]);
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).expect("well-formed JSON");
    assert!(json["star_discrepancy"].is_null() && json["dimensions"] == 4);
    assert_eq!(code(&points(&["random", "-n", "100", "--json", "-o", "-"])), 2);
}

#[test]
fn the_list_names_every_pattern_and_each_can_be_made() {
    let output = points(&["--list", "--json"]);
    let list: serde_json::Value = serde_json::from_slice(&output.stdout).expect("well-formed JSON");
    let list = list.as_array().expect("a list");
    assert!(list.len() > 15);
    for entry in list {
        let name = entry["name"].as_str().expect("a name");
        for bound in ["least", "most"] {
            let dimensions = entry["dimensions"][bound].to_string();
            let output = points(&[name, "-n", if dimensions == "16" { "1" } else { "16" }, "--dim", &dimensions]);
            assert_eq!(code(&output), 0, "{name} in {dimensions}: {}", stderr(&output));
        }
        assert!(stdout(&points(&["--list"])).contains(name));
    }
}

#[test]
fn one_place_under_two_names_is_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (one, other) = (folder.path().join("x.svg"), folder.path().join(".").join("x.svg"));
    let output = points(&["random", "-n", "16", "-o", text(&one), "--spectrum", text(&other)]);
    assert!(code(&output) == 2 && stderr(&output).contains("name the same file"), "{}", stderr(&output));
    assert!(!one.exists());
}

#[test]
fn where_one_file_cannot_be_written_neither_is() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (good, missing) = (folder.path().join("x.svg"), folder.path().join("missing").join("x.csv"));
    let output = points(&["random", "-n", "16", "-o", text(&missing), "--spectrum", text(&good)]);
    assert!(code(&output) == 2 && stderr(&output).contains("its folder does not exist"), "{}", stderr(&output));
    assert_eq!(fs::read_dir(folder.path()).expect("readable").count(), 0);
}
