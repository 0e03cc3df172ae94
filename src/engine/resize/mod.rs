//! The resizing engine.

mod code;
mod light;
mod resizer;
mod room;
mod strips;
mod sums;
mod taps;
mod turn;
mod view;

pub use code::Code;
pub use light::Light;
pub use resizer::Resizer;
pub use taps::Taps;
pub use view::{View, ViewMut};
