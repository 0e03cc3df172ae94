//! A student's folder: files of answers, the project that compiles them, what was done.

use crate::cli::exercise::bounded::Limits;
use crate::cli::exercise::progress::Progress;
use crate::cli::exercise::verdict::Verdict;
use crate::cli::exercise::workshop::Workshop;
use crate::cli::{Failure, files};
use nyquist::exercise::{Exercise, Report, catalog};
use nyquist::plot::{Style, draw};
use nyquist::text::{Lang, Text, plain};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// So many lines of what an answer prints are shown.
const MOST_PRINTED: usize = 50;

/// The folder.
#[derive(Debug)]
pub(super) struct Desk {
    root: PathBuf,
    progress: Progress,
}

impl Desk {
    pub(super) fn at(root: &Path, lang: Option<Lang>) -> Result<Self, Failure> {
        Ok(Self { root: root.to_owned(), progress: Progress::read(root, lang)? })
    }

    /// `en` or `ru`, in the language of this folder.
    fn words<'a>(&self, en: &'a str, ru: &'a str) -> &'a str {
        if self.progress.lang == Lang::En { en } else { ru }
    }

    fn title(&self, exercise: &Exercise) -> String {
        format!("{:02} {} — {}", exercise.number, exercise.id, plain(exercise.title.get(self.progress.lang)))
    }

    fn file(&self, exercise: &Exercise) -> PathBuf {
        self.root.join(format!("{}.rs", exercise.file()))
    }

    /// The exercise of that name; without one, that which was worked on last, unless it is solved and another one is begun.
    pub(super) fn current(&self, name: Option<&str>) -> Result<Exercise, Failure> {
        if let Some(name) = name {
            return Ok(catalog::by_name(name)?);
        }
        let open = |exercise: &Exercise| !self.progress.of(&exercise.id).solved && self.file(exercise).exists();
        let none = || {
            let begin = self.words("nothing is begun here", "здесь ничего не начато");
            Failure::Trouble(format!("{begin}: nyquist exercise start"))
        };
        let latest = || self.progress.latest.as_deref().and_then(|id| catalog::by_name(id).ok());
        let latest = || latest().filter(|exercise| self.file(exercise).exists());
        let begun = || latest().filter(open).or_else(|| catalog::all().into_iter().find(open));
        begun().or_else(latest).ok_or_else(none)
    }

    /// The program that judges an answer. It names the file by its whole path, and so does the compiler.
    fn program(&self, exercise: &Exercise) -> Result<String, Failure> {
        let file = fs::canonicalize(&self.root)?.join(format!("{}.rs", exercise.file()));
        Ok(exercise.program(&file.to_string_lossy()))
    }

    fn next(&self) -> Option<Exercise> {
        catalog::all().into_iter().find(|exercise| !self.progress.of(&exercise.id).solved)
    }

    pub(super) fn list(&self, out: &mut impl Write) -> Result<(), Failure> {
        let all = catalog::all();
        for exercise in &all {
            let done = self.progress.of(&exercise.id);
            let mark = if done.solved {
                '✓'
            } else if done.tries > 0 {
                '✗'
            } else if self.file(exercise).exists() {
                '·'
            } else {
                ' '
            };
            let title = plain(exercise.title.get(self.progress.lang));
            writeln!(out, "{mark} {:02} {:<12} {title}", exercise.number, exercise.id)?;
        }
        let solved = all.iter().filter(|exercise| self.progress.of(&exercise.id).solved).count();
        let words = self.words("solved", "решено");
        Ok(writeln!(out, "\n{words}: {solved} / {}", all.len())?)
    }

    /// Lays out a file to begin with: the next exercise, if none is named.
    pub(super) fn start(
        &mut self,
        name: Option<&str>,
        library: Option<&str>,
        out: &mut impl Write,
    ) -> Result<(), Failure> {
        let exercise = match (name, self.next()) {
            (Some(name), _) => catalog::by_name(name)?,
            (None, Some(exercise)) => exercise,
            (None, None) => {
                return Ok(writeln!(out, "{}", self.words("All exercises are solved.", "Все упражнения решены."))?);
            }
        };
        let workshop = Workshop::open(&self.root, library)?;
        workshop.program(&exercise.file(), &self.program(&exercise)?)?;
        let file = self.file(&exercise);
        writeln!(out, "{}\n", self.title(&exercise))?;
        if fs::symlink_metadata(&file).is_ok() {
            let there = self.words("is there already, and stays as it is", "уже есть и остаётся как есть");
            writeln!(out, "{} {there}", file.display())?;
        } else {
            files::write(&file, exercise.stub(self.progress.lang).as_bytes())?;
            for line in exercise.task.get(self.progress.lang).lines().skip(2) {
                writeln!(out, "{}", format!("  {line}").trim_end())?;
            }
            writeln!(out, "\n{}: {}", self.words("Your file", "Ваш файл"), file.display())?;
        }
        self.progress.note(&exercise.id, |_| {})?;
        Ok(writeln!(out, "{}: nyquist exercise check", self.words("When it is ready", "Когда будет готово"))?)
    }

