//! From samples to pixels: what the quotient `Σ f·L / Σ f` keeps, and what it costs (Φ14, V13).

use crate::error::Result;
use crate::film::{Film, Sample};
use crate::grid::Grid;
use crate::image::Image;
use crate::kernel::Kernel;
use crate::kernel::box_kernel::BoxKernel;
use crate::kernel::cubic::Cubic;
use crate::kernel::gaussian::GaussianKernel;
use crate::kernel::lanczos::Lanczos;
use crate::kernel::tent::TentKernel;
use crate::laws::Law;
use crate::laws::jitter::deviations;
use crate::num::quadrature::{even_breaks, integrate_pieces};
use crate::num::random::{bits, uniform};
use crate::residual::Residual;
use crate::text::Text;

/// A picture of light `c` everywhere is `c` in every pixel.
///
/// Measured: the largest difference. Allowed: the rounding of two sums of at most `terms` products, whose amounts are
/// at most `spread` times their sum (1 where no weight is negative): `2ε·terms·spread·|c|`.
pub fn constant_kept(picture: &Image, c: f64, terms: usize, spread: f64) -> Residual {
    let most = picture.values().iter().map(|v| (v - c).abs()).fold(0.0, f64::max);
    Residual::at_most("a constant is kept", most, 2.0 * f64::EPSILON * terms as f64 * spread * c.abs())
}

/// The same samples in another order give the same picture up to rounding.
///
/// Measured: the largest difference between the two pictures. Allowed: twice what [`constant_kept`] allows, for lights
/// up to `most`.
pub fn order_is_rounding(difference: &Image, most: f64, terms: usize, spread: f64) -> Residual {
    let found = difference.values().iter().map(|v| v.abs()).fold(0.0, f64::max);
    let bound = 4.0 * f64::EPSILON * terms as f64 * spread * most;
    Residual::at_most("the order of samples is rounding", found, bound)
}

/// What a sample's weight does to a pixel: the moments of `w = k(x)` and `L` for `x` uniform within the kernel's radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moments {
    /// `E[w]`.
    pub weight: f64,
    /// `E[w²]`.
    pub square: f64,
    /// `I = E[wL]/E[w]`: the pixel.
    pub pixel: f64,
    /// `E[w²L]`.
    pub square_light: f64,
    /// `E[w²(L − I)²]`.
    pub variance: f64,
}

impl Moments {
    /// For a kernel that is smooth between halves, and a smooth light; by quadrature.
    pub fn of(kernel: &dyn Kernel, light: impl Fn(f64) -> f64) -> Self {
        let radius = kernel.radius();
        let breaks = even_breaks(-radius, radius, 0.5);
        let mean = |f: &dyn Fn(f64, f64) -> f64| {
            integrate_pieces(|x| f(kernel.at(x), light(x)), &breaks, 1e-14).value / (2.0 * radius)
        };
        let weight = mean(&|w, _| w);
        let pixel = mean(&|w, l| w * l) / weight;
        Self {
            weight,
            square: mean(&|w, _| w * w),
            pixel,
            square_light: mean(&|w, l| w * w * l),
            variance: mean(&|w, l| (w * (l - pixel)).powi(2)),
        }
    }

    /// The bias of `Σ wL / Σ w` over `count` independent samples, to the first order:
    /// `(I·E[w²] − E[w²L])/(K·E[w]²)` (V13).
    pub fn bias(&self, count: usize) -> f64 {
        (self.pixel * self.square - self.square_light) / (count as f64 * self.weight * self.weight)
    }

    /// The standard deviation of that quotient, to the first order: `√(E[w²(L − I)²]/K)/E[w]`.
    pub fn deviation(&self, count: usize) -> f64 {
        (self.variance / count as f64).sqrt() / self.weight
    }
}

/// The mean of one pixel over films of `count` independent samples each, by the quotient of the sums, or by the sum
/// over the weight that is expected, `K·E[w]`.
///
/// # Errors
/// A kernel of infinite radius.
pub fn mean_pixel(
    kernel: &dyn Kernel,
    light: impl Fn(f64) -> f64,
    count: usize,
    trials: u32,
    seed: u64,
    divided: bool,
) -> Result<f64> {
    let film = Film::new(Grid::cells(-0.5..0.5, 1, -0.5..0.5, 1)?, kernel)?;
    let expected = count as f64 * Moments::of(kernel, &light).weight;
    let radius = kernel.radius();
    let mut sum = 0.0;
    for trial in 0..trials {
        let seed = bits(seed, trial.into(), 13);
        let sample = |i: usize| {
            let x = radius * (2.0 * uniform(seed, i as u64, 0) - 1.0);
            Sample { at: [x, 0.0], light: [light(x)] }
        };
        let exposure = film.develop(&(0..count).map(sample).collect::<Vec<_>>())?;
        // across the other axis all samples have the weight k(0)
        let whole = exposure.weights().at(0, 0) / (kernel.at(0.0) * expected);
        sum += exposure.image().at(0, 0) * if divided { 1.0 } else { whole };
    }
    Ok(sum / f64::from(trials))
}

/// The quotient of the sums is biased by what [`Moments::bias`] says (V13).
///
/// Measured: the difference of the bias found to the predicted one. Allowed: [`deviations`] of the mean over the trials,
/// and for the terms beyond the first the part `E[w²]/(K·E[w]²)` of it, the square of the sum's relative deviation and
/// more, in which the expansion goes on.
///
/// # Errors
/// A kernel of infinite radius.
pub fn ratio_bias(
    kernel: &dyn Kernel,
    light: impl Fn(f64) -> f64,
    count: usize,
    trials: u32,
    divided: bool,
) -> Result<Residual> {
    let moments = Moments::of(kernel, &light);
    let found = mean_pixel(kernel, light, count, trials, 1, divided)? - moments.pixel;
    let predicted = moments.bias(count);
    let next = predicted.abs() * moments.square / (count as f64 * moments.weight * moments.weight);
    let bound = deviations(1) * moments.deviation(count) / f64::from(trials).sqrt() + next;
    Ok(Residual::near("bias of a quotient of sums", found, predicted, bound))
}

