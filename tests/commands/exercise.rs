//! Exercises as a student and a teacher meet them.

use nyquist::exercise::catalog;
use nyquist::text::Lang;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use tempfile::TempDir;

/// The command, with one build folder for all folders of students: the library is compiled once.
fn exercise(folder: &Path, args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_nyquist"));
    command.arg("exercise").args(args).current_dir(folder);
    command.env("CARGO_TARGET_DIR", Path::new(env!("CARGO_TARGET_TMPDIR")).join("exercises"));
    // the versions of the lock file are there already
    command.env("CARGO_NET_OFFLINE", "true").env_remove("NYQUIST_LIBRARY").output().expect("the command starts")
}

fn done(output: &Output) -> (i32, String) {
    let words = [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes).into_owned()).concat();
    (output.status.code().expect("the command was not killed"), words)
}

fn folder() -> TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

#[test]
fn a_student_begins_errs_is_helped_and_solves() {
    let folder = folder();
    let go = |args: &[&str]| done(&exercise(folder.path(), args));
    let file = folder.path().join("01_pixel.rs");

    let (code, words) = go(&["start", "--lang", "ru"]);
    assert!(code == 0 && words.contains("Пиксель как фильтр"), "{words}");
    let stub = fs::read_to_string(&file).expect("the stub is there");

    let (code, words) = go(&["check"]);
    assert!(code == 1 && words.contains('✗') && words.contains("а должно быть"), "{words}");
    let (code, first) = go(&["hint"]);
    assert!(code == 0 && first.contains("1/2") && !first.contains("2/2"), "{first}");
    assert!(go(&["hint"]).1.contains("2/2"));

    // a mistake that is known is called by its name, and the file stays the student's
    let (code, words) = go(&["start"]);
    assert!(code == 0 && words.contains("остаётся как есть"), "{words}");
    assert_eq!(fs::read_to_string(&file).expect("still there"), stub);
    let mistake = "pub fn kept(frequency: f64, width: f64) -> f64 {\n    let t = std::f64::consts::PI * frequency * width;\n    \
                   println!(\"t = {t}\");\n    t.sin() / t\n}\n";
    fs::write(&file, mistake).expect("written");
    let (code, words) = go(&["check"]);
    assert!(code == 1 && words.contains("0/0") && words.contains("t = "), "{words}");

    // what was begun last is meant, and what is somebody else's is not replaced
    assert_eq!(go(&["start", "2"]).0, 0);
    assert!(go(&["hint"]).1.contains("02 wheel"));
    assert_eq!(go(&["hint", "1"]).0, 0);
    fs::write(folder.path().join("src/bin/03_other.rs"), "fn main() {}\n").expect("written");
    assert!(go(&["solution"]).1.contains("kept"));

    let (code, solution) = go(&["solution"]);
    assert_eq!(code, 0);
    fs::write(&file, solution).expect("written");
    let (code, words) = go(&["check"]);
    assert!(code == 0 && words.contains("Решено") && words.contains("02 wheel"), "{words}");
    assert!(fs::read_to_string(folder.path().join("pictures/01_pixel.svg")).expect("drawn").contains("<svg"));
    let (_, list) = go(&["list"]);
    assert!(list.contains("✓ 01 pixel") && list.contains(&format!("решено: 1 / {}", catalog::all().len())), "{list}");

    // the next one comes by itself; the compiler's words stand at the student's line
    assert!(go(&["start"]).1.contains("02 wheel"));
    fs::write(folder.path().join("02_wheel.rs"), "pub fn seen(turns: f64, _: f64, _: f64) -> f64 {\n    turn\n}\n")
        .expect("written");
    let (code, words) = go(&["check"]);
    assert!(code == 1 && words.contains("02_wheel.rs:2:5") && !words.contains("src/bin"), "{words}");
    fs::write(folder.path().join("02_wheel.rs"), "pub fn seen(turns: f64) -> f64 {\n    turns\n}\n").expect("written");
    let (code, words) = go(&["check"]);
    assert!(code == 1 && words.contains("pub fn seen(turns: f64, spokes: f64, frames: f64) -> f64"), "{words}");
}

