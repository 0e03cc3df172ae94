//! Resizing against the sums that it stands for, in every kind of number and on any number of threads.

use crate::oracle::noise;
use nyquist::axis::{Axis, Edge};
use nyquist::door::srgb::srgb_to_linear;
use nyquist::engine::Arithmetic;
use nyquist::engine::resize::{Code, Light, Resizer, Taps, View, ViewMut};
use nyquist::error::Error;
use nyquist::image::resize::resize;
use nyquist::image::resizing::Resizing;
use nyquist::image::weights::Weights;
use nyquist::kernel::catalog;
use nyquist::prelude::*;

/// Smaller, larger, both, hardly, many more pixels than a group, a panel or a window has, and one.
const SIZES: [([usize; 2], [usize; 2]); 13] = [
    ([37, 29], [11, 8]),
    ([11, 8], [37, 29]),
    ([40, 9], [12, 20]),
    ([9, 40], [20, 12]),
    ([30, 20], [31, 19]),
    ([600, 7], [90, 5]),
    ([150, 9], [600, 20]),
    ([9, 130], [12, 330]),
    ([200, 400], [60, 110]),
    ([2500, 90], [300, 40]),
    ([90, 12], [2500, 30]),
    ([1, 1], [5, 3]),
    ([5, 3], [1, 1]),
];

/// The weights of an axis, as they are written in a textbook, and the largest `Σ|w|`.
struct Direct {
    rows: Vec<(i64, Vec<f64>)>,
    gain: f64,
}

impl Direct {
    fn new(old: usize, new: usize, kernel: &dyn Kernel) -> Self {
        let ratio = old as f64 / new as f64;
        let stretch = ratio.max(1.0);
        let reach = kernel.radius() * stretch;
        let row = |j: usize| {
            let at = (j as f64 + 0.5) * ratio - 0.5;
            let first = (at - reach).ceil() as i64;
            let read: Vec<f64> =
                (first..=(at + reach).floor() as i64).map(|i| kernel.at((at - i as f64) / stretch)).collect();
            let sum: f64 = read.iter().sum();
            (first, read.into_iter().map(|w| w / sum).collect())
        };
        let rows: Vec<(i64, Vec<f64>)> = (0..new).map(row).collect();
        let gain = rows.iter().map(|(_, w)| w.iter().map(|w| w.abs()).sum()).fold(0.0, f64::max);
        Self { rows, gain }
    }

    fn most(&self) -> usize {
        self.rows.iter().map(|(_, w)| w.len()).max().unwrap_or(0)
    }
}

/// `Σ_y w_y Σ_x w_x f`, and how far from it rounding may lead in a number type of this `ε`, for values up to one: a weight, a
/// product and the additions of each pass round once each, and weights here differ from the engine's by the rounding of
/// positions in 64 bits.
fn direct(
    f: &[f64],
    [old, new]: [[usize; 2]; 2],
    channels: usize,
    kernel: &dyn Kernel,
    edge: Edge,
    epsilon: f64,
) -> (Vec<f64>, f64) {
    let [across, down] = [0, 1].map(|i| Direct::new(old[i], new[i], kernel));
    let mut sums = Vec::with_capacity(new[0] * new[1] * channels);
    for (top, rows) in &down.rows {
        for (left, columns) in &across.rows {
            for c in 0..channels {
                let mut sum = 0.0;
                for (y, wy) in (*top..).zip(rows) {
                    for (x, wx) in (*left..).zip(columns) {
                        if let (Some(x), Some(y)) = (edge.index(x, old[0]), edge.index(y, old[1])) {
                            sum += wy * wx * f[(y * old[0] + x) * channels + c];
                        }
                    }
                }
                sums.push(sum);
            }
        }
    }
    let gain = across.gain * down.gain;
    let steps = (across.most() + down.most() + 4) as f64 * epsilon;
    // a position among n pixels is right to 2ε·n, so a weight, of a slope below 2, to 4ε·n, and to twice that beside its sum
    let arguments = 8.0 * (old[0] * across.most() + old[1] * down.most()) as f64 * f64::EPSILON;
    let oracle = (across.most() * down.most()) as f64 * f64::EPSILON;
    (sums, (steps + arguments + oracle) * gain)
}

