//! `nyquist figures`: the main job.

use crate::cli::{Failure, files};
use indicatif::{ProgressBar, ProgressStyle};
use nyquist::error::Error;
use nyquist::figure::{Entry, Figure, catalog};
use nyquist::gallery::{self, File, Options, Rendered, html, index, markdown};
use nyquist::plot::{Format, Theme};
use nyquist::text::Lang;
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::io::{ErrorKind, IsTerminal, Write};
use std::path::{Path, PathBuf};

/// Compute figures, check their claims, write them as SVG, PNG and PDF.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  nyquist figures f28-leak --set T=0.9 --lang ru --format png
  nyquist figures --theme dark --out slides
  nyquist figures --list --json")]
pub(super) struct Args {
    /// Figures by id (f28-leak) or by the lecture's inventory (F28); all if none is given
    ids: Vec<String>,
    /// The folder to write into
    #[arg(long, default_value = "figures", value_name = "DIR")]
    out: PathBuf,
    /// File formats: svg, png, pdf; with png, figures in motion are also written as ID.apng
    #[arg(long, value_delimiter = ',', default_value = "svg,png,pdf")]
    format: Vec<Format>,
    /// Languages of the labels: en, ru
    #[arg(long, value_delimiter = ',', default_value = "en,ru")]
    lang: Vec<Lang>,
    /// Colours: light or dark
    #[arg(long, default_value = "light")]
    theme: Theme,
    /// Leave out the title above the picture
    #[arg(long)]
    no_title: bool,
    /// Give a parameter of the named figures another value; the files are called ID@NAME=VALUE
    #[arg(long, value_name = "NAME=VALUE", value_parser = assignment)]
    set: Vec<(String, String)>,
    /// Also write every layer as CSV and JSON into DIR/data
    #[arg(long)]
    data: bool,
    /// How many figures to compute at once; as many as there are processors if not given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    jobs: Option<u16>,
    /// List the figures instead of writing them
    #[arg(long)]
    list: bool,
    /// With --list: as JSON, with captions, panels and measured claims
    #[arg(long, requires = "list")]
    json: bool,
    /// Compare the SVGs, the animations and the index in DIR with what is computed instead of writing: exit code 1 if any differs
    #[arg(long, conflicts_with_all = ["list", "set", "data"])]
    check: bool,
}

fn assignment(given: &str) -> Result<(String, String), Error> {
    let split = given.split_once('=').filter(|(name, _)| !name.is_empty());
    let (name, value) =
        split.ok_or_else(|| Error::Unreadable { what: "--set".into(), given: given.into(), wanted: "NAME=VALUE" })?;
    Ok((name.into(), value.into()))
}

pub(super) fn run(args: &Args, out: &mut impl Write) -> Result<(), Failure> {
    let entries: Vec<&'static Entry> = if args.ids.is_empty() {
        catalog::all()
    } else {
        let named = args.ids.iter().map(|name| catalog::matching(name)).collect::<Result<Vec<_>, _>>()?;
        let mut seen = BTreeSet::new();
        named.concat().into_iter().filter(|entry| seen.insert(entry.id)).collect()
    };
    if !args.set.is_empty() && args.ids.is_empty() {
        return Err(Failure::Trouble(
            "--set needs the figure that it is meant for, as in: f28-leak --set T=0.9".into(),
        ));
    }
    if args.list && !args.json {
        for entry in entries {
            writeln!(out, "{:<24} {:<12} {}", entry.id, entry.inventory.join(","), entry.title.get(args.lang[0]))?;
        }
        return Ok(());
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(args.jobs.map_or(0, usize::from));
    let pool = pool.build().map_err(|error| Failure::trouble("cannot start threads", error))?;
    if args.list {
        let nothing = Options { formats: Vec::new(), motion: false, ..Options::default() };
        let computed = pool.install(|| compute(&entries, &args.set, &nothing, &ProgressBar::hidden()))?;
        write!(out, "{}", index::json(pairs(&computed)))?;
        return Ok(());
    }
    let options = Options {
        formats: if args.check { vec![Format::Svg] } else { args.format.clone() },
        langs: args.lang.clone(),
        theme: args.theme,
        title: !args.no_title,
        data: args.data,
        motion: args.check || args.format.contains(&Format::Png),
    };
    let progress = progress(entries.len());
    let computed = pool.install(|| compute(&entries, &args.set, &options, &progress))?;
    progress.finish_and_clear();
    let mut files: Vec<File> = computed.iter().flat_map(|r| r.files.iter().cloned()).collect();
    // the index shows the SVGs of both languages, so it belongs to a run that has made them
    let whole = args.ids.is_empty();
    let shown = args.theme == Theme::Light && Lang::ALL.iter().all(|lang| args.lang.contains(lang));
    if whole && shown && options.formats.contains(&Format::Svg) {
        files.extend(index_files(&computed));
    }
    let failed = report(&computed);
    if args.check {
        let folders = args.lang.iter().map(|&lang| gallery::folder(lang, args.theme));
        check(&args.out, &files, if whole { folders.collect() } else { Vec::new() })?;
    } else {
        for file in &files {
            files::write(&args.out.join(&file.path), &file.bytes)?;
        }
        let panels: usize = computed.iter().map(|r| r.figure.panels.len()).sum();
        let claims: usize = computed.iter().map(|r| r.figure.claims.len()).sum();
        say(&format!(
            "{} figures, {panels} panels, {claims} claims, {failed} failed; {} files in {}",
            computed.len(),
            files.len(),
            args.out.display()
        ));
    }
    if failed == 0 { Ok(()) } else { Err(Failure::Check) }
}

