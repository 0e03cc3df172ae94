//! What is in measured data: how much band it fills, what would alias at another rate, and where to.

pub mod picture;
pub mod sound;
pub mod table;
