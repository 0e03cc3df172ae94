//! Where everything stands: the grid of panels, their margins, ticks and titles, from measured text.

use super::bar::{self, Gauge};
use super::chart::Frame;
use super::legend::{self, Listed};
use super::look::Sizes;
use super::raster::{cells, settled};
use super::ruler::{Room, Ruler};
use super::typeset::{self, CAP, Face, LEADING};
use crate::figure::{Figure, Legend, Panel, Scale};
use crate::text::Lang;

/// A panel with everything decided.
#[derive(Debug)]
pub(super) struct Placed<'a> {
    pub panel: &'a Panel,
    /// The rectangle that the scales span.
    pub plot: Frame,
    pub x: Ruler,
    pub y: Ruler,
    pub title: Fitted,
    pub x_label: Fitted,
    pub y_label: Fitted,
    pub bar: Option<Gauge>,
    pub legend: Option<Listed<'a>>,
    /// Whether the legend stands above the plot.
    above: bool,
    /// How far the title stands above the plot to be level with the others of its row.
    pub raised: f64,
    /// What its column and row need, and what it needs itself.
    margins: Margins,
    own: Margins,
    pub cell: Frame,
    /// Whether the panel below counts the same along the same scale: numbers stand there alone.
    stacked: bool,
    row: usize,
    columns: (usize, usize),
}

/// Text, broken into lines, and the size at which it fits.
#[derive(Debug, Clone, Default)]
pub(super) struct Fitted {
    pub text: String,
    pub size: f64,
}

impl Fitted {
    fn new(text: &str, face: Face, size: f64, least: f64, room: f64) -> Self {
        let (text, size) = typeset::fit(text, face, size, least.min(size), room);
        Self { text, size }
    }

    pub(super) fn lines(&self) -> f64 {
        self.text.lines().count() as f64
    }

    /// The height of all lines with their leading.
    pub(super) fn height(&self) -> f64 {
        self.lines() * LEADING * self.size
    }
}

/// What stands around a plot, in units of the picture.
#[derive(Debug, Clone, Copy, Default)]
struct Margins {
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

impl Margins {
    fn max(self, other: Self) -> Self {
        Self {
            left: self.left.max(other.left),
            right: self.right.max(other.right),
            top: self.top.max(other.top),
            bottom: self.bottom.max(other.bottom),
        }
    }

    /// What they leave of a cell, in whole units.
    fn within(self, cell: Frame) -> Frame {
        Frame {
            left: (cell.left + self.left).ceil(),
            top: (cell.top + self.top).ceil(),
            right: (cell.right - self.right).floor(),
            bottom: (cell.bottom - self.bottom).floor(),
        }
    }
}

/// The length of a tick. plotters puts labels at twice that distance: far enough that in the corner of the frame the
/// lowest number on the left stays above the exponent of the first one below.
pub(super) fn tick(sizes: &Sizes) -> f64 {
    0.3 * sizes.body
}

/// Everything of `figure` placed within `page`.
pub(super) fn placed<'a>(figure: &'a Figure, page: Frame, sizes: &Sizes, lang: Lang) -> Vec<Placed<'a>> {
    let mut panels = grid(figure, page, sizes);
    settle(&mut panels, sizes, lang);
    // A legend that would hide data in every corner moves above its plot, if the plot can spare the room or its row
    // gives that room up anyway.
    let hiding: Vec<bool> = panels
        .iter()
        .map(|p| legend::boxed(p.panel, sizes, lang, p.plot, (&p.x, &p.y)).is_some_and(|(_, hides)| hides && !p.above))
        .collect();
    let moved = hiding.contains(&true);
    for (p, _) in panels.iter_mut().zip(&hiding).filter(|(p, hides)| **hides && p.plot.height() > 6.0 * sizes.body) {
        p.above = true;
    }
    let raised: Vec<usize> = panels.iter().filter(|p| p.above).map(|p| p.row).collect();
    for (p, _) in panels.iter_mut().zip(&hiding).filter(|(p, hides)| **hides && raised.contains(&p.row)) {
        p.above = true;
    }
    if moved {
        settle(&mut panels, sizes, lang);
    }
    for p in panels.iter_mut().filter(|p| !p.above) {
        p.legend = legend::boxed(p.panel, sizes, lang, p.plot, (&p.x, &p.y)).map(|(listed, _)| listed);
    }
    let rows: Vec<(usize, f64, f64)> = panels.iter().map(|p| (p.row, p.plot.top, p.rows())).collect();
    for p in &mut panels {
        let level = rows.iter().filter(|(row, top, _)| *row == p.row && *top == p.plot.top);
        p.raised = level.map(|(_, _, height)| *height).fold(0.0, f64::max);
    }
    panels
}

