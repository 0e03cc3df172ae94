//! One coordinate direction: from values to places, with ticks that have room for their labels.

use crate::figure::Scale;
use crate::text::{Lang, Text};
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use std::ops::Range;

/// A scale of a panel with its ticks chosen; plotters' coordinate in both directions.
#[derive(Debug, Clone)]
pub(super) struct Ruler {
    low: f64,
    high: f64,
    log: bool,
    /// Places with a tick and a label.
    pub ticks: Vec<(f64, String)>,
    /// Places with a line of the grid only.
    minor: Vec<f64>,
}

/// What ticks must have room for.
pub(super) struct Room<'a> {
    /// The length of the scale, in units of the picture.
    pub length: f64,
    /// How much of it a label takes, gap included.
    pub takes: &'a dyn Fn(&str) -> f64,
    /// No more ticks than these.
    pub most: usize,
    pub lang: Lang,
}

impl Ruler {
    pub(super) fn new(scale: &Scale, room: &Room<'_>) -> Self {
        let (mut low, mut high) = scale.range;
        let sound = low.is_finite() && high.is_finite() && (!scale.log || (low > 0.0 && high > 0.0));
        if !sound {
            (low, high) = if scale.log { (0.1, 1.0) } else { (0.0, 1.0) };
        }
        if low == high {
            (low, high) = if scale.log { (low / 2.0, high * 2.0) } else { (low - 0.5, high + 0.5) };
        }
        let mut ruler = Self { low, high, log: scale.log, ticks: Vec::new(), minor: Vec::new() };
        if scale.bare {
            return ruler;
        }
        if !scale.ticks.is_empty() {
            ruler.own(&scale.ticks, room);
        } else if scale.log {
            ruler.decades(room);
        } else {
            ruler.ticks = ruler.steps(room);
        }
        ruler
    }

    pub(super) fn low(&self) -> f64 {
        self.low
    }

    pub(super) fn high(&self) -> f64 {
        self.high
    }

    pub(super) fn log(&self) -> bool {
        self.log
    }

    /// Where `value` lies: 0 at the low end, 1 at the high end; infinite for what a logarithmic scale cannot show.
    pub(super) fn part(&self, value: f64) -> f64 {
        if self.log {
            (value.max(0.0).log10() - self.low.log10()) / (self.high.log10() - self.low.log10())
        } else {
            (value - self.low) / (self.high - self.low)
        }
    }

    /// Whether `value` is shown, within a hair.
    pub(super) fn shows(&self, value: f64) -> bool {
        (-1e-9..=1.0 + 1e-9).contains(&self.part(value))
    }

    /// Where stems, bars and arrows stand: at zero, or at the end of the scale that is nearest to it.
    pub(super) fn base(&self) -> f64 {
        let (least, most) = (self.low.min(self.high), self.low.max(self.high));
        if self.log { least } else { 0.0_f64.clamp(least, most) }
    }

    /// The author's ticks, thinned out where labels would collide.
    fn own(&mut self, given: &[(f64, Text)], room: &Room<'_>) {
        let mut shown: Vec<(f64, String)> = given.iter().map(|(at, t)| (*at, t.get(room.lang).to_owned())).collect();
        shown.retain(|(at, _)| self.shows(*at));
        shown.sort_by(|a, b| self.part(a.0).total_cmp(&self.part(b.0)));
        let greedy = || {
            let mut kept: Vec<(f64, String)> = Vec::new();
            for tick in &shown {
                if kept.last().is_none_or(|last| self.apart(last, tick, room)) {
                    kept.push(tick.clone());
                }
            }
            kept
        };
        let every = |stride: usize| {
            let zero = shown.iter().position(|(at, _)| *at == 0.0).unwrap_or(0);
            let kept = shown.iter().skip(zero % stride).step_by(stride);
            kept.cloned().collect::<Vec<_>>()
        };
        let gaps: Vec<f64> = shown.windows(2).map(|w| self.part(w[1].0) - self.part(w[0].0)).collect();
        let even = gaps.iter().all(|g| (g - gaps[0]).abs() < 1e-6);
        let thinned = (1..=shown.len()).map(every).find(|kept| self.fit(kept, room));
        let kept = match thinned {
            Some(kept) if even => kept,
            Some(kept) if kept.len() == shown.len() => kept,
            _ => greedy(),
        };
        self.minor = shown.iter().map(|(at, _)| *at).filter(|at| kept.iter().all(|k| k.0 != *at)).collect();
        self.ticks = kept;
    }