fn plan<C: Code>(
    old: [usize; 2],
    new: [usize; 2],
    kernel: &dyn Kernel,
    edge: Edge,
    arithmetic: Arithmetic,
) -> Resizer<C::Sum> {
    let taps = |i: usize| {
        let axis = |n| Axis::cells(0.0..old[i] as f64, n).expect("sizes and kernels are good");
        Weights::of(axis(old[i]), axis(new[i]), kernel)
            .expect("sizes and kernels are good")
            .taps(edge)
            .expect("sizes and kernels are good")
    };
    Resizer::new(taps(0), taps(1), arithmetic)
}

/// What an engine makes of an image, written between numbers that must stay.
fn resized<C: Code + PartialEq>(resizer: &Resizer<C::Sum>, image: &[C], channels: usize, mark: C) -> Vec<C> {
    let ([width, _], [new, height]) = (resizer.old(), resizer.new_size());
    let (row, stride) = (new * channels, new * channels + 3);
    let mut out = vec![mark; height * stride];
    let view = View::new(image, resizer.old(), channels, width * channels).expect("sizes and kernels are good");
    resizer
        .run(view, ViewMut::new(&mut out, [new, height], channels, stride).expect("sizes and kernels are good"))
        .expect("sizes and kernels are good");
    assert!(
        out.chunks(stride).all(|line| line[row..].iter().all(|v| *v == mark)),
        "between the rows nothing is written"
    );
    out.chunks(stride).flat_map(|line| &line[..row]).copied().collect()
}

/// Every size, with kernels, edges and channels in turn.
fn cases() -> impl Iterator<Item = (usize, [[usize; 2]; 2], Box<dyn Kernel>, Edge)> {
    let names = ["mitchell", "lanczos-3", "catmull-rom", "tent"];
    SIZES.into_iter().zip(0..).flat_map(move |((old, new), i)| {
        (0..4).map(move |j| {
            (
                1 + (i + j) % 4,
                [old, new],
                catalog::by_name(names[(i / 2 + j) % 4]).expect("sizes and kernels are good"),
                Edge::ALL[j],
            )
        })
    })
}

#[test]
fn numbers_become_the_weighted_sums() {
    for (channels, sizes, kernel, edge) in cases() {
        let [old, new] = sizes;
        let f: Vec<f64> = noise(old[0] * old[1] * channels, 3).iter().map(|v| v.tanh()).collect();
        let f32s: Vec<f32> = f.iter().map(|v| *v as f32).collect();
        let shorter: Vec<f64> = f32s.iter().map(|v| f64::from(*v)).collect();
        let name = kernel.name();
        let (sums, bound) = direct(&f, sizes, channels, &kernel, edge, f64::EPSILON);
        let (shorter_sums, shorter_bound) = direct(&shorter, sizes, channels, &kernel, edge, f64::from(f32::EPSILON));
        for arithmetic in [Arithmetic::Plain, Arithmetic::Fused] {
            let got = resized(&plan::<f64>(old, new, &kernel, edge, arithmetic), &f, channels, 7.0);
            for (got, sum) in got.iter().zip(&sums) {
                assert!(
                    (got - sum).abs() <= bound,
                    "{old:?} to {new:?}, {name}, {edge:?}: {got} for {sum} ± {bound:e}"
                );
            }
            let got = resized(&plan::<f32>(old, new, &kernel, edge, arithmetic), &f32s, channels, 7.0);
            for (got, sum) in got.iter().zip(&shorter_sums) {
                let differ = (f64::from(*got) - sum).abs();
                assert!(differ <= shorter_bound, "{old:?} to {new:?}, {name}, {edge:?}: {got} for {sum}");
            }
        }
    }
}

