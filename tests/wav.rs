//! Sound at the door: what is read is what was written, by whomever, and what is no sound is refused with a reason.

use nyquist::door::wav::{Dither, Encoding, WavFormat, WavReader, WavWriter};
use nyquist::error::Error;
use nyquist::num::random::uniform;
use std::io::Cursor;

/// The oracle: a file put together by hand, as the specification has it.
fn riff(chunks: &[(&[u8; 4], &[u8])]) -> Vec<u8> {
    let mut body = b"WAVE".to_vec();
    for (id, bytes) in chunks {
        body.extend(*id);
        body.extend((bytes.len() as u32).to_le_bytes());
        body.extend(*bytes);
        body.extend(&[0][..bytes.len() % 2]);
    }
    [&b"RIFF"[..], &(body.len() as u32).to_le_bytes(), &body].concat()
}

fn fmt(kind: u16, channels: u16, rate: u32, bits: u16) -> Vec<u8> {
    let align = channels * bits.div_ceil(8);
    let mut fmt = [kind.to_le_bytes(), channels.to_le_bytes()].concat();
    fmt.extend(rate.to_le_bytes());
    fmt.extend((rate.saturating_mul(u32::from(align))).to_le_bytes());
    fmt.extend(align.to_le_bytes());
    fmt.extend(bits.to_le_bytes());
    fmt
}

fn extensible(kind: u16, channels: u16, bits: u16, valid: u16) -> Vec<u8> {
    let mut fmt = fmt(0xfffe, channels, 48_000, bits);
    fmt.extend([22, 0]);
    fmt.extend(valid.to_le_bytes());
    fmt.extend(0x3fu32.to_le_bytes());
    fmt.extend(kind.to_le_bytes());
    fmt.extend([0, 0, 0, 0, 0x10, 0, 0x80, 0, 0, 0xaa, 0, 0x38, 0x9b, 0x71]);
    fmt
}

fn read_all(bytes: &[u8]) -> Result<(WavReader<&[u8]>, Vec<f64>), Error> {
    let mut reader = WavReader::new("x.wav", bytes)?;
    let mut values = Vec::new();
    while reader.read(100, &mut values)? > 0 {}
    Ok((reader, values))
}

fn reason(bytes: &[u8]) -> String {
    match read_all(bytes).map(|(_, values)| values.len()) {
        Err(Error::Format { file, reason }) => {
            assert_eq!(file, "x.wav");
            reason
        }
        other => panic!("{other:?}"),
    }
}

/// `bytes` with others from `at` on.
fn patched(bytes: &[u8], at: usize, new: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    bytes[at..at + new.len()].copy_from_slice(new);
    bytes
}

#[test]
fn codes_are_fractions_of_full_scale() {
    let eight = riff(&[(b"fmt ", &fmt(1, 1, 8000, 8)), (b"data", &[0, 128, 255])]);
    assert_eq!(read_all(&eight).unwrap().1, [-1.0, 0.0, 127.0 / 128.0]);
    let sixteen = riff(&[(b"fmt ", &fmt(1, 1, 8000, 16)), (b"data", &[0, 0x80, 0xff, 0x7f, 1, 0])]);
    assert_eq!(read_all(&sixteen).unwrap().1, [-1.0, 32767.0 / 32768.0, 1.0 / 32768.0]);
    let twenty_four = riff(&[(b"fmt ", &fmt(1, 2, 8000, 24)), (b"data", &[0, 0, 0x80, 0xff, 0xff, 0xff])]);
    assert_eq!(read_all(&twenty_four).unwrap().1, [-1.0, -1.0 / 8_388_608.0]);
    let long = riff(&[(b"fmt ", &fmt(1, 1, 8000, 32)), (b"data", &[0, 0, 0, 0x40])]);
    assert_eq!(read_all(&long).unwrap().1, [0.5]);
    let single = riff(&[(b"fmt ", &fmt(3, 1, 8000, 32)), (b"data", &1.5f32.to_le_bytes())]);
    assert_eq!(read_all(&single).unwrap().1, [1.5]);
    let double = riff(&[(b"fmt ", &fmt(3, 1, 8000, 64)), (b"data", &0.1f64.to_le_bytes())]);
    assert_eq!(read_all(&double).unwrap().1, [0.1]);
}

