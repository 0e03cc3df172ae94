//! Sampling in frequency: the copies of the spectrum (slides «Сэмплирование в спектральном пространстве»).

use crate::axis::Axis;
use crate::comb::Comb;
use crate::error::Result;
use crate::figure::common::{density_curve, difference, frequency, line_arrows, peak, signal_curve, space, values};
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Meaning, Panel, Scale};
use crate::laws::poisson::{comb_pairing, copies_by_fft, poisson_summation};
use crate::num::extremum::maximum;
use crate::nyquist::Verdict;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::sampled::dft::forward;
use crate::sampled::dtft::dtft;
use crate::signal::FourierPair;
use crate::signal::constant::Constant;
use crate::signal::gaussian::Gaussian;
use crate::signal::raised_cosine::RaisedCosine;
use crate::spectrum::Spectrum;
use crate::text;
use crate::text::{Text, number};

static STEP: Text = Text::fixed("sampling step T", "шаг дискретизации T");
static BAND: Text = Text::fixed("band limit B of the signal", "граница полосы сигнала B");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[INGREDIENTS, REPLICAS, CLOSER];

/// How many copies reach into `|ν| ≤ limit`.
pub(in crate::figure) fn order(spectrum: &Spectrum, rate: f64, limit: f64) -> usize {
    ((spectrum.extent() + limit) / rate).ceil() as usize
}

const INGREDIENTS: Entry = Entry {
    id: "f18-ingredients",
    inventory: &["F18"],
    errata: &["E02", "E10"],
    title: &Text::fixed(
        "Sampling seen in frequency: the two factors",
        "Дискретизация в частотной области: сомножители",
    ),
    caption: &Text::fixed(
        "Sampling multiplies the signal by the comb of step T, so in frequency their spectra are convolved: the signal's \
         spectrum, here within ±B, and the comb's, which is a comb of step 1/T. With Ш_{T} = T·Σδ(x − iT) each of its lines \
         weighs 1, whatever T. (Multiplied is the signal by the comb, not «by the comb of the spectrum».)",
        "Дискретизация умножает сигнал на гребень с шагом T, поэтому по частоте спектры сворачиваются: спектр сигнала, здесь \
         внутри ±B, и спектр гребня — гребень с шагом 1/T. При Ш_{T} = T·Σδ(x − iT) каждая его линия весит 1 при любом T. \
         (Сигнал умножается на гребень, а не «на гребенку спектра».)",
    ),
    params: &[Param::real("T", &STEP, 0.8, 0.5, 2.0, ""), Param::real("B", &BAND, 0.35, 0.2, 0.5, "")],
    build: ingredients,
};

fn ingredients(params: &Params) -> Result<Figure> {
    let (step, band) = (params.real("T"), params.real("B"));
    let (f, comb) = (RaisedCosine::new(band)?, Comb::new(step)?);
    let (end, limit) = (5.2, 2.7);
    let teeth = (end / step).floor() as i64;
    let impulses = comb.times(&Constant::new(1.0)?, -teeth..=teeth);
    let lines = comb.spectrum((limit * step).floor() as usize);
    let comb_lines = line_arrows("lines", Meaning::Samples, &lines);
    let spacing = comb_lines.points().windows(2).map(|w| (w[1][0] - w[0][0] - 1.0 / step).abs()).fold(0.0, f64::max);
    let weight = |high: f64| Scale::linear(text!("weight", "вес"), 0.0, high);
    Ok(Figure::new(2)
        .with(
            Panel::new(
                "signal",
                text!("signal f", "сигнал f"),
                space(-end, end),
                values("f(x)", -0.15 * band, 1.2 * band),
            )
            .with(signal_curve("signal", Meaning::Signal, &f, -end, end).thick()),
        )
        .with(
            Panel::new(
                "spectrum",
                text!("its spectrum F", "его спектр F"),
                frequency(-limit, limit),
                values("F(ν)", 0.0, 1.3),
            )
            .with(density_curve("spectrum", Meaning::Signal, &f.spectrum(), -limit, limit).thick()),
        )
        .with(
            Panel::new(
                "comb",
                text!("comb of step T = {}", "гребень с шагом T = {}", number(step, 3)),
                space(-end, end),
                weight(1.3 * step),
            )
            .with(Layer::arrows("comb", Meaning::Samples, impulses.iter().map(|i| [i.at, i.weight.re]))),
        )
        .with(
            Panel::new(
                "comb spectrum",
                text!("its lines: step 1/T = {}", "его линии: шаг 1/T = {}", number(1.0 / step, 3)),
                frequency(-limit, limit),
                weight(1.3),
            )
            .with(comb_lines),
        )
        .claim(
            text!("the lines stand 1/T = {} apart", "линии отстоят на 1/T = {}", number(1.0 / step, 4)),
            // positions up to 2.7 are rounded to ε·2.7
            Residual::at_most("spacing − 1/T", spacing, 4.0 * f64::EPSILON * limit),
        )
        .claim(
            text!(
                "each line weighs 1: T·Σφ(iT) = ΣΦ(k/T) for a test function φ",
                "каждая линия весит 1: T·Σφ(iT) = ΣΦ(k/T) для пробной функции φ"
            ),
            comb_pairing(&Gaussian::new(0.6)?, step, 60, 1.0)?,
        ))
}