#[test]
fn codes_are_rounded_once() {
    for (channels, sizes, kernel, edge) in cases() {
        let [old, new] = sizes;
        let f: Vec<f64> =
            noise(old[0] * old[1] * channels, 4).iter().map(|v| (127.5 + 127.5 * v.tanh()).round()).collect();
        let (sums, bound) = direct(&f, sizes, channels, &kernel, edge, f64::from(f32::EPSILON));
        let bytes: Vec<u8> = f.iter().map(|v| *v as u8).collect();
        let words: Vec<u16> = bytes.iter().map(|v| u16::from(*v) * 257).collect();
        let got = resized(&plan::<u8>(old, new, &kernel, edge, Arithmetic::Fused), &bytes, channels, 9);
        let got16 = resized(&plan::<u16>(old, new, &kernel, edge, Arithmetic::Fused), &words, channels, 9);
        for ((got, got16), sum) in got.iter().zip(&got16).zip(&sums) {
            let exact = sum.clamp(0.0, 255.0);
            assert!((f64::from(*got) - exact).abs() <= 0.5 + 255.0 * bound, "{old:?} to {new:?}: {got} for {exact}");
            let exact = 257.0 * exact;
            assert!(
                (f64::from(*got16) - exact).abs() <= 0.5 + 65535.0 * bound,
                "{old:?} to {new:?}: {got16} for {exact}"
            );
        }
    }
}

#[test]
fn bytes_of_light_are_averaged_as_light() {
    let light = Light::new(srgb_to_linear).unwrap();
    // a curve with its steps where there is hardly light: many codes in one cell of its table
    let steep = Light::new(|v| v.powi(4)).unwrap();
    assert!((0..=255).all(|code| light.encode(light.decode(code)) == code && steep.encode(steep.decode(code)) == code));
    assert_eq!([f32::NAN, -1.0, 2.0, f32::INFINITY].map(|v| light.encode(v)), [0, 0, 255, 255]);
    for (channels, sizes, kernel, edge) in cases() {
        let [old, new] = sizes;
        let bytes: Vec<u8> =
            noise(old[0] * old[1] * channels, 5).iter().map(|v| (127.5 + 127.5 * v.tanh()) as u8).collect();
        let f: Vec<f64> = bytes.iter().map(|b| srgb_to_linear(f64::from(*b) / 255.0)).collect();
        let (sums, bound) = direct(&f, sizes, channels, &kernel, edge, f64::from(f32::EPSILON));
        let mut out = vec![0; new[0] * new[1] * channels];
        let view = View::new(&bytes, old, channels, old[0] * channels).unwrap();
        let target = ViewMut::new(&mut out, new, channels, new[0] * channels).unwrap();
        plan::<u8>(old, new, &kernel, edge, Arithmetic::Fused).run_in_light(&light, view, target).unwrap();
        for (got, sum) in out.iter().zip(&sums) {
            let exact = sum.clamp(0.0, 1.0);
            let end = |half: f64| srgb_to_linear((f64::from(*got) + half) / 255.0);
            assert!(*got == 0 || end(-0.5) <= exact + bound, "{got} for the light {exact}");
            assert!(*got == 255 || exact - bound <= end(0.5), "{got} for the light {exact}");
        }
    }
}

