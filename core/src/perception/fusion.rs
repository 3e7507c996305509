//! Fusion: from readings to region depths, by every method at once (section 2.4).
//!
//! All methods are computed in every cycle, whichever drives, so that they can be compared side by side
//! and the method can be changed during a run.

use super::{Gains, Hashing, MedianRank, ReadingError, Snapshot};

crate::choice! {
    /// How a region's depth is made from the readings of its sonars.
    pub enum Method {
        Minimum = "minimum": "the least reading, Eq. (2.1), as Reignier proposed",
        MinimumKalman = "minimum-kalman": "Algorithm 1 over the window of least readings",
        Median = "median": "the median reading, Eq. (2.2)",
        MedianKalman = "median-kalman": "Algorithm 1 over the window of median readings, as the thesis proposes",
        MedianWalk = "median-walk": "the general Kalman filter of chapter 1 over all median readings, the depth walking at random",
    }
}

impl Method {
    /// All of them, in the order of [`RegionDepth::depths_m`].
    pub const ALL: [Self; 5] =
        [Self::Minimum, Self::MinimumKalman, Self::Median, Self::MedianKalman, Self::MedianWalk];
}

/// How depths are made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FusionRule {
    /// Which of an even number of readings is the median.
    pub rank: MedianRank,
    /// n of Algorithm 1, at least 1: the window holds n + 1 readings, z(t − n) to z(t).
    pub window: usize,
    /// ς, standard deviation of a reading, metres, above 0; see [`super::Calibration`].
    pub deviation_m: f64,
    /// Standard deviation by which a depth walks from cycle to cycle ([`Method::MedianWalk`]), metres.
    pub walk_m: f64,
}

/// The depth of a region.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RegionDepth {
    /// Sonars that answer.
    pub live: usize,
    /// By each method of [`Method::ALL`], metres.
    pub depths_m: [f64; Method::ALL.len()],
    /// σ of Algorithm 1 after the window, metres.
    pub deviation_m: f64,
    /// σ of the random walk, metres.
    pub walk_deviation_m: f64,
    /// Innovation of the median by what Algorithm 1 expected, squared and over its variance; none of the
    /// first reading.
    pub nis: Option<f64>,
}

/// What is kept of a region from cycle to cycle.
#[derive(Clone, Debug, Default, PartialEq)]
struct Kept {
    /// Least and median reading, the oldest first.
    window: Vec<[f64; 2]>,
    /// Mean and variance of the random walk.
    walk: Option<(f64, f64)>,
}

/// Fusion at work.
#[derive(Clone, Debug, PartialEq)]
pub struct Fusion {
    hashing: Hashing,
    rule: FusionRule,
    gains: Gains,
    kept: Vec<Kept>,
}

impl RegionDepth {
    /// By one method, metres.
    #[must_use]
    pub fn by(&self, method: Method) -> f64 {
        self.depths_m[method as usize]
    }
}

impl Fusion {
    /// A fusion that has read nothing yet.
    ///
    /// # Panics
    /// When the window is 0 or the deviation of a reading not above 0.
    #[must_use]
    pub fn new(hashing: Hashing, rule: FusionRule) -> Self {
        assert!(rule.window > 0, "the window must be at least 1");
        let gains = Gains::algorithm_1(rule.deviation_m * rule.deviation_m, rule.window + 1);
        let kept = vec![Kept::default(); hashing.regions().len()];
        Self { hashing, rule, gains, kept }
    }

    /// The regions.
    #[must_use]
    pub fn hashing(&self) -> &Hashing {
        &self.hashing
    }

    /// Takes in a cycle's readings in metres; the depth of each region, none where every sonar is silent.
    ///
    /// # Errors
    /// When a sonar that answers gives no distance; nothing is taken in then.
    pub fn take(
        &mut self,
        readings_m: &[f64],
        silent: &[bool],
    ) -> Result<Vec<Option<RegionDepth>>, ReadingError> {
        let read = self.hashing.read(readings_m, silent, self.rule.rank)?;
        let regions = read.into_iter().enumerate();
        Ok(regions.map(|(region, read)| self.depth(region, read)).collect())
    }

    fn depth(&mut self, region: usize, read: Option<Snapshot>) -> Option<RegionDepth> {
        let kept = &mut self.kept[region];
        let Some(Snapshot { live, minimum_m, median_m }) = read else {
            *kept = Kept::default();
            return None;
        };
        let nis = nis(&self.gains, &kept.window, self.rule.deviation_m, median_m);
        if kept.window.len() > self.rule.window {
            kept.window.remove(0);
        }
        kept.window.push([minimum_m, median_m]);
        let [minimum_kalman_m, median_kalman_m] = self.gains.estimate(&kept.window);
        let (walk_m, walk_variance) = walked(&self.rule, kept.walk, median_m);
        kept.walk = Some((walk_m, walk_variance));
        Some(RegionDepth {
            live,
            depths_m: [minimum_m, minimum_kalman_m, median_m, median_kalman_m, walk_m],
            deviation_m: libm::sqrt(self.gains.variance(kept.window.len())),
            walk_deviation_m: libm::sqrt(walk_variance),
            nis,
        })
    }
}

