//! Reconstruction in frequency: one copy is cut out (slide «Реконструкция функции в частотной области»).

use crate::error::Result;
use crate::figure::common::{density_curve, difference, frequency, values};
use crate::figure::formal::replicas::order;
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel};
use crate::residual::Residual;
use crate::signal::FourierPair;
use crate::signal::gaussian::Gaussian;
use crate::signal::raised_cosine::RaisedCosine;
use crate::signal::tone::Cosine;
use crate::spectrum::low_pass;
use crate::text;
use crate::text::{Text, number};
use num_complex::Complex;

static STEP: Text = Text::fixed("sampling step T", "шаг дискретизации T");
static SIGNAL: Text =
    Text::fixed("signal: e^{−50ν²} or a raised cosine of band ½", "сигнал: e^{−50ν²} или RC с полосой ½");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[LOW_PASS];

const LOW_PASS: Entry = Entry {
    id: "f21-low-pass",
    inventory: &["F21", "F22"],
    errata: &["E03", "E04", "E05", "E20"],
    title: &Text::fixed(
        "Reconstruction in frequency: cut out one copy",
        "Реконструкция в частотной области: вырезать копию",
    ),
    caption: &Text::fixed(
        "Where the copies do not overlap, a box of width 1/T and height 1 cuts the original out. The box is a function of \
         frequency, Π_{1/T}(ν), and ½ at its edges; with the lines of weight 1/T that the table prints, the result would be \
         F/T. It is exact only without overlap: a Gaussian leaves a trace of its neighbours, the raised cosine of band ½ \
         none as long as 1/T ≥ 1.",
        "Если копии не накладываются, прямоугольник ширины 1/T и высоты 1 вырезает исходный спектр. Это функция частоты, \
         Π_{1/T}(ν), на краях равная ½; с линиями веса 1/T, как в таблице, получилось бы F/T. Точно это только без \
         наложения: у гауссиана остаётся след соседей, у RC с полосой ½ при 1/T ≥ 1 — ничего.",
    ),
    params: &[
        Param::real("T", &STEP, 1.0, 0.5, 2.0, ""),
        Param::choice("signal", &SIGNAL, &["gaussian", "raised-cosine"]),
    ],
    build: cut_out,
};

fn cut_out(params: &Params) -> Result<Figure> {
    let step = params.real("T");
    let spectrum = match params.choice("signal") {
        "gaussian" => Gaussian::with_spectrum(50.0)?.spectrum(),
        _ => RaisedCosine::new(0.5)?.spectrum(),
    };
    let (rate, half, limit) = (1.0 / step, 0.5 / step, 2.6);
    let copies = spectrum.replicated(rate, order(&spectrum, rate, limit))?;
    let product = copies.low_passed(half)?;
    let literal = copies.scaled(rate).low_passed(half)?;
    let title = |en: &str, ru: &str| Text::of(en, ru);
    let panel = |name: &'static str, title: Text, label: &'static str| {
        Panel::new(name, title, frequency(-limit, limit), values(label, 0.0, 1.3)).legend(Legend::Above)
    };
    let box_edges = [[-limit, 0.0], [-half, 0.0], [-half, 1.0], [half, 1.0], [half, 0.0], [limit, 0.0]];
    let edge = [-half, half].map(|nu| [nu, low_pass(nu, half)]);
    let result = density_curve("product", Meaning::Reconstructed, &product, -limit, limit);
    let truth = density_curve("spectrum", Meaning::Signal, &spectrum, -limit, limit);
    let error = difference(&result, &truth);
    // inside: the k-th neighbour is nearest at the edge, (k − ½)/T away, its mirror at k/T: no more than ΣF(j/2T)
    let reach = (2.0 * spectrum.extent() / rate).ceil() as i32;
    let tails: f64 = (1..=reach).map(|j| spectrum.density(f64::from(j) * half).re).sum();
    let gain = literal.density(0.0).re / product.density(0.0).re;
    // a tone on the very edge: each of its lines meets the other's copy
    let phase = 1.0;
    let tone = Cosine::with_phase(half, phase)?.spectrum().replicated(rate, 1)?.low_passed(half)?;
    let edge_line = tone.lines().iter().find(|l| l.at == half).map_or(Complex::ZERO, |l| l.weight);
    Ok(Figure::new(1)
        .heights([1.0, 1.15, 1.45])
        .with(
            panel("copies", title("copies: all that the samples know", "копии: всё, что знают отсчёты"), "ΣF(ν − k/T)")
                .with(density_curve("copies", Meaning::Replica, &copies, -limit, limit).thick())
                .with(Layer::verticals("edges", Meaning::Guide, [-half, half]).dashed()),
        )
        .with(
            panel("box", title("times the box Π_{1/T}(ν)", "умножить на Π_{1/T}(ν)"), "Π_{1/T}(ν)")
                .with(Layer::line("box", Meaning::Kernel, box_edges).thick())
                .with(
                    Layer::dots("edge values", Meaning::Kernel, edge)
                        .thick()
                        .label(text!("½ at the edges", "½ на краях")),
                ),
        )
        .with(
            panel("product", title("one copy is left", "остаётся одна копия"), "F(ν)")
                .with(result.thick().label(text!("product", "произведение")))
                .with(truth.dashed().label(text!("F, the signal's spectrum", "F, спектр сигнала")))
                .with(Layer::verticals("edges", Meaning::Guide, [-half, half]).dashed()),
        )
        .claim(
            text!(
                "the product is F up to the neighbours' tails, ΣF(j/2T) = {}",
                "произведение равно F с точностью до хвостов соседей, ΣF(j/2T) = {}",
                number(tails, 2)
            ),
            Residual::at_most("|product − F| ≤ ΣF(j/2T)", error, tails + 4.0 * f64::EPSILON),
        )
        .claim(
            text!(
                "with the printed line weights 1/T the chain has the gain {}, not 1",
                "с напечатанными весами линий 1/T усиление цепи {}, а не 1",
                number(gain, 4)
            ),
            Residual::near("gain of the literal chain = 1/T", gain, rate, 4.0 * f64::EPSILON * rate),
        )
        .claim(
            text!(
                "with ½ at the edges a tone of phase φ at exactly 1/(2T) comes back with the gain cos φ",
                "при ½ на краях тон с фазой φ ровно на 1/(2T) возвращается с усилением cos φ"
            ),
            Residual::near("weight of the line = ½cos φ", edge_line.re, 0.5 * phase.cos(), 4.0 * f64::EPSILON),
        ))
}
