//! How a table is written down: separators, quotes, decimal points.

use crate::error::{Error, unknown};
use std::borrow::Cow;
use std::str::FromStr;

/// What stands between the cells of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Separator {
    /// `,`
    Comma,
    /// `;`
    Semicolon,
    /// The tabulator.
    Tab,
}

impl Separator {
    /// All three.
    pub const ALL: [Self; 3] = [Self::Comma, Self::Semicolon, Self::Tab];

    /// The character.
    pub fn letter(self) -> char {
        match self {
            Self::Comma => ',',
            Self::Semicolon => ';',
            Self::Tab => '\t',
        }
    }

    /// Its name: `comma`, `semicolon`, `tab`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Comma => "comma",
            Self::Semicolon => "semicolon",
            Self::Tab => "tab",
        }
    }
}

/// Reads a separator's name, or the separator itself.
impl FromStr for Separator {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self, Error> {
        let found =
            Self::ALL.into_iter().find(|s| s.name().eq_ignore_ascii_case(name) || s.letter().to_string() == name);
        found.ok_or_else(|| unknown("separator", name, Self::ALL.map(Self::name)))
    }
}

/// How cells and numbers are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Dialect {
    /// What stands between cells.
    pub separator: Separator,
    /// Whether numbers have a decimal comma, `0,5`.
    pub decimal_comma: bool,
}

impl Dialect {
    /// The dialect of these lines. The separator is the one of tab, semicolon and comma that stands in most of them outside
    /// quotes, the first of those that do; a comma that is a decimal comma separates nothing.
    pub(crate) fn of(lines: &[&str], decimal_comma: bool) -> Self {
        let candidates = [Separator::Comma, Separator::Semicolon, Separator::Tab];
        let stands = |s: Separator| lines.iter().filter(|line| outside_quotes(line).any(|c| c == s.letter())).count();
        let allowed = candidates.into_iter().filter(|s| !(decimal_comma && *s == Separator::Comma));
        // the last of equal ones
        let separator = allowed.max_by_key(|s| stands(*s)).filter(|s| stands(*s) > 0);
        let fallback = if decimal_comma { Separator::Semicolon } else { Separator::Comma };
        Self { separator: separator.unwrap_or(fallback), decimal_comma }
    }

    /// The cells of a line, without the spaces around them and the quotes.
    ///
    /// # Errors
    /// What is wrong with the quotes.
    pub(crate) fn split<'a>(self, line: &'a str, cells: &mut Vec<Cow<'a, str>>) -> Result<(), &'static str> {
        cells.clear();
        let separator = self.separator.letter();
        let blank = |c: char| c == ' ' || (c == '\t' && separator != '\t');
        let mut rest = line;
        loop {
            let start = rest.trim_start_matches(blank);
            let end;
            if let Some(quoted) = start.strip_prefix('"') {
                let (cell, behind) = unquoted(quoted).ok_or("a quote is not closed on its line")?;
                cells.push(cell);
                end = behind.trim_start_matches(blank);
                if !(end.is_empty() || end.starts_with(separator)) {
                    return Err("something stands between a closing quote and the next separator");
                }
            } else {
                let at = start.find(separator).unwrap_or(start.len());
                cells.push(start[..at].trim_end_matches(blank).into());
                end = &start[at..];
            }
            match end.strip_prefix(separator) {
                Some(next) => rest = next,
                None => return Ok(()),
            }
        }
    }

    /// A cell with a decimal point.
    pub(crate) fn pointed(self, cell: &str) -> Cow<'_, str> {
        if self.decimal_comma && cell.contains(',') { cell.replacen(',', ".", 1).into() } else { cell.into() }
    }

    /// A number or a date with a decimal point, as this dialect writes it.
    pub(crate) fn localised(self, pointed: String) -> String {
        if self.decimal_comma { pointed.replacen('.', ",", 1) } else { pointed }
    }

    /// A text as a cell: in quotes where it must be.
    pub(crate) fn quoted(self, text: &str) -> String {
        let plain = !text.contains([self.separator.letter(), '"']) && !text.starts_with(['#', ' ']);
        if plain { text.to_owned() } else { format!("\"{}\"", text.replace('"', "\"\"")) }
    }
}

/// The text up to the closing quote, in which two quotes are one, and what stands behind it.
fn unquoted(text: &str) -> Option<(Cow<'_, str>, &str)> {
    let mut from = 0;
    loop {
        let at = from + text[from..].find('"')?;
        if !text[at + 1..].starts_with('"') {
            let inner = &text[..at];
            let cell = if inner.contains('"') { inner.replace("\"\"", "\"").into() } else { inner.into() };
            return Some((cell, &text[at + 1..]));
        }
        from = at + 2;
    }
}

fn outside_quotes(line: &str) -> impl Iterator<Item = char> {
    let mut inside = false;
    line.chars().filter(move |c| {
        inside ^= *c == '"';
        !inside
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn split(separator: Separator, line: &str) -> Result<Vec<String>, &'static str> {
        let mut cells = Vec::new();
        Dialect { separator, decimal_comma: false }.split(line, &mut cells)?;
        Ok(cells.into_iter().map(Cow::into_owned).collect())
    }

    #[test]
    fn cells_are_what_stands_between_separators_and_inside_quotes() {
        assert_eq!(split(Separator::Comma, " a ,b,,").unwrap(), ["a", "b", "", ""]);
        assert_eq!(split(Separator::Comma, r#""a,b" , "say ""x""",c"#).unwrap(), ["a,b", "say \"x\"", "c"]);
        assert_eq!(split(Separator::Tab, "1\t\t 2 ").unwrap(), ["1", "", "2"]);
        assert!(split(Separator::Comma, r#"1,"2"#).is_err());
        assert!(split(Separator::Comma, r#""1"2,3"#).is_err());
    }

    #[test]
    fn separators_are_told_apart() {
        let of = |line, comma| Dialect::of(&["header, with a comma", line], comma).separator;
        assert_eq!(of("1;2", false), Separator::Semicolon);
        assert_eq!(Dialect::of(&["t\tv", "1,5\t2"], false).separator, Separator::Tab);
        assert_eq!(of("1,5", false), Separator::Comma);
        assert_eq!(of("1,5", true), Separator::Semicolon);
        assert_eq!(of("\"1;5\",2", false), Separator::Comma);
        assert_eq!(Dialect::of(&["t,v", "0,1", "1,2;3"], false).separator, Separator::Comma);
    }
}
