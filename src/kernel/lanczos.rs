//! Lanczos: the sinc under the main lobe of a wider sinc.
//!
//! | | |
//! | --- | --- |
//! | formula | `k(t) = sinc(t)·sinc(t/a)` for `\|t\| < a` |
//! | response | `(a/2π²)·[h(p₊+q) + h(p₊−q) − h(p₋+q) − h(p₋−q)]`, `p± = π(1±1/a)`, `q = 2πν`, `h(p) = p·Si(pa) − (1 − cos pa)/a` |
//! | parameters | the number of lobes `a` to either side |
//! | use it | to resize images sharply (2 or 3 lobes); as a compact stand-in for the ideal kernel |
//! | artefacts | rings at edges: a step overshoots by 11.8 % with three lobes; **not of unit gain**, `∫k = 0.997` for `a = 3`, so that a constant ripples by 0.6 % unless the weights are divided by their sum |
//! | source | Duchon, *Lanczos filtering in one and two dimensions*, 1979; Turkowski, *Filters for common resampling tasks*, Graphics Gems 1990 |

use crate::error::{Result, within};
use crate::kernel::windowed;
use crate::kernel::{Claims, Kernel, MOST_RADIUS};
use crate::num::sinc;
use crate::num::special::si;
use crate::signal::Signal;
use std::f64::consts::PI;

/// A Lanczos kernel; see the [page](self).
///
/// ```
/// use nyquist::prelude::*;
/// let lanczos = Lanczos::new(3.0)?;
/// assert_eq!((lanczos.at(0.0), lanczos.at(1.0), lanczos.at(2.0)), (1.0, 0.0, 0.0));
/// assert!((lanczos.response(0.0) - 0.997055).abs() < 1e-6); // taken for one more often than not
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lanczos {
    lobes: f64,
}

impl Lanczos {
    /// `lobes` lobes to either side, usually 2, 3 or 4; fractions are allowed.
    ///
    /// # Errors
    /// A number of lobes that is not finite or outside `1..=4096`.
    pub fn new(lobes: f64) -> Result<Self> {
        Ok(Self { lobes: within("the lobes of a Lanczos kernel", lobes, 1.0, MOST_RADIUS)? })
    }

    /// The number of lobes to either side, which is the radius.
    pub fn lobes(&self) -> f64 {
        self.lobes
    }
}

impl Signal for Lanczos {
    fn at(&self, t: f64) -> f64 {
        windowed::value(t, self.lobes, |t| sinc(t / self.lobes))
    }
}

impl Kernel for Lanczos {
    fn name(&self) -> String {
        format!("lanczos-{}", self.lobes)
    }
    fn radius(&self) -> f64 {
        self.lobes
    }
    fn claims(&self) -> Claims {
        windowed::CLAIMS
    }
    /// Absolute error below `64ε·(1 + |ν|·a)`.
    fn response(&self, nu: f64) -> f64 {
        if nu.is_infinite() {
            return 0.0;
        }
        let a = self.lobes;
        // ∫₀ᵃ (1 − cos pt)/t² dt, by parts
        let h = |p: f64| p * si(p * a) - (1.0 - (p * a).cos()) / a;
        let (low, high, q) = (PI * (1.0 - 1.0 / a), PI * (1.0 + 1.0 / a), 2.0 * PI * nu.abs());
        a / (2.0 * PI * PI) * (h(high + q) + h(high - q) - h(low + q) - h(low - q))
    }
}
