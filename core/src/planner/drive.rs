//! One step as the simulator takes it, by a robot whose sensors and odometry never err.

use crate::experiment::Settings;
use crate::geometry::{Pose, Vec2, angle, unit};
use crate::learner::{LearnerSettings, Reinforcement, RewardSettings, reinforcement};
use crate::robot::{Body, Contact, Course, Mount, Readings, Robot, SimulationSettings};
use crate::world::{Goal, RayFan, RayRing, World};

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
    /// What the step costs, at least 0; infinite when it ends the trial without the goal.
    pub(super) penalty: f64,
}

/// The robot's motion and reinforcement in a world.
pub(super) struct Driver<'a> {
    world: &'a World,
    body: Body,
    sonars: usize,
    simulation: SimulationSettings,
    reward: RewardSettings,
    ring: RayRing,
    /// Clearance at which no sonar can read less than `d_c`, metres.
    apart_m: f64,
    goal: Goal,
}

impl<'a> Driver<'a> {
    /// A driver of a round robot; none of another, whose clearance depends on its heading.
    pub(super) fn new(world: &'a World, robot: &Robot, settings: &Settings) -> Option<Self> {
        let Body::Round { radius_m } = robot.body() else { return None };
        let simulation = settings.simulation();
        let reward = LearnerSettings::from(settings).reward;
        let fans: Vec<RayFan> = robot.sonars().iter().map(Mount::fan).collect();
        let ring = RayRing::new(
            &fans,
            simulation.sonar_rays,
            simulation.sonar_cone_rad,
            simulation.sonar_range_m,
            simulation.sonar_critical_rad,
        );
        // A sonar outside the shell is nearer to a wall than the shell by at most so much.
        let outside_m = fans.iter().map(|fan| fan.place.norm() - radius_m).fold(0.0, f64::max);
        Some(Self {
            world,
            body: robot.body(),
            sonars: fans.len(),
            simulation,
            apart_m: reward.close_m + outside_m,
            reward,
            ring,
            goal: world.goal(),
        })
    }

    /// Where every path starts.
    pub(super) fn home(&self) -> Place {
        let home = self.world.home();
        let clearance_m = self.body.clearance_m(self.world, home.position(), home.direction());
        Place { position: home.position(), clearance_m }
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
        given + libm::ceil(across_m / self.simulation.advance_m) as usize + 1
    }

    /// Where a step leads when nothing is in the way, and what it costs at least; none when something
    /// may be in the way.
    pub(super) fn free_step(&self, from: Place, heading_rad: f64) -> Option<(Vec2, f64)> {
        let clear_m = self.simulation.virtual_collision_m().max(0.0);
        if from.clearance_m - self.simulation.advance_m <= clear_m {
            return None;
        }
        let position = from.position + unit(heading_rad) * self.simulation.advance_m;
        let bearing_rad =
            Pose::new(position.x, position.y, heading_rad).bearing_to(self.goal.centre);
        let least = reinforcement(&self.reward, &[f64::INFINITY], Contact::None, bearing_rad);
        Some((position, -least.total()))
    }

    /// Advances along a heading, with the rescue if that ends in a collision.
    pub(super) fn step(&mut self, from: Place, heading_rad: f64) -> Taken {
        let direction = unit(heading_rad);
        let course = Course {
            world: self.world,
            body: self.body,
            settings: &self.simulation,
            start: from.position,
            direction,
            start_clearance_m: from.clearance_m,
        };
        let way = course.travel(Contact::None);
        let position = from.position + direction * (way.advanced_m - way.backed_m);
        let to = Place { position, clearance_m: way.clearance_m };
        let bearing_rad =
            Pose::new(position.x, position.y, heading_rad).bearing_to(self.goal.centre);
        let near = way.contact == Contact::None && to.clearance_m < self.apart_m;
        let readings_m = if near { self.scan(position, direction) } else { self.nothing() };
        let reinforcement = reinforcement(&self.reward, &readings_m, way.contact, bearing_rad);
        let killed = way.contact != Contact::None && !self.simulation.rescue;
        let penalty = if killed { f64::INFINITY } else { -reinforcement.total() };
        Taken { to, contact: way.contact, reinforcement, penalty }
    }

    fn scan(&mut self, position: Vec2, direction: Vec2) -> Readings {
        let mut readings_m = self.nothing();
        self.ring.scan(self.world, position, direction, &mut readings_m);
        let (least_m, range_m) = (self.simulation.sonar_least_m, self.simulation.sonar_range_m);
        readings_m.iter_mut().for_each(|reading_m| *reading_m = reading_m.clamp(least_m, range_m));
        readings_m
    }

    /// Readings where nothing is within the sonars' range.
    fn nothing(&self) -> Readings {
        std::iter::repeat_n(self.simulation.sonar_range_m, self.sonars).collect()
    }
}
