//! A scene as SVG: small, self-contained, and without a font.
//!
//! The user unit is a hundredth of a unit of the picture, so that all numbers are whole. Names of glyphs and clips are
//! made from what they are: several figures in one web page may share them.

use super::png;
use super::scene::{Contour, Image, Op, Paint, Pen, Place, Scene, Shape, Words};
use super::typeset::{EM, Face, Segment, outline};
use std::collections::BTreeSet;
use std::fmt::Write;

impl Scene {
    /// The picture as an SVG document, with title and description for screen readers and the letters as outlines.
    pub fn svg(&self) -> String {
        let (width, height) = self.size;
        let lang = self.lang.code();
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" \
             viewBox=\"0 0 {}00 {}00\" width=\"{width}\" height=\"{height}\" role=\"img\" xml:lang=\"{lang}\" \
             fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n<title>{}</title>\n",
            width,
            height,
            escaped(&self.title)
        );
        if !self.about.is_empty() {
            put(&mut out, format_args!("<desc>{}</desc>\n", escaped(&self.about)));
        }
        self.definitions(&mut out);
        put(&mut out, format_args!("<path fill=\"{}\" d=\"M0 0h{width}00v{height}00H0z\"/>\n", colour(self.paper.0)));
        let mut clip = None;
        for op in &self.ops {
            if op.clip() != clip {
                if clip.is_some() {
                    out.push_str("</g>\n");
                }
                clip = op.clip();
                if let Some(clip) = clip {
                    put(&mut out, format_args!("<g clip-path=\"url(#{})\">\n", clip_name(self.clips[clip])));
                }
            }
            match op {
                Op::Shape(shape) => write_shape(&mut out, shape),
                Op::Words(words) => write_words(&mut out, words),
                Op::Image(image) => write_image(&mut out, image),
            }
        }
        if clip.is_some() {
            out.push_str("</g>\n");
        }
        out.push_str("</svg>\n");
        out
    }

    fn definitions(&self, out: &mut String) {
        out.push_str("<defs>\n");
        let used: BTreeSet<usize> = self.ops.iter().filter_map(Op::clip).collect();
        let mut named = BTreeSet::new();
        for clip in used.into_iter().map(|c| self.clips[c]) {
            let ((left, top), (right, bottom)) = clip;
            if named.insert(clip_name(clip)) {
                put(
                    out,
                    format_args!(
                        "<clipPath id=\"{}\"><path d=\"M{left} {top}H{right}V{bottom}H{left}z\"/></clipPath>\n",
                        clip_name(clip)
                    ),
                );
            }
        }
        let words = self.ops.iter().filter_map(|op| match op {
            Op::Words(words) => Some(words),
            _ => None,
        });
        let glyphs: BTreeSet<(Face, u16)> = words.flat_map(|w| w.line.glyphs.iter().map(|g| (g.face, g.id))).collect();
        for (face, id) in glyphs {
            let mut path = Path::default();
            for segment in outline(face, id) {
                match segment {
                    Segment::Move(x, y) => path.to('m', &[(x, -y)]),
                    Segment::Line(x, y) => path.line((x, -y)),
                    Segment::Curve(x1, y1, x, y) => path.to('q', &[(x1, -y1), (x, -y)]),
                    Segment::Close => path.close(),
                }
            }
            if !path.out.is_empty() {
                put(out, format_args!("<path id=\"{}\" d=\"{}\"/>\n", glyph_name(face, id), path.out));
            }
        }
        out.push_str("</defs>\n");
    }
}

fn put(out: &mut String, what: std::fmt::Arguments<'_>) {
    out.write_fmt(what).expect("writing into a string cannot fail");
}

fn glyph_name(face: Face, id: u16) -> String {
    let letter = match face {
        Face::Regular => 'r',
        Face::Bold => 'b',
        Face::Oblique => 'o',
    };
    format!("{letter}{id:x}")
}

fn clip_name(((left, top), (right, bottom)): (Place, Place)) -> String {
    format!("c{left}_{top}_{right}_{bottom}")
}

fn write_shape(out: &mut String, shape: &Shape) {
    let mut path = Path::default();
    for contour in &shape.contours {
        path.contour(contour);
    }
    put(out, format_args!("<path d=\"{}\"", path.out));
    if let Some(fill) = shape.fill {
        paint(out, "fill", fill);
    }
    if let Some(pen) = &shape.pen {
        write_pen(out, pen);
    }
    out.push_str("/>\n");
}

fn write_pen(out: &mut String, pen: &Pen) {
    paint(out, "stroke", pen.paint);
    put(out, format_args!(" stroke-width=\"{}\"", pen.width));
    if !pen.dash.is_empty() {
        let dash: Vec<String> = pen.dash.iter().map(i32::to_string).collect();
        put(out, format_args!(" stroke-dasharray=\"{}\"", dash.join(" ")));
    }
    if !pen.round {
        out.push_str(" stroke-linecap=\"butt\"");
    }
}

fn paint(out: &mut String, what: &str, paint: Paint) {
    put(out, format_args!(" {what}=\"{}\"", colour(paint.rgb)));
    if paint.percent < 100 {
        put(out, format_args!(" {what}-opacity=\".{:02}\"", paint.percent));
    }
}

