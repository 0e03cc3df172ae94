//! The findings of a report on a picture, in words and numbers.

use crate::error::Result;
use crate::figure::report::Section;
use crate::figure::report::picture::Checked;
use crate::image::Image;
use crate::inspect::picture::band::{Band, Fall};
use crate::inspect::picture::found::{Cause, Found};
use crate::inspect::picture::power::PowerSpectrum;
use crate::inspect::picture::sampler::Moire;
use crate::inspect::picture::shrinking::{Shrinking, Tolerance, Way};
use crate::text;
use crate::text::{Lang, Text, number};

/// Of a picture that was checked.
pub(super) fn sections(image: &Image, checked: &Checked, tolerance: Tolerance, file: &str) -> Result<Vec<Section>> {
    let mut all = vec![band(image, &checked.spectrum)?, room(&checked.spectrum, tolerance)?];
    if let Some(shrinking) = &checked.shrinking {
        if enlarged(shrinking) {
            all.push(enlarging(shrinking, file));
        } else {
            all.extend([gratings(checked, shrinking), ways(shrinking), advice(checked, shrinking, file)]);
        }
    }
    Ok(all)
}

/// Whether the new raster holds all that the old one does.
pub(super) fn enlarged(shrinking: &Shrinking) -> bool {
    shrinking.limit.iter().all(|limit| *limit >= 0.5)
}

fn command(file: &str, [w, h]: [usize; 2], filter: &str) -> Text {
    Text::literal(format!("nyquist resize {file} OUT.png --width {w} --height {h} --filter {filter}"))
}

/// Of a picture that does not shrink.
fn enlarging(shrinking: &Shrinking, file: &str) -> Section {
    let [w, h] = shrinking.size;
    Section::new(text!("Enlarging to {w} × {h}", "Увеличение до {w} × {h}"))
        .say(text!(
            "Nothing aliases: the new raster is nowhere coarser than the old one, whatever the filter.",
            "Алиасинга не будет: новый растр нигде не грубее старого, каким бы ни был фильтр."
        ))
        .say(text!(
            "What is left of the images of the spectrum depends on the filter: none and box leave them as blocks, tent \
             weakens them, mitchell and lanczos-3 leave hardly any. ",
            "Сколько останется от копий спектра, зависит от фильтра: none и box оставляют их в виде квадратиков, tent \
             ослабляет, mitchell и lanczos-3 почти не оставляют. "
        ).and(&command(file, shrinking.size, "mitchell")))
}

fn whole(value: f64) -> Text {
    text!("{value:.0}", "{value:.0}")
}

fn cell(value: f64, digits: usize) -> Text {
    let value = number(value, digits);
    text!("{value}", "{value}")
}

/// A contrast as a reader takes it.
pub(super) fn percent(contrast: f64) -> Text {
    match 100.0 * contrast {
        p if p < 0.005 => text!("< 0.01 %", "< 0.01 %"),
        p if p < 1.0 => text!("{p:.2} %", "{p:.2} %"),
        p => text!("{p:.1} %", "{p:.1} %"),
    }
}

fn band(image: &Image, spectrum: &PowerSpectrum) -> Result<Section> {
    let (w, h, mean) = (image.width(), image.height(), number(spectrum.mean(), 3));
    let deviation = number(spectrum.deviation(), 3);
    let section = Section::new(text!("What is in it", "Что в нём есть")).say(text!(
        "{w} × {h} pixels; in linear light the mean is {mean} of white and the standard deviation {deviation}.",
        "{w} × {h} пикселей; в линейном свете среднее {mean} от белого, среднеквадратичное отклонение {deviation}."
    ));
    if spectrum.deviation() == 0.0 {
        return Ok(section.say(text!("All pixels are equal.", "Все пиксели одинаковы.")));
    }
    let mut rows = Vec::new();
    for fraction in Band::FRACTIONS {
        let band = Band::of(spectrum, fraction)?;
        let name = number(100.0 * fraction, 4);
        let mut row = vec![text!("{name} % of the energy", "{name} % энергии")];
        row.extend([band.across, band.down, band.radial].map(|b| text!("{b:.3}", "{b:.3}")));
        rows.push(row);
    }
    let falls = [Fall::along(spectrum, 0), Fall::along(spectrum, 1), Fall::radial(spectrum)];
    let mut row = vec![text!("down to the noise floor", "до уровня шума")];
    row.extend(falls.iter().map(|fall| {
        let [_, band] = fall.floor();
        text!("{band:.3}", "{band:.3}")
    }));
    rows.push(row);
    let head = [
        text!("frequencies up to, cycles/pixel", "частоты до, периодов на пиксель"),
        text!("across", "по горизонтали"),
        text!("down", "по вертикали"),
        text!("radial", "по радиусу"),
    ];
    Ok(section.table(head, rows))
}

