//! The sinc's main lobe under Hamming's window: a tent that keeps more of the pass band, for the price of a tent.
//!
//! | | |
//! | --- | --- |
//! | formula | `k(t) = sinc(t)·(0.54 + 0.46·cos πt)` for `\|t\| < 1` |
//! | response | `0.54·R(ν) + 0.23·[R(ν−½) + R(ν+½)]`, `R(ν) = [Si(2πν+π) − Si(2πν−π)]/π` that of the bare main lobe |
//! | parameters | none |
//! | use it | to shrink images at the cost of the tent, a little sharper, without ringing |
//! | artefacts | kinks at the samples; **not of unit gain**, `∫k = 0.844`, and a constant ripples by 31 %, unless the weights are divided by their sum, as resizing does |
//! | source | Hamming's window after Harris 1978; as a filter for images in Pillow, under this name |

use crate::kernel::windowed;
use crate::kernel::{Claims, Kernel};
use crate::num::cos_pi;
use crate::num::special::si;
use crate::signal::Signal;
use std::f64::consts::PI;

/// The Hamming-windowed main lobe of the sinc; see the [page](self).
///
/// ```
/// use nyquist::prelude::*;
/// assert_eq!([0.0, 1.0, 1.5].map(|t| HammingKernel.at(t)), [1.0, 0.0, 0.0]);
/// assert!((HammingKernel.at(0.5) - 0.54 * 2.0 / std::f64::consts::PI).abs() < 1e-15);
/// // less is lost just below Nyquist than with the tent, and less is let through far above
/// let passed = |kernel: &dyn Kernel| [0.25, 1.5].map(|nu| kernel.response(nu).abs() / kernel.response(0.0));
/// let (hamming, tent) = (passed(&HammingKernel), passed(&TentKernel));
/// assert!(hamming[0] > tent[0] && hamming[1] < tent[1]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct HammingKernel;

impl Signal for HammingKernel {
    fn at(&self, t: f64) -> f64 {
        windowed::value(t, 1.0, |t| 0.54 + 0.46 * cos_pi(t))
    }
}

impl Kernel for HammingKernel {
    fn name(&self) -> String {
        "hamming".into()
    }
    fn radius(&self) -> f64 {
        1.0
    }
    fn claims(&self) -> Claims {
        Claims { nonnegative: true, ..windowed::CLAIMS }
    }
    /// Absolute error below `64ε·(1 + |ν|)`.
    fn response(&self, nu: f64) -> f64 {
        if nu.is_infinite() {
            return 0.0;
        }
        let lobe = |nu: f64| (si(2.0 * PI * nu + PI) - si(2.0 * PI * nu - PI)) / PI;
        let nu = nu.abs();
        0.54 * lobe(nu) + 0.23 * (lobe(nu - 0.5) + lobe(nu + 0.5))
    }
}
