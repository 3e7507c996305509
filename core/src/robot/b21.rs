//! The B21, section 5.3: a round robot with a ring of 24 sonars, infrared and tactile sensors and
//! odometry, simulated in a [`World`].
//!
//! NOTE: the infrared ring is idealised. Section 5.5 reads the strongest of 56 sensors that detect
//! objects nearer than 0.5 m, with a reflectance that depends on the colour of the objects; here one
//! reflectance of all surfaces stands for them, and the nearest surface in any direction counts:
//! `100·ρ·(1 − d/0.5 m)` percent at a clearance `d` from the shell. With ρ = 0.875 the 70 % of a
//! virtual collision is crossed at 0.10 m. The tactile ring answers when that clearance is gone.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;

use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

use crate::geometry::{Pose, Vec2, unit};
use crate::rng::{Purpose, stream};
use crate::world::{RayFan, RayRing, World};

use super::motion::{Course, Motion};

/// Sonars on the enclosure's ring; sonar `i` looks `15°·i` counter-clockwise from the heading.
pub const SONARS: usize = 24;

/// What the simulated robot is like. Lengths in metres, angles in radians. All numbers are finite
/// and none is negative; ranges and increments are greater than 0.
///
/// The thesis gives the way of a step, the infrared range and the threshold (sections 5.4 and 5.5);
/// the size is that of the robot's enclosure, and the rest describes the simulation.
#[derive(Clone, Debug, PartialEq)]
pub struct B21Settings {
    /// Radius of the shell.
    pub radius_m: f64,
    /// Standard deviation of a sonar reading, as a share of it.
    pub sonar_noise: f64,
    /// Full width of a sonar's cone.
    pub sonar_cone_rad: f64,
    /// Rays that stand for a cone; the reading is the least of them.
    pub sonar_rays: usize,
    /// Greatest reading, and the reading when there is no echo.
    pub sonar_range_m: f64,
    /// Incidence beyond which a ray returns no echo; `π/2` loses none.
    pub sonar_critical_rad: f64,
    /// Probability that a sonar misses its echo.
    pub sonar_dropout: f64,
    /// Distance from the shell beyond which the infrared sensors see nothing (section 5.5: 0.5 m).
    pub infrared_range_m: f64,
    /// Reflectance above which a virtual collision is declared, percent (section 5.5: 70 %).
    pub infrared_threshold_pct: f64,
    /// Share of the light that surfaces reflect at the shell.
    pub infrared_reflectance: f64,
    /// Way of one control step (section 5.4: 20 cm).
    pub advance_m: f64,
    /// Way between two looks at the infrared and tactile sensors.
    pub increment_m: f64,
    /// Clearance from the shell at which a rescue is over.
    pub clear_to_m: f64,
    /// Least way backed off in a rescue.
    pub back_min_m: f64,
    /// Greatest way backed off in a rescue.
    pub back_max_m: f64,
    /// Clearance from the shell that a rescue never goes below.
    pub touch_m: f64,
    /// Drift `k` of the odometry: a rotation is executed `(1 + k·N)` times and off by `0.2·k` rad
    /// more, an advance is measured `(1 + k·N)` times, each `N` standard normal.
    pub odometry_drift: f64,
}

impl Default for B21Settings {
    fn default() -> Self {
        Self {
            radius_m: 0.265,
            sonar_noise: 0.01,
            sonar_cone_rad: FRAC_PI_2 / 6.0,
            sonar_rays: 5,
            sonar_range_m: 8.0,
            sonar_critical_rad: FRAC_PI_2,
            sonar_dropout: 0.0,
            infrared_range_m: 0.5,
            infrared_threshold_pct: 70.0,
            infrared_reflectance: 0.875,
            advance_m: 0.2,
            increment_m: 0.01,
            clear_to_m: 0.15,
            back_min_m: 0.1,
            back_max_m: 0.6,
            touch_m: 0.01,
            odometry_drift: 0.0,
        }
    }
}

impl B21Settings {
    /// Strongest infrared reflectance at a clearance from the shell, percent of full reflection.
    #[must_use]
    pub fn reflectance_pct(&self, clearance_m: f64) -> f64 {
        let share = 1.0 - clearance_m.max(0.0) / self.infrared_range_m;
        100.0 * self.infrared_reflectance * share.max(0.0)
    }

    /// Clearance from the shell below which the reflectance exceeds the threshold, metres; negative
    /// when surfaces are too dark for that.
    #[must_use]
    pub fn virtual_collision_m(&self) -> f64 {
        let share = self.infrared_threshold_pct / (100.0 * self.infrared_reflectance);
        self.infrared_range_m * (1.0 - share)
    }
}

/// What the robot senses where it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensed {
    /// Sonar readings, metres from the shell, sonar `i` at `15°·i` counter-clockwise.
    pub sonar_m: [f64; SONARS],
    /// Strongest infrared reflectance, percent of full reflection.
    pub reflectance_pct: f64,
}

/// The simulated robot.
#[derive(Clone, Debug)]
pub struct B21 {
    world: Arc<World>,
    settings: B21Settings,
    seed: u64,
    ring: RayRing,
    sonar_rng: ChaCha8Rng,
    odometry_rng: ChaCha8Rng,
    body: Body,
    believed: Body,
    /// Distance from the true position to the nearest surface less the radius, metres.
    clearance_m: f64,
}

/// A pose with the unit vector of its heading, which every step needs several times.
#[derive(Clone, Copy, Debug)]
struct Body {
    pose: Pose,
    direction: Vec2,
}

