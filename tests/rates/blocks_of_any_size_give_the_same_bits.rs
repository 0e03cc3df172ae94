//! How a stream is cut, how many channels run beside and how many threads there are: the bits do not know.

use nyquist::engine::fft::Butterflies;
use nyquist::num::random::uniform;
use nyquist::rate::{Converter, Quality, convert};

#[test]
fn cuts_and_neighbours_do_not_matter() {
    for (from, to) in
        [(44_100.0, 48_000.0), (48_000.0, 44_100.0), (44_100.0, 50_000.123), (8_000.0, 8_000.0), (5.0, 1.0)]
    {
        let frames = 20_000u64;
        let channel = |c: u32| -> Vec<f64> { (0..frames).map(|i| uniform(5, i, c) - 0.5).collect() };
        let alone: Vec<Vec<f64>> = (0..3).map(|c| convert(&channel(c), from, to, Quality::High).unwrap()).collect();
        let interleaved: Vec<f64> = (0..frames).flat_map(|i| (0..3).map(move |c| uniform(5, i, c) - 0.5)).collect();
        for size in [1, 7, 1024, 9_999, 20_000] {
            let mut converter = Converter::new(from, to, 3, Quality::High).unwrap();
            let mut out = Vec::new();
            for block in interleaved.chunks(3 * size) {
                converter.push(block, &mut out).unwrap();
            }
            converter.finish(&mut out).unwrap();
            assert_eq!(out.len(), 3 * alone[0].len());
            let same = out.iter().enumerate().all(|(i, v)| v.to_bits() == alone[i % 3][i / 3].to_bits());
            assert!(same, "{from} → {to}, blocks of {size}");
        }
    }
}

#[test]
fn threads_do_not_matter_nor_whether_a_record_comes_at_once() {
    let stereo: Vec<f32> = (0..150_000).map(|i| uniform(6, i, 0) as f32 - 0.5).collect();
    for (from, to) in [(44_100.0, 48_000.0), (44_100.0, 50_000.123), (48_000.0, 48_000.0)] {
        let converter = || Converter::with(from, to, 2, Quality::Best, Butterflies::Fastest).unwrap();
        let mut blocks = converter();
        let mut expected = Vec::new();
        stereo.chunks(20_000).for_each(|block| blocks.push(block, &mut expected).unwrap());
        blocks.finish(&mut expected).unwrap();
        for threads in [1, 2, 3] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let mut out = vec![0.0; expected.len()];
            let mut whole = converter();
            whole.push(&stereo[..2_000], &mut Vec::new()).unwrap(); // forgotten
            pool.install(|| whole.whole(&stereo, &mut out)).unwrap();
            let same = out.iter().zip(&expected).all(|(a, b)| a.to_bits() == b.to_bits());
            assert!(same, "{from} → {to}, {threads} threads");
        }
    }
}
