//! Sampling and reconstruction at one view, in space and in frequency (slides «Сэмплинг и реконструкция», «Алиасинг»).

use crate::axis::Axis;
use crate::comb::Comb;
use crate::error::Result;
use crate::figure::common::{PIECES, density_curve, difference, frequency, line_arrows, signal_curve, space, unmarked};
use crate::figure::params::Param;
use crate::figure::{Entry, Figure, Layer, Meaning, Panel};
use crate::kernel::ideal::Ideal;
use crate::laws::alias::{leaked_spectrum, pointwise_alias};
use crate::laws::poisson::{comb_pairing, copies_by_fft, poisson_summation, raised_cosine_tail};
use crate::laws::theorems::pair_by_quadrature;
use crate::num::sinc;
use crate::nyquist::Verdict;
use crate::reconstruct::reconstruct;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::signal::boxcar::Boxcar;
use crate::signal::gaussian::Gaussian;
use crate::signal::raised_cosine::RaisedCosine;
use crate::signal::{FourierPair, Signal};
use crate::spectrum::low_pass;
use crate::text;
use crate::text::{Text, number};

static STEP: Text = Text::fixed("sampling step T", "шаг дискретизации T");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[OVERVIEW, UNDERSAMPLED];

const OVERVIEW: Entry = Entry {
    id: "f25-overview",
    inventory: &["F25"],
    errata: &["E03", "E20"],
    title: &Text::fixed("Sampling and reconstruction", "Сэмплинг и реконструкция"),
    caption: &Text::fixed(
        "Above in space, below in frequency; what is a product in one row is a convolution in the other. Times the comb: \
         the samples, and copies of the spectrum, of gain 1 (not 1/T, as the table of pairs has it). Convolved with r: the \
         signal again, and one copy cut out. It works because the copies do not overlap.",
        "Сверху — пространство, снизу — частота; произведение в одной строке — свёртка в другой. Умножили на гребень Дирака \
         — получили отсчёты и копии спектра с усилением 1 (а не 1/T, как в таблице). Свернули с r — получили снова сигнал, \
         одна копия вырезана. Это возможно, потому что копии не перекрываются.",
    ),
    params: &[Param::real("T", &STEP, 0.4, 0.2, 0.5, "")],
    build: |params| overview(params.real("T")),
};

const UNDERSAMPLED: Entry = Entry {
    id: "f26-undersampled",
    inventory: &["F26"],
    errata: &["E07"],
    title: &Text::fixed("Aliasing: what if the copies overlap?", "Алиасинг: что, если копии пересекаются?"),
    caption: &Text::fixed(
        "The same chain with too large a step T: the copies are 1/T apart, closer than the signal's spectrum is wide, and \
         overlap (shaded). The low-pass then cuts out a wrong spectrum, and the curve through the same samples is another \
         function.",
        "Та же цепочка со слишком большим шагом T: копии отстоят на 1/T — меньше ширины спектра сигнала — и перекрываются \
         (закрашено). Тогда фильтр вырезает уже неверный спектр, и кривая через те же отсчёты — другая функция.",
    ),
    params: &[Param::real("T", &STEP, 0.8, 0.55, 1.25, "")],
    build: |params| overview(params.real("T")),
};

/// The band of the signal.
const BAND: f64 = 1.0;
/// Where space is shown, to either side of zero.
const REACH: f64 = 2.2;

