//! Aliasing: copies that overlap, and what leaks (slides «Алиасинг»).

use crate::error::Result;
use crate::figure::common::{PIECES, density_curve, frequency, signal_curve, space, values};
use crate::figure::formal::replicas::order;
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel};
use crate::laws::alias::leaked_spectrum;
use crate::residual::Residual;
use crate::signal::gaussian::Gaussian;
use crate::signal::{FourierPair, Signal};
use crate::text;
use crate::text::{Text, number};

static STEP: Text = Text::fixed("sampling step T", "шаг дискретизации T");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[OVERLAP, LEAK];

/// The signal of both figures: its spectrum is `e^{−8ν²}`, as in the source's artwork.
fn signal() -> Result<Gaussian> {
    Gaussian::with_spectrum(8.0)
}

const OVERLAP: Entry = Entry {
    id: "f27-overlap",
    inventory: &["F27"],
    errata: &["E07"],
    title: &Text::fixed("Aliasing: the copies overlap", "Алиасинг: копии накладываются"),
    caption: &Text::fixed(
        "Sampling adds up copies of the spectrum, 1/T apart. When T is too large they overlap, and only their sum \
         (thick) is left: the single copies cannot be told apart any more. (The slide says «T not large enough»: it is \
         the other way round.)",
        "Дискретизация складывает копии спектра, отстоящие на 1/T. Если T слишком велико, копии накладываются, и \
         остаётся только их сумма (толстая линия): отдельные копии уже не различить. (На слайде сказано «T \
         недостаточно большой» — должно быть наоборот.)",
    ),
    params: &[Param::real("T", &STEP, 1.0, 0.25, 2.0, "")],
    build: |params| overlap(params.real("T")),
};

fn overlap(step: f64) -> Result<Figure> {
    let spectrum = signal()?.spectrum();
    let (rate, limit) = (1.0 / step, 1.5);
    let order = order(&spectrum, rate, limit);
    let sum = spectrum.replicated(rate, order)?;
    let mut panel =
        Panel::new("spectrum", Text::EMPTY, frequency(-limit, limit), values("F(ν)", 0.0, 1.25)).legend(Legend::Above);
    for k in -(order as i64)..=order as i64 {
        let copy = spectrum.translated(k as f64 * rate);
        let layer = density_curve("copy", Meaning::Replica, &copy, -limit, limit).thin();
        let label = text!("copies F(ν − k/T)", "копии F(ν − k/T)");
        panel = panel.with(if k == 0 { layer.label(label) } else { layer });
    }
    let thick = density_curve("sum", Meaning::Leaked, &sum, -limit, limit).thick();
    let panel = panel
        .with(thick.label(text!("their sum: all that the samples know", "их сумма: всё, что знают отсчёты")))
        .with(Layer::verticals("nyquist", Meaning::Guide, [-0.5 * rate, 0.5 * rate]).dashed());

    let edge = 0.5 * rate;
    let (single, total) = (spectrum.density(edge).re, sum.density(edge).re);
    // the second-nearest copies add 2·F(3/(2T)) at the edge
    let beyond = 2.0 * spectrum.density(1.5 * rate).re + 4.0 * f64::EPSILON;
    Ok(Figure::new(1).with(panel).claim(
        text!(
            "at ν = 1/(2T) one copy has {} and the sum {}: twice as much",
            "при ν = 1/(2T) одна копия равна {}, а сумма — {}: вдвое больше",
            number(single, 4),
            number(total, 4)
        ),
        Residual::near("at the fold the sum is twice a single copy", total, 2.0 * single, beyond * 2.0),
    ))
}

const LEAK: Entry = Entry {
    id: "f28-leak",
    inventory: &["F28"],
    errata: &["E30"],
    title: &Text::fixed(
        "Aliasing: high frequencies leak into low ones",
        "Алиасинг: высокие частоты «протекают» в низкие",
    ),
    caption: &Text::fixed(
        "The ideal low-pass keeps everything inside ±1/(2T): the signal's own spectrum and the tails of its neighbours. \
         Those tails (shaded) are high frequencies under the mask of low ones; the reconstruction passes through every \
         sample and is still another function. (The source's drawing cuts off a single copy and so leaves out the \
         alias itself.)",
        "Идеальный фильтр низких частот оставляет всё внутри ±1/(2T): спектр самого сигнала и хвосты соседних копий. Эти \
         хвосты (закрашены) — высокие частоты под маской низких; реконструкция проходит через все отсчёты и всё же это \
         другая функция. (В исходном рисунке просто обрезана одна копия, так что самого алиаса на нём нет.)",
    ),
    params: &[Param::real("T", &STEP, 1.0, 0.5, 2.0, "")],
    build: |params| leak(params),
};

