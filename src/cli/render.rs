//! `nyquist render`: a scene, sampled in five dimensions, into a PNG.

use crate::cli::{Failure, files};
use indicatif::{ProgressBar, ProgressStyle};
use nyquist::door::picture::Picture;
use nyquist::door::{Depth, png_bytes};
use nyquist::kernel::{Kernel, catalog as kernels};
use nyquist::pattern::{Pattern, grouped};
use nyquist::scene::catalog::{self, Entry};
use nyquist::scene::render::render_watched;
use nyquist::text::Lang;
use std::io::{IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Render a scene through lens and shutter into a PNG.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  nyquist render spheres -o spheres.png
  nyquist render defocus -o noisy.png --spp 16 --pattern random
  nyquist render zone-plate -o rings.png --spp 1 --pattern regular --filter box
  nyquist render --list")]
pub(super) struct Args {
    /// The scene; --list has them all
    #[arg(required_unless_present = "list")]
    scene: Option<String>,
    /// The PNG to write; `-` is standard output
    #[arg(short, long, value_name = "OUT.png", required_unless_present = "list")]
    out: Option<PathBuf>,
    /// Pixels in a row
    #[arg(long, default_value_t = 480, value_name = "PIXELS")]
    width: usize,
    /// Rows
    #[arg(long, default_value_t = 320, value_name = "PIXELS")]
    height: usize,
    /// Samples a pixel
    #[arg(long, default_value_t = 16, value_name = "N")]
    spp: usize,
    /// Where the samples are: padded (image, time and lens in strata), random, regular, sobol-owen, …
    #[arg(long, default_value = "padded")]
    pattern: String,
    /// The kernel that weighs the samples around a pixel: box, tent, gaussian, mitchell, lanczos-3, …
    #[arg(long, default_value = "mitchell", value_name = "KERNEL")]
    filter: String,
    /// The seed of everything random: the same seed, the same bytes
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// The language of the list: en, ru
    #[arg(long, default_value = "en")]
    lang: Lang,
    /// How many threads to use; as many as there are processors if not given. The picture is the same
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
    /// List scenes, patterns and filters instead of rendering
    #[arg(long)]
    list: bool,
    /// Report as JSON
    #[arg(long)]
    json: bool,
    /// Replace the file if it is there
    #[arg(long)]
    force: bool,
}

pub(super) fn run(args: &Args, out: &mut impl Write) -> Result<(), Failure> {
    let (Some(scene), Some(file), false) = (&args.scene, &args.out, args.list) else {
        return list(args, out);
    };
    let entry = catalog::by_name(scene)?;
    let pattern = grouped::by_name(&args.pattern, args.spp)?;
    let kernel = kernels::by_name(&args.filter)?;
    let to_output = file == Path::new("-");
    if to_output && args.json {
        return Err(Failure::Trouble("-o - and --json would mix picture and report on standard output".into()));
    }
    if !to_output {
        if file.extension().is_none_or(|e| !e.eq_ignore_ascii_case("png")) {
            return Err(Failure::Trouble(format!(
                "{} does not end with .png, and PNG is what is written",
                file.display()
            )));
        }
        files::vacant(file, args.force)?;
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(args.threads.map_or(0, usize::from));
    let pool = pool.build().map_err(|error| Failure::trouble("cannot start threads", error))?;
    let started = Instant::now();
    let progress = progress(args.height);
    let picture = pool.install(|| {
        let size = [args.width, args.height];
        render_watched(&*entry.scene(), size, &pattern, &kernel, args.seed, || progress.inc(1))
    });
    progress.finish_and_clear();
    let bytes = png_bytes(&Picture::from(picture?), Depth::Eight)?;
    let time = started.elapsed();
    if to_output {
        return Ok(out.write_all(&bytes)?);
    }
    files::write(file, &bytes)?;
    report(args, &Done { entry, pattern: &pattern, kernel: &kernel, file, time }, out)
}

/// What has been rendered, and how.
struct Done<'a> {
    entry: &'a Entry,
    pattern: &'a dyn Pattern<5>,
    kernel: &'a dyn Kernel,
    file: &'a Path,
    time: Duration,
}

fn report(args: &Args, done: &Done<'_>, out: &mut impl Write) -> Result<(), Failure> {
    let seconds = done.time.as_secs_f64();
    let spp = done.pattern.count();
    if args.json {
        let report = serde_json::json!({
            "scene": done.entry.name,
            "file": done.file.display().to_string(),
            "width": args.width,
            "height": args.height,
            "spp": spp,
            "pattern": done.pattern.name(),
            "filter": done.kernel.name(),
            "seed": args.seed,
            "seconds": (seconds * 1e3).round() / 1e3,
        });
        writeln!(out, "{report:#}")?;
    } else {
        // a pattern whose number of points depends on the seed has about as many as asked for
        let spp = spp.map_or_else(|| format!("about {}", args.spp), |n| n.to_string());
        let (width, height) = (args.width, args.height);
        let (name, kernel) = (done.pattern.name(), done.kernel.name());
        let file = done.file.display();
        writeln!(out, "{file}: {width} × {height}, {spp} samples a pixel ({name}, {kernel}), {seconds:.2} s")?;
    }
    Ok(())
}

fn list(args: &Args, out: &mut impl Write) -> Result<(), Failure> {
    let filters: Vec<&str> = kernels::names().filter(|name| finite(name)).collect();
    let patterns: Vec<&str> = grouped::names().collect();
    if args.json {
        let scene = |e: &Entry| {
            let about = Lang::ALL.map(|lang| (lang.code().to_owned(), e.about.get(lang).into()));
            serde_json::json!({ "name": e.name, "about": about.into_iter().collect::<serde_json::Map<_, _>>() })
        };
        let scenes: Vec<_> = catalog::all().iter().map(scene).collect();
        let all = serde_json::json!({ "scenes": scenes, "patterns": patterns, "filters": filters });
        writeln!(out, "{all:#}")?;
        return Ok(());
    }
    for entry in catalog::all() {
        writeln!(out, "{:<14} {}", entry.name, entry.about.get(args.lang))?;
    }
    let words = match args.lang {
        Lang::En => ["patterns", "filters"],
        Lang::Ru => ["наборы отсчётов", "фильтры"],
    };
    writeln!(out, "\n{}: {}", words[0], patterns.join(", "))?;
    writeln!(out, "{}: {}", words[1], filters.join(", "))?;
    Ok(())
}

/// Whether a film can use that kernel.
fn finite(name: &str) -> bool {
    kernels::by_name(name).is_ok_and(|kernel| kernel.radius().is_finite())
}

fn progress(rows: usize) -> ProgressBar {
    if !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:40} {percent} % {eta}").expect("the template is well formed");
    ProgressBar::new(rows as u64).with_style(style)
}