#[test]
fn extensible_headers_say_valid_bits_and_loudspeakers() {
    let bytes = riff(&[(b"fmt ", &extensible(1, 6, 24, 20)), (b"data", &[0; 36])]);
    let (reader, values) = read_all(&bytes).unwrap();
    let format = reader.format();
    assert_eq!((format.channels(), format.encoding(), format.valid_bits()), (6, Encoding::Int24, 20));
    assert_eq!((format.speakers(), values.len(), reader.position()), (Some(0x3f), 12, 2));
    let float = riff(&[(b"fmt ", &extensible(3, 1, 32, 32)), (b"data", &0.25f32.to_le_bytes())]);
    assert_eq!(read_all(&float).unwrap().1, [0.25]);
    let odd = patched(&float, 20 + 30, &[9]);
    assert!(reason(&odd).contains("kind that is not known"), "{}", reason(&odd));
}

#[test]
fn other_chunks_are_skipped_and_counted() {
    let bytes = riff(&[
        (b"LIST", &[7; 5]),
        (b"JUNK", &[0; 28]),
        (b"fmt ", &fmt(1, 1, 8000, 8)),
        (b"bext", &[1; 602]),
        (b"data", &[128, 129, 130]),
        (b"LIST", &[8; 10]),
    ]);
    let (reader, values) = read_all(&bytes).unwrap();
    assert_eq!(values, [0.0, 1.0 / 128.0, 2.0 / 128.0]);
    let skipped: Vec<_> = reader.skipped().iter().map(|s| (s.name.as_str(), s.count, s.bytes)).collect();
    assert_eq!(skipped, [("LIST", 2, 15), ("bext", 1, 602)]);
    assert_eq!(reader.trailing(), 0);
    let more = [&bytes[..], &[0xff; 100_000]].concat();
    assert_eq!(read_all(&more).unwrap().0.trailing(), 100_000);
    // however many names a file invents
    let names: Vec<[u8; 4]> = (0..200u32).map(|i| *format!("c{i:03}").as_bytes().first_chunk().unwrap()).collect();
    let mut many: Vec<(&[u8; 4], &[u8])> = names.iter().map(|name| (name, &[0u8; 2][..])).collect();
    let explained = fmt(1, 1, 8000, 8);
    many.extend([(b"fmt ", &explained[..]), (b"data", &[0][..])]);
    let many = riff(&many);
    let (reader, _) = read_all(&many).unwrap();
    assert_eq!(reader.skipped().iter().map(|s| s.count).sum::<u64>(), 200);
    assert!(reader.skipped().len() <= 33);
}

#[test]
fn a_length_that_a_stream_left_open_reaches_to_the_end() {
    let bytes = riff(&[(b"fmt ", &fmt(1, 2, 8000, 16)), (b"data", &[0; 400])]);
    for (riff, data) in [(u32::MAX, u32::MAX), (0, 0), (36, 0), (0x7fff_f024, 0x7fff_f000), (u32::MAX, 0)] {
        let open = patched(&patched(&bytes, 4, &riff.to_le_bytes()), 40, &data.to_le_bytes());
        let (reader, values) = read_all(&open).unwrap();
        assert_eq!((reader.frames(), reader.position(), values.len()), (None, 100, 200), "{data:x}");
        assert!(reason(&open[..open.len() - 1]).contains("in the middle of frame 99"));
    }
    // no data and another chunk after them is no open length
    let empty = riff(&[(b"fmt ", &fmt(1, 2, 8000, 16)), (b"data", &[]), (b"LIST", &[0; 4])]);
    let (reader, values) = read_all(&empty).unwrap();
    assert_eq!((reader.frames(), values.len(), reader.skipped().len()), (Some(0), 0, 1));
}

#[test]
fn lengths_beyond_four_gigabytes_stand_in_ds64() {
    let bytes = riff(&[(b"fmt ", &fmt(1, 1, 8000, 8)), (b"data", &[128; 10])]);
    let ds64 = |data: u64| {
        let mut long = b"RF64\xff\xff\xff\xffWAVEds64\x1c\0\0\0".to_vec();
        long.extend([data + 72, data, data].map(u64::to_le_bytes).concat());
        long.extend([0; 4]);
        long.extend(patched(&bytes, 40, &u32::MAX.to_le_bytes()).split_off(12));
        long
    };
    let long = ds64(10);
    let (reader, values) = read_all(&long).unwrap();
    assert_eq!((reader.frames(), values.len()), (Some(10), 10));
    assert!(reason(&ds64(1 << 40)).contains("end after 10 of the 1099511627776 frames"));
}