const REPLICAS: Entry = Entry {
    id: "f19-replicas",
    inventory: &["F19"],
    errata: &["E03", "E19"],
    title: &Text::fixed("Sampling copies the spectrum", "Дискретизация размножает спектр"),
    caption: &Text::fixed(
        "Convolved with the comb's lines the spectrum is repeated at every k/T, with gain 1: convolution with δ(ν − k/T) is a \
         shift by k/T. The same copies come out three independent ways: by adding shifted copies, from the samples alone by \
         their Fourier sum, and by an FFT of a long record.",
        "Свёрнутый с линиями гребня спектр повторяется в каждом k/T с усилением 1: свёртка с δ(ν − k/T) есть сдвиг на k/T. Те \
         же копии получаются тремя независимыми путями: сложением сдвинутых копий, из одних отсчётов — суммой Фурье, и БПФ \
         длинной записи.",
    ),
    params: &[Param::real("T", &STEP, 1.0, 0.5, 2.0, "")],
    build: |params| replicas(params.real("T")),
};

fn replicas(step: f64) -> Result<Figure> {
    let f = Gaussian::with_spectrum(50.0)?;
    let (spectrum, rate, limit) = (f.spectrum(), 1.0 / step, 4.4);
    let order = order(&spectrum, rate, limit);
    let copies = spectrum.replicated(rate, order)?;
    // f falls to rounding of its peak within |x| = 15, and so do the records
    let terms = (16.0 / step).ceil() as usize;
    let samples = Samples::of(&f, Axis::centered(step, 2 * terms + 1)?);
    let record = Axis::centered(step, 2 * (16.0 / step).ceil() as usize)?;
    let bins = forward(&Samples::of(&f, record));
    let panel =
        |name: &'static str, title: Text| Panel::new(name, title, frequency(-limit, limit), values("F(ν)", 0.0, 1.25));
    let shifted = density_curve("copies", Meaning::Replica, &copies, -limit, limit);
    let end = spectrum.extent().min(0.5 * rate);
    let own = density_curve("own", Meaning::Signal, &spectrum, -end, end).thick();
    let summed = density_curve(
        "dtft",
        Meaning::Replica,
        &Spectrum::decaying(f64::INFINITY, move |nu| dtft(&samples, nu)),
        -limit,
        limit,
    );
    let count = (limit * record.span()).floor() as i64;
    let repeated = (-count..=count).map(|k| k as f64 / record.span()).map(|nu| [nu, bins.near(nu).re]);
    let apart = difference(&shifted, &summed);
    let height = peak(&shifted);
    let frequencies: Vec<f64> = (-40..=40).map(|i| 0.1 * f64::from(i)).collect();
    let neighbours = copies.density(0.0).re;
    Ok(Figure::new(1)
        .heights([1.0, 1.0, 1.28])
        .with(
            panel("copies", text!("ΣF(ν − k/T): shifted copies added up", "ΣF(ν − k/T): сумма сдвинутых копий"))
                .with(shifted.thick())
                .with(own),
        )
        .with(
            panel("dtft", text!("TΣf(kT)e^{{−i2πνkT}}: from the samples", "TΣf(kT)e^{{−i2πνkT}}: из отсчётов"))
                .with(summed.thick()),
        )
        .with(
            panel("fft", text!("FFT of a record of {} samples", "БПФ записи из {} отсчётов", record.len()))
                .with(Layer::dots("fft", Meaning::Samples, repeated)),
        )
        .claim(
            text!(
                "the samples' Fourier sum is the sum of the copies (Poisson)",
                "сумма Фурье отсчётов равна сумме копий (Пуассон)"
            ),
            poisson_summation(&f, step, terms, order, &frequencies, 0.0)?,
        )
        .claim(
            text!("so is the FFT of the long record", "и БПФ длинной записи тоже"),
            copies_by_fft(&f, record, order, 0.0)?,
        )
        .claim(
            text!("the two drawn curves are one", "две нарисованные кривые — одна и та же"),
            // the sum of 2·terms + 1 products, each with an angle 2πνx known to 3ε·2π·4.4·16
            Residual::at_most("curve (i) − curve (ii)", apart, (4 * terms + 1600) as f64 * f64::EPSILON),
        )
        .claim(
            text!(
                "the copies are as high as F itself: gain 1, not 1/T = {}",
                "копии той же высоты, что и F: усиление 1, а не 1/T = {}",
                number(rate, 3)
            ),
            // f is nowhere negative, so its Fourier sum is largest at zero, where the drawn grid has a point
            Residual::near(
                "height of the copies = F(0) + neighbours' tails",
                height,
                neighbours,
                64.0 * f64::EPSILON * neighbours,
            ),
        ))
}

