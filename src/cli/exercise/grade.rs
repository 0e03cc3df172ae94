//! `nyquist exercise grade`: the answers of many, in one table.

use crate::cli::Failure;
use crate::cli::exercise::bounded::Limits;
use crate::cli::exercise::verdict::Verdict;
use crate::cli::exercise::workshop::Workshop;
use nyquist::exercise::{Exercise, catalog};
use nyquist::text::Lang;
use rayon::prelude::*;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// A folder of submissions: a folder for every student, in it the files of the answers.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// A folder with a folder for every student
    folder: PathBuf,
    /// Print CSV, a row for every student and exercise, instead of a table
    #[arg(long)]
    csv: bool,
    /// The language of the messages
    #[arg(long, default_value = "en")]
    lang: Lang,
    #[command(flatten)]
    limits: Limits,
    /// Where the crate nyquist is: a folder, or the address of a Git repository; detected if not given
    #[arg(long, value_name = "WHERE")]
    library: Option<String>,
}

/// What one student has handed in for one exercise.
struct Submission {
    student: String,
    exercise: Exercise,
    verdict: Verdict,
}

pub(super) fn run(args: &Args, out: &mut impl Write) -> Result<(), Failure> {
    let students = students(&args.folder)?;
    let submissions = judged(args, &students)?;
    if args.csv { csv(&students, &submissions, args.lang, out) } else { table(&students, &submissions, args.lang, out) }
}

fn students(folder: &Path) -> Result<Vec<String>, Failure> {
    let cannot = |error| Failure::trouble(format!("cannot read {}", folder.display()), error);
    let mut students = Vec::new();
    for entry in fs::read_dir(folder).map_err(cannot)? {
        let entry = entry.map_err(cannot)?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if entry.path().is_dir() && !name.starts_with('.') {
            students.push(name);
        }
    }
    students.sort();
    let none = || Failure::trouble(folder.display(), "holds no folders of students");
    if students.is_empty() { Err(none()) } else { Ok(students) }
}

/// All are compiled in one go, and run one a processor.
fn judged(args: &Args, students: &[String]) -> Result<Vec<Submission>, Failure> {
    let exercises = catalog::all();
    let mut found = Vec::new();
    for (number, student) in students.iter().enumerate() {
        for exercise in &exercises {
            let file = fs::canonicalize(args.folder.join(student).join(format!("{}.rs", exercise.file())));
            found.extend(file.ok().map(|file| (number, student, exercise, file)));
        }
    }
    if found.is_empty() {
        let why = "there is no answer (NN_name.rs) in any student's folder";
        return Err(Failure::trouble(args.folder.display(), why));
    }
    let root = args.folder.join(".nyquist");
    let workshop = Workshop::open(&root, args.library.as_deref())?;
    let root = fs::canonicalize(root)?;
    let mut handed_in = Vec::new();
    for (number, student, exercise, file) in found {
        let program = format!("s{number}_{}", exercise.file());
        workshop.program(&program, &exercise.program(&file.to_string_lossy()))?;
        handed_in.push((student.clone(), exercise.clone(), program));
    }
    let names: Vec<String> = handed_in.iter().map(|(.., program)| program.clone()).collect();
    workshop.keep(&names)?;
    let count = format!("{} answers of {} students", names.len(), students.len());
    let _ = writeln!(std::io::stderr(), "compiling {count} …"); // nobody to tell if it is closed
    let compiled = workshop.compile(&names)?;
    let judge = |(student, exercise, program): (String, Exercise, String)| {
        let compiled = compiled.get(&program).cloned().expect("every program was compiled or not");
        let (verdict, _) = Verdict::of(compiled, &root.join(format!("{program}.report")), args.limits)?;
        Ok(Submission { student, exercise, verdict })
    };
    handed_in.into_par_iter().map(judge).collect()
}

fn table(students: &[String], submissions: &[Submission], lang: Lang, out: &mut impl Write) -> Result<(), Failure> {
    let exercises = catalog::all();
    let asked: Vec<&Exercise> =
        exercises.iter().filter(|e| submissions.iter().any(|s| s.exercise.id == e.id)).collect();
    let wide = students.iter().map(|student| student.chars().count()).max().unwrap_or(0);
    let head: String = asked.iter().map(|exercise| format!("  {:02}", exercise.number)).collect();
    writeln!(out, "{:wide$}{head}", "")?;
    for student in students {
        let of =
            |exercise: &Exercise| submissions.iter().find(|s| s.student == *student && s.exercise.id == exercise.id);
        let marks: String = asked
            .iter()
            .map(|exercise| match of(exercise) {
                None => "   –",
                Some(handed_in) if handed_in.verdict.solved() => "   ✓",
                Some(_) => "   ✗",
            })
            .collect();
        let solved = submissions.iter().filter(|s| s.student == *student && s.verdict.solved()).count();
        writeln!(out, "{student:wide$}{marks}   {solved} / {}", exercises.len())?;
    }
    let mut missed = submissions.iter().filter(|submission| !submission.verdict.solved()).peekable();
    if missed.peek().is_some() {
        writeln!(out)?;
    }
    for Submission { student, exercise, verdict } in missed {
        let (word, sentence) = (verdict.word(), verdict.sentence(lang));
        writeln!(out, "{student}, {:02} {}: {word}: {sentence}", exercise.number, exercise.id)?;
    }
    Ok(())
}

fn csv(students: &[String], submissions: &[Submission], lang: Lang, out: &mut impl Write) -> Result<(), Failure> {
    writeln!(out, "student,number,exercise,result,met,asked,message")?;
    for student in students {
        for exercise in catalog::all() {
            let found = submissions.iter().find(|s| s.student == *student && s.exercise.id == exercise.id);
            let (word, sentence) =
                found.map_or(("missing", String::new()), |s| (s.verdict.word(), s.verdict.sentence(lang)));
            let (met, asked) = match found.map(|s| &s.verdict) {
                Some(Verdict::Judged(report)) => {
                    (report.lines.iter().filter(|line| line.residual().holds()).count(), report.lines.len())
                }
                _ => (0, 0),
            };
            let [student, sentence] = [student.as_str(), &sentence].map(field);
            writeln!(out, "{student},{},{},{word},{met},{asked},{sentence}", exercise.number, exercise.id)?;
        }
    }
    Ok(())
}

/// A field of CSV (RFC 4180).
fn field(text: &str) -> String {
    let needs = text.contains([',', '"', '\n', '\r']);
    if needs { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}