#[test]
fn images_of_the_face_are_resized_as_the_face_does() {
    for name in ["box", "mitchell", "lanczos-3", "gaussian"] {
        let kernel = catalog::by_name(name).unwrap();
        for (old, new) in SIZES {
            let grid = Grid::cells(-1.0..2.5, old[0], 3.0..4.0, old[1]).unwrap();
            let f: Vec<f64> = noise(old[0] * old[1], 6).iter().map(|v| v.tanh()).collect();
            let image = Image::new(grid, f).unwrap();
            for edge in Edge::ALL {
                let fast = Resizing::new(grid, new, &kernel, edge).unwrap().apply(&image).unwrap();
                let slow = resize(&image, new[0], new[1], &kernel, edge).unwrap();
                let [across, down] = [0, 1].map(|i| Direct::new(old[i], new[i], &kernel));
                // both round, and the face its differences of values up to one, which are up to two
                let steps = 4.0 * (across.most() + down.most() + 4) as f64;
                let bound = steps * f64::EPSILON * across.gain * down.gain;
                assert_eq!(fast.grid(), slow.grid());
                for (fast, slow) in fast.values().iter().zip(slow.values()) {
                    assert!((fast - slow).abs() <= bound, "{old:?} to {new:?}, {name}, {edge:?}: {fast} for {slow}");
                }
            }
        }
    }
}

#[test]
fn a_constant_stays_what_it_is() {
    let kernel = catalog::by_name("lanczos-3").unwrap();
    for (old, new) in SIZES {
        let n = old[0] * old[1];
        let [across, down] = [0, 1].map(|i| Direct::new(old[i], new[i], &kernel));
        let bound = (across.most() + down.most() + 4) as f32 * f32::EPSILON * (across.gain * down.gain) as f32;
        for edge in [Edge::Clamp, Edge::Wrap, Edge::Mirror] {
            let bytes = plan::<u8>(old, new, &kernel, edge, Arithmetic::Fused);
            assert!(
                [0_u8, 1, 77, 254, 255].iter().all(|v| resized(&bytes, &vec![*v; n], 1, 3).iter().all(|got| got == v))
            );
            let got = resized(&plan::<f32>(old, new, &kernel, edge, Arithmetic::Fused), &vec![1.0_f32; n], 1, 3.0);
            assert!(got.iter().all(|v| (v - 1.0).abs() <= bound));
        }
    }
}

#[test]
fn plain_sums_have_the_bits_of_a_loop_and_all_have_the_same_on_any_number_of_threads() {
    let kernel = catalog::by_name("mitchell").unwrap();
    for (old, new) in [([150, 700], [70, 300]), ([70, 100], [150, 700])] {
        let image: Vec<f32> = noise(old[0] * old[1], 8).iter().map(|v| *v as f32).collect();
        let on = |threads, arithmetic| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let plan = plan::<f32>(old, new, &kernel, Edge::Mirror, arithmetic);
            pool.install(|| resized(&plan, &image, 1, 0.0)).into_iter().map(f32::to_bits).collect::<Vec<_>>()
        };
        for arithmetic in [Arithmetic::Plain, Arithmetic::Fused] {
            let one = on(1, arithmetic);
            assert!([2, 3, 7].into_iter().all(|threads| on(threads, arithmetic) == one));
        }
        // down first where it shrinks, across first where it grows: in the order of the old positions
        let [across, down] = [0, 1].map(|i| Direct::new(old[i], new[i], &kernel));
        let sum = |(first, w): &(i64, Vec<f64>), n: usize, f: &dyn Fn(usize) -> f32| -> f32 {
            let mut weights = std::collections::BTreeMap::new();
            for (i, w) in (*first..).zip(w).filter(|(_, w)| **w != 0.0) {
                *weights.entry(Edge::Mirror.index(i, n).unwrap()).or_insert(0.0) += w;
            }
            weights.into_iter().fold(0.0, |sum, (i, w)| w as f32 * f(i) + sum)
        };
        let at = |x: usize, y: usize| image[y * old[0] + x];
        let got = on(1, Arithmetic::Plain);
        for (j, i) in [(0, 0), (13, 5), (new[1] - 1, new[0] - 1), (new[1] / 2, 17)] {
            let (row, column) = (&down.rows[j], &across.rows[i]);
            let exact = if old[0] > new[0] {
                sum(column, old[0], &|x| sum(row, old[1], &|y| at(x, y)))
            } else {
                sum(row, old[1], &|y| sum(column, old[0], &|x| at(x, y)))
            };
            assert_eq!(f32::from_bits(got[j * new[0] + i]), exact);
        }
    }
}

