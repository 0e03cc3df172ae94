//! The convolution theorem and its dual (slide «Свертка и преобразование Фурье»).

use crate::axis::Axis;
use crate::error::Result;
use crate::figure::common::{density_curve, frequency, line_arrows, signal_curve, space, values};
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel};
use crate::laws::poisson::copies_by_fft;
use crate::laws::theorems::{convolution_theorem, pair_by_quadrature};
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::sampled::dft::forward;
use crate::signal::boxcar::Boxcar;
use crate::signal::gaussian::Gaussian;
use crate::signal::tent::Tent;
use crate::signal::theorem::{Convolution, Product};
use crate::signal::tone::Cosine;
use crate::signal::{FourierPair, Signal};
use crate::text;
use crate::text::Text;

static CARRIER: Text = Text::fixed("frequency ν_{0} of the tone", "частота тона ν_{0}");
static WIDTH: Text = Text::fixed("width w of the Gaussian", "ширина гауссиана w");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[THEOREMS];

const THEOREMS: Entry = Entry {
    id: "f17-convolution",
    inventory: &["F17"],
    errata: &["E19"],
    title: &Text::fixed("Convolution here is multiplication there", "Свёртка здесь — умножение там"),
    caption: &Text::fixed(
        "Above: box ⊗ box is a tent, and its spectrum is the product sinc·sinc. Below: a tone times a Gaussian, and its \
         spectrum is the convolution of two impulses with a Gaussian: convolved with δ(ν − ν_{0}) a spectrum moves to \
         ν_{0}, and the impulse's weight ½ is its gain. Sampling is this lower row with the Dirac comb for the tone.",
        "Сверху: box ⊗ box — треугольник, а его спектр — произведение sinc·sinc. Снизу: тон, умноженный на гауссиан, а его \
         спектр — свёртка двух импульсов с гауссианом: от свёртки с δ(ν − ν_{0}) спектр переезжает в ν_{0}, а вес импульса \
         ½ становится усилением. Дискретизация — этот нижний ряд, где вместо тона гребень Дирака.",
    ),
    params: &[Param::real("nu0", &CARRIER, 2.0, 1.0, 3.5, ""), Param::real("w", &WIDTH, 2.0, 1.0, 3.0, "")],
    build: theorems,
};

