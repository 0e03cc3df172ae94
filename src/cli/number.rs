//! Numbers as they are written on a command line.

/// A number.
pub(super) fn number(text: &str) -> Result<f64, String> {
    text.trim().parse().map_err(|_| format!("\"{text}\" is no number"))
}

/// A number, or a quotient of two.
pub(super) fn quotient(text: &str) -> Result<f64, String> {
    match text.split_once('/') {
        Some((above, below)) => Ok(number(above)? / number(below)?),
        None => number(text),
    }
}
