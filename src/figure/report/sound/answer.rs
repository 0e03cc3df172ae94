//! What would alias, where to, and what to do.

use super::file::{lines, strongest_of};
use super::picture::numbered;
use super::{Subject, decibels, exactly, hertz, number};
use crate::figure::report::Section;
use crate::inspect::sound::{Forecast, Stretch, Way, dbfs};
use crate::text;
use crate::text::Text;

/// Lines and stretches that are shown, the strongest.
const MOST_LINES: usize = 10;
const MOST_STRETCHES: usize = 8;

pub(super) fn sections(subject: &Subject) -> Vec<Section> {
    let check = subject.check;
    if check.sound().channels().iter().all(|channel| channel.silent()) {
        return vec![Section::new(text!("Silence", "Тишина")).say(text!(
            "All values of each channel are the same: there is no band, and nothing that could alias at any rate.",
            "Все значения каждого канала одинаковы: полосы нет, и ни при какой частоте алиасам взяться неоткуда."
        ))];
    }
    match (check.rate(), check.forecasts().get(check.worst())) {
        (Some(rate), Some(forecast)) if rate < check.sound().rate() => {
            let mut sections = vec![ways(subject, forecast)];
            if forecast.outcomes[0].aliases > 0.0 {
                sections.extend([folded(forecast), stretches(forecast)]);
            }
            sections.push(advice(subject, rate));
            sections
        }
        (Some(rate), _) => vec![higher(subject, rate)],
        (None, _) => lines(subject).into_iter().chain([own(subject)]).collect(),
    }
}

/// The channel that the numbers are of, where there are several: that of the lowest ratio.
fn of_channel(subject: &Subject) -> Option<Text> {
    let (all, worst) = (subject.check.sound().channels().len(), subject.check.worst() + 1);
    (all > 1).then(|| match subject.check.rate() {
        Some(_) => text!(
            "Channel {worst} of {all}, whose signal is the fewest dB above its aliases.",
            "Канал {worst} из {all}: у него отношение сигнала к алиасам наименьшее."
        ),
        None => text!(
            "Channel {worst} of {all}, whose last sixteenth is the fewest dB below the whole.",
            "Канал {worst} из {all}: у него последняя шестнадцатая спектра меньше всего уступает целому."
        ),
    })
}

/// What a way is called.
fn called(way: Way, rate: f64, own: f64) -> Text {
    match way {
        Way::Plain if own % rate == 0.0 => {
            let every = own / rate;
            text!("plain: one sample in {every}", "просто: каждый {every}-й отсчёт")
        }
        Way::Plain => text!("plain: the values at the new times", "просто: значения в новые моменты"),
        Way::Filtered(quality) => text!("resample --quality {quality}", "resample --quality {quality}"),
    }
}

fn ways(subject: &Subject, forecast: &Forecast) -> Section {
    let (rate, own) = (forecast.rate, subject.check.sound().rate());
    let mut section = Section::new(text!("At {rate} Hz", "При {rate} Гц")).say(text!(
        "What lies beyond the new Nyquist frequency, {} Hz, folds back below it.",
        "Всё, что выше новой частоты Найквиста, {} Гц, заворачивается под неё.",
        0.5 * rate
    ));
    if let Some(channel) = of_channel(subject) {
        section = section.say(channel);
    }
    if let Some(loudest) = forecast.loudest {
        let [aliases, signal] = [loudest.beyond, loudest.total - loudest.beyond].map(|p| decibels(dbfs(p)));
        section = section.say(text!(
            "Loudest at {:.2} s: for an instant the aliases of plain sampling reach {aliases} dBFS, beside {signal} dBFS of signal.",
            "Громче всего на {:.2} с: на мгновение алиасы простой выборки достигают {aliases} dBFS при сигнале {signal} dBFS.",
            loudest.time
        ));
    }
    if !subject.encoding.is_float() {
        let bits = subject.encoding.bits();
        let dither = decibels(dbfs(0.25 * subject.encoding.step().powi(2)));
        section = section.say(text!(
            "Before the result is rounded: dithered to {bits} bits it also has noise of {dither} dBFS.",
            "До округления результата: с дизером до {bits} бит к нему добавится шум {dither} dBFS."
        ));
    }
    let head = [
        text!("way", "способ"),
        text!("signal", "сигнал"),
        text!("aliases", "алиасы"),
        text!("signal to aliases", "сигнал/алиасы"),
    ];
    let rows = forecast.outcomes.iter().map(|outcome| {
        // of filtered ways the aliases are a bound
        let most = if outcome.way == Way::Plain || outcome.aliases == 0.0 { "" } else { "≤ " };
        let least = if most.is_empty() { "" } else { "≥ " };
        vec![
            called(outcome.way, rate, own),
            text!("{} dBFS", "{} dBFS", decibels(dbfs(outcome.signal))),
            text!("{most}{} dBFS", "{most}{} dBFS", decibels(dbfs(outcome.aliases))),
            text!("{least}{} dB", "{least}{} дБ", decibels(outcome.ratio())),
        ]
    });
    section.table(head, rows)
}

