//! Gaussian spots and their spectra (slides «More Examples»).

use crate::error::Result;
use crate::field::spot::GaussianSpot;
use crate::field::{Field, FourierField, from_fn};
use crate::figure::images::view::{in_decibels, picture, spectrum, worse};
use crate::figure::params::Param;
use crate::figure::picture::extent;
use crate::figure::{Entry, Figure, Layer, Mark, Meaning, Panel, Scale};
use crate::grid::Grid;
use crate::image::dft::forward;
use crate::image::{Image, ImageBins};
use crate::laws::plane::{spectrum_by_transform, transform_rounding};
use crate::num::isoline::isoline;
use crate::num::{cos_pi, sin_pi};
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};
use std::f64::consts::PI;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[ROUND, TURNED];

/// Pixels along a side.
const SIDE: usize = 128;
/// How many bins to every side of zero are shown.
const REACH: usize = 9;
/// The darkest tone of a spectrum, in decibels.
const FLOOR: f64 = -60.0;

static RADIUS: Text = Text::fixed("radius a of the narrow spot, in pixels", "радиус a узкого пятна, в пикселях");
static ANGLE: Text = Text::fixed("angle of the turn, in degrees", "угол поворота, в градусах");

const ROUND: Entry = Entry {
    id: "f45-gaussians",
    inventory: &["F45"],
    errata: &[],
    title: &Text::fixed("More examples: two Gaussians", "Ещё примеры: два гауссиана"),
    caption: &Text::fixed(
        "e^{−r²/a²} has the spectrum πa²·e^{−π²a²ρ²}, a Gaussian again: twice as wide in space, half as wide in frequency, \
         and four times as high. The spots are repeated with the period of the picture, as its transform takes them to be; \
         cut off at the edge they would draw a cross. Scales of spectra count periods across the picture.",
        "Спектр e^{−r²/a²} равен πa²·e^{−π²a²ρ²} — это снова гауссиан: вдвое шире в пространстве, вдвое уже по частоте и \
         вчетверо выше. Пятна повторены с периодом картинки, как их и понимает преобразование; обрезанные по краю, они \
         оставили бы в спектре крест. По осям спектров — число периодов на картинку.",
    ),
    params: &[Param::real("a", &RADIUS, 16.0, 8.0, 20.0, "px")],
    build: |params| round(params.real("a")),
};

fn grid() -> Result<Grid> {
    Grid::centered(1.0, SIDE, SIDE)
}

/// The samples of a spot and of its copies on all pictures beside this one, to where they vanish in rounding: beyond 6.2
/// radii `e^{−r²}` is below 10⁻¹⁶.
fn repeated(spot: &GaussianSpot, radius: f64) -> Result<Image> {
    let side = SIDE as f64;
    let copies = ((6.2 * radius + 0.5 * side) / side).floor() as i64;
    let shifts = || (-copies..=copies).map(move |k| k as f64 * side);
    let all = from_fn(|x, y| shifts().map(|dy| shifts().map(|dx| spot.at(x - dx, y - dy)).sum::<f64>()).sum());
    Ok(Image::of(&all, grid()?))
}

/// The bins `(k, 0)`, `|k| ≤ REACH`, over bin `(0, 0)`.
fn profile(bins: &ImageBins) -> Vec<[f64; 2]> {
    let reach = REACH as i64;
    (-reach..=reach).map(|k| [k as f64, bins.bin(k, 0).re / bins.bin(0, 0).re]).collect()
}