/// Chooses margins, ticks and plots. Ticks depend on the plot's size, and that on the width of the labels: a few rounds
/// settle it, the last ones never giving room back.
fn settle(panels: &mut [Placed<'_>], sizes: &Sizes, lang: Lang) {
    for round in 0..5 {
        for p in panels.iter_mut() {
            p.measure(sizes, lang);
        }
        let needs: Vec<Margins> = panels.iter().map(|p| p.needs(sizes)).collect();
        let shared: Vec<Margins> = panels.iter().map(|p| p.shared(panels, &needs)).collect();
        for ((p, shared), own) in panels.iter_mut().zip(shared).zip(needs) {
            let own = Margins { top: shared.top, ..own };
            for (margins, needed) in [(&mut p.margins, shared), (&mut p.own, own)] {
                *margins = if round < 2 { needed } else { margins.max(needed) };
            }
            let room = p.margins.within(p.cell);
            p.plot =
                if p.panel.square { pictured(p.panel, p.own.within(p.cell), room) } else { settled(p.panel, room) };
        }
    }
    level(panels);
    for p in panels {
        p.measure(sizes, lang);
    }
}

/// The plot of a picture: as large as its own margins allow, and as near to the middle of its column as they do.
fn pictured(panel: &Panel, own: Frame, column: Frame) -> Frame {
    let plot = settled(panel, own);
    let middle = 0.5 * (column.left + column.right - plot.width());
    let left = middle.max(own.left).min(own.right - plot.width()).round();
    Frame { left, right: left + plot.width(), ..plot }
}

/// Pictures of a row, which are as high as suits their cells, stand level at the top, and so do their titles. Those of one
/// scale are equally large, though one may have to spare the room for a bar.
fn level(panels: &mut [Placed<'_>]) {
    let kind = |p: &Placed<'_>| (p.row, p.panel.x.range, p.panel.y.range, cells(p.panel));
    let seen: Vec<_> = panels.iter().filter(|p| p.panel.square).map(|p| (kind(p), p.plot)).collect();
    for p in panels.iter_mut().filter(|p| p.panel.square) {
        let row = seen.iter().filter(|(other, _)| other.0 == p.row);
        let top = row.map(|(_, plot)| plot.top).fold(p.plot.top, f64::min);
        let least = |length: fn(&Frame) -> f64| {
            let alike = seen.iter().filter(|(other, _)| *other == kind(p));
            alike.map(|(_, plot)| length(plot)).fold(length(&p.plot), f64::min)
        };
        let (width, height) = (least(Frame::width), least(Frame::height));
        let left = (0.5 * (p.plot.left + p.plot.right - width)).round();
        p.plot = Frame { left, top, right: left + width, bottom: top + height };
    }
}

/// The cells of the grid.
fn grid<'a>(figure: &'a Figure, page: Frame, sizes: &Sizes) -> Vec<Placed<'a>> {
    let columns = figure.columns.max(1);
    let mut places = Vec::new();
    let (mut row, mut column) = (0, 0);
    for panel in &figure.panels {
        let span = panel.span.clamp(1, columns);
        if column + span > columns {
            (row, column) = (row + 1, 0);
        }
        places.push((panel, row, (column, column + span)));
        column += span;
    }
    let rows = if figure.panels.is_empty() { 0 } else { row + 1 };
    let gap = (24.0 * sizes.one, 18.0 * sizes.one);
    let weight = |r: usize| figure.heights.get(r).copied().filter(|w| *w > 0.0 && w.is_finite()).unwrap_or(1.0);
    let total: f64 = (0..rows).map(weight).sum();
    let height = page.height() - gap.1 * rows.saturating_sub(1) as f64;
    let width = (page.width() - gap.0 * (columns - 1) as f64) / columns as f64;
    let top = |r: usize| page.top + (0..r).map(|r| height * weight(r) / total + gap.1).sum::<f64>();
    let left = |c: usize| page.left + c as f64 * (width + gap.0);
    let place = |(panel, row, columns): (&'a Panel, usize, (usize, usize))| {
        let cell = Frame {
            left: left(columns.0),
            top: top(row),
            right: left(columns.1) - gap.0,
            bottom: top(row + 1) - gap.1,
        };
        let empty = Room { length: 1.0, takes: &|_| 1.0, most: 2, lang: Lang::En };
        let plot = Frame {
            left: cell.left + 3.0 * sizes.body,
            top: cell.top + 2.0 * sizes.body,
            right: cell.right - sizes.body,
            bottom: cell.bottom - 3.0 * sizes.body,
        };
        Placed {
            panel,
            plot,
            x: Ruler::new(&panel.x, &empty),
            y: Ruler::new(&panel.y, &empty),
            title: Fitted::default(),
            x_label: Fitted::default(),
            y_label: Fitted::default(),
            bar: None,
            legend: None,
            above: panel.legend == Legend::Above,
            raised: 0.0,
            margins: Margins::default(),
            own: Margins::default(),
            cell,
            stacked: false,
            row,
            columns,
        }
    };
    let mut panels: Vec<Placed<'a>> = places.into_iter().map(place).collect();
    // a row without numbers makes room only if all of it does without
    let below = |p: &Placed<'_>, q: &Placed<'_>| (q.row, q.columns) == (p.row + 1, p.columns) && q.panel.x == p.panel.x;
    let open: Vec<usize> = panels.iter().filter(|p| !panels.iter().any(|q| below(p, q))).map(|p| p.row).collect();
    panels.iter_mut().for_each(|p| p.stacked = !open.contains(&p.row));
    panels
}

