//! Job g: sample patterns. What a result owes is measured: boxes that a net leaves empty, distances, gaps.

use crate::jobs::{Job, noise};
use crate::machine::Machine;
use crate::race::{Contender, Outcome, Race};
use nyquist::pattern::Pattern;
use nyquist::pattern::best_candidate::BestCandidate;
use nyquist::pattern::measure::discrepancy::star_discrepancy;
use nyquist::pattern::measure::elementary::net_quality;
use nyquist::pattern::poisson_disk::PoissonDisk;
use nyquist::pattern::scrambling::Scrambling;
use nyquist::pattern::sobol::Sobol;
use poisson::algorithm::{Bridson, Ebeida};
use poisson::{Builder, Type};
use rand6::SeedableRng;

pub const JOB: Job = Job { letter: "g", name: "points", about: "sample patterns and their discrepancy", run };

type Points = Vec<[f64; 2]>;

fn run(machine: &Machine, rounds: usize) -> Vec<Outcome> {
    let mut races = vec![sobol(1 << 14, machine), sobol(1 << 16, machine), sobol(1 << 18, machine)];
    for about in [15_000, 60_000, 240_000] {
        races.extend([false, true].map(|torus| disks(about, torus, machine)));
    }
    races.extend([false, true].map(|torus| maximal(60_000, torus, machine)));
    races.extend([4096, 16_384, 65_536].map(|n| best(n, machine)));
    races.extend([1024, 4096, 16_384].map(worst_box));
    races.into_iter().map(|race| race.run(JOB.letter, rounds)).collect()
}

/// What must be written: two numbers a point.
fn limit(points: usize, machine: &Machine) -> Option<(f64, String)> {
    Some((machine.least(16.0 * points as f64, 0.0, 1), "the points written once".to_owned()))
}

fn sobol(n: usize, machine: &Machine) -> Race<'static> {
    let owen = Sobol::new(n).expect("there can be so many").scrambled(Scrambling::Owen);
    let single = move |seed| -> Vec<[f32; 2]> {
        (0..n as u32).map(|i| [0, 1].map(|d| sobol_burley::sample(i, d, seed))).collect()
    };
    let four = move |seed| -> Vec<[f32; 2]> {
        (0..n as u32).map(|i| sobol_burley::sample_4d(i, 0, seed)).map(|[x, y, ..]| [x, y]).collect()
    };
    // a net of quality zero has a point in every elementary box
    let quality = |points: Points| f64::from(net_quality(&points, 2).expect("a power of two"));
    let wide = |points: Vec<[f32; 2]>| -> Points { points.into_iter().map(|p| p.map(f64::from)).collect() };
    Race {
        case: format!("Owen's Sobol', {n} × 2"),
        threads: 1,
        limit: limit(n, machine),
        allowed: 0.0,
        contenders: vec![
            Contender::ours(
                "nyquist, nested uniform, f64",
                || (),
                move |()| owen.points(1),
                move |(), points| quality(points),
            ),
            Contender::peer(
                "sobol_burley, hashed, f32, one by one",
                || (),
                move |()| single(1),
                move |(), points| quality(wide(points)),
            ),
            Contender::peer(
                "sobol_burley, hashed, f32, four dimensions",
                || (),
                move |()| four(1),
                move |(), points| quality(wide(points)),
            ),
        ],
    }
}

/// By how much two points are nearer than the radius, in parts of it.
fn nearer(points: &[[f64; 2]], torus: bool, radius: f64) -> f64 {
    use nyquist::pattern::measure::distance::{min_distance, min_distance_torus};
    let least = if torus { min_distance_torus(points) } else { min_distance(points) };
    (1.0 - least.expect("there are two points in the square") / radius).max(0.0)
}

/// Places of the unit square from coordinates up to `width`, where they may have been rounded up to.
fn scaled(points: impl Iterator<Item = [f64; 2]>, width: f64) -> Points {
    points.map(|p| p.map(|c| (c / width).min(1.0f64.next_down()))).collect()
}