fn round(a: f64) -> Result<Figure> {
    let (spots, radii) = ([GaussianSpot::round(a)?, GaussianSpot::round(2.0 * a)?], [a, 2.0 * a]);
    let images = [repeated(&spots[0], radii[0])?, repeated(&spots[1], radii[1])?];
    let bins = [forward(&images[0]), forward(&images[1])];
    let profiles = [profile(&bins[0]), profile(&bins[1])];
    let end = REACH as f64 + 0.5;
    let names = [["narrow", "narrow-spectrum", "narrow-row"], ["wide", "wide-spectrum", "wide-row"]];
    let mut figure = Figure::new(4).heights([1.24, 1.0]);
    for i in 0..2 {
        let radius = number(radii[i], 3);
        let title = text!("e^{{−r²/{radius}²}}", "e^{{−r²/{radius}²}}");
        figure = figure.with(picture(names[i][0], title, &images[i], (0.0, 1.0)).span(2));
    }
    for i in 0..2 {
        let known = spots[i].spectrum();
        let curve = move |k: f64| known.density(k / SIDE as f64, 0.0).re / known.density(0.0, 0.0).re;
        let row = Panel::new(
            names[i][2],
            text!("row v = 0", "строка v = 0"),
            Scale::linear(Text::EMPTY, -end, end),
            Scale::linear(Text::same("F(k)/F(0)"), 0.0, 1.12),
        )
        .with(Layer::curve("theory", Meaning::Theory, -end, end, 400, curve))
        .with(Layer::stems("bins", Meaning::Signal, profiles[i].clone()));
        figure = figure.with(spectrum(names[i][1], in_decibels(FLOOR), &bins[i], FLOOR, REACH)?).with(row);
    }

    let side = SIDE as f64;
    let rounding = transform_rounding(SIDE * SIDE);
    let zero = REACH; // where k = 0 stands in a profile
    let ratio = profiles[0][zero + 1][1];
    let known = (-(PI * a / side).powi(2)).exp();
    let twice = (0..=REACH as i64 / 2).map(|k| (bins[1].bin(k, 0) - 4.0 * bins[0].bin(2 * k, 0)).norm());
    // widths by how far from the middle each has fallen to what: f = e^{−x²/2σ²}, x/√(2·ln(f₀/f))
    let at = (0.5 * a).round();
    let middle = SIDE / 2;
    let fallen = (images[0].at(middle, middle) / images[0].at(middle + at as usize, middle)).ln();
    let [sigma_x, sigma_u] = [at / (2.0 * fallen).sqrt(), 1.0 / side / (-2.0 * ratio.ln()).sqrt()];
    // all copies together add less than `8e^{−((N − x)/a)²}` to both values; σ_x is off by half of that over the lower value
    // and ln(f₀/f), σ_u by half of what the ratio is off, 2ε, over the ratio and its logarithm
    let copies = 8.0 * (-((side - at) / a).powi(2)).exp();
    let slack =
        (0.5 * (copies + rounding) * (at / a).powi(2).exp() / fallen - rounding / (ratio * ratio.ln())) / (2.0 * PI);
    Ok(figure
        .claim(
            text!(
                "both spectra are πa²·e^{{−π²a²ρ²}} at every bin",
                "оба спектра равны πa²·e^{{−π²a²ρ²}} во всех отсчётах"
            ),
            worse(
                spectrum_by_transform(&images[0], &spots[0].spectrum(), 0.0),
                spectrum_by_transform(&images[1], &spots[1].spectrum(), 0.0),
            ),
        )
        .claim(
            text!(
                "bin 1 over bin 0 is e^{{−π²a²/N²}} = {}",
                "отношение отсчётов 1 и 0 равно e^{{−π²a²/N²}} = {}",
                number(ratio, 5)
            ),
            // both bins are off by the rounding of the transform, relative to the one at zero
            Residual::near("F(1)/F(0) = e^{−π²a²/N²}", ratio, known, 2.0 * rounding),
        )
        .claim(
            text!(
                "twice as wide in space, half as wide in frequency: F_{{2a}}(k) = 4F_{{a}}(2k)",
                "вдвое шире в пространстве — вдвое уже по частоте: F_{{2a}}(k) = 4F_{{a}}(2k)"
            ),
            Residual::at_most(
                "F_2a(k) = 4F_a(2k)",
                twice.fold(0.0, f64::max),
                2.0 * rounding * bins[1].bin(0, 0).norm(),
            ),
        )
        .claim(
            text!(
                "σ_{{x}}·σ_{{u}} = {} px × {} = 1/(2π)",
                "σ_{{x}}·σ_{{u}} = {} px × {} = 1/(2π)",
                number(sigma_x, 4),
                number(sigma_u, 4)
            ),
            Residual::near("σ_x·σ_u = 1/2π", sigma_x * sigma_u, 0.5 / PI, slack),
        ))
}

