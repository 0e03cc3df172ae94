//! `nyquist check` of pictures.

use crate::cli::Failure;
use crate::cli::check::{Args, Checked};
use crate::cli::number::number;
use crate::cli::picture::{Most, open, seen, short};
use crate::cli::source::Source;
use crate::cli::working::spinner;
use nyquist::door::carried::Light;
use nyquist::figure::report::picture::{self as report, Question};
use nyquist::inspect::picture::band::{Band, Fall};
use nyquist::inspect::picture::found::{Cause, Found};
use nyquist::inspect::picture::sampler::Moire;
use nyquist::inspect::picture::shrinking::{Shrinking, Tolerance, Way};
use nyquist::kernel::Kernel;
use serde_json::{Value, json};

/// What stands below the options.
pub(super) const HELP: &str = "Pictures, in linear light. The tolerance is 40 dB if not given: a moiré of 1 % contrast,
(max - min)/(max + min), which an eye just sees on an even surface. Edges and texture hide their
own aliases: of them all together what is kept must be 30 dB (10 less) above what folds.
What is predicted is done as well, and what was found stands beside it. The exit code is that of
plain decimation (every new pixel takes the nearest old one), or of the filter that is named.
  nyquist check photo.jpg                              its band, and how far it could be shrunk
  nyquist check photo.jpg --scale 0.25 -o moire.png    what would alias, as a picture
  nyquist check photo.jpg --scale 0.25 --filter mitchell";

/// What can be said of pictures alone.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Pictures")]
#[group(skip)]
pub(super) struct Options {
    /// What would alias at this scale: one number, or X,Y for width and height
    #[arg(long, value_name = "S", value_parser = scale)]
    scale: Option<[f64; 2]>,
    /// Judge this filter instead of plain decimation: the exit code is its (names in `nyquist resize --help`)
    #[arg(long, value_name = "NAME", requires = "scale")]
    filter: Option<String>,
    #[command(flatten)]
    most: Most,
}

/// A number, or two with a comma between.
fn scale(text: &str) -> Result<[f64; 2], String> {
    let positive = |part: &str| -> Result<f64, String> {
        let value = number(part)?;
        if value.is_finite() && value > 0.0 {
            Ok(value)
        } else {
            Err("a scale must be greater than zero and finite".into())
        }
    };
    match text.split_once(',') {
        Some((x, y)) => Ok([positive(x)?, positive(y)?]),
        None => positive(text).map(|s| [s, s]),
    }
}

pub(super) fn check(source: Source, args: &Args) -> Result<Checked, Failure> {
    let Options { scale, filter, most } = &args.picture;
    let filter: Option<Box<dyn Kernel>> = filter.as_deref().map_or(Ok(None), crate::cli::picture::filter)?;
    let tolerance = args.tolerance.map_or(Ok(Tolerance::default()), Tolerance::new)?;
    let name = source.name.clone();
    let progress = spinner();
    progress.set_message("reading");
    let opened = open(source, *most, Light::Linear)?;
    let image = seen(&opened);
    let size = scale.map(|s| {
        let [w, h] = [image.width(), image.height()];
        crate::cli::resize::scaled([w, h], s, most.limits())
    });
    let file = if args.input == std::path::Path::new("-") { "-" } else { name.as_str() };
    let question = Question { size: size.transpose()?, tolerance, filter: filter.as_deref(), file };
    progress.set_message("looking");
    let checked = report::check(short(&name), &image, question);
    progress.finish_and_clear();
    let checked = checked?;
    let judged = filter.as_ref().map_or("none".to_owned(), |filter| filter.name());
    let fine = checked.shrinking.as_ref().and_then(|s| s.way(&judged)).is_none_or(|way| way.fine);
    let json = json(&name, &checked, tolerance, &judged, fine)?;
    Ok(Checked { report: checked.report, json, fine })
}

