//! What a sample says about the population it was drawn from, and about a published figure.
//!
//! Symbols: n sample size, x̄ mean, s² sample variance (divisor n − 1), ν = n − 1 degrees of freedom.
//! Intervals are two-sided with 95 % confidence. Those of a mean and of a variance assume that the
//! quantity is near normal; that of a mean forgives much in large samples, that of a variance little.

mod distribution;

pub use distribution::{beta_quantile, chi_square_quantile, t_quantile};

/// Probability left out at each end of an interval.
const TAIL: f64 = 0.025;
/// Least sample that may support a verdict: the thesis repeats its experiment in ten sets.
pub const LEAST_SAMPLE: usize = 10;
/// Widest interval that may support agreement, as a share of the published value's magnitude.
pub const WIDEST_INTERVAL: f64 = 0.5;

/// Mean; none of an empty sample.
#[must_use]
pub fn mean(sample: &[f64]) -> Option<f64> {
    (!sample.is_empty()).then(|| sample.iter().sum::<f64>() / count(sample.len()))
}

/// Sample variance s², divisor n − 1; none of fewer than two values.
#[must_use]
pub fn variance(sample: &[f64]) -> Option<f64> {
    if sample.len() < 2 {
        return None;
    }
    let mean = mean(sample)?;
    let squares: f64 = sample.iter().map(|value| (value - mean) * (value - mean)).sum();
    Some(squares / (count(sample.len()) - 1.0))
}

/// Median, between the middle two when their number is even; none of an empty sample.
#[must_use]
pub fn median(sample: &[f64]) -> Option<f64> {
    let mut sorted = sample.to_vec();
    sorted.sort_by(f64::total_cmp);
    let upper = *sorted.get(sorted.len() / 2)?;
    if sorted.len() % 2 == 1 {
        return Some(upper);
    }
    Some(f64::midpoint(sorted[sorted.len() / 2 - 1], upper))
}

/// A quantity estimated from a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Estimate, in the quantity's unit.
    pub value: f64,
    /// Lower end of the 95 % interval.
    pub low: f64,
    /// Upper end of the 95 % interval.
    pub high: f64,
    /// Sample size.
    pub n: usize,
}

impl Estimate {
    /// Mean with Student's interval, x̄ ± t₀.₉₇₅(ν) s/√n; none of fewer than two values.
    #[must_use]
    pub fn mean(sample: &[f64]) -> Option<Self> {
        let (value, variance) = (mean(sample)?, variance(sample)?);
        let n = sample.len();
        let half = t_quantile(1.0 - TAIL, count(n - 1)) * libm::sqrt(variance / count(n));
        Some(Self { value, low: value - half, high: value + half, n })
    }

    /// Median with the interval between two order statistics that holds it with 95 % confidence
    /// whatever the distribution; the least and the greatest value where the sample is too small for
    /// that. None of an empty sample.
    #[must_use]
    pub fn median(sample: &[f64]) -> Option<Self> {
        Some(Self { value: median(sample)?, ..Self::quantile(sample, 0.5)? })
    }

    /// The value that a share of the population (above 0 and below 1) lies below, between the two values
    /// nearest to it, with the interval between two order statistics that holds it with 95 % confidence
    /// whatever the distribution; the least and the greatest value where the sample is too small for
    /// that. None of an empty sample.
    #[must_use]
    pub fn quantile(sample: &[f64], share: f64) -> Option<Self> {
        let sorted = sorted(sample);
        let n = sorted.len();
        let value = between(&sorted, share)?;
        let (below, above) = (ranks_below(n, share), ranks_below(n, 1.0 - share));
        Some(Self { value, low: sorted[below], high: sorted[n - 1 - above], n })
    }

    /// One value of the population, not its mean: the median, with the interval in which the middle 95 %
    /// of the sample lie, and so, for a large sample, one more value with 95 % probability. None of an
    /// empty sample.
    #[must_use]
    pub fn single(sample: &[f64]) -> Option<Self> {
        let sorted = sorted(sample);
        let end = |share| between(&sorted, share);
        Some(Self {
            value: median(sample)?,
            low: end(TAIL)?,
            high: end(1.0 - TAIL)?,
            n: sorted.len(),
        })
    }

    /// Variance with the interval ν s²/χ²₀.₉₇₅(ν) to ν s²/χ²₀.₀₂₅(ν); none of fewer than two values.
    #[must_use]
    pub fn variance(sample: &[f64]) -> Option<Self> {
        let value = variance(sample)?;
        let freedom = count(sample.len() - 1);
        let end = |probability| freedom * value / chi_square_quantile(probability, freedom);
        Some(Self { value, low: end(1.0 - TAIL), high: end(TAIL), n: sample.len() })
    }

    /// Share of `n` attempts that succeeded, with the exact interval of Clopper and Pearson; none of
    /// no attempts or of more successes than attempts.
    #[must_use]
    pub fn proportion(successes: usize, n: usize) -> Option<Self> {
        if n == 0 || successes > n {
            return None;
        }
        let (k, failures) = (count(successes), count(n - successes));
        let low = if successes == 0 { 0.0 } else { beta_quantile(TAIL, k, failures + 1.0) };
        let high = if successes == n { 1.0 } else { beta_quantile(1.0 - TAIL, k + 1.0, failures) };
        Some(Self { value: k / count(n), low, high, n })
    }