const TURNED: Entry = Entry {
    id: "f46-turned",
    inventory: &["F46"],
    errata: &[],
    title: &Text::fixed("More examples: an elongated Gaussian, turned", "Ещё примеры: вытянутый и повёрнутый гауссиан"),
    caption: &Text::fixed(
        "What is long in space is short in frequency: the spectrum of the spot 32 by 16 is twice as high as wide. Turn the \
         picture, and the spectrum turns with it, by the same angle and in the same sense.",
        "Что длинно в пространстве, то коротко по частоте: спектр пятна 32 на 16 вдвое выше, чем шире. Поверните картинку — \
         и спектр повернётся вместе с ней, на тот же угол и в ту же сторону.",
    ),
    params: &[Param::real("angle", &ANGLE, 45.0, 0.0, 90.0, "°")],
    build: |params| turned(params.real("angle")),
};

/// The second moments `[uu, uv, vv]` of a spectrum, in cycles² per pixel².
fn moments(bins: &ImageBins) -> [f64; 3] {
    let mut sums = [0.0; 4];
    for ([u, v], f) in bins.grid().iter().zip(bins.values()) {
        for (sum, part) in sums.iter_mut().zip([1.0, u * u, u * v, v * v]) {
            *sum += part * f.re;
        }
    }
    [1, 2, 3].map(|i| sums[i] / sums[0])
}

/// The direction of the long axis, and the widths along it and across.
fn axes([uu, uv, vv]: [f64; 3]) -> (f64, [f64; 2]) {
    let (mean, half) = (0.5 * (uu + vv), (0.5 * (uu - vv)).hypot(uv));
    (0.5 * (2.0 * uv).atan2(uu - vv), [mean + half, mean - half].map(f64::sqrt))
}

/// Where the values of a raster equal a level, as one line.
fn contour(name: &'static str, meaning: Meaning, panel: &Panel, level: f64) -> Layer {
    let segments = match panel.layers.first().map(|layer| &layer.mark) {
        Some(Mark::Raster { x, y, values, .. }) => isoline(values, *x, *y, level),
        _ => Vec::new(),
    };
    // the line goes round the middle once: in the order of the angle it is one stroke
    let mut points: Vec<[f64; 2]> = segments.into_iter().flatten().collect();
    points.sort_by(|a, b| a[1].atan2(a[0]).total_cmp(&b[1].atan2(b[0])));
    points.extend(points.first().copied());
    Layer::line(name, meaning, points).thick()
}

/// The ellipse of a Gaussian of these widths, in bins, at so many decibels.
fn ellipse(name: &'static str, meaning: Meaning, (angle, widths): (f64, [f64; 2]), decibels: f64) -> Layer {
    let scale = (-decibels / 10.0 * 10f64.ln()).sqrt() * SIDE as f64; // e^{−t²/2} = 10^{dB/20}
    let (sin, cos) = angle.sin_cos();
    let at = |turns: f64| {
        let [a, b] = [widths[0] * cos_pi(2.0 * turns), widths[1] * sin_pi(2.0 * turns)];
        [scale * (a * cos - b * sin), scale * (a * sin + b * cos)]
    };
    Layer::line(name, meaning, (0..=120).map(|i| at(f64::from(i) / 120.0))).thick()
}

