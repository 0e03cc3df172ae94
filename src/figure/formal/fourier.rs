//! The transform there and back (slide «Прямое и обратное преобразование Фурье»).

use crate::axis::Axis;
use crate::error::Result;
use crate::figure::common::{PIECES, frequency, signal_curve, space, values};
use crate::figure::params::Param;
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::laws::theorems::{parseval_of_samples, round_trip};
use crate::num::{cos_pi, sin_pi};
use crate::residual::Residual;
use crate::sampled::dft::{forward, forward_complex, inverse};
use crate::sampled::{Bins, Samples};
use crate::signal::FourierPair;
use crate::signal::gaussian::Gaussian;
use crate::signal::theorem::{Modulated, Shifted, Sum};
use crate::text;
use crate::text::{Text, number};
use num_complex::Complex;
use std::f64::consts::PI;

static CUTOFF: Text = Text::fixed("highest frequency kept", "наивысшая сохранённая частота");
static TURNS: Text = Text::fixed("frequency ν: turns per unit of x", "частота ν: обороты на единицу x");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[TRANSFORM, EULER];

const TRANSFORM: Entry = Entry {
    id: "f12-transform",
    inventory: &["F12"],
    errata: &[],
    title: &Text::fixed("Forward and inverse Fourier transform", "Прямое и обратное преобразование Фурье"),
    caption: &Text::fixed(
        "A slow and a fast wave packet, and how much of every frequency they hold. All frequencies together give the signal \
         back. Keep only |ν| < c and the fast packet is missing: what is lost in space holds exactly the energy that was \
         cut away in frequency (Parseval).",
        "Медленный и быстрый волновые пакеты и вклад каждой частоты. Все частоты вместе возвращают сигнал. Оставим только \
         |ν| < c — и быстрого пакета нет: в потерянном ровно столько энергии, сколько отрезано по частоте (Парсеваль).",
    ),
    params: &[Param::real("c", &CUTOFF, 2.0, 0.25, 5.0, "")],
    build: |params| transform(params.real("c")),
};

