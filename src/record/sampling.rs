//! How regular the positions of a record are, and which bands they allow.

use crate::door::table::Table;
use crate::error::{Error, Result, all_finite, positive};
use crate::num::mean::mean;
use crate::record::line::{Line, through};
use crate::record::steps::Steps;

/// The unevenness of steps, in steps, from which on there is none. Ways that are no multiple of anything have 0.289.
const NO_STEP: f64 = 0.2;
/// Where at least this part of the positions is equal to the one before, they may be a grid that was printed too coarsely.
const COARSE: f64 = 0.1;

/// The kinds of sampling.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
    /// Equally spaced, to the rounding of the positions.
    Uniform,
    /// Equally spaced, to the rounding, but some samples are missing.
    Gaps,
    /// About equally spaced, with or without missing samples.
    Jittered,
    /// No step underlies the positions.
    Irregular,
}

/// In which order the rows came.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// No position is below the one before it.
    Rising,
    /// From the last to the first.
    Falling,
    /// So many are below the one before them, the first of these in that row (counted from zero).
    Mixed {
        /// How many.
        falls: usize,
        /// The row of the first.
        first: usize,
    },
}

/// Rows at a position that another row has already; the mean of their values is used.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Duplicates {
    /// How many there are.
    pub rows: usize,
    /// The first of them, counted from zero.
    pub first: usize,
}

/// How far positions are from the nearest grid, in units of position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jitter {
    /// The root mean square.
    pub rms: f64,
    /// The most.
    pub most: f64,
}

/// How a record was sampled.
///
/// ```
/// use nyquist::record::{Kind, Sampling};
/// // every 1/30 s, printed with two decimals, and the fifth lost
/// let times = [0.0, 0.03, 0.07, 0.1, 0.17, 0.2];
/// let sampling = Sampling::of(&times, &[0.005; 6])?;
/// assert_eq!(sampling.kind(), Kind::Gaps);
/// assert!((sampling.step().unwrap() - 1.0 / 30.0).abs() < 1e-15 && sampling.gaps()[0].missing == 1);
/// // what Landau and Gröchenig say of it: no band above, every band below
/// assert!((sampling.highest_band() - 12.5).abs() < 1e-13 && (sampling.safe_band() - 7.5).abs() < 1e-13);
/// # Ok::<(), nyquist::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Sampling {
    pub(super) kind: Kind,
    pub(super) order: Order,
    pub(super) duplicates: Duplicates,
    /// The rows in the order of their positions.
    pub(super) rows: Vec<usize>,
    /// Where in them each distinct position begins.
    pub(super) begins: Vec<usize>,
    pub(super) positions: Vec<f64>,
    pub(super) line: Option<Line>,
    pub(super) nodes: Vec<usize>,
    pub(super) jitter: Jitter,
    /// The largest rounding of a position.
    pub(super) rounding: f64,
}

impl Sampling {
    /// Of positions in any order, each of which may be off by its rounding: half of the last printed decimal, for example.
    ///
    /// A position is on a grid if a grid passes all of them within their rounding. Otherwise the step is the mean one, gaps
    /// are those that are several steps long, and where ways between positions are not near whole steps at all (off by
    /// 0.2 steps in the mean square; 0.29 would be chance) there is no step.
    ///
    /// # Errors
    /// Fewer than two positions, or only one distinct; positions or roundings that are not finite; a negative rounding;
    /// lengths that differ or overflow.
    pub fn of(positions: &[f64], rounding: &[f64]) -> Result<Self> {
        all_finite("positions of samples", positions)?;
        if rounding.len() != positions.len() {
            let what = "roundings of positions";
            return Err(Error::Length { what, expected: positions.len(), got: rounding.len() });
        }
        if let Some(&value) = rounding.iter().find(|r| !(r.is_finite() && **r >= 0.0)) {
            let what = "the rounding of a position";
            return Err(Error::OutOfRange { what, value, low: 0.0, high: f64::MAX });
        }
        let n = positions.len();
        if n < 2 {
            return Err(Error::TooFew { what: "rows with positions", least: 2, got: n });
        }
        let (order, rows) = ordered(positions);
        let sorted: Vec<f64> = rows.iter().map(|&row| positions[row]).collect();
        if !(sorted[n - 1] - sorted[0]).is_finite() {
            let what = "the length of a record";
            return Err(Error::Overflow { what, value: sorted[n - 1] - sorted[0], most: f64::MAX });
        }
        if sorted[n - 1] == sorted[0] {
            return Err(Error::TooFew { what: "rows at different positions (all are the same)", least: 2, got: 1 });
        }
        let room: Vec<f64> = rows.iter().map(|&row| rounding[row]).collect();
        let ties = sorted.windows(2).filter(|pair| pair[0] == pair[1]).count();
        let mut sampling = Self {
            kind: Kind::Uniform,
            order,
            duplicates: Duplicates::default(),
            begins: (0..n).collect(),
            positions: sorted,
            rows,
            line: None,
            nodes: (0..n).collect(),
            jitter: Jitter { rms: 0.0, most: 0.0 },
            rounding: rounding.iter().copied().fold(0.0, f64::max),
        };
        if ties == 0 || ties as f64 >= COARSE * n as f64 {
            sampling.line = through(&sampling.positions, &room, |i| i as f64);
            if let Some(line) = sampling.line {
                sampling.positions = (0..n).map(|i| line.start + i as f64 * line.step).collect();
                return Ok(sampling);
            }
        }
        sampling.merge(positions);
        let room: Vec<f64> = sampling.begins.iter().map(|&at| room[at]).collect();
        sampling.classify(&room);
        Ok(sampling)
    }

