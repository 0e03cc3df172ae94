//! Vectors of space: as much of them as a ray needs.

use std::ops::{Add, Mul, Neg, Sub};

/// A vector or a point of space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::scene) struct Vector(pub(in crate::scene) [f64; 3]);

impl Add for Vector {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a + x, b + y, c + z])
    }
}

impl Sub for Vector {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a - x, b - y, c - z])
    }
}

impl Neg for Vector {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(|part| -part))
    }
}

impl Mul<f64> for Vector {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self(self.0.map(|part| part * factor))
    }
}

impl Vector {
    pub(in crate::scene) fn dot(self, other: Self) -> f64 {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        a * x + b * y + c * z
    }

    pub(in crate::scene) fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    pub(in crate::scene) fn length(self) -> f64 {
        self.dot(self).sqrt()
    }

    /// The same direction with length one; of the zero vector, NaN.
    pub(in crate::scene) fn unit(self) -> Self {
        self * self.length().recip()
    }
}

/// `a` for `share` zero, `b` for one, colour by colour.
pub(in crate::scene) fn mix(a: [f64; 3], b: [f64; 3], share: f64) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] + share * (b[i] - a[i]))
}
