//! What is in a picture, and what shrinking makes of it.
//!
//! Everything is in linear light, since lenses, sensors and eyes add light, and so do filters; frequencies are in cycles a
//! pixel, `u` across and `v` down, and angles are seen as on a screen: counter-clockwise from rightwards.

pub mod band;
pub mod blur;
pub mod found;
mod patch;
pub mod power;
pub mod sampler;
pub mod shrinking;
pub mod texture;
pub mod wave;
pub mod waves;

/// The direction of a frequency as seen on a screen, where `v` points down: from 0° (it changes across, its stripes stand
/// upright) to 90° (it changes upwards) and below 180°.
///
/// ```
/// use nyquist::inspect::picture::angle;
/// assert_eq!([[0.1, 0.0], [0.0, 0.1], [0.1, -0.1], [-0.1, 0.0]].map(angle), [0.0, 90.0, 45.0, 0.0]);
/// ```
pub fn angle([u, v]: [f64; 2]) -> f64 {
    let degrees = (-v).atan2(u).to_degrees().rem_euclid(180.0);
    // the remainder of a tiny negative angle rounds to the whole; and zero has no sign
    if degrees == 180.0 || degrees == 0.0 { 0.0 } else { degrees }
}