fn turned(angle: f64) -> Result<Figure> {
    let radii = [32.0, 16.0];
    let spots = [GaussianSpot::new(radii)?, GaussianSpot::turned(radii, angle.to_radians())?];
    let images = [repeated(&spots[0], radii[0])?, repeated(&spots[1], radii[0])?];
    let bins = [forward(&images[0]), forward(&images[1])];
    let degrees = number(angle, 3);
    let titles = [
        text!("e^{{−x²/32²}}·e^{{−y²/16²}}", "e^{{−x²/32²}}·e^{{−y²/16²}}"),
        text!("turned by {degrees}°", "повёрнут на {degrees}°"),
    ];
    let pictures = [
        picture("along", titles[0].clone(), &images[0], (0.0, 1.0)),
        picture("turned", titles[1].clone(), &images[1], (0.0, 1.0)),
    ];
    let spectra = [
        spectrum("along-spectrum", in_decibels(FLOOR), &bins[0], FLOOR, REACH)?,
        spectrum("turned-spectrum", in_decibels(FLOOR), &bins[1], FLOOR, REACH)?,
    ];
    let end = REACH as f64 + 0.5;
    let ((first, widths), (second, others)) = (axes(moments(&bins[0])), axes(moments(&bins[1])));
    let ratio = widths[0] / widths[1];
    let overlay = |name, title, scale: Scale, lines: [Layer; 2], at: f64, upright: bool| {
        let away = |angle: f64| {
            let (sin, cos) = angle.to_radians().sin_cos();
            if upright { [-at * sin, at * cos] } else { [at * cos, at * sin] }
        };
        let names = [("name-along", 180.0, "0°".to_owned()), ("name-turned", angle, format!("{degrees}°"))];
        let panel = lines.into_iter().fold(Panel::new(name, title, scale.clone(), scale).square(), Panel::with);
        (0u8..).zip(names).fold(panel, |panel, (i, (name, place, label))| {
            panel.with(Layer::notes(name, Meaning::Series(i), [(away(place), text!("{label}", "{label}"))]))
        })
    };
    let (low, high) = extent(grid()?.x());
    let space = overlay(
        "contours",
        text!("both at half height", "оба на половине высоты"),
        Scale::linear(Text::EMPTY, low, high),
        [
            contour("along", Meaning::Series(0), &pictures[0], 0.5),
            contour("turned", Meaning::Series(1), &pictures[1], 0.5),
        ],
        45.0,
        false,
    );
    let frequency = overlay(
        "spectrum-contours",
        text!("both at −40 dB", "оба на уровне −40 дБ"),
        Scale::linear(Text::EMPTY, -end, end),
        [
            ellipse("along", Meaning::Series(0), (first, widths), -40.0),
            ellipse("turned", Meaning::Series(1), (second, others), -40.0),
        ],
        7.5,
        true,
    );

    // the moments are the bends at zero of the repeated spot over its value there, −∇∇f/(4π²f): the copies add to both
    let side = SIDE as f64;
    let tail = |spot: &GaussianSpot| -> f64 {
        let copies = (-2..=2i32).flat_map(|k| (-2..=2i32).map(move |l| [k, l])).filter(|c| *c != [0, 0]);
        let bend = |[k, l]: [i32; 2]| {
            let (x, y) = (f64::from(k) * side, f64::from(l) * side);
            let steep = 2.0 / (radii[1] * radii[1]);
            spot.at(x, y) * (steep * steep * (x * x + y * y) + 2.0 * steep)
        };
        copies.map(bend).sum::<f64>() / (4.0 * PI * PI)
    };
    let known = radii.map(|r| 0.5 / (PI * r).powi(2)); // σ² of the spectrum, along and across
    // every bin is off by the rounding of the transform times Σ|f| = πab, at most at a quarter of a cycle squared, and the
    // bins add up to N²·f(0)
    let rounding = 0.25 * transform_rounding(SIDE * SIDE) * PI * radii[0] * radii[1];
    let off = (tail(&spots[0]) + tail(&spots[1]) + 2.0 * rounding) / (known[1] - known[0]);
    let turn = (second - first).to_degrees().rem_euclid(180.0);
    let missed = (turn - angle).abs();
    let ([along, turned], [along_spectrum, turned_spectrum]) = (pictures, spectra);
    Ok(Figure::new(4)
        .heights([1.24, 1.0])
        .with(along.span(2))
        .with(turned.span(2))
        .with(along_spectrum)
        .with(space)
        .with(turned_spectrum)
        .with(frequency)
        .claim(
            text!(
                "both spectra are those of the closed form at every bin",
                "оба спектра совпадают с формулой во всех отсчётах"
            ),
            worse(
                spectrum_by_transform(&images[0], &spots[0].spectrum(), 0.0),
                spectrum_by_transform(&images[1], &spots[1].spectrum(), 0.0),
            ),
        )
        .claim(
            text!(
                "twice as wide as high in space; in frequency {} times as high as wide",
                "в пространстве вдвое шире, чем выше; по частоте в {} раза выше, чем шире",
                number(ratio, 3)
            ),
            // the long axis stands upright, and the ratio of the widths is that of the radii; a square root halves the error
            worse(
                Residual::near("ratio of the widths of the spectrum", ratio, radii[0] / radii[1], 2.0 * off * ratio),
                Residual::near("the long axis of the spectrum stands upright", first.abs(), 0.5 * PI, off),
            ),
        )
        .claim(
            text!("the spectrum is turned by the same {degrees}°", "спектр повёрнут на те же {degrees}°"),
            Residual::at_most(
                "angle between the long axes of the spectra = angle of the turn",
                missed.min(180.0 - missed).to_radians(),
                off,
            ),
        ))
}
