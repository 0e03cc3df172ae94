//! Job d: sound from 44.1 to 48 kHz, whole records, as interleaved frames.
//!
//! The error is the root of the mean square of what is left of a tone when its best fit is taken away: images and rounding.
//! Tones go up to 0.97 of the Nyquist frequency for ours, whose gain must be right there to 0.1 dB, and up to 0.91 (20 kHz)
//! for the others.

use crate::jobs::{Job, noise};
use crate::machine::Machine;
use crate::race::{Contender, Outcome, Race};
use ardftsrc::{InterleavedResampler, PRESET_FAST, PRESET_GOOD};
use audioadapter_buffers::direct::InterleavedSlice;
use nyquist::engine::fft::Butterflies;
use nyquist::engine::real::Real;
use nyquist::rate::{Converter, Quality};
use rubato::{Fft, FixedSync, Resampler};
use std::f64::consts::TAU;

pub const JOB: Job = Job { letter: "d", name: "sound", about: "44.1 to 48 kHz, mono and stereo", run };

const FROM: usize = 44_100;
const TO: usize = 48_000;

/// Frames to frames at the other rate.
type Way<T> = Box<dyn FnMut(&[T], &mut [T]) + Send>;

fn run(machine: &Machine, rounds: usize) -> Vec<Outcome> {
    let mut outcomes = Vec::new();
    for threads in [1, 2] {
        for channels in [1, 2] {
            outcomes.push(sound::<f64>(60, channels, threads, machine, rounds));
            outcomes.push(sound::<f32>(60, channels, threads, machine, rounds));
        }
        // growth
        for seconds in [6, 240] {
            outcomes.push(sound::<f64>(seconds, 2, threads, machine, rounds));
        }
    }
    outcomes
}

fn sound<T: Real + rubato::Sample + ardftsrc::Sample>(
    seconds: usize,
    channels: usize,
    threads: usize,
    machine: &Machine,
    rounds: usize,
) -> Outcome {
    let wide = size_of::<T>() == 8;
    let input: Vec<T> = noise(seconds * FROM * channels).map(|v| T::of(0.5 * v)).collect();
    let mut contenders = vec![
        ours("nyquist best", &input, channels, move || whole(channels, Quality::Best)),
        ours("nyquist best, in blocks of 4096 frames", &input, channels, move || in_blocks(channels, Quality::Best)),
        peer("rubato Fft, 1024", &input, channels, move || by_rubato(channels, 1024)),
        peer("rubato Fft, 4096", &input, channels, move || by_rubato(channels, 4096)),
        peer("ardftsrc good", &input, channels, move || by_ardftsrc(channels, PRESET_GOOD)),
    ];
    if !wide {
        contenders.push(ours("nyquist high (0.96)", &input, channels, move || whole(channels, Quality::High)));
        contenders.push(peer("ardftsrc fast", &input, channels, move || by_ardftsrc(channels, PRESET_FAST)));
    }
    let (width, from, to) =
        (size_of::<T>() as f64, (channels * seconds * FROM) as f64, (channels * seconds * TO) as f64);
    // windows of 2¹⁴ samples, real ones
    let work = 2.5 * 14.0 * (from + to) * width / 8.0;
    let limit = machine.least((from + to) * width, work, threads);
    let counted = "input and output moved once; transforms of 2¹⁴ real samples, forward and back, without overlap";
    let [sort, kind] = [["mono", "stereo"][channels - 1], if wide { "f64" } else { "f32" }];
    let race = Race {
        case: format!("{seconds} s, {sort}, {kind}"),
        threads,
        limit: Some((limit, counted.to_owned())),
        allowed: 10f64.powf(if wide { -180.0 } else { -130.0 } / 20.0),
        contenders,
    };
    race.run(JOB.letter, rounds)
}

fn ours<'a, T: Real>(
    name: &str,
    input: &'a [T],
    channels: usize,
    way: impl FnOnce() -> Way<T> + Send + 'a,
) -> Contender<'a> {
    let made = input.len() / FROM * TO;
    Contender::ours(
        name,
        move || (way(), vec![T::zero(); made]),
        move |(way, out)| way(input, out),
        move |(way, _), ()| worst(&[0.1, 0.5, 0.91, 0.97], channels, way),
    )
}

fn peer<'a, T: Real>(
    name: &str,
    input: &'a [T],
    channels: usize,
    way: impl FnOnce() -> Way<T> + Send + 'a,
) -> Contender<'a> {
    let made = input.len() / FROM * TO;
    Contender::peer(
        name,
        // pages of it that nobody writes are no memory: results of others stay where they make them
        move || (way(), vec![T::zero(); made]),
        move |(way, out)| way(input, out),
        move |(way, _), ()| worst(&[0.1, 0.5, 0.91], channels, way),
    )
}

fn whole<T: Real>(channels: usize, quality: Quality) -> Way<T> {
    let mut converter = converter(channels, quality);
    Box::new(move |input, out| converter.whole(input, out).expect("the lengths agree"))
}

