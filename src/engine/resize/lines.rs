//! Old lines, one after another.

/// Lines of numbers, `stride` apart, from the old position `first` on.
#[derive(Clone, Copy)]
pub(super) struct Lines<'a, T> {
    pub(super) numbers: &'a [T],
    pub(super) first: i64,
    pub(super) stride: usize,
}

impl<'a, T> Lines<'a, T> {
    /// The lines from a position on.
    #[inline(always)]
    pub(super) fn from(&self, position: i64) -> impl Iterator<Item = &'a [T]> {
        self.numbers[(position - self.first) as usize * self.stride..].chunks(self.stride)
    }
}
