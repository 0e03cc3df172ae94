//! Every sentence that a reader sees, in English and in Russian.

use crate::error::{Error, unknown};
use std::borrow::Cow;
use std::str::FromStr;

/// A language of labels and captions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Lang {
    /// English.
    En,
    /// Russian.
    Ru,
}

impl Lang {
    /// Both, English first.
    pub const ALL: [Self; 2] = [Self::En, Self::Ru];

    /// The two-letter code: `en` or `ru`.
    pub fn code(self) -> &'static str {
        match self {
            Self::En => "en",
            Self::Ru => "ru",
        }
    }
}

/// Reads a language's code, in letters of any case.
impl FromStr for Lang {
    type Err = Error;

    fn from_str(code: &str) -> Result<Self, Error> {
        let found = Self::ALL.into_iter().find(|l| l.code().eq_ignore_ascii_case(code));
        found.ok_or_else(|| unknown("language", code, Self::ALL.map(Self::code)))
    }
}

/// One sentence in two languages, with light markup: `_{…}` is a subscript and `^{…}` a superscript.
///
/// ```
/// use nyquist::text::{Lang, Text};
/// const TITLE: Text = Text::fixed("Replicas of Ш_{1/T}", "Копии Ш_{1/T}");
/// assert_eq!(TITLE.get(Lang::Ru), "Копии Ш_{1/T}");
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Text {
    en: Cow<'static, str>,
    ru: Cow<'static, str>,
}

impl Text {
    /// Nothing, in both languages.
    pub const EMPTY: Self = Self::fixed("", "");

    /// A sentence that is known at compile time.
    pub const fn fixed(en: &'static str, ru: &'static str) -> Self {
        Self { en: Cow::Borrowed(en), ru: Cow::Borrowed(ru) }
    }

    /// A formula or a symbol that reads the same in both languages.
    pub const fn same(both: &'static str) -> Self {
        Self::fixed(both, both)
    }

    /// A sentence with numbers in it. Minus signs become `−`, and in Russian the decimal point becomes a comma, so
    /// that the numbers can be formatted once for both.
    ///
    /// ```
    /// use nyquist::text::{Lang, Text};
    /// let text = Text::of(format!("gain {:.2}", -0.5), format!("усиление {:.2}", -0.5));
    /// assert_eq!(text.get(Lang::Ru), "усиление −0,50");
    /// ```
    pub fn of(en: impl Into<String>, ru: impl Into<String>) -> Self {
        Self { en: Cow::Owned(minus(&en.into())), ru: Cow::Owned(comma(&minus(&ru.into()))) }
    }

    /// Letters that are the same in both languages and must stay as they are: a command to be copied, with the decimal points
    /// that it needs.
    ///
    /// ```
    /// use nyquist::text;
    /// use nyquist::text::{Lang, Text};
    /// let both = text!("σ = {}: ", "σ = {}: ", 1.5).and(&Text::literal("--blur 1.5"));
    /// assert_eq!(both.get(Lang::Ru), "σ = 1,5: --blur 1.5");
    /// ```
    pub fn literal(letters: impl Into<String>) -> Self {
        let letters = letters.into();
        Self::verbatim(letters.clone(), letters)
    }

    /// This, and another one behind it.
    #[must_use]
    pub fn and(self, more: &Self) -> Self {
        let joined = |a: Cow<'_, str>, lang| Cow::Owned(a.into_owned() + more.get(lang));
        Self { en: joined(self.en, Lang::En), ru: joined(self.ru, Lang::Ru) }
    }

    /// A sentence whose minus signs and commas are as its author wrote them.
    pub fn verbatim(en: impl Into<String>, ru: impl Into<String>) -> Self {
        Self { en: Cow::Owned(en.into()), ru: Cow::Owned(ru.into()) }
    }

    /// The sentence in one language.
    pub fn get(&self, lang: Lang) -> &str {
        match lang {
            Lang::En => &self.en,
            Lang::Ru => &self.ru,
        }
    }

    /// Whether there is nothing to read.
    pub fn is_empty(&self) -> bool {
        self.en.is_empty() && self.ru.is_empty()
    }
}

/// [`Text`] from two literals, or from two format strings and their shared arguments.
///
/// ```
/// use nyquist::text;
/// use nyquist::text::Lang;
/// let step = 0.5;
/// assert_eq!(text!("T = {step}", "T = {step}").get(Lang::Ru), "T = 0,5");
/// ```
#[macro_export]
macro_rules! text {
    ($en:literal, $ru:literal $(, $($arg:tt)*)?) => {
        $crate::text::Text::of(format!($en $(, $($arg)*)?), format!($ru $(, $($arg)*)?))
    };
}

