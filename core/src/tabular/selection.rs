//! How an action is chosen: greedy, ε-greedy or softmax, section 3.5 and 4.8.

use super::Exponential;

/// Greatest log-odds that greedy rules follow.
const MOST_ODDS: f64 = 300.0;

/// A rule of selection, with the parameter of the moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Selection {
    /// The best action; several share their chance.
    Greedy,
    /// The best action, or with chance ε any.
    EpsilonGreedy {
        /// ε, 0 to 1.
        epsilon: f64,
    },
    /// Chances in the proportion of `e^{Q/τ}`, Eq. (4.11).
    Softmax {
        /// τ, above 0.
        temperature: f64,
    },
}

/// A parameter out of range.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum SelectionError {
    /// A temperature of 0 or less, or none at all.
    #[error(
        "the temperature must be above 0, not {found}; for no exploration take the greedy rule"
    )]
    Temperature {
        /// What was given.
        found: f64,
    },
    /// ε is no chance.
    #[error("ε must be from 0 to 1, not {found}")]
    Epsilon {
        /// What was given.
        found: f64,
    },
}

impl Selection {
    /// Checks the parameter.
    ///
    /// # Errors
    /// When τ is not above 0 and finite, or ε not from 0 to 1.
    pub fn check(self) -> Result<Self, SelectionError> {
        match self {
            Self::Softmax { temperature } if !(temperature > 0.0 && temperature.is_finite()) => {
                Err(SelectionError::Temperature { found: temperature })
            }
            Self::EpsilonGreedy { epsilon } if !(0.0..=1.0).contains(&epsilon) => {
                Err(SelectionError::Epsilon { found: epsilon })
            }
            good => Ok(good),
        }
    }

    /// Fills in running sums of each action's chance, in some unit; the last is the total, above 0.
    ///
    /// `weights` are factors of the chances; 0 excludes an action, and at least one must be above 0.
    /// `pulls` are log-odds, whatever the temperature: they are added to the exponent of the softmax rule. Greedy
    /// rules follow them where several actions are the best, and in what they try at random; so what has been
    /// learned is never overruled for good.
    pub fn sums(&self, preferences: &[f64], weights: &[f64], pulls: &[f64], sums: &mut Vec<f64>) {
        sums.clear();
        match *self {
            Self::Greedy => greedy(0.0, preferences, weights, pulls, sums),
            Self::EpsilonGreedy { epsilon } => greedy(epsilon, preferences, weights, pulls, sums),
            Self::Softmax { temperature } => {
                softmax(1.0 / temperature, preferences, weights, pulls, sums);
            }
        }
    }
}

/// NOTE: Eq. (4.11) is printed with e^{-Q/τ}, which prefers the worst action and learns nothing; the text
/// around it ("the greedy action is still given the highest selection probability") says e^{+Q/τ}.
fn softmax(inverse: f64, preferences: &[f64], weights: &[f64], pulls: &[f64], sums: &mut Vec<f64>) {
    // Eq. (4.11): p(u) = e^{Q(x,u)/τ} / Σ_v e^{Q(x,v)/τ}
    let chance = |action: usize| {
        if weights[action] > 0.0 {
            let chance = Exponential::of(preferences[action] * inverse + pulls[action]);
            Exponential { mantissa: weights[action] * chance.mantissa, ..chance }
        } else {
            Exponential::NOTHING
        }
    };
    let greatest = (0..preferences.len()).map(|action| chance(action).power).max().unwrap_or(0);
    let mut sum = 0.0;
    for action in 0..preferences.len() {
        sum += chance(action).beside(greatest);
        sums.push(sum);
    }
}

/// Several best actions share their chance: where nothing is known yet, the first would else be taken for
/// ever.
fn greedy(epsilon: f64, preferences: &[f64], weights: &[f64], pulls: &[f64], sums: &mut Vec<f64>) {
    let allowed = |action: usize| weights[action] > 0.0;
    let most = (0..preferences.len())
        .filter(|action| allowed(*action))
        .map(|action| preferences[action])
        .fold(f64::NEG_INFINITY, f64::max);
    let is_best = |action: usize| allowed(action) && preferences[action] >= most;
    let odds =
        |action: usize| weights[action] * libm::exp(pulls[action].clamp(-MOST_ODDS, MOST_ODDS));
    let total = |of: &dyn Fn(usize) -> bool| -> f64 {
        (0..preferences.len()).filter(|action| of(*action)).map(odds).sum()
    };
    let (all, best) = (total(&allowed), total(&is_best));
    let mut sum = 0.0;
    for action in 0..preferences.len() {
        let exploiting = if is_best(action) { (1.0 - epsilon) * odds(action) / best } else { 0.0 };
        sum += epsilon * odds(action) / all + exploiting;
        sums.push(sum);
    }
}

