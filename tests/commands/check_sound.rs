//! `nyquist check` of sounds as a user meets it: what it prints about another rate is found in the file that is made so.

use crate::running::{code, json, piped, run, stderr, stdout, text};
use nyquist::door::wav::{Dither, Encoding, WavFormat, WavWriter};
use nyquist::num::{cos_pi, sin_pi};
use serde_json::Value;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};
use tempfile::TempDir;

fn check(args: &[&str]) -> Output {
    run("check", args)
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("a number: {value}"))
}

fn wav(rate: u32, channels: u16, encoding: Encoding, values: &[f64]) -> Vec<u8> {
    let format = WavFormat::new(rate, channels, encoding).expect("the fixture is sound");
    let frames = (values.len() / format.channels()) as u64;
    let dither = Dither::Triangular { seed: 9 };
    let mut writer = WavWriter::new("memory", Vec::new(), format, Some(frames), dither).expect("the fixture is sound");
    writer.write(values).expect("the fixture is sound");
    writer.finish().expect("the fixture is sound").0
}

fn file(bytes: &[u8]) -> (TempDir, PathBuf) {
    let folder = TempDir::new().expect("the fixture is sound");
    let path = folder.path().join("in.wav");
    fs::write(&path, bytes).expect("the fixture is sound");
    (folder, path)
}

/// Amplitude and frequency of the tones of the fixture.
const TONES: [[f64; 2]; 4] = [[0.3, 997.0], [0.1, 3_456.7], [0.02, 9_123.4], [0.005, 13_333.3]];

fn tones(rate: f64, frames: usize) -> Vec<f64> {
    let tone = |[a, f]: [f64; 2], i: usize| a * sin_pi(2.0 * (f / rate * i as f64).fract());
    (0..frames).map(|i| TONES.iter().map(|t| tone(*t, i)).sum()).collect()
}

/// The amplitude of a tone in a record: its correlation under Hann's window.
fn amplitude(values: &[f64], rate: f64, frequency: f64) -> f64 {
    let n = values.len() as f64;
    let (mut re, mut im) = (0.0, 0.0);
    for (i, v) in values.iter().enumerate() {
        let window = 1.0 - cos_pi(2.0 * i as f64 / n);
        let turn = 2.0 * (frequency / rate * i as f64).fract();
        re += v * window * cos_pi(turn);
        im += v * window * sin_pi(turn);
    }
    2.0 / n * re.hypot(im)
}

#[test]
fn what_is_predicted_is_found_in_every_kind_of_samples() {
    let frames = 96_000;
    let values = tones(48_000.0, frames);
    for encoding in Encoding::ALL {
        let (_folder, input) = file(&wav(48_000, 1, encoding, &values));
        let done = check(&[text(&input), "--rate", "16000", "--json"]);
        assert_eq!(code(&done), 1, "{encoding:?}: {}", stderr(&done));
        let found = json(&done);
        let folded = found["forecast"][0]["folded"].as_array().unwrap();
        assert!(folded.len() >= 2, "{encoding:?}");
        // drop two of three samples of what was written
        let dropped: Vec<f64> = read(&fs::read(&input).unwrap()).into_iter().step_by(3).collect();
        for (line, [a, f]) in folded.iter().zip(&TONES[2..]) {
            let (place, level) = (number(&line["lands_at"]), number(&line["levels"]["plain"]));
            // noise of dithered integers, q²/4, in a bin of 8192, and in the correlation: five deviations; 32-bit
            // floats of up to 1 round to 2⁻²⁵, 3·10⁻⁸
            let q = encoding.step();
            let most = 5.0 * (0.25 * q * q * 2.0 * (2.8 / 8_192.0 + 3.0 / dropped.len() as f64)).sqrt() + 1e-7;
            let said = 10f64.powf(level / 20.0);
            let done = amplitude(&dropped, 16_000.0, place);
            assert!((done - said).abs() <= most, "{encoding:?}, {f}: {done} ≠ {said} ± {most:e}");
            assert!((said - a).abs() <= most && (place - (16_000.0 - f)).abs() < 0.1, "{encoding:?}: {a}, {f}");
        }
        // what is left of them after each quality, done by the command next to it
        for quality in ["fast", "high", "best"] {
            let output = input.with_file_name("out.wav");
            let mut resample = Command::new(env!("CARGO_BIN_EXE_nyquist"));
            resample.args(["resample", text(&input), text(&output), "--rate", "16000", "--force", "--bits", "f64"]);
            assert!(resample.args(["--quality", quality]).status().expect("the command starts").success());
            let converted = read(&fs::read(&output).unwrap());
            let middle = &converted[8_000..24_000];
            for line in folded.iter().take(2) {
                let said = 10f64.powf(number(&line["levels"][quality]) / 20.0);
                let done = amplitude(middle, 16_000.0, number(&line["lands_at"]));
                // what dither put there, and the side lobes of Hann's window around the other tones: 1/δ³ at 790 Hz and more
                let (q, bins) = (encoding.step(), 790.0 / 16_000.0 * middle.len() as f64);
                let most = 5.0 * (0.25 * q * q * 6.0 / middle.len() as f64).sqrt()
                    + 0.4 / bins.powi(3)
                    + 1e-7 * f64::from(u8::from(encoding == Encoding::Float32));
                assert!(done <= said + most, "{encoding:?}, {quality}: {done:e} > {said:e} + {most:e}");
            }
        }
    }
}

