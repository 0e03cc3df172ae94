//! The occupied band, in words and numbers, and what it says of the rate.

use crate::figure::report::Section;
use crate::figure::report::table::{decibels, frequency, percent};
use crate::inspect::table::{Findings, Line, TableCheck};
use crate::record::Kind;
use crate::text;
use crate::text::Text;

/// The parts of the energy that are asked for.
const PARTS: [(&str, f64); 3] = [("99 %", 0.99), ("99.9 %", 0.999), ("99.99 %", 0.9999)];

/// The bands of the three parts of the energy.
pub(super) fn sentence(check: &TableCheck, found: &Findings) -> Text {
    let list = |below: &str, unknown: &str| {
        let of = |(name, part): (&str, f64)| match found.energy.occupied(part) {
            Some(band) => format!("{name} {below} {}", frequency(check, band, 4)),
            None => format!("{name} {unknown}"),
        };
        PARTS.map(of).join(", ")
    };
    let start = Text::of(
        format!("Of its energy: {}.", list("below", "not resolved")),
        format!("Из его энергии: {}.", list("ниже", "не разрешено")),
    );
    let unresolved = found.energy.unresolved() / found.energy.total();
    if unresolved < 1e-6 {
        return start;
    }
    let (part, level) = (percent(unresolved), decibels(unresolved));
    let what = if found.energy.band().is_finite() {
        let band = frequency(check, found.energy.band(), 4);
        text!(
            "{part} ({level} dB) is above {band}, or noise: these times do not tell.",
            "{part} ({level} дБ) выше {band} или шум: по этим моментам не определить."
        )
    } else {
        text!("{part} ({level} dB) is not resolved.", "{part} ({level} дБ) не разрешено.")
    };
    start.and(&Text::same(" ")).and(&what)
}

/// The same as a table, with the rates that they need.
pub(super) fn table(section: Section, check: &TableCheck, found: &Findings) -> Section {
    let head = [
        text!("of the energy", "энергии"),
        text!("lies below", "лежит ниже"),
        text!("needs a rate above", "нужна частота выше"),
    ];
    let row = |(name, part): (&'static str, f64)| {
        let band = found.energy.occupied(part);
        let shown = |value: Option<f64>| value.map_or("–".to_owned(), |value| frequency(check, value, 4));
        [name.to_owned(), shown(band), shown(band.map(|band| 2.0 * band))]
            .map(|cell| Text::of(cell.clone(), cell))
            .to_vec()
    };
    section.table(head, PARTS.map(row))
}

/// The upper tenth of the spectrum holds nothing worth speaking of.
const QUIET: f64 = 1e-4;

/// Whether the spectrum ends before the Nyquist frequency: the only sign there is of a rate that sufficed.
pub(super) fn judgement(check: &TableCheck, found: &Findings) -> Option<Text> {
    let sampling = &check.sampling;
    let top = 0.5 / sampling.step()?;
    // what is not resolved counts as what is beyond the band that is
    if sampling.kind() == Kind::Irregular || found.energy.band() < 0.7 * top || found.energy.band().is_infinite() {
        return None;
    }
    let lines = |from: f64| found.lines.iter().filter(|l| l.frequency >= from).map(Line::energy).sum::<f64>();
    let rest = |from: f64| found.energy.above(from) - lines(from);
    let share = found.energy.above(0.9 * top) / found.energy.total();
    let (part, level, at) = (percent(share), decibels(share), frequency(check, top, 4));
    if share <= QUIET {
        return Some(text!(
            "Its upper tenth, up to {at}, is empty ({level} dB): nothing points to a rate that was too low.",
            "Верхняя десятая часть спектра, до {at}, пуста ({level} дБ): ничто не указывает на слишком низкую частоту."
        ));
    }
    // even would be a quarter of what the four tenths below hold
    let (edge, middle) = (rest(0.9 * top), rest(0.5 * top));
    let even = edge / (0.25 * (middle - edge)).max(f64::MIN_POSITIVE);
    Some(if (0.5..2.0).contains(&even) && lines(0.9 * top) <= QUIET * found.energy.total() {
        text!(
            "An even floor reaches up to {at} ({part} of the energy, {level} dB, in its upper tenth): noise. If the sensor \
             has less, it was folded in for want of a filter before sampling.",
            "Ровный фон доходит до {at} (в верхней десятой части {part} энергии, {level} дБ): шум. Если датчик шумит \
             меньше, шум наложился из-за отсутствия фильтра перед дискретизацией."
        )
    } else {
        text!(
            "The spectrum does not end below {at} ({part} of the energy, {level} dB, in its upper tenth): it may well have \
             gone on and folded. Sample faster, or filter before sampling, to be sure.",
            "Спектр не кончается ниже {at} (в верхней десятой части {part} энергии, {level} дБ): он вполне мог идти выше \
             и наложиться. Чтобы исключить это, увеличьте частоту или фильтруйте до дискретизации."
        )
    })
}