fn transform(cutoff: f64) -> Result<Figure> {
    let slow = Shifted::new(-1.5, Modulated::new(0.75, Gaussian::new(1.3)?)?)?;
    let fast = Shifted::new(1.5, Modulated::new(3.0, Gaussian::new(1.1)?)?)?;
    let f = Sum(slow, fast);
    // both packets are below rounding beyond ±7, both spectra beyond ±7: rate 64 sees no copy
    let samples = Samples::of(&f, Axis::centered(1.0 / 64.0, 1024)?);
    let bins = forward(&samples);
    let kept = |nu: f64| nu.abs() < cutoff;
    let passed = bins.axis().iter().zip(bins.values()).map(|(nu, v)| if kept(nu) { *v } else { Complex::ZERO });
    let back = inverse(&Bins::new(bins.space(), passed.collect())?);
    let residual: Vec<[f64; 2]> = samples.points().zip(back.values()).map(|([x, v], b)| [x, v - b]).collect();

    let (end, limit) = (3.6, 5.2);
    let shown = |points: Vec<[f64; 2]>| points.into_iter().filter(move |p| p[0].abs() <= end);
    let signal_panel = Panel::new("signal", text!("signal f", "сигнал f"), space(-end, end), values("f(x)", -1.3, 1.3))
        .with(signal_curve("signal", Meaning::Signal, &f, -end, end).thick());
    let spectrum = f.spectrum();
    let magnitudes: Vec<[f64; 2]> = bins.magnitudes().filter(|p| p[0].abs() <= limit).collect();
    let kept_area = magnitudes.iter().copied().filter(|p| kept(p[0]));
    let spectrum_panel = Panel::new(
        "spectrum",
        text!("its spectrum", "его спектр"),
        frequency(-limit, limit),
        values("|F(ν)|", 0.0, 0.85),
    )
    .legend(Legend::Above)
    .with(Layer::area("kept", Meaning::Reconstructed, kept_area).label(text!("kept", "оставлено")))
    .with(
        Layer::line("magnitude", Meaning::Signal, magnitudes.iter().copied())
            .thick()
            .label(text!("|F| by FFT", "|F|, БПФ")),
    )
    .with(Layer::verticals("cutoff", Meaning::Guide, [-cutoff, cutoff]).dashed());
    let back_panel = Panel::new(
        "resynthesis",
        text!("from |ν| < {} alone", "только из |ν| < {}", number(cutoff, 3)),
        space(-end, end),
        values("f(x)", -1.3, 1.3),
    )
    .with(signal_curve("signal", Meaning::Signal, &f, -end, end).dashed().thin())
    .with(Layer::line("resynthesis", Meaning::Reconstructed, shown(back.points().collect())).thick());
    let lost_panel = Panel::new(
        "residual",
        text!("what is missing", "чего недостаёт"),
        space(-end, end),
        Scale::linear(text!("error", "ошибка"), -1.3, 1.3),
    )
    .with(Layer::line("residual", Meaning::Error, shown(residual.clone())).thick());

    let step = samples.axis().step();
    let total: f64 = samples.values().iter().map(|v| v * v).sum::<f64>() * step;
    let lost: f64 = residual.iter().map(|p| p[1] * p[1]).sum::<f64>() * step;
    let outside = bins.axis().iter().zip(bins.values()).filter(|(nu, _)| !kept(*nu));
    let cut: f64 = outside.map(|(_, v)| v.norm_sqr()).sum::<f64>() / samples.axis().span();
    let fft = 8.0 * f64::EPSILON * (samples.values().len() as f64).log2();
    let size: f64 = samples.values().iter().map(|v| v.abs()).sum::<f64>() * step;
    let closed = bins.axis().iter().zip(bins.values()).map(|(nu, v)| (v - spectrum.density(nu)).norm());
    let twice = forward_complex(bins.axis(), bins.values())?;
    let n = samples.values().len();
    let mirrored = twice.values().iter().enumerate().map(|(j, v)| (v - samples.values()[(n - j) % n]).norm());
    Ok(Figure::new(2)
        .with(signal_panel)
        .with(spectrum_panel)
        .with(back_panel)
        .with(lost_panel)
        .claim(
            text!("all frequencies together give the signal back", "все частоты вместе возвращают сигнал"),
            round_trip(&samples),
        )
        .claim(
            text!(
                "the energy is {} in space and in frequency",
                "энергия в пространстве и по частоте равна {}",
                number(total, 4)
            ),
            parseval_of_samples(&samples),
        )
        .claim(
            text!(
                "the missing part holds {} % of the energy, as much as was cut away in frequency",
                "в недостающем {} % энергии — столько же, сколько отрезано по частоте",
                // beyond the spectrum's end only rounding is cut away
                number(100.0 * (lost / total * 1e4).round() / 1e4, 4)
            ),
            // the residual is known to the rounding of two FFTs, its energy to twice that
            Residual::near("energy of the residual = energy cut away", lost, cut, 4.0 * fft * total),
        )
        .claim(
            text!("the FFT of the samples is the closed form", "БПФ отсчётов совпадает с формулой"),
            Residual::at_most("FFT − closed form", closed.fold(0.0, f64::max), fft * size),
        )
        .claim(
            text!(
                "transformed twice, the signal comes back mirrored: f(−x)",
                "после двух преобразований сигнал возвращается зеркальным: f(−x)"
            ),
            // Σ|F|·Δν bounds the second transform's terms, and the first one's error comes through it
            Residual::at_most(
                "F{F{f}}(x) = f(−x)",
                mirrored.fold(0.0, f64::max),
                2.0 * fft * (size + bins.magnitudes().map(|p| p[1]).sum::<f64>() / samples.axis().span()),
            ),
        ))
}

const EULER: Entry = Entry {
    id: "f12-euler",
    inventory: &["F12"],
    errata: &[],
    title: &Text::fixed("Euler's formula: a helix and its shadows", "Формула Эйлера: винтовая линия и её тени"),
    caption: &Text::fixed(
        "e^{i2πνx} = cos 2πνx + i·sin 2πνx turns about the x axis, ν times per unit; the transform asks how much of every \
         such helix is in a signal. Its shadow on the back wall is the cosine (the real part), on the floor the sine (the \
         imaginary part). A negative frequency turns the other way; the two together make a real wave.",
        "e^{i2πνx} = cos 2πνx + i·sin 2πνx вращается вокруг оси x, ν оборотов на единицу; преобразование спрашивает, сколько \
         каждой такой линии в сигнале. Тень на задней стене — косинус (вещественная часть), на полу — синус (мнимая часть). \
         При отрицательной частоте вращение обратное; вместе они дают вещественную волну.",
    ),
    params: &[Param::real("nu", &TURNS, 1.0, -3.0, 3.0, "")],
    build: |params| euler(params.real("nu")),
};

