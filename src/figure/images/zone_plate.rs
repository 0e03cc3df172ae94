//! Prealiasing and postaliasing told apart (V27; Mitchell and Netravali 1988, Hanrahan's test with two halves).

use crate::axis::{Axis, Edge};
use crate::error::Result;
use crate::field::zone_plate::ZonePlate;
use crate::figure::images::view::picture;
use crate::figure::params::Param;
use crate::figure::picture::{frame, part};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::grid::Grid;
use crate::image::dft::forward;
use crate::image::resize::resample;
use crate::image::{Image, ImageBins};
use crate::kernel::Kernel;
use crate::kernel::box_kernel::BoxKernel;
use crate::kernel::cubic::Cubic;
use crate::kernel::kaiser::Kaiser;
use crate::kernel::tent::TentKernel;
use crate::laws::coverage::ghosts_repeat;
use crate::laws::plane::transform_rounding;
use crate::num::cos_pi;
use crate::residual::Residual;
use crate::text;
use crate::text::{Lang, Text, number};
use std::f64::consts::PI;

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[PLATE];

static RADIUS: Text = Text::fixed("radius of the wide kernel, in samples", "радиус широкого ядра, в отсчётах");

const PLATE: Entry = Entry {
    id: "x-zone-plate",
    inventory: &[],
    errata: &[],
    title: &Text::fixed("Aliasing before and after the samples", "Алиасинг до отсчётов и после них"),
    caption: &Text::fixed(
        "A zone plate has one centre; its 128 × 128 samples have four, and three of them are false: prealiasing, which no \
         kernel can undo. What the kernel adds is postaliasing, frequencies above ½ that are no longer in the samples: \
         the blocks of the box, the beats of tent and Mitchell. A sinc 30 samples wide removes that, and leaves clean rings, \
         which in the crop are all false. The crop is enlarged four times by each kernel.",
        "У зонной пластинки один центр, а у её 128 × 128 отсчётов — четыре, и три из них ложные: это преалиасинг, его не \
         исправит никакое ядро. Само ядро добавляет посталиасинг — частоты выше ½, которых в отсчётах уже нет: блоки у \
         box-ядра, биения у треугольника и Митчелла. Sinc шириной 30 отсчётов убирает их и оставляет чистые кольца — в этом \
         фрагменте все ложные. Фрагмент увеличен каждым ядром вчетверо.",
    ),
    params: &[Param::real("radius", &RADIUS, 15.0, 4.0, 20.0, "")],
    build: |params| plate(params.real("radius")),
};

/// Samples along a side, and the period `M` of the zone plate: they are one period of a picture without an end.
const SIDE: usize = 128;
/// How many times finer the reconstruction is.
const FINER: usize = 4;
/// The corner and the side of the crop, in samples.
const CROP: ([usize; 2], usize) = ([72, 0], 40);

/// `β` of the wide kernel: it leaks −80 dB.
const BETA: f64 = 8.0;

/// One reconstruction of the samples.
struct Back {
    name: &'static str,
    title: Text,
    /// The kernel at the places of the reconstruction on one side of a sample: `[t, weight]`.
    taps: Vec<[f64; 2]>,
    image: Image,
    bins: ImageBins,
}

impl Back {
    fn of(samples: &Image, name: &'static str, title: Text, kernel: &dyn Kernel) -> Result<Self> {
        // four places around every sample, none at the edge of its box
        let part = 1.0 / FINER as f64;
        let axis = Axis::new(0.5 * part - 0.5, part, FINER * SIDE)?;
        let image = resample(samples, Grid::new(axis, axis)?, kernel, Edge::Wrap)?;
        let bins = forward(&image);
        // the weights at each place are divided by their sum over the samples
        let weight = |t: f64| part * kernel.at(t) / kernel.periodic(t, 1);
        let count = (kernel.radius() / part).ceil() as usize;
        let taps = (0..count).map(|j| (j as f64 + 0.5) * part).map(|t| [t, weight(t)]).collect();
        Ok(Self { name, title, taps, image, bins })
    }

