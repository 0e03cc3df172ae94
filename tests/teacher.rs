//! The page for the teacher says what the catalogues say, in both languages.

use nyquist::exercise::catalog as exercises;
use nyquist::figure::catalog as figures;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The cells of the table rows that begin with an entry of the lecture (`F07`) or an erratum (`E07`).
fn rows(page: &str, kind: char) -> Vec<Vec<String>> {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs").join(page);
    let text = fs::read_to_string(page).expect("the page can be read");
    let cells = |line: &str| line.split('|').skip(1).map(|cell| cell.trim().to_owned()).collect::<Vec<_>>();
    let rows = text.lines().filter(|line| line.starts_with('|')).map(cells);
    rows.filter(|cells| cells[0].starts_with(kind) && cells[0].len() == 3).collect()
}

/// What stands between backticks.
fn quoted(cell: &str) -> BTreeSet<&str> {
    cell.split('`').skip(1).step_by(2).collect()
}

/// The exercises of an entry, as the page writes them.
fn exercises_of(entry: &str) -> String {
    let of = exercises::all().into_iter().filter(|exercise| exercise.lecture.iter().any(|name| name == entry));
    let named: Vec<String> = of.map(|exercise| exercise.file().replacen('_', " ", 1)).collect();
    if named.is_empty() { "–".into() } else { named.join(", ") }
}

#[test]
fn every_slide_has_its_figures_and_exercises() {
    for page in ["teacher.md", "teacher.ru.md"] {
        let rows = rows(page, 'F');
        let slides: Vec<&str> = rows.iter().map(|row| row[0].as_str()).collect();
        let all: Vec<String> = (1..=59).map(|number| format!("F{number:02}")).collect();
        assert_eq!(slides, all, "{page}");
        for row in &rows {
            let covers = figures::all().into_iter().filter(|entry| entry.inventory.contains(&row[0].as_str()));
            assert_eq!(quoted(&row[2]), covers.map(|entry| entry.id).collect(), "{page}: figures of {}", row[0]);
            assert_eq!(row[3], exercises_of(&row[0]), "{page}: exercises of {}", row[0]);
        }
    }
}

#[test]
fn every_exercise_belongs_to_a_slide() {
    for exercise in exercises::all() {
        assert!(exercise.lecture.iter().any(|entry| entry.starts_with('F')), "{}", exercise.id);
    }
}

#[test]
fn every_erratum_has_its_figures_exercises_and_tests() {
    let folder =
        fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/errata")).expect("the errata are tested");
    let names = folder.map(|entry| entry.expect("readable").file_name().to_string_lossy().into_owned());
    let tests: Vec<String> = names.filter(|name| name.starts_with('e')).collect();
    let about = |erratum: &str| -> BTreeSet<&str> {
        let named = |test: &&str| test.split('_').any(|word| word == erratum.to_lowercase());
        tests.iter().map(String::as_str).filter(named).collect()
    };
    for page in ["teacher.md", "teacher.ru.md"] {
        let rows = rows(page, 'E');
        let known: BTreeSet<&str> = rows.iter().map(|row| row[0].as_str()).collect();
        let shown = figures::all().into_iter().flat_map(|entry| entry.errata.iter().copied());
        assert!(shown.collect::<BTreeSet<_>>().is_subset(&known), "{page}");
        for row in &rows {
            let shows = figures::all().into_iter().filter(|entry| entry.errata.contains(&row[0].as_str()));
            assert_eq!(quoted(&row[2]), shows.map(|entry| entry.id).collect(), "{page}: figures of {}", row[0]);
            assert_eq!(row[3], exercises_of(&row[0]), "{page}: exercises of {}", row[0]);
            let linked: BTreeSet<&str> =
                row[4].split("tests/errata/").skip(1).filter_map(|rest| rest.split(')').next()).collect();
            assert!(!linked.is_empty(), "{page}: {} is tested nowhere", row[0]);
            assert_eq!(linked, about(&row[0]), "{page}: tests of {}", row[0]);
        }
    }
}
