//! When the next tick is due.

use std::time::{Duration, Instant};

use crate::wire::Speed;

/// Farther behind than this, lost time is let go instead of being caught up.
const FORGIVEN: Duration = Duration::from_secs(1);

/// An absolute schedule: tick k is due at `start + k · period`, so that waiting too long once does not
/// shift all later ticks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pace {
    /// Time between two ticks; none when there is nothing to wait for.
    period: Option<Duration>,
    due: Instant,
}

impl Pace {
    /// A schedule whose first tick is due now.
    #[must_use]
    pub(super) fn new(speed: Speed, now: Instant) -> Self {
        let period = match speed {
            Speed::TicksPerSecond(rate_hz) => Some(Duration::from_secs_f64(1.0 / rate_hz)),
            Speed::Named(_) => None,
        };
        Self { period, due: now }
    }

    /// How long to wait for the next tick; zero when it is due.
    #[must_use]
    pub(super) fn wait(&self, now: Instant) -> Duration {
        match self.period {
            Some(_) => self.due.saturating_duration_since(now),
            None => Duration::ZERO,
        }
    }

    /// Counts a tick as done.
    pub(super) fn done(&mut self, now: Instant) {
        let Some(period) = self.period else { return };
        self.due += period;
        if now.saturating_duration_since(self.due) > FORGIVEN {
            self.due = now;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::NamedSpeed;

    const TENTH: Duration = Duration::from_millis(100);

    #[test]
    fn a_late_tick_does_not_shift_the_next() {
        let start = Instant::now();
        let mut pace = Pace::new(Speed::TicksPerSecond(10.0), start);
        pace.done(start + TENTH / 2);
        assert_eq!(pace.wait(start + TENTH / 2), TENTH / 2);
        pace.done(start + TENTH * 3);
        assert_eq!(pace.wait(start + TENTH * 3), Duration::ZERO, "it catches up");
    }

    #[test]
    fn more_than_a_second_behind_is_forgiven() {
        let start = Instant::now();
        let mut pace = Pace::new(Speed::TicksPerSecond(10.0), start);
        let late = start + Duration::from_secs(5);
        pace.done(late);
        pace.done(late);
        assert_eq!(pace.wait(late), TENTH);
    }

    #[test]
    fn the_fastest_pace_never_waits() {
        let start = Instant::now();
        let mut pace = Pace::new(Speed::Named(NamedSpeed::Max), start);
        pace.done(start);
        assert_eq!(pace.wait(start), Duration::ZERO);
    }
}