fn disks(about: usize, torus: bool, machine: &Machine) -> Race<'static> {
    let pattern = PoissonDisk::with_about(about).expect("a number of disks");
    let radius = pattern.radius();
    let pattern = if torus { pattern } else { pattern.bounded() };
    let width = radius.recip() as f32;
    let bluenoise = move || -> Vec<glam::Vec2> {
        if torus {
            bluenoise::WrappingBlueNoise::<rand_pcg::Pcg64Mcg>::from_seed(width, width, 1.0, 1).collect()
        } else {
            bluenoise::BlueNoise::<rand_pcg::Pcg64Mcg>::from_seed(width, width, 1.0, 1).collect()
        }
    };
    let theirs =
        move |points: Vec<glam::Vec2>| scaled(points.into_iter().map(|p| [p.x, p.y].map(f64::from)), f64::from(width));
    Race {
        case: format!("disks, about {about}{}", if torus { ", torus" } else { "" }),
        threads: 1,
        limit: limit(about, machine),
        // four coordinates of single precision, each rounded to half an ulp of a place up to the width
        allowed: 4.0 * f64::from(width * f32::EPSILON),
        contenders: vec![
            Contender::ours(
                "nyquist, maximal",
                || (),
                move |()| pattern.points(1),
                move |(), points: Points| nearer(&points, torus, radius),
            ),
            Contender::peer(
                "bluenoise, f32, not maximal",
                || (),
                move |()| bluenoise(),
                move |(), points| nearer(&theirs(points), torus, radius),
            ),
        ],
    }
}

/// The part of random places that are at least the radius away from all points: gaps.
fn gaps(points: &[[f64; 2]], torus: bool, radius: f64) -> f64 {
    let side = (1.0 / radius) as i64;
    let mut cells = vec![Vec::new(); (side * side) as usize];
    let cell = |place: [f64; 2]| place.map(|c| (c * side as f64) as i64);
    for point in points {
        let [x, y] = cell(*point);
        cells[(y * side + x) as usize].push(*point);
    }
    let places: Vec<f64> = noise(200_000).map(|u| 0.5 * (u + 1.0)).collect();
    let free = |place: [f64; 2]| {
        let [x, y] = cell(place);
        (0..9).map(|i| [x + i % 3 - 1, y + i / 3 - 1]).all(|[x, y]| {
            let beyond = !(0..side).contains(&x) || !(0..side).contains(&y);
            let images = [x.div_euclid(side), y.div_euclid(side)].map(|turns| turns as f64);
            let near = |p: &[f64; 2]| (p[0] + images[0] - place[0]).hypot(p[1] + images[1] - place[1]) < radius;
            let points = &cells[(y.rem_euclid(side) * side + x.rem_euclid(side)) as usize];
            (beyond && !torus) || !points.iter().any(near)
        })
    };
    places.chunks_exact(2).filter(|p| free([p[0], p[1]])).count() as f64 / 100_000.0
}

fn maximal(about: usize, torus: bool, machine: &Machine) -> Race<'static> {
    type Vector = nalgebra::Vector2<f64>;
    let pattern = PoissonDisk::with_about(about).expect("a number of disks");
    let radius = pattern.radius();
    let pattern = if torus { pattern } else { pattern.bounded() };
    let kind = if torus { Type::Perioditic } else { Type::Normal };
    let theirs = move |ebeida: bool| -> Points {
        let random = rand6::rngs::SmallRng::from_seed([7; 16]);
        let builder = Builder::<_, Vector>::with_radius(0.5 * radius, kind);
        let points =
            if ebeida { builder.build(random, Ebeida).generate() } else { builder.build(random, Bridson).generate() };
        points.into_iter().map(|p| [p.x, p.y]).collect()
    };
    let error = move |points: Points| nearer(&points, torus, radius).max(gaps(&points, torus, radius));
    Race {
        case: format!("maximal disks, about {about}{}", if torus { ", torus" } else { "" }),
        threads: 1,
        limit: limit(about, machine),
        // of the radius, by rounding; and of 10⁵ places, none
        allowed: 8.0 * f64::EPSILON / radius,
        contenders: vec![
            Contender::ours("nyquist", || (), move |()| pattern.points(1), move |(), points| error(points)),
            Contender::peer("poisson, Ebeida", || (), move |()| theirs(true), move |(), points| error(points)),
            Contender::peer("poisson, Bridson", || (), move |()| theirs(false), move |(), points| error(points)),
        ],
    }
}

