//! The command, and pictures for it.

use crate::running::run;
use nyquist::door::carried::{Carried, Light, Opened};
use nyquist::door::{Format, read_file, write_file};
use nyquist::prelude::*;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;
use tempfile::TempDir;

pub(crate) fn resize(args: &[&str]) -> Output {
    run("resize", args)
}

pub(crate) fn fixture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/pictures").join(name)
}

pub(crate) fn opened(bytes: &[u8]) -> Opened {
    read_file("memory", bytes, Limits::default(), Light::Linear).expect("a sound picture")
}

pub(crate) fn grey(width: usize, height: usize, f: impl Fn(f64, f64) -> f64) -> Image {
    Image::of(&field_fn(f), Grid::pixels(width, height).expect("small"))
}

/// A folder with a picture in it, and the names of input and output.
pub(crate) fn folder(picture: &Picture, carried: &Carried, output: &str) -> (TempDir, PathBuf, PathBuf) {
    let folder = TempDir::new().expect("a temporary folder");
    let (input, output) = (folder.path().join("in.png"), folder.path().join(output));
    fs::write(&input, write_file(picture, carried, Format::Png).expect("a sound picture")).expect("written");
    (folder, input, output)
}

pub(crate) fn plain(picture: &Picture, output: &str) -> (TempDir, PathBuf, PathBuf) {
    folder(picture, &Carried::default(), output)
}

/// A PNG with one more chunk before its data.
pub(crate) fn with_chunk(png: &[u8], name: &[u8; 4], content: &[u8]) -> Vec<u8> {
    let body = [&name[..], content].concat();
    let length = u32::try_from(content.len()).expect("short").to_be_bytes();
    let at = 33; // signature and IHDR
    [&png[..at], &length, &body, &crc(&body), &png[at..]].concat()
}

/// The checksum of a chunk's name and content.
pub(crate) fn crc(body: &[u8]) -> [u8; 4] {
    let crc = !body.iter().fold(!0u32, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |c, _| if c & 1 == 1 { 0xedb8_8320 ^ (c >> 1) } else { c >> 1 })
    });
    crc.to_be_bytes()
}
