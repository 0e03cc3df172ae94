//! One adaptor per theorem of the Fourier transform: what is done to a signal, and what that does to its spectrum.
//!
//! | adaptor | signal | spectrum |
//! | --- | --- | --- |
//! | [`Scaled`] (linearity) | `c·f(x)` | `c·F(ν)` |
//! | [`Sum`] (linearity) | `f + g` | `F + G` |
//! | [`Shifted`] | `f(x − x₀)` | `e^{−2πiνx₀}·F(ν)` |
//! | [`Stretched`] (similarity) | `f(x/c)` | `c·F(cν)` |
//! | [`Modulated`] | `f(x)·cos(2πν₀x)` | `½F(ν − ν₀) + ½F(ν + ν₀)` |
//! | [`Product`] | `f·g` | `F ⊗ G` |
//! | [`Convolution`] | `f ⊗ g` | `F·G` |
//! | [`Derivative`] | `f′` | `2πiν·F(ν)` |

mod convolution;
mod derivative;
mod modulated;
mod product;
mod scaled;
mod shifted;
mod stretched;
mod sum;

pub use convolution::Convolution;
pub use derivative::Derivative;
pub use modulated::Modulated;
pub use product::Product;
pub use scaled::Scaled;
pub use shifted::Shifted;
pub use stretched::Stretched;
pub use sum::Sum;
