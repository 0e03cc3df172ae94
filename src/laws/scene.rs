//! The scene function: what a lens, a shutter and a light with a size do to `L(x, y, u, v, t)`.

use crate::laws::Law;
use crate::num::random::uniform;
use crate::residual::Residual;
use crate::scene::lens::{ThinLens, concentric};
use crate::scene::sun::overlap;
use crate::text::Text;

/// Places on the lens in which the laws trace rays: a grid of squares mapped onto the disc, its edge among them.
fn places(lens: &ThinLens) -> impl Iterator<Item = [f64; 2]> + use<'_> {
    let part = |i: u32| f64::from(i) / 8.0;
    (0..=8).flat_map(move |j| (0..=8).map(move |i| lens.point([part(i), part(j)])))
}

/// What rounding may cost a ray on its way to the film: a few roundings of the lengths that are added up on the way.
fn rounding(lens: &ThinLens, point: [f64; 3]) -> f64 {
    let reach = point[0].abs().max(point[1].abs()) + lens.aperture();
    let bend = 1.0 / lens.focal_length() + 1.0 / point[2].abs();
    16.0 * f64::EPSILON * (lens.aperture() + lens.film() * bend * reach)
}

/// F47: the rays of one point through all of the lens end on a disc of the film; the radius that is measured against
/// half of the circle of confusion that is `expected`: zero for a point in focus, whose rays all meet.
///
/// Measured: the farthest place on the film from that of the ray through the middle. Allowed: the rounding of the trace.
///
/// ```
/// use nyquist::laws::scene::rays_meet;
/// use nyquist::prelude::*;
/// let lens = ThinLens::new(0.05, 2.0, 0.025)?;
/// assert!(rays_meet(&lens, [0.3, -0.1, 2.0], 0.0).holds());
/// assert!(!rays_meet(&lens, [0.3, -0.1, 3.0], 0.0).holds());
/// # Ok::<(), Error>(())
/// ```
pub fn rays_meet(lens: &ThinLens, point: [f64; 3], expected: f64) -> Residual {
    let [x, y] = lens.to_film(point, [0.0, 0.0]);
    let apart = places(lens).map(|place| lens.to_film(point, place)).map(|[a, b]| (a - x).hypot(b - y));
    let widest = 2.0 * apart.fold(0.0, f64::max);
    let law = format!("diameter on the film of the rays of a point at z = {}", point[2]);
    Residual::near(law, widest, expected, 2.0 * rounding(lens, point))
}

/// The circle of confusion by the image's distance, `|(d′ − z′)/z′|·A`: similar triangles behind the lens.
pub fn by_similar_triangles(lens: &ThinLens, z: f64) -> f64 {
    let image = lens.image_distance(z);
    ((lens.film() - image) / image).abs() * lens.aperture()
}

/// F47: in the slice `(x, u)` of the scene function a point is a line, and its slope times the lens's diameter is the
/// circle of confusion: `confusion(z)`.
///
/// Measured: the slope of traced places on the film over places on the lens, by its ends. Allowed: the rounding of both.
pub fn slope_is_confusion(lens: &ThinLens, z: f64, confusion: impl Fn(&ThinLens, f64) -> f64) -> Residual {
    let half = 0.5 * lens.aperture();
    let at = |a: f64| lens.to_film([0.0, 0.0, z], [a, 0.0])[0];
    let slope = (at(half) - at(-half)) / (2.0 * half);
    // z′ = 1/(1/f − 1/z) divides the rounding of its terms by their difference, and c multiplies by it again
    let bound = 4.0 * rounding(lens, [0.0, 0.0, z]);
    Residual::near(format!("slope·A = c at z = {z}"), slope.abs() * lens.aperture(), confusion(lens, z), bound)
}

/// The map from the square to the lens keeps areas: of `n` points in the square the share that lands within `radius` is
/// its square.
///
/// Measured: the share of `n` independent points; allowed: four standard deviations of a binomial share.
pub fn lens_is_even(map: impl Fn([f64; 2]) -> [f64; 2], radius: f64, n: u64) -> Residual {
    let inside = (0..n).map(|i| map([uniform(1, i, 0), uniform(1, i, 1)])).filter(|[a, b]| a.hypot(*b) <= radius);
    let (share, expected) = (inside.count() as f64 / n as f64, radius * radius);
    let deviation = (expected * (1.0 - expected) / n as f64).sqrt();
    Residual::near(format!("share of the lens within {radius}"), share, expected, 4.0 * deviation)
}