    /// Multiples of 1, 2 or 5 times a power of ten: the finest for whose labels there is room.
    fn steps(&self, room: &Room<'_>) -> Vec<(f64, String)> {
        let (least, most) = (self.low.min(self.high), self.low.max(self.high));
        let first = ((most - least) / 40.0).log10().floor() as i32;
        let candidates = (first..first + 4).flat_map(|e| [1.0, 2.0, 5.0].map(|m| (m, e)));
        let mut coarsest = Vec::new();
        for (mantissa, exponent) in candidates {
            let unit = power(exponent.abs());
            let at = |i: f64| if exponent < 0 { i * mantissa / unit } else { i * mantissa * unit };
            let step = at(1.0);
            let (a, b) = ((least / step - 1e-9).ceil(), (most / step + 1e-9).floor());
            let count = (b - a).max(-1.0) as usize + 1;
            if count < 2 {
                break;
            }
            if count > 3 * room.most {
                continue; // far too many, and labels cost time
            }
            let values: Vec<f64> = (0..count).map(|i| at(a + i as f64)).collect();
            let ticks = labelled(&values, exponent, room.lang);
            if ticks.len() <= room.most && self.fit(&ticks, room) {
                return ticks;
            }
            coarsest = ticks;
        }
        // Not even two labels fit beside each other: show the ends of the coarsest step alone.
        if coarsest.len() > 2 {
            coarsest.drain(1..coarsest.len() - 1);
        }
        if !self.fit(&coarsest, room) {
            coarsest.truncate(1);
        }
        coarsest
    }

    fn decades(&mut self, room: &Room<'_>) {
        let (least, most) = (self.low.min(self.high), self.low.max(self.high));
        let (first, last) = ((least.log10() - 1e-9).ceil() as i32, (most.log10() + 1e-9).floor() as i32);
        if last - first < 1 {
            // Less than two powers of ten: their parts are labelled too.
            for parts in [&[1.0, 2.0, 5.0][..], &[1.0, 3.0], &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]] {
                let values: Vec<f64> = (first - 1..=last)
                    .flat_map(|e| parts.iter().map(move |m| scaled(*m, e)))
                    .filter(|v| self.shows(*v))
                    .collect();
                let ticks: Vec<(f64, String)> = values.iter().map(|v| (*v, short(*v, room.lang))).collect();
                if ticks.len() > 1 && self.fit(&ticks, room) {
                    self.ticks = ticks;
                    break;
                }
            }
            if self.ticks.is_empty() {
                self.ticks = self.steps(room);
            }
        } else {
            let plain = (-2..=3).contains(&first) && (-2..=4).contains(&last);
            let label = |e: i32| {
                if plain { short(scaled(1.0, e), room.lang) } else { format!("10^{{{e}}}").replace('-', "−") }
            };
            let every = |stride: i32| -> Vec<(f64, String)> {
                let shown = (first..=last).filter(|e| e.rem_euclid(stride) == 0);
                shown.map(|e| (scaled(1.0, e), label(e))).collect()
            };
            let fitting = [1, 2, 3, 5, 10, 20, 50, 100].into_iter().map(every);
            let fitting = fitting.into_iter().find(|t| t.len() <= room.most.max(2) && self.fit(t, room));
            self.ticks = fitting.unwrap_or_default();
        }
        let decade = room.length / (most.log10() - least.log10());
        let parts: &[f64] = if decade > 70.0 { &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0] } else { &[1.0] };
        let all = (first - 1..=last).flat_map(|e| parts.iter().map(move |m| scaled(*m, e)));
        self.minor = all.filter(|v| self.shows(*v) && self.ticks.iter().all(|t| t.0 != *v)).collect();
        if decade < 12.0 {
            self.minor.clear();
        }
    }

    fn fit(&self, ticks: &[(f64, String)], room: &Room<'_>) -> bool {
        ticks.windows(2).all(|w| self.apart(&w[0], &w[1], room))
    }

    fn apart(&self, a: &(f64, String), b: &(f64, String), room: &Room<'_>) -> bool {
        let distance = (self.part(b.0) - self.part(a.0)).abs() * room.length;
        0.5 * ((room.takes)(&a.1) + (room.takes)(&b.1)) <= distance
    }
}