fn colour([r, g, b]: [u8; 3]) -> String {
    if [r, g, b].iter().all(|c| c % 17 == 0) {
        format!("#{:x}{:x}{:x}", r / 17, g / 17, b / 17)
    } else {
        format!("#{r:02x}{g:02x}{b:02x}")
    }
}

fn write_words(out: &mut String, words: &Words) {
    let seen: Vec<_> = words.line.glyphs.iter().filter(|g| !outline(g.face, g.id).is_empty()).collect();
    if seen.is_empty() {
        return;
    }
    let scale = format!("{:.5}", f64::from(words.size) / f64::from(EM));
    let scale = scale.trim_start_matches('0').trim_end_matches('0').trim_end_matches('.');
    let (x, y) = words.at;
    let turn = if words.upright { "rotate(-90)" } else { "" };
    put(out, format_args!("<g transform=\"translate({x} {y}){turn}scale({scale})\""));
    let mut uses = String::new();
    for glyph in seen {
        put(&mut uses, format_args!("<use xlink:href=\"#{}\"", glyph_name(glyph.face, glyph.id)));
        if glyph.size != 1000 {
            let size = format!("{:.3}", f64::from(glyph.size) / 1000.0);
            let size = size.trim_start_matches('0').trim_end_matches('0');
            put(&mut uses, format_args!(" transform=\"translate({} {})scale({size})\"", glyph.x, -glyph.y));
        } else {
            if glyph.x != 0 {
                put(&mut uses, format_args!(" x=\"{}\"", glyph.x));
            }
            if glyph.y != 0 {
                put(&mut uses, format_args!(" y=\"{}\"", -glyph.y));
            }
        }
        uses.push_str("/>");
    }
    if let Some((halo, reach)) = words.halo {
        // In the group's own units, which are smaller than the picture's by its scale.
        let width = i64::from(2 * reach) * i64::from(EM) / i64::from(words.size.max(1));
        let mut behind = String::new();
        paint(&mut behind, "stroke", halo);
        put(out, format_args!("><g{behind} stroke-width=\"{width}\">{uses}</g><g"));
        paint(out, "fill", words.paint);
        put(out, format_args!(">{uses}</g></g>\n"));
    } else {
        paint(out, "fill", words.paint);
        put(out, format_args!(">{uses}</g>\n"));
    }
}

fn write_image(out: &mut String, image: &Image) {
    let ((left, top), (right, bottom)) = image.corners;
    put(
        out,
        format_args!(
            "<image x=\"{left}\" y=\"{top}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" \
         style=\"image-rendering:pixelated\" xlink:href=\"data:image/png;base64,{}\"/>\n",
            right - left,
            bottom - top,
            base64(&png::enlarged(image, 512))
        ),
    );
}

/// Path data in relative whole numbers, as short as they can be written.
#[derive(Default)]
struct Path {
    out: String,
    /// The command that numbers alone would continue.
    command: char,
    at: Place,
    start: Place,
}

impl Path {
    fn contour(&mut self, contour: &Contour) {
        let Some((first, rest)) = contour.points.split_first() else { return };
        self.to('m', &[*first]);
        for point in rest {
            self.line(*point);
        }
        if contour.closed {
            self.close();
        } else if rest.is_empty() {
            // A dot: a line so short that nobody sees its length, which every program draws with its round ends.
            self.line((first.0 + 1, first.1));
        }
    }

    fn line(&mut self, to: Place) {
        let (dx, dy) = (to.0 - self.at.0, to.1 - self.at.1);
        match (dx, dy) {
            (0, 0) => {}
            (_, 0) => {
                self.letter('h');
                self.number(dx);
            }
            (0, _) => {
                self.letter('v');
                self.number(dy);
            }
            _ => self.to('l', &[to]),
        }
        self.at = to;
    }

    fn to(&mut self, command: char, points: &[Place]) {
        self.letter(command);
        let from = self.at;
        for point in points {
            self.number(point.0 - from.0);
            self.number(point.1 - from.1);
            self.at = *point;
        }
        if command == 'm' {
            self.start = self.at;
            self.command = 'l'; // numbers after a move are lines
        }
    }

    fn close(&mut self) {
        self.letter('z');
        self.command = ' ';
        self.at = self.start;
    }

    fn letter(&mut self, command: char) {
        if self.command != command {
            self.out.push(command);
            self.command = command;
        }
    }

    fn number(&mut self, n: i32) {
        if n >= 0 && self.out.ends_with(|c: char| c.is_ascii_digit()) {
            self.out.push(' ');
        }
        put(&mut self.out, format_args!("{n}"));
    }
}

fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '\n' | '\t' => out.push(' '),
            c if c.is_control() => {}
            c => out.push(c),
        }
    }
    out
}

fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut out = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let word = (0..3).fold(0_u32, |w, i| w << 8 | u32::from(three.get(i).copied().unwrap_or(0)));
        for i in 0..4 {
            let letter = LETTERS[(word >> (18 - 6 * i) & 63) as usize];
            out.push(if i <= three.len() { char::from(letter) } else { '=' });
        }
    }
    out
}
