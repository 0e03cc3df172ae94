//! E05: the lecture writes the box once with `|x| < ½` and once with `|x| ≤ T/2`. The consistent value at the edge is ½.
//!
//! It matters for a tone exactly at Nyquist: sampling puts two of its four lines on each edge of the low-pass.

use nyquist::prelude::*;
use std::f64::consts::PI;

/// `cos(2πBx + φ)`, sampled at the rate `2B` and cut off at `B` by a box whose value at its edge is `edge`: the weight of
/// the line at `+B`, by hand. The copies of the line at `−B` land on it.
fn line_by_hand(phi: f64, edge: f64) -> num_complex::Complex<f64> {
    let (own, copy) = (0.5 * num_complex::Complex::cis(phi), 0.5 * num_complex::Complex::cis(-phi));
    (own + copy) * edge
}

const PHASES: [f64; 6] = [0.0, 0.3, 1.0, PI / 2.0, 2.2, PI];

#[test]
fn with_one_half_at_the_edge_a_tone_at_nyquist_comes_back_with_the_gain_cos_phi() {
    for phi in PHASES {
        // cos φ·cos(2πBx) has lines of weight ½·cos φ
        assert!((line_by_hand(phi, 0.5) - 0.5 * phi.cos()).norm() < 1e-16);
        let tone = Cosine::with_phase(3.0, phi).unwrap().spectrum();
        let back = tone.replicated(6.0, 1).unwrap().low_passed(3.0).unwrap();
        let at_edge: num_complex::Complex<f64> = back.lines().iter().filter(|l| l.at == 3.0).map(|l| l.weight).sum();
        assert!((at_edge - 0.5 * phi.cos()).norm() < 1e-15, "phase {phi}");
    }
}

#[test]
fn with_the_edges_as_printed_it_comes_back_twice_or_not_at_all() {
    for phi in PHASES {
        let (closed, open) = (line_by_hand(phi, 1.0), line_by_hand(phi, 0.0));
        // |x| ≤ T/2: lines of weight cos φ, so 2·cos φ·cos(2πBx); |x| < ½: nothing
        assert!((closed - phi.cos()).norm() < 1e-15 && open.norm() == 0.0);
        if phi.cos().abs() > 0.1 {
            assert!((closed - 0.5 * phi.cos()).norm() > 0.05 && (open - 0.5 * phi.cos()).norm() > 0.05);
        }
    }
}

#[test]
fn the_samples_themselves_agree_with_one_half() {
    // a periodic record of even length: Dirichlet's kernel halves the two lines at Nyquist, and passes through the samples
    for phi in PHASES {
        let tone = Cosine::with_phase(3.0, phi).unwrap();
        let samples = Samples::of(&tone, Axis::nodes(0.0..1.0, 6).unwrap());
        let back = reconstruct(&samples, Ideal).edge(Edge::Wrap);
        for i in 0..20 {
            let x = 0.0517 * f64::from(i);
            assert!((back.at(x) - phi.cos() * (6.0 * PI * x).cos()).abs() < 1e-14, "phase {phi}, x = {x}");
        }
    }
}

#[test]
fn in_space_too_the_box_is_one_half_at_its_edge() {
    // Σ box(x − i) = 1 also half-way between samples: with 1 at the edge it would be 2 there, with 0 nothing
    let sum = |edge: f64| -> f64 {
        let printed = |t: f64| if t.abs() == 0.5 { edge } else { f64::from(u8::from(t.abs() < 0.5)) };
        (-3..=3).map(|i| printed(0.5 - f64::from(i))).sum()
    };
    assert_eq!([sum(0.0), sum(1.0), sum(0.5)], [0.0, 2.0, 1.0]);
    let samples = Samples::new(Axis::new(0.0, 1.0, 2).unwrap(), vec![1.0, 3.0]).unwrap();
    assert_eq!(reconstruct(&samples, BoxKernel).at(0.5), 2.0); // the mean of both sides
}