    /// Of the times of a table, each of which may be off by its printing, counted from the first row; or of rows that are
    /// `step` apart.
    ///
    /// # Errors
    /// As [`Sampling::of`]; a table without times where no step is said, a step that is not positive.
    pub fn of_table(table: &Table, step: Option<f64>) -> Result<Self> {
        match (step, &table.clock) {
            (Some(step), _) => {
                positive("the step between rows", step)?;
                let positions: Vec<f64> = (0..table.rows()).map(|i| i as f64 * step).collect();
                Self::of(&positions, &vec![0.0; positions.len()])
            }
            (None, Some(clock)) => Self::of(&clock.since_first(), &clock.rounding()),
            (None, None) => Err(Error::Unsupported("a table without times needs the step between its rows")),
        }
    }

    /// Rows of one position become one sample.
    fn merge(&mut self, positions: &[f64]) {
        let sorted = &self.positions;
        self.begins.retain(|&i| i == 0 || sorted[i] != sorted[i - 1]);
        let begins = &self.begins;
        let repeated = |i: &usize| begins.binary_search(i).is_err();
        let first = (0..sorted.len()).filter(repeated).map(|i| self.rows[i]).min().unwrap_or(0);
        self.duplicates = Duplicates { rows: sorted.len() - begins.len(), first };
        self.positions = begins.iter().map(|&at| positions[self.rows[at]]).collect();
    }

    fn classify(&mut self, room: &[f64]) {
        let steps = Steps::of(&self.positions);
        let node = |i: usize| steps.nodes[i] as f64;
        let rising = steps.nodes.windows(2).all(|pair| pair[0] < pair[1]);
        let whole = rising && steps.nodes[steps.nodes.len() - 1] < 1 << 40;
        if let Some(line) = whole.then(|| through(&self.positions, room, node)).flatten() {
            self.kind =
                if steps.nodes.len() == steps.nodes[steps.nodes.len() - 1] + 1 { Kind::Uniform } else { Kind::Gaps };
            self.line = Some(line);
            self.positions = steps.nodes.iter().map(|&k| line.start + k as f64 * line.step).collect();
            self.nodes = steps.nodes;
            return;
        }
        if !whole || steps.unevenness > NO_STEP {
            self.kind = Kind::Irregular;
            self.nodes = Vec::new();
            return;
        }
        self.kind = Kind::Jittered;
        let line = fitted(&self.positions, &steps.nodes);
        let off = |i: usize| (self.positions[i] - line.start - node(i) * line.step).abs();
        let squares: f64 = (0..self.positions.len()).map(|i| off(i).powi(2)).sum();
        let most = (0..self.positions.len()).map(off).fold(0.0, f64::max);
        self.jitter = Jitter { rms: (squares / self.positions.len() as f64).sqrt(), most };
        self.line = Some(line);
        self.nodes = steps.nodes;
    }

    /// What kind of sampling it is.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// In which order the rows came.
    pub fn order(&self) -> Order {
        self.order
    }

    /// Rows at positions that came before.
    pub fn duplicates(&self) -> Duplicates {
        self.duplicates
    }