fn overview(step: f64) -> Result<Figure> {
    let f = RaisedCosine::new(BAND)?;
    let comb = Comb::new(step)?;
    let (rate, half) = (comb.rate(), 0.5 * comb.rate());
    let verdict = Verdict::on(&f.spectrum(), rate)?;
    let overlap = match verdict {
        Verdict::Aliased { overlap } => Some(overlap),
        _ => None,
    };
    let limit = (1.6 * rate).max(3.0);
    let order = ((limit + BAND) / rate).ceil() as usize;
    let spectrum = f.spectrum();
    let copies = spectrum.replicated(rate, order)?;
    let kept = leaked_spectrum(&spectrum, step)?;

    let last = (REACH / step).floor() as i64;
    let impulses = comb.times(&f, -last..=last).into_iter().map(|i| [i.at, i.weight.re]);
    let record = Samples::of(&f, Axis::centered(step, 2 * 200 + 1)?);
    let back = reconstruct(&record, Ideal);
    let dots = record.points().filter(|[x, _]| x.abs() <= REACH);
    let zero = || Layer::horizontals("zero", Meaning::Guide, [0.0]).thin();
    let upper = |name, title, scale: f64| {
        Panel::new(name, title, space(-REACH, REACH), unmarked(-0.32 * scale, 1.2 * scale)).with(zero())
    };
    let top = if overlap.is_some() { 1.35 } else { 1.2 };
    let lower = |name, title| Panel::new(name, title, frequency(-limit, limit), unmarked(-0.08, top)).with(zero());
    let signal = || signal_curve("signal", Meaning::Signal, &f, -REACH, REACH);
    let own = || density_curve("signal", Meaning::Signal, &spectrum, -limit, limit);
    let result = signal_curve("result", Meaning::Reconstructed, &back, -REACH, REACH).thick();
    let filter = Layer::curve("filter", Meaning::Kernel, -REACH, REACH, PIECES, |x| sinc(x / step) / step);

    let sum = density_curve("sum", Meaning::Replica, &copies, -limit, limit);
    let sum = if overlap.is_some() { sum.thick() } else { sum };
    let mut replicas = lower("copies", text!("= copies", "= копии"));
    if let Some([low, high]) = overlap {
        replicas = replicas.with(Layer::spans("overlap", Meaning::Leaked, [[-high, -low], [low, high]]));
        for k in -(order as i64)..=order as i64 {
            let copy = spectrum.translated(k as f64 * rate);
            replicas = replicas.with(density_curve("copy", Meaning::Replica, &copy, -limit, limit).thin());
        }
    }
    let inside = |i: usize| -half + 2.0 * half * i as f64 / PIECES as f64;
    let tails = (1..PIECES).map(|i| [inside(i), spectrum.density(inside(i)).re, kept.density(inside(i)).re]);
    let mut outcome = lower("result-spectrum", text!("= F̃", "= F̃"));
    if overlap.is_some() {
        outcome = outcome.with(Layer::between("leaked", Meaning::Leaked, tails));
    }

    let figure = Figure::new(5)
        .with(upper("signal", text!("space: f", "пространство: f"), 1.0).with(signal()))
        .with(upper("comb", text!("× Ш_{{T}}", "× Ш_{{T}}"), step).with(Layer::arrows(
            "comb",
            Meaning::Samples,
            (-last..=last).map(|i| [i as f64 * step, step]),
        )))
        .with(
            upper("product", text!("= f·Ш_{{T}}", "= f·Ш_{{T}}"), step)
                .with(Layer::curve("envelope", Meaning::Guide, -REACH, REACH, PIECES, |x| step * f.at(x)).dashed())
                .with(Layer::arrows("product", Meaning::Samples, impulses)),
        )
        .with(upper("filter", text!("⊗ r", "⊗ r"), rate).with(filter))
        .with(upper("result", text!("= f̃", "= f̃"), 1.0).with(result.clone()).with(signal().dashed()).with(Layer::dots(
            "samples",
            Meaning::Samples,
            dots,
        )))
        .with(lower("spectrum", text!("frequency: F", "частота: F")).with(own()))
        .with(lower("comb-spectrum", text!("⊗ Σδ(ν − k/T)", "⊗ Σδ(ν − k/T)")).with(line_arrows(
            "lines",
            Meaning::Samples,
            &comb.spectrum((limit * step).floor() as usize),
        )))
        .with(replicas.with(sum))
        .with(lower("filter-spectrum", text!("× Π_{{1/T}}", "× Π_{{1/T}}")).with(Layer::curve(
            "response",
            Meaning::Kernel,
            -limit,
            limit,
            4 * PIECES,
            |nu| low_pass(nu, half),
        )))
        .with(
            outcome
                .with(density_curve("result", Meaning::Reconstructed, &kept, -limit, limit).thick())
                .with(own().dashed()),
        );
    pairs(figure, &f, step, &result, overlap)
}

