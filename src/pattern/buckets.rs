//! Points in a grid of buckets that grows with their number: the nearest one in constant time.

/// Points in the unit square, in `side × side` buckets of one point each at most, in the mean.
#[derive(Debug)]
pub(crate) struct Buckets {
    points: Vec<[f64; 2]>,
    side: usize,
    torus: bool,
    /// The newest point of each bucket.
    newest: Vec<Link>,
    /// Those that have been the newest before.
    older: Vec<Link>,
}

/// A point, here and not by its number, since memory is what looking for it costs; and the next older one of its bucket.
#[derive(Debug, Clone, Copy)]
struct Link {
    point: [f64; 2],
    next: u32,
}

/// No point: infinitely far away, and none older.
const NONE: Link = Link { point: [f64::INFINITY; 2], next: u32::MAX };

impl Buckets {
    /// None yet; distances are those on the torus if asked for.
    pub(crate) fn new(torus: bool) -> Self {
        Self { points: Vec::new(), side: 1, torus, newest: vec![NONE], older: Vec::new() }
    }

    pub(crate) fn into_points(self) -> Vec<[f64; 2]> {
        self.points
    }

    /// Adds a point; four times as many buckets whenever there are more points than buckets, so that all moves together
    /// cost as much as the last.
    pub(crate) fn insert(&mut self, point: [f64; 2]) {
        self.points.push(point);
        if self.points.len() > self.side * self.side {
            self.side *= 2;
            self.newest = vec![NONE; self.side * self.side];
            self.older.clear();
            (0..self.points.len()).for_each(|i| self.link(self.points[i]));
        } else {
            self.link(point);
        }
    }

    fn link(&mut self, point: [f64; 2]) {
        let [x, y] = self.bucket(point);
        let newest = &mut self.newest[y as usize * self.side + x as usize];
        let before = std::mem::replace(newest, Link { point, next: NONE.next });
        if before.point[0] < f64::INFINITY {
            newest.next = self.older.len() as u32;
            self.older.push(before);
        }
    }

    fn bucket(&self, place: [f64; 2]) -> [i64; 2] {
        place.map(|c| (c * self.side as f64) as i64)
    }

    /// The square of the distance from `place` to the nearest point of its own bucket, infinite if there is none.
    pub(crate) fn nearest_inside(&self, place: [f64; 2]) -> f64 {
        self.in_bucket(self.bucket(place), place)
    }

    /// The square of the distance from `place` to the nearest point, given that to the nearest
    /// [inside](Self::nearest_inside); or, as soon as it is known not to exceed `enough`, some number that does not.
    /// Infinite if there are no points.
    ///
    /// Rings of buckets from the inside out: what lies beyond ring `r` is at least `r` buckets away.
    pub(crate) fn nearest(&self, place: [f64; 2], inside: f64, enough: f64) -> f64 {
        let side = self.side as i64;
        let [cx, cy] = self.bucket(place);
        let rings = if self.torus { side / 2 } else { side };
        let mut best = inside;
        for ring in 1..=rings {
            let reach = (ring - 1) as f64 / side as f64;
            if best <= enough || best <= reach * reach {
                break;
            }
            for dy in -ring..=ring {
                let step = if dy.abs() == ring { 1 } else { 2 * ring };
                let mut dx = -ring;
                while dx <= ring {
                    best = best.min(self.in_bucket([cx + dx, cy + dy], place));
                    dx += step;
                }
            }
        }
        best
    }

    /// The square of the distance to the nearest point of one bucket; buckets beyond the edge wrap around or are empty.
    fn in_bucket(&self, [x, y]: [i64; 2], place: [f64; 2]) -> f64 {
        let side = self.side as i64;
        let inside = (0..side).contains(&x) && (0..side).contains(&y);
        if !inside && !self.torus {
            return f64::INFINITY;
        }
        let [x, y] = if inside { [x, y] } else { [x.rem_euclid(side), y.rem_euclid(side)] };
        let mut link = &self.newest[(y * side + x) as usize];
        let mut best = f64::INFINITY;
        loop {
            let [dx, dy] = [0, 1].map(|d| {
                let apart = (link.point[d] - place[d]).abs();
                if self.torus { apart.min((1.0 - apart).abs()) } else { apart }
            });
            best = best.min(dx * dx + dy * dy);
            match self.older.get(link.next as usize) {
                Some(older) => link = older,
                None => return best,
            }
        }
    }
}
