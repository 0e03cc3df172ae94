//! A scene as pixels.

use super::palette::{Rgb, srgb};
use super::scene::{FINE, Image, Op, Paint, Pixels, Place, Scene, Shape, Words};
use super::typeset::{EM, Segment, outline};
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Mask, PathBuilder, Pixmap, PremultipliedColorU8, Stroke, StrokeDash, Transform,
};

impl Scene {
    /// The picture as a PNG of `scale` pixels to the unit, without transparency.
    pub fn png(&self) -> Vec<u8> {
        let (size, rgb) = self.pixels();
        // a slide is large and mostly even: the fast compressor takes a third of the time for a few more bytes
        encoded(size, png::ColorType::Rgb, None, png::Filter::Adaptive, png::Compression::Fast, &rgb)
    }

    /// The picture as pixels: width and height, and red, green, blue row by row.
    pub(super) fn pixels(&self) -> ((u32, u32), Vec<u8>) {
        let pixels = |units: u32| ((f64::from(units) * self.scale).round() as u32).max(1);
        let (width, height) = (pixels(self.size.0), pixels(self.size.1));
        let mut easel = Easel {
            pixmap: Pixmap::new(width, height).expect("the size of a picture is limited"),
            transform: Transform::from_scale((self.scale / FINE) as f32, (self.scale / FINE) as f32),
            scale: self.scale / FINE,
            mask: None,
        };
        let [r, g, b] = self.paper.0;
        easel.pixmap.fill(Color::from_rgba8(r, g, b, 255));
        let mut clip = None;
        for op in &self.ops {
            if op.clip() != clip {
                clip = op.clip();
                easel.mask = clip.map(|clip| easel.masked(self.clips[clip]));
            }
            match op {
                Op::Shape(shape) => easel.shape(shape),
                Op::Words(words) => easel.words(words),
                Op::Image(image) => easel.image(image),
            }
        }
        ((width, height), easel.pixmap.data().chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]).collect())
    }
}

struct Easel {
    pixmap: Pixmap,
    transform: Transform,
    /// Pixels to a hundredth of a unit.
    scale: f64,
    mask: Option<Mask>,
}

impl Easel {
    fn masked(&self, ((left, top), (right, bottom)): (Place, Place)) -> Mask {
        let mut mask = Mask::new(self.pixmap.width(), self.pixmap.height()).expect("a mask is as large as its picture");
        let corners = [left, top, right, bottom].map(|v| v as f32);
        if let Some(rect) = tiny_skia::Rect::from_ltrb(corners[0], corners[1], corners[2], corners[3]) {
            mask.fill_path(&PathBuilder::from_rect(rect), FillRule::Winding, true, self.transform);
        }
        mask
    }

    fn shape(&mut self, shape: &Shape) {
        let mut path = PathBuilder::new();
        for contour in &shape.contours {
            let Some((first, rest)) = contour.points.split_first() else { continue };
            path.move_to(first.0 as f32, first.1 as f32);
            for point in rest {
                path.line_to(point.0 as f32, point.1 as f32);
            }
            if contour.closed {
                path.close();
            } else if rest.is_empty() {
                path.line_to((first.0 + 1) as f32, first.1 as f32);
            }
        }
        let Some(path) = path.finish() else { return };
        if let Some(fill) = shape.fill {
            self.pixmap.fill_path(&path, &paint(fill), FillRule::Winding, self.transform, self.mask.as_ref());
        }
        if let Some(pen) = &shape.pen {
            let stroke = Stroke {
                width: pen.width as f32,
                line_cap: if pen.round { LineCap::Round } else { LineCap::Butt },
                line_join: LineJoin::Round,
                dash: StrokeDash::new(pen.dash.iter().map(|d| *d as f32).collect(), 0.0),
                ..Stroke::default()
            };
            self.pixmap.stroke_path(&path, &paint(pen.paint), &stroke, self.transform, self.mask.as_ref());
        }
    }

    fn words(&mut self, words: &Words) {
        let mut path = PathBuilder::new();
        let em = words.size as f32 / EM as f32;
        for glyph in &words.line.glyphs {
            let size = glyph.size as f32 / 1000.0;
            let at = |x: i32, y: i32| {
                let (x, y) = ((glyph.x as f32 + size * x as f32) * em, (glyph.y as f32 + size * y as f32) * em);
                let (x, y) = if words.upright { (-y, -x) } else { (x, -y) };
                (words.at.0 as f32 + x, words.at.1 as f32 + y)
            };
            for segment in outline(glyph.face, glyph.id) {
                match segment {
                    Segment::Move(x, y) => {
                        let (x, y) = at(x, y);
                        path.move_to(x, y);
                    }
                    Segment::Line(x, y) => {
                        let (x, y) = at(x, y);
                        path.line_to(x, y);
                    }
                    Segment::Curve(x1, y1, x, y) => {
                        let ((x1, y1), (x, y)) = (at(x1, y1), at(x, y));
                        path.quad_to(x1, y1, x, y);
                    }
                    Segment::Close => path.close(),
                }
            }
        }
        let Some(path) = path.finish() else { return };
        if let Some((halo, reach)) = words.halo {
            let width = 2.0 * reach as f32;
            let stroke = Stroke { width, line_join: LineJoin::Round, line_cap: LineCap::Round, ..Stroke::default() };
            self.pixmap.stroke_path(&path, &paint(halo), &stroke, self.transform, None);
        }
        self.pixmap.fill_path(&path, &paint(words.paint), FillRule::Winding, self.transform, None);
    }

