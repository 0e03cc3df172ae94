//! Text: markup parsed, shaped and measured with the embedded fonts.
//!
//! Lengths are in font units, [`EM`] to the size of the letters, so that everything is a whole number until a writer
//! scales it.

use rustybuzz::ttf_parser::{GlyphId, OutlineBuilder};
use rustybuzz::{Face as Font, UnicodeBuffer};
use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;
use std::sync::OnceLock;

/// Font units to the em of the embedded fonts.
pub(super) const EM: i32 = 2048;
/// How far capital letters and digits rise above the baseline, in ems.
pub(super) const CAP: f64 = 0.73;
/// From baseline to baseline, in ems.
pub(super) const LEADING: f64 = 1.28;
/// How much smaller a script is than what it stands at.
const SMALLER: f64 = 0.7;
/// How far a superscript is raised, in ems of what it stands at.
const RAISED: f64 = 0.38;
/// How far a subscript is lowered, in ems of what it stands at.
const LOWERED: f64 = 0.2;

/// One of the embedded fonts (DejaVu Sans).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) enum Face {
    Regular,
    Bold,
    Oblique,
}

impl Face {
    pub(super) fn font(self) -> &'static Font<'static> {
        static FONTS: OnceLock<[Font<'static>; 3]> = OnceLock::new();
        let parse = |data| Font::from_slice(data, 0).expect("the embedded fonts are whole");
        let fonts = FONTS.get_or_init(|| {
            use dejavu::sans;
            [parse(sans::regular()), parse(sans::bold()), parse(sans::oblique())]
        });
        &fonts[self as usize]
    }

    /// This face where it has the letter, otherwise the regular one, which has the most.
    fn having(self, letter: char) -> Self {
        if self.font().glyph_index(letter).is_some() { self } else { Self::Regular }
    }
}

/// A glyph at its place in a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Glyph {
    pub face: Face,
    pub id: u16,
    /// Rightwards from the start of the line.
    pub x: i32,
    /// Upwards from the baseline.
    pub y: i32,
    /// Its size in thousandths of the line's.
    pub size: i32,
}

/// A line of text, set.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Line {
    /// What was set, with its markup.
    pub text: String,
    pub glyphs: Vec<Glyph>,
    /// How far it advances, in font units.
    pub width: i32,
}

/// One line of text with `_{…}` and `^{…}`, set in `face`.
pub(super) fn line(text: &str, face: Face) -> Rc<Line> {
    thread_local! {
        static SET: RefCell<HashMap<(Face, String), Rc<Line>>> = RefCell::new(HashMap::new());
    }
    const MOST: usize = 4096; // a process that draws for hours keeps no more
    SET.with_borrow_mut(|set| {
        if let Some(line) = set.get(&(face, text.to_owned())) {
            return Rc::clone(line);
        }
        if set.len() >= MOST {
            set.clear();
        }
        let line = Line { text: text.to_owned(), ..Line::default() };
        let mut pen = Pen { face, x: 0.0, line };
        pen.set(&parse(text), 0.0, 1.0);
        pen.line.width = pen.x.round() as i32;
        let line = Rc::new(pen.line);
        set.insert((face, text.to_owned()), Rc::clone(&line));
        line
    })
}

/// How wide the widest line of `text` is at letters of `size`.
pub(super) fn width(text: &str, face: Face, size: f64) -> f64 {
    text.lines().map(|l| f64::from(line(l, face).width)).fold(0.0, f64::max) * size / f64::from(EM)
}

/// How high `text` is at letters of `size`: from the top of the first line's box to the bottom of the last.
pub(super) fn height(text: &str, size: f64) -> f64 {
    let lines = text.lines().count();
    if lines == 0 { 0.0 } else { size * (1.0 + LEADING * (lines - 1) as f64) }
}

/// `text` for a place `room` wide: at `size` if it fits, otherwise smaller down to `least`, and if that is not enough
/// broken into lines at spaces. Returns the text, with line breaks, and the size.
pub(super) fn fit(text: &str, face: Face, size: f64, least: f64, room: f64) -> (String, f64) {
    let natural = width(text, face, size);
    if natural <= room {
        return (text.to_owned(), size);
    }
    let shrunk = size * room / natural;
    if shrunk >= least {
        return (text.to_owned(), shrunk);
    }
    // The least number of lines, then the narrowest column that keeps to it: lines of even length.
    let lines = broken(text, face, least, room);
    let count = lines.lines().count();
    let (mut narrow, mut wide) = (0.0, room);
    for _ in 0..12 {
        let middle = 0.5 * (narrow + wide);
        let tried = broken(text, face, least, middle);
        if tried.lines().count() > count || width(&tried, face, least) > room { narrow = middle } else { wide = middle }
    }
    (broken(text, face, least, wide), least)
}

