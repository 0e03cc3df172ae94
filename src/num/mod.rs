//! The ground floor: numbers that the field needs and the standard library lacks.

pub mod erf;
pub mod extremum;
pub mod faddeeva;
pub mod fresnel;
pub mod isoline;
pub mod mean;
pub mod quadrature;
pub mod random;
pub(crate) mod scale;
mod sinc;
pub mod special;
pub mod svd;

pub use sinc::{cos_pi, sin_pi, sinc, sinc_slope};
