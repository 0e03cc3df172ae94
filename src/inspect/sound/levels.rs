//! How loud a channel is.

/// The level in dBFS of a mean square: `10·log₁₀(2p)`, zero for a sine of full scale; `−∞` of silence.
///
/// ```
/// use nyquist::inspect::sound::dbfs;
/// assert_eq!(dbfs(0.5), 0.0);
/// assert!((dbfs(1.0) - 3.0103).abs() < 1e-4); // a square wave
/// assert_eq!(dbfs(0.0), f64::NEG_INFINITY);
/// ```
pub fn dbfs(mean_square: f64) -> f64 {
    10.0 * (2.0 * mean_square).log10()
}

/// The numbers of a channel that need no spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Levels {
    /// The least value and the largest.
    pub range: [f64; 2],
    /// The mean of all values.
    pub mean: f64,
    /// The mean square of what is left without the mean.
    pub power: f64,
}

impl Levels {
    /// The largest magnitude.
    pub fn peak(&self) -> f64 {
        self.range[0].abs().max(self.range[1].abs())
    }

    /// Whether all values are the same: silence, with or without an offset.
    pub fn constant(&self) -> bool {
        self.range[0] == self.range[1]
    }
}

/// Levels of values that come in.
#[derive(Debug, Clone, Copy)]
pub(super) struct Gauge {
    first: f64,
    range: [f64; 2],
    /// Of whole runs, and of the run that has begun.
    sums: Sums,
    run: Sums,
}

/// Sums of the differences from the first value, plain and squared: an offset does not drown what is quiet.
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    count: u64,
    plain: f64,
    squares: f64,
}

impl Sums {
    fn add(&mut self, other: Self) {
        self.count += other.count;
        self.plain += other.plain;
        self.squares += other.squares;
    }
}

impl Gauge {
    /// Values that are summed before they go into the sum of all, so that rounding grows with the number of runs.
    const RUN: u64 = 4096;

    pub(super) fn new(first: f64) -> Self {
        Self { first, range: [first; 2], sums: Sums::default(), run: Sums::default() }
    }

    pub(super) fn add(&mut self, values: impl Iterator<Item = f64>) {
        for value in values {
            self.range = [self.range[0].min(value), self.range[1].max(value)];
            let away = value - self.first;
            self.run.add(Sums { count: 1, plain: away, squares: away * away });
            if self.run.count == Self::RUN {
                self.sums.add(std::mem::take(&mut self.run));
            }
        }
    }

    pub(super) fn read(&self) -> Levels {
        let mut sums = self.sums;
        sums.add(self.run);
        let count = sums.count as f64;
        let away = sums.plain / count;
        let power = if self.range[0] == self.range[1] { 0.0 } else { (sums.squares / count - away * away).max(0.0) };
        Levels { range: self.range, mean: self.first + away, power }
    }
}
