//! Numbers of two vectors in another order.

use crate::engine::simd::Simd;
use bytemuck::Pod;

/// An order of the numbers of two vectors.
#[derive(Debug, Clone, Copy)]
pub enum Order {
    /// The even ones, then the odd ones.
    Apart,
    /// One of the first, one of the second, and so on: [`Apart`](Self::Apart) undone.
    Together,
    /// Of blocks of `1 << level` numbers every second one of the first and every first one of the second exchanged.
    Exchanged {
        /// The blocks' size.
        level: usize,
    },
}

/// Where number `i` of `2·lanes` comes from.
#[inline(always)]
const fn source(order: Order, lanes: usize, i: usize) -> usize {
    match order {
        Order::Apart => 2 * i % (2 * lanes) + i / lanes,
        Order::Together => i / 2 + lanes * (i % 2),
        Order::Exchanged { level } => {
            let second = i / lanes;
            if (i >> level) & 1 == second { i } else { (i ^ (1 << level)) % lanes + lanes * (1 - second) }
        }
    }
}

/// By element: what the compiler makes of it.
#[inline(always)]
fn each<T: Pod, V: Pod>(both: [V; 2], order: Order) -> [V; 2] {
    let (from, mut to) = (both, both);
    let lanes = size_of::<V>() / size_of::<T>();
    let from: &[T] = bytemuck::cast_slice(&from);
    for (i, to) in bytemuck::cast_slice_mut(&mut to).iter_mut().enumerate() {
        *to = from[source(order, lanes, i)];
    }
    to
}

macro_rules! rearranged {
    ($name:ident, $real:ty, $vector:ident, $permute:ident, $index:ty, $lanes:literal) => {
        #[inline(always)]
        pub(super) fn $name<S: Simd>(simd: S, both: [S::$vector; 2], order: Order) -> [S::$vector; 2] {
            #[cfg(not(target_arch = "x86_64"))]
            let _ = simd;
            #[cfg(target_arch = "x86_64")]
            if let Some(v4) = (&simd as &dyn std::any::Any).downcast_ref::<pulp::x86::V4>() {
                const fn sources(order: Order) -> [[$index; $lanes]; 2] {
                    let mut sources = [[0; $lanes]; 2];
                    let mut i = 0;
                    while i < 2 * $lanes {
                        sources[i / $lanes][i % $lanes] = source(order, $lanes, i) as $index;
                        i += 1;
                    }
                    sources
                }
                let [first, second] = match order {
                    Order::Apart => const { sources(Order::Apart) },
                    Order::Together => const { sources(Order::Together) },
                    Order::Exchanged { level: 0 } => const { sources(Order::Exchanged { level: 0 }) },
                    Order::Exchanged { level: 1 } => const { sources(Order::Exchanged { level: 1 }) },
                    Order::Exchanged { level: 2 } => const { sources(Order::Exchanged { level: 2 }) },
                    Order::Exchanged { .. } => const { sources(Order::Exchanged { level: 3 }) },
                };
                let (a, b) = (bytemuck::cast(both[0]), bytemuck::cast(both[1]));
                return [
                    bytemuck::cast(v4.avx512f.$permute(a, bytemuck::cast(first), b)),
                    bytemuck::cast(v4.avx512f.$permute(a, bytemuck::cast(second), b)),
                ];
            }
            each::<$real, S::$vector>(both, order)
        }
    };
}

rearranged!(rearranged_f32, f32, f32s, _mm512_permutex2var_ps, u32, 16);
rearranged!(rearranged_f64, f64, f64s, _mm512_permutex2var_pd, u64, 8);