const CLOSER: Entry = Entry {
    id: "f20-closer",
    inventory: &["F20"],
    errata: &["E07"],
    title: &Text::fixed("The larger T, the closer the copies", "Чем больше T, тем ближе копии"),
    caption: &Text::fixed(
        "The same signal sampled with four steps. Its copies stand 1/T apart: the larger the step, the closer they are. Each \
         is 2B wide, so they begin to overlap (shaded) exactly when 1/T falls below 2B.",
        "Один и тот же сигнал, четыре шага дискретизации. Копии его спектра отстоят на 1/T: чем больше шаг, тем они ближе. \
         Ширина каждой 2B, поэтому накладываться (закрашено) они начинают ровно тогда, когда 1/T становится меньше 2B.",
    ),
    params: &[Param::real("B", &BAND, 0.4, 0.2, 0.45, "")],
    build: |params| closer(params.real("B")),
};

fn closer(band: f64) -> Result<Figure> {
    let spectrum = RaisedCosine::new(band)?.spectrum();
    let names = ["T = 0.5", "T = 1", "T = 1.5", "T = 2"];
    let figure = Figure::new(1).heights([1.0, 1.0, 1.0, 1.42]);
    names.into_iter().zip([0.5, 1.0, 1.5, 2.0]).try_fold(figure, |figure, (name, step)| {
        let row = Row::new(&spectrum, step)?;
        let (distance, width) = (row.distance(), row.width());
        Ok(figure.with(row.panel(name)).claim(distance.0, distance.1).claim(width.0, width.1))
    })
}

/// The copies at one step.
struct Row<'a> {
    spectrum: &'a Spectrum,
    step: f64,
    sum: Spectrum,
    /// What neighbours have in common: the lesser of the two, on the drawn grid.
    shared: Vec<[f64; 2]>,
    /// The sum of all copies, on the same grid.
    total: Vec<[f64; 2]>,
    /// `2B − 1/T`, if the copies overlap.
    overlap: Option<f64>,
}

impl<'a> Row<'a> {
    /// Half the width of the panels.
    const LIMIT: f64 = 2.55;
    /// How many pieces they are drawn in.
    const PIECES: usize = 2000;
    /// The length of one.
    const PIECE: f64 = 2.0 * Self::LIMIT / Self::PIECES as f64;

    fn new(spectrum: &'a Spectrum, step: f64) -> Result<Self> {
        let rate = 1.0 / step;
        let sum = spectrum.replicated(rate, order(spectrum, rate, Self::LIMIT))?;
        let at = |i: usize| -Self::LIMIT + i as f64 * Self::PIECE;
        let lesser = |nu: f64| {
            let right_of_copy = nu - rate * (nu / rate).floor();
            spectrum.density(right_of_copy).re.min(spectrum.density(right_of_copy - rate).re)
        };
        let overlap = match Verdict::on(spectrum, rate)? {
            Verdict::Aliased { overlap: [low, high] } => Some(high - low),
            _ => None,
        };
        let grid = || (0..=Self::PIECES).map(at);
        let shared = grid().map(|nu| [nu, lesser(nu)]).collect();
        let total = grid().map(|nu| [nu, sum.density(nu).re]).collect();
        Ok(Self { spectrum, step, sum, shared, total, overlap })
    }

