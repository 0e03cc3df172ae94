//! Where a function of one variable is largest.

/// A place and the value there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extremum {
    /// Where.
    pub at: f64,
    /// How much.
    pub value: f64,
}

/// The maximum of `f` on `[a, b]`: the best of `n + 1` equidistant places, refined by golden-section search (Kiefer 1953)
/// between its neighbours.
///
/// Right where `f` has a single peak between neighbouring places. The value is exact to rounding; its place is only known
/// to about `√ε` times the width of the peak, as for every method that compares values.
///
/// ```
/// use nyquist::num::extremum::maximum;
/// let top = maximum(|x| 1.0 - (x - 0.3) * (x - 0.3), 0.0, 1.0, 8);
/// assert!((top.at - 0.3).abs() < 1e-7 && top.value == 1.0);
/// ```
pub fn maximum(f: impl Fn(f64) -> f64, a: f64, b: f64, n: usize) -> Extremum {
    let n = n.max(1);
    let place = |i: usize| a + (b - a) * i as f64 / n as f64;
    let look = |x: f64| Extremum { at: x, value: f(x) };
    let better = |best: Extremum, other: Extremum| if other.value > best.value { other } else { best };
    let (i, coarse) = (1..=n).fold((0, look(a)), |(i, best), j| {
        let other = look(place(j));
        if other.value > best.value { (j, other) } else { (i, best) }
    });
    let (mut low, mut high) = (place(i.saturating_sub(1)), place((i + 1).min(n)));
    let golden = 0.5 * (5.0f64.sqrt() - 1.0);
    let (mut left, mut right) = (look(high - golden * (high - low)), look(low + golden * (high - low)));
    // 0.618⁶⁰ < 10⁻¹²: far below √ε, where values stop telling places apart
    for _ in 0..60 {
        if left.value < right.value {
            (low, left) = (left.at, right);
            right = look(low + golden * (high - low));
        } else {
            (high, right) = (right.at, left);
            left = look(high - golden * (high - low));
        }
    }
    better(better(coarse, left), right)
}
