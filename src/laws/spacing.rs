//! How far apart points are, and how densely they can lie (V21).

use crate::error::Result;
use crate::laws::Law;
use crate::laws::jitter::deviations;
use crate::num::random::uniform;
use crate::pattern::best_candidate::BestCandidate;
use crate::pattern::measure::distance::{min_distance, min_distance_torus, most_distance};
use crate::pattern::measure::periodogram::pattern_seed;
use crate::pattern::poisson_disk::{JAMMED, PoissonDisk};
use crate::pattern::{Pattern, catalog};
use crate::residual::Residual;
use crate::text::Text;

/// No `N` points on the unit torus are all farther apart than `√(2/(√3N))`, the distance in a hexagonal lattice (V21;
/// Thue 1910, Fejes Tóth 1940).
///
/// Measured: `distance`, the least of `count` points. Allowed beside the bound: 4ε of rounding.
pub fn packing(distance: f64, count: usize) -> Residual {
    Residual::at_most("least distance ≤ √(2/(√3N))", distance, most_distance(count) + 4.0 * f64::EPSILON)
}

/// A Poisson disk pattern keeps its radius on the torus.
///
/// Measured: how much nearer the two nearest points are. Allowed: the rounding of images across the edges, 4ε.
///
/// # Errors
/// No points, or points outside the unit square.
pub fn keeps_distance(points: &[[f64; 2]], radius: f64) -> Result<Residual> {
    let shortfall = (radius - min_distance_torus(points)?).max(0.0);
    Ok(Residual::at_most("no two points nearer than the radius", shortfall, 4.0 * f64::EPSILON))
}

/// A maximal Poisson disk pattern leaves no gap: every place is within the radius of a point, on the torus.
///
/// Measured: the greatest distance from any of `probes` random places to the nearest point, in radii; allowed: 1, and
/// 4ε of rounding per radius.
pub fn leaves_no_gap(points: &[[f64; 2]], radius: f64, probes: u64) -> Residual {
    // places by columns as wide as the radius, so that a probe meets three of them
    let columns = ((1.0 / radius) as usize).max(1);
    let column = |x: f64| ((x * columns as f64) as usize).min(columns - 1);
    let mut sorted: Vec<Vec<[f64; 2]>> = vec![Vec::new(); columns];
    points.iter().for_each(|p| sorted[column(p[0])].push(*p));
    let wrapped = |d: f64| d.abs().min(1.0 - d.abs());
    let farthest = (0..probes).map(|probe| {
        let [x, y] = [0, 1].map(|d| uniform(99, probe, d));
        let near = [columns - 1, 0, 1].map(|step| (column(x) + step) % columns);
        let distance = |p: &[f64; 2]| wrapped(p[0] - x).hypot(wrapped(p[1] - y));
        near.iter().flat_map(|&c| &sorted[c]).map(distance).fold(f64::INFINITY, f64::min)
    });
    let worst = farthest.fold(0.0, f64::max) / radius;
    Residual::at_most("every place is within the radius of a point", worst, 1.0 + 4.0 * f64::EPSILON / radius)
}

/// Random sequential addition of disks jams when they cover 0.547 of the plane (V21): a maximal pattern of radius `r` on
/// the torus has `N = (4/π)·0.547/r²` points.
///
/// Measured: the deviation of the mean number of points over `patterns` from that. Allowed: `z` standard deviations of
/// the mean, where `Var N = P(0)·N` with the plateau `P(0) < 0.062` of the periodogram, and the 10⁻⁵ to which the
/// coverage is known.
pub fn jams(pattern: &PoissonDisk, patterns: u32) -> Residual {
    let disk = std::f64::consts::FRAC_PI_4 * pattern.radius().powi(2);
    let expected = JAMMED / disk;
    let count = |p| pattern.points(pattern_seed(3, p)).len() as f64;
    let mean = (0..patterns).map(count).sum::<f64>() / f64::from(patterns);
    let bound = deviations(1) * (0.062 * expected / f64::from(patterns)).sqrt() + 1e-5 / disk;
    Residual::near("disks cover 0.547 of the torus when they jam", mean, expected, bound)
}

fn disks(radius: f64) -> PoissonDisk {
    PoissonDisk::new(radius).expect("the radius is below a half")
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[
    Law {
        name: "packing",
        inventory: &["V21"],
        says: &Text::fixed(
            "N points on the unit torus cannot all be farther apart than √(2/(√3N))",
            "N точек на единичном торе не могут все быть дальше друг от друга, чем √(2/(√3N))",
        ),
        holds: || {
            let check = |pattern: Box<dyn Pattern<2>>| {
                let points = pattern.points(1);
                packing(min_distance_torus(&points).expect("points in the square"), points.len())
            };
            let all = |n| catalog::all(n).expect("a square power of two").into_iter().map(check).collect::<Vec<_>>();
            // two diagonal points, and the nearly hexagonal 4 × 7 of offset rows: the bound is nearly reached
            let rows = |i: usize| [(2 * (i % 4) + i / 4 % 2) as f64 / 8.0, (i / 4) as f64 / 8.0];
            let hexagonal: Vec<[f64; 2]> = (0..32).map(rows).collect();
            let few = [vec![[0.25, 0.25], [0.75, 0.75]], hexagonal];
            let few = few.map(|p| packing(min_distance_torus(&p).expect("points in the square"), p.len()));
            [all(64), all(1024), few.into()].concat()
        },
        // in a square with edges there is more room
        breaks: || {
            let corners = [[0.0, 0.0], [1.0, 1.0]];
            vec![packing(min_distance(&corners).expect("points in the square"), 2)]
        },
    },
    Law {
        name: "poisson-disk",
        inventory: &["V21", "F01"],
        says: &Text::fixed(
            "A maximal Poisson disk pattern keeps its radius and leaves no gap; its disks cover 0.547 of the torus",
            "Максимальный узор пуассоновских дисков выдерживает радиус и не оставляет просветов; диски покрывают 0,547 тора",
        ),
        holds: || {
            let check = |radius: f64| {
                let points = disks(radius).points(1);
                let distance = keeps_distance(&points, radius).expect("points in the square");
                [distance, leaves_no_gap(&points, radius, 100_000)]
            };
            let mut all: Vec<Residual> = [0.02, 0.05, 0.11, 0.3, 0.5].into_iter().flat_map(check).collect();
            all.extend([jams(&disks(0.01), 4), jams(&disks(0.03), 60)]);
            all
        },
        breaks: || {
            let best = BestCandidate::new(1000).expect("there are points").points(1);
            let radius = disks(0.026).radius(); // of about as many
            let sparse = disks(radius).with_rounds(0);
            vec![
                keeps_distance(&best, radius).expect("points in the square"),
                leaves_no_gap(&best, radius, 100_000),
                leaves_no_gap(&sparse.points(1), radius, 100_000),
                jams(&sparse, 20),
                jams(&disks(radius).bounded(), 20), // at edges there is more room
            ]
        },
    },
];