    fn rate(&self) -> f64 {
        1.0 / self.step
    }

    fn panel(&self, name: &'static str) -> Panel {
        let (rate, band, limit) = (self.rate(), self.spectrum.band(), Self::LIMIT);
        let sign = if self.overlap.is_some() { "<" } else { "≥" };
        let title = text!(
            "T = {}: 1/T = {} {sign} 2B = {}",
            "T = {}: 1/T = {} {sign} 2B = {}",
            number(self.step, 2),
            number(rate, 3),
            number(2.0 * band, 3)
        );
        // the sum only where it is more than a single copy
        let lifted =
            |(total, shared): (&[f64; 2], &[f64; 2])| [total[0], if shared[1] > 0.0 { total[1] } else { f64::NAN }];
        let mut panel = Panel::new(name, title, frequency(-limit, limit), values("F(ν)", 0.0, 1.25))
            .with(Layer::area("overlap", Meaning::Leaked, self.shared.iter().copied()))
            .with(Layer::line("sum", Meaning::Leaked, self.total.iter().zip(&self.shared).map(lifted)).dashed());
        let count = (limit / rate).ceil() as i64;
        for at in (-count..=count).filter(|k| *k != 0).map(|k| k as f64 * rate) {
            let (from, to) = ((at - band).max(-limit), (at + band).min(limit));
            if from < to {
                panel = panel.with(density_curve("copy", Meaning::Replica, &self.spectrum.translated(at), from, to));
            }
        }
        panel.with(density_curve("own", Meaning::Signal, self.spectrum, -band, band).thick())
    }

    /// The distance of the peaks: found on the drawn grid, refined between its points.
    fn distance(&self) -> (Text, Residual) {
        let rate = self.rate();
        let tops = self.total.windows(3).filter(|w| w[1][1] > w[0][1] && w[1][1] >= w[2][1]);
        let refine = |w: &[[f64; 2]]| maximum(|nu| self.sum.density(nu).re, w[0][0], w[2][0], 2).at;
        let tops: Vec<f64> = tops.map(refine).collect();
        let off = tops.windows(2).map(|w| (w[1] - w[0] - rate).abs()).fold(0.0, f64::max);
        let distances = tops.len().saturating_sub(1) as f64;
        let mean = tops.last().zip(tops.first()).map_or(f64::NAN, |(last, first)| (last - first) / distances);
        let says = text!(
            "T = {}: the peaks are {} apart, that is 1/T",
            "T = {}: расстояние между вершинами {}, то есть 1/T",
            number(self.step, 2),
            number(mean, 4)
        );
        // F ≈ 1 − (πδ/2B)²: a peak is found to √(4ε)·2B/π < 1.3√ε·B, a distance to twice that
        let bound = 3.0 * f64::EPSILON.sqrt() * self.spectrum.band();
        let residual = Residual::at_most("peak distance − 1/T", off, bound);
        // less than two peaks have no distance
        (says, if mean.is_finite() { residual } else { Residual { measured: f64::NAN, ..residual } })
    }

    /// The width of the overlap between the copy at zero and its right neighbour, counted on the drawn grid.
    fn width(&self) -> (Text, Residual) {
        let (rate, twice) = (self.rate(), 2.0 * self.spectrum.band());
        let between = self.shared.iter().filter(|p| 0.0 < p[0] && p[0] < rate && p[1] > 0.0).count();
        let says = match self.overlap {
            None => text!(
                "T = {}: 1/T ≥ 2B = {}, no overlap",
                "T = {}: 1/T ≥ 2B = {}, наложения нет",
                number(self.step, 2),
                number(twice, 3)
            ),
            Some(width) => text!(
                "T = {}: 1/T < 2B = {}, neighbours overlap over 2B − 1/T = {}",
                "T = {}: 1/T < 2B = {}, соседи накладываются на ширине 2B − 1/T = {}",
                number(self.step, 2),
                number(twice, 3),
                number(width, 3)
            ),
        };
        let drawn = between as f64 * Self::PIECE;
        (says, Residual::near("drawn overlap = 2B − 1/T", drawn, self.overlap.unwrap_or(0.0), Self::PIECE))
    }
}
