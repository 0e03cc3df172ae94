//! `nyquist spectrum` of sounds as a user meets it.

use crate::running::{code, run, stderr, text};
use nyquist::door::wav::{Dither, Encoding, WavFormat, WavWriter};
use nyquist::num::{random, sin_pi};
use nyquist::sampled::segments::Segments;
use nyquist::sampled::welch::welch;
use nyquist::sampled::window::Window;
use serde_json::Value;
use std::fs;
use std::path::PathBuf;
use std::process::Output;
use tempfile::TempDir;

fn spectrum(args: &[&str]) -> Output {
    run("spectrum", args)
}

/// A folder with a file of these frames, and its name.
fn file(rate: u32, channels: u16, encoding: Encoding, values: &[f64]) -> (TempDir, PathBuf) {
    let format = WavFormat::new(rate, channels, encoding).expect("the fixture is sound");
    let frames = (values.len() / format.channels()) as u64;
    let mut writer =
        WavWriter::new("memory", Vec::new(), format, Some(frames), Dither::None).expect("the fixture is sound");
    writer.write(values).expect("the fixture is sound");
    let folder = TempDir::new().expect("the fixture is sound");
    let path = folder.path().join("in.wav");
    fs::write(&path, writer.finish().expect("the fixture is sound").0).expect("the fixture is sound");
    (folder, path)
}

/// A sine of full scale at 1000 Hz beside hiss.
fn two_channels(frames: usize) -> Vec<f64> {
    let sine = |i: usize| sin_pi(2.0 * (i % 48) as f64 / 48.0);
    (0..frames).flat_map(|i| [sine(i), random::uniform(1, i as u64, 0) - 0.5]).collect()
}

/// The names of the columns and the numbers.
fn table(csv: &[u8]) -> (Vec<String>, Vec<Vec<f64>>) {
    let csv = String::from_utf8(csv.to_vec()).expect("CSV is text");
    let mut lines = csv.lines();
    let names = lines.next().expect("there is a head").split(',').map(str::to_owned).collect();
    let row = |line: &str| line.split(',').map(|cell| cell.parse().expect("a number")).collect();
    (names, lines.map(row).collect())
}

