//! Times that do not drift.

/// A time in samples: whole ones, and 2⁻¹²⁸ths.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Time {
    pub(super) whole: u64,
    pub(super) fraction: u128,
}

impl Time {
    /// So many steps later.
    pub(super) fn after(self, count: u64, step: Self) -> Self {
        // the fraction's halves times the count
        let low = u128::from(step.fraction as u64) * u128::from(count);
        let high = (step.fraction >> 64) * u128::from(count) + (low >> 64);
        let (fraction, carry) = self.fraction.overflowing_add(high << 64 | u128::from(low as u64));
        let whole = self.whole + step.whole * count + (high >> 64) as u64 + u64::from(carry);
        Self { whole, fraction }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_steps_are_one_step_many_times() {
        let step = Time { whole: 3, fraction: u128::MAX / 7 * 5 + 11 };
        let start = Time { whole: 10, fraction: u128::MAX / 3 };
        let one_by_one = (0..1000).fold(start, |time, _| time.after(1, step));
        assert_eq!(start.after(1000, step), one_by_one);
        assert_eq!(start.after(7, Time { whole: 0, fraction: 1 << 127 }).whole, 13);
    }
}
