//! Sampling and reconstruction.

pub mod axis;
pub mod beyond;
pub mod comb;
pub mod error;
pub mod figure;
pub mod kernel;
pub mod laws;
pub mod num;
pub mod nyquist;
#[cfg(feature = "plot")]
pub mod plot;
pub mod reconstruct;
pub mod residual;
pub mod resolve;
pub mod sampled;
pub mod signal;
pub mod spectrum;
pub mod text;

/// What users, notebooks and exercises import; nothing inside the library does.
pub mod prelude {
    pub use crate::axis::{Axis, Edge, Unit};
    pub use crate::beyond::{
        BandPass, DerivativeSamples, Interlaced, Irregular, Jitter, JitteredComb, Recovery, Refined, TrigPolynomial,
    };
    pub use crate::comb::Comb;
    pub use crate::error::{Error, Result};
    pub use crate::kernel::box_kernel::BoxKernel;
    pub use crate::kernel::cubic::Cubic;
    pub use crate::kernel::gaussian::GaussianKernel;
    pub use crate::kernel::ideal::Ideal;
    pub use crate::kernel::kaiser::Kaiser;
    pub use crate::kernel::lanczos::Lanczos;
    pub use crate::kernel::pbrt_sinc::PbrtSinc;
    pub use crate::kernel::regularised::Regularised;
    pub use crate::kernel::tent::TentKernel;
    pub use crate::kernel::widened::Widened;
    pub use crate::kernel::{Claims, Kernel};
    pub use crate::nyquist::{
        Alias, Landing, Verdict, bandpass_rates, fold, landings, nyquist_frequency, nyquist_rate,
    };
    pub use crate::reconstruct::{Reconstruction, reconstruct};
    pub use crate::residual::Residual;
    pub use crate::resolve::{Ends, Resolution, Resolved, resolve, resolve_up_to};
    pub use crate::sampled::convolution::{convolve, convolve_circular};
    pub use crate::sampled::dft::{forward, inverse};
    pub use crate::sampled::dtft::dtft;
    pub use crate::sampled::power::{periodogram, power};
    pub use crate::sampled::window::Window;
    pub use crate::sampled::{Bins, Samples};
    pub use crate::signal::boxcar::Boxcar;
    pub use crate::signal::chirp::Chirp;
    pub use crate::signal::constant::Constant;
    pub use crate::signal::decay::Decay;
    pub use crate::signal::gaussian::Gaussian;
    pub use crate::signal::lecture::{HighBump, LectureChirp, LecturePulse, LowBump};
    pub use crate::signal::raised_cosine::RaisedCosine;
    pub use crate::signal::series::{PartialSum, Wave};
    pub use crate::signal::sinc::{Sinc, SincSquared};
    pub use crate::signal::tent::Tent;
    pub use crate::signal::theorem::{Convolution, Derivative, Modulated, Product, Scaled, Shifted, Stretched, Sum};
    pub use crate::signal::tone::{Cosine, Sine};
    pub use crate::signal::{Differentiable, FourierPair, Signal, from_fn};
    pub use crate::spectrum::{Impulse, Spectrum};
    pub use crate::text::{Lang, Text};
}
