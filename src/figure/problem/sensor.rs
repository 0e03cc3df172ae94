//! A sensor samples (slide «Сенсор = сэмплер (дискретизатор)»).

use crate::error::Result;
use crate::figure::common::{PIECES, frequency, space, unmarked, values};
use crate::figure::params::{Param, Params};
use crate::figure::picture::circles;
use crate::figure::{Bar, Entry, Figure, Layer, Legend, Meaning, Panel, Scale, Tones};
use crate::laws::point_spectra::{PLATEAU, band_power};
use crate::num::quadrature::{Integral, even_breaks, integrate_pieces};
use crate::num::sinc;
use crate::nyquist::Alias;
use crate::pattern::Pattern;
use crate::pattern::measure::periodogram::Periodogram;
use crate::pattern::measure::radial::rings;
use crate::pattern::poisson_disk::PoissonDisk;
use crate::pattern::regular::Regular;
use crate::residual::Residual;
use crate::signal::raised_cosine::RaisedCosine;
use crate::signal::tone::Cosine;
use crate::signal::{FourierPair, Signal, from_fn};
use crate::text;
use crate::text::{Text, number};

static FILL: Text = Text::fixed("width of a pixel's sensitive part", "ширина светочувствительной части пикселя");
static FINE: Text = Text::fixed("frequency of the fine grating", "частота мелкой решётки");
static SEED: Text = Text::fixed("seed of the mosaic", "начальное число мозаики");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[SENSOR, PIXELS];

const SENSOR: Entry = Entry {
    id: "f01-sensor",
    inventory: &["F01"],
    errata: &[],
    title: &Text::fixed("Sensor = sampler: two layouts", "Сенсор = сэмплер: две мозаики"),
    caption: &Text::fixed(
        "A chip's square pixels and the cones of an eye outside the fovea, as many of both. The lattice's power stands in \
         isolated peaks, each of which makes a copy of the picture's spectrum. The cones keep their distance but no order \
         (Yellott 1983): around the central peak almost nothing, then a ring and flat noise, so that what is too fine \
         becomes noise instead of a false pattern.",
        "Квадратные пиксели матрицы и колбочки глаза вне центральной ямки, поровну. Мощность решётки собрана в отдельные \
         пики, и каждый создаёт копию спектра картины. Колбочки держат расстояние, но не порядок (Йеллот, 1983): вокруг \
         центрального пика почти пусто, дальше кольцо и ровный шум, поэтому слишком мелкое становится шумом, а не ложным \
         узором.",
    ),
    params: &[Param::real("fill", &FILL, 0.7, 0.3, 1.0, "px"), Param::count("seed", &SEED, 1, 1, 100)],
    build: sensor,
};

/// Pixels along a side; as many cones, about, as pixels.
const SIDE: usize = 12;
/// The largest frequency shown, in cycles per side.
const REACH: usize = 28;
/// The largest frequency of the radial mean.
const FAR: usize = 54;
/// How many mosaics the radial mean is taken over.
const MOSAICS: u32 = 100;
/// How many the power near zero is measured over, where there are only four frequencies.
const PLATEAU_MOSAICS: u32 = 200;

