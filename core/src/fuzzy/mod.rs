//! Fuzzy sets and inference.
