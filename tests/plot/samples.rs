//! Figures of every kind, drawn by the tests of the drawing.

#![allow(dead_code, reason = "each test program uses a part of the samples")]

use ndarray::Array2;
use nyquist::figure::{Bar, Figure, Layer, Legend, Meaning, Panel, Scale, Tones};
use nyquist::num::sinc;
use nyquist::plot::{Rgb, Scene};
use nyquist::text::Text;
use std::f64::consts::PI;

/// A PNG's pixels.
pub(crate) struct Pixels {
    pub(crate) size: (usize, usize),
    rgb: Vec<u8>,
}

impl Pixels {
    pub(crate) fn of(scene: &Scene) -> Self {
        let bytes = scene.png();
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a PNG");
        let mut rgb = vec![0; reader.output_buffer_size().expect("a size that fits")];
        let info = reader.next_frame(&mut rgb).expect("a PNG");
        assert_eq!(info.color_type, png::ColorType::Rgb);
        Self { size: (info.width as usize, info.height as usize), rgb }
    }

    pub(crate) fn at(&self, x: usize, y: usize) -> [u8; 3] {
        let i = 3 * (y * self.size.0 + x);
        [self.rgb[i], self.rgb[i + 1], self.rgb[i + 2]]
    }

    pub(crate) fn is(&self, x: usize, y: usize, colour: Rgb) -> bool {
        self.at(x, y).iter().zip(colour.0).all(|(a, b)| a.abs_diff(b) < 40)
    }
}

const fn t(en: &'static str, ru: &'static str) -> Text {
    Text::fixed(en, ru)
}

/// Name, title and data of every sample.
pub(crate) fn all() -> Vec<(&'static str, Text, Figure)> {
    vec![
        ("pair", t("Sampling copies the spectrum", "Дискретизация повторяет спектр"), pair()),
        ("errors", t("Errors fall", "Ошибки убывают"), errors()),
        ("grid", t("The square in ten pictures", "Квадрат в десяти картинках"), grid()),
        ("raster", t("Ghosts", "Призраки"), rasters()),
        ("mixed", t("Everything at once", "Всё сразу"), mixed()),
        ("bare", t("Nothing", "Ничего"), bare()),
    ]
}

/// Pixels beside each other.
pub(crate) fn colors<const N: usize>(light: [[f64; 3]; N]) -> nyquist::image::Rgb {
    let grid = nyquist::grid::Grid::pixels(N, 1).expect("there are pixels");
    let plane =
        |c: usize| nyquist::image::Image::new(grid, light.iter().map(|rgb| rgb[c]).collect()).expect("they are finite");
    nyquist::image::Rgb::new([plane(0), plane(1), plane(2)]).expect("on the same grid")
}

pub(crate) fn bare() -> Figure {
    let scale = || Scale::linear(Text::EMPTY, 0.0, 1.0).bare();
    Figure::new(1).with(Panel::new("nothing", Text::EMPTY, scale(), scale()))
}

fn pair() -> Figure {
    let samples: Vec<[f64; 2]> = (-5..=5).map(|i| 0.8 * f64::from(i)).map(|x| [x, sinc(x)]).collect();
    let x = Scale::linear(t("position x", "положение x"), -4.0, 4.0);
    let v = Scale::linear(t("frequency ν, cycles per unit", "частота ν, периодов на единицу"), -3.0, 3.0);
    let ticks = [-2.5, -1.25, 0.0, 1.25, 2.5].map(|v| (v, Text::of(format!("{v}/T"), format!("{v}/T"))));
    let y = || Scale::linear(t("f\u{303}, f·Ш_{T}", "f\u{303}, f·Ш_{T}"), -0.3, 1.2);
    let panel = Panel::new("f", t("A signal and its samples", "Сигнал и его отсчёты"), x, y())
        .with(Layer::curve("f", Meaning::Signal, -4.0, 4.0, 800, sinc).label(t("signal", "сигнал")))
        .with(Layer::dots("s", Meaning::Samples, samples).label(t("samples f(iT)", "отсчёты f(iT)")));
    let box_of = |v: f64| if v.abs() < 0.5 { 1.0 } else { 0.0 };
    let spectrum = Panel::new("F", t("Their spectra", "Их спектры"), v.ticks(ticks), y())
        .legend(Legend::Above)
        .with(Layer::curve("F", Meaning::Signal, -3.0, 3.0, 1200, box_of).label(t("of the signal", "сигнала")))
        .with(Layer::arrows("c", Meaning::Samples, [[-1.25, 1.0], [1.25, -0.2]]).label(t("of the comb", "гребня")))
        .with(Layer::spans("n", Meaning::Leaked, [[0.5, 0.75]]).label(t("overlap", "перекрытие")));
    Figure::new(2).with(panel).with(spectrum)
}