    /// Cells of at least a pixel stay sharp: a pixel takes the cell under its middle. Smaller ones are averaged, in
    /// linear light.
    fn image(&mut self, image: &Image) {
        let ((left, top), (right, bottom)) = image.corners;
        let (columns, rows) = image.cells;
        let across = Span::new(left, right, columns, self.scale, self.pixmap.width());
        let down = Span::new(top, bottom, rows, self.scale, self.pixmap.height());
        let stride = self.pixmap.width() as usize;
        let (colors, of) = image.pixels.colors();
        let light: Vec<[f64; 3]> = colors.iter().map(|rgb| Rgb(*rgb).linear()).collect();
        let pixels = self.pixmap.pixels_mut();
        for (py, cells_y) in &down.pixels {
            for (px, cells_x) in &across.pixels {
                let rgb = if let ([(x, _)], [(y, _)]) = (&cells_x[..], &cells_y[..]) {
                    colors[of(y * columns + x)]
                } else {
                    let mut sum = [0.0; 3];
                    for (y, wy) in cells_y {
                        for (x, wx) in cells_x {
                            let cell = light[of(y * columns + x)];
                            sum = std::array::from_fn(|c| sum[c] + wx * wy * cell[c]);
                        }
                    }
                    sum.map(srgb)
                };
                let opaque = PremultipliedColorU8::from_rgba(rgb[0], rgb[1], rgb[2], 255);
                pixels[py * stride + px] = opaque.expect("an opaque colour is always premultiplied");
            }
        }
    }
}

/// Which cells, with weights that sum to one, each pixel of a row or column shows.
struct Span {
    pixels: Vec<(usize, Vec<(usize, f64)>)>,
}

impl Span {
    fn new(from: i32, to: i32, cells: usize, scale: f64, limit: u32) -> Self {
        let (from, to) = (f64::from(from) * scale, f64::from(to) * scale);
        let per = cells as f64 / (to - from).max(1e-9);
        let first = (from + 0.5 - 1e-6).floor().max(0.0) as usize;
        let last = ((to + 0.5 - 1e-6).floor().max(0.0) as usize).min(limit as usize);
        let cell = |at: f64| ((at - from) * per).clamp(0.0, cells as f64);
        let shown = |p: usize| {
            if per <= 1.0 + 1e-9 {
                return vec![((cell(p as f64 + 0.5) as usize).min(cells.saturating_sub(1)), 1.0)];
            }
            let (a, b) = (cell(p as f64), cell(p as f64 + 1.0));
            let part = |i: usize| (b.min(i as f64 + 1.0) - a.max(i as f64)).max(0.0) / (b - a);
            let all = (a as usize..(b.ceil() as usize).min(cells)).map(|i| (i, part(i)));
            all.filter(|(_, w)| *w > 0.0).collect()
        };
        let pixels = if cells == 0 { Vec::new() } else { (first..last).map(|p| (p, shown(p))).collect() };
        Self { pixels }
    }
}

fn paint(paint: Paint) -> tiny_skia::Paint<'static> {
    let [r, g, b] = paint.rgb;
    let mut skia = tiny_skia::Paint { anti_alias: true, ..tiny_skia::Paint::default() };
    skia.set_color_rgba8(r, g, b, (u16::from(paint.percent) * 255 / 100) as u8);
    skia
}

/// The bytes of an image with every cell repeated so that it is at least `least` pixels wide and high: a viewer that
/// smooths what it enlarges then has nothing to smooth.
pub(super) fn repeated(image: &Image, least: usize) -> ((u32, u32), Vec<u8>) {
    let (columns, rows) = image.cells;
    let factor = |n: usize| least.div_ceil(n.max(1)).clamp(1, 64);
    let times = factor(columns).min(factor(rows));
    let mut out = Vec::new();
    let (bytes, each) = image.pixels.bytes();
    for row in bytes.chunks_exact((columns * each).max(1)) {
        let line: Vec<u8> = row.chunks_exact(each).flat_map(|cell| cell.repeat(times)).collect();
        for _ in 0..times {
            out.extend_from_slice(&line);
        }
    }
    (((columns * times) as u32, (rows * times) as u32), out)
}

/// An image with its cells repeated, as a PNG of its own.
pub(super) fn enlarged(image: &Image, least: usize) -> Vec<u8> {
    let (size, bytes) = repeated(image, least);
    let (color, table) = match &image.pixels {
        Pixels::Colored(_) => (png::ColorType::Rgb, None),
        Pixels::Toned { table, .. } if table.iter().enumerate().all(|(i, rgb)| *rgb == [i as u8; 3]) => {
            (png::ColorType::Grayscale, None)
        }
        Pixels::Toned { table, .. } => (png::ColorType::Indexed, Some(table.as_flattened().to_vec())),
    };
    let as_is = |filter| encoded(size, color, table.clone(), filter, png::Compression::Balanced, &bytes);
    // Which filter serves depends on the picture: flat cells compress best without, smooth ones with.
    let (plain, filtered) = (as_is(png::Filter::NoFilter), as_is(png::Filter::Adaptive));
    if plain.len() <= filtered.len() { plain } else { filtered }
}

fn encoded(
    (width, height): (u32, u32),
    colour: png::ColorType,
    palette: Option<Vec<u8>>,
    filter: png::Filter,
    compression: png::Compression,
    data: &[u8],
) -> Vec<u8> {
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, width.max(1), height.max(1));
    encoder.set_color(colour);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(compression);
    if let Some(palette) = palette {
        encoder.set_palette(palette);
    }
    encoder.set_filter(filter);
    let written = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(data)?;
        writer.finish()
    });
    written.expect("writing into memory cannot fail, and the data are as large as the size says");
    out
}