/// How much of the raster is used.
fn room(spectrum: &PowerSpectrum, tolerance: Tolerance) -> Result<Section> {
    let mut section = Section::new(text!("How much of the raster it needs", "Сколько ему нужно пикселей"));
    if spectrum.deviation() == 0.0 {
        return Ok(section.say(text!("One pixel would do.", "Хватило бы одного пикселя.")));
    }
    let db = number(tolerance.decibels(), 3);
    let fraction = 1.0 - 10f64.powf(-0.1 * tolerance.decibels().max(0.1));
    if fraction < 1.0 {
        let scale = (2.0 * Band::of(spectrum, fraction)?.square).min(1.0);
        section = section.say(if scale < 0.99 {
            text!(
                "Without a loss of more than {db} dB it could be shrunk to {scale:.2} of its width and height.",
                "Без потерь более {db} дБ его можно уменьшить до {scale:.2} ширины и высоты."
            )
        } else {
            text!(
                "It fills its raster: shrinking it at all loses more than {db} dB.",
                "Оно заполняет свой растр: любое уменьшение теряет больше {db} дБ."
            )
        });
    }
    let cliffs = [0, 1].map(|axis| Fall::typical(spectrum, axis).cliff());
    if let [Some(across), Some(down)] = cliffs {
        let (wide, high) = (number(2.0 * across, 2), number(2.0 * down, 2));
        section = section.say(text!(
            "It looks enlarged: its spectrum breaks off at {across:.2} across and {down:.2} down. A raster of about {wide} of \
             the width and {high} of the height would have been enough.",
            "Похоже, оно увеличено: спектр обрывается на {across:.2} по горизонтали и {down:.2} по вертикали. Хватило бы растра примерно в \
             {wide} ширины и {high} высоты."
        ));
    }
    Ok(section)
}

/// A place in the plane, as `u, v`.
fn place([u, v]: [f64; 2]) -> Text {
    text!("{u:+.3} {v:+.3}", "{u:+.3} {v:+.3}")
}

fn period(moire: &Moire) -> Text {
    if moire.even { text!("even brightness", "ровная яркость") } else { cell(moire.period(), 3) }
}

/// What was found, and why it is not what was predicted.
fn seen(found: Option<Found>, predicted: f64, tolerance: Tolerance) -> Text {
    let Some(found) = found else { return Text::same("–") };
    let contrast = percent(found.contrast);
    match found.cause(predicted, tolerance.noticeable()) {
        None => contrast,
        Some(Cause::Added) => {
            contrast.and(&text!(", more: texture lands there as well", ", больше: туда же попадает текстура"))
        }
        Some(Cause::Taken) => contrast.and(&text!(", less: texture takes from it", ", меньше: часть гасит текстура")),
        Some(Cause::Images) => contrast.and(&text!(", ratio not whole", ", отношение не целое")),
    }
}

