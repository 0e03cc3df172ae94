//! The box: nearest neighbour, sample and hold.
//!
//! | | |
//! | --- | --- |
//! | formula | `k(t) = 1` for `\|t\| < ½`, `½` at the edge, `0` beyond |
//! | response | `K(ν) = sinc(ν)` |
//! | parameters | none |
//! | use it | as the model of a display pixel, a sensor pixel, a digital-to-analogue converter that holds; for data without an order |
//! | artefacts | blocks: the first image of a tone at `f` keeps `f/(1−f)` of its amplitude, and the pass band sags by 3.9 dB at Nyquist |
//! | source | slides «Преобразования Фурье для некоторых функций», «Примеры работы фильтров» |

use crate::kernel::{Claims, Kernel};
use crate::num::sinc;
use crate::signal::Signal;
use crate::spectrum::low_pass;

/// The box of width one step; see the [page](self).
///
/// ```
/// use nyquist::prelude::*;
/// assert_eq!([0.0, 0.49, 0.5, 0.51].map(|t| BoxKernel.at(t)), [1.0, 1.0, 0.5, 0.0]);
/// assert_eq!(BoxKernel.response(0.5), 2.0 / std::f64::consts::PI); // −3.92 dB at Nyquist
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct BoxKernel;

impl Signal for BoxKernel {
    fn at(&self, t: f64) -> f64 {
        if t.is_nan() { t } else { low_pass(t, 0.5) }
    }
}

impl Kernel for BoxKernel {
    fn name(&self) -> String {
        "box".into()
    }
    fn radius(&self) -> f64 {
        0.5
    }
    fn claims(&self) -> Claims {
        Claims {
            interpolating: true,
            unit_gain: true,
            reproduces_constants: true,
            reproduces_lines: false,
            nonnegative: true,
        }
    }
    fn response(&self, nu: f64) -> f64 {
        sinc(nu)
    }
}
