//! The report on a sound.

mod answer;
mod file;
mod picture;
pub mod spectrum;

use crate::door::wav::Encoding;
use crate::figure::report::Report;
use crate::inspect::sound::{Check, Ending};
use crate::text;
use crate::text::Text;

/// What was checked, and what it is called.
#[derive(Debug, Clone, Copy)]
pub struct Subject<'a> {
    /// The name of the file.
    pub name: &'a str,
    /// What its samples are.
    pub encoding: Encoding,
    /// What was found.
    pub check: &'a Check,
}

/// The report: verdict, numbers, picture, and what to do.
///
/// ```
/// use nyquist::door::wav::Encoding;
/// use nyquist::figure::report::sound::{Subject, report};
/// use nyquist::inspect::sound::{Check, Meter};
/// use nyquist::num::sin_pi;
/// use nyquist::text::Lang;
/// let tone = |f: f64, i: u32| sin_pi(2.0 * (f / 48_000.0 * f64::from(i)).fract());
/// let mut meter = Meter::new(48_000.0, 1)?;
/// meter.push(&(0..48_000).map(|i| 0.5 * tone(1_000.0, i) + 0.05 * tone(9_100.0, i)).collect::<Vec<_>>())?;
/// let check = Check::new(meter.finish()?, Some(16_000.0), 60.0)?;
/// let report = report(&Subject { name: "two.wav", encoding: Encoding::Float64, check: &check });
/// let title = report.portrait.title.get(Lang::En);
/// assert_eq!(title, "two.wav at 16000 Hz: aliases only 20.0 dB below the signal (tolerance 60 dB)");
/// // an arrow from 9100 Hz to 6900 Hz
/// assert!(report.portrait.figure.layer("folds").is_some());
/// # Ok::<(), nyquist::error::Error>(())
/// ```
pub fn report(subject: &Subject) -> Report {
    let mut sections = vec![file::section(subject)];
    sections.extend(answer::sections(subject));
    Report { portrait: picture::portrait(subject, verdict(subject)), sections }
}

/// The answer in one sentence.
fn verdict(subject: &Subject) -> Text {
    let Subject { name, check, .. } = subject;
    let own = check.sound().rate();
    let (ratio, tolerance) = (decibels(check.ratio().abs()), check.tolerance());
    if check.sound().channels().iter().all(|channel| channel.silent()) {
        return text!("{name}: silence, nothing to alias", "{name}: тишина, алиасам взяться неоткуда");
    }
    let Some(rate) = check.rate() else {
        return if let (true, Some(ending @ Ending::Cut { at, .. })) = (check.fine(), check.ending())
            && let Some(enough) = ending.enough().filter(|rate| f64::from(*rate) < own)
        {
            let at = hertz(at);
            text!(
                "{name}: no sign of aliasing, and nothing above {at} of {} Hz: {enough} Hz would have been enough",
                "{name}: признаков алиасинга нет, выше {at} из {} Гц пусто: хватило бы {enough} Гц",
                0.5 * own
            )
        } else if check.fine() {
            text!(
                "{name}: no sign of aliasing at its own rate of {own} Hz",
                "{name}: признаков алиасинга при собственной частоте {own} Гц нет"
            )
        } else {
            text!(
                "{name}: goes on up to its Nyquist frequency, {} Hz, and may be aliased",
                "{name}: доходит до своей частоты Найквиста, {} Гц, и может содержать алиасы",
                0.5 * own
            )
        };
    };
    match check.ratio() {
        _ if rate >= own => text!(
            "{name} at {rate} Hz: no lower than its own {own} Hz, nothing aliases",
            "{name} при {rate} Гц: не ниже собственных {own} Гц, алиасов нет"
        ),
        f64::INFINITY => text!("{name} at {rate} Hz: nothing aliases", "{name} при {rate} Гц: алиасов нет"),
        below if check.fine() || below >= 0.0 => {
            let (only_en, only_ru) = if check.fine() { ("", "") } else { ("only ", "всего ") };
            text!(
                "{name} at {rate} Hz: aliases {only_en}{ratio} dB below the signal (tolerance {tolerance} dB)",
                "{name} при {rate} Гц: алиасы {only_ru}на {ratio} дБ ниже сигнала (допуск {tolerance} дБ)"
            )
        }
        _ => text!(
            "{name} at {rate} Hz: aliases {ratio} dB above the signal (tolerance {tolerance} dB)",
            "{name} при {rate} Гц: алиасы на {ratio} дБ выше сигнала (допуск {tolerance} дБ)"
        ),
    }
}

/// A level or a ratio to a tenth.
fn decibels(value: f64) -> String {
    if value.is_infinite() { if value < 0.0 { "−∞".into() } else { "∞".into() } } else { format!("{value:.1}") }
}

/// A frequency to a whole number, or to three digits where it is low.
fn hertz(value: f64) -> String {
    match value {
        _ if value >= 100.0 || value == 0.0 => format!("{value:.0}"),
        _ if value >= 10.0 => format!("{value:.1}"),
        _ => format!("{value:.2}"),
    }
}

/// The frequency of a line, which is known far better than to a bin.
fn exactly(value: f64) -> String {
    if value >= 1000.0 { format!("{value:.1}") } else { format!("{value:.2}") }
}

/// The same in both languages, but for the decimal comma.
fn number(value: String) -> Text {
    Text::of(value.clone(), value)
}