/// The first channel of a WAV file.
fn read(bytes: &[u8]) -> Vec<f64> {
    let mut reader = nyquist::door::wav::WavReader::new("memory", bytes).expect("the fixture is sound");
    let mut values = Vec::new();
    while reader.read(reader.block(), &mut values).expect("the fixture is sound") > 0 {}
    values.into_iter().step_by(reader.format().channels()).collect()
}

#[test]
fn exit_codes_are_the_answer() {
    let (_folder, input) = file(&wav(48_000, 1, Encoding::Int24, &tones(48_000.0, 96_000)));
    let run = |args: &[&str]| code(&check(&[&[text(&input)], args].concat()));
    assert_eq!(run(&[]), 0);
    assert_eq!(run(&["--rate", "32000"]), 0);
    assert_eq!(run(&["--rate", "16000"]), 1);
    // 0.3² + 0.1² over 0.02² + 0.005²: 23.7 dB
    assert_eq!(run(&["--rate", "16000", "--tolerance", "23.7"]), 0);
    assert_eq!(run(&["--rate", "16000", "--tolerance", "23.8"]), 1);
    assert_eq!(run(&["--rate", "96000", "--tolerance", "300"]), 0);
    assert_eq!(run(&["--rate", "48000"]), 0);
    assert_eq!(run(&["--rate", "48000/7"]), 1);
    assert_eq!(run(&["--rate", "22050.5"]), 1);
}

#[test]
fn words_say_what_to_do_next() {
    let (_folder, input) = file(&wav(48_000, 1, Encoding::Int24, &tones(48_000.0, 96_000)));
    let done = check(&[text(&input), "--rate", "16000"]);
    let said = stdout(&done);
    for words in [
        "aliases only 23.7 dB below the signal (tolerance 60 dB)",
        "one sample in 3",
        "9123.4 Hz",
        "6876.6 Hz",
        "13333.3 Hz",
        "2666.7 Hz",
        "--rate 16000 --quality fast",
        "the lowest standard rate that keeps the aliases 60 dB below the signal is 32000 Hz",
    ] {
        assert!(said.contains(words), "{words}: {said}");
    }
    let done = check(&[text(&input), "--rate", "16000", "--lang", "ru"]);
    let said = stdout(&done);
    for words in ["всего на 23,7 дБ ниже сигнала", "каждый 3-й отсчёт", "9123,4 Гц", "6876,6 Гц"]
    {
        assert!(said.contains(words), "{words}: {said}");
    }
    let own = stdout(&check(&[text(&input)]));
    for words in ["no sign of aliasing", "What cannot be known", "Without a filter 32000 Hz would do"] {
        assert!(own.contains(words), "{words}: {own}");
    }
}

#[test]
fn pipes_are_files_and_lengths_may_be_open() {
    let bytes = wav(48_000, 2, Encoding::Int16, &tones(48_000.0, 120_000));
    let (_folder, input) = file(&bytes);
    let whole = json(&check(&[text(&input), "--rate", "8000", "--json"]));
    let mut open = bytes;
    open[40..44].copy_from_slice(&[0xff; 4]);
    let mut through = json(&piped("check", &["-", "--rate", "8000", "--json"], &open));
    assert_eq!(through["file"], "standard input");
    through["file"] = whole["file"].clone();
    assert_eq!(through, whole);
    assert_eq!(whole["channels"].as_array().map(Vec::len), Some(2));
}

