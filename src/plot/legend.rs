//! The list of what a panel's layers are.

use super::Failure;
use super::canvas::With;
use super::chart::{Frame, Sheet};
use super::elements::corners;
use super::layout::Placed;
use super::look::{Look, Marker, Sizes, filled, stroke};
use super::palette::table;
use super::ruler::Ruler;
use super::scene::{FINE, Image, Pixels, fine};
use super::typeset::{self, Face, LEADING};
use crate::figure::{Layer, Legend, Mark, Panel};
use crate::text::Lang;
use plotters::prelude::{Circle, PathElement, Polygon, Rectangle};
use plotters::style::FontStyle;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::rc::Rc;

/// One line of a legend: layers of the same name share it.
#[derive(Debug, Clone)]
pub(super) struct Entry<'a> {
    pub label: String,
    pub layers: Vec<&'a Layer>,
    /// How long its sample is, in ems.
    sample: f64,
    /// The middle of the left edge, in units of the picture.
    pub left: f64,
    pub middle: f64,
}

/// A legend at its place.
#[derive(Debug, Clone)]
pub(super) struct Listed<'a> {
    pub entries: Vec<Entry<'a>>,
    pub size: f64,
    /// Its background; none for a legend above the plot.
    pub frame: Option<Frame>,
}

fn entries(panel: &Panel, lang: Lang) -> Vec<Entry<'_>> {
    let mut entries: Vec<Entry<'_>> = Vec::new();
    for layer in panel.layers.iter().filter(|l| !l.label.get(lang).is_empty()) {
        let label = layer.label.get(lang);
        let sample = sample(layer);
        match entries.iter_mut().find(|e| e.label == label) {
            Some(entry) => {
                entry.layers.push(layer);
                entry.sample = entry.sample.max(sample);
            }
            None => {
                let (label, layers) = (label.to_owned(), vec![layer]);
                entries.push(Entry { label, layers, sample, left: 0.0, middle: 0.0 });
            }
        }
    }
    entries
}

/// How long the sample of a layer is, in ems: lines need length, upright things do not.
fn sample(layer: &Layer) -> f64 {
    match layer.mark {
        Mark::Dots(_) | Mark::Stems(_) | Mark::Arrows(_) | Mark::Verticals(_) => 0.75,
        Mark::Area(_) | Mark::Bars { .. } | Mark::Spans(_) => 1.3,
        _ => 1.7,
    }
}

/// Between a sample and its label, in ems.
const GAP: f64 = 0.45;
/// Between entries in a row, in ems.
const BETWEEN: f64 = 1.3;
/// From line to line, in ems.
const LINE: f64 = 1.35;

fn width(entry: &Entry<'_>, size: f64) -> f64 {
    typeset::width(&entry.label, Face::Regular, size) + (entry.sample + GAP) * size
}

fn lines(entry: &Entry<'_>) -> f64 {
    entry.label.lines().count().max(1) as f64
}

/// A legend in rows at most `room` wide, as few as hold it and equally full; places are relative to the upper left
/// corner of the rows.
pub(super) fn rows<'a>(panel: &'a Panel, sizes: &Sizes, lang: Lang, room: f64) -> Option<Listed<'a>> {
    let mut entries = entries(panel, lang);
    if entries.is_empty() {
        return None;
    }
    let size = sizes.body;
    for entry in &mut entries {
        (entry.label, _) = typeset::fit(&entry.label, Face::Regular, size, size, room - (entry.sample + GAP) * size);
    }
    let count = flowed(&mut entries, size, room);
    let (mut narrow, mut wide) = (0.0, room);
    for _ in 0..10 {
        let middle = 0.5 * (narrow + wide);
        if flowed(&mut entries, size, middle) > count { narrow = middle } else { wide = middle }
    }
    flowed(&mut entries, size, wide);
    Some(Listed { entries, size, frame: None })
}