fn errors() -> Figure {
    let n = Scale::log(t("samples n", "отсчётов n"), 4.0, 4000.0);
    let e = Scale::log(t("greatest error |f\u{303} − f|", "наибольшая ошибка |f\u{303} − f|"), 1e-16, 10.0);
    let mut panel = Panel::new("e", t("Errors against n", "Ошибки от n"), n, e).legend(Legend::LowerLeft);
    for k in 0..6 {
        let points = (2..12).map(|i| f64::from(1 << i)).map(|n| [n, n.powi(-i32::from(k))]);
        let label = Text::of(format!("n^{{−{k}}}"), format!("n^{{−{k}}}"));
        panel = panel.with(Layer::line("e", Meaning::Series(k), points).label(label));
    }
    Figure::new(1).with(panel)
}

fn grid() -> Figure {
    const NAMES: [&str; 10] = ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j"];
    let mut figure = Figure::new(5);
    for (i, name) in NAMES.into_iter().enumerate() {
        let x = Scale::linear(t("x", "x"), -3.0, 3.0);
        let y = Scale::linear(Text::EMPTY, -0.4, 1.3);
        let title = Text::of(format!("Ш_{{1/T}}, step {i}"), format!("Ш_{{1/T}}, шаг {i}"));
        let f = move |x: f64| sinc(x * (1.0 + i as f64));
        let stems = (-7..=7).map(|k| 0.4 * f64::from(k)).map(|x| [x, f(x)]);
        let panel = Panel::new(name, title, x, y);
        figure = figure.with(
            panel
                .with(Layer::stems("s", Meaning::Samples, stems))
                .with(Layer::curve("f", Meaning::Signal, -3.0, 3.0, 400, f).thin().dashed()),
        );
    }
    figure
}

fn rasters() -> Figure {
    let zone = Array2::from_shape_fn((128, 128), |(y, x)| {
        let (x, y) = (x as f64 - 64.0, y as f64 - 64.0);
        0.5 + 0.5 * (PI * (x * x + y * y) / 64.0).cos()
    });
    let px = || Scale::linear(t("x, pixels", "x, пиксели"), 0.0, 128.0);
    let whole = (0.0, 128.0);
    let note = |x: f64, y: f64| ([x, y], t("a ghost at r_{N} = M/2", "призрак при r_{N} = M/2"));
    let grey = Panel::new("grey", t("A zone plate", "Зонная пластинка"), px(), px())
        .square()
        .with(Layer::raster("z", whole, whole, zone.clone(), (0.0, 1.0), Tones::Grey))
        .with(Layer::notes("n", Meaning::Leaked, [note(0.0, 0.0), note(128.0, 128.0), note(64.0, 64.0)]));
    let data = Panel::new("data", t("The same as data", "Она же как данные"), px(), px().bare())
        .square()
        .with(Layer::raster("z", whole, whole, zone, (0.0, 1.0), Tones::Data).label(t("value", "значение")))
        .with(Layer::pointers("p", Meaning::Samples, [[[64.0, 64.0], [120.0, 64.0]]]))
        .bar(Bar::values(t("brightness", "яркость")));
    Figure::new(2).with(grey).with(data)
}

fn mixed() -> Figure {
    let x = Scale::linear(t("time t, s", "время t, с"), 0.0, 10.0);
    let y = Scale::linear(t("amplitude", "амплитуда"), -1.5, 1.5);
    let long = t(
        "A title so long that it has to be broken, since no size that can be read lets it stand in a single line of the \
         slide, wide as it is",
        "Заголовок такой длины, что его приходится переносить: ни при каком читаемом размере он не встанет в одну \
         строку слайда, как бы широк тот ни был",
    );
    let wide = Panel::new("wide", long, x, y)
        .span(2)
        .with(Layer::curve("f", Meaning::Signal, 0.0, 10.0, 2000, |x| 1.8 * (5.0 * x).sin()).label(t("f", "f")))
        .with(Layer::line("e", Meaning::Error, [[0.0, -1.0], [1.0, f64::NAN], [2.0, -1.0], [4.0, 1.0]]).thick())
        .with(Layer::between("b", Meaning::Kernel, (0..=10).map(|i| [f64::from(i), -0.5, 0.5])))
        .with(Layer::verticals("v", Meaning::Guide, [2.5, 5.0]).dashed())
        .with(Layer::horizontals("h", Meaning::Theory, [1.0]).label(t("bound", "граница")));
    let count = Scale::linear(t("count", "число"), 0.0, 120_000.0);
    let bars = (0..10).map(|i| [0.05 + 0.1 * f64::from(i), 1e4 * f64::from(i + 1)]);
    let histogram = Panel::new("bars", t("Counted", "Подсчитано"), Scale::linear(t("v", "v"), 0.0, 1.0), count)
        .with(Layer::bars("b", Meaning::Samples, 0.09, bars).label(t("measured", "измерено")));
    let tiny = Scale::linear(t("tiny", "малое"), -2e-7, 3e-7);
    let plane = Panel::new("plane", t("Points", "Точки"), tiny, Scale::linear(t("large", "большое"), 0.0, 4e9))
        .with(Layer::dots("d", Meaning::Series(3), (0..9).map(|i| [1e-8 * f64::from(i), 4e8 * f64::from(i)])));
    Figure::new(2).heights([1.5, 1.0]).with(wide).with(histogram).with(plane)
}