    /// Puts an answer to the test.
    pub(super) fn check(&mut self, name: Option<&str>, limits: Limits, out: &mut impl Write) -> Result<(), Failure> {
        let exercise = self.current(name)?;
        let file = self.file(&exercise);
        if !file.is_file() {
            let begin = self.words("is not there; begin with", "нет; начните с");
            return Err(Failure::Trouble(format!(
                "{} {begin}: nyquist exercise start {}",
                file.display(),
                exercise.id
            )));
        }
        writeln!(out, "{}\n", self.title(&exercise))?;
        out.flush()?;
        let workshop = Workshop::open(&self.root, None)?;
        workshop.program(&exercise.file(), &self.program(&exercise)?)?;
        if !self.root.join("target").exists() {
            let once = self.words(
                "The library is compiled, once; this takes a minute or two.",
                "Один раз компилируется библиотека; это минута-другая.",
            );
            let _ = writeln!(std::io::stderr(), "{once}"); // nobody to tell if it is closed
        }
        let mut compiled = workshop.compile(&[exercise.file()])?;
        let compiled = compiled.remove(&exercise.file()).expect("every program was compiled or not");
        let scratch = fs::canonicalize(&self.root)?.join(".nyquist/report");
        fs::create_dir_all(self.root.join(".nyquist"))?;
        let (verdict, printed) = Verdict::of(compiled, &scratch, limits)?;
        if !printed.is_empty() {
            for line in printed.lines().take(MOST_PRINTED) {
                writeln!(out, "{line}")?;
            }
            let left = printed.lines().count().saturating_sub(MOST_PRINTED);
            if left > 0 {
                writeln!(out, "… {} {left}", self.words("lines left out:", "строк опущено:"))?;
            }
            writeln!(out)?;
        }
        verdict.print(self.progress.lang, out)?;
        match &verdict {
            Verdict::Judged(report) => self.picture(&exercise, report, out)?,
            // the compiler speaks of the program, which expects the function as it was
            Verdict::Broken(words) if words.contains("src/bin") => {
                let must = self.words(
                    "The function must begin as it was laid out",
                    "Функция должна начинаться так, как была дана",
                );
                writeln!(out, "  {must}: {}", exercise.signature())?;
            }
            Verdict::Broken(_) | Verdict::Stopped(_) => {}
        }
        self.progress.note(&exercise.id, |mark| {
            mark.tries += 1;
            mark.solved |= verdict.solved();
        })?;
        if !verdict.solved() {
            let help = self.words("Help, step by step", "Подсказки по шагам");
            writeln!(out, "\n{help}: nyquist exercise hint {}", exercise.id)?;
            return Err(Failure::Check);
        }
        writeln!(out, "\n✓ {}", self.words("Solved.", "Решено."))?;
        match self.next() {
            Some(next) => {
                let then = self.words("Next", "Дальше");
                Ok(writeln!(out, "{then}: nyquist exercise start    ({})", self.title(&next))?)
            }
            None => Ok(writeln!(out, "{}", self.words("That was the last one.", "Это было последнее."))?),
        }
    }

    /// The answer beside the truth, where that can be drawn.
    fn picture(&self, exercise: &Exercise, report: &Report, out: &mut impl Write) -> Result<(), Failure> {
        let Some(figure) = report.figure() else { return Ok(()) };
        let lang = self.progress.lang;
        let scene =
            draw(&exercise.title, &Text::EMPTY, &figure, &Style { lang, size: (1120, 630), ..Style::default() });
        let path = self.root.join("pictures").join(format!("{}.svg", exercise.file()));
        files::write(&path, scene.svg().as_bytes())?;
        let words = self.words("Your answer beside the truth", "Ваш ответ рядом с истиной");
        Ok(writeln!(out, "\n{words}: {}", path.display())?)
    }

    /// The next hint.
    pub(super) fn hint(&mut self, name: Option<&str>, out: &mut impl Write) -> Result<(), Failure> {
        let exercise = self.current(name)?;
        let known = usize::try_from(self.progress.of(&exercise.id).hints).unwrap_or(usize::MAX);
        let count = exercise.hints.len();
        let shown = (known + 1).min(count);
        writeln!(out, "{}\n", self.title(&exercise))?;
        for (hint, number) in exercise.hints.iter().zip(1..=shown) {
            writeln!(out, "{number}/{count}  {}", hint.get(self.progress.lang).replace('\n', "\n     "))?;
        }
        if known >= count {
            let last = self.words("There are no more hints. After a try", "Больше подсказок нет. После попытки");
            writeln!(out, "\n{last}: nyquist exercise solution {}", exercise.id)?;
        }
        self.progress.note(&exercise.id, |mark| mark.hints = shown as u64)
    }

    /// The solution, after a try or on demand.
    pub(super) fn solution(&self, name: Option<&str>, show: bool, out: &mut impl Write) -> Result<(), Failure> {
        let exercise = self.current(name)?;
        if self.progress.of(&exercise.id).tries == 0 && !show {
            let first = self.words(
                "is shown after a try (nyquist exercise check), or with --show",
                "показывается после попытки (nyquist exercise check) или с --show",
            );
            return Err(Failure::Trouble(format!("{} {first}", self.words("the solution", "решение"))));
        }
        Ok(write!(out, "{}", exercise.solution())?)
    }
}