/// The action that a number from 0 (in) to 1 (out) falls on.
#[must_use]
pub fn choose(sums: &[f64], unit: f64) -> usize {
    let last = sums.len() - 1;
    let mark = unit * sums[last];
    sums[..last].iter().map(|sum| usize::from(mark >= *sum)).sum()
}

/// The chances that running sums stand for.
#[must_use]
pub fn chances(sums: &[f64]) -> Vec<f64> {
    let total = sums[sums.len() - 1];
    let mut before = 0.0;
    let mut chances = Vec::with_capacity(sums.len());
    for sum in sums {
        chances.push((sum - before) / total);
        before = *sum;
    }
    chances
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn of(rule: Selection, preferences: &[f64], weights: &[f64], pulls: &[f64]) -> Vec<f64> {
        let mut sums = Vec::new();
        rule.sums(preferences, weights, pulls, &mut sums);
        chances(&sums)
    }

    fn close(found: &[f64], expected: &[f64]) -> bool {
        found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12)
    }

    #[test]
    fn chances_in_closed_form() {
        let softmax = Selection::Softmax { temperature: 0.5 };
        let e = libm::exp;
        let none = [0.0; 3];
        let third = [1.0 / 3.0; 3];
        let sum = e(2.0) + e(4.0) + e(0.0);
        for (rule, q, weights, pulls, expected) in [
            (softmax, [1.0, 1.0, 1.0], [1.0; 3], none, third),
            (softmax, [1.0, 2.0, 0.0], [1.0; 3], none, [e(2.0) / sum, e(4.0) / sum, 1.0 / sum]),
            (
                softmax,
                [1.0, 2.0, 0.0],
                [1.0, 0.0, 1.0],
                none,
                [e(2.0) / (1.0 + e(2.0)), 0.0, 1.0 / (1.0 + e(2.0))],
            ),
            (softmax, [1.0, 1.0, 1.0], [1.0, 0.5, 0.5], none, [0.5, 0.25, 0.25]),
            (softmax, [1e5, 1e5, 0.0], [1.0; 3], none, [0.5, 0.5, 0.0]),
            (softmax, [0.0; 3], [1.0; 3], [libm::log(2.0), 0.0, 0.0], [0.5, 0.25, 0.25]),
            (Selection::Greedy, [1.0, 3.0, 3.0], [1.0; 3], none, [0.0, 0.5, 0.5]),
            (Selection::Greedy, [1.0, 3.0, 3.0], [1.0, 0.0, 1.0], none, [0.0, 0.0, 1.0]),
            (
                Selection::Greedy,
                [1.0, 3.0, 3.0],
                [1.0; 3],
                [9.0, libm::log(3.0), 0.0],
                [0.0, 0.75, 0.25],
            ),
            (
                Selection::EpsilonGreedy { epsilon: 0.3 },
                [1.0, 3.0, 2.0],
                [1.0; 3],
                none,
                [0.1, 0.8, 0.1],
            ),
        ] {
            let found = of(rule, &q, &weights, &pulls);
            assert!(close(&found, &expected), "{rule:?} {q:?} {weights:?}: {found:?}");
        }
    }

    #[test]
    fn a_temperature_must_be_above_0() {
        for temperature in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(Selection::Softmax { temperature }.check().is_err(), "{temperature}");
        }
        assert!(Selection::EpsilonGreedy { epsilon: 1.1 }.check().is_err());
        assert!(Selection::Softmax { temperature: 0.1 }.check().is_ok());
    }

    proptest! {
        #[test]
        fn what_is_excluded_is_never_chosen(
            q in proptest::array::uniform4(-1e3..1e3f64), mask in 1..15usize, at in 0.0..1.0f64,
            temperature in 0.001..100.0f64,
        ) {
            let weights = [0, 1, 2, 3].map(|bit| f64::from(u8::from(mask >> bit & 1 == 1)));
            for rule in [Selection::Softmax { temperature }, Selection::EpsilonGreedy { epsilon: 0.5 }] {
                let mut sums = Vec::new();
                rule.sums(&q, &weights, &[0.0; 4], &mut sums);
                for at in [at, 0.0, 1.0 - f64::EPSILON / 2.0] {
                    prop_assert!(weights[choose(&sums, at)] > 0.0, "{:?} at {}", sums, at);
                }
            }
        }
    }
}
