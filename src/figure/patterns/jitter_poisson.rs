//! Jitter beside Poisson disks: two ways to push noise up.

use crate::error::Result;
use crate::figure::params::Param;
use crate::figure::patterns::square::{SEED, SEEDS, for_all_seeds, frequencies, points_panel, power_panel};
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::laws::point_spectra::{Model, PLATEAU, follows, in_band};
use crate::pattern::Pattern;
use crate::pattern::jittered::Jittered;
use crate::pattern::measure::distance::min_distance_torus;
use crate::pattern::measure::periodogram::{Periodogram, pattern_seed};
use crate::pattern::measure::radial::{Ring, rings};
use crate::pattern::poisson_disk::PoissonDisk;
use crate::residual::Residual;
use crate::text;
use crate::text::{Text, number};

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[BOTH];

const BOTH: Entry = Entry {
    id: "x-jitter-poisson",
    inventory: &[],
    errata: &["E11"],
    title: &Text::fixed("256 points: jitter and Poisson disk", "256 точек: джиттер и диски Пуассона"),
    caption: &Text::fixed(
        "Jitter's noise rises from zero with the square of the frequency; Poisson disks keep a plateau of 0.06 down to zero, \
         but a far wider quiet disk, and a ring about it. Jitter wins for very low frequencies, disks up to √N: fewer clumps \
         to see, yet a variance that falls as 1/N only. Frequencies in units of √N.",
        "Шум джиттера растёт от нуля как квадрат частоты; у дисков Пуассона до самого нуля держится плато 0,06, зато тихий \
         круг куда шире, и вокруг него кольцо. На самых низких частотах выигрывает джиттер, до √N — диски: комков видно \
         меньше, но дисперсия убывает лишь как 1/N. Частоты — в единицах √N.",
    ),
    params: &[Param::count("seed", &SEED, 1, 1, SEEDS)],
    build: |params| both(params.count("seed") as u64),
};

fn both(seed: u64) -> Result<Figure> {
    const CELLS: usize = 16;
    const REACH: usize = 48;
    const PATTERNS: u32 = 80;
    const WIDTH: f64 = 1.5;
    let jitter = Jittered::<2>::new([CELLS, CELLS])?;
    let disks = PoissonDisk::with_about(CELLS * CELLS)?;
    let of = |pattern: &dyn Pattern<2>| Periodogram::mean(pattern, seed, PATTERNS, REACH);
    let (jittered, spread) = (of(&jitter)?, of(&disks)?);
    let unit = CELLS as f64;
    let curves = [rings(&jittered, WIDTH)?, rings(&spread, WIDTH)?];
    let model = Model::Jittered([CELLS, CELLS], 1.0);
    // the model averaged over the frequencies of each ring
    let mut theory = vec![[0.0; 3]; curves[0].len()];
    for (frequency, _) in jittered.half() {
        let radius = (frequency[0] as f64).hypot(frequency[1] as f64);
        if let Some(sum) = theory.get_mut((radius / WIDTH) as usize) {
            let [noise, _] = model.at(frequency);
            [1.0, radius, noise].iter().zip(sum).for_each(|(term, sum)| *sum += term);
        }
    }
    let theory: Vec<[f64; 2]> =
        theory.iter().map(|[bins, radius, noise]| [radius / bins / unit, noise / bins]).collect();
    let places = |rings: &[Ring]| rings.iter().map(|r| [r.frequency / unit, r.power]).collect::<Vec<_>>();
    let top = curves[1].iter().map(|ring| ring.power).fold(1.0, f64::max);
    let radial = Panel::new(
        "radial",
        text!("means over rings", "средние по кольцам"),
        frequencies(Text::same("|ν|/√N"), REACH as f64 / unit),
        Scale::linear(text!("power", "мощность"), 0.0, 1.15 * top),
    )
    .span(4)
    .legend(Legend::Above)
    .with(Layer::horizontals("plateau", Meaning::Guide, [PLATEAU[0]]).dashed())
    .with(
        Layer::line("disks", Meaning::Signal, places(&curves[1]))
            .thick()
            .label(text!("Poisson disk", "диски Пуассона")),
    )
    .with(Layer::dots("jitter", Meaning::Samples, places(&curves[0])).label(text!("jitter", "джиттер")))
    .with(
        Layer::line("theory", Meaning::Theory, theory.iter().copied())
            .label(text!("theory of jitter", "теория джиттера")),
    );
    let drawn = |pattern: &dyn Pattern<2>| pattern.points(pattern_seed(seed, 0));
    let (first, second) = (drawn(&jitter), drawn(&disks));
    let [low, error] = in_band(&spread, [0.02, 0.1]);
    let [of_jitter, _] = in_band(&jittered, [0.02, 0.1]);
    let ring = curves[1].iter().max_by(|a, b| a.power.total_cmp(&b.power));
    let (at, peak, deviation) = ring.map_or((0.0, 0.0, 0.0), |r| (r.frequency / unit, r.power, r.deviation(PATTERNS)));
    let z = for_all_seeds(1);
    Ok(Figure::new(4)
        .heights([1.0, 1.0])
        .with(points_panel("jittered", text!("jitter", "джиттер"), &first))
        .with(power_panel("jittered-power", text!("its power", "его мощность"), &jittered, unit, (0.0, 2.0)))
        .with(points_panel("disks", text!("Poisson disk", "диски Пуассона"), &second))
        .with(power_panel("disks-power", text!("its power", "их мощность"), &spread, unit, (0.0, 2.0)))
        .with(radial)
        .claim(
            text!(
                "jitter follows 1 − sinc²·sinc² at every frequency",
                "джиттер на всех частотах следует 1 − sinc²·sinc²"
            ),
            follows(&jittered, model, SEEDS),
        )
        .claim(
            text!(
                "near zero Poisson disks have a plateau of {}, jitter {}",
                "вблизи нуля у дисков Пуассона плато {}, у джиттера {}",
                number(low, 2),
                number(of_jitter, 2)
            ),
            Residual::near("plateau of a Poisson disk pattern", low, PLATEAU[0], z * (error + PLATEAU[1])),
        )
        .claim(
            text!("the ring of the disks: {} at {}·√N", "кольцо дисков: {} на {}·√N", number(peak, 2), number(at, 2)),
            Residual::at_least("ring of a Poisson disk pattern above 1.6", peak + z * deviation, 1.6),
        )
        .claim(
            text!(
                "least distances on the torus: disks {}, jitter {}",
                "наименьшие расстояния на торе: диски {}, джиттер {}",
                number(min_distance_torus(&second)?, 2),
                number(min_distance_torus(&first)?, 1)
            ),
            Residual::at_least(
                "disks keep their radius",
                min_distance_torus(&second)? + 4.0 * f64::EPSILON,
                disks.radius(),
            ),
        ))
}
