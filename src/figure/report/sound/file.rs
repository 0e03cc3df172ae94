//! What is in the file, as it is.

use super::{Subject, decibels, exactly, hertz, number};
use crate::figure::report::Section;
use crate::inspect::sound::{Channel, Ending, dbfs};
use crate::text;
use crate::text::Text;

/// Rows of channels that are shown; the numbers of all are in the JSON.
const MOST_CHANNELS: usize = 16;
/// Lines that are shown.
const MOST_LINES: usize = 8;

pub(super) fn section(subject: &Subject) -> Section {
    let sound = subject.check.sound();
    let (rate, channels, frames) = (sound.rate(), sound.channels().len(), sound.frames());
    let encoding = subject.encoding;
    let (float_en, float_ru) =
        if encoding.is_float() { ("float", "с плавающей точкой") } else { ("integer", "целые") };
    let (bits, seconds) = (encoding.bits(), frames as f64 / rate);
    let plural = if channels == 1 { "" } else { "s" };
    let spectrum = sound.channels()[0].spectrum();
    let mut section = Section::new(text!("The file", "Файл"))
        .say(text!(
            "{rate} Hz, {channels} channel{plural}, {bits}-bit {float_en}, {frames} frames ({seconds:.3} s).",
            "{rate} Гц, каналов: {channels}, {bits} бит, {float_ru}, отсчётов: {frames} ({seconds:.3} с)."
        ))
        .say(text!(
            "Levels in dBFS, a sine of full scale being 0; the mean is in no other number. Spectrum: {} segments of {:.3} s, \
             a bin every {:.2} Hz.",
            "Уровни в dBFS: синус во всю шкалу — 0; среднее ни в одно другое число не входит. Спектр: сегментов {}, по \
             {:.3} с, шаг {:.2} Гц.",
            spectrum.segments(),
            spectrum.cut().length() as f64 / rate,
            spectrum.step()
        ));
    if let Some(ending) = subject.check.ending() {
        section = section.say(ends(&ending, 0.5 * rate));
    }
    let head = [
        text!("channel", "канал"),
        text!("peak", "пик"),
        Text::same("RMS"),
        text!("mean", "среднее"),
        text!("99 % below", "99 % ниже"),
        text!("99.9 %", "99,9 %"),
        text!("99.99 %", "99,99 %"),
        text!("to the floor", "до шума"),
        text!("noise floor", "уровень шума"),
        text!("like rounding to", "как округление до"),
    ];
    let rows = sound.channels().iter().enumerate().take(MOST_CHANNELS).map(|(i, channel)| row(i, channel, 0.5 * rate));
    section = section.table(head, rows);
    if channels > MOST_CHANNELS {
        let more = channels - MOST_CHANNELS;
        section = section.say(text!(
            "{more} more channels are left out here: see --json.",
            "Не показано каналов: {more}, см. --json."
        ));
    }
    section
}

fn row(i: usize, channel: &Channel, nyquist: f64) -> Vec<Text> {
    let levels = channel.levels();
    let mean = if levels.mean == 0.0 { "0".into() } else { format!("{:.2e}", levels.mean) };
    let mut row = vec![
        number((i + 1).to_string()),
        number(decibels(20.0 * levels.peak().log10())),
        number(decibels(dbfs(levels.power))),
        number(mean),
    ];
    let (Some(floor), Some(ending)) = (channel.floor(), channel.ending()) else {
        row.push(text!("silence", "тишина"));
        row.resize(10, Text::EMPTY);
        return row;
    };
    for fraction in [0.99, 0.999, 0.9999] {
        let band = channel.occupied(fraction).ok().flatten().unwrap_or_default();
        row.push(text!("{} Hz", "{} Гц", hertz(band)));
    }
    row.push(match ending {
        Ending::Flat => text!("flat", "ровный"),
        _ => text!("{} Hz", "{} Гц", hertz(ending.at().unwrap_or(nyquist))),
    });
    row.push(text!("{:.1} dBFS/Hz", "{:.1} dBFS/Гц", dbfs(floor.density)));
    row.push(text!("{:.1} bits", "{:.1} бит", floor.bits()));
    row
}

/// How the spectrum ends, and what that means.
fn ends(ending: &Ending, nyquist: f64) -> Text {
    let enough = ending.enough().filter(|rate| f64::from(*rate) < 2.0 * nyquist);
    match (ending, enough) {
        (Ending::Cut { at, drop }, Some(enough)) => text!(
            "The spectrum ends abruptly at {} Hz, by {drop:.0} dB within 5 %, and is empty above: {enough} Hz would have been \
             enough. So ends what was upsampled, or low-passed as by lossy coders, or made without a top; no voice and no \
             microphone ends so.",
            "Спектр обрывается на {} Гц: на {drop:.0} дБ в пределах 5 %, выше пусто; хватило бы {enough} Гц. Так кончается \
             звук, частоту дискретизации которого повысили, или который обрезали фильтром (как кодеки с потерями), или у \
             которого верха и не было; ни голос, ни микрофон так не кончаются.",
            hertz(*at)
        ),
        (Ending::Cut { at, .. } | Ending::Falls { at }, None) => text!(
            "The spectrum comes down to its noise floor at {} Hz, before the Nyquist frequency.",
            "Спектр спускается до уровня шума на {} Гц, не доходя до частоты Найквиста.",
            hertz(*at)
        ),
        (Ending::Falls { at }, Some(enough)) => text!(
            "The spectrum comes down to its noise floor at {} Hz; above it only noise is left, and {enough} Hz would hold the \
             rest.",
            "Спектр спускается до уровня шума на {} Гц; выше — только шум, остальное поместилось бы в {enough} Гц.",
            hertz(*at)
        ),
        (Ending::Runs, _) => text!(
            "The spectrum stands above its noise floor up to the Nyquist frequency, {} Hz.",
            "Спектр стоит над уровнем шума до самой частоты Найквиста, {} Гц.",
            hertz(nyquist)
        ),
        (Ending::Flat, _) => text!(
            "The spectrum is flat up to the Nyquist frequency, {} Hz: all noise, as far as one can tell.",
            "Спектр ровный до самой частоты Найквиста, {} Гц: насколько можно судить, сплошной шум.",
            hertz(nyquist)
        ),
    }
}

/// The strongest lines of the channel that decides.
pub(super) fn lines(subject: &Subject) -> Option<Section> {
    let check = subject.check;
    let channel = &check.sound().channels()[check.worst()];
    let lines = channel.lines();
    let heading = text!("The strongest tones", "Самые сильные тоны");
    if channel.silent() {
        return None;
    }
    if lines.is_empty() {
        return Some(Section::new(heading).say(text!(
            "None stands 10 dB above its surroundings; below {} Hz none could be told apart from the mean.",
            "Ни один не выступает над окружением на 10 дБ; ниже {} Гц их не отличить от среднего.",
            hertz(channel.lowest_line())
        )));
    }
    let head = [text!("frequency", "частота"), text!("level", "уровень")];
    let rows = lines.iter().take(MOST_LINES).map(|line| {
        vec![
            text!("{} Hz", "{} Гц", exactly(line.frequency)),
            text!("{} dBFS", "{} dBFS", decibels(dbfs(line.power()))),
        ]
    });
    Some(strongest_of(Section::new(heading).table(head, rows), lines.len(), MOST_LINES))
}

/// Says of a table how many there are where it shows fewer.
pub(super) fn strongest_of(section: Section, all: usize, shown: usize) -> Section {
    if all > shown {
        section.say(text!("The strongest of {all}.", "Самые сильные из {all}."))
    } else {
        section
    }
}
