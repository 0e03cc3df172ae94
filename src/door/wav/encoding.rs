//! How a value is written in bytes.

/// Kinds of samples. All are little-endian; integers are signed but for those of one byte, whose zero is 128.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// One byte, unsigned.
    Int8,
    /// Two bytes: the compact disc's.
    Int16,
    /// Three bytes.
    Int24,
    /// Four bytes.
    Int32,
    /// `f32`.
    Float32,
    /// `f64`.
    Float64,
}

impl Encoding {
    /// All of them, from the smallest.
    pub const ALL: [Self; 6] = [Self::Int8, Self::Int16, Self::Int24, Self::Int32, Self::Float32, Self::Float64];

    /// Bytes a sample.
    pub const fn bytes(self) -> usize {
        match self {
            Self::Int8 => 1,
            Self::Int16 => 2,
            Self::Int24 => 3,
            Self::Int32 | Self::Float32 => 4,
            Self::Float64 => 8,
        }
    }

    /// Bits a sample.
    pub const fn bits(self) -> u16 {
        8 * self.bytes() as u16
    }

    /// Whether samples are floating-point numbers, which have no full scale.
    pub const fn is_float(self) -> bool {
        matches!(self, Self::Float32 | Self::Float64)
    }

    /// The step between neighbouring values, `2^{1−bits}`; zero for floats, whose rounding is relative.
    ///
    /// ```
    /// use nyquist::door::wav::Encoding;
    /// assert_eq!(Encoding::Int16.step(), 1.0 / 32768.0);
    /// ```
    pub fn step(self) -> f64 {
        if self.is_float() { 0.0 } else { 2.0 / (1u64 << self.bits()) as f64 }
    }

    /// The values of whole samples, appended to `values`. Integers are divided by `2^{bits−1}`, so that they lie within
    /// `[−1, 1)`, exactly.
    pub(super) fn decode(self, bytes: &[u8], values: &mut Vec<f64>) {
        let step = self.step();
        let samples = bytes.chunks_exact(self.bytes());
        match self {
            Self::Int8 => values.extend(samples.map(|b| (f64::from(b[0]) - 128.0) * step)),
            Self::Int16 => values.extend(samples.map(|b| f64::from(i16::from_le_bytes([b[0], b[1]])) * step)),
            // as the upper three bytes of four, whose sign is in its place
            Self::Int24 => {
                values.extend(samples.map(|b| f64::from(i32::from_le_bytes([0, b[0], b[1], b[2]]) >> 8) * step));
            }
            Self::Int32 => {
                values.extend(samples.map(|b| f64::from(i32::from_le_bytes([b[0], b[1], b[2], b[3]])) * step));
            }
            Self::Float32 => {
                values.extend(samples.map(|b| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]]))));
            }
            Self::Float64 => {
                values.extend(samples.map(|b| f64::from_le_bytes([b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7]])));
            }
        }
    }

    /// Appends the bytes of the nearest sample to `value + dither` steps; whether `value` itself was outside of the range.
    pub(super) fn encode(self, value: f64, dither: f64, bytes: &mut Vec<u8>) -> bool {
        match self {
            Self::Float64 => {
                bytes.extend(value.to_le_bytes());
                false
            }
            Self::Float32 => {
                let most = f64::from(f32::MAX);
                bytes.extend((value.clamp(-most, most) as f32).to_le_bytes());
                value.abs() > most
            }
            _ => {
                let half = 0.5 / self.step() * 2.0; // 2^{bits−1}
                let (low, high) = (-half, half - 1.0);
                let code = (value * half + dither).round_ties_even().clamp(low, high) as i64;
                match self {
                    Self::Int8 => bytes.push((code + 128) as u8),
                    _ => bytes.extend(&code.to_le_bytes()[..self.bytes()]),
                }
                let plain = (value * half).round_ties_even();
                plain < low || plain > high
            }
        }
    }
}

/// How many samples did not fit into the range of a file, and by how much.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Clipping {
    /// The number of samples that became the largest or the least one.
    pub samples: u64,
    /// The frame of the first of them.
    pub first_frame: Option<u64>,
    /// The largest magnitude of all samples, clipped or not; full scale is 1.
    pub peak: f64,
}
