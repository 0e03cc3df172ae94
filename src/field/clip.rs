//! Area of a rectangle cut by straight lines.

/// The closed half-plane `normal·p ≤ offset`, the normal of length one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Side {
    pub(super) normal: [f64; 2],
    pub(super) offset: f64,
}

impl Side {
    /// How far outside a point is; negative inside.
    pub(super) fn outside(&self, [x, y]: [f64; 2]) -> f64 {
        self.normal[0] * x + self.normal[1] * y - self.offset
    }
}

/// The part of the rectangle's area that lies within all `sides`: clipping by one line after another (Sutherland and
/// Hodgman 1974) and the shoelace formula, in coordinates from the rectangle's middle.
///
/// What rounding leaves is about `4ε·sides·(1 + |offset|/Δ)`, with `Δ` the shorter side of the rectangle: the offset of a
/// line is rounded before it is cut with.
pub(super) fn coverage([[x0, x1], [y0, y1]]: [[f64; 2]; 2], sides: &[Side]) -> f64 {
    let (cx, cy) = (0.5 * (x0 + x1), 0.5 * (y0 + y1));
    let (w, h) = (0.5 * (x1 - x0), 0.5 * (y1 - y0));
    let mut polygon = vec![[-w, -h], [w, -h], [w, h], [-w, h]];
    for side in sides {
        let local = Side { normal: side.normal, offset: -side.outside([cx, cy]) };
        // how far the farthest corner reaches out, and the nearest
        let reach = local.normal[0].abs() * w + local.normal[1].abs() * h;
        if reach <= local.offset {
            continue;
        }
        if -reach >= local.offset {
            return 0.0;
        }
        polygon = clipped(&polygon, local);
        if polygon.len() < 3 {
            return 0.0;
        }
    }
    (area(&polygon) / (4.0 * w * h)).clamp(0.0, 1.0)
}

/// The polygon's part within one side.
pub(super) fn clipped(polygon: &[[f64; 2]], side: Side) -> Vec<[f64; 2]> {
    let mut kept = Vec::with_capacity(polygon.len() + 2);
    let mut previous = polygon[polygon.len() - 1];
    let mut before = side.outside(previous);
    for &point in polygon {
        let now = side.outside(point);
        if (before > 0.0) != (now > 0.0) {
            let t = before / (before - now);
            kept.push([previous[0] + t * (point[0] - previous[0]), previous[1] + t * (point[1] - previous[1])]);
        }
        if now <= 0.0 {
            kept.push(point);
        }
        (previous, before) = (point, now);
    }
    kept
}

/// `½ Σ (x_i y_{i+1} − x_{i+1} y_i)`, from the first vertex: positive for a turn from the x axis towards the y axis.
pub(super) fn area(polygon: &[[f64; 2]]) -> f64 {
    let [x0, y0] = polygon[0];
    let from = |p: [f64; 2]| [p[0] - x0, p[1] - y0];
    let twice: f64 = polygon
        .windows(2)
        .map(|w| {
            let ([ax, ay], [bx, by]) = (from(w[0]), from(w[1]));
            ax * by - bx * ay
        })
        .sum();
    0.5 * twice
}
