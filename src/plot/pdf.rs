//! A scene as a page of PDF.

use super::png::repeated;
use super::scene::{FINE, Image, Op, Paint, Pixels, Place, Scene, Shape, Words};
use super::typeset::{EM, Segment, outline};
use miniz_oxide::deflate::compress_to_vec_zlib;
use pdf_writer::types::{LineCapStyle, LineJoinStyle};
use pdf_writer::{Content, Filter, Finish, Name, Pdf, Rect, Ref, TextStr};
use std::collections::BTreeSet;

/// Points to a unit of the picture: 1600 × 900 becomes the 13⅓ × 7½ inches of a slide.
const POINT: f64 = 0.6;
/// How hard streams are compressed, of ten.
const LEVEL: u8 = 6;

impl Scene {
    /// The picture as one page of PDF, letters as outlines; 1600 × 900 units are 13⅓ × 7½ inches.
    pub fn pdf(&self) -> Vec<u8> {
        let ids: Vec<Ref> = (1..).map(Ref::new).take(6 + self.ops.len()).collect();
        let [catalog, pages, page, content, info] = [ids[0], ids[1], ids[2], ids[3], ids[4]];
        let images: Vec<(&Image, Ref)> = self
            .ops
            .iter()
            .filter_map(|op| if let Op::Image(image) = op { Some(image) } else { None })
            .zip(ids[5..].iter().copied())
            .collect();

        let mut pdf = Pdf::new();
        pdf.catalog(catalog).pages(pages).lang(TextStr(self.lang.code()));
        pdf.pages(pages).kids([page]).count(1);
        pdf.document_info(info).title(TextStr(&self.title)).subject(TextStr(&self.about));
        let (width, height) = (f64::from(self.size.0) * POINT, f64::from(self.size.1) * POINT);
        let mut leaf = pdf.page(page);
        leaf.parent(pages).media_box(Rect::new(0.0, 0.0, width as f32, height as f32)).contents(content);
        let mut resources = leaf.resources();
        let mut states = resources.ext_g_states();
        for percent in self.opacities() {
            let mut state =
                states.insert(Name(state(percent).as_bytes())).start::<pdf_writer::writers::ExtGraphicsState<'_>>();
            let part = f32::from(percent) / 100.0;
            state.non_stroking_alpha(part).stroking_alpha(part);
        }
        states.finish();
        if !images.is_empty() {
            let mut objects = resources.x_objects();
            for (i, (_, id)) in images.iter().enumerate() {
                objects.pair(Name(format!("I{i}").as_bytes()), *id);
            }
        }
        resources.finish();
        leaf.finish();

        let drawn = compress_to_vec_zlib(&self.content(height), LEVEL);
        pdf.stream(content, &drawn).filter(Filter::FlateDecode);
        for (image, id) in images {
            let ((width, height), bytes) = repeated(image, 1024);
            let bytes = compress_to_vec_zlib(&bytes, LEVEL);
            let mut object = pdf.image_xobject(id, &bytes);
            object.filter(Filter::FlateDecode);
            object.width(width as i32).height(height as i32);
            match &image.pixels {
                Pixels::Toned { table, .. } => {
                    object.color_space().indexed(Name(b"DeviceRGB"), 255, table.as_flattened());
                }
                Pixels::Colored(_) => object.color_space().device_rgb(),
            }
            object.bits_per_component(8).interpolate(false);
        }
        pdf.finish()
    }

    fn opacities(&self) -> BTreeSet<u8> {
        let paints = self.ops.iter().flat_map(|op| match op {
            Op::Shape(shape) => [shape.fill, shape.pen.as_ref().map(|p| p.paint)],
            Op::Words(words) => [Some(words.paint), words.halo.map(|h| h.0)],
            Op::Image(_) => [None, None],
        });
        paints.flatten().map(|p| p.percent).chain([100]).collect()
    }

    fn content(&self, height: f64) -> Vec<u8> {
        let mut brush = Brush { content: Content::new(), fill: None, stroke: None };
        let unit = (POINT / FINE) as f32;
        brush.content.transform([unit, 0.0, 0.0, -unit, 0.0, height as f32]);
        brush.content.set_line_join(LineJoinStyle::RoundJoin);
        let paper = Paint::solid(self.paper);
        brush.fill(paper);
        brush.content.rect(0.0, 0.0, self.size.0 as f32 * 100.0, self.size.1 as f32 * 100.0).fill_nonzero();
        let (mut clip, mut images) = (None, 0);
        for op in &self.ops {
            if op.clip() != clip {
                if clip.is_some() {
                    brush.restore();
                }
                clip = op.clip();
                if let Some(clip) = clip {
                    let ((left, top), (right, bottom)) = self.clips[clip];
                    brush.content.save_state();
                    brush.content.rect(left as f32, top as f32, (right - left) as f32, (bottom - top) as f32);
                    brush.content.clip_nonzero().end_path();
                }
            }
            match op {
                Op::Shape(shape) => brush.shape(shape),
                Op::Words(words) => brush.words(words),
                Op::Image(image) => {
                    brush.image(image, images);
                    images += 1;
                }
            }
        }
        if clip.is_some() {
            brush.restore();
        }
        brush.content.finish().into_vec()
    }
}

fn state(percent: u8) -> String {
    format!("A{percent}")
}

/// The content being written, and the colours in force.
struct Brush {
    content: Content,
    fill: Option<Paint>,
    stroke: Option<Paint>,
}

impl Brush {
    fn restore(&mut self) {
        self.content.restore_state();
        (self.fill, self.stroke) = (None, None);
    }