fn gratings(checked: &Checked, shrinking: &Shrinking) -> Section {
    let [w, h] = shrinking.size;
    let [u, v] = shrinking.limit.map(|limit| number(limit, 3));
    let mut section = Section::new(text!("Moiré at {w} × {h}", "Муар при {w} × {h}")).say(text!(
        "The new raster holds |u| below {u} and |v| below {v} cycles a pixel. What is finer folds.",
        "Новый растр вмещает |u| ниже {u} и |v| ниже {v} периодов на пиксель. Всё более мелкое заворачивается."
    ));
    let waves = &shrinking.waves.strongest;
    if waves.is_empty() {
        let least = percent(0.5 * shrinking.tolerance.contrast());
        let (en, ru) = (least.get(Lang::En), least.get(Lang::Ru));
        return textures(
            section.say(text!(
                "No grating of more than {en} contrast stands out there: no moiré is to be expected.",
                "Решёток с контрастом более {ru} там не видно: муара ждать не следует."
            )),
            shrinking,
        );
    }
    let filter = &checked.filter;
    let (plain, filtered) = (&shrinking.ways[0], shrinking.way(filter));
    let rows = waves.iter().enumerate().map(|(i, wave)| {
        let moire = plain.moires[i];
        let [x, y] = wave.middle();
        let found = checked.found.get(i).copied().unwrap_or_default();
        let other = filtered.map(|way| way.moires[i]);
        vec![
            place(wave.frequency),
            cell(wave.period(), 3),
            whole(wave.angle()),
            text!("{x:.0} {y:.0}", "{x:.0} {y:.0}"),
            period(&moire),
            if moire.even { Text::same("–") } else { whole(moire.angle()) },
            percent(moire.contrast),
            seen(found[0], moire.contrast, shrinking.tolerance),
            other.map_or(Text::EMPTY, |moire| percent(moire.contrast)),
            other.map_or(Text::EMPTY, |moire| seen(found[1], moire.contrast, shrinking.tolerance)),
        ]
    });
    let head = [
        text!("grating u v", "решётка u v"),
        text!("period", "период"),
        text!("angle", "угол"),
        text!("at x y", "где x y"),
        text!("moiré: period", "муар: период"),
        text!("angle", "угол"),
        text!("no filter", "без фильтра"),
        text!("found", "найдено"),
        Text::literal(filter),
        text!("found", "найдено"),
    ];
    section = section.table(head, rows);
    if shrinking.waves.others > 0 {
        let others = shrinking.waves.others;
        section = section.say(text!(
            "The strongest {} of {} gratings are listed.",
            "Показаны сильнейшие {} из {} решёток.",
            waves.len(),
            waves.len() + others
        ));
    }
    section = section.say(text!(
        "Periods of gratings are in pixels, of moiré in new pixels; an angle of 0° is upright stripes. Contrasts are \
         (max − min)/(max + min), predicted, and found by shrinking what is too fine.",
        "Периоды решёток — в пикселях, муара — в новых пикселях; угол 0° — вертикальные полосы. Контраст — \
         (макс − мин)/(макс + мин): предсказанный и найденный после уменьшения того, что слишком мелко."
    ));
    let every = checked.found.iter().zip(plain.moires.iter().enumerate()).flat_map(|(found, (i, moire))| {
        let cause =
            |found: Option<Found>, moire: &Moire| found?.cause(moire.contrast, shrinking.tolerance.noticeable());
        [cause(found[0], moire), filtered.and_then(|way| cause(found[1], &way.moires[i]))]
    });
    let causes: Vec<Cause> = every.flatten().collect();
    if causes.contains(&Cause::Images) {
        section = section.say(text!(
            "Where the ratio of the sizes is not whole, places read slip against the old pixels, and a grating has several \
             images; what was found is what the part around shows of them together.",
            "Если отношение размеров не целое, места чтения смещаются относительно старых пикселей, и у решётки несколько \
             образов; найденное — то, что фрагмент показывает от них вместе."
        ));
    }
    if plain.moires.iter().any(|moire| moire.even) {
        let most = percent(plain.brightness());
        let (en, ru) = (most.get(Lang::En), most.get(Lang::Ru));
        section = section.say(text!(
            "A grating that folds to zero frequency becomes an even change of brightness, without a filter of up to {en}: no \
             moiré, but not what is there either.",
            "Решётка, которая заворачивается в нулевую частоту, становится ровным изменением яркости, без фильтра до {ru}: это \
             не муар, но и не то, что есть на самом деле."
        ));
    }
    textures(section, shrinking)
}

