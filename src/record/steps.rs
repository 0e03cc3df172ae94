//! The step that positions go by, though they jitter and have gaps.

/// A step, and how many of them each way from one position to the next is.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Steps {
    pub(super) step: f64,
    /// From the first position, `k_i`; as many as positions.
    pub(super) nodes: Vec<usize>,
    /// The root mean square of how far ways are from whole steps, in steps.
    pub(super) unevenness: f64,
}

impl Steps {
    /// Of strictly rising positions, two at least. First the median of the ways that are about as long as the shorter ones
    /// (the first fifth), then the mean of all ways, each counted as so many steps as fit best.
    pub(super) fn of(positions: &[f64]) -> Self {
        let ways: Vec<f64> = positions.windows(2).map(|p| p[1] - p[0]).collect();
        let short = quantile(&ways, 0.2);
        let similar: Vec<f64> = ways.iter().copied().filter(|w| (0.5 * short..1.8 * short).contains(w)).collect();
        let mut step = quantile(&similar, 0.5);
        let count = |way: f64, step: f64| (way / step).round().clamp(0.0, 1e15);
        for _ in 0..3 {
            let total: f64 = ways.iter().map(|&way| count(way, step)).sum();
            step = ways.iter().sum::<f64>() / total.max(1.0);
        }
        let off = |way: &f64| (way / step - count(*way, step)).powi(2);
        let unevenness = (ways.iter().map(off).sum::<f64>() / ways.len() as f64).sqrt();
        let mut nodes = vec![0];
        let mut node = 0usize;
        for &way in &ways {
            node = node.saturating_add(count(way, step) as usize);
            nodes.push(node);
        }
        Self { step, nodes, unevenness }
    }
}

/// The value below which the part `at` of the values lies; there is one at least.
pub(super) fn quantile(values: &[f64], at: f64) -> f64 {
    let mut sorted = values.to_vec();
    let index = ((sorted.len() - 1) as f64 * at).round() as usize;
    *sorted.select_nth_unstable_by(index, f64::total_cmp).1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::random::{normal, uniform};

    #[test]
    fn gaps_are_counted_through_jitter() {
        // every tenth sample lost, a hundred in a row, and steps that jitter by a twentieth
        let kept = |k: &u64| k % 10 != 3 && !(5000..5100).contains(k);
        let nodes: Vec<u64> = (0..10_000).filter(kept).collect();
        let at = |&k: &u64| 0.02 * (k as f64 + 0.05 * (2.0 * uniform(1, k, 0) - 1.0));
        let steps = Steps::of(&nodes.iter().map(at).collect::<Vec<_>>());
        assert_eq!(steps.nodes, nodes.iter().map(|&k| k as usize).collect::<Vec<_>>());
        // the ends jitter by a twentieth of a step each, over 10⁴ steps
        assert!((steps.step - 0.02).abs() < 0.02 * 1e-5 && steps.unevenness < 0.05);
    }

    #[test]
    fn a_clock_that_wanders_is_followed() {
        let mut now = 0.0;
        let positions: Vec<f64> = (0..2000u64)
            .map(|k| {
                now += 1.0 + 0.1 * normal(2, k, 0);
                now
            })
            .collect();
        let steps = Steps::of(&positions);
        assert_eq!(*steps.nodes.last().unwrap(), 1999);
        assert!((steps.unevenness - 0.1).abs() < 0.01);
    }

    #[test]
    fn independent_positions_have_no_step() {
        let mut positions: Vec<f64> = (0..2000u64).map(|k| uniform(3, k, 0)).collect();
        positions.sort_by(f64::total_cmp);
        assert!(Steps::of(&positions).unevenness > 0.2);
    }
}