/// `10^exponent`, correctly rounded.
fn power(exponent: i32) -> f64 {
    scaled(1.0, exponent)
}

fn scaled(mantissa: f64, exponent: i32) -> f64 {
    format!("{mantissa}e{exponent}").parse().expect("a number in scientific notation can be read")
}

/// A number with as few digits as say it, for a reader of `lang`; five digits and more stand in groups of three.
fn short(value: f64, lang: Lang) -> String {
    let digits = value.abs().to_string();
    let (whole, part) = digits.split_once('.').unwrap_or((&digits, ""));
    let mut out = if value < 0.0 { "−".to_owned() } else { String::new() };
    for (i, digit) in whole.char_indices() {
        if i > 0 && whole.len() > 4 && (whole.len() - i) % 3 == 0 {
            out.push('\u{2009}');
        }
        out.push(digit);
    }
    if !part.is_empty() {
        out.push(if lang == Lang::Ru { ',' } else { '.' });
        out.push_str(part);
    }
    out
}

/// Labels for multiples of a step of the order `10^exponent`.
fn labelled(values: &[f64], exponent: i32, lang: Lang) -> Vec<(f64, String)> {
    let most = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let common = if most >= 1e6 || (most > 0.0 && most < 1e-3) { most.log10().floor() as i32 } else { 0 };
    let decimals = (common - exponent).max(0) as usize;
    let unit = power(common.abs());
    let label = |v: f64| {
        // Rounded to what the step needs, then as short as that number is.
        let part = if common >= 0 { v / unit } else { v * unit };
        let rounded: f64 = format!("{part:.decimals$}").parse().expect("a plain number can be read back");
        let digits = short(rounded + 0.0, lang);
        match common {
            0 => digits,
            _ if rounded == 0.0 => "0".to_owned(),
            _ if rounded.abs() == 1.0 => format!("{}10^{{{common}}}", digits.trim_end_matches('1')).replace('-', "−"),
            _ => format!("{digits}·10^{{{common}}}").replace('-', "−"),
        }
    };
    values.iter().map(|v| (*v, label(*v))).collect()
}

impl Ranged for Ruler {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    /// Far outside the limits, places are kept where differences still fit into an `i32`.
    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let at = f64::from(limit.0) + self.part(*value) * f64::from(limit.1 - limit.0);
        (at + 0.137).round().clamp(-1e8, 1e8) as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if hint.weight().allow_light_points() { self.minor.clone() } else { self.ticks.iter().map(|t| t.0).collect() }
    }

    fn range(&self) -> Range<f64> {
        self.low..self.high
    }
}

