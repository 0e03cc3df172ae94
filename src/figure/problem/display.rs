//! A display reconstructs (slide «Дисплей – реконструкция сигнала»).

use crate::axis::Axis;
use crate::error::Result;
use crate::figure::common::{PIECES, frequency, signal_curve, space, unmarked, values};
use crate::figure::params::Param;
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel};
use crate::kernel::Kernel;
use crate::kernel::box_kernel::BoxKernel;
use crate::kernel::gaussian::GaussianKernel;
use crate::num::quadrature::{Integral, integrate_pieces};
use crate::reconstruct::reconstruct;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::constant::Constant;
use crate::signal::tone::{Cosine, Sine};
use crate::signal::{FourierPair, Signal};
use crate::text;
use crate::text::{Text, number};
use num_complex::Complex;
use std::f64::consts::PI;

static TONE: Text = Text::fixed("frequency of the tone", "частота тона");
static SPOT: Text = Text::fixed("deviation σ of the Gaussian spot", "ширина σ гауссова пятна");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[DISPLAY];

const DISPLAY: Entry = Entry {
    id: "f02-display",
    inventory: &["F02"],
    errata: &[],
    title: &Text::fixed("Display = reconstruction of the signal", "Дисплей — реконструкция сигнала"),
    caption: &Text::fixed(
        "A display puts a light of finite size in place of every sample. Its spectrum is the tone with all its copies, \
         each weighed by the response of that light: a held sample lets the first image pass with f/(1 − f) of the \
         tone, a Gaussian spot with almost nothing, but a flat field then shows the raster.",
        "Дисплей ставит на место каждого отсчёта источник света конечного размера. Спектр картинки — тон со всеми его \
         копиями, взвешенными откликом источника: удержание отсчёта пропускает первую копию с весом f/(1 − f), гауссово \
         пятно — почти не пропускает, зато на ровном поле проступает растр.",
    ),
    params: &[
        Param::real("f", &TONE, 0.1, 0.02, 0.4, "cycles per step"),
        Param::real("sigma", &SPOT, 0.5, 0.3, 0.7, "steps"),
    ],
    build: |params| display(params.real("f"), params.real("sigma")),
};

/// How many standard deviations the spots reach: the Gaussian has fallen to `e^{−32}` there.
const REACH: f64 = 8.0;
/// Where the pictures in space end.
const END: f64 = 10.0;

fn display(f: f64, sigma: f64) -> Result<Figure> {
    let spot = GaussianKernel::new(sigma, REACH * sigma)?;
    let ripple = crate::kernel::metrics::dc_ripple(&spot);
    let ([held_space, held_spectrum, held_flat], held) = row(
        ["hold", "hold-spectrum", "hold-flat"],
        [
            text!("box: the sample is held", "прямоугольник: удержание"),
            text!("its spectrum", "его спектр"),
            text!("a flat field", "ровное поле"),
        ],
        f,
        BoxKernel,
        ripple,
    )?;
    let ([spot_space, spot_spectrum, spot_flat], spots) = row(
        ["spots", "spots-spectrum", "spots-flat"],
        [text!("Gaussian spots", "гауссовы пятна"), text!("their spectrum", "их спектр"), Text::EMPTY],
        f,
        spot,
        ripple,
    )?;

    let smooth = (-2.0 * (PI * sigma).powi(2) * (1.0 - 2.0 * f)).exp();
    // the kernel is the Gaussian less its value at the edge, and ends there; both together change its area, and so its
    // response anywhere, by less than
    let edge = (-0.5 * REACH * REACH).exp();
    let cut = 2.0 * edge * (2.0 * REACH + 2.0 / REACH) * sigma / (sigma * (2.0 * PI).sqrt());
    let base = spot.response(f);
    let drawn = spot_flat.layer("flat").map_or(f64::NAN, |l| peak_above_one(l.points()));
    let raster: f64 = (1..=4).map(|k| 2.0 * (-2.0 * (PI * sigma * f64::from(k)).powi(2)).exp()).sum();
    let levels = held_flat.layer("flat").map_or(f64::NAN, |l| peak_above_one(l.points()));
    Ok(Figure::new(8)
        .with(held_space)
        .with(held_spectrum)
        .with(held_flat)
        .with(spot_space)
        .with(spot_spectrum)
        .with(spot_flat)
        .claim(
            text!(
                "sample and hold: the image at 1 − f has {} of the tone, f/(1 − f)",
                "удержание: копия на частоте 1 − f имеет {} от тона, f/(1 − f)",
                number(held.value, 4)
            ),
            Residual::near("hold: image/tone = f/(1 − f)", held.value, f / (1.0 - f), held.error),
        )
        .claim(
            text!(
                "Gaussian spots: the image at 1 − f has {} of the tone, e^{{−2π²σ²(1 − 2f)}}",
                "гауссовы пятна: копия на частоте 1 − f имеет {} от тона, e^{{−2π²σ²(1 − 2f)}}",
                number(spots.value, 3)
            ),
            Residual::near("Gaussian: image/tone", spots.value, smooth, spots.error + 2.0 * cut / base),
        )
        .claim(
            text!(
                "a flat field of Gaussian spots ripples by ±{} %, that of held samples not at all",
                "ровное поле из гауссовых пятен рябит на ±{} %, из удержанных отсчётов — не рябит",
                number(100.0 * drawn, 3)
            ),
            // at every place 2·REACH·σ + 1 spots, each off by `edge`, and the tails beyond
            Residual::near(
                "ripple = 2Σe^{−2π²σ²k²}",
                drawn.max(levels),
                raster,
                2.0 * cut + (2.0 * REACH * sigma + 1.0) * edge / (sigma * (2.0 * PI).sqrt()) + 32.0 * f64::EPSILON,
            ),
        ))
}