fn json(
    name: &str,
    checked: &report::Checked,
    tolerance: Tolerance,
    judged: &str,
    fine: bool,
) -> Result<Value, Failure> {
    let spectrum = &checked.spectrum;
    let even = spectrum.deviation() == 0.0;
    let mut bands = Vec::new();
    for fraction in Band::FRACTIONS {
        let band = Band::of(spectrum, fraction)?;
        bands.push(json!({ "fraction": fraction, "across": band.across, "down": band.down, "radial": band.radial,
            "square": band.square }));
    }
    let falls = [Fall::along(spectrum, 0), Fall::along(spectrum, 1), Fall::radial(spectrum)];
    let [across, down, radial] = falls.each_ref().map(|fall| fall.floor()[1]);
    let shrinking = checked.shrinking.as_ref().map(|shrinking| of_shrinking(shrinking, checked));
    Ok(json!({
        "file": name, "kind": "picture", "light": "linear", "unit": "cycles/pixel",
        "mean": spectrum.mean(), "deviation": spectrum.deviation(), "even": even, "blocks": spectrum.blocks(),
        "bands": bands,
        "floor": { "level": falls[2].floor()[0], "across": across, "down": down, "radial": radial },
        "enlarged": { "across": Fall::typical(spectrum, 0).cliff(), "down": Fall::typical(spectrum, 1).cliff() },
        "tolerance_db": tolerance.decibels(), "judged": judged, "fine": fine,
        "shrinking": shrinking,
    }))
}

fn of_shrinking(shrinking: &Shrinking, checked: &report::Checked) -> Value {
    let moire = |moire: &Moire| {
        let period = Some(moire.period()).filter(|_| !moire.even);
        json!({ "frequency": moire.frequency, "period": period, "angle": moire.angle(), "contrast": moire.contrast,
            "even": moire.even })
    };
    let gratings = shrinking.waves.strongest.iter().enumerate().map(|(i, wave)| {
        let found = checked.found.get(i).copied().unwrap_or_default();
        let cause = |which: usize, way: &str| {
            let predicted = shrinking.way(way)?.moires.get(i)?.contrast;
            Some(match found[which]?.cause(predicted, shrinking.tolerance.noticeable())? {
                Cause::Added => "more: texture lands there as well",
                Cause::Taken => "less: texture takes from it",
                Cause::Images => "ratio not whole",
            })
        };
        let [contrasts, alone] = [|f: Found| f.contrast, |f: Found| f.alone].map(|of: fn(Found) -> f64| {
            json!({ "none": found[0].map(of), checked.filter.as_str(): found[1].map(of) })
        });
        json!({ "frequency": wave.frequency, "period": wave.period(), "angle": wave.angle(), "contrast": wave.contrast(),
            "corner": wave.corner, "size": wave.size,
            "found": contrasts, "alone": alone,
            "differs": { "none": cause(0, "none"), checked.filter.as_str(): cause(1, &checked.filter) } })
    });
    let ways = shrinking.ways.iter().map(|way: &Way| {
        let ratio = Some(way.passed.ratio()).filter(|ratio| ratio.is_finite());
        json!({ "filter": way.name, "moires": way.moires.iter().map(moire).collect::<Vec<_>>(),
            "contrast": way.contrast(), "brightness": way.brightness(), "kept": way.passed.kept, "folded": way.passed.folded, "ratio_db": ratio,
            "fine": way.fine })
    });
    let textures = shrinking.textures.iter().map(|t| json!({ "frequency": t.frequency, "contrast": t.contrast }));
    json!({
        "size": shrinking.size, "limit": shrinking.limit,
        "gratings": gratings.collect::<Vec<_>>(), "more_gratings": shrinking.waves.others,
        "textures": textures.collect::<Vec<_>>(),
        "filters": ways.collect::<Vec<_>>(),
        "best": shrinking.best().map(|way| way.name.clone()), "blur": shrinking.blur,
    })
}
