//! The curve of sRGB.

/// Linear light of an sRGB value, both from 0 to 1: `v/12.92` up to 0.04045, `((v + 0.055)/1.055)^2.4` above (IEC
/// 61966-2-1:1999). Odd, so that values outside the range survive.
///
/// The middle of the bytes is not the middle of the light: a checkerboard of black and white pixels has the mean ½ in
/// linear light, which is written 188 and not 128.
///
/// ```
/// use nyquist::prelude::*;
/// assert_eq!((linear_to_srgb(0.5) * 255.0).round(), 188.0);
/// // every code of 8 and of 16 bits comes back
/// for most in [255u32, 65535] {
///     let back = |code: u32| (linear_to_srgb(srgb_to_linear(f64::from(code) / f64::from(most))) * f64::from(most)).round();
///     assert!((0..=most).all(|code| back(code) == f64::from(code)));
/// }
/// ```
pub fn srgb_to_linear(v: f64) -> f64 {
    let size = v.abs();
    if size <= 0.04045 { v / 12.92 } else { ((size + 0.055) / 1.055).powf(2.4).copysign(v) }
}

/// The sRGB value of linear light, both from 0 to 1: `12.92·v` up to 0.0031308, `1.055·v^{1/2.4} − 0.055` above. Odd.
///
/// The inverse of [`srgb_to_linear`] to `4·10⁻⁸`, the gap that the rounded constants of the standard leave where the two
/// pieces meet, and to rounding elsewhere: every code of 8 and of 16 bits survives the way there and back.
pub fn linear_to_srgb(v: f64) -> f64 {
    let size = v.abs();
    if size <= 0.003_130_8 { v * 12.92 } else { (1.055 * size.powf(1.0 / 2.4) - 0.055).copysign(v) }
}
