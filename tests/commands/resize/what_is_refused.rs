//! Files stay what they were, and nonsense is one sentence.

use crate::resize::material::{crc, fixture, grey, plain, resize};
use crate::running::{code, piped, stderr, text};
use nyquist::prelude::*;
use std::fs;
use std::path::Path;

#[test]
fn files_are_safe() {
    let (folder, input, output) = plain(&grey(8, 8, |x, _| x / 8.0).into(), "out.png");
    let before = fs::read(&input).unwrap();
    let inside = folder.path().join(".").join("in.png");
    let same = resize(&[text(&input), text(&inside), "--scale", "2", "--force"]);
    assert_eq!(code(&same), 2);
    assert!(stderr(&same).contains("is the input, which is never overwritten"));
    assert_eq!(fs::read(&input).unwrap(), before);
    fs::write(&output, "precious").unwrap();
    let there = resize(&[text(&input), text(&output), "--scale", "2"]);
    assert_eq!((code(&there), fs::read(&output).unwrap()), (2, b"precious".to_vec()));
    assert!(stderr(&there).contains("--force"));
    // a file that ends too early leaves what was there, and nothing beside it
    fs::write(&input, &before[..before.len() - 20]).unwrap();
    let cut = resize(&[text(&input), text(&output), "--scale", "2", "--force"]);
    assert_eq!((code(&cut), fs::read(&output).unwrap()), (2, b"precious".to_vec()));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
}

#[test]
fn nonsense_is_one_sentence_and_no_file() {
    let (folder, input, output) = plain(&grey(8, 8, |x, _| x / 8.0).into(), "out.png");
    let gif = folder.path().join("out.gif");
    let (input, output) = (text(&input), text(&output));
    for (args, words) in [
        (&[input, output][..], "say the new size"),
        (&[input, output, "--scale", "0"], "must be greater than zero and finite, got 0"),
        (&[input, output, "--scale", "x"], "\"x\" is no number"),
        (&[input, output, "--scale", "2", "--max-pixels", "NaN"], "room for a pixel"),
        (&[input, output, "--scale=-1"], "must be greater than zero and finite, got -1"),
        (&[input, output, "--scale", "nan"], "must be greater than zero and finite, got NaN"),
        (&[input, output, "--scale", "inf"], "must be greater than zero and finite, got inf"),
        (&[input, output, "--scale", "1e9"], "would be more than the 67200000 allowed; --max-pixels"),
        (&[input, output, "--width", "99999999999", "--height", "99999999999"], "would be more than"),
        (&[input, output, "--width", "0"], "--width 0: a picture has at least one pixel"),
        (&[input, output, "--scale", "2", "--width", "3"], "cannot be used with"),
        (&[input, output, "--scale", "2", "--filter", "bicubik"], "no filter is called \"bicubik\"; known: "),
        (&[input, output, "--scale", "2", "--filter", "lanczos3"], "known: lanczos-"),
        (&[input, output, "--scale", "2", "--filter", "ideal"], "needs every pixel for each"),
        (&[input, output, "--scale", "2", "--edge", "miror"], "no edge is called \"miror\"; known: mirror"),
        (&[input, output, "--scale", "2", "--bits", "12"], "8 or 16 bits"),
        (&[input, output, "--scale", "2", "--quality", "101"], "101"),
        (&[input, output, "--scale", "2", "--blur=-3"], "must lie between 0.05 and 1024"),
        (&[input, output, "--scale", "2", "--blur", "0"], "must lie between 0.05 and 1024"),
        (&[input, output, "--scale", "2", "--max-pixels", "0.00001"], "more than the 10 allowed"),
        (&[input, text(&gif), "--scale", "2"], "a picture ends with .png, .jpg or .jpeg"),
        (&[input, "-", "--scale", "2", "--json"], "would mix"),
        (&["/no/such.png", output, "--scale", "2"], "/no/such.png"),
        (&["Cargo.toml", output, "--scale", "2"], "Cargo.toml: neither a PNG nor a JPEG file"),
        (&["tests", output, "--scale", "2"], "is a folder"),
    ] {
        let done = resize(args);
        assert_eq!(code(&done), 2, "{args:?}");
        assert!(stderr(&done).contains(words), "{args:?}: {}", stderr(&done));
        assert!(!Path::new(output).exists(), "{args:?}");
    }
}

