//! Sample patterns of the plane, their spectra and their measures (slides from «Стохастический суперсэмплинг» to «Другие
//! методы сэмплирования»).

pub mod portrait;
mod square;

use crate::figure::Entry;

/// The families of this chapter, in its order.
pub static FAMILIES: &[&[Entry]] = &[];
