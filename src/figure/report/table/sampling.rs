//! How a table was sampled, in words.

use crate::figure::report::Section;
use crate::figure::report::table::{frequency, percent, with_unit};
use crate::inspect::table::{Likeness, TableCheck};
use crate::record::{Kind, Order};
use crate::text;
use crate::text::Text;

/// The section of the sampling.
pub(super) fn section(check: &TableCheck) -> Section {
    let said = [
        Some(kind(check)),
        gaps(check),
        pieces(check),
        looked_at(check),
        order(check),
        duplicates(check),
        left_out(check),
        latin(check),
    ];
    let section = said.into_iter().flatten().fold(Section::new(text!("Sampling", "Дискретизация")), Section::say);
    likenesses(check).into_iter().fold(limits(check).into_iter().fold(section, Section::say), Section::say)
}

fn time(check: &TableCheck, value: f64, digits: usize) -> String {
    with_unit(value, check.unit(), digits)
}

fn kind(check: &TableCheck) -> Text {
    let sampling = &check.sampling;
    let n = sampling.positions().len();
    let length = time(check, sampling.length(), 6);
    let ends = format!("{} … {}", check.shown(0), check.shown(n - 1));
    let Some(step) = sampling.step() else {
        let [least, median, most] = sampling.ways().map(|way| time(check, way, 4));
        return text!(
            "{n} samples over {length} ({ends}), at irregular times: from {least} to {most} apart, {median} in the median. No \
             step underlies them.",
            "{n} отсчётов за {length} ({ends}) в нерегулярные моменты: промежутки от {least} до {most}, медиана {median}. \
             Общего шага нет."
        );
    };
    let (rate, rounding) = (frequency(check, 1.0 / step, 5), sampling.rounding());
    let shown = time(check, step, 5);
    if sampling.kind() == Kind::Jittered {
        let jitter = sampling.jitter();
        let (rms, most) = (time(check, jitter.rms, 3), time(check, jitter.most, 3));
        let (part, worst) = (percent(jitter.rms / step), percent(jitter.most / step));
        return text!(
            "{n} samples over {length} ({ends}), about {shown} apart: a rate of {rate}. They stray from that grid by {rms} \
             in the root mean square ({part} of the step) and by {most} at most ({worst}).",
            "{n} отсчётов за {length} ({ends}) с шагом около {shown}: частота дискретизации {rate}. Их отклонения от этой \
             сетки: среднеквадратичное {rms} ({part} шага), наибольшее {most} ({worst})."
        );
    }
    let every = text!(
        "{n} samples over {length} ({ends}), {shown} apart: a rate of {rate}.",
        "{n} отсчётов за {length} ({ends}) с шагом {shown}: частота дискретизации {rate}."
    );
    if check.table.clock.is_none() || rounding == 0.0 {
        return every;
    }
    let half = time(check, rounding, 2);
    let coarse = 2.0 * rounding > step;
    let printed = match coarse {
        true => text!(
            "Times are printed more coarsely than that (to {half} either way) and are taken for equally spaced, which they can \
             be.",
            "Моменты напечатаны грубее (с точностью до {half}) и приняты за равноотстоящие, что им не противоречит."
        ),
        false => text!(
            "The printed times, right to {half} either way, are equally spaced.",
            "Напечатанные моменты (с точностью до {half}) расположены равномерно."
        ),
    };
    every.and(&Text::same(" ")).and(&printed)
}

fn gaps(check: &TableCheck) -> Option<Text> {
    let gaps = check.sampling.gaps();
    let longest = gaps.iter().max_by_key(|gap| gap.missing)?;
    let missing: usize = gaps.iter().map(|gap| gap.missing).sum();
    let (gap, position) = check.sampling.largest_gap();
    let (after, line, most) = (check.shown(position), check.line(position), longest.missing);
    let (n, gap) = (gaps.len(), time(check, gap, 4));
    let (places, are) = (if n == 1 { "place" } else { "places" }, if most == 1 { "is" } else { "are" });
    let share = percent(missing as f64 / (missing + check.sampling.positions().len()) as f64);
    Some(text!(
        "Missing samples: {missing} ({share}), in {n} {places}; the most in a row {are} {most}: {gap} without a sample after \
         {after} (line {line}).",
        "Пропущено отсчётов: {missing} ({share}), мест: {n}; больше всего подряд {most}: {gap} без отсчётов после {after} \
         (строка {line})."
    ))
}

fn pieces(check: &TableCheck) -> Option<Text> {
    let n = check.sampling.stretches().len();
    (n > 1).then(|| {
        text!(
            "Long gaps part the record into {n} stretches; nothing is said of what happened between them.",
            "Длинные пропуски делят запись на части: {n}; о происходившем между ними ничего не известно."
        )
    })
}

fn looked_at(check: &TableCheck) -> Option<Text> {
    let stretch = check.columns.first()?.found.looked_at.clone();
    let all = check.sampling.positions().len();
    (stretch.len() < all).then(|| {
        let (n, first, last) = (stretch.len(), check.shown(stretch.start), check.shown(stretch.end - 1));
        text!(
            "The record is nearly all gaps; what follows is of its longest stretch alone, {n} samples from {first} to {last}.",
            "Запись почти целиком состоит из пропусков; дальнейшее относится лишь к самой длинной части: {n} отсчётов от {first} \
             до {last}."
        )
    })
}

