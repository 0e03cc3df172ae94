//! The picture of a report on a picture.

use crate::axis::Edge;
use crate::error::Result;
use crate::figure::report::picture::Checked;
use crate::figure::report::picture::sections::{self, percent};
use crate::figure::report::picture::spectrum::{fall_panel, plane_panel};
use crate::figure::{Figure, Layer, Legend, Meaning, Panel, Portrait, Scale, Tones};
use crate::image::Image;
use crate::image::resize::{nearest, over, resize};
use crate::inspect::picture::found::shrunk;
use crate::inspect::picture::sampler::Moire;
use crate::inspect::picture::shrinking::{Shrinking, Way};
use crate::kernel::box_kernel::BoxKernel;
use crate::text;
use crate::text::{Text, number};

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
    let landing = |moire: &Moire| [moire.frequency[0] * 2.0 * u, moire.frequency[1] * 2.0 * v];
    let drawn = strongest(&plain.moires);
    let arrows = drawn.iter().map(|&i| [waves[i].frequency, landing(&plain.moires[i])]);
    let spectrum = spectrum
        .legend(Legend::Above)
        .with(Layer::line("box", Meaning::Guide, box_of).thick().label(text!("new limit", "новый предел")))
        .with(Layer::pointers("pointers", Meaning::Leaked, arrows).thick())
        .with(
            Layer::dots("gratings", Meaning::Leaked, waves.iter().map(|wave| wave.frequency))
                .label(text!("grating → moiré", "решётка → муар")),
        )
        .with(Layer::notes("moirés", Meaning::Leaked, labels(&plain.moires, &drawn, landing)));
    let corner = small.part(image, shrinking);
    let side = [small.plain.width(), small.plain.height()].map(|n| n.min(PART));
    let step = [w as f64 / small.plain.width() as f64, h as f64 / small.plain.height() as f64];
    let [x0, y0] = [0, 1].map(|i| corner[i] as f64 * step[i]);
    let [x1, y1] = [0, 1].map(|i| (corner[i] + side[i]) as f64 * step[i]);
    let frame = Layer::line("part", Meaning::Leaked, [[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]]).thick();
    let original = {
        let (left, top) = (x0.floor() as usize, y0.floor() as usize);
        let [nx, ny] = [(x1.ceil() as usize).min(w) - left, (y1.ceil() as usize).min(h) - top];
        enlarged(&image.part([left, top], [nx, ny])?, side)?
    };
    let filter = &checked.filter;
    let moire = |way: Option<&Way>| match way {
        Some(way) if way.worst().is_some() => text!(": moiré ", ": муар ").and(&percent(way.contrast())),
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
    let title = match sections::enlarged(shrinking) {
        true => {
            text!("{name} at {nw} × {nh}: enlarged, nothing aliases", "{name}, {nw} × {nh}: увеличено, без алиасинга")
        }
        false => text!("{name} at {nw} × {nh}: what would alias", "{name}, {nw} × {nh}: алиасинг"),
    };
    Ok(Portrait {
        title,
        caption: text!(
            "The picture of {w} × {h} pixels; its power spectrum with the Nyquist box of the new raster (grey), dots at \
             gratings beyond it, and pointers from the three strongest to where they land, with period in new pixels and \
             contrast of the moiré; a part of it as it is, at the new size without a filter, and with \
             {filter}, enlarged pixel by pixel. In linear light.",
            "Изображение {w} × {h} пикселей; его спектр мощности с прямоугольником Найквиста нового растра (серый), точками на месте \
             решёток за его пределами и стрелками от трёх сильнейших туда, где они окажутся, с периодом муара в новых \
             пикселях и его контрастом; фрагмент как есть, в новом размере без фильтра и с фильтром \
             {filter}, увеличенный попиксельно. В линейном свете."
        ),
        figure,
    })
}

/// How many moirés have a pointer.
const POINTERS: usize = 3;

/// The strongest moirés, without those that are none.
fn strongest(moires: &[Moire]) -> Vec<usize> {
    let mut all: Vec<usize> = (0..moires.len()).filter(|&i| !moires[i].even).collect();
    all.sort_by(|&a, &b| moires[b].contrast.total_cmp(&moires[a].contrast));
    all.truncate(POINTERS);
    all
}

/// Period and contrast beside the places where moirés land, one below the other where they would meet.
fn labels(moires: &[Moire], drawn: &[usize], landing: impl Fn(&Moire) -> [f64; 2]) -> Vec<([f64; 2], Text)> {
    const LINE: f64 = 0.15;
    let mut places: Vec<([f64; 2], Text)> = drawn
        .iter()
        .map(|&i| {
            let ([u, v], period) = (landing(&moires[i]), number(moires[i].period(), 2));
            // below the head, and inside the panel
            let place = [u.clamp(-0.25, 0.25), v.clamp(-0.4, 0.0) + LINE];
            (place, text!("{period} px · ", "{period} пкс · ").and(&percent(moires[i].contrast)))
        })
        .collect();
    places.sort_by(|a, b| a.0[1].total_cmp(&b.0[1]));
    for i in 1..places.len() {
        places[i].0[1] = places[i].0[1].max(places[i - 1].0[1] + LINE);
    }
    places
}

/// A part of the old picture in cells of the size of those of the new one's `side` pixels, or smaller by a whole factor:
/// panels of both are equally large.
fn enlarged(part: &Image, side: [usize; 2]) -> Result<Image> {
    let times = (9 * PART / side[0].max(side[1])).max(1);
    let [w, h] = side.map(|n| n * times);
    if w < part.width() || h < part.height() {
        return resize(part, w, h, &BoxKernel, Edge::Clamp);
    }
    Ok(nearest(part, over(part.grid(), w, h)?, Edge::Clamp))
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
