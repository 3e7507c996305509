//! Work a CPU second: what other processes do meanwhile hardly matters to it.

use std::time::Instant;

use super::Failure;
use crate::process::cpu_seconds;

/// Measurements of a result.
pub(super) const RUNS: usize = 5;
/// CPU seconds of a measurement. The system counts in hundredths.
const WINDOW_S: f64 = 0.5;

/// Operations a CPU second, measured several times. `work` does some, a few milliseconds' worth, and
/// says how many. Where the system does not count CPU time, the clock on the wall must do.
pub(super) fn per_second(
    mut work: impl FnMut() -> Result<u64, Failure>,
) -> Result<Vec<f64>, Failure> {
    let begun = Instant::now();
    let now = || cpu_seconds().unwrap_or_else(|| begun.elapsed().as_secs_f64());
    work()?;
    (0..RUNS).map(|_| measure(&mut work, &now)).collect()
}

#[expect(clippy::cast_precision_loss, reason = "operations are far below 2^53")]
fn measure(
    work: &mut impl FnMut() -> Result<u64, Failure>,
    now: &impl Fn() -> f64,
) -> Result<f64, Failure> {
    let start = next_tick(work, now)?.1;
    let mut operations = 0;
    loop {
        let (done, time) = next_tick(work, now)?;
        operations += done;
        if time - start >= WINDOW_S {
            return Ok(operations as f64 / (time - start));
        }
    }
}

/// Works until the time changes, so that little of a hundredth is lost at either end.
fn next_tick(
    work: &mut impl FnMut() -> Result<u64, Failure>,
    now: &impl Fn() -> f64,
) -> Result<(u64, f64), Failure> {
    let (before, mut operations) = (now(), 0);
    loop {
        operations += work()?;
        let time = now();
        if time > before {
            return Ok((operations, time));
        }
    }
}
