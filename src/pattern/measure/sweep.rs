//! The largest surplus and the largest deficit of points in boxes at the origin, while the boxes grow to the right.

/// Boxes from the origin to `(t, y_j)` for every upper side `y_j`: how many points too many the closed ones hold, and how
/// many too few the open ones, at the worst.
///
/// A kinetic tournament (Basch, Guibas, Hershberger 1997) in a tree over the sides in rising order. As `t` grows, the box
/// of the higher side gains area faster: of two boxes, the one with the greater surplus or deficit changes once at most.
/// A node knows the worst of its boxes, counted from the points at its own sides, and until when they stay the worst. A
/// new point changes the nodes above one leaf, `O(log n)`; letting `t` grow costs what has changed, `O(log² n)` amortised.
#[derive(Debug)]
pub(super) struct Sweep {
    leaves: usize,
    now: f64,
    nodes: Vec<Node>,
}

/// What is known of the sides below a node.
#[derive(Debug, Clone, Copy)]
struct Node {
    /// How many points have been added at these sides.
    points: f64,
    /// The closed box with too many points.
    surplus: Corner,
    /// The open box with too few.
    deficit: Corner,
    /// When one of the worst boxes somewhere below can be another.
    until: f64,
}

/// A box: its fair number of points is `area·t`.
#[derive(Debug, Clone, Copy)]
struct Corner {
    area: f64,
    points: f64,
}

impl Corner {
    /// Seen from a node that has so many points below this one.
    fn above(self, points: f64) -> Self {
        Self { points: points + self.points, ..self }
    }
}

impl Sweep {
    /// At `t = 0`, without points; the rising `areas`, `N·y_j`, are not above `most`.
    pub(super) fn new(areas: impl ExactSizeIterator<Item = f64>, most: f64) -> Self {
        let leaves = areas.len().next_power_of_two();
        let of = |area, [surplus, deficit]: [f64; 2]| Node {
            points: 0.0,
            surplus: Corner { area, points: surplus },
            deficit: Corner { area, points: deficit },
            until: f64::INFINITY,
        };
        // what is left over of the leaves is never the worst
        let mut nodes = vec![of(most, [f64::MIN, f64::MAX]); 2 * leaves];
        nodes[leaves..].iter_mut().zip(areas).for_each(|(node, area)| *node = of(area, [0.0; 2]));
        let mut sweep = Self { leaves, now: 0.0, nodes };
        (1..leaves).rev().for_each(|node| sweep.join(node));
        sweep
    }

    /// The largest surplus now, in points.
    pub(super) fn surplus(&self) -> f64 {
        let Corner { area, points } = self.nodes[1].surplus;
        points - area * self.now
    }

    /// The largest deficit now, in points.
    pub(super) fn deficit(&self) -> f64 {
        let Corner { area, points } = self.nodes[1].deficit;
        area * self.now - points
    }

    /// Adds a point at side number `at`: it is in the closed box of this side and in all boxes of higher ones.
    pub(super) fn add(&mut self, at: usize) {
        let mut node = self.leaves + at;
        self.nodes[node].points += 1.0;
        self.nodes[node].surplus.points += 1.0;
        while node > 1 {
            node /= 2;
            self.join(node);
        }
    }

    /// Lets `t` grow.
    pub(super) fn advance(&mut self, t: f64) {
        self.now = t;
        self.refresh(1);
    }

    fn refresh(&mut self, node: usize) {
        if self.nodes[node].until <= self.now {
            self.refresh(2 * node);
            self.refresh(2 * node + 1);
            self.join(node);
        }
    }

    /// Looks at the two nodes below.
    fn join(&mut self, node: usize) {
        let [low, high] = [self.nodes[2 * node], self.nodes[2 * node + 1]];
        let mut until = low.until.min(high.until);
        // the strip between two boxes holds too many points until its area has grown to them
        let mut crowded = |below: Corner, above: Corner| {
            let (points, area) = (above.points - below.points, above.area - below.area);
            let crowded = points > area * self.now;
            if crowded {
                until = until.min(points / area);
            }
            crowded
        };
        let (closed, open) = (high.surplus.above(low.points), high.deficit.above(low.points));
        let surplus = if crowded(low.surplus, closed) { closed } else { low.surplus };
        let deficit = if crowded(low.deficit, open) { low.deficit } else { open };
        self.nodes[node] = Node { points: low.points + high.points, surplus, deficit, until };
    }
}
