//! The portrait of any points of the plane: what they look like, their spectrum and their measures.

use crate::error::{Error, Result};
use crate::figure::patterns::square::{frequencies, points_panel, power_panel};
use crate::figure::{Bar, Figure, Layer, Meaning, Panel, Portrait, Scale};
use crate::pattern::cloud::Cloud;
use crate::pattern::measure::summary::Summary;
use crate::text;
use crate::text::{Text, number};

/// How many points are drawn; more would be one grey.
const DRAWN: usize = 4096;

/// Points of the plane, their periodogram, its mean and its anisotropy over the distance from zero.
///
/// ```
/// use nyquist::figure::patterns::portrait::portrait;
/// use nyquist::pattern::cloud::Cloud;
/// use nyquist::pattern::measure::summary::Summary;
/// let cloud = Cloud::new("jittered", 2, 64, 1)?;
/// let drawn = portrait("jittered", &cloud, &Summary::of(&cloud)?)?;
/// assert_eq!(drawn.figure.panels.len(), 4);
/// assert_eq!(drawn.figure.layer("points").map(|l| l.points().len()), Some(64));
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// Points that do not lie in the plane.
pub fn portrait(name: &str, cloud: &Cloud, summary: &Summary) -> Result<Portrait> {
    let (Some(points), Some(spectrum), Some(discrepancy), Some(distance)) =
        (cloud.plane(), &summary.spectrum, summary.star_discrepancy, summary.least_distance)
    else {
        return Err(Error::Unsupported("the spectrum of points is drawn in the plane: two dimensions"));
    };
    let n = points.len();
    let shown = n.min(DRAWN);
    let title = if shown < n {
        text!("the first {shown} of {n} points", "первые {shown} из {n} точек")
    } else {
        text!("points: {n}", "точек: {n}")
    };
    let reach = spectrum.periodogram.reach() as f64;
    let top = spectrum.rings.iter().map(|ring| ring.power).fold(1.0, f64::max);
    let radial = Panel::new(
        "radial",
        text!("mean over a ring", "среднее по кольцу"),
        frequencies(Text::same("|ν|"), reach),
        Scale::linear(text!("power", "мощность"), 0.0, 1.15 * top),
    )
    .with(Layer::horizontals("white", Meaning::Guide, [1.0]).dashed())
    .with(Layer::line("power", Meaning::Samples, spectrum.rings.iter().map(|r| [r.frequency, r.power])).thick());
    let floor = 0.1;
    let uneven = |r: &crate::pattern::measure::radial::Ring| [r.frequency, r.anisotropy.max(floor)];
    let most = spectrum.rings.iter().map(|ring| ring.anisotropy).fold(10.0, f64::max);
    // one pattern: powers are exponential, of variance one
    let anisotropy = Panel::new(
        "anisotropy",
        text!("anisotropy", "анизотропия"),
        frequencies(Text::same("|ν|"), reach),
        Scale::log(text!("variance/mean²", "дисперсия/среднее²"), floor, 2.0 * most),
    )
    .with(Layer::horizontals("white", Meaning::Guide, [1.0]).dashed())
    .with(Layer::line("variance", Meaning::Error, spectrum.rings.iter().map(uneven)).thick());
    let figure = Figure::new(2)
        .heights([1.4, 1.0])
        .with(points_panel("points", title, &points[..shown]))
        .with(
            power_panel("spectrum", text!("power spectrum", "спектр мощности"), &spectrum.periodogram, 1.0, (0.0, 2.0))
                .bar(Bar::values(Text::EMPTY)),
        )
        .with(radial)
        .with(anisotropy);
    let [discrepancy, distance, mean] = [discrepancy, distance, spectrum.mean()].map(|v| number(v, 3));
    Ok(Portrait {
        title: text!(
            "{name}, N = {n}: D* = {discrepancy}, least distance {distance}",
            "{name}, N = {n}: D* = {discrepancy}, наименьшее расстояние {distance}"
        ),
        caption: text!(
            "{n} points of the pattern {name}. Their star discrepancy is {discrepancy}, the least distance of two points \
             {distance}, the mean of the radial spectrum {mean} (one for independent points).",
            "{n} точек узора {name}. Их звёздное расхождение {discrepancy}, наименьшее расстояние двух точек {distance}, \
             среднее радиального спектра {mean} (у независимых точек единица)."
        ),
        figure,
    })
}