#[test]
fn a_teacher_sees_what_each_has_solved_and_whoever_loops_or_eats_memory_is_stopped() {
    let folder = folder();
    let put = |student: &str, name: &str, text: &str| {
        let home = folder.path().join(student);
        fs::create_dir_all(&home).expect("a folder");
        fs::write(home.join(format!("{name}.rs")), text).expect("written");
    };
    for exercise in catalog::all() {
        put("new", &exercise.file(), &exercise.stub(Lang::Ru));
        put("solver", &exercise.file(), &exercise.solution());
    }
    let strange = [
        ("01_pixel", "slow", "pub fn kept(_: f64, _: f64) -> f64 { loop { print!(\"still here \"); } }"),
        (
            "02_wheel",
            "memory",
            "pub fn seen(turns: f64, _: f64, _: f64) -> f64 { let mut all = vec![turns]; loop { all.push(turns); } }",
        ),
        ("03_moire", "uncompiled", "pub fn moire(u: f64, v: f64) -> [f64; 2] { [u, w] }"),
        ("04_alias", "crashed", "pub fn alias(_: f64, _: f64) -> f64 { [1.0][std::env::args().count()] }"),
        (
            "05_fold",
            "crashed",
            "pub fn fold(a: f64, b: f64) -> [f64; 2] { let [x, y] = fold(a + 1.0, b); [y + 1.0, x] }",
        ),
        ("06_square", "crashed", "pub fn amplitude(_: u32) -> f64 { std::process::exit(0) }"),
        ("16_rate", "uncompiled", "pub fn rate(tones: &[f64]) -> f64 { tones[0] }"),
    ];
    for (name, _, text) in strange {
        put("strange", name, text);
    }
    let grade = |more: &[&str]| {
        let args = [&["grade", ".", "--seconds", "5", "--memory", "256"][..], more].concat();
        done(&exercise(folder.path(), &args))
    };
    let (code, csv) = grade(&["--csv"]);
    assert_eq!(code, 0, "{csv}");
    let row = |student: &str, name: &str| {
        let (number, id) = name.split_once('_').expect("NN_id");
        let head = format!("{student},{},{id},", number.trim_start_matches('0'));
        csv.lines().find_map(|line| line.strip_prefix(&head)).unwrap_or_else(|| panic!("no {head} in {csv}")).to_owned()
    };
    for exercise in catalog::all() {
        let [new, solver] = ["new", "solver"].map(|student| row(student, &exercise.file()));
        assert!(new.starts_with("wrong,"), "{} as it is laid out: {new}", exercise.id);
        assert!(solver.starts_with("solved,"), "{}: {solver}", exercise.id);
    }
    for (name, what, _) in strange {
        let row = row("strange", name);
        assert!(row.starts_with(&format!("{what},")), "{name}: {row}");
    }
    assert!(row("strange", "07_gibbs").starts_with("missing,"));
    let (code, table) = grade(&["--lang", "ru"]);
    assert!(code == 0 && table.contains("strange, 01 pixel: slow: Остановлено через 5 с"), "{table}");
    assert!(table.contains(&format!("{0} / {0}", catalog::all().len())), "{table}");
}

#[test]
fn a_folder_without_an_answer_is_said_to_have_none() {
    let folder = folder();
    fs::create_dir(folder.path().join("nobody")).expect("made");
    let (code, words) = done(&exercise(folder.path(), &["grade", "."]));
    assert!(code == 2 && words.contains("no answer"), "{words}");
}

#[test]
fn what_belongs_to_others_stays_as_it_is() {
    let folder = folder();
    fs::write(folder.path().join("Cargo.toml"), "[package]\n").expect("written");
    let (code, words) = done(&exercise(folder.path(), &["start"]));
    assert!(code == 2 && words.contains("belongs to another project"), "{words}");
    assert_eq!(fs::read_to_string(folder.path().join("Cargo.toml")).expect("still there"), "[package]\n");
    assert!(!folder.path().join("01_pixel.rs").exists());
}

#[test]
fn whoever_has_no_cargo_or_no_library_is_told_what_to_do() {
    let folder = folder();
    let (code, words) = done(&exercise(folder.path(), &["start", "--library", "."]));
    assert!(code == 2 && words.contains("--library"), "{words}");
    assert_eq!(done(&exercise(folder.path(), &["start"])).0, 0);
    let mut command = Command::new(env!("CARGO_BIN_EXE_nyquist"));
    let output = command.args(["exercise", "check"]).current_dir(folder.path()).env("CARGO", "no-such-cargo").output();
    let (code, words) = done(&output.expect("the command starts"));
    assert!(code == 2 && words.contains("rustup.rs"), "{words}");
}

#[test]
fn a_solution_is_shown_after_a_try_or_on_demand_and_unknown_names_are_refused() {
    let folder = folder();
    assert_eq!(done(&exercise(folder.path(), &["start", "mitchell"])).0, 0);
    let (code, words) = done(&exercise(folder.path(), &["solution"]));
    assert!(code == 2 && words.contains("--show"), "{words}");
    let (code, words) = done(&exercise(folder.path(), &["solution", "--show"]));
    assert!(code == 0 && words.contains("8.0 * b + 24.0 * c") && !words.contains("%%"), "{words}");
    let (code, words) = done(&exercise(folder.path(), &["hint", "michell"]));
    assert!(code == 2 && words.contains("known: mitchell"), "{words}");
    let (code, words) = done(&exercise(folder.path(), &["check", "alias"]));
    assert!(code == 2 && words.contains("exercise start alias"), "{words}");
    fs::write(folder.path().join(".nyquist/progress.json"), "{").expect("written");
    let (code, words) = done(&exercise(folder.path(), &["list"]));
    assert!(code == 2 && words.contains("damaged"), "{words}");
}