/// Independent samples over a film of `side × side` pixels and a margin as wide as any of the kernels reaches.
fn scattered(side: usize, per_pixel: usize, light: impl Fn(f64, f64) -> f64) -> Vec<Sample<1>> {
    let (margin, width) = (4.0, side as f64);
    let count = per_pixel * (side + 8) * (side + 8);
    let place = |i: usize, d| uniform(5, i as u64, d) * (width + 2.0 * margin) - margin;
    (0..count).map(|i| [place(i, 0), place(i, 1)]).map(|[x, y]| Sample { at: [x, y], light: [light(x, y)] }).collect()
}

/// A film's kernels, with how far their amounts can exceed their sum where twelve and more samples a pixel weigh.
fn kernels() -> Vec<(Box<dyn Kernel>, f64)> {
    let lanczos = Lanczos::new(3.0).expect("three lobes");
    let gaussian = GaussianKernel::pbrt2();
    vec![
        (Box::new(BoxKernel), 1.0),
        (Box::new(TentKernel), 1.0),
        (Box::new(gaussian), 1.0),
        (Box::new(Cubic::mitchell()), 4.0),
        (Box::new(lanczos), 8.0),
    ]
}

const SIDE: usize = 12;
const PER_PIXEL: usize = 16;

fn terms(kernel: &dyn Kernel) -> usize {
    // three times as many as are expected
    (3.0 * PER_PIXEL as f64 * (2.0 * kernel.radius()).powi(2)) as usize
}

/// What one kernel makes of scattered samples.
struct Case {
    /// Of light 0.3 everywhere.
    flat: Image,
    /// Of the same without the division.
    undivided: Image,
    /// The differences that another order makes, and one sample fewer.
    reordered: Image,
    fewer: Image,
    terms: usize,
    spread: f64,
}

fn cases() -> Vec<Case> {
    let grid = Grid::pixels(SIDE, SIDE).expect("pixels");
    let flat = scattered(SIDE, PER_PIXEL, |_, _| 0.3);
    let samples = scattered(SIDE, PER_PIXEL, |x, y| (0.9 * x).sin() * (0.4 * y).cos());
    let reversed: Vec<_> = samples.iter().rev().copied().collect();
    // without the sample nearest to the middle of the film
    let far = |s: &Sample<1>| (s.at[0] - 6.5).hypot(s.at[1] - 6.5);
    let nearest = (0..samples.len()).min_by(|&a, &b| far(&samples[a]).total_cmp(&far(&samples[b]))).unwrap_or(0);
    let mut fewer = samples.clone();
    fewer.remove(nearest);
    let of = |(kernel, spread): (Box<dyn Kernel>, f64)| {
        let film = Film::new(grid, &*kernel).expect("a finite radius");
        let develop = |samples: &[Sample<1>]| film.develop(samples).expect("finite samples");
        let whole = develop(&samples);
        let change = |samples| whole.image().with(develop(samples).image(), |a, b| a - b).expect("one size");
        let (flat, terms) = (develop(&flat), terms(&*kernel));
        Case {
            undivided: flat.weights().map(|w| 0.3 * w / PER_PIXEL as f64),
            flat: flat.image().clone(),
            reordered: change(&reversed),
            fewer: change(&fewer),
            terms,
            spread,
        }
    };
    kernels().into_iter().map(of).collect()
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "film-constant",
        inventory: &["F56"],
        says: &Text::fixed(
            "A film that divides by the sum of the weights keeps a constant, however the samples are scattered",
            "Плёнка, которая делит на сумму весов, сохраняет постоянную при любом расположении отсчётов",
        ),
        holds: || cases().iter().map(|c| constant_kept(&c.flat, 0.3, c.terms, c.spread)).collect(),
        // not divided, only scaled to the mean density of the samples
        breaks: || cases().iter().map(|c| constant_kept(&c.undivided, 0.3, c.terms, c.spread)).collect(),
    },
    Law {
        name: "film-order",
        inventory: &["F56"],
        says: &Text::fixed(
            "The order of the samples changes a film by rounding only",
            "Порядок отсчётов меняет изображение на плёнке лишь в пределах округления",
        ),
        holds: || cases().iter().map(|c| order_is_rounding(&c.reordered, 1.0, c.terms, c.spread)).collect(),
        // a single sample left out is more than rounding
        breaks: || cases().iter().map(|c| order_is_rounding(&c.fewer, 1.0, c.terms, c.spread)).collect(),
    },
    Law {
        name: "film-bias",
        inventory: &["V13"],
        says: &Text::fixed(
            "The quotient of sums over K independent samples is biased by (I·E[w²] − E[w²L])/(K·E[w]²)",
            "Отношение сумм по K независимым отсчётам смещено на (I·E[w²] − E[w²L])/(K·E[w]²)",
        ),
        holds: || {
            let tent = [8, 32].map(|k| ratio_bias(&TentKernel, |x| x * x, k, 20_000, true).expect("a radius"));
            let mitchell = ratio_bias(&Cubic::mitchell(), |x| x * x, 64, 20_000, true).expect("a radius");
            tent.into_iter().chain([mitchell]).collect()
        },
        // over the weight that is expected there is no bias, and so not this one
        breaks: || [8, 32].map(|k| ratio_bias(&TentKernel, |x| x * x, k, 20_000, false).expect("a radius")).to_vec(),
    },
];
