//! What is written in a picture can be read: whole, apart, large enough, in both languages.

use crate::samples::all;
use nyquist::figure::{Figure, Layer, Meaning, Panel, Scale};
use nyquist::plot::{Label, Style, Theme, draw};
use nyquist::text::{Lang, Text};

fn labels(title: &Text, figure: &Figure, style: &Style) -> Vec<Label> {
    draw(title, &Text::EMPTY, figure, style).labels()
}

/// What is wrong with the labels of a figure in any language and size of picture.
fn faults(name: &str, title: &Text, figure: &Figure) -> Vec<String> {
    let mut faults = Vec::new();
    for size in [(1600, 900), (1200, 900), (800, 450)] {
        for lang in Lang::ALL {
            let labels = labels(title, figure, &Style { lang, size, ..Style::default() });
            let (width, height) = (f64::from(size.0), f64::from(size.1));
            let least = 18.0 * (width / 1600.0 * height / 900.0).sqrt() - 0.01;
            for (i, a) in labels.iter().enumerate() {
                let mut fault = |what: &str| faults.push(format!("{name} {lang:?} {size:?}: \"{}\" {what}", a.text));
                let [left, top, right, bottom] = a.ink;
                if left < 8.0 || top < 8.0 || right > width - 8.0 || bottom > height - 8.0 {
                    fault("leaves the picture");
                }
                if a.size < least {
                    fault("is too small to be read from the last row");
                }
                if a.incomplete {
                    fault("has a letter that no font has");
                }
                for b in labels[..i].iter().filter(|b| a.note == b.note && a.overlaps(b)) {
                    fault(&format!("overlaps \"{}\"", b.text));
                }
            }
        }
    }
    faults
}

#[test]
fn labels_lie_within_the_picture_and_do_not_collide() {
    for (name, title, figure) in all() {
        assert_eq!(faults(name, &title, &figure), [""; 0]);
    }
}

#[test]
fn labels_of_the_lecture_lie_within_the_picture_and_do_not_collide() {
    for entry in nyquist::figure::catalog::all() {
        let figure = entry.figure().expect("every figure can be computed with its defaults");
        assert_eq!(faults(entry.id, entry.title, &figure), [""; 0]);
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
        size: 24.0,
        note: false,
        incomplete: false,
    };
    assert!(label(0.0, 10.0).overlaps(&label(9.0, 20.0)));
    assert!(!label(0.0, 10.0).overlaps(&label(10.0, 20.0)));
}
