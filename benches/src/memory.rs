//! Peak memory of a piece of work.

use std::fs;

/// What glibc's allocator is told (mallopt(3), malloc_trim(3)); other systems have none of it.
#[cfg(target_env = "gnu")]
mod heap {
    unsafe extern "C" {
        safe fn mallopt(parameter: i32, value: i32) -> i32;
        safe fn malloc_trim(pad: usize) -> i32;
    }
    const TRIM_THRESHOLD: i32 = -1;
    const MMAP_THRESHOLD: i32 = -3;
    const ARENA_MAX: i32 = -8;

    /// One for all threads: of others not all that is free can be given back.
    pub(super) fn shared() {
        mallopt(ARENA_MAX, 1);
        keeping(true);
    }

    /// Whether what is freed is kept for the next run, as it is after large blocks were freed, or given back at once, as it
    /// is in the beginning.
    pub(super) fn keeping(kept: bool) {
        mallopt(MMAP_THRESHOLD, if kept { 32 << 20 } else { 128 << 10 });
        mallopt(TRIM_THRESHOLD, if kept { 64 << 20 } else { 128 << 10 });
        if !kept {
            malloc_trim(0);
        }
    }
}
#[cfg(not(target_env = "gnu"))]
mod heap {
    pub(super) fn shared() {}
    pub(super) fn keeping(_kept: bool) {}
}

/// To be called before anything is measured, and before there are threads.
pub fn prepare() {
    heap::shared();
}

/// Megabytes by which the process grew at most while `work` ran, code that was loaded meanwhile not counted; nothing where
/// the system does not tell (it does on Linux). What had been freed before is given back first, or it would be used again
/// and not be seen.
pub fn peak_of(work: impl FnOnce()) -> Option<f64> {
    heap::keeping(false);
    // 5 sets the recorded peak back to what is used now (proc(5), clear_refs)
    let reset = fs::write("/proc/self/clear_refs", "5");
    let (before, code) = (status("VmRSS:"), status("RssFile:"));
    work();
    let (peak, loaded) = (status("VmHWM:"), status("RssFile:"));
    heap::keeping(true);
    reset.ok()?;
    Some((peak? - before? - (loaded? - code?)).max(0.0))
}

fn status(field: &str) -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with(field))?;
    let kilobytes: f64 = line[field.len()..].trim().trim_end_matches(" kB").parse().ok()?;
    Some(kilobytes / 1024.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::hint::black_box;

    #[test]
    fn what_is_allocated_is_seen_whether_kept_or_freed_and_as_often_as_it_is_looked_for() {
        let bytes = |megabytes: usize| black_box(vec![1u8; megabytes << 20]);
        // of pages the system counts some dozens late
        let near = |found: Option<f64>, known: f64| found.is_none_or(|found| (found - known).abs() < 1.0);
        for _ in 0..3 {
            let mut kept = Vec::new();
            assert!(near(peak_of(|| drop(bytes(64))), 64.0));
            assert!(near(peak_of(|| kept = bytes(64)), 64.0));
            assert!(near(peak_of(|| drop(black_box(vec![0u8; 64 << 20]))), 0.0)); // nobody writes them
        }
    }
}
