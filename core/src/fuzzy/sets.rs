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

/// A trapezoidal set: 0 outside `[left, right]`, 1 in `[from, to]`.
///
/// A side may be steep (`left == from`), or a shoulder that never falls (both `-∞`, or both `∞`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trapezoid {
    /// Where membership begins to rise.
    pub left: f64,
    /// Where it has risen to 1.
    pub from: f64,
    /// Where it begins to fall.
    pub to: f64,
    /// Where it has fallen to 0.
    pub right: f64,
}

/// A fuzzy set over a real variable, Eq. (2.11).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Set {
    /// Linear sides and a plateau.
    Trapezoid(Trapezoid),
    /// Linear sides and a peak.
    Triangle(Triangle),
    /// One value that belongs wholly, and nothing else.
    Singleton(f64),
}

/// What every membership function of linear pieces can tell.
pub trait Shape {
    /// Degree of membership `μ_A(u)`, 0 to 1.
    fn membership(&self, value: f64) -> f64;
    /// The four corners, where membership begins to rise, has risen to 1, begins to fall and is 0.
    fn corners(&self) -> [f64; 4];

    /// Area under the set; 0 of a singleton, infinite of a shoulder.
    fn area(&self) -> f64 {
        let [left, from, to, right] = self.corners();
        0.5 * ((right - left) + (to - from))
    }

    /// Centre of that area; of no area, the middle of what belongs wholly.
    fn centroid(&self) -> f64 {
        let [left, from, to, right] = self.corners();
        let (rising, level, falling) = (0.5 * (from - left), to - from, 0.5 * (right - to));
        let area = rising + level + falling;
        if area <= 0.0 {
            return f64::midpoint(from, to);
        }
        let moment = rising * (left + 2.0 * from) / 3.0
            + level * f64::midpoint(from, to)
            + falling * (2.0 * to + right) / 3.0;
        moment / area
    }

    /// First and last value whose membership is at least a height from 0 to 1.
    fn level(&self, height: f64) -> (f64, f64) {
        let [left, from, to, right] = self.corners();
        let between = |outer: f64, inner: f64| {
            if outer == inner { inner } else { outer + height * (inner - outer) }
        };
        (between(left, from), between(right, to))
    }
}

impl Shape for Triangle {
    fn membership(&self, value: f64) -> f64 {
        let rising = (value - self.left) / (self.peak - self.left);
        let falling = (self.right - value) / (self.right - self.peak);
        rising.min(falling).clamp(0.0, 1.0)
    }

    fn corners(&self) -> [f64; 4] {
        [self.left, self.peak, self.peak, self.right]
    }

    fn area(&self) -> f64 {
        (self.right - self.left) / 2.0
    }

    fn centroid(&self) -> f64 {
        (self.left + self.peak + self.right) / 3.0
    }
}

impl Shape for Trapezoid {
    fn membership(&self, value: f64) -> f64 {
        let side = |outer: f64, inner: f64| ((value - outer) / (inner - outer)).clamp(0.0, 1.0);
        if value < self.from {
            if value <= self.left { 0.0 } else { side(self.left, self.from) }
        } else if value <= self.to {
            1.0
        } else if value >= self.right {
            0.0
        } else {
            side(self.right, self.to)
        }
    }

    fn corners(&self) -> [f64; 4] {
        [self.left, self.from, self.to, self.right]
    }
}

impl Shape for Set {
    fn membership(&self, value: f64) -> f64 {
        match self {
            Self::Trapezoid(trapezoid) => trapezoid.membership(value),
            Self::Triangle(triangle) => triangle.membership(value),
            Self::Singleton(at) => f64::from(value == *at),
        }
    }

    fn corners(&self) -> [f64; 4] {
        match self {
            Self::Trapezoid(trapezoid) => trapezoid.corners(),
            Self::Triangle(triangle) => triangle.corners(),
            Self::Singleton(at) => [*at; 4],
        }
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
        let trapezoid = Trapezoid { left: 0.0, from: 1.0, to: 3.0, right: 5.0 };
        for (value, expected) in
            [(-1.0, 0.0), (0.0, 0.0), (0.5, 0.5), (1.0, 1.0), (3.0, 1.0), (4.0, 0.5), (5.0, 0.0)]
        {
            assert!((trapezoid.membership(value) - expected).abs() < 1e-15, "at {value}");
        }
        let none = f64::NEG_INFINITY;
        let shoulder = Trapezoid { left: none, from: none, to: 0.2, right: 0.3 };
        for (value, expected) in [(-1e300, 1.0), (0.2, 1.0), (0.25, 0.5), (0.3, 0.0)] {
            assert!((shoulder.membership(value) - expected).abs() < 1e-12, "shoulder at {value}");
        }
        let steep = Trapezoid { left: 1.0, from: 1.0, to: 2.0, right: 2.0 };
        assert_eq!(
            [0.999, 1.0, 2.0, 2.001].map(|value| steep.membership(value)),
            [0.0, 1.0, 1.0, 0.0]
        );
        let singleton = Set::Singleton(2.0);
        assert_eq!([1.9, 2.0, 2.1].map(|value| singleton.membership(value)), [0.0, 1.0, 0.0]);
    }

    #[test]
    fn areas_and_centres_in_closed_form() {
        // A rectangle from 1 to 3 with a triangle of area 1/2 before it and one of area 1 behind it.
        let trapezoid = Trapezoid { left: 0.0, from: 1.0, to: 3.0, right: 5.0 };
        let moment = 0.5 * (2.0 / 3.0) + 2.0 * 2.0 + 1.0 * (3.0 + 2.0 / 3.0);
        assert!((trapezoid.area() - 3.5).abs() < 1e-15);
        assert!((trapezoid.centroid() - moment / 3.5).abs() < 1e-15);
        assert_eq!(trapezoid.level(0.5), (0.5, 4.0));
        let triangle = Triangle { left: -1.0, peak: 0.0, right: 2.0 };
        let same = Trapezoid { left: -1.0, from: 0.0, to: 0.0, right: 2.0 };
        assert_eq!(triangle.area(), same.area());
        assert!((triangle.centroid() - same.centroid()).abs() < 1e-15);
        assert_eq!((Set::Singleton(4.0).area(), Set::Singleton(4.0).centroid()), (0.0, 4.0));
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