impl B21 {
    /// A robot at the world's home, ready for the first trial.
    #[must_use]
    pub fn new(world: Arc<World>, settings: B21Settings, seed: u64) -> Self {
        let sonar = |index: usize| {
            let axis_rad = TAU * index as f64 / SONARS as f64;
            RayFan { place: unit(axis_rad) * settings.radius_m, axis_rad }
        };
        let ring = RayRing::new(
            &std::array::from_fn::<_, SONARS, _>(sonar),
            settings.sonar_rays,
            settings.sonar_cone_rad,
            settings.sonar_range_m,
            settings.sonar_critical_rad,
        );
        let home = Body::new(world.home());
        let clearance_m = world.surface_distance_m(home.pose.position()) - settings.radius_m;
        Self {
            sonar_rng: stream(seed, 0, Purpose::Sonar),
            odometry_rng: stream(seed, 0, Purpose::Odometry),
            world,
            settings,
            seed,
            ring,
            body: home,
            believed: home,
            clearance_m,
        }
    }

    /// Puts the robot back home for a trial (0-based), its belief true and its random streams fresh.
    pub fn begin_trial(&mut self, trial0: u32) {
        self.sonar_rng = stream(self.seed, trial0, Purpose::Sonar);
        self.odometry_rng = stream(self.seed, trial0, Purpose::Odometry);
        self.body = Body::new(self.world.home());
        self.believed = self.body;
        self.clearance_m = self.clearance_at(self.body.pose.position());
    }

    /// Reads all sensors. Each call draws fresh noise.
    pub fn sense(&mut self) -> Sensed {
        let mut sonar_m = [0.0; SONARS];
        let position = self.body.pose.position();
        self.ring.scan(&self.world, position, self.body.direction, &mut sonar_m);
        self.disturb(&mut sonar_m);
        Sensed { sonar_m, reflectance_pct: self.settings.reflectance_pct(self.clearance_m) }
    }

    /// Rotates, advances one step's way, and is rescued if that ends in a collision. The heading
    /// stays what it is after the rotation.
    pub fn act(&mut self, rotation_rad: f64) -> Motion {
        let drift = self.draw_drift();
        let executed_rad = rotation_rad * drift.rotation_factor + drift.rotation_rad;
        self.body = self.body.turned(executed_rad);
        // Without drift both turn alike, so that the belief stays true to the last bit.
        self.believed = self.believed.turned(rotation_rad);
        let course = Course {
            world: &self.world,
            settings: &self.settings,
            start: self.body.pose.position(),
            direction: self.body.direction,
            start_clearance_m: self.clearance_m,
        };
        let way = course.travel();
        self.clearance_m = way.clearance_m;
        let net_m = way.advanced_m - way.backed_m;
        self.body = self.body.shifted(net_m);
        let before = self.believed.pose.position();
        self.believed = self.believed.shifted(net_m * drift.advance_factor);
        Motion {
            contact: way.contact,
            advanced_m: way.advanced_m,
            backed_m: way.backed_m,
            moved: self.believed.pose.position() - before,
        }
    }

    /// Where the robot is.
    #[must_use]
    pub fn true_pose(&self) -> Pose {
        self.body.pose
    }

    /// Where the robot believes to be, by its odometry.
    #[must_use]
    pub fn pose(&self) -> Pose {
        self.believed.pose
    }

    /// Whether the robot's centre is inside the goal.
    #[must_use]
    pub fn at_goal(&self) -> bool {
        let goal = self.world.goal();
        self.body.pose.distance_to(goal.centre) < goal.radius_m
    }

    /// Distance from the shell to the nearest surface, metres.
    #[must_use]
    pub fn shell_clearance_m(&self) -> f64 {
        self.clearance_m
    }

    fn clearance_at(&self, position: Vec2) -> f64 {
        self.world.surface_distance_m(position) - self.settings.radius_m
    }

    /// Noise, missed echoes and the limits of the readings. What is switched off draws nothing.
    fn disturb(&mut self, sonar_m: &mut [f64; SONARS]) {
        let (noise, dropout) = (self.settings.sonar_noise, self.settings.sonar_dropout);
        for reading_m in sonar_m {
            if noise > 0.0 {
                let normal: f64 = self.sonar_rng.sample(StandardNormal);
                *reading_m *= 1.0 + noise * normal;
            }
            if dropout > 0.0 && self.sonar_rng.random::<f64>() < dropout {
                *reading_m = self.settings.sonar_range_m;
            }
            *reading_m = reading_m.clamp(0.0, self.settings.sonar_range_m);
        }
    }

    fn draw_drift(&mut self) -> Drift {
        let k = self.settings.odometry_drift;
        if k <= 0.0 {
            return Drift { rotation_factor: 1.0, rotation_rad: 0.0, advance_factor: 1.0 };
        }
        let mut normal = || self.odometry_rng.sample::<f64, _>(StandardNormal);
        Drift {
            rotation_factor: 1.0 + k * normal(),
            rotation_rad: 0.2 * k * normal(),
            advance_factor: 1.0 + k * normal(),
        }
    }
}

/// How one step differs from what the odometry says.
struct Drift {
    rotation_factor: f64,
    rotation_rad: f64,
    advance_factor: f64,
}

impl Body {
    fn new(pose: Pose) -> Self {
        Self { pose, direction: pose.direction() }
    }

    fn turned(&self, rotation_rad: f64) -> Self {
        let Pose { x_m, y_m, heading_rad } = self.pose;
        Self::new(Pose::new(x_m, y_m, heading_rad + rotation_rad))
    }

    fn shifted(&self, way_m: f64) -> Self {
        Self { pose: self.pose.at(self.pose.position() + self.direction * way_m), ..*self }
    }
}

#[cfg(test)]
mod tests;
