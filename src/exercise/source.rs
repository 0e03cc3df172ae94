//! The one source of an exercise, and what is derived from it.
//!
//! `// %% en F07`, `// %% ru`, `// %% hint en`, `// %% hint ru` begin texts in comments: the task (whose first line is
//! its title) with the entries of the lecture's inventory that it belongs to, and hints, as many in each language.
//! `// %% answer` begins the code of the answer; in it `// %% start EXPRESSION` begins a body to hide, and what stands
//! in its place at the start, and `// %% end` ends it; `// %% ru WORDS` says in Russian what the `///` below it says.
//! `// %% check` begins what is asked.

use crate::error::{Error, Result};
use crate::text::{Lang, Text};

/// One exercise.
#[derive(Debug, Clone, PartialEq)]
pub struct Exercise {
    /// Its place in the course, counted from one.
    pub number: usize,
    /// Its name: `alias`.
    pub id: String,
    /// Which entries of the lecture's inventory it belongs to.
    pub lecture: Vec<String>,
    /// What it is called.
    pub title: Text,
    /// The task, in lines of Markdown.
    pub task: Text,
    /// What helps, step by step.
    pub hints: Vec<Text>,
    answer: Vec<String>,
    check: String,
}

/// Which section of the source a line stands in.
#[derive(Clone, Copy, PartialEq)]
enum Section {
    Before,
    Task(Lang),
    Hint(Lang),
    Answer,
    Check,
}

impl Exercise {
    /// Reads the source called `NN_id`.
    ///
    /// # Errors
    /// [`Error::Format`] where the source is not as described above.
    pub fn read(name: &str, source: &str) -> Result<Self> {
        parse(name, source).map_err(|reason| Error::Format { file: name.into(), reason })
    }

    /// The name of its files, without extension: `07_alias`.
    pub fn file(&self) -> String {
        format!("{:02}_{}", self.number, self.id)
    }

    /// The function that is asked for.
    pub fn function(&self) -> &str {
        self.signature().trim_start_matches("pub fn ").split('(').next().unwrap_or_default()
    }

    /// How it begins: `pub fn alias(frequency: f64, rate: f64) -> f64`.
    pub fn signature(&self) -> &str {
        let line = self.answer.iter().find(|line| line.starts_with("pub fn "));
        line.expect("a source without a function was not read").trim_end_matches(" {")
    }

    /// What the student begins with: the task in comments, and the answer with its bodies replaced.
    pub fn stub(&self, lang: Lang) -> String {
        let mut file = String::new();
        for line in self.task.get(lang).lines() {
            file += format!("//! {line}").trim_end();
            file.push('\n');
        }
        file.push('\n');
        let (mut hidden, mut russian) = (false, None);
        for line in &self.answer {
            if let Some((indent, start)) = line.split_once(START) {
                let todo = ["your answer", "ваш ответ"][usize::from(lang == Lang::Ru)];
                file += &format!("{indent}{start} // {todo}\n");
                hidden = true;
            } else if line.trim() == END {
                hidden = false;
            } else if let Some(words) = line.strip_prefix(RUSSIAN) {
                russian = (lang == Lang::Ru).then(|| format!("/// {words}\n"));
            } else if !hidden {
                file += &russian.take().unwrap_or_else(|| format!("{line}\n"));
            }
        }
        file
    }

    /// The answer as it should be, without the marks.
    pub fn solution(&self) -> String {
        let mark = |line: &str| line.contains(START) || line.trim() == END || line.starts_with(RUSSIAN);
        let code = self.answer.iter().filter(|line| !mark(line));
        code.map(|line| format!("{line}\n")).collect()
    }

    /// The program that judges the file at that path.
    pub fn program(&self, answer: &str) -> String {
        let function = self.function();
        format!(
            "// Written by `nyquist exercise`, and written anew whenever it checks.\n\n#[path = {answer:?}]\nmod answer;\n\n\
             use answer::{function};\n\n{}\nfn main() -> std::process::ExitCode {{\n    \
             nyquist::exercise::tell(&nyquist::exercise::judge(ANSWER, demands, &MISTAKES))\n}}\n",
            self.check
        )
    }
}

