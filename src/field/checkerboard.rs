//! The checkerboard in perspective, with its exact pixels.

use crate::error::{Error, Result};
use crate::field::checks::{Checks, square_wave, triangle_wave};
use crate::field::perspective::{Camera, Perspective};
use crate::field::{ExactMean, Field, rectangle};

/// An endless checkerboard up to the horizon: the picture that every way of antialiasing is tried on (Duff's sequence,
/// slides «Point vs. Supersampled», «Analytic vs. Supersampled»).
///
/// With the square wave `q` on both axes of the floor the mean over a rectangle of the picture has a closed form: the
/// inner integral along `x` is a difference of triangle waves `Λ`,
///
/// ```text
///             1   1      Y₁               Y
/// mean = ½ − ─── ───  ∫     q(h·f/Y)·─────·[ Λ(h·X₁/Y) − Λ(h·X₀/Y) ] dY
///             2   A     Y₀               h
/// ```
///
/// and between the places where `h·f/Y`, `h·X₀/Y` or `h·X₁/Y` cross an integer the integrand is linear in `Y`, so that
/// the midpoint rule is exact. A rectangle that touches the horizon has infinitely many such places: after
/// [`MOST_PIECES`](Self::MOST_PIECES) the rest counts as ½, and [`mean_error`](Self::mean_error) says what that may cost.
///
/// ```
/// use nyquist::prelude::*;
/// let board = Checkerboard::lecture(128)?;
/// // two rows below the horizon the squares are far smaller than a pixel …
/// assert!((board.mean([20.0, 21.0], [1.0, 2.0]) - 0.5).abs() < 0.02);
/// // … and a sample is still black or white
/// assert!([0.0, 1.0].contains(&board.at(20.5, 1.6)));
/// # Ok::<(), Error>(())
/// ```
pub type Checkerboard = Perspective<Checks>;

impl Perspective<Checks> {
    /// How many pieces are summed for one mean.
    pub const MOST_PIECES: usize = 1 << 17;

    /// The checkerboard of the lecture's comparisons for a picture of `size` × `size` pixels: unit squares, the camera
    /// one unit above the floor, a focal length of half the picture, the horizon at the top row's upper edge.
    ///
    /// # Errors
    /// A size of zero.
    pub fn lecture(size: usize) -> Result<Self> {
        if size == 0 {
            return Err(Error::TooFew { what: "pixels of a checkerboard", least: 1, got: 0 });
        }
        let half = 0.5 * size as f64;
        Self::new(Camera::new(half, 1.0, [half, 0.0])?, Checks::new(1.0)?, 0.5)
    }

    /// What [`mean`](ExactMean::mean) leaves out near the horizon, at most: zero for rectangles that stay clear of it.
    ///
    /// Beyond the last piece, at the distance `δ` below the horizon, the inner integral is at most `Y/h` and at most the
    /// rectangle's width, so that the mean errs by at most `½·min(δ²/2h, δ·ΔX)/A`.
    pub fn mean_error(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        let Ok([x, y]) = rectangle(x, y) else { return 0.0 };
        let (walk, height) = (self.walk(x, y), self.unit_height());
        let area = (x[1] - x[0]) * (y[1] - y[0]);
        match walk.left_out {
            near if near > 0.0 => 0.5 * (0.5 * near * near / height).min(near * (x[1] - x[0])) / area,
            _ => 0.0,
        }
    }

    /// The camera's height in squares.
    fn unit_height(&self) -> f64 {
        self.camera().height() / self.field().size()
    }

    fn walk(&self, x: [f64; 2], y: [f64; 2]) -> Walk {
        let (h, f, [x0, y0]) = (self.unit_height(), self.camera().focal(), self.camera().horizon());
        let x = x.map(|x| x - x0);
        let (near, far) = (y[1] - y0, (y[0] - y0).max(0.0));
        if near <= 0.0 {
            return Walk { sum: 0.0, left_out: 0.0 };
        }
        // v = hf/Y grows towards the horizon; the other two places cross integers at multiples of f/|X|
        let rates = [1.0, x[0].abs() / f, x[1].abs() / f];
        let mut v = h * f / near;
        let mut counts = rates.map(|rate| (v * rate).floor() + 1.0);
        let (mut y, mut sum) = (near, 0.0);
        for _ in 0..Self::MOST_PIECES {
            let next = (0..3).filter(|&i| rates[i] > 0.0).map(|i| counts[i] / rates[i]).fold(f64::INFINITY, f64::min);
            let end = (h * f / next).max(far);
            let middle = 0.5 * (y + end);
            let inner = triangle_wave(h * x[1] / middle) - triangle_wave(h * x[0] / middle);
            sum += square_wave(h * f / middle) * middle / h * inner * (y - end);
            (y, v) = (end, next);
            if y <= far {
                break;
            }
            for i in 0..3 {
                if rates[i] > 0.0 && counts[i] / rates[i] <= v {
                    counts[i] += 1.0;
                }
            }
        }
        Walk { sum, left_out: if y > far { y } else { 0.0 } }
    }
}

/// The integral of the product of the two square waves, and how near to the horizon it stopped (zero if it did not).
struct Walk {
    sum: f64,
    left_out: f64,
}

impl ExactMean for Perspective<Checks> {
    fn mean(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        let [x, y] = match rectangle(x, y) {
            Ok(sides) => sides,
            Err([x, y]) => return self.at(x, y),
        };
        let height = y[1] - y[0];
        let sky = (self.camera().horizon()[1].min(y[1]) - y[0]).max(0.0) / height;
        let floor = 0.5 * (1.0 - sky) - 0.5 * self.walk(x, y).sum / (height * (x[1] - x[0]));
        sky * self.sky() + floor
    }
}
