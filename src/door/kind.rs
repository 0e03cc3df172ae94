//! What a file is, by its first bytes and not by its name.

use crate::error::{Error, Result};

/// The kinds of files that can be looked into.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
    /// WAV: `RIFF`, `RF64`, `BW64`, `RIFX`.
    Sound,
    /// PNG or JPEG.
    Picture,
    /// Text: numbers in rows.
    Table,
}

impl Kind {
    /// So many bytes are enough to tell.
    pub const HEAD: usize = 512;

    /// The kind of the file that begins with these bytes, at least [`HEAD`](Self::HEAD) of them or all there are; `name`
    /// is what errors call it. Text is what has no control characters but spaces, tabs and ends of lines.
    ///
    /// ```
    /// use nyquist::door::kind::Kind;
    /// assert_eq!(Kind::of("a", b"RIFF\x24\0\0\0WAVE")?, Kind::Sound);
    /// assert_eq!(Kind::of("b", b"\xff\xd8\xff\xe0")?, Kind::Picture);
    /// assert_eq!(Kind::of("c", b"t,v\n0,1\n")?, Kind::Table);
    /// let error = Kind::of("d", b"\x7fELF\x02").unwrap_err();
    /// assert_eq!(error.to_string(), "d: neither a WAV, PNG or JPEG file nor text, by its first bytes");
    /// # Ok::<(), nyquist::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Format`] for an empty file and for other kinds.
    pub fn of(name: &str, head: &[u8]) -> Result<Self> {
        let refused = |reason: &str| Err(Error::Format { file: name.to_owned(), reason: reason.to_owned() });
        let starts = |signatures: &[&[u8]]| signatures.iter().any(|s| head.starts_with(s));
        let control = |b: &u8| *b < 0x20 && !matches!(b, b'\t' | b'\n' | b'\r');
        match head {
            [] => refused("the file is empty"),
            _ if starts(&[b"RIFF", b"RF64", b"BW64", b"RIFX"]) => Ok(Self::Sound),
            _ if starts(&[b"\x89PNG\r\n\x1a\n", b"\xff\xd8\xff"]) => Ok(Self::Picture),
            // UTF-16 says so itself, and is told apart by the reader of tables
            _ if starts(&[b"\xff\xfe", b"\xfe\xff"]) || !head.iter().any(control) => Ok(Self::Table),
            _ => refused("neither a WAV, PNG or JPEG file nor text, by its first bytes"),
        }
    }
}