#[test]
fn positions_without_weights_are_zero() {
    let one = [1.0];
    // down first and across first; more of them than a group of rows and a panel of columns have
    for (old, new) in [([300, 200], [128, 64]), ([20, 1], [2048, 128])] {
        let there = |i: usize, j: usize| j >= new[i] / 2;
        let place = |i: usize, j: usize| j * old[i] / new[i];
        let taps = |i: usize| {
            let rows = (0..new[i]).map(|j| (place(i, j) as i64, if there(i, j) { &one[..] } else { &one[..0] }));
            Taps::new(old[i], Edge::Clamp, rows).unwrap()
        };
        let plan = Resizer::<f32>::new(taps(0), taps(1), Arithmetic::Plain);
        let image: Vec<u8> = (0..old[0] * old[1]).map(|i| (1 + i % 255) as u8).collect();
        for (i, got) in resized(&plan, &image, 1, 3).into_iter().enumerate() {
            let (x, y) = (i % new[0], i / new[0]);
            let known = if there(0, x) && there(1, y) { image[place(1, y) * old[0] + place(0, x)] } else { 0 };
            assert_eq!(got, known, "{old:?} to {new:?}, {x}, {y}");
        }
    }
}

#[test]
fn positions_far_beyond_a_border_are_those_that_they_stand_for() {
    let (far, w) = (1 << 29, [0.25, 0.5, 1.0]);
    // more new columns than a piece of work has, all of them beside the image
    for edge in Edge::ALL {
        for first in [-far, far, -3, 7] {
            let axis = |n, at| Taps::new(7, edge, (0..n).map(|j| (at + j, &w[..]))).unwrap();
            let plan = Resizer::<f64>::new(axis(70, first), axis(3, 0), Arithmetic::Plain);
            let image: Vec<f64> = (0..49).map(f64::from).collect();
            for (i, got) in resized(&plan, &image, 1, -1.0).into_iter().enumerate() {
                let (x, y) = (first + i as i64 % 70, i as i64 / 70);
                let pairs = (0..9).map(|k| ((x + k % 3, w[k as usize % 3]), (y + k / 3, w[k as usize / 3])));
                let value = |x, y| edge.index(x, 7).zip(edge.index(y, 7)).map_or(0.0, |(x, y)| image[y * 7 + x]);
                // quarters of whole numbers: nothing is rounded
                assert_eq!(
                    got,
                    pairs.map(|((x, u), (y, v))| u * v * value(x, y)).sum::<f64>(),
                    "{edge:?}, {first}, {i}"
                );
            }
        }
    }
}

#[test]
fn new_positions_may_come_in_any_order() {
    let (old, new) = ([120, 300], [40, 100]);
    let forward = |i: usize| -> Vec<(i64, [f64; 5])> {
        (0..new[i]).map(|j| ((j * old[i] / new[i]) as i64 - 1, [0.125, 0.25, 0.5, 0.0625, 0.0625])).collect()
    };
    // backward, and evens before odds
    let orders: [&dyn Fn(usize, usize) -> usize; 2] = [&|j, n| n - 1 - j, &|j, n| (2 * j) % n + (2 * j) / n];
    let plan = |order: &dyn Fn(usize, usize) -> usize| {
        let taps = |i: usize| {
            let rows = forward(i);
            let rows = (0..new[i]).map(|j| &rows[order(j, new[i])]).map(|(first, w)| (*first, &w[..]));
            Taps::new(old[i], Edge::Wrap, rows).unwrap()
        };
        Resizer::<f32>::new(taps(0), taps(1), Arithmetic::Plain)
    };
    let image: Vec<f32> = noise(old[0] * old[1], 9).iter().map(|v| *v as f32).collect();
    let codes: Vec<u8> = image.iter().map(|v| (127.0 + 50.0 * v) as u8).collect();
    let (sums, bytes) = (resized(&plan(&|j, _| j), &image, 1, 0.0), resized(&plan(&|j, _| j), &codes, 1, 0));
    for order in orders {
        let (got, got_bytes) = (resized(&plan(order), &image, 1, 0.0), resized(&plan(order), &codes, 1, 0));
        for (i, (got, byte)) in got.iter().zip(&got_bytes).enumerate() {
            let from = order(i / new[0], new[1]) * new[0] + order(i % new[0], new[0]);
            assert_eq!((got.to_bits(), byte), (sums[from].to_bits(), &bytes[from]));
        }
    }
}

