//! Whoever stops the command finds no temporary file; options that could do nothing are refused.

use crate::running::nyquist;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

#[cfg(unix)]
#[test]
fn an_interrupted_command_leaves_nothing_behind() {
    use std::io::Write;
    use std::time::{Duration, Instant};
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join("out.wav");
    let mut child = Command::new(env!("CARGO_BIN_EXE_nyquist"))
        .args(["resample", "-", target.to_str().unwrap(), "--rate", "48000"])
        .stdin(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("the command starts");
    // a header that promises more than ever comes
    let mut head = b"RIFF\x24\x00\x10\x00WAVEfmt \x10\x00\x00\x00\x01\x00\x01\x00".to_vec();
    head.extend(44_100u32.to_le_bytes().iter().chain(&88_200u32.to_le_bytes()));
    head.extend(b"\x02\x00\x10\x00data\x00\x00\x10\x00");
    head.extend([0; 1 << 16]);
    let mut pipe = child.stdin.take().unwrap();
    pipe.write_all(&head).unwrap();
    let files = || fs::read_dir(folder.path()).unwrap().count();
    let begun = Instant::now();
    while files() == 0 {
        assert!(begun.elapsed() < Duration::from_secs(60), "no temporary file was begun");
        std::thread::sleep(Duration::from_millis(5));
    }
    assert!(Command::new("kill").args(["-TERM", &child.id().to_string()]).status().unwrap().success());
    let code = child.wait().unwrap().code();
    assert_eq!((code, files()), (Some(130), 0));
}

#[test]
fn options_for_another_kind_of_file_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let table = folder.path().join("t.csv");
    fs::write(&table, "t,v\n0,1\n1,0\n2,1\n3,0\n").unwrap();
    let picture = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/camera.png");
    let out = folder.path().join("o.csv");
    let (table, picture, out) = (table.to_str().unwrap(), picture.to_str().unwrap(), out.to_str().unwrap());
    for (args, why) in [
        (vec!["check", picture, "--rate", "8000"], "--rate is for sound and tables, and this is a picture"),
        (vec!["check", table, "--scale", "0.5"], "--scale is for pictures, and this is a table"),
        (vec!["spectrum", picture, "-o", out, "--window", "hann"], "--window is for sound and tables"),
        (vec!["spectrum", table, "-o", out, "--segment", "64"], "--segment is for sound, and this is a table"),
    ] {
        let done = nyquist(&args);
        let said = String::from_utf8_lossy(&done.stderr).into_owned();
        assert_eq!(done.status.code(), Some(2), "{args:?}: {said}");
        assert!(said.contains(why) && said.lines().count() == 1, "{args:?}: {said}");
    }
    assert!(!Path::new(out).exists());
}