fn folded(forecast: &Forecast) -> Section {
    let section = Section::new(text!(
        "Tones that would alias, and where each lands",
        "Тоны, которые дадут алиасы, и куда каждый попадёт"
    ));
    if forecast.folded.is_empty() {
        return section.say(text!(
            "None stands 10 dB above its surroundings: what folds is broad.",
            "Ни один не выступает над окружением на 10 дБ: заворачивается сплошной спектр."
        ));
    }
    let head = [text!("tone", "тон"), text!("lands at", "окажется на")]
        .into_iter()
        .chain(Way::ALL.map(|way| match way {
            Way::Plain => text!("plain, dBFS", "просто, dBFS"),
            Way::Filtered(quality) => text!("{quality}", "{quality}"),
        }))
        .collect::<Vec<_>>();
    let rows = forecast.folded.iter().take(MOST_LINES).map(|folded| {
        let levels = folded.gains.iter().enumerate().map(|(i, gain)| {
            let most = if i == 0 { "" } else { "≤ " };
            number(format!("{most}{}", decibels(dbfs(folded.line.power() * gain * gain))))
        });
        let places = [folded.line.frequency, folded.alias.frequency()];
        places.map(|place| text!("{} Hz", "{} Гц", exactly(place))).into_iter().chain(levels).collect()
    });
    strongest_of(section.table(head, rows), forecast.folded.len(), MOST_LINES)
}

fn stretches(forecast: &Forecast) -> Section {
    let mut strongest: Vec<&Stretch> = forecast.stretches.iter().collect();
    strongest.sort_by(|a, b| b.power.total_cmp(&a.power));
    strongest.truncate(MOST_STRETCHES);
    strongest.sort_by(|a, b| a.landing.from[0].total_cmp(&b.landing.from[0]));
    let head = [
        text!("all that folds", "всё, что заворачивается"),
        text!("lands at", "окажется на"),
        text!("level", "уровень"),
    ];
    let rows = strongest.into_iter().map(|stretch| {
        let [from, to] = [stretch.landing.from, stretch.landing.to].map(|[a, b]| [hertz(a), hertz(b)]);
        vec![
            text!("{} to {} Hz", "{} … {} Гц", from[0], from[1]),
            text!("{} to {} Hz", "{} … {} Гц", to[0], to[1]),
            text!("{} dBFS", "{} dBFS", decibels(dbfs(stretch.power))),
        ]
    });
    let section = Section::new(text!("By bands", "По полосам")).table(head, rows);
    strongest_of(section, forecast.stretches.len(), MOST_STRETCHES)
}

fn advice(subject: &Subject, rate: f64) -> Section {
    let (check, name) = (subject.check, subject.name);
    let tolerance = check.tolerance();
    let mut section = Section::new(text!("What to do", "Что делать"));
    if let Some((channel, ratio)) = check.burst_in() {
        let [en, ru] = numbered(subject, channel);
        section = section.say(text!(
            "The mean is within the tolerance, but not every moment: at {:.2} s{en} the aliases come up to {} dB below the mean \
             of the signal.",
            "Среднее в пределах допуска, но не каждое мгновение: на {:.2} с{ru} алиасы всего на {} дБ ниже среднего сигнала.",
            check.forecasts()[channel].loudest.map_or(0.0, |loudest| loudest.time),
            decibels(ratio)
        ));
    }
    section = match (check.fine(), check.remedy()) {
        (true, _) => section.say(text!(
            "At this tolerance samples may be dropped as they are. A filter is better all the same: nyquist resample {name} OUT.wav --rate {rate}",
            "При таком допуске отсчёты можно просто выбросить. С фильтром всё равно чище: nyquist resample {name} OUT.wav --rate {rate}"
        )),
        (false, Some(way)) => section.say(text!(
            "Filter before dropping samples; this keeps the aliases below the tolerance: nyquist resample {name} OUT.wav --rate {rate} --quality {}",
            "Отфильтровать, прежде чем выбрасывать отсчёты; так алиасы останутся в допуске: nyquist resample {name} OUT.wav --rate {rate} --quality {}",
            way.name()
        )),
        (false, None) => section.say(text!(
            "No quality of nyquist resample promises so much.",
            "Такого не обещает ни одно качество nyquist resample."
        )),
    };
    section.say(match check.sound().smallest_rate(tolerance) {
        Some(enough) => text!(
            "Without a filter, the lowest standard rate that keeps the aliases {tolerance} dB below the signal is {enough} Hz.",
            "Без фильтра наименьшая стандартная частота, при которой алиасы на {tolerance} дБ ниже сигнала, — {enough} Гц."
        ),
        None => text!(
            "Without a filter, no standard rate below its own {} Hz keeps the aliases {tolerance} dB below the signal.",
            "Без фильтра ни одна стандартная частота ниже собственных {} Гц не удержит алиасы на {tolerance} дБ ниже сигнала.",
            check.sound().rate()
        ),
    })
}