#[test]
fn numbers_are_those_of_the_library_to_the_last_bit() {
    let values = two_channels(30_000);
    let (_folder, input) = file(48_000, 2, Encoding::Float64, &values);
    let hiss: Vec<f64> = values.iter().skip(1).step_by(2).copied().collect();
    let done = spectrum(&[
        text(&input),
        "-o",
        "-",
        "--quantity",
        "density",
        "--window",
        "kaiser:14",
        "--segment",
        "1000",
        "--overlap",
        "0.75",
    ]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    let (names, rows) = table(&done.stdout);
    assert_eq!(names[..3], ["frequency [Hz]", "channel 1 [FS^2/Hz]", "channel 1 [dBFS/Hz]"]);
    let truth = welch(&hiss, 48_000.0, Segments::new(1000, 250, Window::Kaiser(14.0)).unwrap()).unwrap();
    assert_eq!(rows.len(), 501);
    for (k, row) in rows.iter().enumerate() {
        assert_eq!((row[0], row[3]), (48.0 * k as f64, truth.density()[k]));
        assert_eq!(row[4], 10.0 * (2.0 * truth.density()[k]).log10());
    }
}

#[test]
fn a_sine_of_full_scale_reads_zero_and_its_density_holds_a_half() {
    let (_folder, input) = file(48_000, 2, Encoding::Float64, &two_channels(96_000));
    let (_, rows) = table(&spectrum(&[text(&input), "-o", "-", "--resolution", "10"]).stdout);
    // bin 100: amplitude 1 and 0 dBFS, to the rounding of a transform
    assert_eq!(rows[100][0], 1000.0);
    assert!((rows[100][1] - 1.0).abs() < 1e-13 && rows[100][2].abs() < 1e-12);
    let (_, rows) = table(&spectrum(&[text(&input), "-o", "-", "--resolution", "10", "--quantity", "density"]).stdout);
    let power: f64 = rows.iter().map(|row| row[1] * 10.0).sum();
    assert!((power - 0.5).abs() < 1e-12, "{power}");
    // between two bins the flat top still reads it, within 0.01 dB
    let (_, rows) = table(&spectrum(&[text(&input), "-o", "-", "--segment", "4992", "--window", "flat-top"]).stdout);
    let top = rows.iter().map(|row| row[2]).fold(f64::NEG_INFINITY, f64::max);
    assert!(top.abs() < 0.01, "{top}");
}

#[test]
fn json_says_how_it_was_made() {
    let (folder, input) = file(48_000, 2, Encoding::Int16, &two_channels(20_000));
    let out = folder.path().join("out.json");
    assert_eq!(code(&spectrum(&[text(&input), "-o", text(&out)])), 0);
    let found: Value = serde_json::from_slice(&fs::read(&out).unwrap()).unwrap();
    assert_eq!((&found["segment"], &found["hop"], &found["segments"]), (&8192.into(), &4096.into(), &3.into()));
    assert_eq!((&found["window"], &found["units"]["levels"]), (&"hann".into(), &"dBFS".into()));
    assert_eq!(found["noise_bandwidth"].as_f64().map(|hz| (hz / (1.5 * 48_000.0 / 8192.0) * 1e9).round()), Some(1e9));
    let channels = found["channels"].as_array().unwrap();
    assert_eq!((channels.len(), channels[0]["levels"].as_array().map(Vec::len)), (2, Some(4097)));
}

#[test]
fn pictures_are_drawn_of_everything() {
    let silence = vec![0.0; 5_000];
    for (channels, values) in [(1, silence), (2, two_channels(30_000)), (10, two_channels(50_000))] {
        let (folder, input) = file(48_000, channels, Encoding::Int24, &values);
        for extra in [&[][..], &["--log"], &["--quantity", "density"], &["--spectrogram"]] {
            for (name, start) in [("s.svg", &b"<svg"[..]), ("s.png", b"\x89PNG"), ("s.pdf", b"%PDF")] {
                let out = folder.path().join(name);
                let done = spectrum(&[&[text(&input), "-o", text(&out), "--force", "--lang", "ru"], extra].concat());
                assert_eq!(code(&done), 0, "{channels}, {extra:?}: {}", stderr(&done));
                assert!(fs::read(&out).unwrap().starts_with(start));
            }
        }
    }
}

#[test]
fn spectrograms_are_tables_of_times_and_frequencies() {
    let (_folder, input) = file(48_000, 2, Encoding::Float64, &two_channels(48_000));
    let done = spectrum(&[text(&input), "-o", "-", "--spectrogram"]);
    let (names, rows) = table(&done.stdout);
    assert_eq!(names[..2], ["time [s]", "channel"]);
    // the sine stands in the column that has 1000 Hz in it, at all times
    let middle = |name: &String| name.trim_end_matches(" Hz [dBFS/Hz]").parse::<f64>().expect("a frequency");
    let nearest = (2..names.len())
        .min_by(|a, b| (middle(&names[*a]) - 1000.0).abs().total_cmp(&(middle(&names[*b]) - 1000.0).abs()))
        .unwrap();
    for row in rows.iter().filter(|row| row[1] == 1.0) {
        let loudest = (2..row.len()).max_by(|a, b| row[*a].total_cmp(&row[*b])).unwrap();
        assert!(loudest.abs_diff(nearest) <= 1, "{}: {}", row[0], names[loudest]);
    }
    assert!(rows.windows(3).all(|w| w[2][0] > w[0][0]) && rows.last().unwrap()[0] < 1.0);
}

#[test]
fn a_record_shorter_than_a_segment_is_one_and_said_to_be() {
    let (_folder, input) = file(48_000, 1, Encoding::Int16, &two_channels(50));
    let done = spectrum(&[text(&input), "-o", "-"]);
    assert_eq!(code(&done), 0);
    assert_eq!(stderr(&done), "note: 100 frames are less than a segment of 8192: one segment of all\n");
    assert_eq!(table(&done.stdout).1.len(), 51);
    let (_folder, one) = file(48_000, 1, Encoding::Int16, &[0.5]);
    let (_, rows) = table(&spectrum(&[text(&one), "-o", "-", "--keep-mean"]).stdout);
    assert_eq!(rows, [[0.0, 0.5, 20.0 * 0.5f64.log10()]]);
}

#[test]
fn nonsense_is_one_sentence_and_nothing_is_written() {
    let (folder, input) = file(48_000, 1, Encoding::Int16, &two_channels(500));
    let out = folder.path().join("s.csv");
    for (args, words) in [
        (&["--window", "han"][..], "no window is called \"han\"; known: hann"),
        (&["--window", "kaiser:-1"], "β of Kaiser's window must lie between 0 and 500"),
        (&["--window", "kaiser:x"], "cannot read \"x\" as a number"),
        (&["--window", "gaussian:0"], "σ of a Gaussian window must be greater than zero"),
        (&["--segment", "0"], "samples in a segment: at least 2 needed"),
        (&["--segment", "99999999999"], "the length of a segment overflows"),
        (&["--resolution", "0"], "--resolution must lie between 0 and the rate"),
        (&["--resolution", "nan"], "--resolution must lie between 0 and the rate"),
        (&["--resolution", "1e-300"], "the length of a segment overflows"),
        (&["--overlap", "1"], "--overlap must be at least 0 and less than 1"),
        (&["--overlap", "nan"], "--overlap must be at least 0 and less than 1"),
        (&["--quantity", "loudness"], "no quantity is called \"loudness\"; known: "),
        (&["--segment", "100", "--resolution", "5"], "cannot be used with"),
        (&["--spectrogram", "--segment", "2000"], "samples of a spectrogram"),
    ] {
        let done = spectrum(&[&[text(&input), "-o", text(&out)], args].concat());
        assert_eq!(code(&done), 2, "{args:?}");
        assert!(stderr(&done).contains(words), "{args:?}: {}", stderr(&done));
        assert!(!out.exists());
    }
    let (_folder, one) = file(48_000, 1, Encoding::Int16, &[0.5]);
    let done = spectrum(&[text(&one), "-o", text(&out), "--spectrogram"]);
    assert!(stderr(&done).contains("at least 2048 needed, got 1\n"), "{}", stderr(&done));
    let (_folder, empty) = file(48_000, 1, Encoding::Int16, &[]);
    let done = spectrum(&[text(&empty), "-o", text(&out)]);
    assert_eq!(code(&done), 2);
    assert!(stderr(&done).contains("at least 1 needed, got 0"), "{}", stderr(&done));
}
