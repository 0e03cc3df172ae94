//! `INDEX.md`: captions in both languages, claims with measured values.

use crate::figure::{Entry, Figure};
use crate::gallery::index::settled;
use crate::text::{Lang, number};
use std::fmt::Write;

/// `_{…}` and `^{…}` as HTML: `<sub>…</sub>` and `<sup>…</sup>`, everything else escaped.
///
/// ```
/// assert_eq!(nyquist::gallery::markdown::html("Ш_{1/T} < 10^{−3}"), "Ш<sub>1/T</sub> &lt; 10<sup>−3</sup>");
/// ```
pub fn html(markup: &str) -> String {
    let mut out = String::new();
    let mut open = Vec::new();
    let mut chars = markup.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            '_' | '^' if chars.peek() == Some(&'{') => {
                chars.next();
                let tag = if c == '_' { "sub" } else { "sup" };
                write!(out, "<{tag}>").expect("writing to a string cannot fail");
                open.push(tag);
            }
            '}' if !open.is_empty() => {
                let tag = open.pop().expect("just seen to be there");
                write!(out, "</{tag}>").expect("writing to a string cannot fail");
            }
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c => out.push(c),
        }
    }
    out
}

/// The index as Markdown.
pub fn markdown<'a>(figures: impl IntoIterator<Item = (&'a Entry, &'a Figure)>) -> String {
    let mut out = String::from(
        "# The figures\n\nWritten by `cargo run --release`, never by hand. Every claim was checked while its figure was \
         drawn: *measured* is how far the drawn data are from it, *allowed* what theory permits. Values under \
         10<sup>−9</sup> are rounding noise and rounded up to a power of ten.\n",
    );
    for (entry, figure) in figures {
        let cell = |markup: &str| html(markup).replace('|', "\\|");
        let origin = [entry.inventory, entry.errata].concat().join(", ");
        let origin = if origin.is_empty() { String::new() } else { format!(" · {origin}") };
        let moving = match figure.motion {
            Some(_) => format!(" · in motion: [en](en/{id}.apng), [ru](ru/{id}.apng)", id = entry.id),
            None => String::new(),
        };
        write!(
            out,
            "\n## {en}\n\n### {ru}\n\n`{id}`{origin} · [en](en/{id}.svg) · [ru](ru/{id}.svg){moving}\n\n{caption_en}\n\n{caption_ru}\n\n\
             | claim | утверждение | measured | allowed | |\n| --- | --- | --- | --- | --- |\n",
            en = html(entry.title.get(Lang::En)),
            ru = html(entry.title.get(Lang::Ru)),
            id = entry.id,
            caption_en = html(entry.caption.get(Lang::En)),
            caption_ru = html(entry.caption.get(Lang::Ru)),
        )
        .expect("writing to a string cannot fail");
        for claim in &figure.claims {
            let shown = |v: f64| html(&number(settled(v), 3));
            let r = &claim.residual;
            writeln!(
                out,
                "| {} | {} | {} | {} | {} |",
                cell(claim.says.get(Lang::En)),
                cell(claim.says.get(Lang::Ru)),
                shown(r.measured),
                shown(r.bound),
                if r.holds() { "✓" } else { "✗" }
            )
            .expect("writing to a string cannot fail");
        }
    }
    out
}
