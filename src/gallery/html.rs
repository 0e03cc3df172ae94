//! `index.html`: the gallery in one page, both languages, without a network.

use crate::figure::params::Kind;
use crate::figure::{Entry, Figure};
use crate::gallery::index::settled;
use crate::gallery::markdown::html as escaped;
use crate::text::{Lang, Text, number};
use std::fmt::Write;

const HEAD: &str = include_str!("head.html");

/// The page.
pub fn html<'a>(figures: impl IntoIterator<Item = (&'a Entry, &'a Figure)>) -> String {
    let figures: Vec<_> = figures.into_iter().collect();
    let mut out = String::from(HEAD);
    out.push_str("<nav><ol>\n");
    for (entry, _) in &figures {
        writeln!(out, "<li><a href=\"#{id}\">{}</a></li>", both(entry.title), id = entry.id).expect(INFALLIBLE);
    }
    out.push_str("</ol></nav>\n<main>\n");
    for (entry, figure) in &figures {
        article(&mut out, entry, figure);
    }
    out.push_str("</main>\n</body>\n</html>\n");
    out
}

const INFALLIBLE: &str = "writing to a string cannot fail";

/// Both languages, of which the style shows one.
fn both(text: &Text) -> String {
    Lang::ALL.map(|l| format!("<span lang=\"{}\">{}</span>", l.code(), escaped(text.get(l)))).concat()
}

fn article(out: &mut String, entry: &Entry, figure: &Figure) {
    let id = entry.id;
    let picture = |file: &str| {
        let each = Lang::ALL.map(|l| {
            let (code, alt) = (l.code(), escaped(entry.title.get(l)));
            format!("<a lang=\"{code}\" href=\"{code}/{file}\"><img loading=\"lazy\" src=\"{code}/{file}\" alt=\"{alt}\"></a>")
        });
        each.concat()
    };
    let still = picture(&format!("{id}.svg"));
    let moving = figure.motion.as_ref().map_or(String::new(), |_| picture(&format!("{id}.apng")));
    let chips: Vec<String> =
        [entry.inventory, entry.errata].concat().iter().map(|c| format!("<span class=\"chip\">{c}</span>")).collect();
    write!(
        out,
        "<article id=\"{id}\">\n<h2>{}</h2>\n<p class=\"origin\"><code>{id}</code> {}</p>\n{}\n<p>{}</p>\n",
        both(entry.title),
        chips.join(" "),
        still + &moving,
        both(entry.caption)
    )
    .expect(INFALLIBLE);
    out.push_str("<table>\n");
    for claim in &figure.claims {
        let shown = |v: f64| escaped(&number(settled(v), 3));
        let (mark, r) = (if claim.residual.holds() { "✓" } else { "✗" }, &claim.residual);
        writeln!(
            out,
            "<tr><td>{}</td><td>{}</td><td>≤ {}</td><td>{mark}</td></tr>",
            both(&claim.says),
            shown(r.measured),
            shown(r.bound)
        )
        .expect(INFALLIBLE);
    }
    out.push_str("</table>\n");
    let command = |set: &str| format!("nyquist figures {id}{set}");
    let mut set = String::new();
    for param in entry.params {
        let (shown, range) = match param.kind {
            Kind::Real { default, low, high, unit } => (default.to_string(), format!("{low} … {high} {unit}")),
            Kind::Count { default, low, high } => (default.to_string(), format!("{low} … {high}")),
            Kind::Choice(of) => (of[0].to_owned(), of.join(", ")),
        };
        write!(set, " --set {}={shown}", param.name).expect(INFALLIBLE);
        writeln!(out, "<p class=\"param\"><code>{}</code> {}: {range}</p>", param.name, both(param.about))
            .expect(INFALLIBLE);
    }
    writeln!(out, "<pre>{}</pre>\n</article>", command(&set)).expect(INFALLIBLE);
}