#[test]
fn reports_are_pictures_and_pages() {
    let (folder, input) = file(&wav(48_000, 1, Encoding::Int16, &tones(48_000.0, 96_000)));
    for rate in [&[][..], &["--rate", "16000"], &["--rate", "96000"]] {
        for (name, start) in
            [("r.svg", &b"<svg"[..]), ("r.png", b"\x89PNG"), ("r.pdf", b"%PDF"), ("r.html", b"<!DOCTYPE")]
        {
            let report = folder.path().join(name);
            let args =
                [&[text(&input), "-o", text(&report), "--force", "--theme", "dark", "--lang", "ru"], rate].concat();
            assert_eq!(code(&check(&args)), i32::from(rate.contains(&"16000")));
            assert!(fs::read(&report).unwrap().starts_with(start), "{name}");
        }
    }
    let there = check(&[text(&input), "-o", text(&folder.path().join("r.svg"))]);
    assert_eq!(code(&there), 2);
    assert!(stderr(&there).contains("--force"));
    let over = check(&[text(&input), "-o", text(&input), "--force"]);
    assert_eq!(code(&over), 2);
}

#[test]
fn silence_and_offsets_are_said() {
    for (value, mean) in [(0.0, 0.0), (0.25, 0.25)] {
        let (_folder, input) = file(&wav(44_100, 1, Encoding::Float64, &[value; 5_000]));
        for args in [&[][..], &["--rate", "8000"]] {
            let done = check(&[&[text(&input)], args].concat());
            assert_eq!(code(&done), 0);
            assert!(stdout(&done).contains("silence, nothing to alias"), "{}", stdout(&done));
        }
        let found = json(&check(&[text(&input), "--json"]));
        assert_eq!(found["channels"][0]["mean"], mean);
        assert_eq!(found["channels"][0]["rms"], Value::Null);
        assert_eq!(found["channels"][0]["band"]["p99"], Value::Null);
        assert_eq!(found["channels"][0]["silent"], true);
    }
}

