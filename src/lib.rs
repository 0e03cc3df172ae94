//! Sampling and reconstruction, in numbers that can be checked.
//!
//! The crate is one square. Four nouns stand at its corners, and the arrows between them are the lecture that it
//! accompanies (A. Ignatenko, image synthesis, lecture 9, 2011):
//!
//! ```text
//!                  sample (× Ш)
//!   Signal  ───────────────────────▶  Samples        space / time
//!     │     ◀───────────────────────     │
//!     │           reconstruct (∗ r)      │
//!  Fourier                              DFT
//!     │                                  │
//!     ▼        replicate (∗ Ш), fold     ▼
//!  Spectrum ───────────────────────▶  Bins           frequency
//!           ◀───────────────────────
//!                low-pass (× Π)
//!  continuous                       discrete
//! ```
//!
//! Sampling is a product with the comb in space and a convolution with the comb in frequency; reconstruction is a
//! convolution with a kernel in space and a product with its response in frequency. The lecture is the statement that
//! the square commutes up to aliasing:
//!
//! ```
//! use nyquist::prelude::*;
//!
//! // A signal that is band-limited to B = 1, and its spectrum in closed form
//! let f = RaisedCosine::new(1.0)?;
//! assert_eq!(f.spectrum().band(), 1.0);
//!
//! // Round the square one way: sample at 2.5 > 2B, and transform …
//! let samples = Samples::of(&f, Axis::centered(0.4, 4001)?);
//! let bins = forward(&samples);
//! // … or the other way: transform, and replicate. The same numbers.
//! let copies = f.spectrum().replicated(2.5, 1)?;
//! let worst = bins.axis().iter().zip(bins.values()).map(|(nu, v)| (v - copies.density(nu)).norm());
//! assert!(worst.fold(0.0, f64::max) < 1e-7); // what lies beyond the record
//!
//! // And back: the ideal kernel returns the signal between the samples
//! let back = reconstruct(&samples, Ideal);
//! assert!((back.at(0.123) - f.at(0.123)).abs() < 1e-9);
//!
//! // Too slow, and a tone at 0.9 of the rate is indistinguishable from one at 0.1
//! assert!((fold(0.9, 1.0) - 0.1).abs() < 1e-15);
//! # Ok::<(), Error>(())
//! ```
//!
//! Two dimensions repeat it: a [`Field`](field::Field) is a signal of the plane, an [`Image`](image::Image) its samples,
//! [`ImageBins`](image::ImageBins) their transform, and sampling lattices take the place of the comb.
//!
//! # Conventions
//!
//! | matter | decision |
//! | --- | --- |
//! | transform | `F(ν) = ∫ f(x) e^{−2πiνx} dx`, ordinary frequency in cycles per unit, no factor in either direction |
//! | comb | `Ш_T(x) = T Σ δ(x − iT)`, so that its transform is `Σ δ(ν − i/T)` and the replicas have gain 1 |
//! | sinc | `sinc(t) = sin(πt)/(πt)` |
//! | reconstruction | `f̃(x) = Σ f(x_i) k((x − x_i)/T)`: kernels are written in units of the step, `r(x) = k(x/T)/T` |
//! | intervals | half-open; [`Axis::nodes`](axis::Axis::nodes) starts at the start, [`Axis::cells`](axis::Axis::cells) sits at the middles |
//! | order of bins | rising frequency, zero at index `n/2` (integer division) |
//! | at a jump | the mean of both sides (the box is ½ at its edge) |
//! | Nyquist | Nyquist frequency = rate/2, Nyquist rate = 2B; a rate must be *greater* than 2B where the spectrum has a line at B |
//! | images | linear light, rows one after another, positions as (x, y); sRGB is converted at the [door] |
//! | edges | [`Edge`](axis::Edge): zero, clamp, wrap, mirror |
//! | deltas | weights, never tall samples: a spectrum's lines are (position, weight) |
//! | randomness | a pure function of (seed, index, dimension) |
//!
//! # Laws
//!
//! A theorem is a function that returns what was measured beside what theory allows: a
//! [`Residual`](residual::Residual). Tests, figures and the command line call the same functions; [`laws`] has them,
//! and each is also run on an object that breaks it.
//!
//! # Features
//!
//! | feature | adds |
//! | --- | --- |
//! | none | the library: transforms, sampling, replication, kernels, reconstruction, laws, and figures as data |
//! | `plot` | figures drawn as SVG, PNG and PDF (plotters, and an embedded font: nothing of the system is used) |
//! | `files` | images from PNG and JPEG files, and to them |
//! | `threads` | films and large transforms on several threads; the bits are the same |
//! | `cli` (default) | the command `nyquist` |