fn theorems(params: &Params) -> Result<Figure> {
    let unit = Boxcar::new(1.0)?;
    let edges = [-0.5, 0.5];
    let both = Convolution::new(unit, &edges, unit, &edges)?;
    let (tent, end, limit) = (Tent::new(1.0)?, 1.4, 4.5);
    let space_up = Panel::new(
        "convolution",
        text!("box ⊗ box = tent", "box ⊗ box = треугольник"),
        space(-end, end),
        values("f(x)", -0.1, 1.3),
    )
    .legend(Legend::Above)
    .with(signal_curve("box", Meaning::Kernel, &unit, -end, end).dashed().label(text!("box", "box")))
    .with(
        Layer::curve("box ⊗ box", Meaning::Signal, -end, end, 240, |x| both.at(x))
            .thick()
            .label(text!("box ⊗ box", "box ⊗ box")),
    );
    let frequency_up = Panel::new(
        "product of spectra",
        text!("sinc·sinc = sinc²", "sinc·sinc = sinc²"),
        frequency(-limit, limit),
        values("F(ν)", -0.35, 1.3),
    )
    .legend(Legend::Above)
    .with(density_curve("sinc", Meaning::Kernel, &unit.spectrum(), -limit, limit).dashed().label(text!("sinc", "sinc")))
    .with(
        density_curve("sinc²", Meaning::Signal, &both.spectrum(), -limit, limit).thick().label(text!("sinc²", "sinc²")),
    );

    let (carrier, width) = (params.real("nu0"), params.real("w"));
    let (tone, envelope) = (Cosine::new(carrier)?, Gaussian::new(width)?);
    let packet = Product::new(tone, envelope)?;
    let (end, axis) = (1.6 * width, Axis::centered(1.0 / 32.0, 1024)?);
    let bins = forward(&Samples::of(&packet, axis));
    // dots on the hills only: a row of them at zero says nothing
    let visible = |nu: &f64| (nu.abs() - carrier).abs() <= 1.3 / width;
    let every = bins.axis().iter().zip(bins.values()).step_by(4).filter(|(nu, _)| visible(nu));
    let space_down = Panel::new(
        "product",
        text!("tone × Gaussian", "тон × гауссиан"),
        space(-end, end),
        values("f(x)", -1.25, 1.25),
    )
    .legend(Legend::Above)
    .with(signal_curve("envelope", Meaning::Kernel, &envelope, -end, end).dashed().label(text!("Gaussian", "гауссиан")))
    .with(signal_curve("packet", Meaning::Signal, &packet, -end, end).thick().label(text!("product", "произведение")));
    let frequency_down = Panel::new(
        "convolution of spectra",
        text!("two impulses ⊗ Gaussian", "два импульса ⊗ гауссиан"),
        frequency(-limit, limit),
        values("F(ν)", -0.07 * width, 1.15 * width),
    )
    .legend(Legend::Above)
    .with(
        density_curve("envelope", Meaning::Kernel, &envelope.spectrum(), -limit, limit)
            .dashed()
            .label(text!("Gaussian", "гауссиан")),
    )
    .with(
        density_curve("packet", Meaning::Signal, &packet.spectrum(), -limit, limit)
            .thick()
            .label(text!("convolution", "свёртка")),
    )
    .with(Layer::dots("fft", Meaning::Theory, every.map(|(nu, v)| [nu, v.re])).label(text!("FFT", "БПФ")))
    .with(line_arrows("lines", Meaning::Samples, &tone.spectrum()).label(text!("tone: ½", "тон: ½")));

    let drawn = space_up.layer("box ⊗ box").map_or(&[][..], Layer::points).iter();
    let off = drawn.map(|[x, y]| (y - tent.at(*x)).abs()).fold(0.0, f64::max);
    let record = Samples::of(&unit, Axis::centered(1.0 / 64.0, 129)?);
    let heights = |nu: f64| packet.spectrum().density(nu).re / envelope.spectrum().density(0.0).re;
    // the other copy reaches over from −ν₀
    let far = envelope.spectrum().density(2.0 * carrier).re / width;
    Ok(Figure::new(2)
        .with(space_up)
        .with(frequency_up)
        .with(space_down)
        .with(frequency_down)
        .claim(
            text!("box ⊗ box is the tent", "box ⊗ box — треугольник"),
            // a piecewise constant integrand: the quadrature asks for 1e-14 and rounds to 16ε
            Residual::at_most("∫box(x′)·box(x − x′)dx′ = tent(x)", off, 1e-14 + 16.0 * f64::EPSILON),
        )
        .claim(
            text!("its spectrum is sinc², the product of the two", "его спектр — sinc², произведение двух"),
            pair_by_quadrature(&both, &[-1.0, 0.0, 1.0], &[0.0, 0.3, 0.5, 1.43, 2.5], 1e-14),
        )
        .claim(
            text!("FFT(f ⊗ g) = F·G for the sampled boxes", "БПФ(f ⊗ g) = F·G для отсчётов"),
            convolution_theorem(&record, &record)?,
        )
        .claim(
            text!(
                "the FFT of tone × Gaussian is the sum of the two moved Gaussians",
                "БПФ произведения тона и гауссиана — сумма двух сдвинутых гауссианов"
            ),
            copies_by_fft(&packet, axis, 1, 0.0)?,
        )
        .claim(
            text!("each moved Gaussian is half as high: the impulse weighs ½", "сдвинутые вдвое ниже: вес импульса ½"),
            Residual::near("F(ν₀)/G(0) = ½", heights(carrier), 0.5, 0.5 * far + 4.0 * f64::EPSILON),
        ))
}