fn pairs(computed: &[Rendered]) -> impl Iterator<Item = (&Entry, &Figure)> {
    computed.iter().map(|r| (r.entry, &r.figure))
}

/// In parallel, in the order of the entries; the first error in that order ends it.
fn compute(
    entries: &[&'static Entry],
    set: &[(String, String)],
    options: &Options,
    progress: &ProgressBar,
) -> Result<Vec<Rendered>, Failure> {
    let rendered = entries.par_iter().map(|entry| {
        let rendered = gallery::render(entry, set, options)
            .map_err(|error| Failure::trouble(format!("figure {}", entry.id), error));
        if let (Ok(Rendered { figure, .. }), false, false) = (&rendered, options.formats.is_empty(), watched()) {
            say(&format!("{:<24} {} panels, {} claims", entry.id, figure.panels.len(), figure.claims.len()));
        }
        progress.set_message(entry.id);
        progress.inc(1);
        rendered
    });
    rendered.collect::<Vec<_>>().into_iter().collect()
}

fn index_files(computed: &[Rendered]) -> Vec<File> {
    let file = |name: &str, text: String| File { path: name.into(), bytes: text.into_bytes() };
    vec![
        file("index.json", index::json(pairs(computed))),
        file("INDEX.md", markdown::markdown(pairs(computed))),
        file("index.html", html::html(pairs(computed))),
    ]
}

/// A line for every failed claim; how many failed.
fn report(computed: &[Rendered]) -> usize {
    let mut failed = 0;
    for Rendered { entry, figure, .. } in computed {
        for claim in figure.claims.iter().filter(|c| !c.residual.holds()) {
            let r = &claim.residual;
            say(&format!("✗ {}: {}: measured {:e}, allowed {:e}", entry.id, r.law, r.measured, r.bound));
            failed += 1;
        }
    }
    failed
}

fn is_animation(path: &Path) -> bool {
    path.extension().is_some_and(|e| e == "apng")
}

/// Every file must be there with the same bytes (an animation: if it is there), and no other SVG or animation may lie about in the given folders.
fn check(out: &Path, files: &[File], folders: Vec<PathBuf>) -> Result<(), Failure> {
    let mut stale = Vec::new();
    for file in files {
        match std::fs::read(out.join(&file.path)) {
            Ok(bytes) if bytes == file.bytes => {}
            Ok(_) => stale.push(format!("{} differs", file.path.display())),
            // an animation is there only where pixels were asked for
            Err(error) if is_animation(&file.path) && error.kind() == ErrorKind::NotFound => {}
            Err(error) => stale.push(format!("{}: {error}", file.path.display())),
        }
    }
    let known: BTreeSet<&Path> = files.iter().map(|f| f.path.as_path()).collect();
    for folder in folders {
        let Ok(found) = std::fs::read_dir(out.join(&folder)) else { continue };
        for name in found.flatten().map(|f| f.file_name()) {
            let path = folder.join(&name);
            let variant = name.to_string_lossy().contains('@');
            if path.extension().is_some_and(|e| e == "svg" || e == "apng")
                && !variant
                && !known.contains(path.as_path())
            {
                stale.push(format!("{} belongs to no figure", path.display()));
            }
        }
    }
    for line in &stale {
        say(line);
    }
    if stale.is_empty() {
        say(&format!("{} files are fresh", files.len()));
        Ok(())
    } else {
        Err(Failure::Check)
    }
}

/// A line for the person at the terminal. If standard error is closed there is nobody to tell.
fn say(line: &str) {
    let _ = writeln!(std::io::stderr(), "{line}");
}

/// Whether somebody watches a bar; otherwise a line is written for every figure as it is done.
fn watched() -> bool {
    std::io::stderr().is_terminal()
}

fn progress(len: usize) -> ProgressBar {
    if !watched() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}").expect("the template is well formed");
    ProgressBar::new(len as u64).with_style(style)
}
