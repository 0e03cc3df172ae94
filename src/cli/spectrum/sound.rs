//! `nyquist spectrum` of sounds.

use crate::cli::Failure;
use crate::cli::sound::{note_oddities, open, pump};
use crate::cli::source::Source;
use crate::cli::spectrum::{Args, Computed};
use crate::cli::working::note;
use nyquist::door::table::Heading;
use nyquist::figure::report::Quantity;
use nyquist::figure::report::sound::spectrum::{room, spectra, spectrograms, units, value_and_level};
use nyquist::inspect::sound::dbfs;
use nyquist::sampled::segments::{Detrend, Segments};
use nyquist::sampled::spectrogram::{Spectrogram, SpectrogramWriter};
use nyquist::sampled::welch::{PowerSpectrum, Welch};
use nyquist::sampled::window::Window;
use serde_json::{Value, json};

/// What can be said of sounds alone.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Sound")]
#[group(skip)]
pub(super) struct Options {
    /// Samples in a segment; spectra of segments are averaged (Welch) [default: 8192; spectrograms: 2048]
    #[arg(long, value_name = "N", conflicts_with = "resolution")]
    segment: Option<usize>,
    /// The distance of bins in Hz, instead of --segment
    #[arg(long, value_name = "HZ")]
    resolution: Option<f64>,
    /// The part of a segment that it shares with the next, from 0 up to, not including, 1 [default: 0.5; spectrograms: 0.875]
    #[arg(long, value_name = "PART")]
    overlap: Option<f64>,
    /// Leave the mean of each segment in
    #[arg(long)]
    keep_mean: bool,
    /// Power density over time and frequency; long sounds become columns of means, so that memory does not grow
    #[arg(long)]
    spectrogram: bool,
    /// Draw frequencies on a logarithmic scale
    #[arg(long, conflicts_with = "spectrogram")]
    log: bool,
}

/// What stands below the options.
pub(super) const HELP: &str =
    "Sound: full scale (FS) is 1. An amplitude is that of the sine that would read the same: a sine of
full scale is 1 FS, 0 dBFS. A density is one-sided mean square per Hz, as scipy.signal.welch has
it; in decibels 0 dBFS/Hz is the mean square of such a sine, 1/2, in one Hz. Spectra of segments
are averaged (Welch); --overlap 0 and a --segment of the whole length is the plain periodogram.

  nyquist spectrum talk.wav -o talk.svg
  nyquist spectrum talk.wav -o talk.csv --quantity density --resolution 5 --window blackman-harris
  nyquist spectrum talk.wav -o talk.png --spectrogram";

impl Options {
    /// How a sound of that rate is cut.
    fn segments(&self, rate: f64, window: Window) -> Result<Segments, Failure> {
        let (length, overlap) = if self.spectrogram { (2048, 0.875) } else { (8192, 0.5) };
        let length = match (self.segment, self.resolution) {
            (Some(length), _) => length,
            (None, Some(step)) if step > 0.0 && step <= rate => (rate / step).round() as usize,
            (None, Some(step)) => {
                return Err(Failure::Trouble(format!(
                    "--resolution must lie between 0 and the rate, {rate} Hz, got {step}"
                )));
            }
            (None, None) => length,
        };
        let overlap = self.overlap.unwrap_or(overlap);
        if !(0.0..1.0).contains(&overlap) {
            return Err(Failure::Trouble(format!("--overlap must be at least 0 and less than 1, got {overlap}")));
        }
        let hop = (length as f64 * (1.0 - overlap)).round().max(1.0) as usize;
        let detrend = if self.keep_mean { Detrend::None } else { Detrend::Mean };
        Ok(Segments::new(length, hop, window)?.detrend(detrend))
    }
}

