//! What is told on standard error while work is done: words, and signs of life on a terminal.

use indicatif::{ProgressBar, ProgressStyle};
use std::io::{self, IsTerminal, Write};
use std::time::Duration;

/// A word on standard error; if that is closed there is nobody to tell.
pub(super) fn note(words: &str) {
    let _ = writeln!(io::stderr(), "note: {words}");
}

/// How far of so many steps; of nobody knows how many, how many `what` so far.
pub(super) fn progress(steps: Option<u64>, what: &str) -> ProgressBar {
    match steps {
        Some(steps) => shown(ProgressBar::new(steps), "{wide_bar} {percent} % {eta}"),
        None => shown(ProgressBar::no_length(), &format!("{{spinner}} {{human_pos}} {what}")),
    }
}

/// Something that turns while work is done that cannot say how far it is; its message says what.
pub(super) fn spinner() -> ProgressBar {
    let spinner = shown(ProgressBar::new_spinner(), "{spinner} {msg} {elapsed}");
    spinner.enable_steady_tick(Duration::from_millis(100));
    spinner
}

/// A [`spinner`] around work.
pub(super) fn working<T>(what: &'static str, work: impl FnOnce() -> T) -> T {
    let spinner = spinner().with_message(what);
    let done = work();
    spinner.finish_and_clear();
    done
}

fn shown(bar: ProgressBar, template: &str) -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    match ProgressStyle::with_template(template) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
