//! What this process uses of the machine, where the system tells (Linux).

use std::fs;

/// Bytes of resident memory.
#[must_use]
pub(crate) fn resident_bytes() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    let kilobytes: u64 = line.trim().trim_end_matches("kB").trim().parse().ok()?;
    Some(kilobytes * 1024)
}

/// Seconds of CPU time, of all threads together.
#[must_use]
pub(crate) fn cpu_seconds() -> Option<f64> {
    /// Clock ticks a second as `/proc` counts them, on every Linux there is.
    const TICKS_HZ: f64 = 100.0;
    let stat = fs::read_to_string("/proc/self/stat").ok()?;
    // The name may hold spaces; the numbers start behind its closing bracket, with field 3.
    let mut fields = stat.rsplit_once(')')?.1.split_whitespace().skip(11);
    let user: u32 = fields.next()?.parse().ok()?;
    let system: u32 = fields.next()?.parse().ok()?;
    Some(f64::from(user + system) / TICKS_HZ)
}