pub(super) fn spectrum(source: Source, args: &Args) -> Result<Computed, Failure> {
    let name = source.name.clone();
    let mut reader = open(source)?;
    let options = &args.sound;
    let (rate, channels) = (f64::from(reader.format().rate()), reader.format().channels());
    let segments = options.segments(rate, args.window)?;
    let failed = |error| Failure::trouble(&name, error);
    if options.spectrogram {
        let (rows, columns) = room(channels);
        let mut writer = SpectrogramWriter::new(rate, channels, segments, columns, rows)?;
        pump(&mut reader, |block| writer.push(block))?;
        note_oddities(&reader);
        return over_time(&name, rate, segments, &writer.finish().map_err(failed)?);
    }
    let mut welch = Welch::new(rate, channels, segments)?;
    pump(&mut reader, |block| welch.push(block))?;
    note_oddities(&reader);
    let frames = reader.position();
    if frames < segments.length() as u64 {
        note(&format!("{frames} frames are less than a segment of {}: one segment of all", segments.length()));
    }
    Ok(averaged(&name, frames, args.quantity, options.log, &welch.finish().map_err(failed)?))
}

fn averaged(name: &str, frames: u64, quantity: Quantity, log: bool, found: &[PowerSpectrum]) -> Computed {
    let [unit, level] = units(quantity);
    let columns = (1..=found.len())
        .flat_map(|i| [unit, level].map(|unit| Heading { name: format!("channel {i}"), unit: unit.to_owned() }));
    let columns = std::iter::once(Heading::read("frequency [Hz]")).chain(columns).collect();
    let first = &found[0];
    let row = |k: usize| {
        let values = found.iter().flat_map(|spectrum| value_and_level(spectrum, quantity, k));
        std::iter::once(first.frequency(k)).chain(values).collect()
    };
    let rows: Vec<Vec<f64>> = (0..first.density().len()).map(row).collect();
    let all = |i: usize| rows.iter().map(|row| row[i]).collect::<Vec<_>>();
    let channels: Vec<Value> =
        (0..found.len()).map(|i| json!({ "values": all(1 + 2 * i), "levels": all(2 + 2 * i) })).collect();
    let json = json!({
        "file": name,
        "kind": "sound",
        "rate": first.rate(),
        "frames": frames,
        "quantity": quantity.name(),
        "units": { "values": unit, "levels": level },
        "window": first.cut().window().to_string(),
        "segment": first.cut().length(),
        "hop": first.cut().hop(),
        "segments": first.segments(),
        "noise_bandwidth": first.noise_bandwidth(),
        "frequencies": all(0),
        "channels": channels,
    });
    Computed { portrait: spectra(name, found, quantity, log), columns, rows, json }
}

fn over_time(name: &str, rate: f64, segments: Segments, found: &[Spectrogram]) -> Result<Computed, Failure> {
    let middle = |[from, to]: [f64; 2]| 0.5 * (from + to);
    let (bands, times) = found[0].density().dim();
    let frequencies: Vec<f64> = (0..bands).map(|i| middle(found[0].frequencies(i))).collect();
    let names =
        frequencies.iter().map(|frequency| Heading { name: format!("{frequency} Hz"), unit: "dBFS/Hz".to_owned() });
    let columns = ["time [s]", "channel"].map(Heading::read).into_iter().chain(names).collect();
    let row = |time: usize, channel: usize| -> Vec<f64> {
        let levels = (0..bands).map(|i| dbfs(found[channel].density()[[i, time]]));
        [middle(found[0].time(time)), (channel + 1) as f64].into_iter().chain(levels).collect()
    };
    let rows: Vec<Vec<f64>> =
        (0..times).flat_map(|time| (0..found.len()).map(move |c| (time, c))).map(|(t, c)| row(t, c)).collect();
    let json = json!({
        "file": name,
        "kind": "sound",
        "rate": rate,
        "units": { "levels": "dBFS/Hz" },
        "window": segments.window().to_string(),
        "segment": segments.length(),
        "hop": segments.hop(),
        "times": (0..times).map(|i| middle(found[0].time(i))).collect::<Vec<_>>(),
        "frequencies": frequencies,
        "channels": (0..found.len()).map(|c| (0..times).map(|t| row(t, c)[2..].to_vec()).collect::<Vec<_>>()).collect::<Vec<_>>(),
    });
    Ok(Computed { portrait: spectrograms(name, found, 0.5 * rate)?, columns, rows, json })
}
