//! Outcomes as a table in Markdown.

use crate::race::{Line, Outcome};
use std::fmt::Write;

/// One line a case: ours over the fastest of all others, in whichever run it took part, on one thread and on two.
pub fn summary(outcomes: &[Outcome]) -> String {
    let mut out = String::from(
        "| job | case | one thread | | two threads | |\n\
         | --- | --- | ---: | --- | ---: | --- |\n",
    );
    let mut seen: Vec<(&str, &str)> = Vec::new();
    for outcome in outcomes {
        let case = (outcome.job.as_str(), outcome.case.as_str());
        if seen.contains(&case) {
            continue;
        }
        seen.push(case);
        let worst = |threads: usize| {
            let runs =
                outcomes.iter().filter(|o| (o.job.as_str(), o.case.as_str(), o.threads) == (case.0, case.1, threads));
            let ratios = runs.filter_map(|o| Some((o.ratio()?, o.best(false)?.name.as_str())));
            let slowest = ratios.max_by(|a, b| a.0.total_cmp(&b.0));
            slowest.map_or(["—".to_owned(), String::new()], |(ratio, who)| [format!("{ratio:.2}"), who.to_owned()])
        };
        let ([one, by_one], [two, by_two]) = (worst(1), worst(2));
        writeln!(out, "| {} | {} | {one} | {by_one} | {two} | {by_two} |", case.0, case.1)
            .expect("writing to a string cannot fail");
    }
    out
}

/// The rows of the outcomes: ours, the best other, their ratio, the limit, and the errors beside the times.
pub fn table(outcomes: &[Outcome]) -> String {
    let mut out = String::from(
        "| job | case | threads | nyquist, ms | best other, ms | ratio | limit, ms | of the limit | error | its error | MB | its MB |\n\
         | --- | --- | ---: | ---: | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n",
    );
    for outcome in outcomes {
        let [ours, other] = [true, false].map(|ours| outcome.best(ours));
        let time = |line: &Line| format!("{} ± {}", milliseconds(line.median), milliseconds(line.spread));
        let limit = outcome.limit.as_ref().map(|(seconds, _)| *seconds);
        let cells = [
            outcome.job.clone(),
            outcome.case.clone(),
            outcome.threads.to_string(),
            ours.map_or("—".into(), time),
            other.map_or("—".into(), |line| format!("{} ({})", time(line), line.name)),
            outcome.ratio().map_or("—".into(), |ratio| format!("**{ratio:.2}**")),
            limit.map_or("—".into(), milliseconds),
            ours.zip(limit).map_or("—".into(), |(line, limit)| format!("{:.1} ×", line.median / limit)),
            ours.map_or("—".into(), |line| error(line.error)),
            other.map_or("—".into(), |line| error(line.error)),
            ours.map_or("—".into(), memory),
            other.map_or("—".into(), memory),
        ];
        writeln!(out, "| {} |", cells.join(" | ")).expect("writing to a string cannot fail");
    }
    out
}

/// All contenders of the outcomes, line by line.
pub fn details(outcomes: &[Outcome]) -> String {
    let mut out = String::from(
        "| job | case | threads | who | least, ms | median, ms | quartiles ± | error | MB |\n\
         | --- | --- | ---: | --- | ---: | ---: | ---: | ---: | ---: |\n",
    );
    for outcome in outcomes {
        for line in &outcome.lines {
            let unable = if line.error <= outcome.allowed { "" } else { " (errs too much)" };
            let cells = [
                outcome.job.clone(),
                outcome.case.clone(),
                outcome.threads.to_string(),
                format!("{}{unable}", line.name),
                milliseconds(line.least),
                milliseconds(line.median),
                milliseconds(line.spread),
                error(line.error),
                memory(line),
            ];
            writeln!(out, "| {} |", cells.join(" | ")).expect("writing to a string cannot fail");
        }
    }
    out
}

/// What each limit counts.
pub fn limits(outcomes: &[Outcome]) -> String {
    let told = outcomes.iter().filter_map(|o| Some((&o.job, &o.limit.as_ref()?.1)));
    let mut lines: Vec<String> = told.map(|(job, counts)| format!("- {job}: {counts}\n")).collect();
    lines.dedup();
    lines.concat()
}

fn milliseconds(seconds: f64) -> String {
    let value = 1e3 * seconds;
    match value {
        _ if value >= 100.0 => format!("{value:.0}"),
        _ if value >= 10.0 => format!("{value:.1}"),
        _ if value >= 1.0 => format!("{value:.2}"),
        _ if value >= 0.01 => format!("{value:.4}"),
        _ => format!("{value:.5}"),
    }
}

fn error(value: f64) -> String {
    if value == 0.0 { "0".into() } else { format!("{value:.1e}") }
}

fn memory(line: &Line) -> String {
    // smaller ones the system does not tell apart
    let told = |megabytes: f64| if megabytes < 10.0 { format!("{megabytes:.1}") } else { format!("{megabytes:.0}") };
    line.memory.map_or("—".into(), told)
}
