//! `nyquist spectrum`: the spectrum of a file, as a picture or as numbers.

mod picture;
mod sound;
mod table;

use crate::cli::given::Given;
use crate::cli::source::Source;
use crate::cli::table::Frequencies;
use crate::cli::{Failure, files};
use nyquist::door::kind::Kind;
use nyquist::door::table::{Dialect, Heading, Separator, TableWriter};
use nyquist::figure::Portrait;
use nyquist::figure::report::Quantity;
use nyquist::plot::{Format, Style, Theme, draw};
use nyquist::sampled::window::Window;
use nyquist::text::Lang;
use serde_json::Value;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Compute the spectrum of a file: as a picture, as CSV or as JSON.
#[derive(Debug, clap::Args)]
#[command(after_help = sound::HELP)]
pub(super) struct Args {
    /// A WAV, PNG, JPEG or CSV file, told apart by its first bytes; `-` is standard input
    input: PathBuf,
    /// What to write: a picture (.svg, .png, .pdf) or numbers (.csv, .json); `-` is CSV on standard output
    #[arg(short = 'o', long = "out", value_name = "OUT")]
    out: PathBuf,
    /// What of each frequency: amplitude, or density (mean square per unit of frequency)
    #[arg(long, default_value = "amplitude", help_heading = "Sound and tables")]
    quantity: Quantity,
    /// The window: rectangular, hann, hamming, blackman, blackman-harris, flat-top, gaussian:SIGMA or kaiser:BETA
    #[arg(long, default_value = "hann", help_heading = "Sound and tables")]
    window: Window,
    /// The language of the picture: en or ru
    #[arg(long, default_value = "en")]
    lang: Lang,
    /// The colours of the picture: light or dark
    #[arg(long, default_value = "light")]
    theme: Theme,
    /// Replace the output if it exists
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    sound: sound::Options,
    #[command(flatten)]
    picture: picture::Options,
    #[command(flatten)]
    table: Frequencies,
}

/// A spectrum in all the forms that it can be written in.
struct Computed {
    portrait: Portrait,
    /// The names of the columns, with their units, and the rows.
    columns: Vec<Heading>,
    rows: Vec<Vec<f64>>,
    json: Value,
}

/// What is written.
enum Form {
    Picture(Format),
    Csv,
    Json,
}

pub(super) fn run(args: &Args, given: &Given, out: &mut impl Write) -> Result<(), Failure> {
    let form = form(&args.out)?;
    let piped = args.out == Path::new("-");
    if !piped {
        files::distinct(&args.input, &args.out)?;
        files::vacant(&args.out, args.force)?;
    }
    let (source, kind) = Source::open_any(&args.input)?;
    given.fit(&source.name, kind)?;
    let computed = match kind {
        Kind::Sound => sound::spectrum(source, args),
        Kind::Picture => picture::spectrum(source, args),
        Kind::Table => table::spectrum(source, args),
    }?;
    let bytes = match form {
        Form::Picture(format) => {
            let Portrait { title, caption, figure } = &computed.portrait;
            let style = Style { lang: args.lang, theme: args.theme, ..Style::default() };
            draw(title, caption, figure, &style).write(format)
        }
        Form::Csv => csv(&computed).into_bytes(),
        Form::Json => format!("{:#}\n", computed.json).into_bytes(),
    };
    if piped { Ok(out.write_all(&bytes)?) } else { files::write(&args.out, &bytes) }
}

fn form(path: &Path) -> Result<Form, Failure> {
    let ending = files::ending(path);
    match (ending.as_str(), ending.parse()) {
        _ if path == Path::new("-") => Ok(Form::Csv),
        ("csv", _) => Ok(Form::Csv),
        ("json", _) => Ok(Form::Json),
        (_, Ok(format)) => Ok(Form::Picture(format)),
        _ => Err(Failure::trouble(path.display(), "a spectrum ends with .svg, .png, .pdf, .csv or .json")),
    }
}

/// A line for each row; every number is the shortest that reads back as the same.
fn csv(computed: &Computed) -> String {
    let mut writer = TableWriter::new(Dialect { separator: Separator::Comma, decimal_comma: false });
    writer.header(&computed.columns);
    computed.rows.iter().for_each(|row| writer.row(None, row));
    writer.take()
}
