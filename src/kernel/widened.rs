//! A kernel made wider or narrower, with its area kept.
//!
//! | | |
//! | --- | --- |
//! | formula | `k_c(t) = k(t/c)/c` |
//! | response | `K_c(ν) = K(cν)` |
//! | parameters | the kernel and the factor `c` |
//! | use it | as the prefilter before the rate is lowered `c` times; to see what a filter that is not scaled with the step does: the lecture's tent `max(0, 1−\|x\|)` at step `T` is the tent stretched `1/T` times (E06) |
//! | artefacts | no longer interpolating; constants stay reproduced for whole `c` only |
//! | source | the similarity theorem (Bracewell, *The Fourier transform and its applications*); slide «Реконструированная функция» |

use crate::error::{Result, within};
use crate::kernel::{Claims, Kernel, MOST_RADIUS};
use crate::signal::Signal;

/// `k(t/c)/c`; see the [page](self).
///
/// ```
/// use nyquist::prelude::*;
/// let wide = Widened::new(TentKernel, 2.0)?;
/// assert_eq!((wide.at(0.0), wide.at(1.0), wide.radius()), (0.5, 0.25, 2.0));
/// assert_eq!(wide.response(0.0), 1.0); // the area is kept
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Widened<K> {
    kernel: K,
    factor: f64,
}

impl<K: Kernel> Widened<K> {
    /// `kernel`, `factor` times as wide.
    ///
    /// # Errors
    /// A factor that is not finite or outside `1/4096..=4096`.
    pub fn new(kernel: K, factor: f64) -> Result<Self> {
        within("the factor of a widened kernel", factor, 1.0 / MOST_RADIUS, MOST_RADIUS)?;
        Ok(Self { kernel, factor })
    }

    /// How many times wider than the kernel.
    pub fn factor(&self) -> f64 {
        self.factor
    }
}

impl<K: Kernel> Signal for Widened<K> {
    fn at(&self, t: f64) -> f64 {
        self.kernel.at(t / self.factor) / self.factor
    }
}

impl<K: Kernel> Kernel for Widened<K> {
    fn name(&self) -> String {
        format!("{}*{}", self.kernel.name(), self.factor)
    }
    fn radius(&self) -> f64 {
        self.kernel.radius() * self.factor
    }
    /// What follows from the kernel's claims: constants and lines need `K` flat at the nonzero integers (Strang & Fix
    /// 1971), and the multiples of a whole factor are among them.
    fn claims(&self) -> Claims {
        let of = self.kernel.claims();
        let whole = self.factor.fract() == 0.0;
        Claims {
            interpolating: of.interpolating && self.factor == 1.0,
            reproduces_constants: of.reproduces_constants && whole,
            reproduces_lines: of.reproduces_lines && whole,
            ..of
        }
    }
    fn response(&self, nu: f64) -> f64 {
        self.kernel.response(nu * self.factor)
    }
}