/// As a stream: every block's frames to the place that is next.
fn in_blocks<T: Real>(channels: usize, quality: Quality) -> Way<T> {
    let mut block_out = Vec::new();
    Box::new(move |input, mut out| {
        let mut converter = converter(channels, quality);
        let mut give = |block: &mut Vec<T>| {
            let (now, later) = std::mem::take(&mut out).split_at_mut(block.len());
            now.copy_from_slice(block);
            block.clear();
            out = later;
        };
        for block in input.chunks(4096 * channels) {
            converter.push(block, &mut block_out).expect("blocks are whole frames");
            give(&mut block_out);
        }
        converter.finish(&mut block_out).expect("samples are at most one");
        give(&mut block_out);
    })
}

fn converter<T: Real>(channels: usize, quality: Quality) -> Converter<T> {
    let (from, to) = (FROM as f64, TO as f64);
    Converter::with(from, to, channels, quality, Butterflies::Fastest).expect("the rates are possible")
}

fn by_rubato<T: Real + rubato::Sample>(channels: usize, chunk: usize) -> Way<T> {
    let mut fft = Fft::<T>::new(FROM, TO, chunk, channels, FixedSync::Both).expect("the rates are possible");
    let mut room = Vec::new();
    Box::new(move |input, out| {
        fft.reset();
        let frames = input.len() / channels;
        // it wants more room than it fills, and leaves its result there: what is timed is without a copy
        let needed = fft.process_all_needed_output_len(frames);
        room.resize(needed * channels, T::zero());
        let source = InterleavedSlice::new(input, channels, frames).expect("frames are whole");
        let mut sink = InterleavedSlice::new_mut(&mut room, channels, needed).expect("frames are whole");
        fft.process_all_into_buffer(&source, &mut sink, frames, None).expect("there is room");
        keep(&room, out);
    })
}

fn by_ardftsrc<T: Real + ardftsrc::Sample>(channels: usize, preset: ardftsrc::Config) -> Way<T> {
    let config = preset.with_input_rate(FROM).with_output_rate(TO).with_channels(channels);
    let mut resampler = InterleavedResampler::<T>::new(config).expect("the rates are possible");
    Box::new(move |input, out| {
        resampler.reset();
        let planes = resampler.process_all(input).expect("frames are whole");
        // one plane a channel: what is timed is without weaving them
        if out.len() <= PROBE * TO * channels {
            let planes = planes.as_slice();
            out.iter_mut().enumerate().for_each(|(i, v)| *v = planes[i % channels][i / channels]);
        }
    })
}

/// Seconds of the records by which errors are measured.
const PROBE: usize = 2;

/// The result of a short record, which is looked at.
fn keep<T: Copy>(from: &[T], out: &mut [T]) {
    if out.len() <= 2 * PROBE * TO {
        out.copy_from_slice(&from[..out.len()]);
    }
}

/// The largest error of tones at these fractions of the Nyquist frequency; one where the last is weaker by 0.1 dB.
fn worst<T: Real>(parts: &[f64], channels: usize, way: &mut Way<T>) -> f64 {
    let tone = |part: f64, rate: usize, i: usize, phase: f64| {
        let cycles = 0.5 * part * FROM as f64 / rate as f64 * i as f64;
        (TAU * (cycles.fract() + phase)).cos()
    };
    let mut worst = 0.0f64;
    for &part in parts {
        let frames = (0..PROBE * FROM).map(|i| T::of(0.9 * tone(part, FROM, i, 0.1)));
        let input: Vec<T> = frames.flat_map(|v| std::iter::repeat_n(v, channels)).collect();
        let mut out = vec![T::zero(); PROBE * TO * channels];
        way(&input, &mut out);
        for channel in 0..channels {
            let middle = (TO / 2..PROBE * TO - TO / 2).map(|i| {
                let value = out[i * channels + channel].to_f64().expect("every number is one of 64 bits");
                (value, tone(part, TO, i, 0.0), tone(part, TO, i, 0.25))
            });
            let middle: Vec<_> = middle.collect();
            let (fit, left) = fitted(&middle);
            let gain =
                if part == parts[parts.len() - 1] && (20.0 * (fit / 0.9).log10()).abs() > 0.1 { 1.0 } else { 0.0 };
            worst = worst.max(left / fit).max(gain);
        }
    }
    worst
}

/// The amplitude of the tone `a·c + b·s` nearest to the values `(v, c, s)`, and the root of the mean square of the rest,
/// times √2.
fn fitted(values: &[(f64, f64, f64)]) -> (f64, f64) {
    let sum = |f: &dyn Fn(&(f64, f64, f64)) -> f64| values.iter().map(f).sum::<f64>();
    let (cc, ss, cs) = (sum(&|v| v.1 * v.1), sum(&|v| v.2 * v.2), sum(&|v| v.1 * v.2));
    // twice: what the first fit leaves of the tone, by rounding, is taken by the second
    let (mut a, mut b) = (0.0, 0.0);
    for _ in 0..2 {
        let vc = sum(&|v| (v.0 - a * v.1 - b * v.2) * v.1);
        let vs = sum(&|v| (v.0 - a * v.1 - b * v.2) * v.2);
        let det = cc * ss - cs * cs;
        (a, b) = (a + (vc * ss - vs * cs) / det, b + (vs * cc - vc * cs) / det);
    }
    let rest = sum(&|v| (v.0 - a * v.1 - b * v.2).powi(2));
    (a.hypot(b), (2.0 * rest / values.len() as f64).sqrt())
}