/// A soft shadow is the share of the light that is hidden: the closed form against counting `n` random points of the light.
///
/// Measured: the difference of `share` to the count; allowed: four standard deviations of it.
pub fn shadow_is_share(own: f64, other: f64, between: f64, share: f64, n: u64) -> Residual {
    let point = |i: u64| concentric([uniform(2, i, 0), uniform(2, i, 1)]).map(|part| own * part);
    let hidden = (0..n).map(point).filter(|[a, b]| (a - between).hypot(*b) < other).count() as f64 / n as f64;
    let deviation = (share * (1.0 - share) / n as f64).sqrt();
    let law = format!("hidden share of a light of radius {own} behind {other} at {between}");
    Residual::near(law, hidden, share, 4.0 * deviation)
}

fn normal_lens() -> ThinLens {
    ThinLens::new(0.05, 2.0, 0.025).expect("a lens of 5 cm, f/2")
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "focus",
        inventory: &["F47"],
        says: &Text::fixed(
            "Rays of a point in focus meet in one point of the film, those of any other fill its circle of confusion",
            "Лучи точки в фокусе сходятся в одной точке плёнки, лучи любой другой заполняют кружок нерезкости",
        ),
        holds: || {
            let lens = normal_lens();
            let focused =
                [[0.0, 0.0, 2.0], [0.4, -0.2, 2.0], [-0.9, 0.9, 2.0]].map(|point| rays_meet(&lens, point, 0.0));
            let others = [0.5, 1.0, 3.0, 50.0].map(|z| rays_meet(&lens, [0.1, 0.2, z], lens.circle_of_confusion(z)));
            focused.into_iter().chain(others).collect()
        },
        breaks: || {
            let lens = normal_lens();
            // points out of focus
            [0.5, 1.9, 2.1, 50.0].map(|z| rays_meet(&lens, [0.1, 0.2, z], 0.0)).into()
        },
    },
    Law {
        name: "light-field-shear",
        inventory: &["F47"],
        says: &Text::fixed(
            "In the slice (x, u) a point is a line whose slope times A is its circle of confusion, |(d′ − z′)/z′|·A",
            "В сечении (x, u) точка — прямая, наклон которой, умноженный на A, равен кружку нерезкости |(d′ − z′)/z′|·A",
        ),
        holds: || {
            let lens = normal_lens();
            [0.3, 1.0, 2.0, 3.0, 50.0].map(|z| slope_is_confusion(&lens, z, by_similar_triangles)).into()
        },
        breaks: || {
            let lens = normal_lens();
            // the blur in the plane in focus taken for that on the film: not scaled by d′/z_f
            let there = |lens: &ThinLens, z: f64| lens.circle_of_confusion(z) * lens.focus() / lens.film();
            [0.3, 1.0, 3.0, 50.0].map(|z| slope_is_confusion(&lens, z, there)).into()
        },
    },
    Law {
        name: "lens-map",
        inventory: &["F47", "F53"],
        says: &Text::fixed(
            "The concentric map spreads the points of the square evenly over the lens",
            "Концентрическое отображение распределяет точки квадрата по линзе равномерно",
        ),
        holds: || [0.25, 0.5, 0.75, 0.9].map(|radius| lens_is_even(concentric, radius, 20_000)).into(),
        breaks: || {
            // polar coordinates without the root crowd in the middle
            let crowded = |[u, v]: [f64; 2]| {
                let angle = 2.0 * std::f64::consts::PI * v;
                [u * angle.cos(), u * angle.sin()]
            };
            [0.25, 0.5, 0.75].map(|radius| lens_is_even(crowded, radius, 20_000)).into()
        },
    },
    Law {
        name: "soft-shadow",
        inventory: &["F48"],
        says: &Text::fixed(
            "The half-shadow of a round light is the share of its disc that is hidden, two circular segments",
            "Полутень круглого источника — закрытая доля его диска, два круговых сегмента",
        ),
        holds: || {
            let cases = [(1.0, 1.0, 1.0), (1.0, 3.0, 2.5), (1.0, 0.4, 0.8), (2.0, 5.0, 6.5)];
            cases.map(|(own, other, at)| shadow_is_share(own, other, at, overlap(own, other, at), 20_000)).into()
        },
        breaks: || {
            // a straight edge for a round one; a ramp for a disc
            let ramp = |own: f64, other: f64, at: f64| (0.5 * (own + other - at) / own).clamp(0.0, 1.0);
            let cases = [(1.0, 1.0, 1.0), (1.0, 3.0, 2.5), (2.0, 5.0, 6.5)];
            cases.map(|(own, other, at)| shadow_is_share(own, other, at, ramp(own, other, at), 20_000)).into()
        },
    },
];
