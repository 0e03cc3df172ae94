//! `nyquist resample` as a user meets it.

use crate::running::{code, piped, run, stderr, text};
use nyquist::door::wav::{Dither, Encoding, WavFormat, WavReader, WavWriter};
use nyquist::num::sin_pi;
use nyquist::rate::{Quality, convert};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;
use tempfile::TempDir;

fn resample(args: &[&str]) -> Output {
    run("resample", args)
}

fn wav(format: WavFormat, values: &[f64]) -> Vec<u8> {
    let frames = (values.len() / format.channels()) as u64;
    let mut writer =
        WavWriter::new("memory", Vec::new(), format, Some(frames), Dither::None).expect("the fixture is sound");
    writer.write(values).expect("the fixture is sound");
    writer.finish().expect("the fixture is sound").0
}

fn read(bytes: &[u8]) -> (WavFormat, Vec<f64>) {
    let mut reader = WavReader::new("memory", bytes).expect("the fixture is sound");
    let mut values = Vec::new();
    while reader.read(reader.block(), &mut values).expect("the fixture is sound") > 0 {}
    (reader.format(), values)
}

/// A folder with a file of these values, and the names of input and output.
fn folder(rate: u32, channels: u16, encoding: Encoding, values: &[f64]) -> (TempDir, PathBuf, PathBuf) {
    let folder = TempDir::new().expect("the fixture is sound");
    let (input, output) = (folder.path().join("in.wav"), folder.path().join("out.wav"));
    fs::write(&input, wav(WavFormat::new(rate, channels, encoding).expect("the fixture is sound"), values))
        .expect("the fixture is sound");
    (folder, input, output)
}

fn tone(rate: f64, frequency: f64, frames: usize) -> Vec<f64> {
    (0..frames).map(|i| 0.5 * sin_pi(2.0 * frequency * i as f64 / rate)).collect()
}

#[test]
fn every_kind_of_samples_is_kept_and_every_channel_converted() {
    let channels = [tone(44_100.0, 1_000.0, 4_410), tone(44_100.0, 3_333.0, 4_410)];
    let frames: Vec<f64> = (0..4_410).flat_map(|i| [channels[0][i], channels[1][i]]).collect();
    for encoding in Encoding::ALL {
        let (_folder, input, output) = folder(44_100, 2, encoding, &frames);
        let done = resample(&[text(&input), text(&output), "--rate", "48000", "--quality", "best"]);
        assert_eq!(code(&done), 0, "{}", stderr(&done));
        let (format, values) = read(&fs::read(&output).unwrap());
        assert_eq!((format.rate(), format.channels(), format.encoding()), (48_000, 2, encoding));
        assert_eq!(values.len(), 2 * 4_800);
        // a tone at its phase: what 16 bits and less leave is their rounding and dither, at most 2.5 steps
        let most = 2.5 * encoding.step() + if encoding == Encoding::Float64 { 1e-10 } else { 1e-7 };
        for (c, frequency) in [1_000.0, 3_333.0].into_iter().enumerate() {
            let truth = tone(48_000.0, frequency, 4_800);
            let worst = (1_600..3_200).map(|i| (values[2 * i + c] - truth[i]).abs()).fold(0.0, f64::max);
            assert!(worst <= most, "{encoding:?}, channel {c}: {worst:e} > {most:e}");
        }
    }
}

#[test]
fn the_command_is_the_library_to_the_last_bit() {
    let values = tone(48_000.0, 5_000.0, 20_000);
    let (_folder, input, output) = folder(48_000, 1, Encoding::Float64, &values);
    for (rate, number) in [("44100", 44_100.0), ("48000/1.001", 48_000.0 / 1.001), ("31415.926", 31_415.926)] {
        let done = resample(&[text(&input), text(&output), "--rate", rate, "--force"]);
        assert_eq!(code(&done), 0, "{}", stderr(&done));
        let (format, converted) = read(&fs::read(&output).unwrap());
        assert_eq!(converted, convert(&values, 48_000.0, number, Quality::High).unwrap());
        assert_eq!(f64::from(format.rate()), number.round());
        assert_eq!(stderr(&done).contains("whole rate"), number.fract() != 0.0, "{}", stderr(&done));
    }
}