pub mod antialias;
pub mod axis;
pub mod beyond;
pub mod comb;
#[cfg(feature = "plot")]
pub mod course;
pub mod door;
pub mod engine;
pub mod error;
pub mod exercise;
pub mod field;
pub mod figure;
pub mod film;
#[cfg(feature = "plot")]
pub mod gallery;
pub mod grid;
pub mod image;
pub mod inspect;
pub mod kernel;
pub mod laws;
pub mod num;
pub mod nyquist;
mod parallel;
pub mod pattern;
#[cfg(feature = "plot")]
pub mod plot;
pub mod rate;
pub mod reconstruct;
pub mod record;
pub mod residual;
pub mod resolve;
pub mod sampled;
pub mod scene;
pub mod signal;
pub mod spectrum;
pub mod text;

/// What users, notebooks and exercises import; nothing inside the library does.
pub mod prelude {
    pub use crate::antialias::adaptive::{Adapted, Budget, adaptive};
    pub use crate::antialias::prefilter::prefiltered;
    pub use crate::antialias::supersample::{Tap, supersample, weighted};
    pub use crate::axis::{Axis, Edge, Unit};
    pub use crate::beyond::{
        BandPass, DerivativeSamples, Interlaced, Irregular, Jitter, JitteredComb, Recovery, Refined, Weighted,
    };
    pub use crate::comb::Comb;
    pub use crate::door::picture::{Color, Picture};
    pub use crate::door::srgb::{linear_to_srgb, srgb_to_linear};
    pub use crate::door::table::{Reading, Table, TableWriter, read_table};
    pub use crate::door::wav::{Dither, Encoding, WavFormat, WavReader, WavWriter};
    #[cfg(feature = "files")]
    pub use crate::door::{Depth, Limits, png_bytes, read_picture};
    pub use crate::error::{Error, Result};
    pub use crate::field::added::Added;
    pub use crate::field::amplified::Amplified;
    pub use crate::field::bricks::BrickWall;
    pub use crate::field::checkerboard::Checkerboard;
    pub use crate::field::checks::Checks;
    pub use crate::field::disc::Disc;
    pub use crate::field::flat::Flat;
    pub use crate::field::glyphs::Glyphs;
    pub use crate::field::grating::Grating;
    pub use crate::field::half_plane::HalfPlane;
    pub use crate::field::line::ThinLine;
    pub use crate::field::moved::Moved;
    pub use crate::field::multiplied::{Multiplied, Separable};
    pub use crate::field::perspective::{Camera, Perspective};
    pub use crate::field::plaid::Plaid;
    pub use crate::field::polygon::ConvexPolygon;
    pub use crate::field::rotated::Rotated;
    pub use crate::field::spectrum::{PlaneImpulse, PlaneSpectrum};
    pub use crate::field::spot::GaussianSpot;
    pub use crate::field::star::SiemensStar;
    pub use crate::field::zone_plate::ZonePlate;
    pub use crate::field::zoomed::Zoomed;
    pub use crate::field::{ExactMean, Field, FourierField, from_fn as field_fn};
    pub use crate::film::{Exposure, Film, Sample};
    pub use crate::grid::Grid;
    pub use crate::image::dft::{forward as image_forward, inverse as image_inverse, power as image_power};
    pub use crate::image::filter::{Filter, Shape};
    pub use crate::image::lattice::Lattice;
    pub use crate::image::{Image, ImageBins, Rgb};
    pub use crate::kernel::box_kernel::BoxKernel;
    pub use crate::kernel::cubic::Cubic;
    pub use crate::kernel::gaussian::GaussianKernel;
    pub use crate::kernel::hamming::HammingKernel;
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
    pub use crate::pattern::Pattern;
    pub use crate::pattern::best_candidate::BestCandidate;
    pub use crate::pattern::blue_noise::BlueNoise;
    pub use crate::pattern::cells::Cells;
    pub use crate::pattern::grouped::Grouped;
    pub use crate::pattern::halton::Halton;
    pub use crate::pattern::hammersley::Hammersley;
    pub use crate::pattern::jittered::Jittered;
    pub use crate::pattern::measure::discrepancy::{star_discrepancy, star_discrepancy_line};
    pub use crate::pattern::measure::distance::{min_distance, min_distance_torus, most_distance};
    pub use crate::pattern::measure::elementary::net_quality;
    pub use crate::pattern::measure::periodogram::Periodogram;
    pub use crate::pattern::multi_jittered::MultiJittered;
    pub use crate::pattern::n_rooks::NRooks;
    pub use crate::pattern::padded::{Association, Padded};
    pub use crate::pattern::poisson_disk::PoissonDisk;
    pub use crate::pattern::random::Random;
    pub use crate::pattern::regular::Regular;
    pub use crate::pattern::scrambling::Scrambling;
    pub use crate::pattern::sobol::Sobol;
    pub use crate::pattern::zero_two::ZeroTwo;
    pub use crate::rate::{Converter, Quality, Response, convert};
    pub use crate::reconstruct::{Reconstruction, reconstruct};
    pub use crate::record::{Interpolated, Interpolator, Sampling, Wanted};
    pub use crate::residual::Residual;
    pub use crate::resolve::{Ends, Resolution, Resolved, resolve, resolve_up_to};
    pub use crate::sampled::convolution::{convolve, convolve_circular};
    pub use crate::sampled::dft::{forward, inverse};
    pub use crate::sampled::dtft::dtft;
    pub use crate::sampled::occupied::occupied_band;
    pub use crate::sampled::power::{periodogram, power};
    pub use crate::sampled::segments::{Detrend, Segments};
    pub use crate::sampled::welch::{Welch, welch};
    pub use crate::sampled::window::Window;
    pub use crate::sampled::{Bins, Samples};
    pub use crate::scene::camera::LensCamera;
    pub use crate::scene::chart::Chart;
    pub use crate::scene::lens::ThinLens;
    pub use crate::scene::render::render;
    pub use crate::scene::sphere::Sphere;
    pub use crate::scene::sun::Sun;
    pub use crate::scene::surface::Surface;
    pub use crate::scene::world::{Sky, World};
    pub use crate::scene::{Scene, ScenePoint};
    pub use crate::signal::boxcar::Boxcar;
    pub use crate::signal::chirp::Chirp;
    pub use crate::signal::constant::Constant;
    pub use crate::signal::decay::Decay;
    pub use crate::signal::gaussian::Gaussian;
    pub use crate::signal::lecture::{HighBump, LectureChirp, LecturePulse, LowBump};
    pub use crate::signal::raised_cosine::RaisedCosine;
    pub use crate::signal::series::{PartialSum, Wave};
    pub use crate::signal::sinc::{Sinc, SincSquared};
    pub use crate::signal::spline::Spline;
    pub use crate::signal::tent::Tent;
    pub use crate::signal::theorem::{Convolution, Derivative, Modulated, Product, Scaled, Shifted, Stretched, Sum};
    pub use crate::signal::tone::{Cosine, Sine};
    pub use crate::signal::trigonometric::TrigPolynomial;
    pub use crate::signal::{Differentiable, FourierPair, Signal, from_fn};
    pub use crate::spectrum::{Impulse, Spectrum};
    pub use crate::text::{Lang, Text};
}
