//! Whether positions lie on a line, to the rounding that each may have.

/// Equally spaced positions `start + k·step`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Line {
    pub(super) start: f64,
    pub(super) step: f64,
    /// By how much the step may be off.
    pub(super) slack: f64,
}

/// The line that passes each position `x_i`, with node `k_i`, within its rounding `r_i`, if there is one. Positions and
/// nodes do not fall, and there are two of them at least; `nodes` counts from zero.
///
/// The strip between `x_i − r_i` and `x_i + r_i` holds a line of slope `T` where
/// `w(T) = max(x_i − r_i − k_i T) − min(x_i + r_i − k_i T) ≤ 0`; `w` is convex, so its least value is found by trisection,
/// between the slopes that the first and the last position allow.
pub(super) fn through(positions: &[f64], rounding: &[f64], node: impl Fn(usize) -> f64) -> Option<Line> {
    let last = positions.len() - 1;
    let length = node(last);
    // positions were rounded to f64 as well
    let room = |i: usize| rounding[i] + 2.0 * f64::EPSILON * positions[last].abs().max(positions[0].abs());
    let reach = |step: f64| {
        let mut ends = (f64::NEG_INFINITY, f64::INFINITY);
        for (i, x) in positions.iter().enumerate() {
            let rest = x - node(i) * step;
            ends = (ends.0.max(rest - room(i)), ends.1.min(rest + room(i)));
        }
        ends
    };
    let width = |step: f64| {
        let (low, high) = reach(step);
        low - high
    };
    let slack = (room(0) + room(last)) / length;
    let middle = (positions[last] - positions[0]) / length;
    let found = |step: f64| {
        let (low, high) = reach(step);
        let start = if low <= positions[0] && positions[0] <= high { positions[0] } else { 0.5 * (low + high) };
        Some(Line { start, step, slack })
    };
    let here = width(middle);
    if here <= 0.0 {
        return found(middle);
    }
    // no slope within the slack can lower the width by more than the slack times the length
    if here > slack * length {
        return None;
    }
    let (mut low, mut high) = (middle - slack, middle + slack);
    for _ in 0..60 {
        let (left, right) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        let (a, b) = (width(left), width(right));
        if a <= 0.0 {
            return found(left);
        }
        if b <= 0.0 {
            return found(right);
        }
        if a < b { high = right } else { low = left }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rounded(step: f64, n: i32, unit: f64) -> Option<Line> {
        let positions: Vec<f64> = (0..n).map(|i| (f64::from(i) * step / unit).round() * unit).collect();
        through(&positions, &vec![0.5 * unit; positions.len()], |i| i as f64)
    }

    #[test]
    fn a_printed_grid_is_found_and_its_step_within_the_slack() {
        for (step, unit) in [(1.0 / 48_000.0, 1e-6), (1.0 / 3.0, 1e-3), (0.4, 1.0), (0.123_456, 0.1)] {
            let line = rounded(step, 1000, unit).expect("a grid");
            assert!((line.step - step).abs() <= line.slack, "{line:?}");
        }
        assert_eq!(rounded(0.001, 1000, 1e-3).map(|l| (l.start, l.step)), Some((0.0, 0.001)));
    }

    #[test]
    fn a_position_off_by_more_than_the_rounding_is_on_no_line() {
        let mut positions: Vec<f64> = (0..100).map(f64::from).collect();
        assert!(through(&positions, &[0.001; 100], |i| i as f64).is_some());
        positions[50] += 0.0021;
        assert!(through(&positions, &[0.001; 100], |i| i as f64).is_none());
        positions[50] -= 0.0002;
        assert!(through(&positions, &[0.001; 100], |i| i as f64).is_some());
    }
}