    /// The same in another unit, `factor` (above 0) of which make one of this.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        let Self { value, low, high, n } = self;
        Self { value: value * factor, low: low * factor, high: high * factor, n }
    }
}

fn sorted(sample: &[f64]) -> Vec<f64> {
    let mut sorted = sample.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted
}

/// The quantile of a sorted sample, linear between two neighbours; none of an empty one.
fn between(sorted: &[f64], share: f64) -> Option<f64> {
    let place = share * count(sorted.len().checked_sub(1)?);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to n - 1")]
    let below = place as usize;
    let (low, high) = (sorted[below], sorted[(below + 1).min(sorted.len() - 1)]);
    Some(low + (high - low) * (place - count(below)))
}

/// Values that may be left out at the lower end of a sorted sample of `n` so that the rest still holds the
/// quantile of a share p with 97.5 % confidence: the greatest k with P(B ≤ k) ≤ 0.025, B binomial with n
/// and p.
fn ranks_below(n: usize, share: f64) -> usize {
    // ln P(B = k), so that large samples do not underflow.
    let mut term = count(n) * libm::log1p(-share);
    let (mut tail, mut ranks) = (libm::exp(term), 0);
    let odds = share / (1.0 - share);
    while tail <= TAIL && ranks + 1 < n {
        ranks += 1;
        term += libm::log(odds * count(n - ranks + 1) / count(ranks));
        tail += libm::exp(term);
    }
    ranks.saturating_sub(1)
}

/// A bound that a quantity has to keep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// It must not be less.
    AtLeast(f64),
    /// It must not be greater.
    AtMost(f64),
}

impl Bound {
    /// The rule of [`Bound::judge`], for people.
    pub const RULE: &str = "a bound is kept (agrees) when our whole 95 % interval keeps it, broken \
        (differs) when no part of it does; else, or with n < 10, nothing can be told";

    /// Whether a quantity keeps the bound: [`Verdict::Agrees`] when its whole interval does,
    /// [`Verdict::Differs`] when no part of it does.
    #[must_use]
    pub fn judge(self, ours: &Estimate) -> Verdict {
        let (all, some) = match self {
            Self::AtLeast(bound) => (ours.low >= bound, ours.high >= bound),
            Self::AtMost(bound) => (ours.high <= bound, ours.low <= bound),
        };
        match (all, some) {
            _ if ours.n < LEAST_SAMPLE => Verdict::CannotTell,
            (true, _) => Verdict::Agrees,
            (_, true) => Verdict::CannotTell,
            // An interval that is not a number keeps nothing and proves nothing.
            _ if ours.low.is_nan() || ours.high.is_nan() => Verdict::CannotTell,
            _ => Verdict::Differs,
        }
    }
}

/// How a published figure stands to ours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The published value lies in our 95 % interval, and the interval is narrow enough to say so.
    Agrees,
    /// The published value lies outside our 95 % interval.
    Differs,
    /// Nothing was published, the sample is too small, or the interval too wide to call it agreement.
    CannotTell,
}

impl Verdict {
    /// The rule of [`Verdict::of`], for people.
    pub const RULE: &str = "agrees: the published value lies inside our 95 % interval; differs: it \
        lies outside; cannot tell: nothing was published, n < 10, or it lies inside an interval wider \
        than half the published value; the published value is taken as exact";

    /// The rule of [`Verdict::exact`], for people.
    pub const EXACT_RULE: &str = "ours is computed exactly, without a sample: agrees when it is the \
        published value to the digit that is printed, differs when it is not; cannot tell: nothing was \
        published";

    /// Judges a published value beside one that was computed exactly; `digit` is the worth of the last
    /// digit that is printed, above 0.
    #[must_use]
    pub fn exact(published: Option<f64>, ours: f64, digit: f64) -> Self {
        let Some(published) = published.filter(|value| value.is_finite()) else {
            return Self::CannotTell;
        };
        // A little more than half a digit, since neither is exact in binary.
        if (published - ours).abs() <= 0.501 * digit { Self::Agrees } else { Self::Differs }
    }

    /// Judges a published value.
    ///
    /// A wide interval never earns agreement, but what lies outside even a wide interval differs. The
    /// published value is taken as exact: what its own sample leaves uncertain is not counted.
    #[must_use]
    pub fn of(published: Option<f64>, ours: &Estimate) -> Self {
        let Some(published) = published.filter(|value| value.is_finite()) else {
            return Self::CannotTell;
        };
        if ours.n < LEAST_SAMPLE || !(ours.low.is_finite() && ours.high.is_finite()) {
            Self::CannotTell
        } else if !(ours.low..=ours.high).contains(&published) {
            Self::Differs
        } else if ours.high - ours.low > WIDEST_INTERVAL * published.abs() {
            Self::CannotTell
        } else {
            Self::Agrees
        }
    }
}

#[expect(clippy::cast_precision_loss, reason = "samples are far smaller than 2^53")]
fn count(n: usize) -> f64 {
    n as f64
}

#[cfg(test)]
mod tests;
