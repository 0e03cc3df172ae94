//! Gaps of a record, and what lies between long ones.

use crate::axis::Axis;
use crate::record::sampling::{Duplicates, Kind, Order, Sampling};
use crate::record::steps::quantile;
use std::ops::Range;

/// Of how many steps the next sample must at least be missing for a record to be two.
const LONG_GAP: usize = 4;
/// The same where there is no step, in medians of the ways between positions. For independent positions a way of 20 has
/// the probability `e^{−14} = 10⁻⁶`.
const LONG_WAY: f64 = 20.0;
/// Nodes of a grid, and nodes to the sample, above which a record is too sparse to be looked into as one.
const MOST_NODES: usize = 1 << 22;
const SPARSE: usize = 8;

/// Samples that are missing in a row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// Between which positions.
    pub between: [f64; 2],
    /// How many there would be.
    pub missing: usize,
}

impl Sampling {
    /// Where samples of a grid are missing, in order.
    pub fn gaps(&self) -> Vec<Gap> {
        let missing = |i: usize| self.nodes[i + 1].saturating_sub(self.nodes[i] + 1);
        let gap = |i: usize| Gap { between: [self.positions[i], self.positions[i + 1]], missing: missing(i) };
        (0..self.nodes.len().saturating_sub(1)).map(gap).filter(|gap| gap.missing > 0).collect()
    }

    /// The longest way from one position to the next, and behind which position it is.
    pub fn largest_gap(&self) -> (f64, usize) {
        let ways = self.positions.windows(2).map(|pair| pair[1] - pair[0]).zip(0..);
        ways.fold((0.0, 0), |most, way| if way.0 > most.0 { way } else { most })
    }

    /// The least, the median and the greatest way from one position to the next.
    pub fn ways(&self) -> [f64; 3] {
        let ways: Vec<f64> = self.positions.windows(2).map(|pair| pair[1] - pair[0]).collect();
        [0.0, 0.5, 1.0].map(|at| quantile(&ways, at))
    }

    /// The equally spaced positions; none for other kinds.
    pub fn axis(&self) -> Option<Axis> {
        self.axis_of(0..self.positions.len())
    }

    /// The equally spaced positions of a stretch; none where they are not.
    pub fn axis_of(&self, stretch: Range<usize>) -> Option<Axis> {
        let nodes = self.nodes_of(stretch.clone())?;
        let step = self.line?.step;
        let dense = nodes[nodes.len() - 1] - nodes[0] + 1 == nodes.len();
        dense.then(|| Axis::new(self.positions[stretch.start], step, nodes.len()).ok()).flatten()
    }

    /// The nodes of a stretch on a grid, with or without gaps; none where positions are on none.
    pub(crate) fn nodes_of(&self, stretch: Range<usize>) -> Option<&[usize]> {
        let on_grid = matches!(self.kind, Kind::Uniform | Kind::Gaps);
        self.nodes.get(stretch).filter(|nodes| on_grid && !nodes.is_empty())
    }

    /// The stretches without long gaps: four missing samples in a row, or 20 medians of the ways where there is no step,
    /// part a record into two.
    pub fn stretches(&self) -> Vec<Range<usize>> {
        let longest = match self.kind {
            Kind::Irregular => LONG_WAY * self.ways()[1],
            _ => f64::INFINITY,
        };
        let parted = |i: &usize| match self.nodes.as_slice() {
            [] => self.positions[*i] - self.positions[*i - 1] > longest,
            nodes => nodes[*i].saturating_sub(nodes[*i - 1]) > LONG_GAP,
        };
        let n = self.positions.len();
        let mut starts: Vec<usize> = (1..n).filter(parted).collect();
        starts.insert(0, 0);
        let ends = starts.iter().skip(1).copied().chain([n]);
        starts.iter().zip(ends).map(|(&start, end)| start..end).collect()
    }

    /// A stretch alone.
    #[must_use]
    pub fn part(&self, stretch: Range<usize>) -> Self {
        let n = stretch.len();
        let nodes = self.nodes.get(stretch.clone()).unwrap_or_default();
        let nodes: Vec<usize> = nodes.iter().map(|node| node - nodes[0]).collect();
        let dense = nodes.last().is_some_and(|last| *last + 1 == n);
        let kind = if self.kind == Kind::Gaps && dense { Kind::Uniform } else { self.kind };
        let (order, duplicates, rows) = (Order::Rising, Duplicates::default(), (0..n).collect());
        let positions = self.positions[stretch].to_vec();
        Self { kind, order, duplicates, rows, begins: (0..n).collect(), positions, nodes, ..self.clone() }
    }

    /// What can be looked into as one: all, or the longest stretch of a record that is nearly all gaps (two bursts of a
    /// millisecond, a day apart).
    pub fn main_stretch(&self) -> Range<usize> {
        let n = self.positions.len();
        let nodes = self.nodes.last().map_or(0, |last| last + 1);
        if nodes <= MOST_NODES.max(SPARSE * n) {
            return 0..n;
        }
        self.stretches().into_iter().max_by_key(Range::len).unwrap_or(0..n)
    }
}