    /// What the kernel, sampled as finely as the reconstruction, does to the frequency `nu`.
    fn gain(&self, nu: f64) -> f64 {
        self.taps.iter().map(|[t, weight]| 2.0 * weight * cos_pi(2.0 * nu * t)).sum()
    }

    /// The gains at all bins of the reconstruction, from zero to half of them.
    fn gains(&self) -> Vec<f64> {
        (0..=FINER * SIDE / 2).map(|k| self.gain(k as f64 / SIDE as f64)).collect()
    }

    /// The part of the energy of the samples that stands at frequencies above `guard` along either axis, and what the gains
    /// say of it.
    fn beyond(&self, samples: &ImageBins, energy: f64, guard: f64) -> [f64; 2] {
        let half = (FINER * SIDE / 2) as i64;
        let gains = self.gains();
        let gain = |k: i64| gains[k.unsigned_abs() as usize];
        let above = |k: i64| k.unsigned_abs() as f64 > guard * SIDE as f64;
        let (mut found, mut known) = (0.0, 0.0);
        for l in -half..half {
            for k in (-half..half).filter(|&k| above(k) || above(l)) {
                found += self.bins.bin(k, l).norm_sqr();
                known += samples.bin(k, l).norm_sqr() * (gain(k) * gain(l)).powi(2);
            }
        }
        [found / energy, known / energy]
    }

    /// The largest difference between places on both sides of the middle: true centre and ghost.
    fn asymmetry(&self) -> f64 {
        let n = FINER * SIDE;
        let mirror = |j: usize| (n + FINER - 1 - j) % n;
        let differences = (0..n)
            .flat_map(|j| (0..n / 2).map(move |i| (i, j)))
            .map(|(i, j)| self.image.at(i, j) - self.image.at(mirror(i), j));
        differences.map(f64::abs).fold(0.0, f64::max)
    }

    fn panel(&self) -> Result<Panel> {
        Ok(picture(self.name, self.title.clone(), &crop(&self.image)?, (0.0, 1.0)))
    }
}

/// The crop of a picture that is `FINER` times as fine as the samples.
fn crop(image: &Image) -> Result<Image> {
    let ([left, low], side) = CROP;
    let along = |first: usize| FINER * first..FINER * (first + side);
    part(image, along(left), along(low))
}

