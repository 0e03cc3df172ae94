//! Direction numbers of Sobol's sequence.

/// How many dimensions there are numbers for.
pub const DIMENSIONS: usize = 32;

/// The polynomial and the first direction numbers of dimensions 1 to 31, counted from zero; dimension 0 is van der
/// Corput's sequence.
///
/// `(s, a, m)`: a primitive polynomial over the field of two elements, `x^s + a₁x^{s−1} + … + a_{s−1}x + 1`, whose inner
/// coefficients are the binary digits of `a`, and odd `m_k < 2^k`. The polynomials stand by degree. Numbers of S. Joe and
/// F. Y. Kuo, *Constructing Sobol' sequences with better two-dimensional projections*, SIAM J. Sci. Comput. 30 (2008),
/// the file `new-joe-kuo-6.21201`, its first 31 rows: chosen so that every pair of dimensions fills the square evenly
/// from few points on. The tests prove that each polynomial is primitive.
pub const JOE_KUO: [(u32, u32, &[u32]); DIMENSIONS - 1] = [
    (1, 0, &[1]),
    (2, 1, &[1, 3]),
    (3, 1, &[1, 3, 1]),
    (3, 2, &[1, 1, 1]),
    (4, 1, &[1, 1, 3, 3]),
    (4, 4, &[1, 3, 5, 13]),
    (5, 2, &[1, 1, 5, 5, 17]),
    (5, 4, &[1, 1, 5, 5, 5]),
    (5, 7, &[1, 1, 7, 11, 19]),
    (5, 11, &[1, 1, 5, 1, 1]),
    (5, 13, &[1, 1, 1, 3, 11]),
    (5, 14, &[1, 3, 5, 5, 31]),
    (6, 1, &[1, 3, 3, 9, 7, 49]),
    (6, 13, &[1, 1, 1, 15, 21, 21]),
    (6, 16, &[1, 3, 1, 13, 27, 49]),
    (6, 19, &[1, 1, 1, 15, 7, 5]),
    (6, 22, &[1, 3, 1, 15, 13, 25]),
    (6, 25, &[1, 1, 5, 5, 19, 61]),
    (7, 1, &[1, 3, 7, 11, 23, 15, 103]),
    (7, 4, &[1, 3, 7, 13, 13, 15, 69]),
    (7, 7, &[1, 1, 3, 13, 7, 35, 63]),
    (7, 8, &[1, 3, 5, 9, 1, 25, 53]),
    (7, 14, &[1, 3, 1, 13, 9, 35, 107]),
    (7, 19, &[1, 3, 1, 5, 27, 61, 31]),
    (7, 21, &[1, 1, 5, 11, 19, 41, 61]),
    (7, 28, &[1, 3, 5, 3, 3, 13, 69]),
    (7, 31, &[1, 1, 7, 13, 1, 19, 1]),
    (7, 32, &[1, 3, 7, 5, 13, 19, 59]),
    (7, 37, &[1, 1, 3, 9, 25, 29, 41]),
    (7, 41, &[1, 3, 5, 13, 23, 1, 55]),
    (7, 42, &[1, 3, 7, 3, 13, 59, 17]),
];

/// The columns of the generator matrices: in each dimension, for each bit of the index, the 32 binary digits which that
/// bit adds (exclusive or), the first digit in the highest bit.
///
/// `v_k = m_k/2^k`, and beyond the given ones `m_k = 2a₁m_{k−1} ⊕ … ⊕ 2^{s−1}a_{s−1}m_{k−s+1} ⊕ 2^s m_{k−s} ⊕ m_{k−s}`
/// (Sobol' 1967; Bratley and Fox 1988).
pub const COLUMNS: [[u32; 32]; DIMENSIONS] = columns();

const fn columns() -> [[u32; 32]; DIMENSIONS] {
    let mut all = [[0; 32]; DIMENSIONS];
    let mut k = 0;
    while k < 32 {
        all[0][k] = 1 << (31 - k);
        k += 1;
    }
    let mut d = 1;
    while d < DIMENSIONS {
        let (degree, inner, first) = JOE_KUO[d - 1];
        let s = degree as usize;
        let mut k = 0;
        while k < 32 {
            all[d][k] = if k < s {
                first[k] << (31 - k)
            } else {
                let mut v = all[d][k - s] ^ (all[d][k - s] >> s);
                let mut j = 1;
                while j < s {
                    if (inner >> (s - 1 - j)) & 1 == 1 {
                        v ^= all[d][k - j];
                    }
                    j += 1;
                }
                v
            };
            k += 1;
        }
        d += 1;
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `x^e` modulo the polynomial, both as bits.
    fn power_of_x(mut e: u32, polynomial: u32, degree: u32) -> u32 {
        let times = |a: u32, b: u32| {
            (0..degree).rev().fold(0, |product, bit| {
                let doubled = product << 1;
                let reduced = if doubled >> degree & 1 == 1 { doubled ^ polynomial } else { doubled };
                if b >> bit & 1 == 1 { reduced ^ a } else { reduced }
            })
        };
        let (mut square, mut result) = (if degree == 1 { 1 } else { 2 }, 1);
        while e > 0 {
            if e & 1 == 1 {
                result = times(result, square);
            }
            square = times(square, square);
            e >>= 1;
        }
        result
    }

    #[test]
    fn every_polynomial_is_primitive_and_stands_once() {
        let mut seen = std::collections::HashSet::new();
        for (degree, inner, first) in JOE_KUO {
            let polynomial = 1 << degree | inner << 1 | 1;
            assert!(seen.insert(polynomial));
            // x generates all 2^s − 1 non-zero residues: its order is divided by no prime too few
            let order = (1u32 << degree) - 1;
            assert_eq!(power_of_x(order, polynomial, degree), 1);
            for prime in (2..=order).filter(|p| order.is_multiple_of(*p) && (2..*p).all(|q| p % q != 0)) {
                assert!(degree == 1 || power_of_x(order / prime, polynomial, degree) != 1, "{degree} {inner}");
            }
            assert_eq!(first.len(), degree as usize);
            assert!(first.iter().zip(1..).all(|(&m, k)| m % 2 == 1 && m < 1 << k));
        }
    }
}
