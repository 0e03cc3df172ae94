//! What a conversion promises, in numbers.

use crate::error::{Error, Result, unknown};
use crate::rate::design::LowPass;
use std::fmt;
use std::str::FromStr;

/// How clean a conversion is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Quality {
    /// 100 dB: below the noise of 16 bits. The shortest filter, which rings the least.
    Fast,
    /// 150 dB: below the noise of 24 bits.
    High,
    /// 200 dB: below what 32 bits tell apart.
    Best,
}

/// What the filter is better than its promise, in dB: the windows cut it at its stop-band's first ripple, and signals have
/// more than one component.
const MARGIN: f64 = 8.0;

/// The numbers behind a [`Quality`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Promise {
    /// The end of the pass-band as a fraction of the lower of both Nyquist frequencies.
    pub pass: f64,
    /// The most by which the gain within the pass-band differs from 1, in dB.
    pub ripple: f64,
    /// By how many dB is weakened at least what would alias or image: all that lies beyond the lower Nyquist frequency.
    pub rejection: f64,
}

impl Quality {
    /// All of them, the cheapest first.
    pub const ALL: [Self; 3] = [Self::Fast, Self::High, Self::Best];

    /// What it promises.
    ///
    /// ```
    /// use nyquist::rate::Quality;
    /// assert!(Quality::Best.promise().rejection >= 200.0 && Quality::Best.promise().pass >= 0.99);
    /// ```
    pub const fn promise(self) -> Promise {
        match self {
            Self::Fast => Promise { pass: 0.91, ripple: 1e-4, rejection: 100.0 },
            Self::High => Promise { pass: 0.96, ripple: 3e-7, rejection: 150.0 },
            Self::Best => Promise { pass: 0.99, ripple: 1e-9, rejection: 200.0 },
        }
    }

    /// The filter that keeps the promise, where the lower of both Nyquist frequencies is `nyquist` cycles a step, and a tone
    /// there is made so many times as strong by something else.
    pub(super) fn low_pass(self, nyquist: f64, stronger: f64) -> LowPass {
        let promise = self.promise();
        LowPass::new(promise.pass * nyquist, nyquist, promise.rejection + MARGIN + 20.0 * stronger.log10())
    }

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Fast => "fast",
            Self::High => "high",
            Self::Best => "best",
        }
    }
}

impl fmt::Display for Quality {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Quality {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self> {
        let found = Self::ALL.into_iter().find(|q| q.name() == name);
        found.ok_or_else(|| unknown("quality", name, Self::ALL.map(Self::name)))
    }
}