/// `text` broken at spaces outside braces so that lines are at most `room` wide where words allow.
fn broken(text: &str, face: Face, size: f64, room: f64) -> String {
    let mut lines: Vec<String> = Vec::new();
    for word in words(text) {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}"), face, size) <= room => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines.join("\n")
}

fn words(text: &str) -> Vec<&str> {
    let (mut words, mut start, mut depth) = (Vec::new(), 0, 0_i32);
    for (i, c) in text.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ' ' if depth <= 0 => {
                words.push(&text[start..i]);
                start = i + 1;
            }
            _ => {}
        }
    }
    words.push(&text[start..]);
    words.retain(|w| !w.is_empty());
    words
}

#[derive(Debug, PartialEq, Eq)]
enum Item {
    Letters(String),
    Script { raised: bool, of: Vec<Item> },
}

/// Markup that is not closed is taken as letters.
fn parse(text: &str) -> Vec<Item> {
    let mut items = Vec::new();
    let mut letters = String::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let script = (c == '_' || c == '^') && rest[1..].starts_with('{');
        match script.then(|| closing(&rest[2..])).flatten() {
            Some(end) => {
                if !letters.is_empty() {
                    items.push(Item::Letters(std::mem::take(&mut letters)));
                }
                items.push(Item::Script { raised: c == '^', of: parse(&rest[2..2 + end]) });
                rest = &rest[2 + end + 1..];
            }
            None => {
                letters.push(c);
                rest = &rest[c.len_utf8()..];
            }
        }
    }
    if !letters.is_empty() {
        items.push(Item::Letters(letters));
    }
    items
}

/// Where the brace that is already open closes.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 1;
    for (i, c) in text.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some(i);
        }
    }
    None
}

struct Pen {
    face: Face,
    x: f64,
    line: Line,
}

impl Pen {
    fn set(&mut self, items: &[Item], rise: f64, size: f64) {
        let em = f64::from(EM);
        let mut before: Option<(bool, f64)> = None; // the script just set: raised or not, and where it began
        for item in items {
            match item {
                Item::Letters(letters) => {
                    self.letters(letters, rise, size);
                    before = None;
                }
                Item::Script { raised, of } => {
                    let end = self.x;
                    // A sub- and a superscript in a row stand above each other.
                    let stacked = before.filter(|(other, _)| other != raised);
                    self.x = stacked.map_or(end, |(_, start)| start);
                    before = Some((*raised, self.x));
                    let shift = if *raised { RAISED } else { -LOWERED };
                    self.set(of, rise + shift * size * em, size * SMALLER);
                    self.x = if stacked.is_some() { self.x.max(end) } else { self.x };
                }
            }
        }
    }

    fn letters(&mut self, letters: &str, rise: f64, size: f64) {
        let mut start = 0;
        let mut face = None;
        for (i, c) in letters.char_indices() {
            let next = self.face.having(c);
            if let Some(now) = face.replace(next).filter(|now| *now != next) {
                self.run(&letters[start..i], now, rise, size);
                start = i;
            }
        }
        if let Some(face) = face {
            self.run(&letters[start..], face, rise, size);
        }
    }

    fn run(&mut self, letters: &str, face: Face, rise: f64, size: f64) {
        let mut buffer = UnicodeBuffer::new();
        buffer.push_str(letters);
        buffer.guess_segment_properties();
        let shaped = rustybuzz::shape(face.font(), &[], buffer);
        for (info, at) in shaped.glyph_infos().iter().zip(shaped.glyph_positions()) {
            self.line.glyphs.push(Glyph {
                face,
                id: info.glyph_id as u16,
                x: (self.x + f64::from(at.x_offset) * size).round() as i32,
                y: (rise + f64::from(at.y_offset) * size).round() as i32,
                size: (size * 1000.0).round() as i32,
            });
            self.x += f64::from(at.x_advance) * size;
        }
    }
}

/// A piece of a glyph's outline, in font units, y upwards.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Segment {
    Move(i32, i32),
    Line(i32, i32),
    Curve(i32, i32, i32, i32),
    Close,
}

