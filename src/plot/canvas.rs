//! What plotters draws on: a backend that records a [`Scene`].

use super::scene::{Contour, Image, Op, Paint, Pen, Place, Scene, Shape, Words};
use super::stroke::{clipped, clipped_area, simplified};
use super::typeset::{self, CAP, Face, LEADING};
use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind, FontStyle,
    FontTransform,
};
use std::cell::RefCell;
use std::convert::Infallible;
use std::rc::Rc;

type Drawn = Result<(), DrawingErrorKind<Infallible>>;

/// A handle on the scene being drawn; clones share it, so that what plotters' styles cannot say (dashes, halos,
/// clipping) can be set beside plotters.
#[derive(Clone)]
pub(super) struct Canvas(Rc<RefCell<State>>);

struct State {
    scene: Scene,
    with: With,
}

/// What plotters' styles cannot say.
#[derive(Debug, Clone, Default)]
pub(super) struct With {
    /// Which clip everything but text is cut to.
    pub clip: Option<usize>,
    /// Dashes of lines.
    pub dash: Vec<i32>,
    /// A halo behind text.
    pub halo: Option<(Paint, i32)>,
}

impl Canvas {
    pub(super) fn new(scene: Scene) -> Self {
        Self(Rc::new(RefCell::new(State { scene, with: With::default() })))
    }

    /// From now on, draws with this.
    pub(super) fn set(&self, with: With) {
        self.0.borrow_mut().with = with;
    }

    /// A new clipping rectangle.
    pub(super) fn clip(&self, corners: (Place, Place)) -> usize {
        let clips = &mut self.0.borrow_mut().scene.clips;
        clips.push(corners);
        clips.len() - 1
    }

    /// Draws an image, which plotters could only draw pixel by pixel.
    pub(super) fn image(&self, image: Image) {
        self.0.borrow_mut().scene.ops.push(Op::Image(image));
    }

    /// What has been drawn.
    pub(super) fn finish(&self) -> Scene {
        let scene = &mut self.0.borrow_mut().scene;
        let (ops, clips) = (std::mem::take(&mut scene.ops), std::mem::take(&mut scene.clips));
        Scene { ops, clips, ..scene.clone() }
    }

    fn push(&self, contours: Vec<Contour>, fill: Option<Paint>, pen: Option<Pen>) {
        if contours.is_empty() {
            return;
        }
        let state = &mut *self.0.borrow_mut();
        state.scene.push(Shape { contours, fill, pen, clip: state.with.clip });
    }

    fn pen<S: BackendStyle>(&self, style: &S) -> Pen {
        let dash = self.0.borrow().with.dash.clone();
        Pen { paint: paint(style.color()), width: style.stroke_width() as i32, round: dash.is_empty(), dash }
    }

    /// The clipping rectangle now in force, widened so that the ends of cut lines lie outside it.
    fn cut(&self, wider: i32) -> Option<(Place, Place)> {
        let state = self.0.borrow();
        state.with.clip.map(|clip| {
            let ((left, top), (right, bottom)) = state.scene.clips[clip];
            ((left - wider, top - wider), (right + wider, bottom + wider))
        })
    }
}

fn paint(color: BackendColor) -> Paint {
    let (r, g, b) = color.rgb;
    Paint { rgb: [r, g, b], percent: (color.alpha * 100.0).round() as u8 }
}

impl DrawingBackend for Canvas {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        let (width, height) = self.0.borrow().scene.size;
        (width * 100, height * 100)
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, (x, y): BackendCoord, color: BackendColor) -> Drawn {
        self.draw_rect((x, y), (x + 1, y + 1), &color, true)
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Drawn {
        self.draw_path([from, to], style)
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        (left, top): BackendCoord,
        (right, bottom): BackendCoord,
        style: &S,
        fill: bool,
    ) -> Drawn {
        let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
        if fill {
            return self.fill_polygon(corners, style);
        }
        let points = corners.to_vec();
        self.push(vec![Contour { points, closed: true }], None, Some(self.pen(style)));
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> Drawn {
        let pen = self.pen(style);
        let points: Vec<Place> = path.into_iter().collect();
        let parts = clipped(&points, self.cut(2 * pen.width)).into_iter();
        let contours = parts.filter(|p| p.len() > 1).map(|p| Contour { points: simplified(&p), closed: false });
        self.push(contours.collect(), None, Some(pen));
        Ok(())
    }

    /// A filled circle is a dot of a round pen; only such are drawn.
    fn draw_circle<S: BackendStyle>(&mut self, center: BackendCoord, radius: u32, style: &S, _fill: bool) -> Drawn {
        let pen = Pen { paint: paint(style.color()), width: 2 * radius as i32, dash: Vec::new(), round: true };
        self.push(vec![Contour { points: vec![center], closed: false }], None, Some(pen));
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, vert: I, style: &S) -> Drawn {
        let points: Vec<Place> = vert.into_iter().collect();
        let points = simplified(&clipped_area(&points, self.cut(100)));
        if points.len() > 2 {
            self.push(vec![Contour { points, closed: true }], Some(paint(style.color())), None);
        }
        Ok(())
    }

    /// One or several lines, `\n` between them. The anchor is that of the box from the top of the first line's capitals
    /// to the last line's baseline, so that numbers sit in the middle of their ticks.
    fn draw_text<T: BackendTextStyle>(&mut self, text: &str, style: &T, pos: BackendCoord) -> Drawn {
        let (size, face) = (style.size(), face(style));
        let upright = matches!(style.transform(), FontTransform::Rotate270);
        let state = &mut *self.0.borrow_mut();
        let leading = size * LEADING;
        let height = size * CAP + leading * (text.lines().count().max(1) - 1) as f64;
        let first = size * CAP
            - match style.anchor().v_pos {
                VPos::Top => 0.0,
                VPos::Center => height / 2.0,
                VPos::Bottom => height,
            };
        for (i, text) in text.lines().enumerate() {
            let line = typeset::line(text, face);
            let width = f64::from(line.width) * size / f64::from(typeset::EM);
            let along = match style.anchor().h_pos {
                HPos::Left => 0.0,
                HPos::Center => -width / 2.0,
                HPos::Right => -width,
            };
            let across = first + leading * i as f64;
            let (dx, dy) = if upright { (across, -along) } else { (along, across) };
            let at = (pos.0 + (dx + 0.137).round() as i32, pos.1 + (dy + 0.137).round() as i32);
            let (paint, halo) = (paint(style.color()), state.with.halo);
            state.scene.ops.push(Op::Words(Words { line, at, size: size.round() as i32, upright, paint, halo }));
        }
        Ok(())
    }

    fn estimate_text_size<T: BackendTextStyle>(
        &self,
        text: &str,
        style: &T,
    ) -> Result<(u32, u32), DrawingErrorKind<Infallible>> {
        let size = style.size();
        let width = typeset::width(text, face(style), size);
        Ok((width.ceil() as u32, typeset::height(text, size).ceil() as u32))
    }
}

fn face<T: BackendTextStyle>(style: &T) -> Face {
    match style.style() {
        FontStyle::Normal => Face::Regular,
        FontStyle::Bold => Face::Bold,
        FontStyle::Oblique | FontStyle::Italic => Face::Oblique,
    }
}