#[test]
fn what_lies_behind_a_single_row_does_not_matter() {
    let taps = || Taps::new(1, Edge::Clamp, [(0, &[1.0][..])]).unwrap();
    let plan = Resizer::<f32>::new(taps(), taps(), Arithmetic::Plain);
    let (source, mut target) = ([5u8], [0u8]);
    let view = View::new(&source, [1, 1], 1, usize::MAX).unwrap();
    plan.run(view, ViewMut::new(&mut target, [1, 1], 1, usize::MAX).unwrap()).unwrap();
    assert_eq!(target, source);
}

#[test]
fn what_cannot_be_resized_is_refused() {
    let half = [0.5, 0.5];
    let rows = |first: i64| [(first, &half[..])];
    assert!(matches!(Taps::new(0, Edge::Clamp, rows(0)), Err(Error::TooFew { got: 0, .. })));
    assert!(matches!(Taps::new(4, Edge::Clamp, []), Err(Error::TooFew { got: 0, .. })));
    assert!(matches!(Taps::new(4, Edge::Clamp, [(0, &[f64::NAN][..])]), Err(Error::NotFinite { .. })));
    for far in [i64::MAX, i64::MIN, 1 << 40] {
        assert!(matches!(Taps::new(4, Edge::Clamp, rows(far)), Err(Error::Overflow { .. })), "{far}");
    }
    let mut bytes = [0u8; 24];
    assert!(View::new(&bytes, [0, 3], 1, 8).is_err() && View::new(&bytes, [3, 2], 0, 8).is_err());
    assert!(View::new(&bytes, [4, 3], 2, 7).is_err(), "rows of eight are not seven apart");
    assert!(View::new(&bytes, [4, 4], 2, 8).is_err() && View::new(&bytes, [4, 3], 2, 8).is_ok());
    assert!(View::new(&bytes, [usize::MAX, 2], 2, usize::MAX).is_err());
    assert!(ViewMut::new(&mut bytes, [1, usize::MAX], 1, 1 << 60).is_err());
    let taps = || Taps::new(2, Edge::Clamp, rows(0)).unwrap();
    let plan = Resizer::<f32>::new(taps(), taps(), Arithmetic::Plain);
    assert_eq!((plan.old(), plan.new_size()), ([2, 2], [1, 1]));
    let run = |old, new, from, to| {
        let (source, mut target) = ([0u8; 24], [0u8; 24]);
        plan.run(View::new(&source, old, from, 8).unwrap(), ViewMut::new(&mut target, new, to, 8).unwrap())
    };
    assert_eq!(run([2, 2], [1, 1], 3, 3), Ok(()));
    for (old, new, from, to) in [
        ([3, 2], [1, 1], 1, 1),
        ([2, 3], [1, 1], 1, 1),
        ([2, 2], [2, 1], 1, 1),
        ([2, 2], [1, 2], 1, 1),
        ([2, 2], [1, 1], 1, 3),
    ] {
        assert!(matches!(run(old, new, from, to), Err(Error::Length { .. })), "{old:?} {new:?} {from} {to}");
    }
    assert!(
        Light::new(|_| 0.5).is_err() && Light::new(|v| 1.0 - v).is_err() && Light::new(|v| 1.0 / (v - 1.0)).is_err()
    );
    assert!(Light::new(|v| 2.0 * v).is_err() && Light::new(|v| v - 0.5).is_err());
}
