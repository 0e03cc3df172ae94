//! Points in a grid of buckets that grows with their number: the nearest one in constant time.

/// Points in the unit square, in `side × side` buckets of about one point each.
#[derive(Debug)]
pub(crate) struct Buckets {
    points: Vec<[f64; 2]>,
    side: usize,
    torus: bool,
    /// The newest point of each bucket.
    first: Vec<u32>,
    /// The next older one in the bucket of each point.
    next: Vec<u32>,
}

const NONE: u32 = u32::MAX;

impl Buckets {
    /// None yet; distances are those on the torus if asked for.
    pub(crate) fn new(torus: bool) -> Self {
        Self { points: Vec::new(), side: 1, torus, first: vec![NONE], next: Vec::new() }
    }

    pub(crate) fn into_points(self) -> Vec<[f64; 2]> {
        self.points
    }

    /// Adds a point; four times as many buckets whenever there are more than two points a bucket, so that all moves
    /// together cost as much as the last.
    pub(crate) fn insert(&mut self, point: [f64; 2]) {
        self.points.push(point);
        self.next.push(NONE);
        if self.points.len() > 2 * self.side * self.side {
            self.side *= 2;
            self.first = vec![NONE; self.side * self.side];
            (0..self.points.len()).for_each(|i| self.link(i));
        } else {
            self.link(self.points.len() - 1);
        }
    }

    fn link(&mut self, i: usize) {
        let [x, y] = self.points[i].map(|c| (c * self.side as f64) as usize);
        let bucket = &mut self.first[y * self.side + x];
        self.next[i] = *bucket;
        *bucket = i as u32;
    }

    /// The square of the distance from `place` to the nearest point; or, as soon as it is known not to exceed `enough`,
    /// some number that does not. Infinite if there are no points.
    ///
    /// Rings of buckets from the inside out: what lies beyond ring `r` is at least `r` buckets away.
    pub(crate) fn nearest(&self, place: [f64; 2], enough: f64) -> f64 {
        let side = self.side as i64;
        let [cx, cy] = place.map(|c| (c * side as f64) as i64);
        let rings = if self.torus { side / 2 } else { side };
        let mut best = f64::INFINITY;
        for ring in 0..=rings {
            for dy in -ring..=ring {
                let step = if dy.abs() == ring { 1 } else { 2 * ring };
                let mut dx = -ring;
                while dx <= ring {
                    best = best.min(self.in_bucket(cx + dx, cy + dy, place));
                    dx += step;
                }
            }
            let reach = ring as f64 / side as f64;
            if best <= enough || best <= reach * reach {
                break;
            }
        }
        best
    }

    /// The square of the distance to the nearest point of one bucket; buckets beyond the edge wrap around or are empty.
    fn in_bucket(&self, x: i64, y: i64, place: [f64; 2]) -> f64 {
        let side = self.side as i64;
        let inside = (0..side).contains(&x) && (0..side).contains(&y);
        if !inside && !self.torus {
            return f64::INFINITY;
        }
        let [x, y] = if inside { [x, y] } else { [x.rem_euclid(side), y.rem_euclid(side)] };
        let mut best = f64::INFINITY;
        let mut i = self.first[(y * side + x) as usize];
        while i != NONE {
            let point = self.points[i as usize];
            let [dx, dy] = [0, 1].map(|d| {
                let apart = (point[d] - place[d]).abs();
                if self.torus { apart.min(1.0 - apart) } else { apart }
            });
            best = best.min(dx * dx + dy * dy);
            i = self.next[i as usize];
        }
        best
    }
}
