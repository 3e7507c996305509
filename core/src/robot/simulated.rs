//! A robot with sonars, infrared and tactile sensors and odometry, simulated in a [`World`]: the B21 of
//! section 5.3, or any other that a [`Robot`] describes.
//!
//! NOTE: the infrared ring is idealised. Section 5.5 reads the strongest of 56 sensors that detect
//! objects nearer than 0.5 m, with a reflectance that depends on the colour of the objects; here one
//! reflectance of all surfaces stands for them, and the nearest surface in any direction counts:
//! `100·ρ·(1 − d/0.5 m)` percent at a clearance `d` from the shell. With ρ = 0.875 the 70 % of a
//! virtual collision is crossed at 0.10 m. The tactile ring answers when that clearance is gone.

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

use crate::geometry::{Pose, Vec2};
use crate::rng::{Purpose, stream};
use crate::world::{RayFan, RayRing, World};

use super::motion::{Course, Motion, Turn};
use super::{Body, Contact, Mount, Readings, Robot};

/// Heading error of a step without a rotation where odometry errs by its whole, radians.
pub(crate) const STRAIGHT_RAD: f64 = 0.2;

/// How a robot senses and moves. Lengths in metres, angles in radians. All numbers are finite and
/// none is negative; ranges and increments are greater than 0.
///
/// The thesis gives the way of a step, the infrared range and the threshold (sections 5.4 and 5.5);
/// the rest describes the simulation.
#[derive(Clone, Debug, PartialEq)]
pub struct SimulationSettings {
    /// Standard deviation of a sonar reading, as a share of it.
    pub sonar_noise: f64,
    /// Full width of a sonar's cone.
    pub sonar_cone_rad: f64,
    /// Rays that stand for a cone; the reading is the least of them.
    pub sonar_rays: usize,
    /// Greatest reading, and the reading when there is no echo.
    pub sonar_range_m: f64,
    /// Least reading.
    pub sonar_least_m: f64,
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
    /// A collision is followed by a rescue: the robot backs off until it is clear.
    pub rescue: bool,
    /// Clearance from the shell at which a rescue is over.
    pub clear_to_m: f64,
    /// Least way backed off in a rescue.
    pub back_min_m: f64,
    /// Greatest way backed off in a rescue.
    pub back_max_m: f64,
    /// Clearance from the shell that a rescue never goes below.
    pub touch_m: f64,
    /// Drift `k` of the odometry: a rotation is executed `(1 + k·N)` times and off by `0.2·k·N` rad
    /// more, an advance is measured `(1 + k·N)` times, each `N` standard normal.
    pub odometry_drift: f64,
}

impl Default for SimulationSettings {
    fn default() -> Self {
        Self {
            sonar_noise: 0.01,
            sonar_cone_rad: FRAC_PI_2 / 6.0,
            sonar_rays: 5,
            sonar_range_m: 8.0,
            sonar_least_m: 0.0,
            sonar_critical_rad: FRAC_PI_2,
            sonar_dropout: 0.0,
            infrared_range_m: 0.5,
            infrared_threshold_pct: 70.0,
            infrared_reflectance: 0.875,
            advance_m: 0.2,
            increment_m: 0.01,
            rescue: true,
            clear_to_m: 0.15,
            back_min_m: 0.1,
            back_max_m: 0.6,
            touch_m: 0.01,
            odometry_drift: 0.0,
        }
    }
}

impl SimulationSettings {
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
    /// Sonar readings, metres from each sonar.
    pub sonar_m: Readings,
    /// Strongest infrared reflectance, percent of full reflection.
    pub reflectance_pct: f64,
}

/// The simulated robot.
#[derive(Clone, Debug)]
pub struct SimulatedRobot {
    world: Arc<World>,
    robot: Arc<Robot>,
    settings: SimulationSettings,
    seed: u64,
    ring: RayRing,
    sonar_rng: ChaCha8Rng,
    odometry_rng: ChaCha8Rng,
    actual: Stance,
    believed: Stance,
    /// Distance from the body to the nearest surface where the robot really is, metres.
    clearance_m: f64,
}

/// A pose with the unit vector of its heading, which every step needs several times.
#[derive(Clone, Copy, Debug)]
struct Stance {
    pose: Pose,
    direction: Vec2,
}

impl SimulatedRobot {
    /// A robot at the world's home, ready for the first trial.
    #[must_use]
    pub fn new(
        world: Arc<World>,
        robot: Arc<Robot>,
        settings: SimulationSettings,
        seed: u64,
    ) -> Self {
        let fans: Vec<RayFan> = robot.sonars().iter().map(Mount::fan).collect();
        let ring = RayRing::new(
            &fans,
            settings.sonar_rays,
            settings.sonar_cone_rad,
            settings.sonar_range_m,
            settings.sonar_critical_rad,
        );
        let home = Stance::new(world.home());
        let clearance_m = home.clearance_m(robot.body(), &world);
        Self {
            sonar_rng: stream(seed, 0, Purpose::Sonar),
            odometry_rng: stream(seed, 0, Purpose::Odometry),
            world,
            robot,
            settings,
            seed,
            ring,
            actual: home,
            believed: home,
            clearance_m,
        }
    }