#[test]
fn many_channels_are_no_trouble() {
    let frames = 3_000;
    let values: Vec<f64> = tones(48_000.0, frames).into_iter().flat_map(|v| vec![v; 300]).collect();
    let (_folder, input) = file(&wav(48_000, 300, Encoding::Int16, &values));
    let done = check(&[text(&input), "--rate", "16000", "--tolerance", "10"]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    assert!(stdout(&done).contains("284 more channels"), "{}", stdout(&done));
}

#[test]
fn nonsense_is_one_sentence() {
    let good = wav(48_000, 1, Encoding::Float32, &tones(48_000.0, 1_000));
    let (_folder, input) = file(&good);
    for (args, words) in [
        (&["--rate", "0"][..], "the rate of the output must be greater than zero"),
        (&["--rate=-8000"], "the rate of the output must be greater than zero"),
        (&["--rate", "nan"], "the rate of the output must be finite"),
        (&["--rate", "inf"], "the rate of the output must be finite"),
        (&["--rate", "1e308"], "between 0.001 and 1000"),
        (
            &["--rate", "1e300"],
            "--rate must lie between 48 and 48000000 Hz, between 0.001 and 1000 times the rate of the file, got 1e300",
        ),
        (
            &["--rate", "1e-300"],
            "--rate must lie between 48 and 48000000 Hz, between 0.001 and 1000 times the rate of the file, got 1e-300",
        ),
        (&["--rate", "cd"], "is no number"),
        (&["--rate", "40"], "between 0.001 and 1000"),
        (&["--tolerance=-3"], "the tolerance in dB must lie between 0 and 300"),
        (&["--tolerance", "nan"], "the tolerance in dB must be finite"),
        (&["-o", "report.txt"], "a report ends with .svg, .png, .pdf or .html"),
    ] {
        let done = check(&[&[text(&input)], args].concat());
        assert_eq!((code(&done), done.stdout.len()), (2, 0), "{args:?}: {}", stderr(&done));
        assert!(stderr(&done).contains(words), "{args:?}: {}", stderr(&done));
    }
    // files that lie, end early, hold nothing
    let patched = |at: usize, with: &[u8]| {
        let mut bytes = good.clone();
        bytes[at..at + with.len()].copy_from_slice(with);
        bytes
    };
    let data = good.len() - 4_000;
    for (bytes, words) in [
        (good[..good.len() - 10].to_vec(), "the data end after 997 of the 1000 frames"),
        (good[..20].to_vec(), "the file ends within"),
        (patched(22, &[0, 0]), "0 channels"),
        (patched(24, &[0; 4]), "a rate of 0 Hz"),
        (patched(data - 4, &0xffff_fff0u32.to_le_bytes()), "the data end after 1000 of the"),
        (patched(data + 400, &f32::NAN.to_le_bytes()), "frame 100, channel 1: the 32-bit float is NaN"),
        (wav(48_000, 1, Encoding::Int16, &[0.5]), "at least 64 needed, got 1"),
        (wav(48_000, 1, Encoding::Int16, &[]), "at least 64 needed, got 0"),
        (Vec::new(), "the file is empty"),
    ] {
        let (_folder, input) = file(&bytes);
        let done = check(&[text(&input)]);
        assert_eq!((code(&done), done.stdout.len()), (2, 0), "{words}: {}", stdout(&done));
        assert!(stderr(&done).contains(words), "{words}: {}", stderr(&done));
        assert_eq!(stderr(&done).lines().count(), 1);
    }
}

#[test]
fn help_says_what_the_tolerance_is() {
    let help = stdout(&check(&["--help"]));
    for words in ["signal-to-alias", "60", "Exit codes", "--rate"] {
        assert!(help.contains(words), "{words}: {help}");
    }
}

#[test]
fn the_rounding_of_its_own_bits_is_no_sign_of_aliasing() {
    let clean: Vec<f64> = (0..96_000).map(|i| 0.9 * sin_pi(2.0 * (997.3 / 48_000.0 * f64::from(i)).fract())).collect();
    let (_folder, input) = file(&wav(48_000, 1, Encoding::Int8, &clean));
    let done = check(&[text(&input)]);
    assert_eq!(code(&done), 0, "{}", stdout(&done));
    for words in ["no sign of aliasing", "no more than the rounding of its 8 bits leaves there"] {
        assert!(stdout(&done).contains(words), "{words}: {}", stdout(&done));
    }
    assert_eq!(json(&check(&[text(&input), "--json"]))["only_rounding"], true);
    // a tone there, as loud as the noise of the last sixteenth would have to be three times
    let beside = |i: usize| 0.004 * sin_pi(2.0 * (23_400.0 / 48_000.0 * i as f64).fract());
    let values: Vec<f64> = clean.iter().enumerate().map(|(i, v)| v + beside(i)).collect();
    let (_folder, input) = file(&wav(48_000, 1, Encoding::Int8, &values));
    assert_eq!(code(&check(&[text(&input)])), 1);
}

#[test]
fn words_name_the_channel_that_is_shown_and_how_many_are_not() {
    let values: Vec<f64> = tones(48_000.0, 6_000).into_iter().flat_map(|v| [0.1 * v; 20]).collect();
    let (_folder, input) = file(&wav(48_000, 20, Encoding::Int24, &values));
    for (args, said) in [
        (&["--rate", "16000"][..], "whose signal is the fewest dB above its aliases"),
        (&[], "whose last sixteenth is the fewest dB below the whole"),
    ] {
        let done = check(&[&[text(&input)], args].concat());
        let out = stdout(&done);
        assert!(code(&done) < 2, "{}", stderr(&done));
        assert!(out.contains(said) && !out.contains("strongest aliases"), "{out}");
        assert!(out.contains("4 more channels are left out here"), "{out}");
    }
}

#[test]
fn a_header_without_a_length_is_said_to_have_none() {
    let mut bytes = wav(48_000, 1, Encoding::Int16, &tones(48_000.0, 6_000));
    let (_folder, input) = file(&bytes);
    assert!(!stderr(&check(&[text(&input)])).contains("gives no length"));
    bytes[40..44].copy_from_slice(&[0xff; 4]);
    let (_folder, input) = file(&bytes);
    let done = check(&[text(&input)]);
    assert!(stderr(&done).contains("the header gives no length: read to the end of the file"), "{}", stderr(&done));
}
