//! Membership functions over a real input.

/// Membership that is 1 up to `full`, falls linearly, and is 0 from `none` on.
///
/// With `full >= none` it is a step at `full`.
#[must_use]
pub fn falling(value: f64, full: f64, none: f64) -> f64 {
    if full >= none {
        return f64::from(value <= full);
    }
    ((none - value) / (none - full)).clamp(0.0, 1.0)
}

/// A triangular set: 0 outside `[left, right]`, 1 at `peak`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// Where membership begins to rise.
    pub left: f64,
    /// Where membership is 1.
    pub peak: f64,
    /// Where membership has fallen to 0.
    pub right: f64,
}

impl Triangle {
    /// Degree of membership, 0 to 1.
    #[must_use]
    pub fn membership(&self, value: f64) -> f64 {
        let rising = (value - self.left) / (self.peak - self.left);
        let falling = (self.right - value) / (self.right - self.peak);
        rising.min(falling).clamp(0.0, 1.0)
    }

    /// Area under the set.
    #[must_use]
    pub fn area(&self) -> f64 {
        (self.right - self.left) / 2.0
    }

    /// Centre of that area.
    #[must_use]
    pub fn centroid(&self) -> f64 {
        (self.left + self.peak + self.right) / 3.0
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn memberships_at_their_corners() {
        let triangle = Triangle { left: -1.0, peak: 0.0, right: 2.0 };
        for (value, expected) in
            [(-2.0, 0.0), (-1.0, 0.0), (-0.5, 0.5), (0.0, 1.0), (1.0, 0.5), (2.0, 0.0), (9.0, 0.0)]
        {
            assert!((triangle.membership(value) - expected).abs() < 1e-15, "triangle at {value}");
        }
        for (value, expected) in [(0.0, 1.0), (0.1, 1.0), (0.25, 0.5), (0.4, 0.0), (8.0, 0.0)] {
            assert!((falling(value, 0.1, 0.4) - expected).abs() < 1e-12, "falling at {value}");
        }
        assert_eq!((falling(0.1, 0.1, 0.1), falling(0.2, 0.1, 0.1)), (1.0, 0.0), "a step");
    }

    proptest! {
        #[test]
        fn memberships_stay_in_the_unit_interval(value in -10.0..10.0f64, peak in -1.0..1.0f64) {
            let triangle = Triangle { left: peak - 1.0, peak, right: peak + 0.5 };
            prop_assert!((0.0..=1.0).contains(&triangle.membership(value)));
            prop_assert!((0.0..=1.0).contains(&falling(value, peak, peak + 0.3)));
        }
    }
}
