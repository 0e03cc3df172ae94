//! Job e: images at another size, by kernels that widen when shrinking. The sums in 64 bits are the reference.

use crate::jobs::{Job, noise, resize_peers};
use crate::machine::Machine;
use crate::race::{Contender, Outcome, Race};
use nyquist::axis::{Axis, Edge};
use nyquist::door::srgb::{linear_to_srgb, srgb_to_linear};
use nyquist::engine::Arithmetic;
use nyquist::engine::resize::{Code, Light, Resizer, View, ViewMut};
use nyquist::image::weights::Weights;
use nyquist::kernel::catalog;
use rayon::prelude::*;

pub const JOB: Job =
    Job { letter: "e", name: "resize", about: "images of 4096² to 1024² and back, Lanczos-3 and cubics", run };

/// What is done.
#[derive(Debug, Clone, Copy)]
pub struct Case {
    /// The library's name of the kernel.
    pub kernel: &'static str,
    /// Interleaved channels.
    pub channels: usize,
    /// Old width and height.
    pub from: usize,
    /// New width and height.
    pub to: usize,
    /// Whether bytes are averaged as the light that they stand for.
    pub light: bool,
}

/// What writes a resized image.
pub type Run<'a, C> = Box<dyn FnMut(&mut [C]) + Send + 'a>;

/// What plans it.
pub type Make<'a, C> = Box<dyn FnOnce() -> Run<'a, C> + Send + 'a>;

/// A way to do it.
pub struct Way<'a, C> {
    pub name: &'static str,
    pub make: Make<'a, C>,
}

/// `f32` or bytes.
pub trait Number: Code<Sum = f32> + Default + resize_peers::Known {
    const NAME: &'static str;
    /// The number for white.
    const WHITE: f64;
    fn of(value: f64) -> Self;
    fn value(self) -> f64;
    /// Ours, by light where that is asked for and there is such a thing.
    fn ours(plan: &Resizer<f32>, light: Option<&Light>, source: View<'_, Self>, target: ViewMut<'_, Self>);
}

impl Number for f32 {
    const NAME: &'static str = "f32";
    const WHITE: f64 = 1.0;
    fn of(value: f64) -> Self {
        value as Self
    }
    fn value(self) -> f64 {
        f64::from(self)
    }
    fn ours(plan: &Resizer<f32>, _: Option<&Light>, source: View<'_, Self>, target: ViewMut<'_, Self>) {
        plan.run(source, target).expect("the sizes agree");
    }
}

impl Number for u8 {
    const NAME: &'static str = "u8";
    const WHITE: f64 = 255.0;
    fn of(value: f64) -> Self {
        (255.0 * value).round() as Self
    }
    fn value(self) -> f64 {
        f64::from(self)
    }
    fn ours(plan: &Resizer<f32>, light: Option<&Light>, source: View<'_, Self>, target: ViewMut<'_, Self>) {
        match light {
            Some(light) => plan.run_in_light(light, source, target),
            None => plan.run(source, target),
        }
        .expect("the sizes agree");
    }
}

fn run(machine: &Machine, rounds: usize) -> Vec<Outcome> {
    let mut outcomes = Vec::new();
    // three sizes with one kernel, all kernels at the largest
    let sizes = [(1024, 256), (2048, 512), (4096, 1024), (1024, 4096)];
    for (from, to) in sizes {
        for kernel in ["lanczos-3", "mitchell", "catmull-rom"] {
            if kernel != "lanczos-3" && from.max(to) < 4096 {
                continue;
            }
            for channels in [1, 3] {
                let case = Case { kernel, channels, from, to, light: false };
                outcomes.extend(of::<f32>(case, machine, rounds));
                outcomes.extend(of::<u8>(case, machine, rounds));
                outcomes.extend(of::<u8>(Case { light: true, ..case }, machine, rounds));
            }
        }
    }
    outcomes
}

