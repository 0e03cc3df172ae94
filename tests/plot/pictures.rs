//! Pictures among plots: colours, bars of tones, and where they stand.

use crate::samples::{Pixels, colors};
use ndarray::Array2;
use nyquist::figure::{Bar, Figure, Layer, Meaning, Panel, Scale, Tones};
use nyquist::plot::{Format, Style, Theme, draw};
use nyquist::text::Text;

fn bare(end: f64) -> Scale {
    Scale::linear(Text::EMPTY, 0.0, end).bare()
}

fn drawn(figure: &Figure) -> Pixels {
    Pixels::of(&draw(&Text::EMPTY, &Text::EMPTY, figure, &Style::default()))
}

/// A square of even cells in tones from zero to one.
fn square(name: &'static str, cells: usize, value: f64) -> Panel {
    let end = cells as f64;
    let values = Array2::from_elem((cells, cells), value);
    let raster = Layer::raster("r", (0.0, end), (0.0, end), values, (0.0, 1.0), Tones::Data);
    Panel::new(name, Text::EMPTY, bare(end), bare(end)).square().with(raster)
}

#[test]
fn colours_are_those_of_their_light_in_srgb() {
    // a half and a fifth of the light are 188 and 124 of 255; what is beyond white or below black is cut off
    let light = colors([[0.5, 0.2, 0.0], [2.0, -1.0, 1.0]]);
    let figure = |flipped: bool| {
        let x = if flipped { Scale::linear(Text::EMPTY, 2.0, 0.0).bare() } else { bare(2.0) };
        let layer = Layer::colors("c", (0.0, 2.0), (0.0, 1.0), &light);
        Figure::new(1).with(Panel::new("p", Text::EMPTY, x, bare(1.0)).square().with(layer))
    };
    let (first, second) = ([188, 124, 0], [255, 0, 255]);
    let pixels = drawn(&figure(false));
    assert_eq!([pixels.at(500, 450), pixels.at(1100, 450)], [first, second]);
    let pixels = drawn(&figure(true));
    assert_eq!([pixels.at(500, 450), pixels.at(1100, 450)], [second, first]);
    let scene = draw(&Text::EMPTY, &Text::EMPTY, &figure(false), &Style::default());
    assert!(scene.svg().contains("data:image/png"));
    assert!(String::from_utf8_lossy(&scene.write(Format::Pdf)).contains("/ColorSpace /DeviceRGB"));
}

#[test]
fn a_bar_has_the_tones_of_its_raster_the_lowest_below() {
    let figure = Figure::new(1).with(square("p", 8, 0.5).bar(Bar::values(Text::EMPTY)));
    let pixels = drawn(&figure);
    let has = |colour: [u8; 3]| {
        let all = (0..pixels.size.1).flat_map(|y| (0..pixels.size.0).map(move |x| (x, y)));
        all.filter(|(x, y)| pixels.at(*x, *y) == colour).map(|(_, y)| y).collect::<Vec<_>>()
    };
    // viridis from end to end, which the even raster has nothing of
    let (dark, bright) = (has([68, 1, 84]), has([253, 231, 37]));
    assert!(!dark.is_empty() && !bright.is_empty());
    let (lowest, highest) = (dark.iter().min().expect("some"), bright.iter().max().expect("some"));
    assert!(*lowest > 800 && *highest < 100, "dark from row {lowest}, bright to row {highest}");
}

#[test]
fn a_bar_counts_from_the_first_tone_to_the_last_or_in_powers_of_ten() {
    let numbers = |bar: Bar, range: (f64, f64)| -> Vec<String> {
        let raster = Layer::raster("r", (0.0, 1.0), (0.0, 1.0), Array2::zeros((2, 2)), range, Tones::Data);
        let panel = Panel::new("p", Text::EMPTY, bare(1.0), bare(1.0)).square().with(raster).bar(bar);
        let scene = draw(&Text::EMPTY, &Text::EMPTY, &Figure::new(1).with(panel), &Style::default());
        scene.labels().into_iter().map(|label| label.text).collect()
    };
    assert_eq!(
        numbers(Bar::values(Text::same("dB")), (-60.0, 0.0)),
        ["−60", "−50", "−40", "−30", "−20", "−10", "0", "dB"]
    );
    assert_eq!(numbers(Bar::powers_of_ten(Text::EMPTY), (-2.0, 1.0)), ["0.01", "0.1", "1", "10"]);
    // without a raster there are no tones
    let none = Panel::new("p", Text::EMPTY, bare(1.0), bare(1.0)).bar(Bar::values(Text::EMPTY));
    assert!(draw(&Text::EMPTY, &Text::EMPTY, &Figure::new(1).with(none), &Style::default()).labels().is_empty());
}

#[test]
fn pictures_of_a_row_stand_level_and_are_as_large_as_their_own_margins_allow() {
    // one has numbers below it and a bar beside it, the other has not
    let mut numbered = square("numbered", 10, 0.2).bar(Bar::values(Text::EMPTY));
    (numbered.x.bare, numbered.y.bare) = (false, false);
    let figure = |plain: Panel| Figure::new(2).with(numbered.clone()).with(plain);
    let placed = |figure: &Figure| {
        let pixels = drawn(figure);
        // the colours of the two even rasters, and where they begin and how high they are
        [400, 1200].map(|x| {
            let colour = pixels.at(x, 300);
            let rows: Vec<usize> = (0..pixels.size.1).filter(|y| pixels.at(x, *y) == colour).collect();
            (rows[0], rows.len())
        })
    };
    let [numbered_one, other] = placed(&figure(square("of another scale", 12, 0.9)));
    assert_eq!(numbered_one.0, other.0);
    assert!(other.1 > numbered_one.1 + 20, "{other:?} and {numbered_one:?}");
    // those of one scale can be compared: they are equally large
    let [numbered_one, other] = placed(&figure(square("of the same scale", 10, 0.9)));
    assert_eq!(numbered_one, other);
}

#[test]
fn rows_over_the_same_scales_leave_the_numbers_to_the_lowest() {
    let panel = |name, end: f64| {
        let curve = Layer::curve("f", Meaning::Signal, 0.0, end, 10, |x| x / end);
        Panel::new(name, Text::EMPTY, Scale::linear(Text::same("x"), 0.0, end), bare(1.0)).with(curve)
    };
    let count = |figure: &Figure, what: &str| {
        let scene = draw(&Text::EMPTY, &Text::EMPTY, figure, &Style { theme: Theme::Dark, ..Style::default() });
        scene.labels().iter().filter(|label| label.text == what).count()
    };
    let stack = Figure::new(1).with(panel("a", 7.0)).with(panel("b", 7.0)).with(panel("c", 7.0));
    assert_eq!([count(&stack, "7"), count(&stack, "x")], [1, 1]);
    let others = Figure::new(1).with(panel("a", 7.0)).with(panel("b", 80.0)).with(panel("c", 80.0));
    assert_eq!([count(&others, "7"), count(&others, "80"), count(&others, "x")], [1, 1, 2]);
    // a row leaves them out as a whole or not at all
    let mixed = Figure::new(2).with(panel("a", 7.0)).with(panel("b", 7.0)).with(panel("c", 7.0)).with(panel("d", 80.0));
    assert_eq!([count(&mixed, "7"), count(&mixed, "x")], [3, 4]);
}