fn sensor(params: &Params) -> Result<Figure> {
    let (fill, seed) = (params.real("fill"), params.count("seed") as u64);
    let (lattice, mosaic) = (Regular::new([SIDE, SIDE])?, PoissonDisk::with_about(SIDE * SIDE)?);
    let (pixels, cones) = (lattice.points(0), mosaic.points(seed));
    let (of_pixels, of_cones) = (Periodogram::of(&pixels, REACH)?, Periodogram::of(&cones, REACH)?);
    let mean = Periodogram::mean(&mosaic, seed, MOSAICS, FAR)?;
    let radial = rings(&mean, 1.0)?;
    let unit = mean.points().sqrt();

    let half = 0.5 * fill / SIDE as f64;
    let corners = [[-half, -half], [half, -half], [half, half], [-half, half], [-half, -half], [f64::NAN, f64::NAN]];
    let squares = pixels.iter().flat_map(|[x, y]| corners.map(|[dx, dy]| [x + dx, y + dy]));
    let layout = |name, title, layer: Layer| {
        Panel::new(name, title, unmarked(-0.02, 1.02), unmarked(-0.02, 1.02)).square().with(layer)
    };
    let side = REACH as f64 + 0.5;
    let power = |name, title, of: &Periodogram| {
        Panel::new(name, title, unmarked(-side, side), unmarked(-side, side))
            .square()
            .with(Layer::raster("power", (-side, side), (-side, side), of.power().clone(), (0.0, 3.0), Tones::Data))
            .bar(Bar::values(Text::EMPTY))
    };
    // in cycles per distance of receptors
    let axis = |end: f64| Scale::linear(text!("cycles per receptor", "периодов на рецептор"), 0.0, end);
    let per = SIDE as f64;
    let lines = (1..=REACH as i64).map(|u| [u as f64 / per, of_pixels.at(u, 0)]);
    let cut = Panel::new("cut", text!("power along the axis", "мощность вдоль оси"), axis(2.4), values("", 0.0, 180.0))
        .with(Layer::stems("lines", Meaning::Replica, lines));
    let ring = radial.iter().map(|r| [r.frequency / unit, r.power]);
    let curve = Panel::new("radial", text!("radial mean power", "средняя по кругу"), axis(4.4), values("", 0.0, 2.2))
        .legend(Legend::UpperRight)
        .with(Layer::horizontals("white", Meaning::Guide, [1.0]).dashed())
        .with(Layer::line("mean", Meaning::Replica, ring).thick());

    let n = pixels.len() as f64;
    let expected = |[u, v]: [i64; 2]| if u % SIDE as i64 == 0 && v % SIDE as i64 == 0 { n } else { 0.0 };
    let off = of_pixels.half().map(|(f, p)| (p - expected(f)).abs()).fold(0.0, f64::max);
    let [low, deviation] = band_power(&mosaic, PLATEAU_MOSAICS, [0.02, 0.1])?;
    let top =
        radial.iter().fold([0.0; 2], |best, r| if r.power > best[1] { [r.frequency / unit, r.power] } else { best });
    let beyond = radial.iter().filter(|r| r.frequency > 3.0 * unit);
    let ripple = beyond.map(|r| (r.power - 1.0).abs()).fold(0.0, f64::max);
    Ok(Figure::new(3)
        .with(layout(
            "lattice",
            text!("pixels of a chip", "пиксели матрицы"),
            Layer::line("pixels", Meaning::Samples, squares),
        ))
        .with(power("lattice-power", text!("their power", "их мощность"), &of_pixels))
        .with(cut)
        .with(layout(
            "mosaic",
            text!("cones of an eye", "колбочки глаза"),
            circles("cones", Meaning::Samples, 0.5 * mosaic.radius(), &cones),
        ))
        .with(power("mosaic-power", text!("their power", "их мощность"), &of_cones))
        .with(curve)
        .claim(
            text!(
                "the lattice has the power {} at the multiples of the rate, and none elsewhere",
                "мощность решётки равна {} на кратных частоты дискретизации, а вне их — нулю",
                number(n, 4)
            ),
            // phasors are powers of one, off by 2ε·reach; N of them, each twice, times √(N·P) ≤ N
            Residual::at_most("lattice: N at the multiples of n, else 0", off, 8.0 * f64::EPSILON * side * n),
        )
        .claim(
            text!(
                "near zero the cones have {} of the power of white noise",
                "около нуля мощность колбочек — {} от белого шума",
                number(low, 1)
            ),
            Residual::near("Poisson disk: plateau of the power", low, PLATEAU[0], 4.0 * deviation.hypot(PLATEAU[1])),
        )
        .claim(
            text!(
                "the ring stands at one cycle per receptor and little more, with {} times the power of white noise",
                "кольцо стоит чуть дальше одного периода на рецептор, мощность {} от белого шума",
                number(top[1], 2)
            ),
            // found in rings one frequency wide, so to half a ring to either side
            Residual::at_most(
                "place of the ring, beyond 1.0 … 1.3 (V21)",
                (1.0 - top[0]).max(top[0] - 1.3),
                0.5 / unit,
            ),
        )
        .claim(
            text!(
                "beyond three cycles per receptor less than half of the ring's ripple is left: nearly flat noise",
                "за тремя периодами на рецептор от ряби кольца остаётся меньше половины: почти ровный шум"
            ),
            Residual::at_most("|P − 1| beyond three cycles per receptor", ripple, 0.5 * (top[1] - 1.0)),
        ))
}

