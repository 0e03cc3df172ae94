//! `nyquist resize`: a picture at another size.

use crate::cli::number::number;
use crate::cli::picture::{Most, filter, filters, open};
use crate::cli::source::Source;
use crate::cli::working::{note, spinner};
use crate::cli::{Failure, files, skipped};
use nyquist::axis::Edge;
use nyquist::door::carried::{Carried, Depth, Light, Opened, Space};
use nyquist::door::picture::{Color, Picture};
use nyquist::door::{Format, Limits, write_file};
use nyquist::image::Image;
use nyquist::image::resize::{nearest, over};
use nyquist::image::resizing::Resizing;
use nyquist::inspect::picture::blur::Blur;
use nyquist::kernel::{Kernel, catalog};
use serde_json::json;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Resize a picture, in linear light.
#[derive(Debug, clap::Args)]
#[command(after_help = after_help())]
pub(super) struct Args {
    /// The PNG or JPEG to read; `-` is standard input
    input: PathBuf,
    /// The PNG or JPEG to write, by its ending; `-` is a PNG on standard output
    output: PathBuf,
    /// The new width in pixels; the height follows if it is not given
    #[arg(short = 'W', long, value_name = "PIXELS")]
    width: Option<usize>,
    /// The new height in pixels; the width follows if it is not given
    #[arg(short = 'H', long, value_name = "PIXELS")]
    height: Option<usize>,
    /// The new size as a multiple of the old one
    #[arg(short, long, value_name = "S", value_parser = number, conflicts_with_all = ["width", "height"])]
    scale: Option<f64>,
    /// The kernel (names below), or none: every pixel takes the nearest one
    #[arg(short, long, default_value = "mitchell", value_name = "NAME")]
    filter: String,
    /// What lies beyond the border: mirror, clamp, wrap or zero (black)
    #[arg(long, default_value = "mirror")]
    edge: Edge,
    /// Blur first, by a Gaussian of this standard deviation in pixels of the input
    #[arg(long, value_name = "SIGMA", value_parser = number)]
    blur: Option<f64>,
    /// Average the codes instead of the light, as most programs do
    #[arg(long)]
    encoded: bool,
    /// Bits a channel of the output, 8 or 16; those of the input if not given
    #[arg(long, value_name = "BITS", value_parser = depth)]
    bits: Option<Depth>,
    /// The quality of a JPEG, from 1 to 100
    #[arg(long, default_value_t = 92, value_parser = clap::value_parser!(u8).range(1..=100))]
    quality: u8,
    #[command(flatten)]
    most: Most,
    /// Replace the output if it exists
    #[arg(long)]
    force: bool,
    /// Print what was done as JSON
    #[arg(long)]
    json: bool,
}

fn after_help() -> String {
    let filters: Vec<&str> = filters().collect();
    let mut lines = vec![String::new()];
    for name in filters {
        let line = lines.last_mut().expect("there is a first line");
        if line.len() + name.len() > 88 {
            lines.push(format!("{name}, "));
        } else {
            *line += &format!("{name}, ");
        }
    }
    let filters = lines.join("\n  ");
    format!(
        "Filters: {}\n  and families of them: {}.\n\
         Elsewhere tent is called bilinear or triangle, catmull-rom bicubic, lanczos-3 Lanczos.\n\n\
         When shrinking the kernel widens with the step, so that it filters what the new raster cannot hold;\n\
         pixel centres stay where they are (no shift by half a pixel), and a constant stays what it is.\n\
         Light is linear: codes are decoded by the curve of the file, which is sRGB's unless a gamma or the\n\
         tone curves of a colour profile say otherwise, and encoded again. Colours are weighed by their opacity.\n\
         Kept: bits, colour profile or gamma, density. What is left out is said on standard error.\n\n\
         Examples:\n  \
         nyquist resize photo.jpg small.png --width 800\n  \
         nyquist resize scan.png half.png --scale 0.5 --filter mitchell\n  \
         nyquist resize - - --scale 2 < icon.png > large.png",
        filters.trim_end_matches(", "),
        catalog::FAMILIES.join(", "),
    )
}

