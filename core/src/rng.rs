//! Random streams, all derived from one seed.
//!
//! The rule: a session has one 64-bit seed. Each use of randomness in each trial has its own
//! `ChaCha8` stream, numbered `trial · 16 + purpose`. So nothing that one use draws can shift another,
//! a trial can be repeated without the ones before it, and a checkpoint holds no generator.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// What a random stream is for. The numbers are part of the reproducibility promise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u64)]
pub enum Purpose {
    /// Noise on sonar readings.
    Sonar = 0,
    /// Drift of the odometry.
    Odometry = 1,
    /// The stochastic unit, Eq. (5.12).
    Exploration = 2,
    /// What sonars hear one after the other: noise, lost echoes, crosstalk.
    Echo = 3,
    /// Where people walk.
    People = 4,
    /// Where a run starts.
    Start = 5,
    /// Noise of the compass.
    Compass = 6,
    /// Choosing an action in a tabular world.
    Selection = 8,
    /// What an action of a stochastic tabular world leads to.
    Transition = 9,
    /// Planning on a learned model.
    Planning = 10,
    /// What a lever pays.
    Payoff = 11,
    /// The means of a bandit's levers.
    Levers = 12,
}

/// The generator for one purpose in one trial (0-based) of a session.
#[must_use]
pub fn stream(seed: u64, trial: u32, purpose: Purpose) -> ChaCha8Rng {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    rng.set_stream(u64::from(trial) * 16 + purpose as u64);
    rng
}

#[cfg(test)]
mod tests {
    use rand::Rng;

    use super::*;

    #[test]
    fn streams_differ_by_seed_trial_and_purpose() {
        let first = |seed, trial, purpose| stream(seed, trial, purpose).next_u64();
        let base = first(1, 0, Purpose::Sonar);
        assert_eq!(base, first(1, 0, Purpose::Sonar));
        assert_ne!(base, first(2, 0, Purpose::Sonar));
        assert_ne!(base, first(1, 1, Purpose::Sonar));
        assert_ne!(base, first(1, 0, Purpose::Exploration));
    }
}
