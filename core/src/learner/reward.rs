//! The reinforcement functions of section 5.5.

use std::f64::consts::PI;

use super::Reinforcement;
use crate::robot::Contact;

/// Settings of the reinforcement.
#[derive(Clone, Debug, PartialEq)]
pub struct RewardSettings {
    /// Reinforcement of a collision, at most 0.
    pub collision: f64,
    /// `d_c`, metres: a smaller sonar reading is too close.
    pub close_m: f64,
}

/// The reinforcement of a situation reached with a contact, with the goal at a bearing in `[-π, π)`.
#[must_use]
pub fn reinforcement(
    settings: &RewardSettings,
    sonar_m: &[f64],
    contact: Contact,
    goal_bearing_rad: f64,
) -> Reinforcement {
    let least_m = sonar_m.iter().copied().fold(f64::INFINITY, f64::min);
    let close = least_m < settings.close_m;
    // Eq. (5.6): f₁ = -3 on collision; -1 + min_j(d_j / d_c) when close; else 0
    let safety = if contact != Contact::None {
        settings.collision
    } else if close {
        -1.0 + least_m / settings.close_m
    } else {
        0.0
    };
    Reinforcement { safety, goal: goal_part(goal_bearing_rad), close }
}

/// The goal's part of the reinforcement, with the goal at a bearing in `[-π, π)`.
#[must_use]
pub fn goal_part(goal_bearing_rad: f64) -> f64 {
    // Eq. (5.7): f₂ = -acute(|θ_h - θ_gr|) / π
    -goal_bearing_rad.abs() / PI
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_parts_at_their_corners() {
        let settings = RewardSettings { collision: -3.0, close_m: 0.2 };
        for (least_m, contact, bearing_rad, safety, goal) in [
            (1.0, Contact::None, 0.0, 0.0, 0.0),
            (0.2, Contact::None, PI / 2.0, 0.0, -0.5),
            (0.1, Contact::None, -PI / 2.0, -0.5, -0.5),
            (0.0, Contact::None, -PI, -1.0, -1.0),
            (0.1, Contact::Virtual, 0.0, -3.0, 0.0),
            (1.0, Contact::Real, 0.0, -3.0, 0.0),
        ] {
            let mut sonar_m = [8.0; 24];
            sonar_m[5] = least_m;
            let found = reinforcement(&settings, &sonar_m, contact, bearing_rad);
            assert!((found.safety - safety).abs() < 1e-15, "{least_m} {contact:?}");
            assert!((found.goal - goal).abs() < 1e-15, "{bearing_rad}");
            assert!((found.total() - safety - goal).abs() < 1e-15);
        }
    }
}
