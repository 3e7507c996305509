//! Whether a filter's errors are as great as it says they are.
//!
//! Innovations (NIS) and, where the truth is known, errors (NEES), squared and over their variance, are
//! χ² with one degree of freedom if they are. Their mean over n independent values lies between
//! χ²₀.₀₂₅(n)/n and χ²₀.₉₇₅(n)/n with 95 % probability.

use serde::{Deserialize, Serialize};

use crate::stats::chi_square_quantile;

/// Normalised squares, added up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Consistency {
    sum: f64,
    count: u64,
}

impl Consistency {
    /// Takes in a normalised square.
    pub fn take(&mut self, square: f64) {
        self.sum += square;
        self.count += 1;
    }

    /// How many were taken in.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Their mean, 1 for a filter that is as sure as it should be; none of none.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
    pub fn mean(&self) -> Option<f64> {
        (self.count > 0).then(|| self.sum / self.count as f64)
    }

    /// Where the mean of so many independent values lies with 95 % probability.
    ///
    /// NOTE: windows that share readings are not independent, so over a run this is narrower than it
    /// should be.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
    pub fn bounds(count: u64) -> (f64, f64) {
        let freedom = count.max(1) as f64;
        let end = |probability| chi_square_quantile(probability, freedom) / freedom;
        (end(0.025), end(0.975))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_those_of_tables() {
        // χ² tables: 1 degree 0.00098 and 5.024, 10 degrees 3.247 and 20.483.
        for (count, low, high) in [(1, 0.00098, 5.024), (10, 0.3247, 2.0483)] {
            let (found_low, found_high) = Consistency::bounds(count);
            assert!((found_low - low).abs() < 5e-5 && (found_high - high).abs() < 5e-4, "{count}");
        }
        let mut consistency = Consistency::default();
        assert_eq!(consistency.mean(), None);
        consistency.take(1.0);
        consistency.take(2.0);
        assert_eq!((consistency.mean(), consistency.count()), (Some(1.5), 2));
    }
}
