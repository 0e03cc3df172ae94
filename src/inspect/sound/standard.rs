//! The rates that sound is kept at.

/// Sampling rates of devices and formats in Hz, rising.
pub const STANDARD_RATES: [u32; 16] = [
    8_000, 11_025, 12_000, 16_000, 22_050, 24_000, 32_000, 44_100, 48_000, 64_000, 88_200, 96_000, 176_400, 192_000,
    352_800, 384_000,
];

/// The least of the [`STANDARD_RATES`] for which `fits` says yes.
///
/// ```
/// use nyquist::inspect::sound::smallest_standard;
/// assert_eq!(smallest_standard(|rate| rate > 2.0 * 9_000.0), Some(22_050));
/// assert_eq!(smallest_standard(|rate| rate > 1e6), None);
/// ```
pub fn smallest_standard(fits: impl Fn(f64) -> bool) -> Option<u32> {
    STANDARD_RATES.into_iter().find(|rate| fits(f64::from(*rate)))
}