/// Places entries in rows and counts the rows.
fn flowed(entries: &mut [Entry<'_>], size: f64, room: f64) -> usize {
    let (mut left, mut row, mut tall, mut count) = (0.0, 0.0, 1.0_f64, 1);
    for entry in entries {
        if left > 0.0 && left + width(entry, size) > room {
            row += LINE + LEADING * (tall - 1.0);
            (left, tall, count) = (0.0, 1.0, count + 1);
        }
        entry.left = left;
        entry.middle = (row + LINE / 2.0 + 0.5 * LEADING * (lines(entry) - 1.0)) * size;
        tall = tall.max(lines(entry));
        left += width(entry, size) + BETWEEN * size;
    }
    count
}

/// A legend in a corner of the plot: the one that the panel names, unless it would hide data there and another corner
/// is free. With it comes whether it hides data even so, because all corners do.
pub(super) fn boxed<'a>(
    panel: &'a Panel,
    sizes: &Sizes,
    lang: Lang,
    plot: Frame,
    (x, y): (&Ruler, &Ruler),
) -> Option<(Listed<'a>, bool)> {
    let mut entries = entries(panel, lang);
    if entries.is_empty() {
        return None;
    }
    // One below the other, labels start at one place.
    let longest = entries.iter().map(|e| e.sample).fold(0.0, f64::max);
    entries.iter_mut().for_each(|e| e.sample = longest);
    let room = 0.62 * plot.width();
    let widest = |size: f64, entries: &[Entry<'_>]| entries.iter().map(|e| width(e, size)).fold(0.0, f64::max);
    let tall = |size: f64, entries: &[Entry<'_>]| size * (entries.len() as f64 * LINE + 0.4);
    let mut size = sizes.body;
    if widest(size, &entries) > room || tall(size, &entries) > 0.55 * plot.height() {
        size = sizes.least.max(0.85 * size);
    }
    for entry in &mut entries {
        (entry.label, _) = typeset::fit(&entry.label, Face::Regular, size, size, room - (entry.sample + GAP) * size);
    }
    let (pad, margin) = (0.4 * size, 0.5 * size);
    let box_width = widest(size, &entries) + 2.0 * pad;
    let text: f64 = entries.iter().map(|e| LINE + LEADING * (lines(e) - 1.0)).sum();
    let box_height = text * size + pad;
    let at = |corner: Legend| {
        let (right, lower) = match corner {
            Legend::UpperRight | Legend::Above => (true, false),
            Legend::UpperLeft => (false, false),
            Legend::LowerRight => (true, true),
            Legend::LowerLeft => (false, true),
        };
        let left = if right { plot.right - margin - box_width } else { plot.left + margin };
        let top = if lower { plot.bottom - margin - box_height } else { plot.top + margin };
        Frame { left, top, right: left + box_width, bottom: top + box_height }
    };
    let hidden = |corner: Legend| covered(panel, at(corner), plot, x, y);
    let others = [Legend::UpperRight, Legend::UpperLeft, Legend::LowerRight, Legend::LowerLeft];
    let corner = if hidden(panel.legend) == 0 {
        panel.legend
    } else {
        others.into_iter().find(|c| hidden(*c) == 0).unwrap_or(panel.legend)
    };
    let frame = at(corner);
    let mut top = frame.top + 0.5 * pad;
    for entry in &mut entries {
        let height = (LINE + LEADING * (lines(entry) - 1.0)) * size;
        (entry.left, entry.middle) = (frame.left + pad, top + height / 2.0);
        top += height;
    }
    Some((Listed { entries, size, frame: Some(frame) }, hidden(corner) > 0))
}

/// How many data of the panel lie under `frame`; points of curves count also where they are between data.
fn covered(panel: &Panel, frame: Frame, plot: Frame, x: &Ruler, y: &Ruler) -> usize {
    let place = |px: f64, py: f64| (plot.left + x.part(px) * plot.width(), plot.bottom - y.part(py) * plot.height());
    let under =
        |(px, py): (f64, f64)| (frame.left..=frame.right).contains(&px) && (frame.top..=frame.bottom).contains(&py);
    let crosses = |a: (f64, f64), b: (f64, f64)| {
        (0..=16).any(|i| {
            let t = f64::from(i) / 16.0;
            under((a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1)))
        })
    };
    let base = y.base();
    let count = |layer: &Layer| match &layer.mark {
        Mark::Line(p) => p.windows(2).filter(|w| crosses(place(w[0][0], w[0][1]), place(w[1][0], w[1][1]))).count(),
        Mark::Dots(p) => p.iter().filter(|p| under(place(p[0], p[1]))).count(),
        Mark::Stems(p) | Mark::Arrows(p) => p.iter().filter(|p| crosses(place(p[0], base), place(p[0], p[1]))).count(),
        Mark::Bars { width, points } => {
            let bar = |p: &&[f64; 2]| {
                let edges = [-0.5, 0.0, 0.5].map(|side| p[0] + side * width);
                edges.into_iter().any(|x| crosses(place(x, base), place(x, p[1])))
            };
            points.iter().filter(bar).count()
        }
        Mark::Pointers(p) => p.iter().filter(|[a, b]| crosses(place(a[0], a[1]), place(b[0], b[1]))).count(),
        Mark::Notes(notes) => notes.iter().filter(|(p, _)| under(place(p[0], p[1]))).count(),
        Mark::Area(p) => p.iter().filter(|p| crosses(place(p[0], p[1]), place(p[0], p[2]))).count(),
        Mark::Verticals(_) | Mark::Horizontals(_) | Mark::Spans(_) | Mark::Raster { .. } | Mark::Colors { .. } => 0,
    };
    panel.layers.iter().map(count).sum()
}

impl Listed<'_> {
    /// How high the rows above a plot are, with the gap to it.
    pub(super) fn height(&self) -> f64 {
        let bottom = |e: &Entry<'_>| e.middle + (0.5 * LINE + 0.5 * LEADING * (lines(e) - 1.0)) * self.size;
        self.entries.iter().map(bottom).fold(0.0, f64::max) + 0.3 * self.size
    }
}

