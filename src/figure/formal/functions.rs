//! Functions and their spectra (slide «Формализация», figures 7.2 and 7.3 of the source).

use crate::axis::Axis;
use crate::error::Result;
use crate::figure::common::{density_curve, frequency, signal_curve, space, values};
use crate::figure::params::{Param, Params};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::num::extremum::maximum;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::sampled::dft::forward;
use crate::signal::lecture::{HighBump, LowBump};
use crate::signal::theorem::Stretched;
use crate::signal::{FourierPair, Signal};
use crate::spectrum::Spectrum;
use crate::text;
use crate::text::{Lang, Text, number};
use std::f64::consts::PI;

static STRETCH: Text = Text::fixed("stretch c: f(x/c) is shown", "растяжение c: показано f(x/c)");
static RECORD: Text = Text::fixed("half-length X of the record", "половина длины записи X");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[FUNCTIONS, SPECTRA];

const FUNCTIONS: Entry = Entry {
    id: "f09-functions",
    inventory: &["F09"],
    errata: &["E31"],
    title: &Text::fixed("Low-frequency and high-frequency functions", "Низкочастотная и высокочастотная функции"),
    caption: &Text::fixed(
        "The higher the frequencies in a function, the faster it varies. Each curve is the closed form; the dots are its \
         spectrum (next figure) transformed back numerically. (In the source the right-hand curve is not the transform \
         of the spectrum printed for it: it starts at a minimum, and a spectrum that is nowhere negative has its peak \
         at 0. Ours is a true pair.)",
        "Чем выше частоты в функции, тем быстрее она меняется. Каждая кривая — формула в замкнутом виде, точки — её спектр \
         (следующий рисунок), численно преобразованный обратно. (В источнике правая кривая не есть преобразование \
         напечатанного для неё спектра: она начинается с минимума, а при неотрицательном спектре максимум стоит в нуле. \
         Здесь пара настоящая.)",
    ),
    params: &[Param::real("c", &STRETCH, 1.0, 0.5, 2.0, "")],
    build: |params| functions(params.real("c")),
};

fn functions(stretch: f64) -> Result<Figure> {
    let [low_title, high_title] = letters();
    let low = function("low", ["a", "а"], low_title, Stretched::new(stretch, LowBump)?)?;
    let high = function("high", ["b", "б"], high_title, Stretched::new(stretch, HighBump)?)?;
    let figure = Figure::new(2).claim(
        text!(
            "first minima: {} of the peak at x = {} (a) and {} at x = {} (b): the faster one turns back first",
            "первые минимумы: {} пика при x = {} (а) и {} при x = {} (б): быстрая функция поворачивает раньше",
            number(low.extrema[0][1] / low.peak, 4),
            number(low.extrema[0][0], 4),
            number(high.extrema[0][1] / high.peak, 4),
            number(high.extrema[0][0], 4)
        ),
        Residual::at_least("the high-frequency function turns back first", low.extrema[0][0], high.extrema[0][0]),
    );
    Ok([low, high].into_iter().fold(figure, |figure, f| {
        let figure = figure.with(f.panel);
        f.claims.into_iter().fold(figure, |figure, (says, residual)| figure.claim(says, residual))
    }))
}

/// What the source calls its two functions.
fn letters() -> [Text; 2] {
    [text!("(a) low frequencies", "(а) низкие частоты"), text!("(b) high frequencies", "(б) высокие частоты")]
}

/// One of the two functions, drawn and examined.
struct Examined {
    panel: Panel,
    peak: f64,
    extrema: [[f64; 2]; 3],
    claims: Vec<(Text, Residual)>,
}