/// The claims: every lower panel is the transform of the one above it, and what became of the signal.
fn pairs(figure: Figure, f: &RaisedCosine, step: f64, result: &Layer, overlap: Option<[f64; 2]>) -> Result<Figure> {
    let (rate, terms) = (1.0 / step, 2000);
    let spectrum = f.spectrum();
    let kept = leaked_spectrum(&spectrum, step)?;
    let nu: Vec<f64> = (0..=32).map(|i| rate * (f64::from(i) / 32.0 - 0.5)).collect();
    let x: Vec<f64> = (0..=16).map(|i| REACH * f64::from(i) / 16.0).collect();
    let tail = raised_cosine_tail(BAND, step, terms);
    let order = ((0.5 * rate + BAND) / rate).ceil() as usize;
    let fine = 0.25 / BAND;
    let long = Samples::of(f, Axis::centered(step, 2 * terms + 1)?);
    let long = reconstruct(&long, Ideal);
    let mut apart = 0.0f64;
    for &x in &x {
        apart = apart.max((kept.inverse_at(x)?.re - long.at(x)).abs());
    }
    let figure = figure
        .claim(
            text!("column 1: F is the transform of f, by FFT", "столбец 1: F — преобразование f, по БПФ"),
            copies_by_fft(f, Axis::centered(fine, 4097)?, 1, raised_cosine_tail(BAND, fine, 2048))?,
        )
        .claim(
            text!(
                "column 2: lines of weight 1 at k/T are the transform of the comb of weights T",
                "столбец 2: линии веса 1 в точках k/T — преобразование гребня с весами T"
            ),
            comb_pairing(&Gaussian::new(0.6)?, step, 60, 1.0)?,
        )
        .claim(
            text!(
                "column 3: the copies are the transform of the product",
                "столбец 3: копии — преобразование произведения"
            ),
            poisson_summation(f, step, terms, order, &nu, tail)?,
        )
        .claim(
            text!("column 4: the box is the transform of r", "столбец 4: прямоугольник — преобразование r"),
            pair_by_quadrature(&Boxcar::new(rate)?, &[-0.5 * rate, 0.5 * rate], &x, 0.0),
        )
        .claim(
            text!(
                "column 5: what the low-pass left is the transform of the sum of sincs",
                "столбец 5: то, что оставил фильтр, — преобразование суммы sinc"
            ),
            // the samples left out, and the rounding of series and quadrature
            Residual::at_most("low-passed copies = cardinal series", apart, tail / step + 1e-13),
        );
    Ok(match overlap {
        None => {
            let error = result.points().iter().map(|p| (p[1] - f.at(p[0])).abs()).fold(0.0, f64::max);
            figure.claim(
                text!(
                    "the copies are {} apart and {} wide: the result is the signal",
                    "копии отстоят на {} при ширине {}: результат равен сигналу",
                    number(rate, 4),
                    number(2.0 * BAND, 4)
                ),
                Residual::at_most("f̃ = f", error, raised_cosine_tail(BAND, step, 200) / step),
            )
        }
        Some([low, high]) => {
            // the first frequency of the drawn spectrum that a neighbour reaches
            let neighbour = spectrum.translated(rate);
            let drawn = figure.panel("copies").and_then(|p| p.layer("sum")).map(|l| l.points().to_vec());
            let drawn = drawn.unwrap_or_default();
            let piece = drawn.windows(2).map(|w| w[1][0] - w[0][0]).fold(0.0, f64::max);
            let reached = drawn.iter().map(|p| p[0]).filter(|&nu| nu > 0.0 && neighbour.density(nu).re > 0.0);
            let first = reached.fold(f64::INFINITY, f64::min);
            let tail = raised_cosine_tail(BAND, step, 400) / step;
            let own = figure.panel("result").and_then(|p| p.layer("signal"));
            let worst = own.map_or(f64::NAN, |own| difference(result, own));
            let law = pointwise_alias(f, step, 400, &x, tail)?;
            figure
                .claim(
                    text!(
                        "the copies overlap for |ν| from {} to {}",
                        "копии перекрываются при |ν| от {} до {}",
                        number(low, 4),
                        number(high, 4)
                    ),
                    Residual::near("overlap starts at 1/T − B", first, low, piece),
                )
                .claim(
                    text!(
                        "the result is off by up to {}, not more than twice the spectrum beyond 1/(2T), {}",
                        "результат ошибается до {}, не больше удвоенного спектра за 1/(2T), {}",
                        number(worst, 3),
                        number(law.bound, 3)
                    ),
                    Residual::at_most("|f̃ − f| ≤ 2∫|F| beyond 1/(2T) (V08)", worst.max(law.measured), law.bound),
                )
        }
    })
}
