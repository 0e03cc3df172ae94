//! `nyquist kernel`: what the kernels are worth.

use crate::cli::Failure;
use nyquist::kernel::Kernel;
use nyquist::kernel::catalog;
use nyquist::signal::Signal;
use std::io::Write;

/// List the reconstruction kernels, or tabulate one and its response.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:
  nyquist kernel mitchell > mitchell.csv")]
pub(super) struct Args {
    /// The kernel to tabulate as CSV (t, value, frequency, response); a list of all if none is given
    name: Option<String>,
    /// How many rows the table has
    #[arg(long, default_value_t = 256, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    rows: u32,
}

pub(super) fn run(args: &Args, out: &mut impl Write) -> Result<(), Failure> {
    let Some(name) = &args.name else {
        writeln!(out, "{:<16} {:>6}  claims", "name", "radius")?;
        for kernel in catalog::all() {
            let claims = kernel.claims();
            let words = [
                (claims.interpolating, "interpolating"),
                (claims.unit_gain, "unit gain"),
                (claims.reproduces_constants, "constants"),
                (claims.reproduces_lines, "lines"),
                (claims.nonnegative, "nonnegative"),
            ];
            let words: Vec<&str> = words.iter().filter(|w| w.0).map(|w| w.1).collect();
            writeln!(out, "{:<16} {:>6}  {}", kernel.name(), kernel.radius(), words.join(", "))?;
        }
        return Ok(());
    };
    let kernel = catalog::by_name(name)?;
    let reach = if kernel.radius().is_finite() { kernel.radius() } else { 8.0 };
    writeln!(out, "t,value,frequency,response")?;
    for i in 0..=args.rows {
        let part = f64::from(i) / f64::from(args.rows);
        let (t, nu) = (reach * part, 4.0 * part);
        writeln!(out, "{t},{},{nu},{}", kernel.at(t), kernel.response(nu))?;
    }
    Ok(())
}
