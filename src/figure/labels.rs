//! Names beside dots.

use crate::figure::{Layer, Meaning, Panel, Scale};
use crate::text::{Lang, Text};

/// Names beside dots, each on the side where it covers the fewest other names and dots: `row` letters are as wide as the
/// panel. The first dot is placed first; a dot without a name only takes its room.
///
/// ```
/// use nyquist::figure::common::values;
/// use nyquist::figure::labels::labels;
/// use nyquist::figure::{Mark, Panel};
/// use nyquist::text::Text;
/// let panel = Panel::new("plane", Text::EMPTY, values("x", 0.0, 1.0), values("y", 0.0, 1.0));
/// // one dot above the other: the lower one's name goes elsewhere
/// let names = labels("names", &panel, 40.0, &[[0.5, 0.56], [0.5, 0.5]], &[Text::same("upper"), Text::same("lower")]);
/// let Mark::Notes(notes) = names.mark else { panic!() };
/// assert!(notes[0].0[1] > 0.56 && notes[1].0 != [0.5, 0.56]);
/// ```
pub fn labels(name: &'static str, panel: &Panel, row: f64, dots: &[[f64; 2]], names: &[Text]) -> Layer {
    // places as parts of the panel, 0 to 1
    let (x, y) = (Ruler::of(&panel.x), Ruler::of(&panel.y));
    let part = |p: &[f64; 2]| [x.part(p[0]), y.part(p[1])];
    let height = 2.4 / row; // of a line; panels are about as high as wide
    let mut taken: Vec<[f64; 4]> = Vec::new();
    let mut notes = Vec::new();
    for (dot, text) in dots.iter().zip(names).filter(|(_, text)| !text.is_empty()) {
        let letters = Lang::ALL.map(|lang| text.get(lang).chars().count()).into_iter().max();
        let width = letters.unwrap_or(0) as f64 / row;
        let at = part(dot);
        let aside = 0.5 * width + 0.8 / row;
        let sides = [[0.0, height], [aside, 0.0], [-aside, 0.0], [0.0, -height]];
        let corners = [[aside, height], [-aside, height], [aside, -height], [-aside, -height]];
        let far = [[0.0, 2.0 * height], [0.0, -2.0 * height]]; // behind another name
        let (half, tall) = (0.5 * width, 0.5 * height);
        // kept inside the panel, as it will be drawn
        let middle = |side: [f64; 2]| {
            let inside = |v: f64, margin: f64| v.max(margin + 0.3 / row).min(1.0 - margin - 0.3 / row);
            [inside(at[0] + side[0], half), inside(at[1] + side[1], tall)]
        };
        let cost = |side: [f64; 2]| {
            let [cx, cy] = middle(side);
            let meets = |b: &&[f64; 4]| (b[0] - cx).abs() < b[2] + half && (b[1] - cy).abs() < b[3] + tall;
            let hides = |d: &&[f64; 2]| {
                let [dx, dy] = part(d);
                **d != *dot && (dx - cx).abs() < half + 1.5 / row && (dy - cy).abs() < tall + 0.6 / row
            };
            3 * taken.iter().filter(meets).count() + dots.iter().filter(hides).count()
        };
        let best = sides.into_iter().chain(corners).chain(far).min_by_key(|side| cost(*side)).unwrap_or_default();
        let [cx, cy] = middle(best);
        taken.push([cx, cy, half, tall]);
        notes.push(([x.at(cx), y.at(cy)], text.clone()));
    }
    Layer::notes(name, Meaning::Guide, notes)
}

/// A scale read both ways.
struct Ruler {
    low: f64,
    high: f64,
    log: bool,
}

impl Ruler {
    fn of(scale: &Scale) -> Self {
        let (low, high) = scale.range;
        if scale.log { Self { low: low.ln(), high: high.ln(), log: true } } else { Self { low, high, log: false } }
    }

    /// How far along the scale a value stands, 0 to 1.
    fn part(&self, value: f64) -> f64 {
        let value = if self.log { value.ln() } else { value };
        (value - self.low) / (self.high - self.low)
    }

    fn at(&self, part: f64) -> f64 {
        let value = self.low + part * (self.high - self.low);
        if self.log { value.exp() } else { value }
    }
}