fn function(
    name: &'static str,
    letters: [&str; 2],
    title: Text,
    f: Stretched<impl FourierPair + Copy>,
) -> Result<Examined> {
    let (spectrum, peak, end) = (f.spectrum(), f.at(0.0), 4.0);
    let dots: Vec<[f64; 2]> =
        (0..=20).map(|i| 0.2 * f64::from(i)).map(|x| Ok([x, spectrum.inverse_at(x)?.re])).collect::<Result<_>>()?;
    let worst = dots.iter().map(|[x, v]| (v - f.at(*x)).abs()).fold(0.0, f64::max);

    // the zero is the peak of −|f|; of a spectrum that ends at B the extrema are at most about 1/(2B) apart
    let swing = 0.5 / spectrum.band();
    let zero = maximum(|x| -f.at(x).abs(), 0.0, 2.0 * swing, 64).at;
    let turn = |sign: f64, from: f64| maximum(|x| sign * f.at(x), from, from + 1.6 * swing, 64).at;
    let first = turn(-1.0, zero);
    let second = turn(1.0, first);
    let extrema = [first, second, turn(-1.0, second)].map(|x| [x, f.at(x)]);

    let panel = Panel::new(name, title, space(-0.2, end + 0.2), values("f(x)", 1.3 * extrema[0][1], 1.1 * peak))
        .legend(Legend::Above)
        .with(Layer::horizontals("axis", Meaning::Guide, [0.0]).thin())
        .with(
            signal_curve("closed", Meaning::Signal, &f, -0.2, end + 0.2).thick().label(text!("closed form", "формула")),
        )
        .with(Layer::dots("inverse", Meaning::Theory, dots).label(text!("inverse transform", "обратное ПФ")));
    let turns: Vec<f64> = extrema.iter().map(|[x, _]| *x).filter(|x| *x <= end).collect();
    let panel = panel.with(Layer::verticals("extrema", Meaning::Guide, turns).dashed().thin());
    let highest = panel.layer("closed").map_or(0.0, crate::figure::common::peak);
    let both = |says: &dyn Fn(&str) -> Text| {
        Text::of(says(letters[0]).get(Lang::En).to_owned(), says(letters[1]).get(Lang::Ru).to_owned())
    };
    let claims = vec![
        (
            both(&|letter| {
                text!(
                    "({letter}) the closed form and the numerical inverse transform agree; f(0) = ∫F = {}, first zero at {}",
                    "({letter}) формула и численное обратное преобразование совпадают; f(0) = ∫F = {}, первый нуль при {}",
                    number(peak, 5),
                    number(zero, 5)
                )
            }),
            // the quadrature asks for 1e-15 or 16ε·∫|F| = 16ε·f(0); the closed forms lose at most a factor 13, or e⁴, of ε
            Residual::at_most("closed form = inverse transform", worst, 1e-15 + 128.0 * f64::EPSILON * peak),
        ),
        (
            both(&|letter| {
                text!(
                    "({letter}) F is nowhere negative, so the highest point stands at x = 0",
                    "({letter}) спектр неотрицателен, поэтому наивысшая точка стоит в x = 0"
                )
            }),
            Residual::at_most("|f(x)| ≤ f(0)", highest, peak * (1.0 + 8.0 * f64::EPSILON)),
        ),
    ];
    Ok(Examined { panel, peak, extrema, claims })
}

const SPECTRA: Entry = Entry {
    id: "f10-spectra",
    inventory: &["F10"],
    errata: &["E31"],
    title: &Text::fixed("Their spectra", "Их спектры"),
    caption: &Text::fixed(
        "The two functions in frequency: how much of every frequency ν each contains. The slow one ends at ½ and has no \
         mean at all, the fast one reaches √2. Lines are the closed forms, dots the FFT of sampled f; below, their \
         difference, which is what the record of length 2X leaves out and is largest where F has a corner.",
        "Те же две функции по частоте: сколько вносит каждая частота ν. Спектр медленной функции кончается на ½, а её \
         среднее равно нулю; спектр быстрой доходит до √2. Линии — формулы, точки — БПФ отсчётов f; внизу их разность: то, что не \
         попало в запись длины 2X, и больше всего она там, где у F излом.",
    ),
    params: &[Param::real("X", &RECORD, 100.0, 20.0, 400.0, "")],
    build: spectra,
};

/// The total variation of `F′`, jumps at the ends of the band included: `|f(x)| ≤ V/(2πx)²` (two integrations by parts).
///
/// PL: `F′ = 32ν − 256ν³` jumps by 16 at `±½` and turns at `±1/√24`, where it is `±m = (64/3)/√24`: `V = 64 + 4m`.
/// PH: `F′ = −ν⁷/2` falls from `2^{5/2}` to `−2^{5/2}` and jumps by as much at either end: `V = 4·2^{5/2}`.
fn slope_variations() -> [f64; 2] {
    [64.0 + 4.0 * (64.0 / 3.0) / 24f64.sqrt(), 4.0 * 2f64.powf(2.5)]
}

