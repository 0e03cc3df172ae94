//! The highest of many rising lines while they are shifted and time goes on.

/// Lines `b_j + k_j·t` in a tree, each node of which knows the highest line below it now and when that can change.
///
/// A kinetic tournament (Basch, Guibas, Hershberger 1997) with range updates: shifting all lines from one on costs
/// `O(log n)`, and going on in time what has changed, `O(log² n)` amortised.
#[derive(Debug)]
pub(super) struct Kinetic {
    leaves: usize,
    now: f64,
    nodes: Vec<Node>,
}

#[derive(Debug, Clone, Copy)]
struct Node {
    slope: f64,
    offset: f64,
    /// When the highest line somewhere below this node can be another.
    until: f64,
    /// What has been added to all lines below, but not yet told them.
    pending: f64,
}

impl Node {
    fn at(&self, t: f64) -> f64 {
        self.offset + self.slope * t
    }

    fn add(&mut self, shift: f64) {
        self.offset += shift;
        self.pending += shift;
    }
}

impl Kinetic {
    /// Lines of those slopes through the origin, at `t = 0`.
    pub(super) fn new(slopes: impl ExactSizeIterator<Item = f64>) -> Self {
        let leaves = slopes.len().next_power_of_two();
        let nothing = Node { slope: 0.0, offset: f64::NEG_INFINITY, until: f64::INFINITY, pending: 0.0 };
        let mut nodes = vec![nothing; 2 * leaves];
        for (node, slope) in nodes[leaves..].iter_mut().zip(slopes) {
            (node.slope, node.offset) = (slope, 0.0);
        }
        let mut tree = Self { leaves, now: 0.0, nodes };
        (1..leaves).rev().for_each(|node| tree.pull(node));
        tree
    }

    /// The height of the highest line now.
    pub(super) fn highest(&self) -> f64 {
        self.nodes[1].at(self.now)
    }

    /// Shifts all lines from number `from` on.
    pub(super) fn shift_from(&mut self, from: usize, shift: f64) {
        let mut node = 1;
        let mut half = self.leaves;
        let mut start = 0;
        let mut path = Vec::with_capacity(32);
        while half > 1 {
            self.push(node);
            path.push(node);
            half /= 2;
            if from < start + half {
                self.nodes[2 * node + 1].add(shift);
                node *= 2;
            } else {
                start += half;
                node = 2 * node + 1;
            }
        }
        if from <= start {
            self.nodes[node].add(shift);
        }
        path.into_iter().rev().for_each(|node| self.pull(node));
    }

    /// Lets time go on to `t`, which must not be earlier.
    pub(super) fn advance(&mut self, t: f64) {
        self.now = t;
        self.refresh(1);
    }

    fn refresh(&mut self, node: usize) {
        if self.nodes[node].until > self.now || node >= self.leaves {
            return;
        }
        self.push(node);
        self.refresh(2 * node);
        self.refresh(2 * node + 1);
        self.pull(node);
    }

    fn push(&mut self, node: usize) {
        let pending = std::mem::take(&mut self.nodes[node].pending);
        self.nodes[2 * node].add(pending);
        self.nodes[2 * node + 1].add(pending);
    }

    /// The higher of the two children's lines, and how long it stays so.
    fn pull(&mut self, node: usize) {
        let (left, right) = (self.nodes[2 * node], self.nodes[2 * node + 1]);
        let (high, low) = if left.at(self.now) >= right.at(self.now) { (left, right) } else { (right, left) };
        let crossing =
            if low.slope > high.slope { (high.offset - low.offset) / (low.slope - high.slope) } else { f64::INFINITY };
        let until = left.until.min(right.until).min(crossing);
        self.nodes[node] = Node { slope: high.slope, offset: high.offset, until, pending: 0.0 };
    }
}