fn plate(radius: f64) -> Result<Figure> {
    let field = ZonePlate::new(SIDE as f64)?;
    let axis = Axis::new(0.0, 1.0, SIDE)?;
    let samples = Image::of(&field, Grid::new(axis, axis)?);
    let bins = forward(&samples);
    let backs = [
        Back::of(&samples, "box", text!("box", "прямоугольник"), &BoxKernel)?,
        Back::of(&samples, "tent", text!("tent", "треугольник"), &TentKernel)?,
        Back::of(&samples, "mitchell", text!("Mitchell", "Митчелл"), &Cubic::mitchell())?,
        Back::of(&samples, "kaiser", text!("wide Kaiser sinc", "широкий sinc Кайзера"), &Kaiser::new(radius, BETA)?)?,
    ];

    let ([left, low], side) = CROP;
    let [x, y] = [left, low].map(|first| [first as f64 - 0.5, (first + side) as f64 - 0.5]);
    let end = SIDE as f64;
    let whole = picture("samples", text!("128² samples", "128² отсчётов"), &samples, (0.0, 1.0))
        .with(frame("crop", Meaning::Leaked, x, y).thick());
    let fine = Axis::new(-0.375, 0.25, FINER * SIDE)?;
    let truth = crop(&Image::of(&field, Grid::new(fine, fine)?))?;
    let original = picture("original", text!("crop: the true rings", "фрагмент: верные кольца"), &truth, (0.0, 1.0));

    // where the wide kernel has let everything go: Nyquist and half its transition
    let guard = 0.5 + (BETA * BETA + PI * PI).sqrt() / (2.0 * PI * radius);
    let shown = 1.5;
    let mut gain = Panel::new(
        "gain",
        text!("gain of the kernels", "усиление ядер"),
        Scale::linear(text!("periods per sample", "периодов на отсчёт"), 0.0, shown),
        Scale::linear(Text::EMPTY, -0.3, 1.1),
    )
    .legend(Legend::UpperRight)
    .span(2)
    .with(Layer::spans("postaliasing", Meaning::Leaked, [[0.5, shown]]).label(text!("postaliasing", "посталиасинг")));
    for (i, back) in (0u8..).zip(&backs) {
        let curve = Layer::curve(back.name, Meaning::Series(i), 0.0, shown, 300, |nu| back.gain(nu));
        gain = gain.with(curve.thick().label(back.title.clone()));
    }
    // measured where the samples have something at (k, 0): the gain at zero along the other axis is one
    let most = (1..SIDE as i64 / 2).map(|k| bins.bin(k, 0).norm()).fold(0.0, f64::max);
    let dots = |back: &Back| {
        let strong = (2..(shown * end) as i64).step_by(6).filter(|&k| bins.bin(k, 0).norm() > 0.5 * most);
        strong.map(|k| [k as f64 / end, (back.bins.bin(k, 0) / bins.bin(k, 0)).re]).collect::<Vec<_>>()
    };
    for (i, back) in (0u8..).zip(&backs) {
        gain = gain.with(Layer::dots("measured", Meaning::Series(i), dots(back)));
    }

    let ghosts = backs.iter().map(Back::asymmetry).fold(0.0, f64::max);
    let energy = bins.values().iter().map(|f| f.norm_sqr()).sum::<f64>() - bins.bin(0, 0).norm_sqr();
    let mut figure = Figure::new(4).with(whole).with(original);
    figure = figure.with(backs[0].panel()?).with(backs[1].panel()?).with(gain).with(backs[2].panel()?);
    figure = figure
        .with(backs[3].panel()?)
        .claim(
            text!(
                "the samples repeat with the period M = {SIDE}: ghosts as sharp as the true centre",
                "отсчёты периодичны с периодом M = {SIDE}: ложные центры столь же резки, как настоящий"
            ),
            ghosts_repeat(SIDE as u32, SIDE as i32 / 4)?,
        )
        .claim(
            text!(
                "prealiasing stays: with every kernel the ghost at (M, 0) is the mirror image of the true centre",
                "преалиасинг остаётся: при любом ядре ложный центр (M, 0) — зеркальное отражение настоящего"
            ),
            // sums of at most (2·20 + 1)² products, in either order
            Residual::at_most(
                "f̃(M − x, y) = f̃(x, y)",
                ghosts,
                2.0 * (2.0 * radius.max(2.0) + 1.0).powi(2) * f64::EPSILON,
            ),
        );
    for back in &backs {
        let [found, known] = back.beyond(&bins, energy, guard);
        let at = number(guard, 2);
        let (size, title) = (number(100.0 * found, 2), &back.title);
        let (en, ru) = (title.get(Lang::En), title.get(Lang::Ru));
        let says = match found {
            found if found > 1e-4 => text!(
                "postaliasing, {en}: {size} % of the samples' energy stands above the frequency {at}",
                "посталиасинг, {ru}: {size} % энергии отсчётов — выше частоты {at}"
            ),
            _ => text!(
                "postaliasing, {en}: less than 0.01 % of the samples' energy stands above the frequency {at}",
                "посталиасинг, {ru}: менее 0.01 % энергии отсчётов — выше частоты {at}"
            ),
        };
        // the transform's rounding, relative to the root of the whole energy: twice in a square, three times with the mean
        let rounding = 6.0 * transform_rounding(SIDE * SIDE * FINER * FINER);
        figure = figure.claim(says, Residual::near("energy above the guard = Σ|F|²·K²", found, known, rounding));
    }
    Ok(figure)
}
