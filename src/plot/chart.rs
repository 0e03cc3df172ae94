//! One panel as a chart of plotters.

use super::Failure;
use super::canvas::{Canvas, With};
use super::layout::{Fitted, Placed, tick};
use super::look::{Sizes, filled, halo, ink, stroke};
use super::marks::Painter;
use super::palette::{Rgb, Theme};
use super::ruler::Ruler;
use super::scene::{FINE, fine};
use super::typeset::{self, Face, LEADING};
use crate::figure::{Layer, Mark, Meaning};
use crate::text::Lang;
use plotters::chart::{ChartBuilder, ChartContext, LabelAreaPosition};
use plotters::coord::Shift;
use plotters::drawing::DrawingArea;
use plotters::prelude::{Cartesian2d, PathElement, Rectangle};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontDesc, FontFamily, FontStyle, FontTransform, TextStyle};

/// plotters' chart over two of our rulers.
pub(super) type Chart<'a> = ChartContext<'a, Canvas, Cartesian2d<Ruler, Ruler>>;
/// plotters' drawing area without coordinates.
pub(super) type Area = DrawingArea<Canvas, Shift>;

/// A rectangle in units of the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frame {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
}

impl Frame {
    pub(super) fn width(&self) -> f64 {
        self.right - self.left
    }

    pub(super) fn height(&self) -> f64 {
        self.bottom - self.top
    }
}

/// What all panels of a figure share.
pub(super) struct Sheet<'a> {
    pub root: &'a Area,
    pub canvas: &'a Canvas,
    pub theme: Theme,
    pub lang: Lang,
    pub sizes: &'a Sizes,
}