#[test]
fn pipes_are_files() {
    let values = tone(8_000.0, 500.0, 9_000);
    let (_folder, input, output) = folder(8_000, 1, Encoding::Int16, &values);
    let bytes = fs::read(&input).unwrap();
    assert_eq!(code(&resample(&[text(&input), text(&output), "--rate", "48000"])), 0);
    let whole = fs::read(&output).unwrap();
    let through = piped("resample", &["-", "-", "--rate", "48000"], &bytes);
    assert_eq!((code(&through), &through.stdout), (0, &whole), "{}", stderr(&through));
    // a stream that left its length open, into a file: the length is there in the end
    let mut open = bytes.clone();
    open[40..44].copy_from_slice(&[0xff; 4]);
    assert_eq!(code(&piped("resample", &["-", text(&output), "--rate", "48000", "--force"], &open)), 0);
    let file = fs::read(&output).unwrap();
    assert_eq!(WavReader::new("x", &file[..]).unwrap().frames(), Some(54_000));
    assert_eq!(read(&file).1, read(&whole).1);
    // and into a pipe: it stays open
    let through = piped("resample", &["-", "-", "--rate", "48000"], &open);
    assert_eq!(read(&through.stdout).1, read(&whole).1);
}

#[test]
fn dither_is_the_same_in_every_run_and_can_be_left_out() {
    // a tone of half a step of 16 bits: gone without dither, there with it
    let values: Vec<f64> = tone(48_000.0, 1_000.0, 48_000).iter().map(|v| v * 0.8 / 32_768.0).collect();
    let (_folder, input, output) = folder(48_000, 1, Encoding::Float32, &values);
    let run = |more: &[&str]| {
        let args = [&[text(&input), text(&output), "--rate", "44100", "--bits", "16", "--force"], more].concat();
        assert_eq!(code(&resample(&args)), 0);
        fs::read(&output).unwrap()
    };
    let (first, again, plain) = (run(&[]), run(&[]), run(&["--no-dither"]));
    assert_eq!(first, again);
    assert!(read(&plain).1.iter().all(|&v| v == 0.0));
    // correlation with the tone: amplitude 0.4 steps, noise of ½ step a sample: ±5·½·√(2/n)
    let (_, dithered) = read(&first);
    let n = dithered.len() as f64;
    let truth = tone(44_100.0, 1_000.0, dithered.len());
    let amplitude = dithered.iter().zip(&truth).map(|(v, t)| v * t / 0.5).sum::<f64>() * 2.0 / n * 32_768.0;
    assert!((amplitude - 0.4).abs() < 5.0 * 0.5 * (2.0 / n).sqrt(), "{amplitude}");
}

#[test]
fn equal_rates_copy_codes() {
    let values: Vec<f64> = (0..5_000).map(|i| f64::from(i * 13 % 60_000 - 30_000) / 32_768.0).collect();
    let (_folder, input, output) = folder(48_000, 1, Encoding::Int16, &values);
    assert_eq!(code(&resample(&[text(&input), text(&output), "--rate", "48000"])), 0);
    assert_eq!(fs::read(&output).unwrap(), fs::read(&input).unwrap());
}

#[test]
fn clipping_is_said() {
    // a square wave at full scale overshoots when it is band-limited (Gibbs)
    let square: Vec<f64> = (0..4_800).map(|i| if i / 24 % 2 == 0 { 0.99 } else { -0.99 }).collect();
    let (_folder, input, output) = folder(48_000, 1, Encoding::Int16, &square);
    let done = resample(&[text(&input), text(&output), "--rate", "44100", "--json"]);
    assert_eq!(code(&done), 0);
    assert!(stderr(&done).contains("samples clipped to 16-bit integer, the first in frame "), "{}", stderr(&done));
    let report: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    assert!(report["clipping"]["samples"].as_u64().unwrap() > 100);
    assert!(report["clipping"]["peak"].as_f64().unwrap() > 1.05);
    assert_eq!(report["output"]["frames"], 4_410);
    assert_eq!(report["ratio"]["terms"], serde_json::json!([147, 160]));
    let float = resample(&[text(&input), text(&output), "--rate", "44100", "--bits", "f32", "--force"]);
    assert!(!stderr(&float).contains("clipped"));
}