/// Normalised innovation squared of a reading after those of a window: ν² / (σ² + ς²), which is χ² with
/// one degree of freedom where the filter's assumptions hold.
fn nis(gains: &Gains, window: &[[f64; 2]], deviation_m: f64, reading_m: f64) -> Option<f64> {
    // A full window loses its oldest reading before the next comes in.
    let expected_by = if window.len() == gains.readings() { &window[1..] } else { window };
    if expected_by.is_empty() {
        return None;
    }
    let innovation_m = reading_m - gains.estimate(expected_by)[1];
    let variance = gains.variance(expected_by.len()) + deviation_m * deviation_m;
    Some(innovation_m * innovation_m / variance)
}

/// One step of the scalar filter of Eq. (1.5)-(1.8) over a random walk: mean and variance.
fn walked(rule: &FusionRule, before: Option<(f64, f64)>, reading_m: f64) -> (f64, f64) {
    let measurement = rule.deviation_m * rule.deviation_m;
    let Some((mean_m, variance)) = before else { return (reading_m, measurement) };
    let gains = Gains::new(variance, rule.walk_m * rule.walk_m, measurement, 2);
    (gains.estimate(&[[mean_m], [reading_m]])[0], gains.variance(2))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const RULE: FusionRule =
        FusionRule { rank: MedianRank::Lower, window: 3, deviation_m: 0.3, walk_m: 0.04 };

    fn fusion() -> Fusion {
        Fusion::new(Hashing::even(1, 3, true).expect("three sonars"), RULE)
    }

    #[test]
    fn every_method_by_hand() {
        let mut fusion = fusion();
        let snapshots =
            [[1.0, 1.2, 0.2], [1.0, 1.1, 1.3], [0.9, 0.8, 2.0], [0.7, 0.8, 0.9], [0.6, 0.7, 0.8]];
        let mut depth = None;
        for readings_m in snapshots {
            depth = fusion.take(&readings_m, &[false; 3]).expect("distances")[0];
        }
        let depth = depth.expect("live");
        let minimum_kalman = (1.0 + 0.8 + 0.7 + 0.6) / 4.0;
        let median_kalman = (1.1 + 0.9 + 0.8 + 0.7) / 4.0;
        for (method, expected) in [
            (Method::Minimum, 0.6),
            (Method::MinimumKalman, minimum_kalman),
            (Method::Median, 0.7),
            (Method::MedianKalman, median_kalman),
        ] {
            assert!((depth.by(method) - expected).abs() < 1e-12, "{method:?}");
        }
        assert!((depth.deviation_m - 0.3 / 2.0).abs() < 1e-12);
        // The last median against the mean of the three before, of variance ς²/3.
        let innovation = 0.7 - (1.1 + 0.9 + 0.8) / 3.0;
        let expected = innovation * innovation / (0.09 / 3.0 + 0.09);
        assert!((depth.nis.expect("not the first") - expected).abs() < 1e-12);
    }

    #[test]
    fn a_region_without_a_live_sensor_has_no_depth_and_begins_anew() {
        let mut fusion = fusion();
        let take = |fusion: &mut Fusion, silent: [bool; 3]| {
            fusion.take(&[1.0; 3], &silent).expect("distances")[0]
        };
        assert_eq!(take(&mut fusion, [false; 3]).map(|depth| depth.live), Some(3));
        assert_eq!(take(&mut fusion, [false, true, true]).map(|depth| depth.live), Some(1));
        assert_eq!(take(&mut fusion, [true; 3]), None);
        let again = take(&mut fusion, [false; 3]).expect("live");
        assert_eq!((again.nis, again.deviation_m), (None, 0.3));
    }

    proptest! {
        #[test]
        fn innovations_of_normal_readings_are_consistent(seed in 0..20u64) {
            use rand_distr::{Distribution, Normal};
            use crate::perception::Consistency;
            let mut rng = crate::rng::stream(seed, 0, crate::rng::Purpose::Echo);
            let normal = Normal::new(1.0, 0.1).expect("a deviation");
            let rule = FusionRule { deviation_m: 0.1, ..RULE };
            let mut fusion = Fusion::new(Hashing::even(1, 1, true).expect("one"), rule);
            let mut consistency = Consistency::default();
            for cycle in 0..400 {
                let readings_m = [f64::max(normal.sample(&mut rng), 0.0)];
                let depth = fusion.take(&readings_m, &[false]).expect("distances")[0].expect("live");
                // Windows overlap, so only every fourth is independent.
                if cycle % 4 == 3 {
                    consistency.take(depth.nis.expect("not the first"));
                }
            }
            let mean = consistency.mean().expect("a hundred");
            // Five deviations of a mean of 100 values of χ², variance 2.
            prop_assert!((mean - 1.0).abs() < 5.0 * (2.0_f64 / 100.0).sqrt(), "{mean}");
        }
    }
}