fn textures(section: Section, shrinking: &Shrinking) -> Section {
    let seen = shrinking.textures.iter().filter(|texture| texture.contrast > shrinking.tolerance.noticeable());
    seen.fold(section, |section, texture| {
        let (rms, [u, v]) = (percent(texture.contrast), texture.frequency);
        let (en, ru) = (rms.get(Lang::En), rms.get(Lang::Ru));
        section.say(text!(
            "Edges and texture around {u:+.2} {v:+.2}: {en} (root mean square against the mean).",
            "Края и текстура около {u:+.2} {v:+.2}: {ru} (среднеквадратичное к среднему)."
        ))
    })
}

fn ways(shrinking: &Shrinking) -> Section {
    let (contrast, ratio) = (percent(shrinking.tolerance.contrast()), number(shrinking.tolerance.ratio(), 3));
    let db = number(shrinking.tolerance.decibels(), 3);
    let (en, ru) = (contrast.get(Lang::En), contrast.get(Lang::Ru));
    let brighter = shrinking.ways.iter().any(|way| way.moires.iter().any(|moire| moire.even));
    let row = |way: &Way| {
        let worst = way.worst().map(|(_, moire)| moire);
        let mut cells = vec![
            match way.name.as_str() {
                "none" => text!("none (plain decimation)", "none (прореживание)"),
                name => Text::literal(name),
            },
            worst.map_or(Text::same("–"), |moire| percent(moire.contrast)),
            worst.map_or(Text::same("–"), |moire| period(&moire)),
            match way.passed.ratio() {
                ratio if ratio.is_finite() => text!("{ratio:.1} dB", "{ratio:.1} дБ"),
                _ => Text::same("∞"),
            },
            if way.fine { text!("fine", "годится") } else { text!("aliases", "алиасинг") },
        ];
        if brighter {
            cells.insert(3, percent(way.brightness()));
        }
        cells
    };
    let mut head = vec![
        text!("filter", "фильтр"),
        text!("strongest moiré", "сильнейший муар"),
        text!("period", "период"),
        text!("kept to folded", "сохранённое / завёрнутое"),
        Text::EMPTY,
    ];
    if brighter {
        head.insert(3, text!("change of brightness", "изменение яркости"));
    }
    Section::new(text!("Every way to get there", "Все способы"))
        .say(text!(
            "Tolerance {db} dB: a moiré of no more than {en}; of edges and texture, which hide their own aliases, {ratio} dB \
             of what is kept above what folds.",
            "Допуск {db} дБ: муар не более {ru}; для краёв и текстуры, которые сами скрывают свой алиасинг, сохранённое выше \
             завёрнутого на {ratio} дБ."
        ))
        .table(head, shrinking.ways.iter().map(row))
}

/// What to do.
fn advice(checked: &Checked, shrinking: &Shrinking, file: &str) -> Section {
    let section = Section::new(text!("What to do", "Что делать"));
    let command = |name: &str| command(file, shrinking.size, name);
    let mut section = match shrinking.best() {
        Some(way) if way.name == "none" => {
            section.say(text!("Nothing: it can be decimated as it is.", "Ничего: его можно прореживать как есть."))
        }
        Some(way) => section.say(
            text!("Of the filters that are fine this one keeps most: ", "Из годных фильтров больше всего сохраняет: ")
                .and(&command(&way.name)),
        ),
        None => section.say(
            text!(
                "No filter is within the tolerance; nearest comes: ",
                "Ни один фильтр не укладывается в допуск; ближе всех: "
            )
            .and(&command(&shrinking.cleanest().name)),
        ),
    };
    if let Some(sigma) = shrinking.blur {
        let line = command("none").and(&Text::literal(format!(" --blur {sigma:.2}")));
        section = section.say(
            text!(
                "Or blur first, by a Gaussian of σ = {sigma:.2} pixels, and then decimate: ",
                "Или сначала размыть гауссианом с σ = {sigma:.2} пикселя, затем проредить: "
            )
            .and(&line),
        );
    }
    if let Some(way) = shrinking.way(&checked.filter).filter(|way| !way.fine && shrinking.best().is_some()) {
        let name = &way.name;
        section = section
            .say(text!("With {name} aliases stay above the tolerance.", "С {name} искажения остаются выше допуска."));
    }
    section
}
