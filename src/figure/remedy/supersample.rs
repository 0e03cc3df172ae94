//! Uniform supersampling (slides «Однородный супер-сэмплинг»): more samples, a digital filter, fewer samples.

use crate::axis::Axis;
use crate::error::Result;
use crate::figure::common::{PIECES, density_curve, frequency, space, unmarked, values};
use crate::figure::params::Param;
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::laws::hold::{supersampled_tone, uniform_transfer};
use crate::num::{cos_pi, sinc};
use crate::nyquist::Verdict;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::sampled::convolution::convolve;
use crate::signal::raised_cosine::RaisedCosine;
use crate::signal::tone::Cosine;
use crate::signal::{FourierPair, Signal, from_fn};
use crate::text;
use crate::text::{Text, number};
use std::f64::consts::PI;

static COUNT: Text = Text::fixed("samples per pixel n", "отсчётов на пиксель n");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[SUPERSAMPLING];

const SUPERSAMPLING: Entry = Entry {
    id: "f33-supersampling",
    inventory: &["F33", "F34"],
    errata: &["E13"],
    title: &Text::fixed("Uniform supersampling", "Однородный супер-сэмплинг"),
    caption: &Text::fixed(
        "Sampling n times as often moves the copies n times as far apart. The samples of a pixel are then averaged, which \
         is a digital filter, before only one value a pixel is kept. That filter is near the box over the pixel for low \
         frequencies, but it repeats: close to n·f_{s} everything passes, and folds.",
        "Дискретизация в n раз чаще раздвигает копии в n раз. Затем отсчёты пикселя усредняются — это цифровой фильтр, — и \
         остаётся одно значение на пиксель. На низких частотах такой фильтр близок к усреднению по площади, но он \
         периодичен: около n·f_{s} проходит всё — и заворачивается.",
    ),
    params: &[Param::count("n", &COUNT, 4, 2, 8)],
    build: |params| supersampling(params.count("n")),
};

/// The chain of the slide: samples `1/n` apart, the mean of the `n` of each pixel as a convolution with `n` weights, and
/// one value a pixel kept, for the pixels `−pixels … pixels`, each centred on its number.
fn chain(signal: &impl Signal, n: usize, weights: &[f64], pixels: usize) -> Result<Samples> {
    let part = 1.0 / n as f64;
    let first = 0.5 * part - 0.5;
    let fine = Samples::of(signal, Axis::new(first - pixels as f64, part, (2 * pixels + 1) * n)?);
    // a convolution of samples carries the step, 1/n, in front
    let taps = Samples::new(Axis::new(first, part, n)?, weights.iter().map(|w| w * n as f64).collect())?;
    let means = convolve(&fine, &taps)?;
    let inside = means.values()[n - 1..means.values().len() - (n - 1)].to_vec();
    Samples::new(Axis::new(-(pixels as f64), part, inside.len())?, inside)?.decimated(n)
}

/// The gain of the chain for a tone at `nu` cycles a pixel.
fn chain_gain(n: usize, weights: &[f64], nu: f64) -> Result<f64> {
    let pixels = chain(&Cosine::new(nu)?, n, weights, 24)?;
    let wave = |x: f64| cos_pi(2.0 * nu * x);
    let product: f64 = pixels.points().map(|[x, v]| v * wave(x)).sum();
    Ok(product / pixels.points().map(|[x, _]| wave(x).powi(2)).sum::<f64>())
}