fn best(n: usize, machine: &Machine) -> Race<'static> {
    let ours = BestCandidate::new(n).expect("there can be so many");
    // how many independent points would be as near as the nearest two: none here, and the same for both
    let near = move |points: Points| nearer(&points, true, 0.3 / (n as f64).sqrt());
    Race {
        case: format!("best of 10 candidates, {n}"),
        threads: 1,
        limit: limit(n, machine),
        allowed: 0.5,
        contenders: vec![
            Contender::ours("nyquist", || (), move |()| ours.points(1), move |(), points| near(points)),
            Contender::peer(
                "a plain grid of lists",
                || (),
                move |()| plain_grid(n, 10),
                move |(), points| near(points),
            ),
        ],
    }
}

/// No library has it: what one writes who knows that a grid is needed, of one point a cell in the end.
fn plain_grid(n: usize, candidates: usize) -> Points {
    let side = (n as f64).sqrt() as i64;
    let mut cells: Vec<Points> = vec![Vec::new(); (side * side) as usize];
    let mut random = noise(2 * n * candidates).map(|u| 0.5 * (u + 1.0));
    for _ in 0..n {
        let (mut best, mut farthest) = ([0.0; 2], -1.0);
        for _ in 0..candidates {
            let place = [0, 1].map(|_| random.next().expect("two for each candidate"));
            let [cx, cy] = place.map(|c| (c * side as f64) as i64);
            let mut nearest = f64::INFINITY;
            for ring in 0..=side / 2 {
                let reach = (ring - 1).max(0) as f64 / side as f64;
                if (ring > 0 && nearest <= reach * reach) || nearest <= farthest {
                    break;
                }
                for dy in -ring..=ring {
                    let step = if dy.abs() == ring { 1 } else { 2 * ring };
                    for dx in (-ring..=ring).step_by(step as usize) {
                        let [x, y] = [cx + dx, cy + dy].map(|c| c.rem_euclid(side));
                        for point in &cells[(y * side + x) as usize] {
                            let apart = [0, 1].map(|d| (place[d] - point[d]).abs()).map(|a: f64| a.min(1.0 - a));
                            nearest = nearest.min(apart[0] * apart[0] + apart[1] * apart[1]);
                        }
                    }
                }
            }
            if nearest > farthest {
                (best, farthest) = (place, nearest);
            }
        }
        let [x, y] = best.map(|c| (c * side as f64) as i64);
        cells[(y * side + x) as usize].push(best);
    }
    cells.concat()
}

fn worst_box(n: usize) -> Race<'static> {
    let points: Points = Sobol::new(n).expect("there can be so many").scrambled(Scrambling::Owen).points(1);
    let theirs = points.clone();
    let (ours, known) = (star_discrepancy(&points).expect("points of the square"), textbook(&points));
    Race {
        case: format!("star discrepancy of {n}"),
        threads: 1,
        limit: None,
        // a product and a sum of numbers up to one, in either
        allowed: 4.0 * f64::EPSILON,
        contenders: vec![
            Contender::ours(
                "nyquist",
                || (),
                move |()| star_discrepancy(&points).expect("points of the square"),
                move |(), found| (found - known).abs(),
            ),
            Contender::peer(
                "the textbook's O(N²)",
                || (),
                move |()| textbook(&theirs),
                move |(), found| (found - ours).abs(),
            ),
        ],
    }
}

/// For every x the ordinates so far, kept sorted: all boxes (Niederreiter 1992, theorem 2.6, in the plane).
fn textbook(points: &[[f64; 2]]) -> f64 {
    let n = points.len() as f64;
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let (mut ys, mut worst) = (Vec::new(), 0.0f64);
    for column in sorted.chunk_by(|a, b| a[0] == b[0]).map(Some).chain([None]) {
        let x = column.map_or(1.0, |column| column[0][0]);
        for (j, y) in ys.iter().chain(&[1.0]).enumerate() {
            worst = worst.max(x * y - j as f64 / n);
        }
        for point in column.unwrap_or(&[]) {
            ys.insert(ys.partition_point(|y| *y <= point[1]), point[1]);
        }
        for (j, y) in ys.iter().enumerate() {
            worst = worst.max((j + 1) as f64 / n - x * y);
        }
    }
    worst
}