fn depth(text: &str) -> Result<Depth, String> {
    match text {
        "8" => Ok(Depth::Eight),
        "16" => Ok(Depth::Sixteen),
        _ => Err("8 or 16 bits can be written".into()),
    }
}

/// The size at a scale, at least one pixel and not more than is allowed.
pub(super) fn scaled(size: [usize; 2], scale: [f64; 2], limits: Limits) -> Result<[usize; 2], Failure> {
    let [w, h] = [0, 1].map(|i| (size[i] as f64 * scale[i]).round().max(1.0));
    allowed([w, h], limits)
}

fn allowed([w, h]: [f64; 2], limits: Limits) -> Result<[usize; 2], Failure> {
    if w * h > limits.pixels as f64 {
        let most = limits.pixels;
        let words = format!("{w} × {h} pixels would be more than the {most} allowed; --max-pixels allows more");
        return Err(Failure::Trouble(words));
    }
    Ok([w as usize, h as usize])
}

/// The size that was asked for; the side that was not keeps the shape.
fn size(args: &Args, old: [usize; 2]) -> Result<[usize; 2], Failure> {
    let limits = args.most.limits();
    let [w, h] = old.map(|n| n as f64);
    for (name, side) in [("--width", args.width), ("--height", args.height)] {
        if side == Some(0) {
            return Err(Failure::Trouble(format!("{name} 0: a picture has at least one pixel")));
        }
    }
    match (args.width.map(|n| n as f64), args.height.map(|n| n as f64), args.scale) {
        (None, None, None) => Err(Failure::Trouble("say the new size: --width, --height or --scale".into())),
        (None, None, Some(scale)) if scale.is_finite() && scale > 0.0 => scaled(old, [scale, scale], limits),
        (None, None, Some(scale)) => {
            Err(Failure::Trouble(format!("--scale must be greater than zero and finite, got {scale}")))
        }
        (Some(width), None, _) => allowed([width, (h * width / w).round().max(1.0)], limits),
        (None, Some(height), _) => allowed([(w * height / h).round().max(1.0), height], limits),
        (Some(width), Some(height), _) => allowed([width, height], limits),
    }
}

/// How a picture is resized.
struct Way {
    kernel: Option<Box<dyn Kernel>>,
    blur: Option<Blur>,
    edge: Edge,
}

impl Way {
    fn resized(&self, picture: &Picture, [width, height]: [usize; 2]) -> nyquist::error::Result<Picture> {
        let planned = |kernel| Resizing::new(picture.grid(), [width, height], kernel, self.edge);
        let resizing = self.kernel.as_deref().map(planned).transpose()?;
        picture.each(|plane| {
            let blurred: Option<Image> = self.blur.as_ref().map(|blur| blur.apply(plane, self.edge)).transpose()?;
            let plane = blurred.as_ref().unwrap_or(plane);
            match &resizing {
                Some(resizing) => resizing.apply(plane),
                None => Ok(nearest(plane, over(plane.grid(), width, height)?, self.edge)),
            }
        })
    }
}

pub(super) fn run(args: &Args, out: &mut impl Write) -> Result<(), Failure> {
    let piped = args.output == Path::new("-");
    if piped && args.json {
        return Err(Failure::Trouble("the output - and --json would mix picture and text on standard output".into()));
    }
    let format = format(args)?;
    if !piped {
        files::distinct(&args.input, &args.output)?;
        files::vacant(&args.output, args.force)?;
    }
    let kernel = filter(&args.filter)?;
    let way = Way { kernel, blur: args.blur.map(Blur::new).transpose()?, edge: args.edge };
    let light = if args.encoded { Light::Encoded } else { Light::Linear };
    let progress = spinner();
    progress.set_message("reading");
    let opened = open(Source::open(&args.input)?, args.most, light)?;
    let (grid, source) = (opened.picture.grid(), opened.carried.depth);
    let size = size(args, [grid.width(), grid.height()])?;
    progress.set_message("resizing");
    let resized = way.resized(&opened.picture, size)?;
    let clipped = clipped(&resized);
    let carried = Carried { depth: args.bits.unwrap_or(source), ..opened.carried.clone() };
    progress.set_message("writing");
    let bytes = write_file(&resized, &carried, format)?;
    progress.finish_and_clear();
    tell(&opened, &carried, format);
    if piped {
        return Ok(out.write_all(&bytes)?);
    }
    files::write(&args.output, &bytes)?;
    report(args, &opened, &Done { size, carried: &carried, format, clipped }, out)
}

