//! Polylines and polygons cut to a rectangle and freed of points that nobody sees, in whole numbers.

use super::scene::Place;

/// A line moves by at most this much when points are left out: 0.05 units.
const TOLERANCE: f64 = 5.0;

/// The parts of the polyline through `points` that lie within the rectangle, `None` for everywhere.
pub(super) fn clipped(points: &[Place], within: Option<(Place, Place)>) -> Vec<Vec<Place>> {
    let Some(within) = within else { return vec![points.to_vec()] };
    let mut parts: Vec<Vec<Place>> = Vec::new();
    let mut open = false; // whether the last part ends where the next segment begins
    for pair in points.windows(2) {
        let Some((a, b, left)) = segment(pair[0], pair[1], within) else {
            open = false;
            continue;
        };
        match parts.last_mut() {
            Some(part) if open && part.last() == Some(&a) => part.push(b),
            _ => parts.push(vec![a, b]),
        }
        open = !left;
    }
    parts
}

/// The part of a segment within a rectangle, and whether its end was cut off (Liang and Barsky 1984).
fn segment(a: Place, b: Place, ((left, top), (right, bottom)): (Place, Place)) -> Option<(Place, Place, bool)> {
    let (ax, ay) = (i64::from(a.0), i64::from(a.1));
    let (dx, dy) = (i64::from(b.0) - ax, i64::from(b.1) - ay);
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    let sides = [
        (-dx, ax - i64::from(left)),
        (dx, i64::from(right) - ax),
        (-dy, ay - i64::from(top)),
        (dy, i64::from(bottom) - ay),
    ];
    for (p, q) in sides {
        if p == 0 {
            if q < 0 {
                return None;
            }
            continue;
        }
        let t = q as f64 / p as f64;
        if p < 0 { enter = enter.max(t) } else { leave = leave.min(t) }
    }
    if enter > leave {
        return None;
    }
    let at = |t: f64| (a.0 + (t * dx as f64).round() as i32, a.1 + (t * dy as f64).round() as i32);
    let start = if enter > 0.0 { at(enter) } else { a };
    let end = if leave < 1.0 { at(leave) } else { b };
    Some((start, end, leave < 1.0))
}

/// The part of a polygon within a rectangle (Sutherland and Hodgman 1974).
pub(super) fn clipped_area(points: &[Place], within: Option<(Place, Place)>) -> Vec<Place> {
    let Some(((left, top), (right, bottom))) = within else { return points.to_vec() };
    let cut = |points: Vec<Place>, inside: &dyn Fn(Place) -> bool, cross: &dyn Fn(Place, Place) -> Place| {
        let mut kept = Vec::with_capacity(points.len() + 4);
        for (i, &b) in points.iter().enumerate() {
            let a = points[if i == 0 { points.len() - 1 } else { i - 1 }];
            if inside(a) != inside(b) {
                kept.push(cross(a, b));
            }
            if inside(b) {
                kept.push(b);
            }
        }
        kept
    };
    let between = |a: i32, b: i32, from: i32, to: i32, at: i32| {
        let part = (f64::from(at) - f64::from(from)) / (f64::from(to) - f64::from(from));
        (f64::from(a) + part * (f64::from(b) - f64::from(a))).round() as i32
    };
    let at_x = |x: i32| move |a: Place, b: Place| (x, between(a.1, b.1, a.0, b.0, x));
    let at_y = |y: i32| move |a: Place, b: Place| (between(a.0, b.0, a.1, b.1, y), y);
    let points = cut(points.to_vec(), &|p| p.0 >= left, &at_x(left));
    let points = cut(points, &|p| p.0 <= right, &at_x(right));
    let points = cut(points, &|p| p.1 >= top, &at_y(top));
    cut(points, &|p| p.1 <= bottom, &at_y(bottom))
}

/// `points` without those that lie within 0.05 units of the line through the others (Douglas and Peucker 1973).
pub(super) fn simplified(points: &[Place]) -> Vec<Place> {
    if points.len() < 3 {
        return points.to_vec();
    }
    let mut keep = vec![false; points.len()];
    keep[0] = true;
    keep[points.len() - 1] = true;
    let mut open = vec![(0, points.len() - 1)];
    while let Some((a, b)) = open.pop() {
        let farthest = (a + 1..b).map(|i| (off(points[i], points[a], points[b]), i));
        let farthest = farthest.fold((0.0, a), |most, this| if this.0 > most.0 { this } else { most });
        if farthest.0 > TOLERANCE * TOLERANCE {
            keep[farthest.1] = true;
            open.push((a, farthest.1));
            open.push((farthest.1, b));
        }
    }
    points.iter().zip(keep).filter_map(|(p, keep)| keep.then_some(*p)).collect()
}

/// The squared distance of `p` from the segment from `a` to `b`.
fn off(p: Place, a: Place, b: Place) -> f64 {
    let v = |p: Place, a: Place| (f64::from(p.0) - f64::from(a.0), f64::from(p.1) - f64::from(a.1));
    let ((px, py), (bx, by)) = (v(p, a), v(b, a));
    let length = bx * bx + by * by;
    let along = px * bx + py * by;
    if along <= 0.0 || length == 0.0 {
        return px * px + py * py;
    }
    if along >= length {
        let (x, y) = (px - bx, py - by);
        return x * x + y * y;
    }
    let across = px * by - py * bx;
    across * across / length
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOX: Option<(Place, Place)> = Some(((0, 0), (100, 100)));

    #[test]
    fn a_line_is_cut_where_it_crosses_and_comes_back_as_a_part_of_its_own() {
        let points = [(-50, 50), (50, 50), (50, 150), (70, 150), (70, 50)];
        assert_eq!(clipped(&points, BOX), [vec![(0, 50), (50, 50), (50, 100)], vec![(70, 100), (70, 50)]]);
        assert_eq!(clipped(&[(-10, -10), (-10, 200)], BOX), Vec::<Vec<Place>>::new());
        assert_eq!(clipped(&points, None), [points.to_vec()]);
    }

    #[test]
    fn an_area_is_cut_to_the_part_inside() {
        let area = clipped_area(&[(50, -100_000_000), (150, 50), (50, 100_000_000), (-50, 50)], BOX);
        assert!(area.iter().all(|p| (0..=100).contains(&p.0) && (0..=100).contains(&p.1)));
        assert!(clipped_area(&[(200, 200), (300, 200), (300, 300)], BOX).is_empty());
    }

    #[test]
    fn points_that_nobody_sees_are_left_out() {
        let straight: Vec<Place> = (0..1000).map(|i| (i, 2 * i + i % 3)).collect();
        assert_eq!(simplified(&straight), [(0, 0), (999, 1998)]);
        let circle: Vec<Place> = (0..=3600)
            .map(|i| f64::from(i) / 3600.0 * std::f64::consts::TAU)
            .map(|t| ((10_000.0 * t.cos()).round() as i32, (10_000.0 * t.sin()).round() as i32))
            .collect();
        let kept = simplified(&circle);
        // A chord that is 5 off its arc of radius 10 000 spans 2·arccos(1 − 5/10 000) = 0.0632: 100 would do, and
        // halving takes at most twice as many.
        assert!((100..200).contains(&kept.len()), "{}", kept.len());
        for p in &circle {
            let nearest = kept.windows(2).map(|w| off(*p, w[0], w[1])).fold(f64::INFINITY, f64::min);
            assert!(nearest <= TOLERANCE * TOLERANCE);
        }
    }
}