fn spectra(params: &Params) -> Result<Figure> {
    let [low_title, high_title] = letters();
    let [low_variation, high_variation] = slope_variations();
    let low = transformed(&LowBump, params.real("X"), low_variation)?;
    let high = transformed(&HighBump, params.real("X"), high_variation)?;
    let crest = low.bins.iter().filter(|b| b[0] > 0.0).fold([0.0, 0.0], |a, b| if b[1] > a[1] { *b } else { a });
    let (wide, narrow) = (HighBump.spectrum().band(), LowBump.spectrum().band());
    let spacing = low.bins[1][0] - low.bins[0][0];
    Ok(Figure::new(2)
        .heights([3.0, 2.0])
        .with(low.spectrum_panel("low", low_title))
        .with(high.spectrum_panel("high", high_title))
        .with(low.difference_panel("low difference"))
        .with(high.difference_panel("high difference"))
        .claim(
            text!(
                "both FFTs follow the closed forms, up to what the record leaves out",
                "оба БПФ следуют формулам с точностью до того, что не попало в запись"
            ),
            Residual::at_most("|FFT − F| / tail of the record", low.worst().max(high.worst()), 1.0),
        )
        .claim(
            text!(
                "beyond ν = {} (a) and ν = {} (b) nothing is left: the fast function's spectrum is {} times as wide",
                "дальше ν = {} (а) и ν = {} (б) ничего нет: спектр быстрой функции в {} раза шире",
                number(narrow, 3),
                number(wide, 5),
                number(wide / narrow, 3)
            ),
            Residual::at_most("|FFT| beyond the band / tail of the record", low.beyond().max(high.beyond()), 1.0),
        )
        .claim(
            text!(
                "the humps of (a) peak at |ν| = 1/(2√2) = {}",
                "горбы (а) достигают вершины при |ν| = 1/(2√2) = {}",
                number(0.125f64.sqrt(), 4)
            ),
            // F ≈ 1 − 32δ² there: an error e in the values can move the largest by √(2e/32), the grid by half a bin
            Residual::near(
                "the largest bin is the one at 1/(2√2)",
                crest[0],
                0.125f64.sqrt(),
                0.5 * spacing + (low.tail / 16.0).sqrt(),
            ),
        ))
}

/// The spectrum of a lecture function from its samples, beside its closed form.
struct Transformed {
    spectrum: Spectrum,
    /// `[ν, F]` of all bins that the panels show.
    bins: Vec<[f64; 2]>,
    tail: f64,
}

/// How far the bins are shown; the panels reach a little farther.
const SHOWN: f64 = 2.0;

/// Half the width of the frequency panels.
const FRAME: f64 = 2.1;

fn transformed(f: &impl FourierPair, reach: f64, variation: f64) -> Result<Transformed> {
    // at rate 8 the copies of both bands, ½ and √2, are far apart
    let step = 0.125;
    let bins = forward(&Samples::of(f, Axis::centered(step, 2 * (reach / step).round() as usize)?));
    let shown = bins.axis().iter().zip(bins.values()).map(|(nu, v)| [nu, v.re]);
    // T·Σ V/(2πkT)² over |k| ≥ X/T: at most 2·V/(4π²)/(X − T)
    let tail = variation / (2.0 * PI * PI * (reach - step));
    Ok(Transformed { spectrum: f.spectrum(), bins: shown.filter(|b| b[0].abs() <= SHOWN).collect(), tail })
}

impl Transformed {
    fn difference(&self, bin: &[f64; 2]) -> f64 {
        (bin[1] - self.spectrum.density(bin[0]).re).abs()
    }

    /// The largest difference to the closed form, in units of what is allowed.
    fn worst(&self) -> f64 {
        self.bins.iter().map(|b| self.difference(b)).fold(0.0, f64::max) / self.tail
    }

    /// The largest bin beyond the band, in units of what is allowed.
    fn beyond(&self) -> f64 {
        let outside = self.bins.iter().filter(|b| b[0].abs() > self.spectrum.band());
        outside.map(|b| b[1].abs()).fold(0.0, f64::max) / self.tail
    }

    fn spectrum_panel(&self, name: &'static str, title: Text) -> Panel {
        // about fifty dots, whatever the record's length
        let every = self.bins.len().div_ceil(50);
        Panel::new(name, title, frequency(-FRAME, FRAME), values("F(ν)", -0.1, 1.2))
            .legend(Legend::Above)
            .with(
                density_curve("closed", Meaning::Signal, &self.spectrum, -FRAME, FRAME)
                    .thick()
                    .label(text!("closed form", "формула")),
            )
            .with(
                Layer::dots("fft", Meaning::Samples, self.bins.iter().step_by(every).copied())
                    .label(text!("FFT of samples", "БПФ отсчётов")),
            )
    }

    fn difference_panel(&self, name: &'static str) -> Panel {
        let difference = self.bins.iter().map(|b| [b[0], self.difference(b).max(1e-9)]);
        let scale = Scale::log(text!("difference", "разность"), 1e-8, 1.0);
        Panel::new(name, Text::EMPTY, frequency(-FRAME, FRAME), scale)
            .legend(Legend::Above)
            .with(Layer::line("difference", Meaning::Error, difference).label(text!("|FFT − F|", "|БПФ − F|")))
            .with(
                Layer::horizontals("tail", Meaning::Theory, [self.tail])
                    .dashed()
                    .label(text!("bound: what is cut off", "граница: отброшенное")),
            )
    }
}