#[test]
fn chunks_that_are_dropped_are_named() {
    let mut bytes = wav(WavFormat::new(8_000, 1, Encoding::Int16).unwrap(), &[0.0; 100]);
    bytes.extend(b"LIST\x04\0\0\0INFO");
    let done = piped("resample", &["-", "-", "--rate", "16000"], &bytes);
    assert_eq!(code(&done), 0);
    assert_eq!(stderr(&done), "note: the chunk \"LIST\" (4 bytes) is not carried over\n");
}

#[test]
fn files_are_safe() {
    let (folder, input, output) = folder(8_000, 1, Encoding::Int16, &[0.25; 1000]);
    let before = fs::read(&input).unwrap();
    let inside = folder.path().join(".").join("in.wav");
    let same = resample(&[text(&input), text(&inside), "--rate", "16000", "--force"]);
    assert_eq!(code(&same), 2);
    assert!(stderr(&same).contains("is the input, which is never overwritten"));
    fs::write(&output, "precious").unwrap();
    let there = resample(&[text(&input), text(&output), "--rate", "16000"]);
    assert_eq!((code(&there), fs::read(&output).unwrap()), (2, b"precious".to_vec()));
    assert!(stderr(&there).contains("--force"));
    // a file that ends too early leaves what was there, and nothing beside it
    fs::write(&input, &before[..500]).unwrap();
    let cut = resample(&[text(&input), text(&output), "--rate", "16000", "--force"]);
    assert_eq!((code(&cut), fs::read(&output).unwrap()), (2, b"precious".to_vec()));
    assert!(stderr(&cut).contains("the data end after 228 of the 1000 frames"), "{}", stderr(&cut));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
}

#[test]
fn nonsense_is_one_sentence() {
    let (_folder, input, output) = folder(8_000, 1, Encoding::Int16, &[0.25; 1000]);
    let (input, output) = (text(&input), text(&output));
    for (args, words) in [
        (&[input, output, "--rate", "0"][..], "a WAV file can have rates from 1 to"),
        (&[input, output, "--rate", "nan"], "a WAV file can have rates from 1 to"),
        (&[input, output, "--rate", "fast"], "is no number"),
        (&[input, output, "--rate", "1/0"], "a WAV file can have rates from 1 to"),
        (&[input, output, "--rate", "4000000000"], "between 0.001 and 1000"),
        (&[input, output, "--rate", "16000", "--quality", "good"], "no quality is called \"good\""),
        (&[input, output, "--rate", "16000", "--bits", "12"], "known: 8, 16, 24, 32, f32, f64"),
        (&[input, "-", "--rate", "16000", "--json"], "would mix"),
        (&["/no/such.wav", output, "--rate", "16000"], "/no/such.wav"),
        (&["Cargo.toml", output, "--rate", "16000"], "Cargo.toml: not a WAV file"),
    ] {
        let done = resample(args);
        assert_eq!(code(&done), 2, "{args:?}");
        assert!(stderr(&done).contains(words), "{args:?}: {}", stderr(&done));
        assert!(!Path::new(output).exists());
    }
}

#[test]
fn help_states_the_qualities_in_numbers() {
    let help = resample(&["--help"]);
    let help = String::from_utf8_lossy(&help.stdout).into_owned();
    for words in ["0.91", "0.96", "0.99", "100 dB", "150 dB", "200 dB", "1e-9"] {
        assert!(help.contains(words), "{words}: {help}");
    }
}

#[test]
fn limits_of_the_rate_and_an_empty_sound_are_said() {
    let (_folder, input, output) = folder(48_000, 1, Encoding::Int16, &[]);
    let done = resample(&[text(&input), text(&output), "--rate", "44.1"]);
    assert_eq!(code(&done), 2);
    let said = stderr(&done);
    assert!(said.contains("--rate must lie between 48 and 48000000 Hz") && said.ends_with("got 44.1\n"), "{said}");
    let done = resample(&[text(&input), text(&output), "--rate", "8000"]);
    assert_eq!(code(&done), 0);
    assert!(stderr(&done).contains("the input is empty"), "{}", stderr(&done));
}