fn peak_above_one(points: &[[f64; 2]]) -> f64 {
    points.iter().map(|p| (p[1] - 1.0).abs()).fold(0.0, f64::max)
}

/// The tone, its spectrum and a flat field as that kernel displays them; the lower of two rows has the scales, the upper
/// one the legends.
fn row(
    names: [&'static str; 3],
    titles: [Text; 3],
    f: f64,
    kernel: impl Kernel + Copy + 'static,
    ripple: f64,
) -> Result<([Panel; 3], Integral)> {
    let lower = titles[2].is_empty();
    let named = |layer: Layer, label: Text| if lower { layer } else { layer.label(label) };
    let tone = Cosine::new(f)?;
    // every spot that reaches into the picture
    let before = kernel.radius().ceil();
    let axis = Axis::new(-before, 1.0, (END + 2.0 * before) as usize + 1)?;
    let samples = Samples::of(&tone, axis);
    let shown = samples.points().filter(|[x, _]| (0.0..=END).contains(x));
    let [title, spectrum_title, flat_title] = titles;
    let picture = signal_curve("picture", Meaning::Reconstructed, &reconstruct(&samples, kernel), 0.0, END).thick();
    let x = if lower { space(0.0, END) } else { unmarked(0.0, END) };
    let top = 1.2 * (1.0 + ripple); // the spots of a peak and of its neighbours add up
    let picture = Panel::new(names[0], title, x, values("", -top, top))
        .legend(Legend::Above)
        .span(3)
        .with(named(signal_curve("tone", Meaning::Signal, &tone, 0.0, END).dashed(), text!("tone", "тон")))
        .with(named(picture, text!("display", "дисплей")))
        .with(named(Layer::dots("samples", Meaning::Samples, shown), text!("samples", "отсчёты")));

    let displayed = tone.spectrum().replicated(1.0, 3)?.times(move |nu| kernel.response(nu).into());
    let weights = |image: bool| {
        let lines = displayed.lines().iter().filter(move |l| l.at > 0.0 && (l.at > 0.5) == image);
        lines.map(|l| [l.at, 2.0 * l.weight.re]).collect::<Vec<_>>()
    };
    let ratio = image_ratio(kernel, f)?;
    let says = text!("copy/tone = {}", "копия/тон = {}", number(ratio.value, 3));
    let end = 2.25;
    let response = Layer::curve("response", Meaning::Kernel, 0.0, end, PIECES, |nu| kernel.response(nu)).dashed();
    let x = if lower { frequency(0.0, end) } else { unmarked(0.0, end) };
    let spectrum = Panel::new(names[1], spectrum_title, x, values("", -0.3, 1.15))
        .legend(Legend::Above)
        .span(3)
        .with(named(response, text!("response", "отклик")))
        .with(named(Layer::arrows("tone", Meaning::Reconstructed, weights(false)), text!("tone", "тон")))
        .with(named(Layer::arrows("images", Meaning::Replica, weights(true)), text!("copies", "копии")))
        .with(Layer::notes("image", Meaning::Replica, [([1.5, 0.45], says)]));

    let flat = Samples::of(&Constant::new(1.0)?, axis);
    let (depth, width) = (1.5 * ripple.max(0.004), 6.0);
    let x = if lower { space(0.0, width) } else { unmarked(0.0, width) };
    let field = Panel::new(names[2], flat_title, x, values("", 1.0 - depth, 1.0 + depth))
        .span(2)
        .with(signal_curve("flat", Meaning::Reconstructed, &reconstruct(&flat, kernel), 0.0, width).thick())
        .with(Layer::dots("samples", Meaning::Samples, flat.points().filter(|[x, _]| (0.0..=width).contains(x))));
    Ok(([picture, spectrum, field], ratio))
}

/// The weight of the image at `f − 1` beside that of the tone at `f`, measured in space.
///
/// What is displayed of `e^{2πifk}` is `e^{2πifx}` times a function of period one step, whose Fourier coefficients are
/// the weights of the lines `f + k`: an integral over one step, by quadrature.
fn image_ratio(kernel: impl Kernel + Copy, f: f64) -> Result<Integral> {
    let before = kernel.radius().ceil();
    let axis = Axis::new(-before, 1.0, 2 * before as usize + 2)?;
    let (cosine, sine) = (Samples::of(&Cosine::new(f)?, axis), Samples::of(&Sine::new(f)?, axis));
    let (even, odd) = (reconstruct(&cosine, kernel), reconstruct(&sine, kernel));
    let weight = |nu: f64| {
        let wave = |x: f64| Complex::new(even.at(x), odd.at(x)) * Complex::cis(-2.0 * PI * nu * x);
        integrate_pieces(wave, &[0.0, 0.25, 0.5, 0.75, 1.0], 1e-15)
    };
    let (tone, image) = (weight(f), weight(f - 1.0));
    let value = image.value.norm() / tone.value.norm();
    Ok(Integral { value, error: (image.error + value * tone.error) / tone.value.norm() })
}
