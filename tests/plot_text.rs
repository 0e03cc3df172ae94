//! What is written in a picture can be read: whole, apart, large enough, in both languages.

#![cfg(feature = "plot")]

mod plot_samples;

use nyquist::figure::{Figure, Layer, Meaning, Panel, Scale};
use nyquist::plot::{Label, Style, Theme, draw};
use nyquist::text::{Lang, Text};
use plot_samples::all;

fn labels(title: &Text, figure: &Figure, style: &Style) -> Vec<Label> {
    draw(title, &Text::EMPTY, figure, style).labels()
}

#[test]
fn labels_lie_within_the_picture_and_do_not_collide() {
    for (name, title, figure) in all() {
        for size in [(1600, 900), (1200, 900), (800, 450)] {
            for lang in Lang::ALL {
                let labels = labels(&title, &figure, &Style { lang, size, ..Style::default() });
                for (i, a) in labels.iter().enumerate() {
                    let [left, top, right, bottom] = a.ink;
                    let inside =
                        left >= 8.0 && top >= 8.0 && right <= size.0 as f64 - 8.0 && bottom <= size.1 as f64 - 8.0;
                    assert!(inside, "{name} {lang:?} {size:?}: \"{}\" at {:?}", a.text, a.ink);
                    let others = labels[..i].iter().filter(|b| !a.note && !b.note);
                    for b in others {
                        assert!(!a.overlaps(b), "{name} {lang:?} {size:?}: \"{}\" and \"{}\"", a.text, b.text);
                    }
                }
            }
        }
    }
}

#[test]
fn every_letter_has_a_glyph() {
    for (name, title, figure) in all() {
        for lang in Lang::ALL {
            for label in labels(&title, &figure, &Style { lang, ..Style::default() }) {
                assert!(!label.incomplete, "{name}: a letter of \"{}\" is missing", label.text);
            }
        }
    }
    let private = Text::same("\u{E000}");
    assert!(labels(&private, &Figure::new(1), &Style::default())[0].incomplete, "a missing one would be found");
}

#[test]
fn numbers_follow_the_language() {
    let axis = || Scale::linear(Text::EMPTY, -1.0, 1.0);
    let figure = Figure::new(1).with(Panel::new("p", Text::EMPTY, axis(), axis()));
    let read = |lang| {
        let labels = labels(&Text::EMPTY, &figure, &Style { lang, ..Style::default() });
        labels.into_iter().map(|l| l.text).collect::<Vec<_>>()
    };
    assert!(read(Lang::En).contains(&"−0.5".to_owned()));
    assert!(read(Lang::Ru).contains(&"−0,5".to_owned()));
    assert!(read(Lang::Ru).iter().all(|l| !l.contains('-') && !l.contains("−0,0")));
}

#[test]
fn notes_stay_inside_their_panel() {
    let axis = || Scale::linear(Text::EMPTY, 0.0, 1.0).bare();
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
    let notes = corners.map(|at| (at, Text::same("a long note in the corner")));
    let panel = Panel::new("p", Text::EMPTY, axis(), axis()).with(Layer::notes("n", Meaning::Guide, notes));
    for label in labels(&Text::EMPTY, &Figure::new(1).with(panel), &Style { theme: Theme::Dark, ..Style::default() }) {
        let [left, top, right, bottom] = label.ink;
        assert!(label.note && left > 30.0 && top > 24.0 && right < 1570.0 && bottom < 880.0, "{:?}", label.ink);
    }
}

#[test]
fn a_label_drawn_wider_than_measured_would_be_found() {
    let label = |left: f64, right: f64| Label {
        text: String::new(),
        ink: [left, 0.0, right, 10.0],
        note: false,
        incomplete: false,
    };
    assert!(label(0.0, 10.0).overlaps(&label(9.0, 20.0)));
    assert!(!label(0.0, 10.0).overlaps(&label(10.0, 20.0)));
}