fn supersampling(n: usize) -> Result<Figure> {
    let count = n as f64;
    let weights = vec![1.0 / count; n];
    let f = RaisedCosine::new(0.8)?;
    let spectrum = f.spectrum();
    let limit = count + 1.2;
    let replicas = |name, title, rate: f64| -> Result<Panel> {
        let order = ((limit + f.band()) / rate).ceil() as usize;
        let sum = spectrum.replicated(rate, order)?;
        let mut panel = Panel::new(name, title, frequency(-limit, limit), unmarked(-0.08, 1.35));
        if let Verdict::Aliased { overlap: [low, high] } = Verdict::on(&spectrum, rate)? {
            panel = panel.with(Layer::spans("overlap", Meaning::Leaked, [[-high, -low], [low, high]]));
        }
        Ok(panel.with(density_curve("copies", Meaning::Replica, &sum, -limit, limit).thick()).with(density_curve(
            "signal",
            Meaning::Signal,
            &spectrum,
            -f.band(),
            f.band(),
        )))
    };
    let once = replicas("once", text!("n = 1: copies overlap", "n = 1: копии перекрываются"), 1.0)?;
    let often = replicas("often", text!("n = {n}: copies far apart", "n = {n}: копии раздвинуты"), count)?;

    let low = |nu: f64| uniform_transfer(n as u32, nu);
    let mut measured = Vec::new();
    for i in 0..=(10.0 * limit / 2.5) as usize {
        let nu = 0.15 + 0.25 * i as f64;
        if nu < limit {
            measured.push([nu, chain_gain(n, &weights, nu)?]);
        }
    }
    let near = count - 0.1;
    let (passes, box_passes) = (chain_gain(n, &weights, near)?, sinc(near));
    let transfer = Panel::new(
        "transfer",
        text!("gain of the mean of {n}", "усиление среднего: n = {n}"),
        Scale::linear(text!("frequency ν, cycles per pixel", "частота ν, периодов на пиксель"), 0.0, limit),
        values("", -1.25, 1.25),
    )
    .legend(Legend::Above)
    .with(Layer::curve("mean", Meaning::Kernel, 0.0, limit, PIECES, low).thick().label(Text::same("D(ν)")))
    .with(
        Layer::curve("box", Meaning::Theory, 0.0, limit, PIECES, sinc)
            .dashed()
            .label(text!("area: sinc ν", "площадь: sinc ν")),
    )
    .with(Layer::dots("chain", Meaning::Samples, measured.clone()).label(text!("measured", "измерено")))
    .with(Layer::dots("alias", Meaning::Leaked, [[near, passes]]))
    .with(Layer::notes(
        "passes",
        Meaning::Leaked,
        [([near - 0.2 * limit, passes.signum()], text!("{}: {}", "{}: {}", number(near, 3), number(passes, 3)))],
    ));

    let scene = from_fn(|x| 0.55 * cos_pi(0.46 * x + 0.3) + 0.35 * cos_pi(3.4 * x));
    let shown = 2usize;
    let end = shown as f64 + 0.5;
    let fine: Vec<[f64; 2]> =
        (0..(2 * shown + 1) * n).map(|i| (i as f64 + 0.5) / count - end).map(|x| [x, scene.at(x)]).collect();
    let pixels = chain(&scene, n, &weights, shown)?;
    let bars = pixels.points().flat_map(|[x, v]| [[x - 0.5, v], [x + 0.5, v], [f64::NAN, f64::NAN]]);
    let pixel = Panel::new(
        "pixel",
        text!("pixel = Σ w_{{s}}·sample_{{s}}", "пиксель = Σ w_{{s}}·отсчёт_{{s}}"),
        space(-end, end),
        unmarked(-1.15, 1.15),
    )
    .legend(Legend::Above)
    .with(Layer::verticals("edges", Meaning::Guide, (0..2 * shown).map(|i| i as f64 + 1.0 - end)))
    .with(Layer::curve("scene", Meaning::Signal, -end, end, PIECES, |x| scene.at(x)).label(text!("signal", "сигнал")))
    .with(Layer::line("pixels", Meaning::Reconstructed, bars).thick().label(text!("pixels", "пиксели")))
    .with(Layer::dots("samples", Meaning::Samples, fine.clone()).label(text!("samples", "отсчёты")));

    let total: f64 = weights.iter().sum();
    // every pixel's mean of the samples drawn over it
    let means = pixels.values().iter().zip(fine.chunks(n));
    let apart = means.map(|(v, s)| (v - s.iter().map(|p| p[1]).sum::<f64>() / count).abs()).fold(0.0, f64::max);
    let off = measured.iter().map(|p| (p[1] - low(p[0])).abs()).fold(0.0, f64::max);
    let repeats = measured.iter().map(|p| (low(p[0] + count).abs() - low(p[0]).abs()).abs()).fold(0.0, f64::max);
    // 49 pixels by FFT, and tones whose arguments are off by ε times themselves
    let rounding = f64::EPSILON * (64.0 + 8.0 * PI * limit * 25.0);
    let gap = match Verdict::on(&spectrum, count)? {
        Verdict::Recoverable { margin } => margin,
        _ => f64::NAN,
    };
    Ok(Figure::new(2)
        .with(once)
        .with(pixel)
        .with(often)
        .with(transfer)
        .claim(
            text!(
                "the copies, {} wide, overlap at a spacing of 1 and stand {} apart at {}",
                "копии шириной {0} при шаге 1 перекрываются, а при шаге {2} между ними зазор {1}",
                number(2.0 * f.band(), 3),
                number(gap, 3),
                number(count, 2)
            ),
            Residual::near("gap between copies = n/T − 2B", gap, count - 2.0 * f.band(), 4.0 * f64::EPSILON * count),
        )
        .claim(
            text!("the weights add up to one, and pixels are the means", "сумма весов равна единице, пиксели — средние"),
            Residual::at_most("Σw = 1, pixel = Σw·sample", (total - 1.0).abs().max(apart), 16.0 * f64::EPSILON * count),
        )
        .claim(
            text!(
                "the chain, sample, filter, decimate, has the gain sin(πν)/(n·sin(πν/n)); its size repeats after n·f_{{s}}",
                "цепочка «дискретизация, фильтр, прореживание» усиливает в sin(πν)/(n·sin(πν/n)); период по модулю n·f_{{s}}"
            ),
            Residual::at_most("measured gain = D(ν), |D(ν + n)| = |D(ν)|", off.max(repeats), rounding),
        )
        .claim(
            text!(
                "at {} it lets {} through, the area of a pixel only {}",
                "на частоте {} она пропускает {}, а площадь пикселя — лишь {}",
                number(near, 3),
                number(passes, 5),
                number(box_passes, 4)
            ),
            supersampled_tone(n as u32, near, passes),
        ))
}
