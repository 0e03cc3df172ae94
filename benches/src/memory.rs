//! Peak memory of a piece of work.

use std::fs;

/// Megabytes by which the process grew at most while `work` ran; nothing where the system does not tell (it does on Linux).
pub fn peak_of(work: impl FnOnce()) -> Option<f64> {
    // 5 sets the recorded peak back to what is used now (proc(5), clear_refs)
    let reset = fs::write("/proc/self/clear_refs", "5");
    let before = status("VmRSS:");
    work();
    reset.ok()?;
    Some((status("VmHWM:")? - before?).max(0.0))
}

fn status(field: &str) -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with(field))?;
    let kilobytes: f64 = line[field.len()..].trim().trim_end_matches(" kB").parse().ok()?;
    Some(kilobytes / 1024.0)
}
