//! Looking into data: what band do they fill, and what would alias, and where to, at another rate.

pub mod sound;