impl Sheet<'_> {
    /// The legend of a panel over everything else in it.
    pub(super) fn legend(&self, placed: &Placed<'_>) -> Result<(), Failure> {
        let Some(listed) = &placed.legend else { return Ok(()) };
        let size = listed.size;
        let mut origin = (0.0, 0.0);
        if let Some(frame) = listed.frame {
            let corners = [(fine(frame.left), fine(frame.top)), (fine(frame.right), fine(frame.bottom))];
            self.root.draw(&Rectangle::new(corners, filled(self.theme.paper(), 0.88)))?;
            self.root.draw(&Rectangle::new(corners, stroke(self.theme.grid(), 1.5 * self.sizes.one)))?;
        } else {
            let widest = listed.entries.iter().map(|e| e.left + width(e, size)).fold(0.0, f64::max);
            let left = placed.plot.left + 0.5 * (placed.plot.width() - widest).max(0.0);
            origin = (left, placed.plot.top - listed.height());
        }
        for entry in &listed.entries {
            let (x, y) = (origin.0 + entry.left, origin.1 + entry.middle);
            for layer in &entry.layers {
                self.sample(layer, (x, y), (size, entry.sample))?;
            }
            let style = self.style(size, FontStyle::Normal, self.theme.text());
            let style = style.pos(Pos::new(HPos::Left, VPos::Center));
            let left = x + (entry.sample + GAP) * size;
            self.canvas.set(With::default());
            self.root.draw_text(&entry.label, &style, (fine(left), fine(y)))?;
        }
        Ok(())
    }

    /// A small sample of a layer, `long` ems long, its left end's middle at a place.
    fn sample(&self, layer: &Layer, (x, y): (f64, f64), (size, long): (f64, f64)) -> Result<(), Failure> {
        let look = Look::of(layer, self.theme, self.sizes);
        let at = |along: f64, down: f64| (fine(x + along * long * size), fine(y + down * size));
        let path = |points: Vec<(i32, i32)>| PathElement::new(points, look.line());
        let area = |opacity: f64| Rectangle::new([at(0.05, -0.36), at(0.95, 0.36)], filled(look.rgb, opacity));
        self.canvas.set(With { dash: look.dash.clone(), ..With::default() });
        let dot = |place: (i32, i32)| -> Result<(), Failure> {
            self.canvas.set(With::default());
            let radius = (1.9 * self.sizes.line).min(0.3 * size);
            if look.marker == Marker::Circle {
                self.root.draw(&Circle::new(place, (radius * FINE).round() as i32, filled(look.rgb, 1.0)))?;
            } else {
                let points: Vec<_> =
                    corners(look.marker, radius).into_iter().map(|c| (c.0 + place.0, c.1 + place.1)).collect();
                self.root.draw(&Polygon::new(points, filled(look.rgb, 1.0)))?;
            }
            Ok(())
        };
        let head = |tip: (f64, f64), up: bool| {
            let (deep, half) = (0.38, 0.17);
            let wide = half / long;
            if up {
                vec![at(tip.0, tip.1), at(tip.0 - wide, tip.1 + deep), at(tip.0 + wide, tip.1 + deep)]
            } else {
                let back = tip.0 - deep / long;
                vec![at(tip.0, tip.1), at(back, tip.1 - half), at(back, tip.1 + half)]
            }
        };
        match &layer.mark {
            Mark::Line(_) | Mark::Horizontals(_) => self.root.draw(&path(vec![at(0.0, 0.0), at(1.0, 0.0)]))?,
            Mark::Dots(_) => dot(at(0.5, 0.0))?,
            Mark::Stems(_) => {
                self.root.draw(&path(vec![at(0.5, 0.45), at(0.5, -0.25)]))?;
                dot(at(0.5, -0.25))?;
            }
            Mark::Arrows(_) => {
                self.root.draw(&path(vec![at(0.5, 0.45), at(0.5, -0.2)]))?;
                self.root.draw(&Polygon::new(head((0.5, -0.48), true), filled(look.rgb, 1.0)))?;
            }
            Mark::Pointers(_) => {
                self.root.draw(&path(vec![at(0.0, 0.0), at(0.85, 0.0)]))?;
                self.root.draw(&Polygon::new(head((1.0, 0.0), false), filled(look.rgb, 1.0)))?;
            }
            Mark::Area(_) => self.root.draw(&area(self.theme.wash(0.4)))?,
            Mark::Bars { .. } => self.root.draw(&area(0.8))?,
            Mark::Spans(_) => self.root.draw(&area(self.theme.wash(0.35)))?,
            Mark::Verticals(_) => self.root.draw(&path(vec![at(0.5, 0.45), at(0.5, -0.45)]))?,
            Mark::Notes(_) | Mark::Colors { .. } => {}
            Mark::Raster { tones, .. } => {
                let tones = Pixels::Toned { tones: (0..8).map(|i| i * 36).collect(), table: Rc::new(table(*tones)) };
                let corners = (at(0.05, -0.36), at(0.95, 0.36));
                self.canvas.image(Image { corners, cells: (8, 1), pixels: tones, clip: None });
            }
        }
        Ok(())
    }
}