/// A number for a reader: plain where that is short, otherwise mantissa and power of ten with `digits` significant
/// digits, as markup: `4.2·10^{−15}`.
///
/// ```
/// assert_eq!(nyquist::text::number(0.00042, 2), "0.00042");
/// assert_eq!(nyquist::text::number(4.19e-15, 2), "4.2·10^{−15}");
/// assert_eq!(nyquist::text::number(1e-14, 3), "10^{−14}");
/// assert_eq!(nyquist::text::number(-1234.5, 3), "−1230");
/// ```
pub fn number(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return if value == 0.0 { "0".into() } else { minus(&value.to_string()) };
    }
    let scientific = format!("{value:.*e}", digits.saturating_sub(1));
    let (mantissa, exponent) = scientific.split_once('e').expect("the format {:e} always writes an e");
    let exponent: i32 = exponent.parse().expect("the format {:e} writes a whole exponent");
    let plain = || {
        let rounded: f64 = scientific.parse().expect("the format {:e} can be read back");
        rounded.to_string()
    };
    let mantissa = if mantissa.contains('.') { mantissa.trim_end_matches('0').trim_end_matches('.') } else { mantissa };
    let short = match mantissa {
        _ if (-5..7).contains(&exponent) => plain(),
        "1" => format!("10^{{{exponent}}}"),
        "-1" => format!("-10^{{{exponent}}}"),
        _ => format!("{mantissa}·10^{{{exponent}}}"),
    };
    minus(&short)
}

/// `markup` as letters alone, for a terminal or a title: `Ш_{1/T}` becomes `Ш_(1/T)`, `x^{2}` becomes `x^2`. A brace that is
/// not closed stays a letter.
///
/// ```
/// assert_eq!(nyquist::text::plain("Ш_{1/T} и x^{2}, 10^{−15}"), "Ш_(1/T) и x^2, 10^(−15)");
/// ```
pub fn plain(markup: &str) -> String {
    let mut out = String::new();
    let mut rest = markup;
    while let Some(c) = rest.chars().next() {
        out.push(c);
        rest = &rest[c.len_utf8()..];
        let script = matches!(c, '_' | '^') && rest.starts_with('{');
        if let Some(end) = script.then(|| closing(rest)).flatten() {
            let inner = plain(&rest[1..end]);
            let short = inner.chars().count() == 1;
            out.push_str(&if short { inner } else { format!("({inner})") });
            rest = &rest[end + 1..];
        }
    }
    out
}

/// Where the brace that `text` begins with is closed.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 0;
    let closed = |(_, c): &(usize, char)| {
        depth += match c {
            '{' => 1,
            '}' => -1,
            _ => 0,
        };
        depth == 0
    };
    text.char_indices().find(closed).map(|(i, _)| i)
}

/// `-` before a digit becomes `−`, unless it stands inside a word or a range.
fn minus(s: &str) -> String {
    let chars: Vec<char> = s.chars().collect();
    let is_sign = |i: usize| {
        let before = i.checked_sub(1).map(|j| chars[j]);
        chars.get(i + 1).is_some_and(char::is_ascii_digit) && !before.is_some_and(char::is_alphanumeric)
    };
    chars.iter().enumerate().map(|(i, &c)| if c == '-' && is_sign(i) { '−' } else { c }).collect()
}

/// A point between two digits becomes a comma.
fn comma(s: &str) -> String {
    let chars: Vec<char> = s.chars().collect();
    let digit = |i: Option<usize>| i.and_then(|i| chars.get(i)).is_some_and(char::is_ascii_digit);
    let inside = |i: usize| digit(i.checked_sub(1)) && digit(Some(i + 1));
    chars.iter().enumerate().map(|(i, &c)| if c == '.' && inside(i) { ',' } else { c }).collect()
}

/// A number with its power of ten in letters alone: `10^{−14}` becomes `10⁻¹⁴`.
///
/// ```
/// use nyquist::text::{number, raised};
/// assert_eq!(raised(&number(1.5e-14, 3)), "1.5·10⁻¹⁴");
/// ```
pub fn raised(number: &str) -> String {
    let Some((mantissa, power)) = number.split_once("^{") else { return number.to_owned() };
    let small = |c: char| match c.to_digit(10) {
        Some(digit) => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize],
        None => '⁻',
    };
    mantissa.chars().chain(power.trim_end_matches('}').chars().map(small)).collect()
}
