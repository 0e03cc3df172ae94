//! Cells of a spectrogram are means, so that no power is lost however few there are.

use crate::material::{mean_square, noise, tone};
use nyquist::sampled::segments::Segments;
use nyquist::sampled::spectrogram::{Spectrogram, SpectrogramWriter};
use nyquist::sampled::window::Window;

fn of(values: &[f64], columns: usize, rows: usize) -> Spectrogram {
    let segments = Segments::new(256, 64, Window::Hann).expect("finite values and valid segments");
    let mut writer =
        SpectrogramWriter::new(8_000.0, 1, segments, columns, rows).expect("finite values and valid segments");
    writer.push(values).expect("finite values and valid segments");
    writer.finish().expect("finite values and valid segments").remove(0)
}

#[test]
fn memory_does_not_grow_and_times_stay_right() {
    for seconds in [1, 2, 5, 13, 40] {
        // half noise, half silence
        let frames = 8_000 * seconds;
        let mut values = noise(1, frames);
        values[frames / 2..].fill(0.0);
        let spectrogram = of(&values, 32, 64);
        let (rows, columns) = spectrogram.density().dim();
        assert!(rows <= 64 && (16..=32).contains(&columns), "{seconds} s: {columns} columns");
        let [start, end] = [spectrogram.time(0)[0], spectrogram.time(columns - 1)[1]];
        let column = spectrogram.time(0)[1] - spectrogram.time(0)[0];
        assert!(start >= 0.0 && end <= seconds as f64 && end + column + 0.04 > seconds as f64, "{start} to {end}");
        // mean square of a column, rows as wide as they are
        let power = |column: usize| -> f64 {
            let row = |i: usize| {
                let [from, to] = spectrogram.frequencies(i);
                spectrogram.density()[[i, column]] * (to - from)
            };
            (0..rows).map(row).sum()
        };
        for i in 0..columns {
            let [from, to] = spectrogram.time(i);
            let middle = 0.5 * seconds as f64;
            if to < middle - 0.04 {
                // a mean over so many values, of 1/12: the mean square of noise is known to 0.9/√n
                let most = 5.0 * 0.9 / ((to - from) * 8_000.0).sqrt();
                assert!((power(i) * 12.0 - 1.0).abs() < most, "{seconds} s, column {i}: {}", power(i) * 12.0);
            } else if from > middle + 0.04 {
                assert_eq!(power(i), 0.0);
            }
        }
    }
}

#[test]
fn a_tone_stands_in_its_row() {
    let values: Vec<f64> = (0..16_000).map(|i| tone(0.5, 1_000.0, 0.2, 8_000.0, i)).collect();
    for rows in [129, 65, 20] {
        let spectrogram = of(&values, 50, rows);
        let column: Vec<f64> = spectrogram.density().column(10).to_vec();
        let loudest = (0..column.len()).max_by(|a, b| column[*a].total_cmp(&column[*b])).unwrap();
        let [from, to] = spectrogram.frequencies(loudest);
        assert!((from..=to).contains(&1_000.0), "{rows}: {from}–{to} Hz");
    }
    assert!((mean_square(&values) - 0.125).abs() < 1e-12);
}

#[test]
fn nonsense_is_refused() {
    let segments = Segments::new(256, 64, Window::Hann).unwrap();
    assert!(SpectrogramWriter::new(8_000.0, 1, segments, 1, 40).is_err());
    assert!(SpectrogramWriter::new(8_000.0, 1, segments, 10, 0).is_err());
    assert!(SpectrogramWriter::new(-1.0, 1, segments, 10, 40).is_err());
    let mut short = SpectrogramWriter::new(8_000.0, 1, segments, 10, 40).unwrap();
    short.push(&[0.0; 255]).unwrap();
    assert!(short.finish().is_err());
}