#[test]
fn what_is_written_is_read_back_to_the_last_bit() {
    for encoding in Encoding::ALL {
        for channels in [1u16, 2, 3, 8] {
            let format = WavFormat::new(44_100, channels, encoding).unwrap();
            let count = 301 * u64::from(channels);
            let step = encoding.step();
            let values: Vec<f64> = (0..count)
                .map(|i| match encoding {
                    Encoding::Float64 => uniform(1, i, 0) * 4.0 - 2.0,
                    Encoding::Float32 => f64::from((uniform(1, i, 0) * 4.0 - 2.0) as f32),
                    _ => ((uniform(1, i, 0) * 2.0 - 1.0) / step).floor() * step,
                })
                .collect();
            let write = |frames| {
                let mut writer =
                    WavWriter::new("x.wav", Cursor::new(Vec::new()), format, frames, Dither::None).unwrap();
                for block in values.chunks(usize::from(channels) * 17) {
                    writer.write(block).unwrap();
                }
                let (sink, clipping) = writer.finish_seek().unwrap();
                assert_eq!(clipping.samples, 0);
                sink.into_inner()
            };
            for bytes in [write(Some(301)), write(None)] {
                assert_eq!(u32::from_le_bytes(*bytes[4..].first_chunk().unwrap()) as usize, bytes.len() - 8);
                let (reader, back) = read_all(&bytes).unwrap();
                assert_eq!((reader.frames(), reader.trailing(), reader.skipped().len()), (Some(301), 0, 0));
                assert_eq!(reader.format().encoding(), encoding);
                assert!(reader.byte_rate_fits());
                assert_eq!(back, values, "{encoding:?}, {channels} channels");
            }
        }
    }
}

#[test]
fn a_stream_is_written_with_its_length_open() {
    let format = WavFormat::new(44_100, 1, Encoding::Int24).unwrap();
    let mut writer = WavWriter::new("-", Vec::new(), format, None, Dither::None).unwrap();
    writer.write(&[0.5; 7]).unwrap();
    let (bytes, _) = writer.finish().unwrap();
    let (reader, values) = read_all(&bytes).unwrap();
    assert_eq!((reader.frames(), values), (None, vec![0.5; 7]));
}

#[test]
fn other_numbers_of_frames_than_announced_are_an_error() {
    let format = WavFormat::new(44_100, 2, Encoding::Int16).unwrap();
    let mut writer = WavWriter::new("x.wav", Vec::new(), format, Some(2), Dither::None).unwrap();
    assert!(matches!(writer.write(&[0.0; 3]), Err(Error::Length { expected: 4, got: 3, .. })));
    assert!(matches!(writer.write(&[f64::NAN, 0.0]), Err(Error::NotFiniteAt { index: 0, .. })));
    writer.write(&[0.0; 2]).unwrap();
    assert!(matches!(writer.finish(), Err(Error::Length { expected: 2, got: 1, .. })));
}

#[test]
fn dither_makes_the_error_independent_of_the_signal() {
    let format = WavFormat::new(48_000, 1, Encoding::Int16).unwrap();
    let n = 100_000usize;
    for at in [0.0, 0.25, 0.5] {
        let written = |dither| {
            let mut writer = WavWriter::new("x.wav", Vec::new(), format, Some(n as u64), dither).unwrap();
            writer.write(&vec![at / 32768.0; n]).unwrap();
            writer.finish().unwrap().0
        };
        let bytes = written(Dither::Triangular { seed: 3 });
        assert_eq!(bytes, written(Dither::Triangular { seed: 3 }));
        let (_, values) = read_all(&bytes).unwrap();
        let errors: Vec<f64> = values.iter().map(|v| v * 32768.0 - at).collect();
        let mean = errors.iter().sum::<f64>() / n as f64;
        let power = errors.iter().map(|e| e * e).sum::<f64>() / n as f64;
        // mean 0 and power ¼; five deviations, of ½/√n and, the fourth moment being below ½, of √½/√n
        let five = 5.0 / (n as f64).sqrt();
        assert!(mean.abs() < 0.5 * five && (power - 0.25).abs() < 0.5f64.sqrt() * five, "{at}: {mean} {power}");
        // without it a constant of a quarter of a step is gone
        let (_, plain) = read_all(&written(Dither::None)).unwrap();
        assert!(plain.iter().all(|&v| v == 0.0));
    }
}

