//! A brick wall.

use crate::error::{Result, finite, positive, within};
use crate::field::{ExactMean, Field, rectangle};

/// Bricks in running bond: courses of equal height, every second one shifted by half a brick, mortar between.
///
/// Axis-parallel edges at two scales: what a box filter gets right and a point sample turns into beats (the scene of
/// slide «Примеры работы фильтров»). Its mean is exact: the courses of either kind are a pulse train across times a pulse
/// train down, and each has a closed primitive; rounding leaves `8ε·(pitch/Δ)`.
///
/// ```
/// use nyquist::prelude::*;
/// let wall = BrickWall::new([4.0, 2.0], 0.5, [0.8, 0.2])?; // 4 by 2 with its mortar
/// assert_eq!([wall.at(1.0, 1.0), wall.at(3.75, 1.0), wall.at(1.75, 3.0)], [0.8, 0.2, 0.2]);
/// let whole = wall.mean([0.0, 4.0], [0.0, 4.0]);
/// assert!((whole - (0.2 + 0.6 * (3.5 * 1.5) / 8.0)).abs() < 1e-15); // bricks cover 3.5 × 1.5 of 4 × 2
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BrickWall {
    pitch: [f64; 2],
    mortar: f64,
    brick: f64,
    joint: f64,
}

impl BrickWall {
    /// `pitch` is width and height of a brick together with its joint, `levels` are the values of brick and mortar.
    ///
    /// # Errors
    /// A pitch that is not positive and finite, mortar that is negative or leaves no brick, levels that are not finite.
    pub fn new(pitch: [f64; 2], mortar: f64, levels: [f64; 2]) -> Result<Self> {
        for side in pitch {
            positive("the pitch of a brick wall", side)?;
        }
        within("the mortar of a brick wall", mortar, 0.0, pitch[0].min(pitch[1]))?;
        positive("what the mortar leaves of a brick", pitch[0].min(pitch[1]) - mortar)?;
        for level in levels {
            finite("a level of a brick wall", level)?;
        }
        Ok(Self { pitch, mortar, brick: levels[0], joint: levels[1] })
    }

    /// The trains of pulses of both kinds of courses: (period, pulse, start) across and down.
    fn courses(&self) -> [[Train; 2]; 2] {
        let ([w, h], m) = (self.pitch, self.mortar);
        let across = |start: f64| Train { period: w, pulse: w - m, start };
        let down = |start: f64| Train { period: 2.0 * h, pulse: h - m, start };
        [[across(0.0), down(0.0)], [across(0.5 * w), down(h)]]
    }

    fn value(&self, brick: f64) -> f64 {
        self.joint + (self.brick - self.joint) * brick
    }
}

/// Pulses of height one, `pulse` long, every `period`, one of them from `start` on.
#[derive(Clone, Copy)]
struct Train {
    period: f64,
    pulse: f64,
    start: f64,
}

impl Train {
    fn at(&self, t: f64) -> f64 {
        let rest = (t - self.start).rem_euclid(self.period);
        // without joints the pulses touch, and nothing is between them
        if (rest == 0.0 || rest == self.pulse) && self.pulse < self.period {
            0.5
        } else if rest <= self.pulse {
            1.0
        } else {
            0.0
        }
    }

    fn mean(&self, [a, b]: [f64; 2]) -> f64 {
        // counted from the start of the period that `a` lies in, so that nothing large cancels
        let base = self.start + self.period * ((a - self.start) / self.period).floor();
        let primitive = |t: f64| {
            let whole = (t / self.period).floor();
            whole * self.pulse + (t - whole * self.period).min(self.pulse)
        };
        (primitive(b - base) - primitive(a - base)) / (b - a)
    }
}

impl Field for BrickWall {
    fn at(&self, x: f64, y: f64) -> f64 {
        self.value(self.courses().iter().map(|[across, down]| across.at(x) * down.at(y)).sum())
    }
}

impl ExactMean for BrickWall {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        match rectangle(x, y) {
            Ok([x, y]) => self.value(self.courses().iter().map(|[across, down]| across.mean(x) * down.mean(y)).sum()),
            Err([x, y]) => self.at(x, y),
        }
    }
}
