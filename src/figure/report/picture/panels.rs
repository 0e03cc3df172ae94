//! The picture of a report on a picture.

use crate::axis::Edge;
use crate::error::Result;
use crate::figure::report::picture::Checked;
use crate::figure::report::picture::sections::percent;
use crate::figure::report::picture::spectrum::{fall_panel, plane_panel};
use crate::figure::{Figure, Layer, Meaning, Panel, Portrait, Scale, Tones};
use crate::image::Image;
use crate::image::resize::resize;
use crate::inspect::picture::found::shrunk;
use crate::inspect::picture::shrinking::{Shrinking, Way};
use crate::kernel::box_kernel::BoxKernel;
use crate::text;
use crate::text::Text;

/// How many pixels of a picture are drawn along its longer side: as many units as there is room.
const DRAWN: usize = 288;
/// How many new pixels the enlarged part has along a side: eight units each.
const PART: usize = 36;

/// The picture at its new size, in two ways.
pub(super) struct Small {
    plain: Image,
    filtered: Image,
}

impl Small {
    pub(super) fn of(image: &Image, shrinking: &Shrinking, filter: &str) -> Result<Self> {
        let way = |name: &str| shrunk(image, shrinking.size, name, Edge::Mirror);
        Ok(Self { plain: way("none")?, filtered: way(filter)? })
    }

    /// The corner of the part that is worth looking at: around the strongest moiré, or where both ways differ most.
    fn part(&self, image: &Image, shrinking: &Shrinking) -> [usize; 2] {
        let whole = [self.plain.width(), self.plain.height()];
        let side = whole.map(|n| n.min(PART));
        let middle = match shrinking.ways[0].worst() {
            Some((i, _)) => {
                let middle = shrinking.waves.strongest[i].middle();
                [
                    middle[0] * whole[0] as f64 / image.width() as f64,
                    middle[1] * whole[1] as f64 / image.height() as f64,
                ]
            }
            None => self.most_different(side),
        };
        [0, 1].map(|i| ((middle[i] - 0.5 * side[i] as f64).max(0.0) as usize).min(whole[i] - side[i]))
    }

    /// The middle of the part of that size in which the sum of squared differences is largest, to half its size.
    fn most_different(&self, side: [usize; 2]) -> [f64; 2] {
        let step = side.map(|n| (n / 2).max(1));
        let differences = |left: usize, top: usize| -> f64 {
            let places = (top..top + side[1]).flat_map(|y| (left..left + side[0]).map(move |x| (x, y)));
            places.map(|(x, y)| (self.plain.at(x, y) - self.filtered.at(x, y)).powi(2)).sum()
        };
        let mut best = ([0, 0], -1.0);
        for top in (0..=self.plain.height() - side[1]).step_by(step[1]) {
            for left in (0..=self.plain.width() - side[0]).step_by(step[0]) {
                let here = differences(left, top);
                if here > best.1 {
                    best = ([left, top], here);
                }
            }
        }
        [0, 1].map(|i| best.0[i] as f64 + 0.5 * side[i] as f64)
    }
}

