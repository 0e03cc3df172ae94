//! The report of a table: how it was sampled, what is in it, and where its lines would go at another rate.

mod bands;
mod column;
mod picture;
mod rate;
mod sampling;
pub mod spectrum;

use crate::figure::Portrait;
use crate::figure::report::Report;
use crate::inspect::table::{Prediction, TableCheck, units};
use crate::text;
use crate::text::{Text, number};

/// What a table's check found, in words, tables and a picture.
///
/// ```
/// use nyquist::door::table::{Reading, read_table};
/// use nyquist::figure::report::table::report;
/// use nyquist::inspect::table::{Look, TOLERANCE, TableCheck};
/// use nyquist::text::Lang;
/// let row = |k: i32| format!("{},{}\n", f64::from(k) / 100.0, nyquist::num::cos_pi(0.6 * f64::from(k)));
/// let text = format!("t [s],U [V]\n{}", (0..200).map(row).collect::<String>());
/// let table = read_table("tone.csv", text.as_bytes(), &Reading::default())?;
/// let check = TableCheck::new(table, None, Look::default(), Some(50.0), TOLERANCE)?;
/// let said = report(&check);
/// assert!(said.portrait.title.get(Lang::En).starts_with("tone.csv: 200 samples at 100 Hz; at 50 Hz"));
/// assert_eq!(said.sections.len(), 3); // the sampling, the column, the new rate
/// assert!(said.portrait.figure.layer("aliases").is_some()); // before, and after:
/// assert!(said.portrait.figure.layer("landed").is_some());
/// # Ok::<(), nyquist::error::Error>(())
/// ```
pub fn report(check: &TableCheck) -> Report {
    let predictions = check.predictions();
    let mut sections = vec![sampling::section(check)];
    sections.extend(check.columns.iter().map(|column| column::section(check, column)));
    sections.extend(check.columns.iter().zip(&predictions).map(|(c, prediction)| rate::section(check, c, prediction)));
    // the column that fares worst is drawn
    let ratio = |i: &usize| predictions.get(*i).map_or(0.0, Prediction::signal_to_alias);
    let drawn = (0..check.columns.len()).min_by(|a, b| ratio(a).total_cmp(&ratio(b))).unwrap_or(0);
    let title = title(check, predictions.get(drawn));
    let caption = caption(check);
    let figure = picture::figure(check, &check.columns[drawn], predictions.get(drawn));
    Report { portrait: Portrait { title, caption, figure }, sections }
}

fn title(check: &TableCheck, prediction: Option<&Prediction<'_>>) -> Text {
    let n = check.sampling.positions().len();
    let step = check.sampling.step();
    let rate = frequency(check, 1.0 / step.unwrap_or(check.sampling.mean_step()), 5);
    let file = &check.table.file;
    let start = match step.is_none() {
        false => text!("{file}: {n} samples at {rate}", "{file}: отсчётов {n}, частота дискретизации {rate}"),
        true => text!(
            "{file}: {n} irregular samples, {rate} on average",
            "{file}: нерегулярных отсчётов {n}, в среднем {rate}"
        ),
    };
    let Some(prediction) = prediction else { return start };
    let new = frequency(check, prediction.rate, 6);
    let ratio = prediction.signal_to_alias();
    let verdict = match (ratio == f64::INFINITY, check.fine()) {
        (true, _) => text!("at {new} nothing aliases", "при {new} наложений нет"),
        (false, true) => {
            let ratio = number(ratio, 3);
            text!("at {new} aliases are {ratio} dB below the signal", "при {new} наложения ниже сигнала на {ratio} дБ")
        }
        (false, false) if ratio <= 0.0 => {
            text!("at {new} aliases are stronger than what stays", "при {new} наложения сильнее того, что останется")
        }
        (false, false) => {
            let ratio = number(ratio, 3);
            text!(
                "at {new} aliases are only {ratio} dB below the signal",
                "при {new} наложения лишь на {ratio} дБ ниже сигнала"
            )
        }
    };
    start.and(&Text::same("; ")).and(&verdict)
}

fn caption(check: &TableCheck) -> Text {
    let regular = text!(
        "The samples over time, and the amplitudes of the sinusoids that fit them best, with the lines that stand out",
        "Отсчёты во времени и амплитуды наилучших синусоид с выделяющимися линиями"
    );
    let irregular = text!(
        "The samples over time, the ways from each to the next, and the amplitudes of the sinusoids that fit them best, with \
         the lines that stand out",
        "Отсчёты во времени, промежутки между соседними и амплитуды наилучших синусоид с выделяющимися линиями"
    );
    let start = if check.sampling.axis().is_some() { regular } else { irregular };
    match check.rate {
        None => start.and(&Text::same(".")),
        Some(_) => {
            let arrows = text!(
                "Arrows lead from each line beyond half the new rate to where it would be seen; beside it the spectrum at \
                 the new rate, what stays and what has folded.",
                "Стрелки ведут от каждой линии выше половины новой частоты туда, где она окажется; рядом спектр при новой \
                 частоте: то, что остаётся, и то, что наложилось."
            );
            start.and(&Text::same(". ")).and(&arrows)
        }
    }
}

/// A value with its unit; one per minute is written 1/min.
fn with_unit(value: f64, unit: &str, digits: usize) -> String {
    let number = number(value, digits);
    match unit.strip_prefix("1/") {
        Some(per) if number.contains('^') => format!("{number} · 1/{per}"),
        Some(per) => format!("{number}/{per}"),
        None if unit.is_empty() => number,
        None => format!("{number} {unit}"),
    }
}

/// The frequency of a line, to a ten thousandth of the record's resolution.
fn line_frequency(check: &TableCheck, value: f64, resolution: f64) -> String {
    let unit = 10f64.powf((1e-4 * resolution).log10().floor());
    frequency(check, (value / unit).round() * unit, 9)
}

/// A frequency in the unit that belongs to the table's times.
fn frequency(check: &TableCheck, value: f64, digits: usize) -> String {
    with_unit(value, &units::frequency(check.unit()), digits)
}

/// A part of a whole, in per cent.
fn percent(part: f64) -> String {
    format!("{} %", number(100.0 * part, 2))
}

/// A ratio of energies in dB.
fn decibels(ratio: f64) -> String {
    format!("{:.1}", 10.0 * ratio.log10())
}
