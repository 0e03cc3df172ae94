//! nyquist for the scripts in `python/`: a C interface to what the jobs measure, one job a file.
//!
//! A plan is built by `…_new`, which gives null on bad input, used on `threads` threads and given back to `…_free`. All
//! pointers come from NumPy arrays of the stated lengths, in C order, which the caller keeps alive during the call.

mod fft;
mod film;
mod nonuniform;
mod plane;
mod points;
mod resize;
mod sound;

use std::sync::{LazyLock, Mutex};

/// Runs `work` on a pool of so many threads, which is started once.
fn on<R: Send>(threads: usize, work: impl FnOnce() -> R + Send) -> R {
    type Pools = Vec<(usize, &'static rayon::ThreadPool)>;
    static POOLS: LazyLock<Mutex<Pools>> = LazyLock::new(Mutex::default);
    let pool = {
        let mut pools = POOLS.lock().expect("no thread panics while it holds the list");
        match pools.iter().find(|(count, _)| *count == threads) {
            Some(&(_, pool)) => pool,
            None => {
                let built =
                    rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads can be started");
                let pool: &'static _ = Box::leak(Box::new(built));
                pools.push((threads, pool));
                pool
            }
        }
    };
    pool.install(work)
}

/// A plan on the heap, or null.
fn boxed<T, E>(plan: Result<T, E>) -> *mut T {
    plan.map_or(std::ptr::null_mut(), |plan| Box::into_raw(Box::new(plan)))
}

/// The `len` values at `values`.
///
/// # Safety
/// There are so many, and nobody writes them while the slice lives.
unsafe fn slice<'a, T>(values: *const T, len: usize) -> &'a [T] {
    // SAFETY: promised by the caller
    unsafe { std::slice::from_raw_parts(values, len) }
}

/// The `len` values at `values`, to be written.
///
/// # Safety
/// There are so many, and nobody else uses them while the slice lives.
unsafe fn slice_mut<'a, T>(values: *mut T, len: usize) -> &'a mut [T] {
    // SAFETY: promised by the caller
    unsafe { std::slice::from_raw_parts_mut(values, len) }
}

/// `…_new`, a use and `…_free` of a plan for both widths of numbers.
macro_rules! freed {
    ($($name:ident: $plan:ty),* $(,)?) => {
        $(
            /// Gives the plan back.
            ///
            /// # Safety
            /// It came from `…_new` and is not used again.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn $name(plan: *mut $plan) {
                // SAFETY: promised by the caller
                drop(unsafe { Box::from_raw(plan) });
            }
        )*
    };
}
use freed;
