//! Units of frequencies and of spectra.

/// The unit of frequencies over positions in `unit`: Hz and its multiples where that is one of time.
///
/// ```
/// use nyquist::inspect::table::units::frequency;
/// assert_eq!(frequency("s"), "Hz");
/// assert_eq!(frequency("ms"), "kHz");
/// assert_eq!((frequency("mm").as_str(), frequency("").as_str()), ("1/mm", ""));
/// ```
pub fn frequency(unit: &str) -> String {
    match unit {
        "" => String::new(),
        "s" | "sec" | "second" | "seconds" => "Hz".into(),
        "ms" | "msec" => "kHz".into(),
        "us" | "µs" | "μs" => "MHz".into(),
        "ns" => "GHz".into(),
        other => format!("1/{other}"),
    }
}

/// The unit of a power density: the square of that of the values, per unit of frequency.
///
/// ```
/// use nyquist::inspect::table::units::density;
/// assert_eq!(density("V", "s"), "V²/Hz");
/// assert_eq!((density("", "s").as_str(), density("m/s", "").as_str()), ("1/Hz", "(m/s)²"));
/// ```
pub fn density(values: &str, positions: &str) -> String {
    let simple = values.chars().all(|c| c.is_alphanumeric() || c == '°' || c == '%');
    let square = match values {
        "" => String::new(),
        _ if simple => format!("{values}²"),
        _ => format!("({values})²"),
    };
    match (square.as_str(), frequency(positions).as_str()) {
        (_, "") => square,
        ("", frequency) if !frequency.contains('/') => format!("1/{frequency}"),
        ("", _) => positions.to_owned(),
        (square, frequency) if frequency.contains('/') => format!("{square}·{}", &frequency[2..]),
        (square, frequency) => format!("{square}/{frequency}"),
    }
}