    /// The distinct positions, rising; of a grid its nodes, from which the printed ones differ by their rounding.
    pub fn positions(&self) -> &[f64] {
        &self.positions
    }

    /// The value of each position: that of its row, or the mean of its rows.
    ///
    /// # Errors
    /// Values of another number than there were rows, or that are not finite.
    pub fn values(&self, values: &[f64]) -> Result<Vec<f64>> {
        if values.len() != self.rows.len() {
            return Err(Error::Length { what: "values in rows", expected: self.rows.len(), got: values.len() });
        }
        all_finite("values in rows", values)?;
        let value = |rows: &[usize]| match rows {
            [row] => values[*row],
            rows => mean(&rows.iter().map(|&row| values[row]).collect::<Vec<_>>()),
        };
        Ok(self.groups().map(value).collect())
    }

    /// How many positions have rows whose values differ.
    pub fn disagreements(&self, values: &[f64]) -> usize {
        let differ = |rows: &&[usize]| rows.windows(2).any(|pair| values.get(pair[0]) != values.get(pair[1]));
        self.groups().filter(differ).count()
    }

    /// The rows of each position.
    fn groups(&self) -> impl Iterator<Item = &[usize]> {
        let end = |i: usize| self.begins.get(i + 1).copied().unwrap_or(self.rows.len());
        self.begins.iter().enumerate().map(move |(i, &at)| &self.rows[at..end(i)])
    }

    /// The row that position `i` came from; the first, if there are several.
    pub fn row(&self, i: usize) -> usize {
        self.rows[self.begins[i]]
    }

    /// The step of the grid, or the mean one of jittered positions; none where there is none.
    pub fn step(&self) -> Option<f64> {
        self.line.map(|line| line.step)
    }

    /// By how much the step of a grid may be off, since its positions were rounded.
    pub fn step_slack(&self) -> f64 {
        self.line.map_or(0.0, |line| line.slack)
    }

    /// The way from each position to the next on the average.
    pub fn mean_step(&self) -> f64 {
        self.length() / (self.positions.len() - 1) as f64
    }

    /// The number of the grid's node at each position; empty where there is no step.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// How far positions are from the grid; zero on a grid, and where there is none.
    pub fn jitter(&self) -> Jitter {
        self.jitter
    }

    /// The most by which a position may be off from having been printed.
    pub fn rounding(&self) -> f64 {
        self.rounding
    }

    /// From the first position to the last.
    pub fn length(&self) -> f64 {
        self.positions[self.positions.len() - 1] - self.positions[0]
    }

    /// Positions per unit.
    pub fn density(&self) -> f64 {
        1.0 / self.mean_step()
    }

    /// Half the density: no band above it is determined, however the positions lie (Landau 1967). On a grid without gaps it
    /// is the Nyquist frequency.
    pub fn highest_band(&self) -> f64 {
        0.5 * self.density()
    }

    /// `1/(2δ)` for the largest gap `δ`: every band below it is determined, and stably (Gröchenig 1992).
    pub fn safe_band(&self) -> f64 {
        0.5 / self.largest_gap().0
    }
}

/// The order that the positions came in, and the rows in rising order; equal positions keep theirs.
fn ordered(positions: &[f64]) -> (Order, Vec<usize>) {
    let n = positions.len();
    let falls = (1..n).filter(|&i| positions[i] < positions[i - 1]).count();
    let mut rows: Vec<usize> = (0..n).collect();
    let order = match (1..n).find(|&i| positions[i] < positions[i - 1]) {
        None => return (Order::Rising, rows),
        Some(_) if positions.windows(2).all(|pair| pair[1] <= pair[0]) => Order::Falling,
        Some(first) => Order::Mixed { falls, first },
    };
    rows.sort_by(|&a, &b| positions[a].total_cmp(&positions[b]));
    (order, rows)
}

/// The line of least squares through positions over nodes.
fn fitted(positions: &[f64], nodes: &[usize]) -> Line {
    let n = positions.len() as f64;
    let mean_node = nodes.iter().map(|&k| k as f64).sum::<f64>() / n;
    let mean = mean(positions);
    let (mut across, mut square) = (0.0, 0.0);
    for (x, &k) in positions.iter().zip(nodes) {
        let k = k as f64 - mean_node;
        across += k * (x - mean);
        square += k * k;
    }
    let step = across / square;
    Line { start: mean - mean_node * step, step, slack: 0.0 }
}
