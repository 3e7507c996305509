//! What the sonars of one place show of the ground around it.

use crate::geometry::{Pose, Vec2, unit};

/// Degrees from the axis of a sonar to the edges of its cone, where the echo may have come from.
const EDGES_DEG: [f64; 3] = [-7.5, 0.0, 7.5];

/// The echoes heard at one believed pose, as points in the odometry frame.
#[derive(Clone, Debug)]
pub(super) struct Echoes {
    from: Vec2,
    heading_rad: f64,
    body_m: f64,
    readings_m: Vec<f64>,
    points: Vec<Vec2>,
}

impl Echoes {
    /// The echoes of a ring of sonars on the shell of a round body; a reading of the full range is no
    /// echo.
    pub(super) fn new(pose: Pose, readings_m: &[f64], body_m: f64, range_m: f64) -> Self {
        let from = pose.position();
        let spacing_deg = spacing_deg(readings_m.len());
        let mut points = Vec::new();
        let mut axis_deg = pose.heading_rad.to_degrees();
        for reading_m in readings_m {
            if *reading_m < range_m {
                points.extend(EDGES_DEG.map(|edge_deg| {
                    from + unit((axis_deg + edge_deg).to_radians()) * (body_m + reading_m)
                }));
            }
            axis_deg += spacing_deg;
        }
        Self {
            from,
            heading_rad: pose.heading_rad,
            body_m,
            readings_m: readings_m.to_vec(),
            points,
        }
    }

    /// Where they were heard.
    pub(super) fn from(&self) -> Vec2 {
        self.from
    }

    /// Way that the sonar nearest to a direction shows free, metres from the shell.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_possible_wrap,
        clippy::cast_sign_loss,
        reason = "a sonar's number"
    )]
    pub(super) fn free_m(&self, direction_rad: f64) -> f64 {
        let sonars = self.readings_m.len();
        let turned_deg = (direction_rad - self.heading_rad).to_degrees();
        let sonar = libm::round(turned_deg / spacing_deg(sonars)) as i64;
        self.readings_m[sonar.rem_euclid(sonars as i64) as usize]
    }

    /// Distance of the shell to the nearest echo when the body stands at a place, metres.
    pub(super) fn clearance_m(&self, at: Vec2) -> f64 {
        let nearest = self.points.iter().map(|echo| (echo - at).norm_squared());
        nearest.fold(f64::INFINITY, f64::min).sqrt() - self.body_m
    }
}

#[expect(clippy::cast_precision_loss, reason = "a few dozen sonars")]
fn spacing_deg(sonars: usize) -> f64 {
    360.0 / sonars as f64
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;

    #[test]
    fn a_wall_ahead_is_as_far_as_its_sonar_says() {
        let mut readings_m = [8.0; 24];
        readings_m[0] = 1.0;
        // Heading north, so the sonar ahead looks along y.
        let pose = Pose::new(1.0, 2.0, FRAC_PI_2);
        let echoes = Echoes::new(pose, &readings_m, 0.25, 8.0);
        assert!((echoes.free_m(FRAC_PI_2) - 1.0).abs() < 1e-12);
        assert!((echoes.free_m(FRAC_PI_2 + 0.2) - 8.0).abs() < 1e-12, "the sonar to its left");
        for (y_m, expected_m) in [(2.0, 1.0), (2.5, 0.5), (3.25, -0.25)] {
            let found_m = echoes.clearance_m(Vec2::new(1.0, y_m));
            assert!((found_m - expected_m).abs() < 1e-12, "{y_m}: {found_m}");
        }
        assert!(Echoes::new(pose, &[8.0; 24], 0.25, 8.0).clearance_m(pose.position()).is_infinite());
    }
}
