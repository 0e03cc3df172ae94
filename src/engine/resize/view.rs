//! An image in somebody's memory.

use crate::error::{Error, Result};

/// Where the numbers of an image are: row by row, pixel by pixel, channel by channel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Layout {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) channels: usize,
    /// From one row to the next; of a single row its length, whatever lies behind it.
    pub(super) stride: usize,
}

impl Layout {
    fn new(len: usize, [width, height]: [usize; 2], channels: usize, stride: usize) -> Result<Self> {
        let counts = [("the width of an image", width), ("the height of an image", height), ("its channels", channels)];
        for (what, got) in counts {
            if got == 0 {
                return Err(Error::TooFew { what, least: 1, got });
            }
        }
        let overflow = || Error::Overflow {
            what: "the size of an image",
            value: stride.max(width) as f64 * channels as f64 * height as f64,
            most: usize::MAX as f64,
        };
        let row = width.checked_mul(channels).ok_or_else(overflow)?;
        if stride < row {
            return Err(Error::TooFew { what: "numbers from one row to the next", least: row, got: stride });
        }
        let all = stride.checked_mul(height - 1).and_then(|n| n.checked_add(row)).ok_or_else(overflow)?;
        if len < all {
            return Err(Error::TooFew { what: "the numbers of an image", least: all, got: len });
        }
        Ok(Self { width, height, channels, stride: if height == 1 { row } else { stride } })
    }

    pub(super) fn row(&self) -> usize {
        self.width * self.channels
    }

    fn all(&self) -> usize {
        self.stride * (self.height - 1) + self.row()
    }
}

/// An image to read: interleaved channels, rows one after another, with anything between them.
///
/// ```
/// use nyquist::engine::resize::View;
/// let bytes = [0u8; 2 * 3 * 4];
/// assert!(View::new(&bytes, [3, 2], 4, 12).is_ok());
/// assert!(View::new(&bytes, [3, 3], 4, 12).is_err()); // three rows of three pixels are 36 bytes
/// ```
#[derive(Debug, Clone, Copy)]
pub struct View<'a, T> {
    pub(super) values: &'a [T],
    pub(super) layout: Layout,
}

impl<'a, T> View<'a, T> {
    /// Of so many pixels across and down; `stride` numbers lie between the beginnings of two rows.
    ///
    /// # Errors
    /// No pixel, no channel, a stride shorter than a row, fewer numbers than there must be.
    pub fn new(values: &'a [T], size: [usize; 2], channels: usize, stride: usize) -> Result<Self> {
        Ok(Self { values, layout: Layout::new(values.len(), size, channels, stride)? })
    }

    #[inline(always)]
    pub(super) fn row(&self, y: usize) -> &'a [T] {
        &self.values[y * self.layout.stride..][..self.layout.row()]
    }
}

/// An image to write, laid out as a [`View`].
#[derive(Debug)]
pub struct ViewMut<'a, T> {
    pub(super) values: &'a mut [T],
    pub(super) layout: Layout,
}

impl<'a, T> ViewMut<'a, T> {
    /// Of so many pixels across and down; `stride` numbers lie between the beginnings of two rows.
    ///
    /// # Errors
    /// No pixel, no channel, a stride shorter than a row, fewer numbers than there must be.
    pub fn new(values: &'a mut [T], size: [usize; 2], channels: usize, stride: usize) -> Result<Self> {
        let layout = Layout::new(values.len(), size, channels, stride)?;
        Ok(Self { values: &mut values[..layout.all()], layout })
    }
}