    /// Opacity is one state for fills and strokes: what is not painted now is set anew before it is.
    fn fill(&mut self, paint: Paint) {
        if self.fill != Some(paint) {
            if self.fill.is_none_or(|f| f.percent != paint.percent) {
                self.content.set_parameters(Name(state(paint.percent).as_bytes()));
                self.stroke = None;
            }
            self.content.set_fill_rgb(part(paint.rgb[0]), part(paint.rgb[1]), part(paint.rgb[2]));
            self.fill = Some(paint);
        }
    }

    fn stroke(&mut self, paint: Paint) {
        if self.stroke != Some(paint) {
            if self.stroke.is_none_or(|s| s.percent != paint.percent) {
                self.content.set_parameters(Name(state(paint.percent).as_bytes()));
                self.fill = None;
            }
            self.content.set_stroke_rgb(part(paint.rgb[0]), part(paint.rgb[1]), part(paint.rgb[2]));
            self.stroke = Some(paint);
        }
    }

    fn trace(&mut self, shape: &Shape) {
        for contour in &shape.contours {
            let Some((first, rest)) = contour.points.split_first() else { continue };
            self.content.move_to(first.0 as f32, first.1 as f32);
            for point in rest {
                self.content.line_to(point.0 as f32, point.1 as f32);
            }
            if contour.closed {
                self.content.close_path();
            } else if rest.is_empty() {
                self.content.line_to((first.0 + 1) as f32, first.1 as f32);
            }
        }
    }

    fn shape(&mut self, shape: &Shape) {
        if let Some(fill) = shape.fill {
            self.fill(fill);
            self.trace(shape);
            self.content.fill_nonzero();
        }
        if let Some(pen) = &shape.pen {
            self.stroke(pen.paint);
            let cap = if pen.round { LineCapStyle::RoundCap } else { LineCapStyle::ButtCap };
            self.content.set_line_cap(cap).set_line_width(pen.width as f32);
            self.content.set_dash_pattern(pen.dash.iter().map(|d| *d as f32), 0.0);
            self.trace(shape);
            self.content.stroke();
        }
    }

    fn words(&mut self, words: &Words) {
        if let Some((halo, reach)) = words.halo {
            self.stroke(halo);
            // In the letters' own units, into which the transform below leads.
            let em = words.size as f32 / EM as f32;
            self.content.set_line_cap(LineCapStyle::RoundCap).set_dash_pattern([], 0.0);
            self.letters(
                words,
                |content, size| {
                    content.set_line_width(rounded(2.0 * reach as f32 / (em * size)));
                },
                |content| {
                    content.stroke();
                },
            );
        }
        self.fill(words.paint);
        self.letters(
            words,
            |_, _| {},
            |content| {
                content.fill_nonzero();
            },
        );
    }

    fn letters(&mut self, words: &Words, before: impl Fn(&mut Content, f32), paint: impl Fn(&mut Content)) {
        let em = f64::from(words.size) / f64::from(EM);
        for glyph in &words.line.glyphs {
            let segments = outline(glyph.face, glyph.id);
            if segments.is_empty() {
                continue;
            }
            let size = f64::from(glyph.size) / 1000.0;
            let (x, y) = (f64::from(glyph.x) * em, f64::from(glyph.y) * em);
            let (x, y) = if words.upright { (-y, -x) } else { (x, -y) };
            let at = (f64::from(words.at.0) + x, f64::from(words.at.1) + y);
            let s = rounded((em * size) as f32);
            let turn = if words.upright { [0.0, -s, -s, 0.0] } else { [s, 0.0, 0.0, -s] };
            self.content.save_state();
            let (x, y) = (at.0.round() as f32, at.1.round() as f32);
            self.content.transform([turn[0], turn[1], turn[2], turn[3], x, y]);
            before(&mut self.content, size as f32);
            let mut here = (0, 0);
            for segment in segments {
                here = self.segment(segment, here);
            }
            paint(&mut self.content);
            self.content.restore_state();
        }
    }

    /// PDF has no quadratic curves: each becomes the cubic that is the same curve.
    fn segment(&mut self, segment: Segment, from: Place) -> Place {
        match segment {
            Segment::Move(x, y) => {
                self.content.move_to(x as f32, y as f32);
                (x, y)
            }
            Segment::Line(x, y) => {
                self.content.line_to(x as f32, y as f32);
                (x, y)
            }
            Segment::Curve(x1, y1, x, y) => {
                let third = |end: i32, middle: i32| (f64::from(end + 2 * middle) / 3.0).round() as f32;
                let (ax, ay, bx, by) = (third(from.0, x1), third(from.1, y1), third(x, x1), third(y, y1));
                self.content.cubic_to(ax, ay, bx, by, x as f32, y as f32);
                (x, y)
            }
            Segment::Close => {
                self.content.close_path();
                from
            }
        }
    }

    fn image(&mut self, image: &Image, number: usize) {
        let ((left, top), (right, bottom)) = image.corners;
        self.fill(Paint { rgb: [0; 3], percent: 100 });
        self.content.save_state();
        let (width, height) = ((right - left) as f32, (bottom - top) as f32);
        self.content.transform([width, 0.0, 0.0, -height, left as f32, bottom as f32]);
        self.content.x_object(Name(format!("I{number}").as_bytes()));
        self.content.restore_state();
    }
}

/// A channel from 0 to 1, to three digits.
fn part(channel: u8) -> f32 {
    (f32::from(channel) / 255.0 * 1000.0).round() / 1000.0
}

fn rounded(v: f32) -> f32 {
    (v * 10_000.0).round() / 10_000.0
}
