//! A figure in motion.

use crate::figure::Figure;

/// What a still picture cannot show: figures one after another, repeated for ever.
///
/// ```
/// use nyquist::figure::catalog::by_name;
/// // the wheel's still stands for itself; its motion is data of the same figure
/// let figure = by_name("f03-strobing")?.figure()?;
/// let motion = figure.motion.expect("the wheel turns");
/// assert!(motion.frames.len() <= 90 && motion.seconds() < 5.0);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// The frames, in their order. Their own claims are not looked at: what is claimed of a motion stands in the figure
    /// that it belongs to.
    pub frames: Vec<Figure>,
    /// How many frames are shown in a second.
    pub rate: u16,
}

impl Motion {
    /// How long it lasts until it begins again.
    pub fn seconds(&self) -> f64 {
        self.frames.len() as f64 / f64::from(self.rate)
    }
}