fn higher(subject: &Subject, rate: f64) -> Section {
    let own = subject.check.sound().rate();
    let section = Section::new(text!("At {rate} Hz", "При {rate} Гц"));
    if rate == own {
        return section.say(text!(
            "That is the rate of the file: nothing changes.",
            "Это частота самого файла: ничего не изменится."
        ));
    }
    section.say(text!(
        "Everything up to the old Nyquist frequency, {} Hz, fits below the new one; nothing comes to lie above it that was \
         not there. What may have aliased when the sound was recorded stays as it is.",
        "Всё до прежней частоты Найквиста, {} Гц, помещается под новой; выше ничего нового не появится. Алиасы, которые \
         могли возникнуть при записи, останутся.",
        0.5 * own
    ))
}

/// The answer about its own rate, and what nobody can know.
fn own(subject: &Subject) -> Section {
    let check = subject.check;
    let sound = check.sound();
    let channel = &sound.channels()[check.worst()];
    let ([from, nyquist], tolerance) = (channel.edge(), check.tolerance());
    let mut section = Section::new(text!("Sampled well enough?", "Достаточна ли частота дискретизации?"));
    if let Some(of) = of_channel(subject) {
        section = section.say(of);
    }
    section = section.say(text!(
        "From {} to {} Hz, the last sixteenth below the Nyquist frequency, there is {} dBFS, {} dB below all ({} dBFS).",
        "От {} до {} Гц, в последней шестнадцатой до частоты Найквиста, — {} dBFS, на {} дБ ниже всего вместе ({} dBFS).",
        hertz(from),
        hertz(nyquist),
        decibels(dbfs(channel.edge_power())),
        decibels(check.ratio()),
        decibels(dbfs(channel.levels().power))
    ));
    section = section.say(if check.only_rounding() {
        let bits = subject.encoding.bits();
        text!(
            "That is no more than the rounding of its {bits} bits leaves there: nothing that could have folded stands out of it.",
            "Это не больше, чем оставляет там округление до {bits} бит: ничего, что могло бы завернуться, из него не выступает."
        )
    } else if check.fine() {
        text!(
            "That is within the tolerance of {tolerance} dB: sound that comes down so far before the Nyquist frequency went on \
             falling beyond it, and little can have folded.",
            "Это в пределах допуска {tolerance} дБ: звук, который так ослаб до частоты Найквиста, слабел и дальше; завернуться \
             могло немногое."
        )
    } else {
        text!(
            "That is beyond the tolerance of {tolerance} dB: what lay as near beyond when this was sampled was about as strong, \
             and has folded unless a filter took it away.",
            "Это за пределами допуска {tolerance} дБ: что лежало так же близко по другую сторону, было примерно столь же сильным и \
             завернулось, если фильтр его не убрал."
        )
    });
    section = section.say(text!(
        "What cannot be known from the samples: whether something below is itself an alias. Only the recorder's filter tells.",
        "Чего по отсчётам не узнать: не является ли алиасом что-то из того, что ниже. Это знает только фильтр записи."
    ));
    if !check.fine() {
        section = section.say(text!(
            "If it can be recorded or computed again: at a higher rate, then nyquist resample.",
            "Если можно записать или вычислить заново — при большей частоте, затем nyquist resample."
        ));
    }
    let smallest = sound.smallest_rate(tolerance);
    section.say(match smallest {
        Some(enough) => text!(
            "Without a filter {enough} Hz would do, the lowest standard rate that keeps aliases {tolerance} dB below the signal: \
             ask with --rate.",
            "Без фильтра хватило бы {enough} Гц — это наименьшая стандартная частота, при которой алиасы на {tolerance} дБ ниже \
             сигнала; проверить: --rate."
        ),
        None => text!(
            "Every lower standard rate needs a filter to keep aliases {tolerance} dB below the signal: ask with --rate.",
            "При любой меньшей стандартной частоте без фильтра алиасы будут выше допуска {tolerance} дБ; проверить: --rate."
        ),
    })
}
