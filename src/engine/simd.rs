//! Vector instructions, chosen at run time: the only place that knows pulp.
//!
//! What runs here is plain arithmetic on arrays, element by element, which the compiler vectorises once for every set of
//! instructions. It never fuses a product and a sum, so the bits do not depend on the choice.

use pulp::{Arch, NullaryFnOnce};

/// A loop that is worth wide vectors. `run` must be `#[inline(always)]`, and what it calls too.
pub(super) trait Loop {
    /// The loop.
    fn run(self);
}

struct Dispatched<L>(L);

impl<L: Loop> NullaryFnOnce for Dispatched<L> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        self.0.run();
    }
}

/// Runs a loop with the widest vectors of this processor.
pub(super) fn vectorised(task: impl Loop) {
    Arch::new().dispatch(Dispatched(task));
}
