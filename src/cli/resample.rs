//! `nyquist resample`: sound at another rate.

use crate::cli::number::quotient;
use crate::cli::sound::{note_oddities, open, pump, reachable};
use crate::cli::source::Source;
use crate::cli::working::note;
use crate::cli::{Failure, files, skipped};
use nyquist::door::wav::{Clipping, Dither, Encoding, WavFormat, WavReader, WavWriter};
use nyquist::error::Error;
use nyquist::rate::{Converter, Quality};
use serde_json::json;
use std::cell::Cell;
use std::io::{self, BufWriter, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

/// Convert a WAV file to another sampling rate.
#[derive(Debug, clap::Args)]
#[command(after_help = after_help())]
pub(super) struct Args {
    /// The WAV file to read: integers of 8 to 32 bits, floats of 32 or 64; `-` is standard input
    input: PathBuf,
    /// The WAV file to write; `-` is standard output
    output: PathBuf,
    /// The new rate in Hz: whole, real, or a quotient such as 48000/1.001
    #[arg(short = 'r', long, value_name = "R", value_parser = rate)]
    rate: f64,
    /// How clean: fast, high or best (in numbers below)
    #[arg(short = 'q', long, default_value = "high")]
    quality: Quality,
    /// Another kind of samples than that of the input: 8, 16, 24, 32 (integers), f32 or f64
    #[arg(long, value_name = "BITS", value_parser = encoding)]
    bits: Option<Encoding>,
    /// Round to integers without dither: the error then depends on the signal
    #[arg(long)]
    no_dither: bool,
    /// Replace the output if it exists
    #[arg(long)]
    force: bool,
    /// Print what was done as JSON
    #[arg(long)]
    json: bool,
}

/// Dithers of all runs are the same.
const SEED: u64 = 1;

fn after_help() -> String {
    let mut text = String::from(
        "All channels, any ratio of rates. A tone keeps its phase: the filter's delay is compensated.\n\
         Of n frames there come round(n*R/R0). The kind of samples stays; integers are dithered (TPDF,\n\
         the same noise in every run). What is clipped or left out is said on standard error.\n\n\
         Qualities, held by tests. The pass-band is a fraction of the lower Nyquist frequency of both\n\
         rates; rejected is all that lies beyond that frequency, which would alias or image.\n  \
         quality   pass-band to   44.1 with 48 kHz   ripple within   rejection\n",
    );
    for quality in Quality::ALL {
        let promise = quality.promise();
        let (name, pass, ripple, rejection) = (quality.name(), promise.pass, promise.ripple, promise.rejection);
        let kilohertz = 22.05 * pass;
        text += &format!("  {name:<9} {pass:<14} {kilohertz:.2} kHz          {ripple:<6e} dB       {rejection} dB\n");
    }
    text + "\nExamples:
  nyquist resample in.wav out.wav --rate 48000
  nyquist resample in.wav out.wav --rate 44100 --quality best --bits 24
  nyquist resample film.wav pal.wav --rate 48000/1.001
  sox talk.flac -t wav - | nyquist resample - - --rate 16000 > talk.wav"
}

/// A number of Hz, or a quotient of two.
fn rate(text: &str) -> Result<f64, String> {
    let rate = quotient(text)?;
    // a header can say whole numbers of 32 bits
    if rate >= 0.5 && rate <= f64::from(u32::MAX) {
        Ok(rate)
    } else {
        Err(format!("a WAV file can have rates from 1 to {} Hz", u32::MAX))
    }
}

fn encoding(text: &str) -> Result<Encoding, String> {
    let known = ["8", "16", "24", "32", "f32", "f64"];
    let found = known.iter().zip(Encoding::ALL).find(|(name, _)| **name == text);
    found.map(|(_, encoding)| encoding).ok_or_else(|| format!("known: {}", known.join(", ")))
}

fn called(encoding: Encoding) -> String {
    format!("{}-bit {}", encoding.bits(), if encoding.is_float() { "float" } else { "integer" })
}

pub(super) fn run(args: &Args, out: &mut impl Write) -> Result<(), Failure> {
    let piped = args.output == Path::new("-");
    if piped && args.json {
        return Err(Failure::Trouble("the output - and --json would mix sound and text on standard output".into()));
    }
    if !piped {
        files::distinct(&args.input, &args.output)?;
        files::vacant(&args.output, args.force)?;
    }
    let mut reader = open(Source::open(&args.input)?)?;
    let from = reader.format();
    let to = from.with((args.rate.round() as u32).max(1), args.bits.unwrap_or(from.encoding()))?;
    reachable(f64::from(from.rate()), args.rate)?;
    let converter = Converter::new(f64::from(from.rate()), args.rate, from.channels(), args.quality)?;
    let frames = reader.frames().map(|n| converter.ratio().frames(n));
    let (given, wanted) = (from.encoding(), to.encoding());
    // at the same rate codes stay what they are, where they fit
    let exact = converter.ratio().value() == 1.0 && !given.is_float() && given.bits() <= wanted.bits();
    let dithered = !args.no_dither && !wanted.is_float() && !exact;
    let dither = if dithered { Dither::Triangular { seed: SEED } } else { Dither::None };
    if args.rate != f64::from(to.rate()) {
        note(&format!("the header can only say a whole rate: {} Hz for {} Hz", to.rate(), args.rate));
    }
    let clipping = if piped {
        let closed = Cell::new(false);
        let sink = Pipe { sink: BufWriter::new(out.by_ref()), closed: &closed };
        let written = WavWriter::new("standard output", sink, to, frames, dither)
            .and_then(|mut writer| convert(&mut reader, converter, &mut writer).and_then(|()| Ok(writer.finish()?.1)));
        match written {
            Err(_) if closed.get() => return Err(Failure::ClosedPipe),
            written => written?,
        }
    } else {
        files::write_seek(&args.output, |file| {
            let mut writer = WavWriter::new(&args.output.display().to_string(), file, to, frames, dither)?;
            convert(&mut reader, converter, &mut writer)?;
            Ok(writer.finish_seek()?.1)
        })?
    };
    tell(&reader, wanted, &clipping);
    if piped { Ok(()) } else { report(args, &reader, to, dithered, &clipping, out) }
}

/// Block after block, to the end.
fn convert<R: Read, W: Write>(
    reader: &mut WavReader<R>,
    mut converter: Converter,
    writer: &mut WavWriter<W>,
) -> Result<(), Error> {
    let mut converted = Vec::new();
    pump(reader, |block| {
        converter.push(block, &mut converted)?;
        writer.write(&converted)?;
        converted.clear();
        Ok(())
    })?;
    converter.finish(&mut converted)?;
    writer.write(&converted)
}

/// What was left out, and what did not fit.
fn tell<R: Read>(reader: &WavReader<R>, wanted: Encoding, clipping: &Clipping) {
    skipped::tell(reader.skipped(), |name| format!("the chunk \"{name}\""));
    note_oddities(reader);
    if reader.position() == 0 {
        note("the input is empty, without a single frame, and so is the output");
    }
    if let Some(first) = clipping.first_frame {
        let (samples, peak) = (clipping.samples, 20.0 * clipping.peak.log10());
        note(&format!(
            "{samples} samples clipped to {}, the first in frame {first}; the peak is {peak:+.2} dB of full scale \
             (--bits f32 would hold it)",
            called(wanted)
        ));
    }
}

fn report<R: Read>(
    args: &Args,
    reader: &WavReader<R>,
    to: WavFormat,
    dithered: bool,
    clipping: &Clipping,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let from = reader.format();
    let path = args.output.display().to_string();
    let ratio = nyquist::rate::Ratio::new(f64::from(from.rate()), args.rate)?;
    let frames = ratio.frames(reader.position());
    let channels = to.channels();
    if !args.json {
        let plural = if channels == 1 { "" } else { "s" };
        let (rate, kind) = (args.rate, called(to.encoding()));
        return Ok(writeln!(out, "{path}: {frames} frames at {rate} Hz, {channels} channel{plural}, {kind}")?);
    }
    let promise = args.quality.promise();
    let value = json!({
        "input": { "file": args.input.display().to_string(), "rate": from.rate(), "frames": reader.position(),
            "channels": channels, "bits": from.encoding().bits(), "float": from.encoding().is_float() },
        "output": { "file": path, "rate": args.rate, "header_rate": to.rate(), "frames": frames,
            "bits": to.encoding().bits(), "float": to.encoding().is_float(), "dither": dithered },
        "ratio": { "value": ratio.value(), "terms": ratio.terms().map(|(up, down)| [up, down]) },
        "quality": { "name": args.quality.name(), "pass": promise.pass, "ripple_db": promise.ripple,
            "rejection_db": promise.rejection },
        "clipping": { "samples": clipping.samples, "first_frame": clipping.first_frame, "peak": clipping.peak },
        "skipped": skipped::json(reader.skipped()),
        "trailing_bytes": reader.trailing(),
    });
    Ok(writeln!(out, "{value:#}")?)
}

/// Standard output, which remembers that its reader has gone.
struct Pipe<'a, W> {
    sink: W,
    closed: &'a Cell<bool>,
}

impl<W: Write> Pipe<'_, W> {
    fn seen<T>(&self, result: io::Result<T>) -> io::Result<T> {
        if matches!(&result, Err(error) if error.kind() == ErrorKind::BrokenPipe) {
            self.closed.set(true);
        }
        result
    }
}

impl<W: Write> Write for Pipe<'_, W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let result = self.sink.write(bytes);
        self.seen(result)
    }

    fn flush(&mut self) -> io::Result<()> {
        let result = self.sink.flush();
        self.seen(result)
    }
}
