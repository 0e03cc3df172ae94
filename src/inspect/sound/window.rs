//! The window of all spectra here: Kaiser's.

use std::f64::consts::PI;

/// Its parameter: side lobes are 188 dB down.
pub const BETA: f64 = 24.0;

/// How many bins a line is wide to either side: `√(1 + (β/π)²)`.
pub(super) fn width() -> f64 {
    (1.0 + (BETA / PI).powi(2)).sqrt()
}

/// The same in whole bins.
pub(super) fn reach() -> usize {
    width().ceil() as usize
}

/// The transform of the window within its main lobe, `delta` bins from its middle: one there.
pub(super) fn lobe(delta: f64) -> f64 {
    let root = (BETA * BETA - PI * PI * delta * delta).max(0.0).sqrt();
    let height = if root < 1e-8 { 1.0 } else { root.sinh() / root };
    height * BETA / BETA.sinh()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::{cos_pi, sin_pi};
    use crate::sampled::window::Window;

    #[test]
    fn the_lobe_is_the_transform_of_the_window() {
        let weights = Window::Kaiser(BETA).values(512);
        let sum: f64 = weights.iter().sum();
        for delta in [0.0, 0.3, 1.0, 2.5, 5.0, 7.0] {
            let part = |wave: fn(f64) -> f64| -> f64 {
                let turn = |j: usize| 2.0 * delta * j as f64 / 512.0;
                weights.iter().enumerate().map(|(j, w)| w * wave(turn(j))).sum()
            };
            let found = part(cos_pi).hypot(part(sin_pi)) / sum;
            // the window jumps by 1/I₀(β) = 5·10⁻¹⁰ at its ends, where the sum takes one value and not two halves
            assert!((found - lobe(delta)).abs() < 1e-11, "{delta}: {found} ≠ {}", lobe(delta));
        }
    }
}