#[test]
fn hostile_files_are_one_sentence() {
    let good = png_bytes(&grey(5, 3, |x, _| x / 5.0).into(), Depth::Eight).unwrap();
    let header = |width: u32, height: u32| {
        let mut file = good.clone();
        file[16..20].copy_from_slice(&width.to_be_bytes());
        file[20..24].copy_from_slice(&height.to_be_bytes());
        let crc = crc(&file[12..29]);
        file[29..33].copy_from_slice(&crc);
        file
    };
    let mut bad_index = fs::read(fixture("palette.png")).unwrap();
    let palette = bad_index.windows(4).position(|w| w == b"PLTE").unwrap();
    // a palette of two colours where there were four: its length, its content, its checksum
    let colours = [&b"PLTE"[..], &bad_index[palette + 4..palette + 10]].concat();
    let crc = crc(&colours);
    let rest = bad_index.split_off(palette + 4 + 12 + 4);
    bad_index.truncate(palette - 4);
    let bad_index = [&bad_index[..], &6u32.to_be_bytes(), &colours, &crc, &rest].concat();
    let data = good.windows(4).position(|w| w == b"IDAT").unwrap();
    let mut flipped = good.clone();
    flipped[data + 8] ^= 0x55;
    let mut corrupt = good.clone();
    let length = u32::from_be_bytes([0, 1, 2, 3].map(|i| good[data - 4 + i])) as usize;
    corrupt[data + 4] = 0xff;
    let sum = crate::resize::material::crc(&corrupt[data..data + 4 + length]);
    corrupt[data + 4 + length..data + 8 + length].copy_from_slice(&sum);
    for (file, words) in [
        (flipped, "the chunk IDAT is damaged (its checksum differs)"),
        (corrupt, "the pixels are damaged"),
        (header(40_000, 25_000), "1000000000 pixels, more than the 67200000 allowed"),
        (header(0, 3), "dimensions"),
        (header(5, 4), "error:"),
        (good[..good.len() - 30].to_vec(), "the PNG ends in the middle"),
        (fs::read(fixture("ramp.jpg")).unwrap()[..900].to_vec(), "the JPEG ends in the middle"),
        (fs::read(fixture("ramp-cmyk.jpg")).unwrap(), "CMYK"),
        (bad_index, "of a palette of 2"),
        (Vec::new(), "the file is empty"),
    ] {
        let done = piped("resize", &["-", "-", "--scale", "2"], &file);
        assert_eq!(code(&done), 2, "{words}");
        let said = stderr(&done);
        assert!(said.contains(words) && said.lines().count() == 1 && said.starts_with("error: "), "{words}: {said}");
        assert!(done.stdout.is_empty());
    }
}

#[test]
fn what_stands_behind_the_end_is_counted_and_not_read() {
    let good = png_bytes(&grey(5, 3, |x, _| x / 5.0).into(), Depth::Eight).unwrap();
    let done = piped("resize", &["-", "-", "--scale", "2"], &[&good[..], &[b'x'; 100]].concat());
    assert_eq!((code(&done), stderr(&done).as_str()), (0, "note: 100 bytes after the end of the PNG ignored\n"));
}

#[test]
fn help_names_the_filters_and_says_what_light_is() {
    let help = String::from_utf8_lossy(&resize(&["--help"]).stdout).into_owned();
    for words in ["lanczos-3", "mitchell", "hamming", "none", "cubic:B,C", "bilinear", "linear", "profile", "density"] {
        assert!(help.contains(words), "{words}: {help}");
    }
    assert!(!help.contains("ideal"), "what cannot be used is not offered");
}
