//! What is in a column, in words and numbers.

use crate::figure::report::Section;
use crate::figure::report::table::{bands, decibels, line_frequency, percent, with_unit};
use crate::inspect::table::{ColumnCheck, Line, TableCheck};
use crate::text;
use crate::text::Text;

/// The section of a column.
pub(super) fn section(check: &TableCheck, column: &ColumnCheck) -> Section {
    let (heading, found) = (&column.heading, &column.found);
    let unit = heading.unit.as_str();
    let section = Section::new(text!("Column {heading}", "Столбец {heading}"));
    // a mean that is lost in rounding is none
    let none = found.mean.abs() < 1e-12 * found.rms;
    let mean = with_unit(if none { 0.0 } else { found.mean }, unit, 5);
    if found.rms == 0.0 {
        return section.say(text!(
            "The values are constant: {mean}. There is no frequency but zero.",
            "Значения постоянны: {mean}. Нет никаких частот, кроме нуля."
        ));
    }
    let rms = with_unit(found.rms, unit, 4);
    let spread = text!(
        "Mean {mean}, around it {rms} in the root mean square.",
        "Среднее {mean}, среднеквадратичное отклонение {rms}."
    );
    let section = section.say(spread).say(stand_out(column)).say(bands::sentence(check, found));
    let section = bands::judgement(check, found).into_iter().fold(section, Section::say);
    // one table a section: lines where there are any, else bands alone
    if found.lines.is_empty() {
        return bands::table(section, check, found);
    }
    let head = [
        text!("line", "линия"),
        text!("amplitude", "амплитуда"),
        text!("level, dB", "уровень, дБ"),
        text!("phase, °", "фаза, °"),
    ];
    let (strongest, resolution) = (found.lines[0].amplitude, found.spectrum.resolution());
    let row = |line: &Line| {
        let level = format!("{:.1}", 20.0 * (line.amplitude / strongest).log10());
        let phase = format!("{:.1}", line.phase.to_degrees());
        let cells =
            [line_frequency(check, line.frequency, resolution), with_unit(line.amplitude, unit, 4), level, phase];
        cells.map(|cell| Text::of(cell.clone(), cell)).to_vec()
    };
    section.table(head, found.lines.iter().map(row))
}

fn stand_out(column: &ColumnCheck) -> Text {
    let found = &column.found;
    let (n, total) = (found.lines.len(), found.energy.total());
    let rest = with_unit(found.rest, &column.heading.unit, 3);
    let share = (found.rest * found.rest / total).min(1.0);
    match n {
        0 => text!(
            "No line stands out: the spectrum is broad, or noise.",
            "Ни одна линия не выделяется: спектр широкий или шумовой."
        ),
        _ => {
            let (part, level) = (percent(share), decibels(share));
            text!(
                "Lines that stand out: {n} (below the amplitude A and the phase φ of each A cos(2πνt + φ), t from the first \
                 sample on). Without them {rest} is left in the root mean square, {part} of the energy ({level} dB).",
                "Выделяющихся линий: {n} (ниже амплитуда A и фаза φ каждой A cos(2πνt + φ), t от первого отсчёта). Без них \
                 остаётся среднеквадратичное {rest}, {part} энергии ({level} дБ)."
            )
        }
    }
}
