//! How an answer is judged, and how the judgement travels from the student's process.

use crate::exercise::line::{Case, Line};
use crate::figure::{Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::text::{Lang, Text};
use std::fs;
use std::io::{self, Write};
use std::process::ExitCode;

/// A wrong answer that is often given, and what helps whoever gave it.
#[derive(Debug, Clone)]
pub struct Mistake<A> {
    answer: A,
    says: Text,
}

impl<A> Mistake<A> {
    /// A wrong answer, and what to say in English and in Russian.
    pub const fn new(answer: A, en: &'static str, ru: &'static str) -> Self {
        Self { answer, says: Text::fixed(en, ru) }
    }
}

/// What was asked of an answer, and what came out.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// The demands, with all cases.
    pub lines: Vec<Line>,
    /// What was forgotten, if the answer gives the values of a known mistake.
    pub says: Option<Text>,
}

/// Puts all demands to an answer, and if one is not met, looks for a mistake that would say the same.
pub fn judge<A: Copy>(answer: A, demands: fn(A) -> Vec<Line>, mistakes: &[Mistake<A>]) -> Report {
    let lines = demands(answer);
    let mut report = Report { lines, says: None };
    if !report.passed() {
        let same = |mistake: &&Mistake<A>| {
            let others = demands(mistake.answer);
            others.len() == report.lines.len() && report.lines.iter().zip(&others).all(|(a, b)| a.says_the_same(b))
        };
        report.says = mistakes.iter().find(same).map(|mistake| mistake.says.clone());
    }
    report
}

/// The end of the program that judges an answer: the report goes into the file that the first argument names; without
/// one, a table is printed.
pub fn tell(report: &Report) -> ExitCode {
    let told = match std::env::args_os().nth(1) {
        Some(path) => fs::write(path, report.encoded()),
        None => io::stdout().write_all(report.table().as_bytes()),
    };
    match told {
        Ok(()) if report.passed() => ExitCode::SUCCESS,
        Ok(()) => ExitCode::from(1),
        Err(error) => {
            // if standard error is gone as well, the exit code says it all
            let _ = writeln!(io::stderr(), "the report cannot be written: {error}");
            ExitCode::from(2)
        }
    }
}

impl Report {
    /// Whether every demand is met, and there is at least one.
    pub fn passed(&self) -> bool {
        !self.lines.is_empty() && self.lines.iter().all(|line| line.residual().holds())
    }

    fn table(&self) -> String {
        let mut table = String::new();
        for residual in self.lines.iter().map(Line::residual) {
            let mark = if residual.holds() { '✓' } else { '✗' };
            table += &format!("{mark} {:.2e} · {:.2e}  {}\n", residual.measured, residual.bound, residual.law);
        }
        table
    }

    /// The answer beside the truth, over whatever the demands are drawn along; none if they are not.
    pub fn figure(&self) -> Option<Figure> {
        let drawn: Vec<&Line> = self.lines.iter().filter(|line| !line.along.is_empty()).collect();
        let panels = PANELS.iter().zip(&drawn).map(|(name, line)| panel(name, line));
        (!drawn.is_empty()).then(|| panels.fold(Figure::new(drawn.len().min(2)), Figure::with))
    }

    /// As text that [`Report::decoded`] reads: a record a line, fields between tabs, numbers in the shortest form that
    /// is exact.
    pub fn encoded(&self) -> String {
        let mut out = String::from(HEAD);
        let texts = |text: &Text| Lang::ALL.map(|lang| text.get(lang).replace(['\t', '\n'], " ")).join("\t");
        if let Some(says) = &self.says {
            out += &format!("says\t{}\n", texts(says));
        }
        for Line { law, allowed, along, cases } in &self.lines {
            out += &format!("line\t{allowed:e}\t{}\t{}\n", texts(law), texts(along));
            for Case { call, at, said, truth } in cases {
                out += &format!("case\t{at:e}\t{said:e}\t{truth:e}\t{}\n", call.replace(['\t', '\n'], " "));
            }
        }
        out
    }

    /// Reads what [`Report::encoded`] has written; nothing if it is something else.
    ///
    /// ```
    /// use nyquist::exercise::{Line, Report};
    /// use nyquist::text;
    /// let line = Line::new(text!("one third", "одна треть"), 1e-16).case("third()", 0.333, 1.0 / 3.0);
    /// let report = Report { lines: vec![line], says: Some(text!("too few digits", "мало цифр")) };
    /// assert_eq!(Report::decoded(&report.encoded()), Some(report));
    /// assert_eq!(Report::decoded("hello"), None);
    /// ```
    pub fn decoded(text: &str) -> Option<Self> {
        let mut report = Self { lines: Vec::new(), says: None };
        for record in text.strip_prefix(HEAD)?.lines() {
            match record.split('\t').collect::<Vec<_>>()[..] {
                ["says", en, ru] => report.says = Some(Text::verbatim(en, ru)),
                ["line", allowed, en, ru, along_en, along_ru] => {
                    let line = Line::new(Text::verbatim(en, ru), allowed.parse().ok()?);
                    report.lines.push(line.along(Text::verbatim(along_en, along_ru)));
                }
                ["case", at, said, truth, call] => {
                    let [at, said, truth] = [at.parse().ok()?, said.parse().ok()?, truth.parse().ok()?];
                    report.lines.last_mut()?.cases.push(Case { call: call.into(), at, said, truth });
                }
                _ => return None,
            }
        }
        Some(report)
    }
}

impl<A: Copy> Mistake<A> {
    /// The wrong answer.
    pub fn answer(&self) -> A {
        self.answer
    }

    /// What was forgotten, without giving the answer away.
    pub fn says(&self) -> &Text {
        &self.says
    }
}

/// The first line of an encoded report.
const HEAD: &str = "nyquist exercise report 1\n";

/// The names of the panels of a drawn report: more are not drawn.
const PANELS: [&str; 4] = ["first", "second", "third", "fourth"];

fn panel(name: &'static str, line: &Line) -> Panel {
    let finite = |value: &f64| value.is_finite();
    let range = |values: &[f64]| {
        let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
        let margin = if high > low { 0.1 * (high - low) } else { 1.0 };
        if low <= high { (low - margin, high + margin) } else { (-1.0, 1.0) }
    };
    let along: Vec<f64> = line.cases.iter().map(|case| case.at).filter(finite).collect();
    let truths: Vec<f64> = line.cases.iter().map(|case| case.truth).filter(finite).collect();
    let (low, high) = range(&truths);
    let height = high - low;
    // an answer far off must not press the truth into a line
    let near = line.cases.iter().map(|case| case.said).filter(finite).map(|v| v.clamp(low - height, high + height));
    let (x, y) = (range(&along), range(&[&truths[..], &near.collect::<Vec<_>>()].concat()));
    let truth = Layer::line("truth", Meaning::Theory, line.cases.iter().map(|case| [case.at, case.truth]));
    let said = Layer::dots("answer", Meaning::Reconstructed, line.cases.iter().map(|case| [case.at, case.said]));
    Panel::new(
        name,
        line.law.clone(),
        Scale::linear(line.along.clone(), x.0, x.1),
        Scale::linear(Text::EMPTY, y.0, y.1),
    )
    .with(truth.label(Text::fixed("truth", "истина")))
    .with(said.label(Text::fixed("your answer", "ваш ответ")))
    .legend(Legend::Above)
}
