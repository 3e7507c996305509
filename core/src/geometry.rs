//! Points, poses and angles in the plane.
//!
//! Lengths are in metres and angles in radians, counter-clockwise, wrapped to `[-π, π)`. Every
//! transcendental function goes through [`libm`], so a result does not depend on the platform's C
//! library.

use std::f64::consts::{PI, TAU};

use nalgebra::Vector2;
use serde::{Deserialize, Serialize};

/// A point or displacement in the plane, metres.
pub type Vec2 = Vector2<f64>;

/// Position and heading of a body in some frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Pose {
    /// Metres along the frame's x axis.
    pub x_m: f64,
    /// Metres along the frame's y axis.
    pub y_m: f64,
    /// Radians from the x axis, counter-clockwise, in `[-π, π)`.
    pub heading_rad: f64,
}

impl Pose {
    /// A pose from its parts; the heading is wrapped.
    #[must_use]
    pub fn new(x_m: f64, y_m: f64, heading_rad: f64) -> Self {
        Self { x_m, y_m, heading_rad: wrap_angle(heading_rad) }
    }

    /// The position without the heading.
    #[must_use]
    pub fn position(&self) -> Vec2 {
        Vec2::new(self.x_m, self.y_m)
    }

    /// Unit vector along the heading.
    #[must_use]
    pub fn direction(&self) -> Vec2 {
        unit(self.heading_rad)
    }

    /// The same heading at another place.
    #[must_use]
    pub fn at(&self, position: Vec2) -> Self {
        Self { x_m: position.x, y_m: position.y, heading_rad: self.heading_rad }
    }

    /// Distance to a point, metres.
    #[must_use]
    pub fn distance_to(&self, point: Vec2) -> f64 {
        (point - self.position()).norm()
    }

    /// Angle from the heading to a point, counter-clockwise, in `[-π, π)`.
    #[must_use]
    pub fn bearing_to(&self, point: Vec2) -> f64 {
        wrap_angle(angle(point - self.position()) - self.heading_rad)
    }
}

/// Wraps an angle to `[-π, π)`.
#[must_use]
pub fn wrap_angle(angle_rad: f64) -> f64 {
    if (-PI..PI).contains(&angle_rad) {
        return angle_rad;
    }
    let turned = angle_rad - TAU * libm::floor((angle_rad + PI) / TAU);
    // Rounding can land exactly on π, which belongs to the other end.
    if turned >= PI { turned - TAU } else { turned }
}

/// Angle of a vector from the x axis, in `[-π, π]`; the zero vector gives 0.
#[must_use]
pub fn angle(vector: Vec2) -> f64 {
    libm::atan2(vector.y, vector.x)
}

/// Unit vector at an angle from the x axis.
#[must_use]
pub fn unit(angle_rad: f64) -> Vec2 {
    let (sin, cos) = libm::sincos(angle_rad);
    Vec2::new(cos, sin)
}

/// Turns a vector counter-clockwise by the angle whose unit vector is `direction`.
#[must_use]
pub fn rotate(vector: Vec2, direction: Vec2) -> Vec2 {
    Vec2::new(
        vector.x * direction.x - vector.y * direction.y,
        vector.x * direction.y + vector.y * direction.x,
    )
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn a_wrapped_angle_points_the_same_way(angle_rad in -100.0..100.0f64) {
            let wrapped = wrap_angle(angle_rad);
            prop_assert!((-PI..PI).contains(&wrapped));
            prop_assert!((unit(wrapped) - unit(angle_rad)).norm() < 1e-12);
        }

        #[test]
        fn rotating_adds_angles(a in -3.0..3.0f64, b in -3.0..3.0f64) {
            prop_assert!((rotate(unit(a), unit(b)) - unit(a + b)).norm() < 1e-12);
        }
    }

    #[test]
    fn bearings_are_relative_to_the_heading() {
        let pose = Pose::new(1.0, 1.0, PI / 2.0);
        for (point, expected) in [
            (Vec2::new(1.0, 3.0), 0.0),
            (Vec2::new(3.0, 1.0), -PI / 2.0),
            (Vec2::new(-1.0, 1.0), PI / 2.0),
        ] {
            assert!((pose.bearing_to(point) - expected).abs() < 1e-12, "{point:?}");
        }
    }
}