pub(super) fn portrait(name: &str, image: &Image, checked: &Checked, small: Option<&Small>) -> Result<Portrait> {
    let (w, h) = (image.width(), image.height());
    let whole = whole_panel(image)?;
    let spectrum = plane_panel(&checked.spectrum, DRAWN);
    let falls = fall_panel(&checked.spectrum);
    let (Some(shrinking), Some(small)) = (&checked.shrinking, small) else {
        return Ok(Portrait {
            title: text!("{name}: what is in it", "{name}: что в нём есть"),
            caption: text!(
                "The picture of {w} × {h} pixels, its power spectrum over the plane of frequencies and along its directions, \
                 in linear light.",
                "Изображение {w} × {h} пикселей, его спектр мощности на плоскости частот и вдоль направлений, в линейном свете."
            ),
            figure: Figure::new(3).with(whole).with(spectrum).with(falls),
        });
    };
    let [u, v] = shrinking.limit;
    let box_of = [[-u, -v], [u, -v], [u, v], [-u, v], [-u, -v]];
    let plain = &shrinking.ways[0];
    let waves = &shrinking.waves.strongest;
    let arrows = waves
        .iter()
        .zip(&plain.moires)
        .map(|(wave, moire)| [wave.frequency, [moire.frequency[0] * 2.0 * u, moire.frequency[1] * 2.0 * v]]);
    let spectrum = spectrum
        .with(Layer::line("box", Meaning::Guide, box_of).thick())
        .with(Layer::pointers("pointers", Meaning::Leaked, arrows).thick())
        .with(Layer::dots("gratings", Meaning::Leaked, waves.iter().map(|wave| wave.frequency)));
    let corner = small.part(image, shrinking);
    let side = [small.plain.width(), small.plain.height()].map(|n| n.min(PART));
    let step = [w as f64 / small.plain.width() as f64, h as f64 / small.plain.height() as f64];
    let [x0, y0] = [0, 1].map(|i| corner[i] as f64 * step[i]);
    let [x1, y1] = [0, 1].map(|i| (corner[i] + side[i]) as f64 * step[i]);
    let frame = Layer::line("part", Meaning::Leaked, [[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]]).thick();
    let original = {
        let (left, top) = (x0.floor() as usize, y0.floor() as usize);
        let [nx, ny] = [(x1.ceil() as usize).min(w) - left, (y1.ceil() as usize).min(h) - top];
        image.part([left, top], [nx, ny])?
    };
    let filter = &checked.filter;
    let moire = |way: Option<&Way>| match way {
        Some(way) if !way.moires.is_empty() => text!(": moiré ", ": муар ").and(&percent(way.contrast())),
        _ => Text::EMPTY,
    };
    let (before, after) = (moire(shrinking.way("none")), moire(shrinking.way(filter)));
    let tones = tones(&original);
    let part = |name, title, image: &Image| raster_panel(name, title, image, tones);
    let [nw, nh] = shrinking.size;
    let figure = Figure::new(3)
        .with(whole.with(frame))
        .with(spectrum)
        .with(
            falls
                .with(Layer::verticals("limit", Meaning::Leaked, [u.min(v)]).label(text!("new limit", "новый предел"))),
        )
        .with(part("original", text!("this part", "этот фрагмент"), &original))
        .with(part("plain", text!("no filter", "без фильтра").and(&before), &small.plain.part(corner, side)?))
        .with(part("filtered", Text::literal(filter).and(&after), &small.filtered.part(corner, side)?));
    Ok(Portrait {
        title: text!("{name} at {nw} × {nh}: what would alias", "{name}, {nw} × {nh}: алиасинг"),
        caption: text!(
            "The picture of {w} × {h} pixels; its power spectrum with the Nyquist box of the new raster and pointers from \
             gratings beyond it to where they land; a part of it as it is, at the new size without a filter, and with \
             {filter}, enlarged pixel by pixel. In linear light.",
            "Изображение {w} × {h} пикселей; его спектр мощности с прямоугольником Найквиста нового растра и стрелками от \
             решёток за его пределами туда, где они окажутся; фрагмент как есть, в новом размере без фильтра и с фильтром \
             {filter}, увеличенный попиксельно. В линейном свете."
        ),
        figure,
    })
}

/// The picture, not finer than it is worth drawing.
fn whole_panel(image: &Image) -> Result<Panel> {
    let (w, h) = (image.width(), image.height());
    let longer = w.max(h);
    let drawn = match longer > DRAWN {
        true => {
            let part = |n: usize| (n * DRAWN / longer).max(1);
            resize(image, part(w), part(h), &BoxKernel, Edge::Clamp)?
        }
        false => image.clone(),
    };
    let (w, h) = (w as f64, h as f64);
    let (x, y) = (Scale::linear(Text::EMPTY, 0.0, w).bare(), Scale::linear(Text::EMPTY, h, 0.0).bare());
    let pixels = Layer::raster("pixels", (0.0, w), (0.0, h), drawn.pixels().clone(), (0.0, 1.0), Tones::Grey);
    let title = text!("{w} × {h} pixels", "{w} × {h} пикселей");
    Ok(Panel::new("picture", title, x, y).square().with(pixels))
}

/// From the darkest to the lightest pixel, so that a faint pattern is seen.
fn tones(image: &Image) -> (f64, f64) {
    let (low, high) = image.values().iter().fold((1.0f64, 0.0f64), |(l, h), &v| (l.min(v), h.max(v)));
    let room = (0.25 - (high - low)).max(0.0) / 2.0;
    ((low - room).max(0.0), (high + room).min(1.0))
}

fn raster_panel(name: &'static str, title: Text, image: &Image, tones: (f64, f64)) -> Panel {
    let (w, h) = (image.width() as f64, image.height() as f64);
    let (x, y) = (Scale::linear(Text::EMPTY, 0.0, w).bare(), Scale::linear(Text::EMPTY, h, 0.0).bare());
    let pixels = Layer::raster("pixels", (0.0, w), (0.0, h), image.pixels().clone(), tones, Tones::Grey);
    Panel::new(name, title, x, y).square().with(pixels)
}
