//! What is found depends on the frames and not on how they came, nor on the number of threads.

use crate::material::noise;
use nyquist::inspect::sound::{Meter, Sound};
use nyquist::sampled::segments::Segments;
use nyquist::sampled::spectrogram::SpectrogramWriter;
use nyquist::sampled::window::Window;

/// All numbers of a sound, as bits.
fn bits(sound: &Sound) -> Vec<u64> {
    let channel = |c: &nyquist::inspect::sound::Channel| {
        let levels = c.levels();
        let mut numbers = c.spectrum().density().to_vec();
        numbers.extend([levels.mean, levels.power, levels.range[0], levels.range[1], c.edge_power()]);
        numbers.extend(c.whole().density());
        for k in 0..20 {
            numbers.extend(
                c.loudest_beyond(f64::from(k) * 100.0).map(|m| [m.time, m.beyond, m.total]).into_iter().flatten(),
            );
        }
        numbers.into_iter().map(f64::to_bits).collect::<Vec<_>>()
    };
    sound.channels().iter().flat_map(channel).collect()
}

fn heard(frames: &[f64], channels: usize, block: usize) -> Sound {
    let mut meter = Meter::new(8_000.0, channels).expect("whole frames of finite values");
    frames.chunks(block * channels).for_each(|frames| meter.push(frames).expect("whole frames of finite values"));
    meter.finish().expect("whole frames of finite values")
}

#[test]
fn meters_do_not_see_blocks() {
    // shorter and longer than what is kept until segments are chosen
    for (frames, channels) in [(64, 1), (1_000, 3), (40_000, 2), (160_000, 1)] {
        let values = noise(11, frames * channels);
        let whole = bits(&heard(&values, channels, frames));
        for block in [1_000, 4_096, 65_536] {
            assert_eq!(bits(&heard(&values, channels, block)), whole, "{frames} frames in blocks of {block}");
        }
        // the channels are those that stand alone
        let alone: Vec<f64> = values.iter().skip(channels - 1).step_by(channels).copied().collect();
        let last = heard(&values, channels, frames).channels()[channels - 1].spectrum().density().to_vec();
        assert_eq!(heard(&alone, 1, frames).channels()[0].spectrum().density(), last);
    }
}

#[test]
fn spectrograms_do_not_see_blocks() {
    let values = noise(12, 100_000);
    let written = |block: usize| {
        let segments = Segments::new(256, 64, Window::Hann).unwrap();
        let mut writer = SpectrogramWriter::new(8_000.0, 1, segments, 100, 40).unwrap();
        values.chunks(block).for_each(|block| writer.push(block).unwrap());
        writer.finish().unwrap()
    };
    assert_eq!(written(100_000), written(777));
}

#[test]
fn one_thread_gives_the_same_bits_as_several() {
    let values = noise(13, 150_000);
    let pool = |threads: usize| rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    let one = pool(1).install(|| bits(&heard(&values, 1, 50_000)));
    assert_eq!(one, pool(3).install(|| bits(&heard(&values, 1, 50_000))));
}
