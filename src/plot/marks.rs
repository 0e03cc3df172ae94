//! The marks of layers, drawn through plotters' series and elements.

use super::Failure;
use super::canvas::{Canvas, With};
use super::chart::{Chart, Frame};
use super::elements::{Arrow, Curve, Tip, corners};
use super::look::{Look, Marker, Sizes, filled, stroke};
use super::palette::Theme;
use super::raster::Place;
use super::ruler::Ruler;
use super::scene::{FINE, Image};
use crate::figure::{Layer, Mark, Meaning};
use plotters::prelude::{Circle, EmptyElement, PathElement, Polygon, Rectangle};

/// Draws the layers of one panel.
pub(super) struct Painter<'a> {
    pub chart: &'a mut Chart<'static>,
    pub canvas: &'a Canvas,
    pub x: &'a Ruler,
    pub y: &'a Ruler,
    pub plot: Frame,
    pub clip: usize,
    pub theme: Theme,
    pub sizes: &'a Sizes,
}

impl Painter<'_> {
    /// Draws one layer, except notes, which stand above everything.
    pub(super) fn draw(&mut self, layer: &Layer) -> Result<(), Failure> {
        let look = Look::of(layer, self.theme, self.sizes);
        self.canvas.set(With { clip: Some(self.clip), dash: look.dash.clone(), halo: None });
        match &layer.mark {
            Mark::Line(points) => self.lines(points, &look),
            Mark::Dots(points) => self.dots(points, &look, self.radius(points)),
            Mark::Stems(points) => self.stems(points, &look),
            Mark::Arrows(weights) => self.arrows(weights, &look),
            Mark::Area(points) => self.area(points, layer.meaning, &look),
            Mark::Bars { width, points } => self.bars(*width, points, &look),
            Mark::Verticals(at) => {
                let ends = (self.y.low(), self.y.high());
                self.rules(at.iter().filter(|x| self.x.shows(**x)).map(|x| [(*x, ends.0), (*x, ends.1)]), &look)
            }
            Mark::Horizontals(at) => {
                let ends = (self.x.low(), self.x.high());
                self.rules(at.iter().filter(|y| self.y.shows(**y)).map(|y| [(ends.0, *y), (ends.1, *y)]), &look)
            }
            Mark::Spans(intervals) => self.spans(intervals, &look),
            Mark::Pointers(pointers) => self.pointers(pointers, &look),
            Mark::Notes(_) => Ok(()),
            Mark::Raster { x, y, values, low, high, tones } => {
                let place = |size| Place::of(*x, *y, size, (self.x, self.y), self.plot);
                let image = place(values.dim()).map(|place| place.toned(values, (*low, *high), *tones));
                self.images(image);
                Ok(())
            }
            Mark::Colors { x, y, light } => {
                let place = |size| Place::of(*x, *y, size, (self.x, self.y), self.plot);
                self.images(place(light[0].dim()).map(|place| place.colored(light)));
                Ok(())
            }
        }
    }

    /// An image, cut at the frame.
    fn images(&self, image: Option<Image>) {
        image.into_iter().for_each(|image| self.canvas.image(Image { clip: Some(self.clip), ..image }));
    }

    /// Whether both coordinates can be drawn; infinite ones would pull lines to wrong places.
    fn drawable(&self, [x, y]: [f64; 2]) -> bool {
        !self.x.part(x).is_nan() && !self.y.part(y).is_nan() && x.is_finite() && y.is_finite()
    }

    fn seen(&self, [x, y]: [f64; 2]) -> bool {
        self.x.shows(x) && self.y.shows(y)
    }

    fn lines(&mut self, points: &[[f64; 2]], look: &Look) -> Result<(), Failure> {
        let parts: Vec<&[[f64; 2]]> = points.split(|p| !self.drawable(*p)).collect();
        for part in parts {
            self.chart.draw_series([Curve::new(part.iter().map(|p| (p[0], p[1])), look.line())])?;
        }
        Ok(())
    }

    fn rules(&mut self, ends: impl Iterator<Item = [(f64, f64); 2]>, look: &Look) -> Result<(), Failure> {
        let line = look.line();
        let elements: Vec<_> = ends.map(|ends| PathElement::new(ends.to_vec(), line)).collect();
        self.chart.draw_series(elements)?;
        Ok(())
    }

    /// As large as leaves neighbours apart, within limits.
    fn radius(&self, points: &[[f64; 2]]) -> f64 {
        let seen: Vec<[f64; 2]> = points.iter().copied().filter(|p| self.seen(*p)).collect();
        let one = self.sizes.one;
        let each = (self.plot.width() * self.plot.height() / seen.len().max(1) as f64).sqrt();
        let largest = 2.1 * self.sizes.line;
        (0.3 * each).min(0.42 * self.spacing(&seen)).min(largest).max(2.2 * one)
    }

    /// The median distance of neighbours in the list, in units of the picture.
    fn spacing(&self, points: &[[f64; 2]]) -> f64 {
        let place = |p: [f64; 2]| (self.x.part(p[0]) * self.plot.width(), self.y.part(p[1]) * self.plot.height());
        let gap = |w: &[[f64; 2]]| {
            let (a, b) = (place(w[0]), place(w[1]));
            ((a.0 - b.0).powi(2) + (a.1 - b.1).powi(2)).sqrt()
        };
        let mut gaps: Vec<f64> = points.windows(2).map(gap).filter(|g| *g > 0.0).collect();
        gaps.sort_by(f64::total_cmp);
        gaps.get(gaps.len() / 2).copied().unwrap_or(f64::INFINITY)
    }

    /// The median horizontal distance of neighbours in the list.
    fn pitch(&self, points: &[[f64; 2]]) -> f64 {
        let flat: Vec<[f64; 2]> = points.iter().map(|p| [p[0], self.y.base()]).collect();
        self.spacing(&flat)
    }

    /// Dots with a thin ring of paper around each, which lifts them off the lines below. Dots are shown whole or not
    /// at all: one on the frame is not cut in half.
    fn dots(&mut self, points: &[[f64; 2]], look: &Look, radius: f64) -> Result<(), Failure> {
        self.canvas.set(With::default());
        let seen: Vec<(f64, f64)> = points.iter().filter(|p| self.seen(**p)).map(|p| (p[0], p[1])).collect();
        let ring = if seen.len() <= 400 { 1.6 * self.sizes.one } else { 0.0 };
        for (rgb, radius) in [(self.theme.paper(), radius + ring), (look.rgb, radius)] {
            if ring == 0.0 && rgb != look.rgb {
                continue;
            }
            let style = filled(rgb, 1.0);
            if look.marker == Marker::Circle {
                let r = (radius * FINE).round() as i32;
                self.chart.draw_series(seen.iter().map(|at| Circle::new(*at, r, style)))?;
            } else {
                let corners = corners(look.marker, radius);
                self.chart
                    .draw_series(seen.iter().map(|at| EmptyElement::at(*at) + Polygon::new(corners.clone(), style)))?;
            }
        }
        Ok(())
    }

    fn stems(&mut self, points: &[[f64; 2]], look: &Look) -> Result<(), Failure> {
        let base = self.y.base();
        let drawable: Vec<[f64; 2]> =
            points.iter().copied().filter(|p| self.drawable(*p) && self.x.shows(p[0])).collect();
        let pitch = self.pitch(&drawable);
        let line = stroke(look.rgb, (look.width * 0.8).min(0.5 * pitch).max(0.8 * self.sizes.one));
        let shafts: Vec<_> =
            drawable.iter().map(|p| PathElement::new(vec![(p[0], base), (p[0], p[1])], line)).collect();
        self.chart.draw_series(shafts)?;
        let radius = (0.42 * pitch).clamp(1.8 * self.sizes.one, 2.0 * self.sizes.line);
        self.dots(&drawable, look, radius)
    }

    fn arrows(&mut self, weights: &[[f64; 2]], look: &Look) -> Result<(), Failure> {
        let base = self.y.base();
        let drawable: Vec<[f64; 2]> =
            weights.iter().copied().filter(|p| self.drawable(*p) && self.x.shows(p[0])).collect();
        let pitch = self.pitch(&drawable);
        let head = (5.5 * look.width).min(pitch).max(5.0 * self.sizes.one);
        let shaft = look.width.min(0.35 * pitch).max(self.sizes.one);
        let tall = drawable.iter().filter(|p| p[1] != base);
        let ends: Vec<_> = tall.map(|p| [(p[0], base), (p[0], p[1])]).collect();
        self.chart.draw_series(Arrow::all(&ends, look, Tip { shaft, head }))?;
        // A weight of zero is a dot on the axis: it is there, and it is nothing.
        let none: Vec<[f64; 2]> = drawable.into_iter().filter(|p| p[1] == base).collect();
        self.dots(&none, look, 1.2 * look.width)
    }

    fn pointers(&mut self, pointers: &[[[f64; 2]; 2]], look: &Look) -> Result<(), Failure> {
        let drawable = pointers.iter().filter(|ends| ends.iter().all(|p| self.drawable(*p)));
        let ends: Vec<_> = drawable.map(|ends| ends.map(|p| (p[0], p[1]))).collect();
        let tip = Tip { shaft: 0.85 * look.width, head: 5.5 * look.width };
        self.chart.draw_series(Arrow::all(&ends, look, tip))?;
        Ok(())
    }

    fn area(&mut self, points: &[[f64; 3]], meaning: Meaning, look: &Look) -> Result<(), Failure> {
        let strong = meaning == Meaning::Leaked || meaning == Meaning::Error;
        let opacity = self.theme.wash(if strong { 0.42 } else { 0.26 });
        let log = self.y.log();
        for part in points.split(|p| !p.iter().all(|v| v.is_finite())) {
            // On a logarithmic scale an area from zero starts at the bottom.
            let lower = |y: f64| if log && y <= 0.0 { self.y.base() } else { y };
            let upper = part.iter().map(|p| (p[0], lower(p[2])));
            let outline = upper.chain(part.iter().rev().map(|p| (p[0], lower(p[1]))));
            if part.len() > 1 {
                self.chart.draw_series([Curve::new(outline, filled(look.rgb, opacity))])?;
            }
        }
        Ok(())
    }

    fn bars(&mut self, width: f64, points: &[[f64; 2]], look: &Look) -> Result<(), Failure> {
        let base = self.y.base();
        let style = filled(look.rgb, 0.8);
        let drawable = points.iter().filter(|p| self.drawable(**p));
        let bars: Vec<_> = drawable
            .map(|[x, y]| Rectangle::new([(x - width / 2.0, y.max(base)), (x + width / 2.0, y.min(base))], style))
            .collect();
        self.chart.draw_series(bars)?;
        Ok(())
    }

    fn spans(&mut self, intervals: &[[f64; 2]], look: &Look) -> Result<(), Failure> {
        let style = filled(look.rgb, self.theme.wash(0.15));
        let (low, high) = (self.y.low(), self.y.high());
        let sound = intervals.iter().filter(|i| i.iter().all(|v| !self.x.part(*v).is_nan()));
        let spans: Vec<_> = sound.map(|[a, b]| Rectangle::new([(*a, high), (*b, low)], style)).collect();
        self.chart.draw_series(spans)?;
        Ok(())
    }
}