impl Placed<'_> {
    /// Ticks, titles and the legend above, for the present size of the plot.
    fn measure(&mut self, sizes: &Sizes, lang: Lang) {
        let wide = |label: &str| typeset::width(label, Face::Regular, sizes.body) + 0.7 * sizes.body;
        let tall = |label: &str| sizes.body * if label.contains("^{") { 1.75 } else { 1.5 };
        let most = |length: f64, each: f64, top: usize| ((length / (each * sizes.body)) as usize).clamp(3, top);
        let (width, height) = (self.plot.width(), self.plot.height());
        let ruler = |scale: &Scale, length, takes, most| Ruler::new(scale, &Room { length, takes, most, lang });
        self.x = ruler(&self.panel.x, width, &wide, most(width, 2.6, 11));
        self.y = ruler(&self.panel.y, height, &tall, most(height, 1.9, 8));
        let body = |text: &str, room| Fitted::new(text, Face::Regular, sizes.body, sizes.least, room);
        self.x_label = body(self.panel.x.label.get(lang), self.cell.width().min(1.6 * width));
        if self.stacked {
            self.x.ticks.iter_mut().for_each(|tick| tick.1.clear());
            self.x_label = Fitted::default();
        }
        self.y_label = body(self.panel.y.label.get(lang), height.max(4.0 * sizes.body));
        self.bar = bar::scale(self.panel).map(|(scale, tones)| Gauge {
            ruler: ruler(&scale, height, &tall, most(height, 1.9, 8)),
            label: body(scale.label.get(lang), height.max(4.0 * sizes.body)),
            tones,
        });
        let title = self.panel.title.get(lang);
        self.title = Fitted::new(title, Face::Bold, sizes.heading, sizes.least, self.cell.width());
        self.legend = if self.above { legend::rows(self.panel, sizes, lang, width) } else { None };
    }

    /// The height of the legend above the plot.
    fn rows(&self) -> f64 {
        let rows = self.legend.as_ref().filter(|l| l.frame.is_none());
        rows.map_or(0.0, |l| l.height())
    }

    /// The label areas left of and below the plot, as plotters takes them.
    pub(super) fn label_areas(&self, sizes: &Sizes) -> (f64, f64) {
        let gap = 2.0 * tick(sizes);
        let ticks = &self.y.ticks;
        let widest = ticks.iter().map(|t| typeset::width(&t.1, Face::Regular, sizes.body)).fold(0.0, f64::max);
        let mut left = if ticks.is_empty() { 0.0 } else { gap + widest };
        let lines = self.y_label.lines();
        if lines > 0.0 {
            left += self.y_label.size * (CAP + 0.3 + LEADING * (lines - 1.0)) + 0.35 * sizes.body;
        }
        let numbers = self.x.ticks.iter().map(|t| t.1.lines().count()).max().unwrap_or(0) as f64;
        let mut below = if numbers == 0.0 { 0.0 } else { gap + sizes.body * (CAP + 0.25 + LEADING * (numbers - 1.0)) };
        let lines = self.x_label.lines();
        if lines > 0.0 {
            below += self.x_label.size * (CAP + LEADING * (lines - 1.0)) + 0.45 * sizes.body;
        }
        (left, below)
    }

    fn needs(&self, sizes: &Sizes) -> Margins {
        let (left, below) = self.label_areas(sizes);
        let beyond = |part: f64, label: &str, length: f64, end: f64| {
            let half = 0.5 * typeset::width(label, Face::Regular, sizes.body);
            half - (part - end).abs() * length
        };
        let width = self.plot.width();
        let over = |end: f64| {
            let ticks = self.x.ticks.iter();
            ticks.map(|t| beyond(self.x.part(t.0), &t.1, width, end)).fold(0.0, f64::max)
        };
        let label = 0.5 * (typeset::width(&self.x_label.text, Face::Regular, self.x_label.size) - width).max(0.0);
        let title = self.title.height() + if self.title.lines() > 0.0 { 0.4 * sizes.body } else { 0.0 };
        let rows = self.rows();
        Margins {
            left: left.max(over(0.0)).max(label),
            right: over(1.0).max(label).max(2.0 * sizes.one).max(self.bar.as_ref().map_or(0.0, |bar| bar.room(sizes))),
            top: (title + rows).max(0.5 * sizes.body),
            bottom: below + 0.28 * sizes.body,
        }
    }

    /// Panels of a column share their left and right margins, those of a row their upper and lower ones, so that plots
    /// stand in line. Pictures, which do not fill their cells, share the upper ones alone.
    fn shared(&self, panels: &[Placed<'_>], needs: &[Margins]) -> Margins {
        let most = |same: &dyn Fn(&Placed<'_>) -> bool, of: &dyn Fn(&Margins) -> f64| {
            panels.iter().zip(needs).filter(|(p, _)| same(p)).map(|(_, m)| of(m)).fold(0.0, f64::max)
        };
        // what stands beside a picture is no concern of the plots above and below it
        let counts = |p: &Placed<'_>| self.panel.square || !p.panel.square;
        Margins {
            left: most(&|p| p.columns.0 == self.columns.0 && counts(p), &|m| m.left),
            right: most(&|p| p.columns.1 == self.columns.1 && counts(p), &|m| m.right),
            top: most(&|p| p.row == self.row, &|m| m.top),
            bottom: most(&|p| p.row == self.row, &|m| m.bottom),
        }
    }
}