fn leak(params: &Params) -> Result<Figure> {
    let step = params.real("T");
    let f = signal()?;
    let spectrum = f.spectrum();
    let half = 0.5 / step;
    let limit = 1.25f64.max(1.2 * half);
    let kept = leaked_spectrum(&spectrum, step)?;
    let inside = |i: usize| -half + 2.0 * half * i as f64 / PIECES as f64;
    // between the signal's own copy and the sum: open at the edges, where the low-pass halves both
    let tails = (1..PIECES).map(|i| [inside(i), spectrum.density(inside(i)).re, kept.density(inside(i)).re]);
    let frequency_panel =
        Panel::new("spectrum", text!("in frequency", "по частоте"), frequency(-limit, limit), values("F(ν)", 0.0, 1.2))
            .legend(Legend::Above)
            .with(Layer::between("leaked", Meaning::Leaked, tails).label(text!("leaked", "протекло")))
            .with(density_curve("signal", Meaning::Signal, &spectrum, -limit, limit).label(text!("signal", "сигнал")))
            .with(
                density_curve("kept", Meaning::Reconstructed, &kept, -limit, limit)
                    .thick()
                    .label(text!("reconstruction", "реконструкция")),
            )
            .with(Layer::verticals("nyquist", Meaning::Guide, [-half, half]).dashed());

    let (low, high) = (-2.5 * step, 2.5 * step);
    let n = 200;
    let mut reconstructed = Vec::with_capacity(n + 1);
    for i in 0..=n {
        let x = low + (high - low) * i as f64 / n as f64;
        reconstructed.push([x, kept.inverse_at(x)?.re]);
    }
    let dots = (-2..=2).map(|k| f64::from(k) * step).map(|x| [x, f.at(x)]);
    let space_panel =
        Panel::new("space", text!("in space", "в пространстве"), space(low, high), values("f(x)", -0.1, 0.75))
            .legend(Legend::Above)
            .with(signal_curve("signal", Meaning::Signal, &f, low, high).label(text!("signal", "сигнал")))
            .with(
                Layer::line("reconstruction", Meaning::Reconstructed, reconstructed)
                    .thick()
                    .label(text!("reconstruction", "реконструкция")),
            )
            .with(Layer::dots("samples", Meaning::Samples, dots).label(text!("samples", "отсчёты")));

    let between = 0.5 * step;
    let (before, after) = (f.at(between), kept.inverse_at(between)?.re);
    // the cardinal series of the samples, which knows nothing of spectra: the signal is below ε beyond 12 units
    let reach = (12.0 / step).ceil() as i64;
    let series: f64 =
        (-reach..=reach).map(|k| f.at(k as f64 * step) * crate::num::sinc(between / step - k as f64)).sum();
    let alias = crate::laws::alias::alias_energy(&spectrum, step)?;
    Ok(Figure::new(2)
        .with(frequency_panel)
        .with(space_panel)
        .claim(
            text!(
                "the samples are kept: reconstruction and signal agree at x = 0",
                "отсчёты сохранены: при x = 0 реконструкция и сигнал совпадают"
            ),
            // the quadrature's 16ε∫|F| with ∫|F| < 1, and its tolerance per piece of 1e-15 for tens of pieces
            Residual::near("the reconstruction keeps the samples", kept.inverse_at(0.0)?.re, f.at(0.0), 1e-13),
        )
        .claim(
            text!(
                "half-way between two samples the reconstruction has {}, the signal {}",
                "посередине между отсчётами реконструкция равна {}, а сигнал — {}",
                number(after, 5),
                number(before, 5)
            ),
            // the same quadrature, and ε·n·Σ|f| for the rounding of the sum of n < 100 terms with Σ|f| < 3
            Residual::near("low-passed sum of copies = cardinal series of the samples", after, series, 1e-13),
        )
        .claim(
            text!(
                "energy leaked in {}, cut off {}: here no copy is negative, so at least as much leaks in as is cut off",
                "энергия протёкшего {}, отрезанного {}: здесь копии неотрицательны, и протекает не меньше, чем отрезано",
                number(alias.folded, 4),
                number(alias.lost, 4)
            ),
            // the difference is 2∫ΣF_jF_k over pairs of neighbours, positive; allowed: the error of the quadratures
            Residual::at_most("energy cut off − energy leaked in", alias.lost - alias.folded, 2e-15),
        ))
}
