//! The bar beside a raster: which tone stands for which number.

use super::Failure;
use super::canvas::With;
use super::chart::{Frame, Sheet};
use super::layout::{Fitted, Placed, tick};
use super::look::{Sizes, stroke};
use super::palette::table;
use super::raster::tone;
use super::ruler::Ruler;
use super::scene::{Image, Pixels, fine};
use super::typeset::{self, CAP, Face, LEADING};
use crate::figure::{Mark, Panel, Scale, Tones};
use plotters::prelude::{PathElement, Rectangle};
use plotters::style::FontStyle;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::rc::Rc;

/// A scale of tones, as high as its plot.
#[derive(Debug, Clone)]
pub(super) struct Gauge {
    pub ruler: Ruler,
    pub label: Fitted,
    pub tones: Tones,
}

/// Between plot and bar, and how wide the bar is, in ems.
const GAP: f64 = 0.4;
const WIDTH: f64 = 0.7;

/// The scale of a panel's bar and its tones: none where there is no bar, or no raster.
pub(super) fn scale(panel: &Panel) -> Option<(Scale, Tones)> {
    let bar = panel.bar.as_ref()?;
    panel.layers.iter().find_map(|layer| match layer.mark {
        Mark::Raster { low, high, tones, .. } => Some((bar.scale((low, high)), tones)),
        _ => None,
    })
}

impl Gauge {
    /// How much room it takes to the right of the plot.
    pub(super) fn room(&self, sizes: &Sizes) -> f64 {
        let label = match self.label.lines() {
            0.0 => 0.0,
            lines => self.label.size * (CAP + 0.6 + LEADING * (lines - 1.0)),
        };
        (GAP + WIDTH) * sizes.body + 2.0 * tick(sizes) + self.widest(sizes) + label
    }

    fn widest(&self, sizes: &Sizes) -> f64 {
        let widths = self.ruler.ticks.iter().map(|t| typeset::width(&t.1, Face::Regular, sizes.body));
        widths.fold(0.0, f64::max)
    }
}

impl Sheet<'_> {
    /// The bar of a panel, if it has one: its tones from the lowest below to the highest above, ticks and numbers.
    pub(super) fn bar(&self, placed: &Placed<'_>) -> Result<(), Failure> {
        let Some(bar) = &placed.bar else { return Ok(()) };
        let (plot, sizes) = (placed.plot, self.sizes);
        let left = (plot.right + GAP * sizes.body).round();
        let frame = Frame { left, right: (left + WIDTH * sizes.body).round(), ..plot };
        let corners = [(fine(frame.left), fine(frame.top)), (fine(frame.right), fine(frame.bottom))];
        let steps = (0..=255u8).rev().map(|i| tone(f64::from(i) / 255.0, bar.tones));
        self.canvas.set(With::default());
        self.canvas.image(Image {
            corners: corners.into(),
            cells: (1, 256),
            pixels: Pixels::Toned { tones: steps.collect(), table: Rc::new(table(bar.tones)) },
            clip: None,
        });
        let line = stroke(self.theme.frame(), 1.6 * sizes.one);
        self.root.draw(&Rectangle::new(corners, line))?;
        let style = self.style(sizes.body, FontStyle::Normal, self.theme.text());
        let style = style.pos(Pos::new(HPos::Left, VPos::Center));
        for (value, number) in &bar.ruler.ticks {
            let y = frame.bottom - bar.ruler.part(*value) * frame.height();
            let at = |x: f64| (fine(x), fine(y));
            self.root.draw(&PathElement::new(vec![at(frame.right), at(frame.right + tick(sizes))], line))?;
            self.root.draw_text(number, &style, at(frame.right + 2.0 * tick(sizes)))?;
        }
        let x = frame.right + 2.0 * tick(sizes) + bar.widest(sizes) + 0.6 * bar.label.size;
        self.write(&bar.label, FontStyle::Normal, (x, 0.5 * (frame.top + frame.bottom)), VPos::Top, true)
    }
}
