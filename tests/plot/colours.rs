//! Every meaning can be seen, and told from those it stands beside, with any colour vision.

use nyquist::figure::Meaning;
use nyquist::plot::{Rgb, Theme};

const TOGETHER: [Meaning; 7] = [
    Meaning::Signal,
    Meaning::Samples,
    Meaning::Reconstructed,
    Meaning::Leaked,
    Meaning::Error,
    Meaning::Kernel,
    Meaning::Theory,
];

/// What is seen without deficiency, with protanopia and with deuteranopia: matrices on linear light from Machado,
/// Oliveira, Fernandes, "A physiologically-based model for simulation of color vision deficiency" (2009), severity 1.
const VISIONS: [(&str, [[f64; 3]; 3]); 3] = [
    ("full colour vision", [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
    ("protanopia", [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]),
    (
        "deuteranopia",
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
    ),
];

/// CIE L*a*b* under D65 of a colour as `vision` sees it.
fn lab(colour: Rgb, vision: [[f64; 3]; 3]) -> [f64; 3] {
    let light = colour.linear();
    let seen = vision.map(|row| row.iter().zip(light).map(|(m, l)| m * l).sum::<f64>().clamp(0.0, 1.0));
    let [r, g, b] = seen;
    let x = (0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047;
    let y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    let z = (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883;
    let f = |t: f64| if t > 216.0 / 24389.0 { t.cbrt() } else { (24389.0 / 27.0 * t + 16.0) / 116.0 };
    [116.0 * f(y) - 16.0, 500.0 * (f(x) - f(y)), 200.0 * (f(y) - f(z))]
}

fn distance(a: Rgb, b: Rgb, vision: [[f64; 3]; 3]) -> f64 {
    lab(a, vision).iter().zip(lab(b, vision)).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

#[test]
fn every_meaning_stands_out_from_the_paper() {
    // WCAG 2.2, 1.4.11: graphical objects need 3:1; 1.4.3: text needs 4.5:1, large text (from 24 pixels) 3:1.
    for theme in Theme::ALL {
        let all = TOGETHER.into_iter().chain([Meaning::Replica, Meaning::Guide]).chain((0..=20).map(Meaning::Series));
        for meaning in all {
            let contrast = theme.colour(meaning).contrast(theme.paper());
            assert!(contrast >= 3.0, "{meaning:?} has {contrast:.2} in {theme:?}");
        }
        assert!(theme.text().contrast(theme.paper()) >= 7.0);
        assert!(theme.frame().contrast(theme.paper()) >= 3.0);
        assert!(theme.grid().contrast(theme.paper()) < 1.6, "the grid stays behind");
    }
}

#[test]
fn meanings_that_meet_are_told_apart_with_any_colour_vision() {
    // 2.3 ΔE*ab is a just noticeable difference (Mahy, Van Eycken, Oosterlinck 1994): 19 is eight of them, enough for
    // thin lines on a projector.
    for theme in Theme::ALL {
        for (name, vision) in VISIONS {
            for (i, a) in TOGETHER.into_iter().enumerate() {
                for b in TOGETHER.into_iter().take(i) {
                    let distance = distance(theme.colour(a), theme.colour(b), vision);
                    assert!(distance >= 19.0, "{a:?} and {b:?} with {name} in {theme:?}: {distance:.1}");
                }
            }
        }
    }
}

#[test]
fn a_confusable_pair_would_be_found() {
    // Pure red and a dark green, the classic trap: far apart with full vision, close with deuteranopia.
    let (red, green) = (Rgb([200, 60, 40]), Rgb([110, 105, 30]));
    assert!(distance(red, green, VISIONS[0].1) > 40.0);
    assert!(distance(red, green, VISIONS[2].1) < 19.0, "{}", distance(red, green, VISIONS[2].1));
}
