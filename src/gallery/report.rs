//! A report as a page of its own: sentences, tables and the picture, without a network.

use crate::figure::report::{Report, Section, Table};
use crate::gallery::markdown::html as escaped;
use crate::plot::{Scene, Style, draw};
use crate::text::{Lang, Text};
use std::fmt::Write;

const STYLE: &str = include_str!("report.css");

/// The picture of a report.
pub fn picture(report: &Report, style: &Style) -> Scene {
    let portrait = &report.portrait;
    draw(&portrait.title, &portrait.caption, &portrait.figure, style)
}

/// The page, in the language of the style, with the picture inside it.
///
/// ```
/// use nyquist::figure::report::{Report, Section};
/// use nyquist::figure::{Figure, Portrait};
/// use nyquist::gallery::report::page;
/// use nyquist::plot::Style;
/// use nyquist::text;
/// let portrait = Portrait { title: text!("a & b", "a & b"), caption: text!("", ""), figure: Figure::new(1) };
/// let band = Section::new(text!("band", "полоса")).say(text!("B = 2^{{10}}", "B = 2^{{10}}"));
/// let page = page(&Report { portrait, sections: vec![band] }, &Style::default());
/// assert!(page.contains("<h1>a &amp; b</h1>") && page.contains("B = 2<sup>10</sup>") && page.contains("<svg"));
/// ```
pub fn page(report: &Report, style: &Style) -> String {
    let lang = style.lang;
    let title = escaped(report.portrait.title.get(lang));
    let mut out = format!(
        "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" \
         content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n\
         <body class=\"{}\">\n<main>\n<h1>{title}</h1>\n",
        lang.code(),
        style.theme.name()
    );
    // the title stands above it already
    let scene = picture(report, &Style { title: false, ..style.clone() });
    let caption = escaped(report.portrait.caption.get(lang));
    writeln!(out, "<figure>\n{}\n<figcaption>{caption}</figcaption>\n</figure>", scene.svg()).expect(INFALLIBLE);
    for Section { heading, sentences, table } in &report.sections {
        writeln!(out, "<section>\n<h2>{}</h2>", escaped(heading.get(lang))).expect(INFALLIBLE);
        for sentence in sentences {
            writeln!(out, "<p>{}</p>", escaped(sentence.get(lang))).expect(INFALLIBLE);
        }
        if let Some(table) = table {
            write_table(&mut out, table, lang);
        }
        out.push_str("</section>\n");
    }
    out.push_str("</main>\n</body>\n</html>\n");
    out
}

const INFALLIBLE: &str = "writing to a string cannot fail";

fn write_table(out: &mut String, table: &Table, lang: Lang) {
    let row = |cells: &[Text], tag: &str| -> String {
        let cells = cells.iter().map(|cell| format!("<{tag}>{}</{tag}>", escaped(cell.get(lang))));
        format!("<tr>{}</tr>\n", cells.collect::<String>())
    };
    let rows: String = table.rows.iter().map(|cells| row(cells, "td")).collect();
    write!(out, "<div class=\"table\"><table>\n{}{rows}</table></div>\n", row(&table.head, "th")).expect(INFALLIBLE);
}