const START: &str = "// %% start ";
const END: &str = "// %% end";
const RUSSIAN: &str = "// %% ru ";

fn parse(name: &str, source: &str) -> std::result::Result<Exercise, String> {
    let (number, id) = name.split_once('_').ok_or("its name is not NN_id")?;
    let number = number.parse().map_err(|_| "its name does not begin with a number")?;
    let (mut section, mut lecture) = (Section::Before, Vec::new());
    let mut tasks = [Vec::new(), Vec::new()];
    let mut hints = [Vec::<Vec<&str>>::new(), Vec::new()];
    let (mut answer, mut check) = (Vec::new(), Vec::new());
    for (i, line) in source.lines().enumerate() {
        let wrong = |why: &str| format!("line {}: {why}", i + 1);
        let mark = line.strip_prefix("// %% ").map(|mark| mark.split(' ').collect::<Vec<_>>());
        match mark.as_deref() {
            Some(["en", slides @ ..]) => {
                section = Section::Task(Lang::En);
                lecture = slides.iter().map(|slide| (*slide).to_owned()).collect();
                continue;
            }
            Some(["ru"]) => section = Section::Task(Lang::Ru),
            Some(["ru", ..]) if section == Section::Answer => answer.push(line.to_owned()),
            Some(["hint", lang]) => {
                let lang: Lang = lang.parse().map_err(|_| wrong("a hint in no language"))?;
                hints[lang as usize].push(Vec::new());
                section = Section::Hint(lang);
            }
            Some(["answer"]) => section = Section::Answer,
            Some(["check"]) => section = Section::Check,
            Some(_) => return Err(wrong("an unknown mark")),
            None => {
                let words = || line.strip_prefix("//").map(|words| words.strip_prefix(' ').unwrap_or(words));
                match section {
                    Section::Before if line.is_empty() || line.starts_with("//!") => {}
                    Section::Task(_) | Section::Hint(_) if line.is_empty() => {}
                    Section::Before => return Err(wrong("stands before the first mark")),
                    Section::Task(lang) => tasks[lang as usize].push(words().ok_or_else(|| wrong("is no comment"))?),
                    Section::Hint(lang) => {
                        let hint = hints[lang as usize].last_mut().ok_or_else(|| wrong("belongs to no hint"))?;
                        hint.push(words().ok_or_else(|| wrong("is no comment"))?);
                    }
                    Section::Answer => answer.push(line.to_owned()),
                    Section::Check => check.push(line),
                }
            }
        }
    }
    let [en, ru] = &tasks;
    let titles = [en, ru].map(|task| task.first().and_then(|line| line.strip_prefix("# ")));
    let [Some(title_en), Some(title_ru)] = titles else { return Err("a task does not begin with its title".into()) };
    if hints[0].is_empty() || hints[0].len() != hints[1].len() {
        return Err(format!("{} hints in English, {} in Russian", hints[0].len(), hints[1].len()));
    }
    let hint = |(en, ru): (&Vec<&str>, &Vec<&str>)| Text::verbatim(en.join("\n"), ru.join("\n"));
    let marks = |mark: &str| answer.iter().filter(|line: &&String| line.contains(mark)).count();
    if marks(START) == 0 || marks(START) != marks(END) || !answer.iter().any(|line| line.starts_with("pub fn ")) {
        return Err("the answer has no public function, or no body to hide".into());
    }
    let begin = |mark: &str| answer.iter().filter(|line: &&String| line.starts_with(mark)).count();
    if begin("///") != begin(RUSSIAN) {
        return Err("a comment of the answer is not said in Russian as well".into());
    }
    while answer.last().is_some_and(|line| line.is_empty()) {
        answer.pop();
    }
    Ok(Exercise {
        number,
        id: id.into(),
        lecture,
        title: Text::verbatim(title_en, title_ru),
        task: Text::verbatim(en.join("\n"), ru.join("\n")),
        hints: hints[0].iter().zip(&hints[1]).map(hint).collect(),
        answer,
        check: check.join("\n"),
    })
}