const PIXELS: Entry = Entry {
    id: "f01-pixels",
    inventory: &["F01"],
    errata: &["E18"],
    title: &Text::fixed("A pixel measures a mean", "Пиксель измеряет среднее"),
    caption: &Text::fixed(
        "Light with a fine grating in it. A renderer reads it at points, and the grating comes back whole as a slow wave. \
         A sensor integrates over the width aT of its pixels: that is the box prefilter, followed by point samples, with \
         the transfer sinc(aν). A full pixel stops what has the frequency 1, but of a tone at Nyquist it lets 0.64 through.",
        "Свет с мелкой решёткой. Рендерер читает его в точках, и решётка целиком возвращается медленной волной. Сенсор \
         интегрирует по ширине aT своих пикселей: это прямоугольный предфильтр, а затем точечные отсчёты, с передачей \
         sinc(aν). Полный пиксель гасит частоту 1, но тон на частоте Найквиста пропускает на 0,64.",
    ),
    params: &[Param::real("a", &FILL, 1.0, 0.2, 1.0, "T"), Param::real("f", &FINE, 0.9, 0.6, 1.4, "cycles per pixel")],
    build: pixels,
};

/// The band of the broad light, and how strong the grating is beside its peak of one.
const BAND: f64 = 0.1;
const GRATING: f64 = 0.25;
/// Pixels to either side.
const END: i64 = 9;

