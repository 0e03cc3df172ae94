//! Frames of several channels, read channel by channel.

use crate::engine::real::Real;

/// Frames one after another: those that were kept, those that came, and then silence.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frames<'a, T> {
    pub(super) kept: &'a [T],
    pub(super) came: &'a [T],
    pub(super) channels: usize,
}

impl<T: Real> Frames<'_, T> {
    /// The values of one or two channels, a line of `length` for each, from frame `first` on.
    pub(super) fn read(&self, channel: usize, first: usize, length: usize, lines: &mut [T]) {
        let (mut from, mut done) = (first * self.channels, 0);
        for part in [self.kept, self.came] {
            let rest = part.get(from..).unwrap_or_default();
            let count = (rest.len() / self.channels).min(length - done);
            let values = &rest[..count * self.channels];
            if let (2, Some((left, right))) = (self.channels, lines.split_at_mut_checked(length)) {
                let both = left[done..done + count].iter_mut().zip(&mut right[done..done + count]);
                both.zip(values.chunks_exact(2)).for_each(|((a, b), frame)| (*a, *b) = (frame[0], frame[1]));
            } else {
                for (i, line) in lines.chunks_exact_mut(length).enumerate() {
                    let values = values.iter().skip(channel + i).step_by(self.channels);
                    line[done..done + count].iter_mut().zip(values).for_each(|(to, v)| *to = *v);
                }
            }
            from = from.saturating_sub(part.len());
            done += count;
        }
        lines.chunks_exact_mut(length).for_each(|line| line[done..].fill(T::zero()));
    }
}

/// One or two channels of frames from their lines of `length`, from place `from` on.
pub(super) fn write<T: Real>(lines: &[T], length: usize, from: usize, channel: usize, channels: usize, out: &mut [T]) {
    if let (2, Some((left, right))) = (channels, lines.split_at_checked(length)) {
        let both = left[from..].iter().zip(&right[from..]);
        out.chunks_exact_mut(2).zip(both).for_each(|(frame, (a, b))| (frame[0], frame[1]) = (*a, *b));
    } else {
        for (i, line) in lines.chunks_exact(length).enumerate() {
            let places = out.iter_mut().skip(channel + i).step_by(channels);
            places.zip(&line[from..]).for_each(|(to, v)| *to = *v);
        }
    }
}
