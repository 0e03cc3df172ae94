//! The `sinc` filter of pbrt-2: a Lanczos kernel, stretched.
//!
//! | | |
//! | --- | --- |
//! | formula | `k(t) = (τ/w)·sinc(t/w)·sinc(τt/w)` for `\|t\| < w` |
//! | response | that of Lanczos with `τ` lobes, at the frequency `νw/τ` |
//! | parameters | the width `w` (which is the radius), and the number of lobes `τ`; by default 4 and 3 |
//! | use it | to compare with pictures rendered by that program |
//! | artefacts | smoother than the textbook's Lanczos-3: it cuts off at `τ/2w = 0.375` cycles per sample and leaves 0.05 of a tone at Nyquist; a step overshoots by 9.6 % |
//! | source | pbrt-2 `filters/sinc.h`, which evaluates `sinc(x/w)·sinc(τx/w)`: the default is Lanczos-3 stretched by 4/3, without the factor `τ/w` |

use crate::error::Result;
use crate::kernel::lanczos::Lanczos;
use crate::kernel::widened::Widened;
use crate::kernel::{Claims, Kernel};
use crate::signal::Signal;

/// The `sinc` of pbrt-2, of the gain of its Lanczos kernel; see the [page](self).
///
/// ```
/// use nyquist::prelude::*;
/// let pbrt = PbrtSinc::new(4.0, 3.0)?;
/// let as_printed = |x: f64| nyquist::num::sinc(x / 4.0) * nyquist::num::sinc(3.0 * x / 4.0);
/// assert!((pbrt.at(1.0) / pbrt.at(0.0) - as_printed(1.0)).abs() < 1e-15);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PbrtSinc {
    width: f64,
    tau: f64,
    lanczos: Widened<Lanczos>,
}

impl PbrtSinc {
    /// Width `w` and lobes `τ`, as the scene file has them.
    ///
    /// # Errors
    /// As [`Lanczos::new`] for `τ` and [`Widened::new`] for `w/τ`.
    pub fn new(width: f64, tau: f64) -> Result<Self> {
        let lanczos = Widened::new(Lanczos::new(tau)?, width / tau)?;
        Ok(Self { width, tau, lanczos })
    }
}

impl Signal for PbrtSinc {
    fn at(&self, t: f64) -> f64 {
        self.lanczos.at(t)
    }
}

impl Kernel for PbrtSinc {
    fn name(&self) -> String {
        match (self.width, self.tau) {
            (4.0, 3.0) => "sinc-pbrt2".into(),
            (width, tau) => format!("sinc-pbrt2:{width},{tau}"),
        }
    }
    fn radius(&self) -> f64 {
        self.width
    }
    fn claims(&self) -> Claims {
        self.lanczos.claims()
    }
    fn response(&self, nu: f64) -> f64 {
        self.lanczos.response(nu)
    }
}
