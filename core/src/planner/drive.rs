//! One step as the simulator takes it, by a robot whose sensors and odometry never err.

use crate::experiment::Settings;
use crate::geometry::{Pose, Vec2, angle, unit};
use crate::learner::{LearnerSettings, Reinforcement, RewardSettings, reinforcement};
use crate::robot::{B21Settings, Contact, Course, SONARS};
use crate::world::{Goal, RayRing, World};

/// Where the robot stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    /// Centre, metres.
    pub(super) position: Vec2,
    /// Clearance of the shell, metres.
    pub(super) clearance_m: f64,
}

/// What a step led to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Taken {
    pub(super) to: Place,
    pub(super) contact: Contact,
    pub(super) reinforcement: Reinforcement,
}

impl Taken {
    /// What the step costs, at least 0.
    pub(super) fn penalty(&self) -> f64 {
        -self.reinforcement.total()
    }
}

/// The robot's motion and reinforcement in a world.
pub(super) struct Driver<'a> {
    world: &'a World,
    robot: B21Settings,
    reward: RewardSettings,
    ring: RayRing,
    goal: Goal,
}

impl<'a> Driver<'a> {
    pub(super) fn new(world: &'a World, settings: &Settings) -> Self {
        let robot = settings.robot();
        Self {
            world,
            reward: LearnerSettings::from(settings).reward,
            ring: RayRing::new(
                SONARS,
                robot.sonar_rays,
                robot.sonar_cone_rad,
                robot.radius_m,
                robot.sonar_range_m,
                robot.sonar_critical_rad,
            ),
            goal: world.goal(),
            robot,
        }
    }

    /// Where every path starts.
    pub(super) fn home(&self) -> Place {
        let position = self.world.home().position();
        let clearance_m = self.world.surface_distance_m(position) - self.robot.radius_m;
        Place { position, clearance_m }
    }

    /// Heading from a place to the centre of the goal.
    pub(super) fn to_goal_rad(&self, place: Place) -> f64 {
        angle(self.goal.centre - place.position)
    }

    /// Whether a place is inside the goal.
    pub(super) fn at_goal(&self, place: Place) -> bool {
        (place.position - self.goal.centre).norm() < self.goal.radius_m
    }

    /// Steps after which a path that begins with `given` headings and then goes straight to the goal
    /// has missed it.
    pub(super) fn most_steps(&self, given: usize) -> usize {
        let [x0, y0, x1, y1] = self.world.bounds_m();
        let across_m = (x1 - x0) + (y1 - y0);
        given + libm::ceil(across_m / self.robot.advance_m) as usize + 1
    }

    /// Where a step leads when nothing is in the way, and what it costs at least; none when something
    /// may be in the way.
    pub(super) fn free_step(&self, from: Place, heading_rad: f64) -> Option<(Vec2, f64)> {
        let clear_m = self.robot.virtual_collision_m().max(0.0);
        if from.clearance_m - self.robot.advance_m <= clear_m {
            return None;
        }
        let position = from.position + unit(heading_rad) * self.robot.advance_m;
        Some((position, -self.judge(position, heading_rad, Contact::None, None).total()))
    }

    /// Advances along a heading, with the rescue if that ends in a collision.
    pub(super) fn step(&mut self, from: Place, heading_rad: f64) -> Taken {
        let direction = unit(heading_rad);
        let course = Course {
            world: self.world,
            settings: &self.robot,
            start: from.position,
            direction,
            start_clearance_m: from.clearance_m,
        };
        let way = course.travel();
        let position = from.position + direction * (way.advanced_m - way.backed_m);
        let to = Place { position, clearance_m: way.clearance_m };
        // No reading is less than the clearance.
        let near = way.contact == Contact::None && to.clearance_m < self.reward.close_m;
        let readings_m = near.then(|| self.scan(position, direction));
        let reinforcement = self.judge(position, heading_rad, way.contact, readings_m);
        Taken { to, contact: way.contact, reinforcement }
    }

    fn scan(&mut self, position: Vec2, direction: Vec2) -> [f64; SONARS] {
        let mut readings_m = [0.0; SONARS];
        self.ring.scan(self.world, position, direction, &mut readings_m);
        readings_m
    }

    /// The reinforcement of a place; where nothing was read, nothing is within the sonars' range.
    fn judge(
        &self,
        position: Vec2,
        heading_rad: f64,
        contact: Contact,
        readings_m: Option<[f64; SONARS]>,
    ) -> Reinforcement {
        let pose = Pose::new(position.x, position.y, heading_rad);
        let bearing_rad = pose.bearing_to(self.goal.centre);
        let readings_m = readings_m.unwrap_or([self.robot.sonar_range_m; SONARS]);
        reinforcement(&self.reward, &readings_m, contact, bearing_rad)
    }
}
