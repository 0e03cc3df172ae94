//! The exercises: every solution passes, and every mistake fails for its own reason.
#![allow(
    unreachable_pub,
    unused_qualifications,
    reason = "answers and what is asked of them are files of their own for a student"
)]

use nyquist::exercise::{Exercise, Mistake, catalog, judge};
use nyquist::text::Lang;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

#[path = "../../exercises/04_alias.rs"]
mod alias;
#[path = "../../exercises/13_boxes.rs"]
mod boxes;
#[path = "../../exercises/17_chirp.rs"]
mod chirp;
#[path = "../../exercises/11_comb.rs"]
mod comb;
#[path = "../../exercises/21_coverage.rs"]
mod coverage;
#[path = "../../exercises/29_film.rs"]
mod film;
#[path = "../../exercises/05_fold.rs"]
mod fold;
#[path = "../../exercises/07_gibbs.rs"]
mod gibbs;
#[path = "../../exercises/27_hammersley.rs"]
mod hammersley;
#[path = "../../exercises/22_irregular.rs"]
mod irregular;
#[path = "../../exercises/23_jitter.rs"]
mod jitter;
#[path = "../../exercises/12_kernel.rs"]
mod kernel;
#[path = "../../exercises/32_lanczos.rs"]
mod lanczos;
#[path = "../../exercises/20_length.rs"]
mod length;
#[path = "../../exercises/24_lens.rs"]
mod lens;
#[path = "../../exercises/10_lines.rs"]
mod lines;
#[path = "../../exercises/18_mean.rs"]
mod mean;
#[path = "../../exercises/31_mitchell.rs"]
mod mitchell;
#[path = "../../exercises/03_moire.rs"]
mod moire;
#[path = "../../exercises/28_nets.rs"]
mod nets;
#[path = "../../exercises/01_pixel.rs"]
mod pixel;
#[path = "../../exercises/26_radical.rs"]
mod radical;
#[path = "../../exercises/16_rate.rs"]
mod rate;
#[path = "../../exercises/15_replicas.rs"]
mod replicas;
#[path = "../../exercises/09_shift.rs"]
mod shift;
#[path = "../../exercises/14_spacing.rs"]
mod spacing;
#[path = "../../exercises/06_square.rs"]
mod square;
#[path = "../../exercises/19_supersample.rs"]
mod supersample;
#[path = "../../exercises/08_transform.rs"]
mod transform;
#[path = "../../exercises/30_unity.rs"]
mod unity;
#[path = "../../exercises/25_variance.rs"]
mod variance;
#[path = "../../exercises/02_wheel.rs"]
mod wheel;

/// Runs `$check` with the parts of every exercise.
macro_rules! every {
    ($check:ident: $($exercise:ident)+) => {
        [$((stringify!($exercise), $check($exercise::ANSWER, $exercise::demands, &$exercise::MISTAKES))),+]
    };
}

#[test]
fn every_solution_passes_and_every_mistake_fails_for_its_own_reason() {
    let found = every!(wrong: pixel wheel moire alias fold square gibbs transform shift lines comb kernel boxes spacing replicas rate chirp mean supersample length coverage irregular jitter lens variance radical hammersley nets film unity mitchell lanczos);
    let ids: Vec<&str> = found.iter().map(|(id, _)| *id).collect();
    let known: Vec<String> = catalog::all().into_iter().map(|exercise| exercise.id).collect();
    assert_eq!(ids, known, "every exercise is proven here, in the order of the catalogue");
    let wrong: Vec<String> =
        found.iter().flat_map(|(id, wrong)| wrong.iter().map(move |why| format!("{id}: {why}"))).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// What is wrong with an exercise.
fn wrong<A: Copy>(answer: A, demands: fn(A) -> Vec<nyquist::exercise::Line>, mistakes: &[Mistake<A>]) -> Vec<String> {
    let mut wrong = Vec::new();
    let solution = judge(answer, demands, mistakes);
    for line in solution.lines.iter().filter(|line| !line.residual().holds()) {
        wrong.push(format!("the solution fails: {:?}: {:?}", line.residual(), line.worst()));
    }
    for case in solution.lines.iter().flat_map(|line| &line.cases).filter(|case| !case.truth.is_finite()) {
        wrong.push(format!("no truth for {}", case.call));
    }
    let words: BTreeSet<&str> = mistakes.iter().map(|mistake| mistake.says().get(Lang::Ru)).collect();
    if mistakes.len() < 3 || words.len() < mistakes.len() {
        wrong.push(format!("{} mistakes with {} messages", mistakes.len(), words.len()));
    }
    for mistake in mistakes {
        let report = judge(mistake.answer(), demands, mistakes);
        let says = mistake.says().get(Lang::En);
        if report.passed() {
            wrong.push(format!("passes: {says}"));
        } else if report.says.as_ref() != Some(mistake.says()) {
            wrong.push(format!("is told {:?} instead of {says}", report.says.as_ref().map(|says| says.get(Lang::En))));
        }
    }
    wrong
}

#[test]
fn every_source_is_in_the_catalogue_and_can_be_read() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("exercises");
    let mut files: Vec<String> = fs::read_dir(folder)
        .expect("the folder of the exercises")
        .map(|entry| entry.expect("readable").file_name().to_string_lossy().into_owned())
        .collect();
    files.sort();
    let known: Vec<String> = catalog::SOURCES.iter().map(|(name, _)| format!("{name}.rs")).collect();
    assert_eq!(files, known);
    for (i, (name, source)) in catalog::SOURCES.iter().enumerate() {
        let exercise = Exercise::read(name, source).expect("well formed");
        assert_eq!((exercise.number, exercise.file().as_str()), (i + 1, *name));
    }
}

#[test]
fn a_stub_has_the_task_in_its_language_and_not_the_solution() {
    for exercise in catalog::all() {
        for lang in Lang::ALL {
            let stub = exercise.stub(lang);
            assert!(stub.starts_with(&format!("//! # {}\n", exercise.title.get(lang))), "{stub}");
            assert!(!stub.contains("%%"), "{stub}");
            let hidden = exercise.solution();
            let body: Vec<&str> = hidden.lines().filter(|line| line.starts_with("    ") && line.len() > 12).collect();
            assert!(body.iter().any(|line| !stub.contains(line)), "{stub}");
        }
        // what stands above the function is in its reader's language as well
        let above =
            |lang| exercise.stub(lang).lines().filter(|line| line.starts_with("///")).map(str::to_owned).collect();
        let [en, ru]: [Vec<String>; 2] = [Lang::En, Lang::Ru].map(above);
        assert!(!en.is_empty() && en.len() == ru.len() && en.iter().all(|line| !ru.contains(line)), "{ru:?}");
        assert!(exercise.program("answer.rs").contains(&format!("use answer::{};", exercise.function())));
    }
}