fn order(check: &TableCheck) -> Option<Text> {
    match check.sampling.order() {
        Order::Rising => None,
        Order::Falling => Some(text!(
            "The rows run backwards in time; they were turned round.",
            "Строки идут назад во времени; порядок обращён."
        )),
        Order::Mixed { falls, first } => {
            let (line, are) = (check.table.lines[first], if falls == 1 { "is" } else { "are" });
            Some(text!(
                "The rows are out of order: {falls} {are} earlier than the row before, the first on line {line}. They were sorted.",
                "Порядок строк нарушен: раньше предыдущей строк {falls}, первая из них — строка {line}. Строки упорядочены."
            ))
        }
    }
}

fn duplicates(check: &TableCheck) -> Option<Text> {
    let duplicates = check.sampling.duplicates();
    let differ = check.columns.iter().map(|column| column.disagreements).max().unwrap_or(0);
    (duplicates.rows > 0).then(|| {
        let (rows, line) = (duplicates.rows, check.table.lines[duplicates.first]);
        text!(
            "Rows whose time stood there before: {rows}, the first on line {line}; times whose values differ: {differ}, where \
             the mean is used.",
            "Строк с уже встречавшимся моментом: {rows}, первая — строка {line}; моментов с различными значениями: {differ}, \
             взято среднее."
        )
    })
}

fn left_out(check: &TableCheck) -> Option<Text> {
    let skipped = check.table.skipped;
    (skipped.rows > 0).then(|| {
        let (rows, line) = (skipped.rows, skipped.first_line);
        text!(
            "Rows left out, since a value is missing in them: {rows}, the first on line {line}.",
            "Пропущено строк без значений: {rows}, первая — строка {line}."
        )
    })
}

fn latin(check: &TableCheck) -> Option<Text> {
    check
        .table
        .latin
        .then(|| text!("The text is not UTF-8; it was read as Latin-1.", "Текст не в UTF-8; он прочитан как Latin-1."))
}

fn limits(check: &TableCheck) -> Option<Text> {
    let sampling = &check.sampling;
    let highest = frequency(check, sampling.highest_band(), 5);
    if sampling.axis().is_some() {
        return Some(text!(
            "Frequencies below the Nyquist frequency {highest} can be told apart. What was above it when the samples were taken \
             has folded already, and nothing in them can tell.",
            "Различимы частоты ниже частоты Найквиста {highest}. Всё, что было выше при взятии отсчётов, уже наложилось, и по \
             ним этого не узнать."
        ));
    }
    let grid = sampling.step().filter(|_| sampling.kind() == Kind::Gaps).map(|step| {
        let half = frequency(check, 0.5 / step, 5);
        text!(
            "Being on a grid, they do not tell frequencies above {half} from their mirror images below. ",
            "Лежа на сетке, они не отличают частоты выше {half} от их зеркальных образов ниже. "
        )
    });
    let (gap, position) = sampling.largest_gap();
    let (density, safe) = (frequency(check, sampling.density(), 5), frequency(check, sampling.safe_band(), 4));
    let (gap, after, line) = (time(check, gap, 4), check.shown(position), check.line(position));
    let limits = text!(
        "Their density is {density} on average, so that no band above {highest} is determined (Landau); every band below \
         {safe} is, and stably: the largest gap is {gap}, after {after} (line {line}; Gröchenig).",
        "Их средняя плотность {density}, поэтому полоса выше {highest} не определена (Ландау); любая полоса ниже {safe} \
         определена, и устойчиво: наибольший промежуток {gap}, после {after} (строка {line}; Грёхениг)."
    );
    Some(grid.unwrap_or_default().and(&limits))
}

fn likenesses(check: &TableCheck) -> Vec<Text> {
    let found = check.columns.first().map_or(&[][..], |column| &column.found.likenesses[..]);
    let say = |likeness: &Likeness| {
        let (shift, height) = (frequency(check, likeness.shift, 4), percent(likeness.height));
        // a shift by the rate is what equally spaced samples cannot tell at all
        if check.sampling.step().is_some_and(|step| (likeness.shift * step - 1.0).abs() < 0.01) {
            let half = frequency(check, 0.5 * likeness.shift, 4);
            return text!(
                "They are so nearly equally spaced that a line above {half} and its mirror image below it are alike to {height} \
                 at these times.",
                "Они столь близки к равномерным, что линия выше {half} и её зеркальный образ ниже в эти моменты похожи на \
                 {height}."
            );
        }
        text!(
            "Lines whose frequencies differ by {shift} (or add up to it) are alike to {height} at these times: which of them \
             it is, they hardly tell.",
            "Линии, частоты которых отличаются на {shift} (или дают это в сумме), в эти моменты похожи на {height}: какая из \
             них настоящая, отсчёты почти не говорят."
        )
    };
    found.iter().map(say).collect()
}
