//! Vector instructions, chosen at run time: the only place that knows pulp.
//!
//! A [`Loop`] is plain arithmetic on arrays, element by element, which the compiler vectorises once for every set of
//! instructions. It never fuses a product and a sum, so the bits do not depend on the choice. A [`Task`] holds vectors in
//! its hands, and may fuse where [`Arithmetic`] allows it; with [`Wide`] it is written as arithmetic, too.

mod rearranged;
mod turn;
mod wide;

use pulp::{Arch, NullaryFnOnce};
pub(crate) use pulp::{Simd, WithSimd as Task};
pub(super) use rearranged::Order;
pub(super) use turn::Turn;
pub(super) use wide::{LANES, Wide, turned, unrolled};

/// How products are added.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Arithmetic {
    /// Rounded before they are added: the same bits on every processor.
    Plain,
    /// In one instruction and with one rounding where the processor has it; the last bits depend on that.
    #[default]
    Fused,
}

/// A loop that is worth wide vectors. `run` must be `#[inline(always)]`, and what it calls too.
pub(crate) trait Loop {
    /// The loop.
    fn run(self);
}

struct Dispatched<L>(L);

impl<L: Loop> NullaryFnOnce for Dispatched<L> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        self.0.run();
    }
}

/// Runs a loop with the widest vectors of this processor.
pub(crate) fn vectorised(task: impl Loop) {
    Arch::new().dispatch(Dispatched(task));
}

/// Runs a task with the widest vectors of this processor. Its `with_simd` must be `#[inline(always)]`, and what it calls
/// too.
pub(crate) fn with_vectors<T: Task>(task: T) -> T::Output {
    Arch::new().dispatch(task)
}

/// Bytes of the widest vectors of this processor.
pub(super) fn widest() -> usize {
    struct Bytes;
    impl Task for Bytes {
        type Output = usize;

        #[inline(always)]
        fn with_simd<S: Simd>(self, _: S) -> usize {
            size_of::<S::f32s>()
        }
    }
    with_vectors(Bytes)
}

/// Numbers that processors have vectors of.
pub trait Lanes: bytemuck::Pod {
    /// A vector.
    type Vector<S: Simd>: bytemuck::Pod;

    /// The whole vectors in a slice.
    fn vectors<S: Simd>(values: &[Self]) -> &[Self::Vector<S>];

    /// The whole vectors in a slice.
    fn vectors_mut<S: Simd>(values: &mut [Self]) -> &mut [Self::Vector<S>];

    /// A vector of one number.
    fn splat<S: Simd>(simd: S, value: Self) -> Self::Vector<S>;

    /// `a + b`.
    fn plus<S: Simd>(simd: S, a: Self::Vector<S>, b: Self::Vector<S>) -> Self::Vector<S>;

    /// `a − b`.
    fn minus<S: Simd>(simd: S, a: Self::Vector<S>, b: Self::Vector<S>) -> Self::Vector<S>;

    /// `a·b`.
    fn product<S: Simd>(simd: S, a: Self::Vector<S>, b: Self::Vector<S>) -> Self::Vector<S>;

    /// `a·b + sum`, rounded twice.
    fn add_product<S: Simd>(simd: S, a: Self::Vector<S>, b: Self::Vector<S>, sum: Self::Vector<S>) -> Self::Vector<S>;

    /// `a·b + sum`, rounded once if the processor can.
    fn fuse_product<S: Simd>(simd: S, a: Self::Vector<S>, b: Self::Vector<S>, sum: Self::Vector<S>) -> Self::Vector<S>;

    /// `rest − a·b`, rounded once if the processor can.
    fn fuse_less<S: Simd>(simd: S, a: Self::Vector<S>, b: Self::Vector<S>, rest: Self::Vector<S>) -> Self::Vector<S>;

    /// The numbers of two vectors in another order.
    fn rearranged<S: Simd>(simd: S, both: [Self::Vector<S>; 2], order: Order) -> [Self::Vector<S>; 2];

    #[doc(hidden)]
    fn turn(turn: Turn<'_, Self>);
}

macro_rules! lanes {
    ($real:ty, $vector:ident, $split:ident, $split_mut:ident, $splat:ident, $mul:ident, $add:ident, $sub:ident, $fused:ident, $less:ident, $rearranged:path, $turn:path) => {
        impl Lanes for $real {
            type Vector<S: Simd> = S::$vector;

            #[inline(always)]
            fn vectors<S: Simd>(values: &[Self]) -> &[S::$vector] {
                S::$split(values).0
            }

            #[inline(always)]
            fn vectors_mut<S: Simd>(values: &mut [Self]) -> &mut [S::$vector] {
                S::$split_mut(values).0
            }

            #[inline(always)]
            fn splat<S: Simd>(simd: S, value: Self) -> S::$vector {
                simd.$splat(value)
            }

            #[inline(always)]
            fn plus<S: Simd>(simd: S, a: S::$vector, b: S::$vector) -> S::$vector {
                simd.$add(a, b)
            }

            #[inline(always)]
            fn minus<S: Simd>(simd: S, a: S::$vector, b: S::$vector) -> S::$vector {
                simd.$sub(a, b)
            }

            #[inline(always)]
            fn product<S: Simd>(simd: S, a: S::$vector, b: S::$vector) -> S::$vector {
                simd.$mul(a, b)
            }

            #[inline(always)]
            fn add_product<S: Simd>(simd: S, a: S::$vector, b: S::$vector, sum: S::$vector) -> S::$vector {
                simd.$add(sum, simd.$mul(a, b))
            }

            #[inline(always)]
            fn fuse_product<S: Simd>(simd: S, a: S::$vector, b: S::$vector, sum: S::$vector) -> S::$vector {
                simd.$fused(a, b, sum)
            }

            #[inline(always)]
            fn fuse_less<S: Simd>(simd: S, a: S::$vector, b: S::$vector, rest: S::$vector) -> S::$vector {
                simd.$less(a, b, rest)
            }

            #[inline(always)]
            fn rearranged<S: Simd>(simd: S, both: [S::$vector; 2], order: Order) -> [S::$vector; 2] {
                $rearranged(simd, both, order)
            }

            fn turn(turn: Turn<'_, Self>) {
                $turn(turn);
            }
        }
    };
}

lanes!(
    f32,
    f32s,
    as_simd_f32s,
    as_mut_simd_f32s,
    splat_f32s,
    mul_f32s,
    add_f32s,
    sub_f32s,
    mul_add_e_f32s,
    negate_mul_add_e_f32s,
    rearranged::rearranged_f32,
    turn::turn_f32
);
lanes!(
    f64,
    f64s,
    as_simd_f64s,
    as_mut_simd_f64s,
    splat_f64s,
    mul_f64s,
    add_f64s,
    sub_f64s,
    mul_add_e_f64s,
    negate_mul_add_e_f64s,
    rearranged::rearranged_f64,
    vectorised
);