fn euler(nu: f64) -> Result<Figure> {
    let (end, wall) = (3.0, 1.35);
    let helix = |x: f64| Complex::cis(2.0 * PI * nu * x);
    // seen obliquely: the imaginary axis comes towards the viewer, to the left and down
    let seen = |x: f64, re: f64, im: f64| [x - 0.3 * im, re - 0.3 * im];
    let at = |i: usize| end * i as f64 / PIECES as f64;
    let path = |place: &dyn Fn(f64, Complex<f64>) -> [f64; 2]| -> Vec<[f64; 2]> {
        (0..=PIECES).map(at).map(|x| place(x, helix(x))).collect()
    };
    let corner = |x: f64, re: f64, im: f64| seen(x, re * wall, im * wall);
    // floor and back wall, as one stroke each
    let floor = [(0.0, 1.0), (end, 1.0), (end, -1.0), (0.0, -1.0), (0.0, 1.0)].map(|(x, im)| corner(x, -1.0, im));
    let back = [(0.0, -1.0), (end, -1.0), (end, 1.0), (0.0, 1.0), (0.0, -1.0)].map(|(x, re)| corner(x, re, -1.0));
    // from the axis to the helix, eight a unit: the turning hand
    let hand = |i: u32| {
        let x = f64::from(i) / 8.0;
        [seen(x, 0.0, 0.0), seen(x, helix(x).re, helix(x).im), [x, f64::NAN]]
    };
    let spokes = (0..=24).flat_map(hand);
    let room = Panel::new(
        "helix",
        text!("e^{{i2πνx}}", "e^{{i2πνx}}"),
        Scale::linear(Text::EMPTY, -0.5, end + 0.5).bare(),
        Scale::linear(Text::EMPTY, -1.95, 1.95).bare(),
    )
    .span(2)
    .legend(Legend::Above)
    .with(Layer::line("floor", Meaning::Guide, floor).thin())
    .with(Layer::line("back wall", Meaning::Guide, back).thin())
    .with(Layer::line("spokes", Meaning::Guide, spokes).thin())
    .with(Layer::line("axis", Meaning::Guide, [seen(0.0, 0.0, 0.0), seen(end, 0.0, 0.0)]).dashed())
    .with(
        Layer::line("shadow on the wall", Meaning::Series(1), path(&|x, z| seen(x, z.re, -wall)))
            .label(text!("real part: cosine", "вещественная часть: косинус")),
    )
    .with(
        Layer::line("shadow on the floor", Meaning::Series(2), path(&|x, z| seen(x, -wall, z.im)))
            .label(text!("imaginary part: sine", "мнимая часть: синус")),
    )
    .with(Layer::line("helix", Meaning::Signal, path(&|x, z| seen(x, z.re, z.im))).thick());
    let flat = |name: &'static str, title: Text, meaning: Meaning, points: Vec<[f64; 2]>| {
        Panel::new(name, title, space(0.0, end), Scale::linear(Text::EMPTY, -1.4, 1.4))
            .with(Layer::horizontals("zero", Meaning::Guide, [0.0]).thin())
            .with(Layer::line("wave", meaning, points).thick())
    };
    let cosine = path(&|x, z| [x, z.re]);
    let sine = path(&|x, z| [x, z.im]);
    // both sides know the angle 2πνx ≤ 18π to 3 roundings
    let bound = 4.0 * f64::EPSILON * (1.0 + 2.0 * PI * nu.abs() * end);
    let real = cosine.iter().map(|[x, y]| (y - cos_pi(2.0 * nu * x)).abs()).fold(0.0, f64::max);
    let imaginary = sine.iter().map(|[x, y]| (y - sin_pi(2.0 * nu * x)).abs()).fold(0.0, f64::max);
    let pair = |x: f64| 0.5 * (helix(x) + Complex::cis(-2.0 * PI * nu * x));
    let both = (0..=PIECES).map(at).map(|x| (pair(x) - cos_pi(2.0 * nu * x)).norm()).fold(0.0, f64::max);
    Ok(Figure::new(2)
        .heights([5.0, 2.0])
        .with(room)
        .with(flat("cosine", text!("Re: cos 2πνx", "Re: cos 2πνx"), Meaning::Series(1), cosine))
        .with(flat("sine", text!("Im: sin 2πνx", "Im: sin 2πνx"), Meaning::Series(2), sine))
        .claim(
            text!("the two shadows are the cosine and the sine", "две тени — косинус и синус"),
            Residual::at_most("e^{iφ} = cos φ + i·sin φ", real.max(imaginary), bound),
        )
        .claim(
            text!(
                "half of ν and half of −ν make the real wave cos 2πνx",
                "половина ν и половина −ν дают вещественную волну cos 2πνx"
            ),
            Residual::at_most("½(e^{iφ} + e^{−iφ}) = cos φ", both, bound),
        ))
}