#[test]
fn hostile_headers_get_one_clear_sentence() {
    let good = riff(&[(b"fmt ", &fmt(1, 2, 8000, 16)), (b"data", &[0; 400])]);
    assert!(read_all(&good).is_ok());
    let with = |at: usize, new: &[u8]| reason(&patched(&good, at, new));
    assert_eq!(reason(&[]), "not a WAV file, by its first bytes");
    assert_eq!(reason(b"\x89PNG\r\n\x1a\n...."), "not a WAV file, by its first bytes");
    assert!(with(0, b"RIFX").contains("big-endian"));
    assert!(with(8, b"AVI ").contains("not of sound"));
    assert_eq!(with(22, &[0, 0]), "the header says 0 channels");
    assert_eq!(with(24, &[0; 4]), "the header says a rate of 0 Hz");
    assert!(with(20, &[0x55]).contains("compressed (MP3)"));
    assert!(with(20, &[0x99]).contains("compressed (kind 0x0099)"));
    assert!(with(20, &[3]).contains("floating-point samples of 16 bits"));
    assert!(with(34, &[0]).contains("integers of 0 bits"));
    assert!(with(34, &[64]).contains("integers of 64 bits"));
    let align = "the header contradicts itself: 2 channels of 2 bytes are frames of 4 bytes, not of 3";
    assert_eq!(with(32, &[3]), align);
    assert!(with(22, &[0xff, 0xff]).contains("65535 channels of 2 bytes are frames of 131070 bytes, not of 4"));
    assert_eq!(
        with(40, &[0xfc, 0xff, 0xff, 0xff]),
        "the data end after 100 of the 1073741823 frames that the header says"
    );
    assert!(with(40, &[0x8f, 1]).contains("399 bytes of data, which is no whole number of frames of 4"));
    assert!(with(16, &[8]).contains("needs more") || with(16, &[8]).contains("ends within"));
    assert!(with(16, &[0xff, 0xff, 0xff, 0xff]).contains("within its chunk \"fmt \""));
    for end in 4..good.len() {
        let reason = reason(&good[..end]);
        assert!(reason.contains("end"), "{end}: {reason}");
    }
    let backwards = riff(&[(b"data", &[0; 4]), (b"fmt ", &fmt(1, 2, 8000, 16))]);
    assert!(reason(&backwards).contains("before the chunk \"fmt \""));
    let twice = riff(&[(b"fmt ", &fmt(1, 2, 8000, 16)), (b"fmt ", &fmt(1, 2, 8000, 16))]);
    assert!(reason(&twice).contains("two chunks"));
}

#[test]
fn values_that_are_not_numbers_are_named_with_their_frame() {
    let mut samples = vec![0.5f32; 600];
    samples[2 * 250 + 1] = f32::NAN;
    let data: Vec<u8> = samples.iter().flat_map(|v| v.to_le_bytes()).collect();
    let bytes = riff(&[(b"fmt ", &fmt(3, 2, 8000, 32)), (b"data", &data)]);
    assert_eq!(reason(&bytes), "frame 250, channel 2: the 32-bit float is NaN, no sound");
}

#[test]
fn damaged_files_give_an_error_or_sound_and_never_a_panic() {
    let good = riff(&[(b"LIST", &[1; 3]), (b"fmt ", &extensible(1, 2, 24, 20)), (b"data", &[9; 600])]);
    for i in 0..3000u64 {
        let mut damaged = good.clone();
        for k in 0..=i % 4 {
            let random = |d: u32| nyquist::num::random::bits(17, 8 * i + k, d);
            // the head, where damage matters
            damaged[random(0) as usize % 90] = random(1) as u8;
        }
        if let Ok((reader, values)) = read_all(&damaged) {
            assert!(values.len() <= damaged.len() && reader.format().channels() > 0);
        }
    }
}