fn of<C: Number>(case: Case, machine: &Machine, rounds: usize) -> [Outcome; 2] {
    let Case { kernel, channels, from, to, light } = case;
    // waves under noise: what is exact for one alone would flatter
    let pixel = |(i, noise): (usize, f64)| {
        let (x, y) = ((i / channels % from) as f64, (i / channels / from) as f64);
        C::of(0.3 * (2.0 + (0.021 * x).sin() + (0.017 * y).cos()) * 0.75 + 0.05 * (1.0 + noise))
    };
    let source: Vec<C> = noise(from * from * channels).enumerate().map(pixel).collect();
    let exact = exact(case, &source);
    [1, 2].map(|threads| {
        let (source, exact) = (&source, &exact);
        let result = move || vec![C::default(); to * to * channels];
        let error = move |out: &[C]| error(case, out, exact);
        let mut contenders = vec![Contender::ours(
            "nyquist",
            move || (ours(case, source), result()),
            |(run, out)| run(out),
            move |(_, out), ()| error(out),
        )];
        contenders.extend(C::peers(case, source, threads).into_iter().map(|Way { name, make }| {
            Contender::peer(name, move || (make(), result()), |(run, out)| run(out), move |(_, out), ()| error(out))
        }));
        let bytes = (size_of::<C>() * channels * (from * from + to * to)) as f64;
        // the way that needs fewer products: down before across when shrinking
        let taps = |n: f64| 2.0 * catalog::by_name(kernel).expect("a known kernel").radius() * n;
        let (f, t) = (from as f64, to as f64);
        let products = channels as f64 * taps((f / t).max(1.0)) * (t * t + f * t);
        let counted = "the image read and the result written once; products and sums in 32 bits of both passes";
        let race = Race {
            case: format!(
                "{from}² → {to}², {kernel}, {} × {channels}{}",
                C::NAME,
                if light { " by light" } else { "" }
            ),
            threads,
            // 64 bits are what is measured: twice as many of 32 at a time
            limit: Some((machine.least(bytes, 2.0 * products / 2.0, threads), counted.into())),
            // of f32 the bound of the engine, (n + m + 4)·ε·A² with A ≤ 1.5; of bytes a rounding of the result, and one of rows
            allowed: if C::WHITE == 1.0 {
                (2.0 * taps((f / t).max(1.0)) + 4.0) * f64::from(f32::EPSILON) * 2.25
            } else {
                1.25
            },
            contenders,
        };
        race.run(JOB.letter, rounds)
    })
}

fn ours<C: Number>(case: Case, source: &[C]) -> Run<'_, C> {
    let Case { kernel, channels, from, to, light } = case;
    let kernel = catalog::by_name(kernel).expect("a known kernel");
    let axis = |n| Axis::cells(0.0..from as f64, n).expect("sizes are positive");
    let taps =
        || Weights::of(axis(from), axis(to), &kernel).and_then(|w| w.taps(Edge::Clamp)).expect("a finite kernel");
    let plan = Resizer::new(taps(), taps(), Arithmetic::Fused);
    let light = light.then(|| Light::new(srgb_to_linear).expect("a rising curve"));
    Box::new(move |out| {
        let source = View::new(source, [from; 2], channels, from * channels).expect("the sizes agree");
        let target = ViewMut::new(out, [to; 2], channels, to * channels).expect("the sizes agree");
        C::ours(&plan, light.as_ref(), source, target);
    })
}

/// The largest error of pixels that see nothing beyond the border: every library says otherwise what is there.
fn error<C: Number>(case: Case, found: &[C], exact: &[f64]) -> f64 {
    let Case { kernel, channels, from, to, .. } = case;
    let radius = catalog::by_name(kernel).expect("a known kernel").radius();
    let border = (radius * (to as f64 / from as f64).max(1.0)).ceil() as usize + 1;
    let inside = border..to - border;
    let differences = found.iter().zip(exact).enumerate().filter_map(|(i, (found, exact))| {
        let pixel = i / channels;
        let within = inside.contains(&(pixel % to)) && inside.contains(&(pixel / to));
        within.then(|| (found.value() - exact).abs())
    });
    differences.fold(0.0, f64::max)
}

/// `Σ_y w_y Σ_x w_x f` in 64 bits, the border pixels repeated; bytes not rounded.
fn exact<C: Number>(case: Case, source: &[C]) -> Vec<f64> {
    let Case { kernel, channels, from, to, light } = case;
    let kernel = catalog::by_name(kernel).expect("a known kernel");
    let (ratio, stretch) = (from as f64 / to as f64, (from as f64 / to as f64).max(1.0));
    let reach = kernel.radius() * stretch;
    let taps = |j: usize| {
        let at = (j as f64 + 0.5) * ratio - 0.5;
        let read = (at - reach).ceil() as i64..=(at + reach).floor() as i64;
        let weights: Vec<(i64, f64)> = read.map(|i| (i, kernel.at((at - i as f64) / stretch))).collect();
        let sum: f64 = weights.iter().map(|(_, w)| w).sum();
        weights.into_iter().map(|(i, w)| (i.clamp(0, from as i64 - 1) as usize, w / sum)).collect::<Vec<_>>()
    };
    let taps: Vec<_> = (0..to).map(taps).collect();
    let decoded: Vec<f64> =
        source.par_iter().map(|v| if light { srgb_to_linear(v.value() / C::WHITE) } else { v.value() }).collect();
    let (old, new) = (from * channels, to * channels);
    let mut out = vec![0.0; to * new];
    out.par_chunks_mut(new).zip(&taps).for_each(|(out, rows)| {
        let mut row = vec![0.0; old];
        for &(y, w) in rows {
            row.iter_mut().zip(&decoded[y * old..]).for_each(|(sum, v)| *sum += w * v);
        }
        for (i, out) in out.iter_mut().enumerate() {
            let sum: f64 = taps[i / channels].iter().map(|&(x, w)| w * row[x * channels + i % channels]).sum();
            *out = match (light, C::WHITE == 1.0) {
                (true, _) => C::WHITE * linear_to_srgb(sum.clamp(0.0, 1.0)),
                (false, true) => sum,
                (false, false) => sum.clamp(0.0, C::WHITE),
            };
        }
    });
    out
}