impl Sheet<'_> {
    /// Draws a panel: the mesh, the layers from the bottom up, notes and the legend above them.
    pub(super) fn panel(&self, placed: &Placed<'_>) -> Result<(), Failure> {
        let (sizes, theme) = (self.sizes, self.theme);
        let plot = placed.plot;
        let (left, below) = placed.label_areas(sizes);
        let corner = (fine(plot.left - left), fine(plot.top));
        let size = (fine(plot.width() + left), fine(plot.height() + below));
        let area = self.root.clone().shrink(corner, size);
        let mut chart: Chart<'static> = ChartBuilder::on(&area)
            .set_label_area_size(LabelAreaPosition::Left, fine(left))
            .set_label_area_size(LabelAreaPosition::Bottom, fine(below))
            .build_cartesian_2d(placed.x.clone(), placed.y.clone())?;
        self.canvas.set(With::default());
        self.mesh(&mut chart, placed)?;

        let reach = 0.5 * sizes.line;
        let clip = self.canvas.clip((
            (fine(plot.left - reach), fine(plot.top - reach)),
            (fine(plot.right + reach), fine(plot.bottom + reach)),
        ));
        let frame = stroke(theme.frame(), 1.6 * sizes.one);
        let outline = Rectangle::new([(placed.x.low(), placed.y.high()), (placed.x.high(), placed.y.low())], frame);
        let (images, others): (Vec<&Layer>, Vec<&Layer>) = placed.panel.layers.iter().partition(|l| l.mark.is_image());
        let mut painter =
            Painter { chart: &mut chart, canvas: self.canvas, x: &placed.x, y: &placed.y, plot, clip, theme, sizes };
        for layer in images {
            painter.draw(layer)?;
        }
        self.canvas.set(With::default());
        painter.chart.draw_series([outline])?;
        for layer in &others {
            painter.draw(layer)?;
        }
        for layer in others {
            self.notes(&chart, layer, placed)?;
        }
        self.canvas.set(With::default());
        self.bar(placed)?;
        self.legend(placed)?;
        self.title(placed)
    }

    /// Grid, ticks, numbers and labels of the scales, by plotters.
    fn mesh(&self, chart: &mut Chart<'static>, placed: &Placed<'_>) -> Result<(), Failure> {
        let (sizes, theme) = (self.sizes, self.theme);
        let grid = !placed.panel.layers.iter().any(|layer| layer.mark.is_image());
        let light = stroke(theme.grid(), 1.2 * sizes.one);
        let axes = self.style(sizes.body, FontStyle::Normal, theme.text());
        let mut mesh = chart.configure_mesh();
        mesh.light_line_style(light)
            .bold_line_style(stroke(theme.grid(), 2.0 * sizes.one))
            .axis_style(stroke(theme.frame(), 1.6 * sizes.one))
            .set_all_tick_mark_size(fine(tick(sizes)))
            .x_label_style(axes.clone())
            .y_label_style(axes);
        if !grid {
            mesh.disable_mesh();
        }
        mesh.draw()?;
        let zero = placed.y.shows(0.0) && !placed.y.log() && placed.y.base() == 0.0 && !placed.panel.y.bare && grid;
        if zero {
            let line = stroke(theme.frame(), 1.4 * sizes.one);
            let ends = vec![(placed.x.low(), 0.0), (placed.x.high(), 0.0)];
            chart.draw_series([PathElement::new(ends, line)])?;
        }
        let plot = placed.plot;
        let (left, below) = placed.label_areas(sizes);
        let centre = (0.5 * (plot.left + plot.right), 0.5 * (plot.top + plot.bottom));
        self.write(&placed.x_label, FontStyle::Normal, (centre.0, plot.bottom + below), VPos::Bottom, false)?;
        self.write(&placed.y_label, FontStyle::Normal, (plot.left - left, centre.1), VPos::Top, true)
    }

    /// Text centred at a place.
    pub(super) fn write(
        &self,
        text: &Fitted,
        weight: FontStyle,
        (x, y): (f64, f64),
        v: VPos,
        upright: bool,
    ) -> Result<(), Failure> {
        let mut style = self.style(text.size, weight, self.theme.text()).pos(Pos::new(HPos::Center, v));
        if upright {
            style = style.transform(FontTransform::Rotate270);
        }
        self.root.draw_text(&text.text, &style, (fine(x), fine(y)))
    }

    /// A style of text for plotters; our canvas knows one family.
    pub(super) fn style(&self, size: f64, weight: FontStyle, rgb: Rgb) -> TextStyle<'static> {
        let font = FontDesc::new(FontFamily::SansSerif, size * FINE, weight);
        TextStyle { font, color: ink(rgb, 1.0).to_backend_color(), pos: Pos::default() }
    }

    fn title(&self, placed: &Placed<'_>) -> Result<(), Failure> {
        let (plot, title) = (placed.plot, &placed.title);
        let half = 0.5 * typeset::width(&title.text, Face::Bold, title.size);
        let (least, most) = (placed.cell.left + half, placed.cell.right - half);
        let x = (0.5 * (plot.left + plot.right)).min(most).max(least);
        let baseline = plot.top - placed.raised - 0.6 * self.sizes.body;
        self.write(title, FontStyle::Bold, (x, baseline), VPos::Bottom, false)
    }

    /// The figure's title, centred at the top of the page.
    pub(super) fn headline(&self, title: &Fitted, (x, top): (f64, f64)) -> Result<(), Failure> {
        self.write(title, FontStyle::Bold, (x, top), VPos::Top, false)
    }

    /// The notes of a layer, moved where they would leave the plot.
    fn notes(&self, chart: &Chart<'static>, layer: &Layer, placed: &Placed<'_>) -> Result<(), Failure> {
        let Mark::Notes(notes) = &layer.mark else { return Ok(()) };
        let (plot, sizes) = (placed.plot, self.sizes);
        let pad = 0.3 * sizes.body;
        let rgb = if layer.meaning == Meaning::Guide { self.theme.text() } else { self.theme.colour(layer.meaning) };
        self.canvas.set(With { halo: Some(halo(self.theme, sizes.body)), ..With::default() });
        // On an image a halo is not enough: letters get a plate.
        let plate = placed.panel.layers.iter().any(|layer| layer.mark.is_image());
        for ([x, y], text) in notes {
            if !placed.x.shows(*x) || !placed.y.shows(*y) {
                continue;
            }
            let (text, size) = typeset::fit(
                text.get(self.lang),
                Face::Regular,
                sizes.body,
                sizes.least.min(sizes.body),
                plot.width() - 3.0 * pad,
            );
            let half = 0.5 * typeset::width(&text, Face::Regular, size);
            let tall = 0.5 * size * (1.0 + LEADING * (text.lines().count().max(1) - 1) as f64);
            let (px, py) = chart.plotting_area().map_coordinate(&(*x, *y));
            let (px, py) = (f64::from(px) / FINE, f64::from(py) / FINE);
            let x = px.min(plot.right - 1.5 * pad - half).max(plot.left + 1.5 * pad + half);
            let y = py.min(plot.bottom - pad - tall).max(plot.top + pad + tall);
            if plate {
                let corner = |side: f64| (fine(x + side * (half + pad)), fine(y + side * (tall + 0.5 * pad)));
                self.root.draw(&Rectangle::new([corner(-1.0), corner(1.0)], filled(self.theme.paper(), 0.85)))?;
            }
            let style = self.style(size, FontStyle::Normal, rgb).pos(Pos::new(HPos::Center, VPos::Center));
            self.root.draw_text(&text, &style, (fine(x), fine(y)))?;
        }
        Ok(())
    }
}