impl ValueFormatter<f64> for Ruler {
    fn format_ext(&self, value: &f64) -> String {
        let tick = self.ticks.iter().find(|t| t.0 == *value);
        tick.map(|t| t.1.clone()).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(scale: &Scale, length: f64, lang: Lang) -> Vec<String> {
        let takes = |label: &str| 14.0 * label.chars().count() as f64 + 14.0;
        let ruler = Ruler::new(scale, &Room { length, takes: &takes, most: 9, lang });
        ruler.ticks.into_iter().map(|t| t.1).collect()
    }

    fn linear(low: f64, high: f64) -> Scale {
        Scale::linear(Text::EMPTY, low, high)
    }

    #[test]
    fn numbers_have_the_digits_that_their_step_needs() {
        assert_eq!(labels(&linear(-1.2, 1.2), 600.0, Lang::En), ["−1", "−0.5", "0", "0.5", "1"]);
        assert_eq!(labels(&linear(0.0, 0.7), 800.0, Lang::Ru), ["0", "0,1", "0,2", "0,3", "0,4", "0,5", "0,6", "0,7"]);
        assert_eq!(
            labels(&linear(0.0, 30000.0), 400.0, Lang::En),
            ["0", "10\u{2009}000", "20\u{2009}000", "30\u{2009}000"]
        );
        assert_eq!(
            labels(&linear(-2e-7, 2e-7), 900.0, Lang::Ru),
            ["−2·10^{−7}", "−10^{−7}", "0", "10^{−7}", "2·10^{−7}"]
        );
        assert_eq!(labels(&linear(0.0, 4e9), 700.0, Lang::En), ["0", "10^{9}", "2·10^{9}", "3·10^{9}", "4·10^{9}"]);
    }

    #[test]
    fn less_room_gives_fewer_ticks_and_no_room_still_one() {
        assert_eq!(labels(&linear(-4.0, 4.0), 200.0, Lang::En), ["−4", "−2", "0", "2", "4"]);
        assert_eq!(labels(&linear(-4.0, 4.0), 100.0, Lang::En), ["−4", "4"]);
        assert_eq!(labels(&linear(-4.0, 4.0), 20.0, Lang::En).len(), 1);
    }

    #[test]
    fn decades_are_thinned_evenly_and_few_are_divided() {
        let decades = |low, high, length| labels(&Scale::log(Text::EMPTY, low, high), length, Lang::En);
        assert_eq!(decades(1e-16, 10.0, 700.0), ["10^{−15}", "10^{−10}", "10^{−5}", "10^{0}"]);
        assert_eq!(decades(0.1, 1000.0, 600.0), ["0.1", "1", "10", "100", "1000"]);
        assert_eq!(decades(0.5, 8.0, 600.0), ["0.5", "1", "2", "5"]);
        assert_eq!(decades(200.0, 900.0, 600.0), ["200", "500"]);
    }

    #[test]
    fn ticks_of_ones_own_are_kept_where_there_is_room() {
        let own = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|v| (v, Text::of(format!("{v}/T"), format!("{v}/T"))));
        let scale = linear(-2.0, 2.0).ticks(own);
        assert_eq!(labels(&scale, 600.0, Lang::En), ["−2/T", "−1/T", "0/T", "1/T", "2/T"]);
        assert_eq!(
            labels(&scale, 200.0, Lang::En),
            ["−2/T", "0/T", "2/T"],
            "even ones are thinned evenly, around zero"
        );
    }

    #[test]
    fn a_place_is_where_its_value_lies_also_in_reverse_and_in_decades() {
        let room = Room { length: 100.0, takes: &|_| 1.0, most: 9, lang: Lang::En };
        let at = |scale: Scale, v: f64| Ruler::new(&scale, &room).part(v);
        assert_eq!(at(linear(2.0, 4.0), 3.0), 0.5);
        assert_eq!(at(linear(4.0, 2.0), 3.5), 0.25);
        assert!((at(Scale::log(Text::EMPTY, 1.0, 100.0), 10.0) - 0.5).abs() <= 2.0 * f64::EPSILON);
        assert_eq!(at(Scale::log(Text::EMPTY, 1.0, 100.0), 0.0), f64::NEG_INFINITY);
    }
}
