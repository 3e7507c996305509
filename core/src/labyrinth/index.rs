//! The index of table 4.3: the gain in the reduction of the average number of actions.

use super::belief::{Bias, InsightRule, Readings};
use super::episode::Episode;
use crate::stats::Estimate;
use crate::tabular::Exclusion;

/// Episodes of one experiment: "all points on the curves are cumulative averages of ten episodes".
pub const EPISODES: usize = 10;

/// The index of a bias, with what it was made of. Percentages.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gain {
    /// Eq. (4.13) from the mean J of all episodes, with the 95 % interval of its mean over experiments.
    pub mean: Estimate,
    /// 5th percentile of experiments of ten episodes.
    pub low: f64,
    /// 95th percentile.
    pub high: f64,
    /// J of the bias.
    pub index: f64,
    /// J of the unbiased learner.
    pub unbiased: f64,
}

/// Eq. (4.13) of every experiment of ten episodes, percent, against the unbiased learner's in the same place.
#[must_use]
pub fn gains(biased: &[Episode], unbiased: &[Episode]) -> Vec<f64> {
    let pairs = biased.chunks_exact(EPISODES).zip(unbiased.chunks_exact(EPISODES));
    pairs.map(|(biased, unbiased)| percent(index(biased), index(unbiased))).collect()
}

/// Eq. (4.13) over episodes of a bias and of the unbiased learner; none of fewer than two experiments of ten
/// episodes.
#[must_use]
pub fn gain(biased: &[Episode], unbiased: &[Episode]) -> Option<Gain> {
    let experiments = gains(biased, unbiased);
    let spread = Estimate::mean(&experiments)?;
    let (index_b, index_0) = (index(biased), index(unbiased));
    let value = percent(index_b, index_0);
    let half = (spread.high - spread.low) / 2.0;
    let mean = Estimate { value, low: value - half, high: value + half, n: spread.n };
    let mut sorted = experiments;
    sorted.sort_by(f64::total_cmp);
    let last = sorted.len() - 1;
    let (low, high) = (sorted[last / 20], sorted[last - last / 20]);
    Some(Gain { mean, low, high, index: index_b, unbiased: index_0 })
}

/// Mean J of episodes.
#[expect(clippy::cast_precision_loss, reason = "far fewer episodes than 2^53")]
fn index(episodes: &[Episode]) -> f64 {
    episodes.iter().map(Episode::index).sum::<f64>() / episodes.len() as f64
}

fn percent(biased: f64, unbiased: f64) -> f64 {
    // Eq. (4.13): r = 1 − J(B_i)/J(B_0)
    100.0 * (1.0 - biased / unbiased)
}

/// Published index of a bias, percent; none for the unbiased learner.
#[must_use]
pub fn published(bias: Bias) -> Option<f64> {
    match bias {
        Bias::B0 => None,
        Bias::B10 => Some(22.7),
        Bias::B11 => Some(41.7),
        Bias::B2 => Some(45.3),
        Bias::B30 => Some(23.9),
        Bias::B31 => Some(75.9),
    }
}

/// One row of the reproduction of table 4.3: a bias in one reading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contestant {
    /// The bias.
    pub bias: Bias,
    /// How its definition is read.
    pub readings: Readings,
    /// What its beliefs do.
    pub exclusion: Exclusion,
    /// The reading, in words.
    pub reading: &'static str,
    /// Whether the reading is the literal one; the others were chosen because the literal ones fail.
    pub literal: bool,
}

/// Every row that can be compared with table 4.3: the literal readings first.
///
/// NOTE: the literal B2 and B11 do not reproduce. Without a turn in every second state the walker of B2 is
/// turned back, so that its search gets longer; and the 0.5 of B11 as a first Q-value is lost at the high
/// temperatures that the unbiased learner's J of 20.75 or more demands.
#[must_use]
pub fn table_4_3() -> Vec<Contestant> {
    let readings = Readings::default();
    let literal = |bias, reading| Contestant {
        bias,
        readings,
        exclusion: Exclusion::Strict,
        reading,
        literal: true,
    };
    let insight = |insight, reading, literal| Contestant {
        bias: Bias::B2,
        readings: Readings { insight, ..readings },
        exclusion: Exclusion::Strict,
        reading,
        literal,
    };
    let weighted = |lowered, reading| Contestant {
        bias: Bias::B11,
        readings: Readings { lowered, ..readings },
        exclusion: Exclusion::Weight,
        reading,
        literal: false,
    };
    vec![
        literal(Bias::B0, "all beliefs 1"),
        literal(Bias::B10, "collisions excluded"),
        literal(Bias::B11, "0.5 as first Q-value, as printed"),
        insight(InsightRule::GoalDirected, "{right right} towards the goal left out", true),
        literal(Bias::B30, "near vector fields, all else excluded there"),
        literal(Bias::B31, "far vector fields, all else excluded there"),
        insight(InsightRule::West, "{right right} from west to east left out in every cell", true),
        weighted(0.5, "0.5 multiplies the chance too"),
        weighted(0.75, "0.75 in its place, fitted"),
        insight(
            InsightRule::Away,
            "{right right} away from the goal left out, against figure 4.8",
            false,
        ),
        insight(InsightRule::Turns, "turns away from the goal left out, against figure 4.8", false),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_index_by_hand() {
        let episode = |steps: u32| Episode { steps: vec![steps, steps + 2], capped: 0 };
        let biased: Vec<Episode> = (0..20).map(|at| episode(4 + 2 * (at / 10))).collect();
        let unbiased = vec![episode(9); 20];
        let found = gain(&biased, &unbiased).expect("two experiments");
        // J = 5 and 7 in the two experiments, against 10: gains of 50 % and 30 %.
        assert!((found.mean.value - 40.0).abs() < 1e-9 && (found.unbiased - 10.0).abs() < 1e-12);
        assert_eq!(gains(&biased, &unbiased).len(), 2);
        assert!((found.low - 30.0).abs() < 1e-9 && (found.high - 50.0).abs() < 1e-9);
        assert_eq!(
            gain(&biased[..19], &unbiased),
            None,
            "one experiment says nothing of their spread"
        );
        assert!((episode(9).tail(1) - 11.0).abs() < 1e-12);
    }
}
