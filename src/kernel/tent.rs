//! The tent: linear interpolation.
//!
//! | | |
//! | --- | --- |
//! | formula | `k(t) = max(0, 1 − \|t\|)`, the box convolved with itself |
//! | response | `K(ν) = sinc²(ν)` |
//! | parameters | none; the lecture's `max(0, 1 − \|x\|)` is right for `T = 1` only (E06): [`Widened`](crate::kernel::widened::Widened) shows what it does elsewhere |
//! | use it | where speed counts and ringing is forbidden; the error is at most `T²/8·max\|f″\|` |
//! | artefacts | kinks at the samples; a pass band that sags by 7.8 dB at Nyquist |
//! | source | slide «Реконструированная функция» (Pharr & Humphreys, figure 7.5) |

use crate::kernel::{Claims, Kernel};
use crate::num::sinc;
use crate::signal::Signal;

/// The tent of radius one step; see the [page](self).
///
/// ```
/// use nyquist::prelude::*;
/// let samples = Samples::new(Axis::new(0.0, 0.5, 3)?, vec![0.0, 2.0, 1.0])?;
/// assert_eq!(reconstruct(&samples, TentKernel).at(0.75), 1.5); // half-way between 2 and 1
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct TentKernel;

impl Signal for TentKernel {
    fn at(&self, t: f64) -> f64 {
        if t.abs() >= 1.0 { 0.0 } else { 1.0 - t.abs() }
    }
}

impl Kernel for TentKernel {
    fn name(&self) -> String {
        "tent".into()
    }
    fn radius(&self) -> f64 {
        1.0
    }
    fn claims(&self) -> Claims {
        Claims {
            interpolating: true,
            unit_gain: true,
            reproduces_constants: true,
            reproduces_lines: true,
            nonnegative: true,
        }
    }
    fn response(&self, nu: f64) -> f64 {
        sinc(nu) * sinc(nu)
    }
}