fn pixels(params: &Params) -> Result<Figure> {
    let (a, f) = (params.real("a"), params.real("f"));
    let (broad, grating) = (RaisedCosine::new(BAND)?, Cosine::new(f)?);
    let level = 0.9;
    let light = from_fn(|x| level * broad.at(x) / BAND + GRATING * (1.0 + grating.at(x)));
    // through the spectrum: E ⊗ box has F(ν)·sinc(aν)
    let spectrum = broad.spectrum();
    let boxed = |x: f64| {
        let breaks = even_breaks(0.0, BAND, 0.05);
        let wave = |nu: f64| 2.0 * spectrum.density(nu).re * sinc(a * nu) * (std::f64::consts::TAU * nu * x).cos();
        let part = integrate_pieces(wave, &breaks, 1e-16);
        let value = level * part.value / BAND + GRATING * (1.0 + sinc(a * f) * grating.at(x));
        Integral { value, error: level * part.error / BAND }
    };
    let measured = |i: i64| {
        let x = i as f64;
        let light = integrate_pieces(|x| light.at(x), &even_breaks(x - 0.5 * a, x + 0.5 * a, 0.25), 1e-16);
        Integral { value: light.value / a, error: light.error / a }
    };
    let alias = Alias::of(f, 1.0)?;
    let slow = Cosine::new(alias.frequency())?;
    let seen = |gain: f64| move |x: f64| level * broad.at(x) / BAND + GRATING * (1.0 + gain * slow.at(x));
    let end = END as f64;
    let panel = |name, title, last: bool| {
        let x = if last { space(-end - 0.6, end + 0.6) } else { unmarked(-end - 0.6, end + 0.6) };
        let panel = Panel::new(name, title, x, unmarked(-0.15, 1.55)).span(2).legend(Legend::Above);
        let curve = Layer::curve("light", Meaning::Signal, -end - 0.5, end + 0.5, 2 * PIECES, |x| light.at(x));
        panel.with(curve.label(text!("light E", "свет E")))
    };
    let taken: Vec<[f64; 2]> = (-END..=END).map(|i| [i as f64, light.at(i as f64)]).collect();
    let points = panel("points", text!("a renderer: point samples E(iT)", "рендерер: отсчёты в точках E(iT)"), false)
        .with(
            Layer::curve("seen", Meaning::Leaked, -end - 0.5, end + 0.5, PIECES, seen(1.0))
                .thick()
                .label(text!("what they show", "что они показывают")),
        )
        .with(Layer::dots("samples", Meaning::Samples, taken).label(text!("samples", "отсчёты")));
    let integrals: Vec<(f64, Integral)> = (-END..=END).map(|i| (i as f64, measured(i))).collect();
    let bars =
        integrals.iter().flat_map(|(x, r)| [[x - 0.5 * a, r.value], [x + 0.5 * a, r.value], [f64::NAN, f64::NAN]]);
    let sensor = panel("pixels", text!("a sensor: means R_{{i}} over aT", "сенсор: средние R_{{i}} по aT"), true)
        .with(
            Layer::curve("boxed", Meaning::Kernel, -end - 0.5, end + 0.5, PIECES, |x| boxed(x).value)
                .label(text!("E ⊗ box", "E ⊗ box")),
        )
        .with(
            Layer::line("means", Meaning::Reconstructed, bars)
                .thick()
                .label(text!("pixels R_{{i}}", "пиксели R_{{i}}")),
        );
    let left = sinc(a * f);
    let arrows = |panel: Panel, gain: f64| {
        panel
            .with(
                Layer::arrows("grating", Meaning::Signal, [[f, gain.abs()]]).thick().label(text!("grating", "решётка")),
            )
            .with(
                Layer::arrows("alias", Meaning::Leaked, [[alias.frequency(), gain.abs()]])
                    .thick()
                    .label(text!("seen as", "видна как")),
            )
    };
    let top = 2.2;
    let open =
        Panel::new("point-transfer", text!("transfer: 1", "передача: 1"), unmarked(0.0, top), values("", 0.0, 1.2))
            .legend(Legend::Above)
            .with(Layer::verticals("nyquist", Meaning::Guide, [0.5]).dashed())
            .with(Layer::curve("transfer", Meaning::Kernel, 0.0, top, 2, |_| 1.0));
    let named = |(above, width): (f64, f64)| {
        let gain = sinc(0.5 * width);
        ([1.65, gain + above], text!("a = {}: {gain:.2}", "a = {}: {gain:.2}", number(width, 2)))
    };
    let closed = Panel::new(
        "transfer",
        text!("transfer: |sinc(aν)|", "передача: |sinc(aν)|"),
        frequency(0.0, top),
        values("", 0.0, 1.2),
    )
    .with(Layer::verticals("nyquist", Meaning::Guide, [0.5]).dashed())
    .with(Layer::curve("half", Meaning::Guide, 0.0, top, PIECES, |nu| sinc(0.5 * a * nu).abs()).dashed())
    .with(Layer::curve("transfer", Meaning::Kernel, 0.0, top, PIECES, |nu| sinc(a * nu).abs()).thick())
    .with(Layer::dots("at-nyquist", Meaning::Kernel, [[0.5, sinc(0.5 * a)], [0.5, sinc(0.25 * a)]]))
    .with(Layer::notes("gains", Meaning::Kernel, [(0.0, a), (0.09, 0.5 * a)].map(named)));
    let plain =
        |panel: Panel| Panel { layers: panel.layers.into_iter().map(|l| l.label(Text::EMPTY)).collect(), ..panel };

    let worst = integrals.iter().map(|(x, r)| ((r.value - boxed(*x).value).abs(), r.error + boxed(*x).error));
    let (apart, error) = worst.fold((0.0f64, 0.0f64), |(d, e), w| (d.max(w.0), e.max(w.1)));
    // what a pixel of that width makes of a tone at Nyquist, by quadrature
    let gain = |width: f64| {
        let tone = Cosine::new(0.5);
        tone.map(|tone| {
            let mean = integrate_pieces(|x| tone.at(x), &[-0.5 * width, 0.5 * width], 1e-16);
            Integral { value: mean.value / width, error: mean.error / width }
        })
    };
    let decibels = |gain: f64| 20.0 * gain.log10();
    let figure = Figure::new(3)
        .heights([1.0, 1.2])
        .with(points)
        .with(arrows(open, 1.0))
        .with(sensor)
        .with(plain(arrows(closed, left)))
        .claim(
            text!(
                "pixels are samples of E ⊗ box: the integral over space equals the one over frequency",
                "пиксели — отсчёты E ⊗ box: интеграл по площади равен интегралу по частоте"
            ),
            // values below 1.5, and arguments of cosines up to 2π·f·(END + 1), rounded
            Residual::at_most(
                "R_i = (E ⊗ box)(iT)",
                apart,
                error + 8.0 * f64::EPSILON * (1.5 + std::f64::consts::TAU * f * (end + 1.0)),
            ),
        );
    [a, 0.5 * a].into_iter().try_fold(figure, |figure, width| {
        let measured = gain(width)?;
        Ok(figure.claim(
            text!(
                "a pixel of width {} keeps {} of a tone at Nyquist, {} dB",
                "пиксель шириной {} оставляет {} от тона на частоте Найквиста, {} дБ",
                number(width, 3),
                number(measured.value, 4),
                number(decibels(measured.value), 3)
            ),
            Residual::near(
                "transfer of a pixel = sinc(aν)",
                measured.value,
                sinc(0.5 * width),
                measured.error + 4.0 * f64::EPSILON,
            ),
        ))
    })
}
