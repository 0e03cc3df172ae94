//! What another rate would make of a column, in words and numbers.

use crate::figure::report::Section;
use crate::figure::report::table::{decibels, frequency, line_frequency, with_unit};
use crate::inspect::table::{ColumnCheck, Landing, Prediction, TableCheck};
use crate::text;
use crate::text::{Text, number};

/// The section of a column at the new rate.
pub(super) fn section(check: &TableCheck, column: &ColumnCheck, prediction: &Prediction<'_>) -> Section {
    let (name, rate) = (&column.heading.name, frequency(check, prediction.rate, 7));
    let half = frequency(check, 0.5 * prediction.rate, 7);
    let section = Section::new(text!("{name} at {rate}", "{name} при {rate}"));
    let ratio = prediction.signal_to_alias();
    if ratio == f64::INFINITY {
        return section.say(text!(
            "Nothing aliases: there is nothing at or above half that rate, {half}.",
            "Наложений нет: от половины этой частоты, {half}, и выше ничего нет."
        ));
    }
    let tolerance = number(check.tolerance, 3);
    let fine = ratio >= check.tolerance;
    let shown = number(ratio, 3);
    let verdict = match fine {
        _ if ratio <= 0.0 => text!(
            "Taken at {rate} without a filter, what is above {half} lands below it, stronger than what stays there.",
            "При взятии отсчётов с частотой {rate} без фильтра всё, что выше {half}, окажется ниже её и будет сильнее \
             остального."
        ),
        true => text!(
            "Taken at {rate} without a filter, what is above {half} lands below it, {shown} dB under the signal: within the \
             tolerance of {tolerance} dB.",
            "При взятии отсчётов с частотой {rate} без фильтра всё, что выше {half}, окажется ниже её, на {shown} дБ слабее \
             сигнала: допуск {tolerance} дБ выдержан."
        ),
        false => text!(
            "Taken at {rate} without a filter, what is above {half} lands below it, only {shown} dB under the signal: above \
             the tolerance of {tolerance} dB.",
            "При взятии отсчётов с частотой {rate} без фильтра всё, что выше {half}, окажется ниже её, лишь на {shown} дБ \
             слабее сигнала: допуск {tolerance} дБ нарушен."
        ),
    };
    let section = section.say(verdict);
    let section = rest(prediction).into_iter().fold(section, Section::say);
    let section = if fine { section } else { section.say(remedy(check, prediction)) };
    if prediction.landings.is_empty() {
        return section;
    }
    let head = [
        text!("line", "линия"),
        text!("amplitude", "амплитуда"),
        text!("lands at", "окажется на"),
        text!("under the signal, dB", "ниже сигнала, дБ"),
    ];
    let (total, resolution) = (column.found.energy.total(), column.found.spectrum.resolution());
    let row = |landing: &Landing| {
        let under = decibels(total / landing.line.energy());
        let amplitude = with_unit(landing.line.amplitude, &column.heading.unit, 4);
        let [line, alias] =
            [landing.line.frequency, landing.alias.frequency()].map(|f| line_frequency(check, f, resolution));
        [line, amplitude, alias, under].map(|cell| Text::of(cell.clone(), cell)).to_vec()
    };
    section.table(head, prediction.landings.iter().map(row))
}

/// What folds beside lines.
fn rest(prediction: &Prediction<'_>) -> Option<Text> {
    let (all, rest) = (prediction.aliased(), prediction.aliased_rest());
    let part = rest / all;
    (part > 0.01).then(|| {
        let share = super::percent(part);
        text!(
            "Of what folds, {share} is in no line: a broad spectrum, or noise, which spreads over all frequencies.",
            "Из того, что наложится, {share} не в линиях: широкий спектр или шум, который распределится по всем частотам."
        )
    })
}

fn remedy(check: &TableCheck, prediction: &Prediction<'_>) -> Text {
    let half = frequency(check, 0.5 * prediction.rate, 7);
    match prediction.rate_for(check.tolerance) {
        Some(rate) => {
            let rate = frequency(check, rate, 4);
            text!(
                "Filter out what is above {half} first; without a filter a rate above {rate} would do.",
                "Сначала отфильтруйте всё выше {half}; без фильтра хватило бы частоты выше {rate}."
            )
        }
        None => text!(
            "Filter out what is above {half} first; which rate would do without a filter, these samples do not resolve.",
            "Сначала отфильтруйте всё выше {half}; какой частоты хватило бы без фильтра, по этим отсчётам не определить."
        ),
    }
}