fn format(args: &Args) -> Result<Format, Failure> {
    if args.output == Path::new("-") {
        return Ok(Format::Png);
    }
    match files::ending(&args.output).as_str() {
        "png" => Ok(Format::Png),
        "jpg" | "jpeg" => Ok(Format::Jpeg(args.quality)),
        _ => Err(Failure::trouble(args.output.display(), "a picture ends with .png, .jpg or .jpeg")),
    }
}

/// Above the rounding of weighted sums, some hundred ε; below the finest step of 16 bits, the first one of sRGB:
/// 1/(65535 · 12.92) = 1.2·10⁻⁶.
const ROUNDING: f64 = 1e-9;

/// How many values of colour lie beyond black or white, by more than a rounding.
fn clipped(picture: &Picture) -> usize {
    let beyond = |plane: &Image| plane.values().iter().filter(|v| !(-ROUNDING..=1.0 + ROUNDING).contains(*v)).count();
    match picture.color() {
        Color::Grey(grey) => beyond(grey),
        Color::Rgb(rgb) => rgb.planes().iter().map(beyond).sum(),
    }
}

/// What was left out, and what the format has no place for.
fn tell(opened: &Opened, carried: &Carried, format: Format) {
    for remark in &opened.remarks {
        note(remark);
    }
    skipped::tell(&opened.skipped, str::to_owned);
    if matches!(format, Format::Jpeg(_)) {
        if opened.picture.alpha().is_some() {
            note("JPEG has no opacity: the picture stands before white");
        }
        if carried.depth == Depth::Sixteen {
            note("JPEG has 8 bits a channel: 16 are rounded");
        }
        if matches!(carried.space, Space::Measured { .. } | Space::CodePoints(_)) {
            note(match carried.light {
                Light::Linear => "JPEG has no place for a gamma or code points: it is encoded as sRGB",
                Light::Encoded => "JPEG has no place for a gamma or code points: the codes will be taken for sRGB",
            });
        }
    }
}

/// What was done.
struct Done<'a> {
    size: [usize; 2],
    carried: &'a Carried,
    format: Format,
    clipped: usize,
}

fn report(args: &Args, opened: &Opened, done: &Done<'_>, out: &mut impl Write) -> Result<(), Failure> {
    let ([width, height], path) = (done.size, args.output.display().to_string());
    let depth = if done.format == Format::Png { done.carried.depth } else { Depth::Eight };
    let (bits, filter) = (depth.bits(), &args.filter);
    let grey = matches!(opened.picture.color(), Color::Grey(_));
    let alpha = opened.picture.alpha().is_some() && done.format == Format::Png;
    let grid = opened.picture.grid();
    if args.json {
        let value = json!({
            "input": { "file": args.input.display().to_string(), "width": grid.width(), "height": grid.height(),
                "bits": opened.carried.depth.bits() },
            "output": { "file": path, "width": width, "height": height, "bits": bits, "grey": grey, "alpha": alpha },
            "filter": filter, "blur": args.blur, "light": if args.encoded { "encoded" } else { "linear" },
            "clipped": done.clipped, "remarks": opened.remarks, "skipped": skipped::json(&opened.skipped),
        });
        return Ok(writeln!(out, "{value:#}")?);
    }
    let color = match (grey, alpha) {
        (true, false) => "grey",
        (true, true) => "grey with opacity",
        (false, false) => "colour",
        (false, true) => "colour with opacity",
    };
    let light = if args.encoded { "codes averaged" } else { "in linear light" };
    let clipped = match done.clipped {
        0 => String::new(),
        n => {
            let planes = if grey { 1 } else { 3 };
            let part = 100.0 * n as f64 / (planes * width * height) as f64;
            format!("; {part:.1} % of the values, beyond black or white, clipped")
        }
    };
    Ok(writeln!(out, "{path}: {width} × {height}, {bits}-bit {color}, {filter} {light}{clipped}")?)
}