/// The outline of a glyph of the embedded (quadratic) fonts; empty for spaces.
pub(super) fn outline(face: Face, id: u16) -> Vec<Segment> {
    struct Collect(Vec<Segment>);
    impl OutlineBuilder for Collect {
        fn move_to(&mut self, x: f32, y: f32) {
            self.0.push(Segment::Move(x.round() as i32, y.round() as i32));
        }
        fn line_to(&mut self, x: f32, y: f32) {
            self.0.push(Segment::Line(x.round() as i32, y.round() as i32));
        }
        fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
            let [x1, y1, x, y] = [x1, y1, x, y].map(|v| v.round() as i32);
            self.0.push(Segment::Curve(x1, y1, x, y));
        }
        fn curve_to(&mut self, x1: f32, y1: f32, _: f32, _: f32, x: f32, y: f32) {
            self.quad_to(x1, y1, x, y); // TrueType outlines have no cubic curves
        }
        fn close(&mut self) {
            self.0.push(Segment::Close);
        }
    }
    let mut collect = Collect(Vec::new());
    face.font().outline_glyph(GlyphId(id), &mut collect);
    collect.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The leftmost and rightmost point of a line's ink, in font units.
    fn ink(line: &Line) -> (f64, f64) {
        let mut ends = (f64::INFINITY, f64::NEG_INFINITY);
        for glyph in &line.glyphs {
            for segment in outline(glyph.face, glyph.id) {
                if let Segment::Move(x, _) | Segment::Line(x, _) | Segment::Curve(_, _, x, _) = segment {
                    let x = f64::from(glyph.x) + f64::from(glyph.size) / 1000.0 * f64::from(x);
                    ends = (ends.0.min(x), ends.1.max(x));
                }
            }
        }
        ends
    }

    #[test]
    fn every_letter_of_the_lecture_has_a_glyph() {
        let letters = "AZaz09 АЯЁаяё ΑΩαω «»—–−·×÷±≈≠≤≥∞∫∑∏∂∇√∗⊗⊕⋆⇔⇒→↔⟨⟩‖⌊⌋∈∉ℝℤℂ½¼²³ⁿ₀₁Ш_{1/T} f\u{303} f\u{302} x\u{304} 10^{−15} 1\u{2009}000";
        for face in [Face::Regular, Face::Bold, Face::Oblique] {
            let line = line(letters, face);
            assert!(line.glyphs.iter().all(|g| g.id != 0), "{face:?}: a letter without a glyph");
        }
        assert!(line("\u{E000}", Face::Regular).glyphs.iter().any(|g| g.id == 0), "a missing one would be found");
    }

    #[test]
    fn measured_widths_are_those_of_the_ink() {
        // Side bearings of DejaVu are below 0.13 em; the ink may not leave the measured width by more.
        let bearing = 0.13 * f64::from(EM);
        for text in ["Спектр отсчётов", "reconstruction f\u{303}(x)", "Ш_{1/T}", "10^{−15}", "x_{i}^{2} + y_{j_{k}}"]
        {
            for face in [Face::Regular, Face::Bold] {
                let line = line(text, face);
                let (left, right) = ink(&line);
                assert!((-bearing..=bearing).contains(&left), "{text}: ink starts at {left}");
                assert!((f64::from(line.width) - right).abs() <= bearing, "{text}: {} but ink to {right}", line.width);
            }
        }
    }

    #[test]
    fn combining_marks_sit_on_their_letter() {
        let (with, without) = (line("f\u{303}", Face::Regular), line("f", Face::Regular));
        assert_eq!(with.width, without.width);
    }

    #[test]
    fn scripts_are_smaller_raised_and_stacked() {
        let line = line("a_{b}^{c}^{d^{e}}", Face::Regular);
        let of = |i: usize| (line.glyphs[i].size, line.glyphs[i].y.signum());
        assert_eq!([of(0), of(1), of(2), of(3)], [(1000, 0), (700, -1), (700, 1), (700, 1)]);
        assert_eq!(line.glyphs[1].x, line.glyphs[2].x, "a subscript and a superscript stand above each other");
        assert!(line.glyphs[3].x > line.glyphs[2].x);
        assert_eq!(line.glyphs[4].size, 490);
        assert!(line.glyphs[4].y > line.glyphs[3].y);
    }

    #[test]
    fn markup_that_is_not_closed_is_text() {
        assert_eq!(parse("a_{b"), [Item::Letters("a_{b".into())]);
        assert_eq!(parse("a_b^2}"), [Item::Letters("a_b^2}".into())]);
    }

    #[test]
    fn text_is_shrunk_before_it_is_broken_and_never_below_the_least() {
        let text = "the spectrum of the samples repeats";
        let natural = width(text, Face::Regular, 24.0);
        assert_eq!(fit(text, Face::Regular, 24.0, 18.0, natural + 1.0), (text.to_owned(), 24.0));
        let (same, size) = fit(text, Face::Regular, 24.0, 18.0, 0.9 * natural);
        assert!(same == text && (21.0..22.0).contains(&size));
        let (broken, size) = fit(text, Face::Regular, 24.0, 18.0, 0.5 * natural);
        assert!(size == 18.0 && broken.lines().count() == 2 && width(&broken, Face::Regular, size) <= 0.5 * natural);
        let lines: Vec<f64> = broken.lines().map(|l| width(l, Face::Regular, size)).collect();
        assert!((lines[0] - lines[1]).abs() < 0.35 * lines[0], "lines of even length: {lines:?}");
    }
}
