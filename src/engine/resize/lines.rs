//! Old lines, one after another.

/// Lines of numbers, `stride` apart, from the old position `first` on.
#[derive(Clone, Copy)]
pub(super) struct Lines<'a, T> {
    pub(super) numbers: &'a [T],
    pub(super) first: usize,
    pub(super) stride: usize,
}

impl<'a, T> Lines<'a, T> {
    /// The lines from a position on.
    #[inline(always)]
    pub(super) fn from(&self, position: usize) -> impl Iterator<Item = &'a [T]> {
        self.numbers[(position - self.first) * self.stride..].chunks(self.stride)
    }
}
