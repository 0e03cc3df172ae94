//! `nyquist check` of sounds.

use crate::cli::Failure;
use crate::cli::check::{Args, Checked};
use crate::cli::sound::{note_oddities, open, pump, reachable};
use crate::cli::source::Source;
use nyquist::door::wav::WavFormat;
use nyquist::figure::report::sound::{Subject, report};
use nyquist::inspect::sound::{Channel, Check, Ending, Folded, Forecast, Meter, Outcome, TOLERANCE, Way, dbfs};
use serde_json::{Value, json};

/// What stands below the options.
pub(super) const HELP: &str =
    "Sound: with --rate R, what lies beyond R/2 and where it lands, sampled plainly (as when samples are
dropped) and through each quality of nyquist resample. The ratio is that of power over the whole
sound, of the channel where it is least, for plain sampling. Without --rate nobody can tell what
has folded already: the ratio is that of all power to that of the last sixteenth below the Nyquist
frequency, since what lay as near beyond it was about as strong. The tolerance is 60 dB if none is
given: aliases hold a millionth of the power. Telephone filters leave 40, 16 bits hold 98.

  nyquist check talk.wav
  nyquist check talk.wav --rate 16000 -o talk.html
  sox talk.flac -t wav - | nyquist check - --rate 44100 --tolerance 90 --json

";

pub(super) fn check(source: Source, args: &Args) -> Result<Checked, Failure> {
    let tolerance = args.tolerance.unwrap_or(TOLERANCE);
    let name = source.name.clone();
    let mut reader = open(source)?;
    let format = reader.format();
    args.rate.map(|rate| reachable(f64::from(format.rate()), rate)).transpose()?;
    Check::possible(f64::from(format.rate()), args.rate, tolerance)?;
    let mut meter = Meter::new(f64::from(format.rate()), format.channels())?;
    pump(&mut reader, |block| meter.push(block))?;
    let sound = meter.finish().map_err(|error| Failure::trouble(&name, error))?;
    note_oddities(&reader);
    let mut check = Check::new(sound, args.rate, tolerance)?;
    if !format.encoding().is_float() {
        // the lower bits of 20 in 24 are empty
        check = check.rounded_to(0.5f64.powi(i32::from(format.valid_bits()) - 1));
    }
    let subject = Subject { name: &name, encoding: format.encoding(), check: &check };
    Ok(Checked { report: report(&subject), json: json(&name, format, &check), fine: check.fine() })
}

/// The findings; levels in dBFS, frequencies in Hz, ratios in dB, and `null` where a level or ratio is infinite.
fn json(name: &str, format: WavFormat, check: &Check) -> Value {
    let sound = check.sound();
    json!({
        "file": name,
        "kind": "sound",
        "rate": sound.rate(),
        "frames": sound.frames(),
        "bits": format.encoding().bits(),
        "float": format.encoding().is_float(),
        "checked_rate": check.rate(),
        "tolerance_db": check.tolerance(),
        "fine": check.fine(),
        "only_rounding": check.only_rounding(),
        "ratio_db": check.ratio(),
        "worst_channel": check.worst() + 1,
        "smallest_rate": sound.smallest_rate(check.tolerance()),
        "burst_db": check.burst(),
        "burst_channel": check.burst_in().map(|(i, _)| i + 1),
        "channels": sound.channels().iter().map(channel).collect::<Vec<_>>(),
        "forecast": check.forecasts().iter().map(forecast).collect::<Vec<_>>(),
    })
}

fn channel(channel: &Channel) -> Value {
    let levels = channel.levels();
    let band = |fraction: f64| channel.occupied(fraction).ok().flatten();
    let ending = channel.ending().map(|ending| {
        let (name, drop) = match ending {
            Ending::Flat => ("flat", None),
            Ending::Falls { .. } => ("falls", None),
            Ending::Cut { drop, .. } => ("cut", Some(drop)),
            Ending::Runs => ("runs", None),
        };
        json!({ "kind": name, "at": ending.at(), "drop_db": drop, "enough_rate": ending.enough() })
    });
    let floor = channel.floor().map(|floor| json!({ "per_hz": dbfs(floor.density), "bits": floor.bits() }));
    let spectrum = channel.spectrum();
    let lines = channel.lines();
    let lines = lines.iter().map(|line| json!({ "frequency": line.frequency, "level": dbfs(line.power()) }));
    json!({
        "silent": channel.silent(),
        "peak": 20.0 * levels.peak().log10(),
        "rms": dbfs(levels.power),
        "mean": levels.mean,
        "band": { "p99": band(0.99), "p999": band(0.999), "p9999": band(0.9999), "resolution": spectrum.step() },
        "noise_floor": floor,
        "ending": ending,
        "edge": dbfs(channel.edge_power()),
        "segments": spectrum.segments(),
        "lines": lines.collect::<Vec<_>>(),
    })
}

fn forecast(forecast: &Forecast) -> Value {
    let way = |outcome: &Outcome| {
        let (signal, aliases) = (dbfs(outcome.signal), dbfs(outcome.aliases));
        let bound = outcome.way != Way::Plain;
        json!({ "way": outcome.way.name(), "signal": signal, "aliases": aliases, "ratio_db": outcome.ratio(), "bound": bound })
    };
    let folded = |folded: &Folded| {
        let levels = Way::ALL.iter().zip(folded.gains);
        let levels = levels.map(|(way, gain)| (way.name().to_owned(), json!(dbfs(folded.line.power() * gain * gain))));
        json!({
            "frequency": folded.line.frequency,
            "level": dbfs(folded.line.power()),
            "lands_at": folded.alias.frequency(),
            "levels": levels.collect::<serde_json::Map<_, _>>(),
        })
    };
    let stretches = forecast.stretches.iter().map(
        |stretch| json!({ "from": stretch.landing.from, "lands": stretch.landing.to, "level": dbfs(stretch.power) }),
    );
    let loudest = forecast.loudest.map(|moment| {
        json!({ "time": moment.time, "aliases": dbfs(moment.beyond), "signal": dbfs(moment.total - moment.beyond) })
    });
    json!({
        "ways": forecast.outcomes.iter().map(way).collect::<Vec<_>>(),
        "folded": forecast.folded.iter().map(folded).collect::<Vec<_>>(),
        "bands": stretches.collect::<Vec<_>>(),
        "loudest": loudest,
    })
}
