//! What notebooks and exercises show: pictures, and laws as *measured · allowed*, where the code stands.
//!
//! In a notebook (the evcxr kernel, or while the notebooks are derived) a picture is displayed under its cell; elsewhere
//! its title is printed. Numbers are printed so that they are the same on every processor.

use crate::error::{Error, Result};
use crate::figure::params::Params;
use crate::figure::{Figure, catalog};
use crate::gallery::index::settled;
use crate::laws;
use crate::plot::{Style, draw};
use crate::residual::Residual;
use crate::text;
use crate::text::{Lang, Text, number, plain, raised};
use std::io::{self, Write};

/// How many lines of a law are printed: it may be proved on dozens of examples.
const LINES: usize = 6;

/// How large a picture in a notebook is laid out: half a slide, with letters of a slide's proportions.
const SIZE: (u32, u32) = (1120, 630);
/// How large it is shown: Jupyter does not shrink a picture that is wider than its column of text.
const SHOWN: (u32, u32) = (880, 495);

/// Shows a figure of the lecture, by its id or its entry in the inventory, with some of its parameters set.
///
/// ```
/// use nyquist::course::show;
/// use nyquist::text::Lang;
/// show(Lang::En, "f28-leak", &[("T", "0.9")])?;
/// assert!(show(Lang::En, "f99-nothing", &[]).is_err());
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// An unknown figure or parameter, a value out of range, a claim of the figure that does not hold.
pub fn show(lang: Lang, id: &str, set: &[(&str, &str)]) -> Result<()> {
    let entry = catalog::by_name(id)?;
    let figure = (entry.build)(&Params::with(entry.params, set.iter().copied())?)?;
    display(lang, entry.title, &figure)
}

/// Shows a figure made in the notebook.
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::course::display;
/// use nyquist::figure::{Figure, Layer, Meaning, Panel, Scale};
/// use nyquist::text;
/// let (x, y) = (Scale::linear(text!("x", "x"), -1.0, 1.0), Scale::linear(text!("f", "f"), -1.0, 1.0));
/// let panel = Panel::new("cubic", Text::EMPTY, x, y).with(Layer::curve("cubic", Meaning::Signal, -1.0, 1.0, 200, |x| x * x * x));
/// display(Lang::En, &text!("x cubed", "куб x"), &Figure::new(1).with(panel))?;
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// [`Error::Broken`] for a claim of the figure that does not hold.
pub fn display(lang: Lang, title: &Text, figure: &Figure) -> Result<()> {
    if notebook() {
        let scene = draw(title, &Text::EMPTY, figure, &Style { lang, size: SIZE, ..Style::default() });
        let size = |(width, height)| format!("width=\"{width}\" height=\"{height}\"");
        let svg = scene.svg().replacen(&size(SIZE), &size(SHOWN), 1);
        say(&format!("EVCXR_BEGIN_CONTENT image/svg+xml\n{}\nEVCXR_END_CONTENT", svg.trim_end()));
    } else {
        say(&format!("[{}]", plain(title.get(lang))));
    }
    figure.claims.iter().try_for_each(|claim| checked(&claim.residual))
}

/// Prints what was measured beside what is allowed, line by line.
///
/// ```
/// use nyquist::course::prove;
/// use nyquist::residual::Residual;
/// prove([Residual::near("sin(π/6) = 1/2", (std::f64::consts::PI / 6.0).sin(), 0.5, f64::EPSILON)])?;
/// assert!(prove([Residual::at_most("one is nothing", 1.0, 0.0)]).is_err());
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Broken`] where more was measured than is allowed; all lines are printed before.
pub fn prove(residuals: impl IntoIterator<Item = Residual>) -> Result<()> {
    let residuals: Vec<Residual> = residuals.into_iter().collect();
    residuals.iter().for_each(|residual| say(&line(residual)));
    residuals.iter().try_for_each(checked)
}

/// States a law of the catalogue, by its name or the result of the inventory, and proves it on its examples; the first few
/// are printed, all if one of them fails.
///
/// ```
/// nyquist::course::law(nyquist::text::Lang::En, "V28")?;
/// # Ok::<(), nyquist::error::Error>(())
/// ```
///
/// # Errors
/// An unknown law; [`Error::Broken`].
pub fn law(lang: Lang, name: &str) -> Result<()> {
    for law in laws::catalog::matching(name)? {
        say(&plain(law.says.get(lang)));
        let mut shown = (law.holds)();
        if !shown.iter().all(Residual::holds) {
            return prove(shown);
        }
        let silent = shown.split_off(LINES.min(shown.len())).len();
        prove(shown)?;
        if silent > 0 {
            say(text!("  … and so on, {} more", "  … и так далее, ещё {}", silent).get(lang));
        }
    }
    Ok(())
}

/// Marks the beginning of a cell, for whoever derives notebooks from their output.
#[doc(hidden)]
pub fn cell(index: usize) {
    say(&format!("\u{1e}{index}"));
}

/// Whether somebody collects what is displayed: evcxr says so in this variable.
fn notebook() -> bool {
    std::env::var_os("EVCXR_IS_RUNTIME").is_some()
}

fn line(residual: &Residual) -> String {
    let shown = |value: f64| raised(&number(settled(value), 3));
    let mark = if residual.holds() { '✓' } else { '✗' };
    // where rounding is allowed, whether it came out as nothing or as the last bit depends on the processor
    let least = if residual.bound > 0.0 { f64::MIN_POSITIVE } else { 0.0 };
    let measured = if residual.measured == 0.0 { least } else { residual.measured };
    let (measured, allowed) = (shown(measured), shown(residual.bound));
    format!("{mark} {measured:>10} · {allowed:<10} {}", residual.law)
}

fn checked(residual: &Residual) -> Result<()> {
    if residual.holds() {
        return Ok(());
    }
    let Residual { law, measured, bound } = residual.clone();
    Err(Error::Broken { law: law.into_owned(), measured, bound })
}

/// If nobody reads, there is nobody to tell.
fn say(text: &str) {
    let _ = writeln!(io::stdout(), "{text}");
}
