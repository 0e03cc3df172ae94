//! What became of an answer, and how it is told.

use crate::cli::Failure;
use crate::cli::exercise::bounded::{End, Limits, run};
use crate::cli::exercise::workshop::Compiled;
use nyquist::exercise::{Line, Report};
use nyquist::gallery::index::settled;
use nyquist::text::{Lang, Text, number, plain, raised};
use std::fs;
use std::io::Write;
use std::path::Path;

/// What became of an answer.
#[derive(Debug)]
pub(super) enum Verdict {
    /// It was judged.
    Judged(Report),
    /// It does not compile, with the compiler's words.
    Broken(String),
    /// It did not come to a judgement.
    Stopped(End),
}

impl Verdict {
    /// Runs a compiled program within limits; what the answer printed, too. The report is handed over in `scratch`.
    pub(super) fn of(compiled: Compiled, scratch: &Path, limits: Limits) -> Result<(Self, String), Failure> {
        let program = match compiled {
            Ok(program) => program,
            Err(words) => return Ok((Self::Broken(words), String::new())),
        };
        let cannot = |error| Failure::trouble(format!("cannot use {}", scratch.display()), error);
        if scratch.exists() {
            fs::remove_file(scratch).map_err(cannot)?;
        }
        let ran = run(&program, scratch, limits)?;
        let report = fs::read_to_string(scratch).ok().and_then(|text| Report::decoded(&text));
        let _ = fs::remove_file(scratch); // there is none if the program has not come so far
        let verdict = match (ran.end, report) {
            (End::Ended, Some(report)) => Self::Judged(report),
            (end, _) => Self::Stopped(end),
        };
        Ok((verdict, ran.printed))
    }

    /// Whether the exercise is solved.
    pub(super) fn solved(&self) -> bool {
        matches!(self, Self::Judged(report) if report.passed())
    }

    /// In one word, for a table of many.
    pub(super) fn word(&self) -> &'static str {
        match self {
            Self::Judged(report) if report.passed() => "solved",
            Self::Judged(_) => "wrong",
            Self::Broken(_) => "uncompiled",
            Self::Stopped(End::Slow(_)) => "slow",
            Self::Stopped(End::Greedy(_)) => "memory",
            Self::Stopped(End::Deep | End::Panicked(_) | End::Killed(_) | End::Ended) => "crashed",
        }
    }

    /// In one sentence, for whoever has to help; nothing where all is well.
    pub(super) fn sentence(&self, lang: Lang) -> String {
        match self {
            Self::Judged(report) if report.passed() => String::new(),
            Self::Judged(report) => report.says.as_ref().map_or_else(
                || {
                    report
                        .lines
                        .iter()
                        .find(|line| !line.residual().holds())
                        .and_then(|l| off(l, lang))
                        .unwrap_or_default()
                },
                |says| plain(says.get(lang)),
            ),
            Self::Broken(words) => words.lines().take(2).map(str::trim).collect::<Vec<_>>().join(" "),
            Self::Stopped(end) => stopped(end, lang).replace('\n', " "),
        }
    }

    /// The whole of it.
    pub(super) fn print(&self, lang: Lang, out: &mut impl Write) -> Result<(), Failure> {
        match self {
            Self::Judged(report) => table(report, lang, out),
            Self::Broken(words) => {
                writeln!(out, "{}\n", words.trim_end())?;
                let says = ["✗ The answer does not compile: see above.", "✗ Ответ не компилируется: см. выше."];
                Ok(writeln!(out, "{}", says[usize::from(lang == Lang::Ru)])?)
            }
            Self::Stopped(end) => Ok(writeln!(out, "✗ {}", stopped(end, lang))?),
        }
    }
}

/// Law · measured · allowed · mark; below a demand that is not met, the case that is off the most.
fn table(report: &Report, lang: Lang, out: &mut impl Write) -> Result<(), Failure> {
    let [measured, allowed] = [Text::fixed("measured", "измерено"), Text::fixed("allowed", "допустимо")];
    let wide = report.lines.iter().map(|line| plain(line.law.get(lang)).chars().count()).max().unwrap_or(0);
    writeln!(out, "  {:wide$}   {:>11} | {}", "", measured.get(lang), allowed.get(lang))?;
    for line in &report.lines {
        let residual = line.residual();
        let mark = if residual.holds() { '✓' } else { '✗' };
        // rounded up to a decade where that says enough; as they are where they must tell apart
        let rounded = |value| if residual.holds() { settled(value) } else { value };
        let [measured, allowed] = [residual.measured, residual.bound].map(|value| shown(rounded(value), 3, lang));
        writeln!(out, "  {:wide$}   {measured:>11} | {allowed:<11} {mark}", plain(line.law.get(lang)))?;
        if let Some(off) = off(line, lang).filter(|_| !residual.holds()) {
            writeln!(out, "      {off}")?;
        }
    }
    if let Some(says) = &report.says {
        writeln!(out, "\n  → {}", plain(says.get(lang)))?;
    }
    Ok(())
}

/// The case that is off the most.
fn off(line: &Line, lang: Lang) -> Option<String> {
    let case = line.worst()?;
    // as many digits as tell them apart
    let both = |digits| [case.said, case.truth].map(|value| shown(value, digits, lang));
    let digits = [6, 9, 12, 15].into_iter().find(|digits| both(*digits)[0] != both(*digits)[1]);
    let [said, truth] = both(digits.unwrap_or(17));
    Some(match lang {
        Lang::En => format!("{} is {said} and should be {truth}", case.call),
        Lang::Ru => format!("{} равно {said}, а должно быть {truth}", case.call),
    })
}

fn shown(value: f64, digits: usize, lang: Lang) -> String {
    let number = raised(&number(value, digits));
    plain(Text::of(number.clone(), number).get(lang))
}

fn stopped(end: &End, lang: Lang) -> String {
    let text = match end {
        End::Slow(seconds) => Text::of(
            format!("Stopped after {seconds} s: the answer does not come to an end. Does a loop run for ever?"),
            format!("Остановлено через {seconds} с: ответ не кончает работу. Нет ли вечного цикла?"),
        ),
        End::Greedy(megabytes) => Text::of(
            format!("Stopped: the answer wanted more than {megabytes} MB. Does a list grow for ever?"),
            format!("Остановлено: ответу мало {megabytes} МБ памяти. Не растёт ли какой-нибудь список без конца?"),
        ),
        End::Deep => Text::fixed(
            "Stopped: the stack is full. Does a function call itself for ever?",
            "Остановлено: стек переполнен. Не вызывает ли функция сама себя без конца?",
        ),
        End::Panicked(words) => {
            Text::verbatim(format!("The answer panicked:\n{words}"), format!("Ответ завершился аварийно:\n{words}"))
        }
        End::Killed(status) => {
            Text::verbatim(format!("The program was killed: {status}"), format!("Программа прервана: {status}"))
        }
        End::Ended => Text::fixed(
            "The program ended before it was judged. Does the answer call std::process::exit?",
            "Программа кончилась раньше проверки. Не вызывает ли ответ std::process::exit?",
        ),
    };
    text.get(lang).to_owned()
}
