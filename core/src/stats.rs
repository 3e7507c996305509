//! Means, intervals, verdicts.
