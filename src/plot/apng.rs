//! Scenes one after another, as one animated PNG.

use super::scene::Scene;

/// The scenes as an animated PNG that begins again for ever, `rate` of them in a second; all must be of one size. A
/// viewer that knows nothing of animations shows the first.
///
/// Of every scene but the first only the rectangle that has changed is kept.
///
/// ```
/// use nyquist::figure::{Figure, Layer, Meaning, Panel, Scale};
/// use nyquist::plot::{Style, animated, draw};
/// use nyquist::text::Text;
/// let scale = || Scale::linear(Text::EMPTY, 0.0, 4.0);
/// let frame = |x: f64| {
///     let panel = Panel::new("dot", Text::EMPTY, scale(), scale()).with(Layer::dots("dot", Meaning::Signal, [[x, 1.0]]));
///     draw(&Text::EMPTY, &Text::EMPTY, &Figure::new(1).with(panel), &Style::default())
/// };
/// let (one, three) = (animated(&[frame(1.0)], 10), animated(&[frame(1.0), frame(2.0), frame(3.0)], 10));
/// assert!(three.len() < 2 * one.len()); // the frame around the dot is kept once
/// ```
pub fn animated(scenes: &[Scene], rate: u16) -> Vec<u8> {
    let mut out = Vec::new();
    let Some(first) = scenes.first() else { return out };
    let (size, mut shown) = first.pixels();
    let mut encoder = png::Encoder::new(&mut out, size.0, size.1);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Balanced);
    encoder.set_filter(png::Filter::NoFilter); // drawings are even: filters make more of them
    let written = encoder
        .set_animated(scenes.len() as u32, 0)
        .and_then(|()| encoder.set_frame_delay(1, rate))
        .and_then(|()| encoder.write_header())
        .and_then(|mut writer| {
            writer.write_image_data(&shown)?;
            for scene in &scenes[1..] {
                let (_, next) = scene.pixels();
                let changed = Changed::between(&shown, &next, size.0 as usize);
                writer.reset_frame_position()?;
                writer.set_frame_dimension(changed.width as u32, changed.height as u32)?;
                writer.set_frame_position(changed.left as u32, changed.top as u32)?;
                writer.write_image_data(&changed.of(&next, size.0 as usize))?;
                shown = next;
            }
            writer.finish()
        });
    written.expect("writing into memory cannot fail, and every rectangle lies within the picture");
    out
}

/// A rectangle of pixels.
struct Changed {
    left: usize,
    top: usize,
    width: usize,
    height: usize,
}

impl Changed {
    /// The least one outside of which two pictures are the same; one pixel if they are the same everywhere.
    fn between(a: &[u8], b: &[u8], width: usize) -> Self {
        let differs = a.chunks_exact(3).zip(b.chunks_exact(3)).enumerate().filter(|(_, (a, b))| a != b);
        let (mut low, mut high) = ([usize::MAX; 2], [0; 2]);
        for (i, _) in differs {
            for (axis, v) in [i % width, i / width].into_iter().enumerate() {
                (low[axis], high[axis]) = (low[axis].min(v), high[axis].max(v));
            }
        }
        if low[0] > high[0] {
            return Self { left: 0, top: 0, width: 1, height: 1 };
        }
        Self { left: low[0], top: low[1], width: high[0] - low[0] + 1, height: high[1] - low[1] + 1 }
    }

    /// Its part of a picture.
    fn of(&self, picture: &[u8], width: usize) -> Vec<u8> {
        let rows = picture.chunks_exact(3 * width).skip(self.top).take(self.height);
        rows.flat_map(|row| &row[3 * self.left..3 * (self.left + self.width)]).copied().collect()
    }
}