    /// Puts the robot back home for a trial (0-based), its belief true and its random streams fresh.
    pub fn begin_trial(&mut self, trial0: u32) {
        self.begin_trial_at(trial0, self.world.home());
    }

    /// Puts the robot anywhere for a trial (0-based), its belief true and its random streams fresh.
    pub fn begin_trial_at(&mut self, trial0: u32, start: Pose) {
        self.sonar_rng = stream(self.seed, trial0, Purpose::Sonar);
        self.odometry_rng = stream(self.seed, trial0, Purpose::Odometry);
        self.actual = Stance::new(start);
        self.believed = self.actual;
        self.clearance_m = self.actual.clearance_m(self.robot.body(), &self.world);
    }

    /// Reads all sensors. Each call draws fresh noise.
    pub fn sense(&mut self) -> Sensed {
        let mut sonar_m = Readings::zero(self.robot.sonars().len());
        let Stance { pose, direction } = self.actual;
        self.ring.scan(&self.world, pose.position(), direction, &mut sonar_m);
        self.disturb(&mut sonar_m);
        Sensed { sonar_m, reflectance_pct: self.settings.reflectance_pct(self.clearance_m) }
    }

    /// Rotates, advances one step's way, and is rescued if that ends in a collision. The heading
    /// stays what it is after the rotation.
    pub fn act(&mut self, rotation_rad: f64) -> Motion {
        let drift = self.draw_drift();
        let executed_rad = rotation_rad * drift.rotation_factor + drift.rotation_rad;
        let turn = self.turn(executed_rad);
        self.actual = self.actual.turned(executed_rad * turn.share);
        // Without drift both turn alike, so that the belief stays true to the last bit.
        self.believed = self.believed.turned(rotation_rad * turn.share);
        let course = Course {
            world: &self.world,
            body: self.robot.body(),
            settings: &self.settings,
            start: self.actual.pose.position(),
            direction: self.actual.direction,
            start_clearance_m: turn.clearance_m,
        };
        let way = course.travel(turn.contact);
        self.clearance_m = way.clearance_m;
        let net_m = way.advanced_m - way.backed_m;
        self.actual = self.actual.shifted(net_m);
        let before = self.believed.pose.position();
        self.believed = self.believed.shifted(net_m * drift.advance_factor);
        Motion {
            contact: way.contact,
            advanced_m: way.advanced_m,
            backed_m: way.backed_m,
            moved: self.believed.pose.position() - before,
        }
    }

    /// How much of a rotation the body has room for. A round body always has.
    fn turn(&self, rotation_rad: f64) -> Turn {
        let whole = Turn { share: 1.0, contact: Contact::None, clearance_m: self.clearance_m };
        let body = self.robot.body();
        let Body::Box { .. } = body else { return whole };
        let way_m = rotation_rad.abs() * body.reach_m();
        let steps = libm::ceil(way_m / self.settings.increment_m).max(1.0) as u32;
        let mut done = Turn { share: 0.0, ..whole };
        for step in 1..=steps {
            let share = f64::from(step) / f64::from(steps);
            let turned = self.actual.turned(rotation_rad * share);
            let clearance_m = turned.clearance_m(body, &self.world);
            if clearance_m <= 0.0 {
                return Turn { contact: Contact::Real, ..done };
            }
            done = Turn { share, contact: Contact::None, clearance_m };
        }
        done
    }

    /// Where the robot is.
    #[must_use]
    pub fn true_pose(&self) -> Pose {
        self.actual.pose
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
        self.actual.pose.distance_to(goal.centre) < goal.radius_m
    }

    /// Distance from the shell to the nearest surface, metres.
    #[must_use]
    pub fn shell_clearance_m(&self) -> f64 {
        self.clearance_m
    }

    /// Noise, missed echoes and the limits of the readings. What is switched off draws nothing.
    fn disturb(&mut self, sonar_m: &mut Readings) {
        let (noise, dropout) = (self.settings.sonar_noise, self.settings.sonar_dropout);
        for reading_m in sonar_m.iter_mut() {
            if noise > 0.0 {
                let normal: f64 = self.sonar_rng.sample(StandardNormal);
                *reading_m *= 1.0 + noise * normal;
            }
            if dropout > 0.0 && self.sonar_rng.random::<f64>() < dropout {
                *reading_m = self.settings.sonar_range_m;
            }
            *reading_m = reading_m.clamp(self.settings.sonar_least_m, self.settings.sonar_range_m);
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
            rotation_rad: STRAIGHT_RAD * k * normal(),
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

impl Stance {
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

    fn clearance_m(&self, body: Body, world: &World) -> f64 {
        body.clearance_m(world, self.pose.position(), self.direction)
    }
}

#[cfg(test)]
mod tests;
