//! The resizing engine: images of any number of interleaved channels, of `f32`, `f64`, bytes and words of 16 bits, and of
//! bytes by the light that they stand for, planned once and used by any number of threads.
//!
//! A resizing is two sums, `Σ_y w_y Σ_x w_x f(x, y)`, whose weights [`Taps`] hold; those of a kernel are
//! [`Weights::taps`](crate::image::weights::Weights::taps). [`Resizer`] does them in two passes, in the order that needs
//! fewer products: rows are summed before columns where an image becomes smaller. Both passes are weighted sums of lines in
//! vectors, since some rows turned by 90° are lines for the way across; no gathering and no horizontal addition is left,
//! whatever the ratio. Where neighbouring sums read nearly the same lines, four are made at once.
//!
//! Rows are read and written as memory has them, in pieces of 4096 numbers, and what is worked on stays in the second
//! cache. An image of floating-point numbers that becomes smaller is read once, each number to all the sums that it is in;
//! rows of bytes and words stay in the cache until the last new row has come back to them. The room of a thread is a few
//! such pieces of some dozen rows, below 4 MB for sums in `f32`, whatever the size of the image; it is more where 32 new
//! columns read more than 4096 numbers, 32 new rows of a larger image more than 32 old ones, or beyond a border that
//! continues at the other one.
//!
//! Cuts depend on sizes alone, and every number is summed in the order of the old positions: the bits do not depend on the
//! number of threads, and with [`Arithmetic::Plain`](crate::engine::Arithmetic::Plain) not on the processor.
//!
//! # Errors of rounding
//!
//! For values up to 1, weights of `n` and `m` old positions along the axes and `A = max Σ|w|` of each: weights, products and
//! sums round once each, so a result is right to `(n + m + 4)·ε·A_x·A_y`; of bytes and words half a code besides, from the
//! one rounding at the end. Values must be finite, and weights in the numbers that sums are made of: a value may count as
//! zero times itself in sums beside those that read it.
//!
//! ```
//! use nyquist::prelude::*;
//! use nyquist::door::srgb::srgb_to_linear;
//! use nyquist::engine::Arithmetic;
//! use nyquist::engine::resize::{Light, Resizer, View, ViewMut};
//! use nyquist::image::weights::Weights;
//! let (old, new) = (Axis::cells(0.0..8.0, 8)?, Axis::cells(0.0..8.0, 4)?);
//! let taps = || Weights::of(old, new, &Cubic::mitchell())?.taps(Edge::Mirror);
//! let half = Resizer::<f32>::new(taps()?, taps()?, Arithmetic::Fused);
//! let checks: Vec<u8> = (0..64).map(|i| if (i + i / 8) % 2 == 0 { 255 } else { 0 }).collect();
//! let mut small = [0u8; 16];
//! half.run(View::new(&checks, [8, 8], 1, 8)?, ViewMut::new(&mut small, [4, 4], 1, 4)?)?;
//! assert_eq!(small[5], 128); // the mean of the codes, darker than the checkerboard
//! half.run_in_light(&Light::new(srgb_to_linear)?, View::new(&checks, [8, 8], 1, 8)?, ViewMut::new(&mut small, [4, 4], 1, 4)?)?;
//! assert_eq!(small[5], 188); // the mean of the light
//! # Ok::<(), Error>(())
//! ```

mod across_first;
mod code;
mod down_first;
mod job;
mod light;
mod lines;
mod panel;
mod resizer;
mod room;
mod shares;
mod strips;
mod sums;
mod taps;
mod view;

pub use code::Code;
pub use light::Light;
pub use resizer::Resizer;
pub use taps::Taps;
pub use view::{View, ViewMut};
