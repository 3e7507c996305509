//! The world as the page needs it, and the arena as it is drawn.

use sonarium_core::geometry::Pose;
use sonarium_core::robot::Mount;
use sonarium_core::world::World;

use super::Snapshot;
use crate::catalog::Plan;
use crate::render::view::{ArenaView, ConeView, NeuronMark, RegionView, RobotPose, RobotView};
use crate::wire::{NeuronView, PoseView, SonarView, TickView, WorldView, Yardstick};

/// What of a picture stays the same while a session runs.
#[derive(Clone, Debug)]
pub struct Scenery {
    empty: ArenaView,
    regions: Vec<String>,
    robot: RobotView,
}

impl Scenery {
    /// The scenery of a plan.
    #[must_use]
    pub fn new(plan: &Plan) -> Self {
        let names = plan.names();
        Self {
            empty: empty_arena(&plan.world.world, &names.regions),
            regions: names.regions,
            robot: still_robot(plan),
        }
    }

    /// The world without robot or neurons.
    #[must_use]
    pub fn empty(&self) -> ArenaView {
        self.empty.clone()
    }

    /// The present of a robot's session, with the path that a planner finds once it is known.
    #[must_use]
    pub fn live(&self, snapshot: &Snapshot, yardstick: &Yardstick) -> ArenaView {
        let Some(present) = snapshot.present.path() else { return self.empty() };
        let (paths, tick) = (&present.paths, present.tick.as_deref());
        ArenaView {
            earlier_paths_m: paths.earlier.iter().map(|path| path.to_vec()).collect(),
            planned_path_m: planned(yardstick),
            best_path_m: paths.best.as_deref().cloned().unwrap_or_default(),
            path_m: paths.present.clone(),
            collisions_m: paths.collisions.clone(),
            neurons: self.neurons(&present.neurons, tick.and_then(|tick| tick.neuron)),
            robot: tick.map(|tick| self.robot(tick)),
            caption: tick.map_or_else(|| "Not started".into(), caption),
            ..self.empty()
        }
    }

    /// The robot where it took the readings of a tick, since cones belong to the place they were
    /// measured from; at the goal, when that is where the tick led, and then without cones.
    #[must_use]
    pub fn robot(&self, tick: &TickView) -> RobotView {
        let arrived = tick.outcome.reached_goal;
        let (pose, believed) = if arrived {
            (tick.outcome.true_pose, tick.outcome.pose)
        } else {
            (tick.true_pose, tick.pose)
        };
        RobotView {
            pose: robot_pose(pose),
            believed: robot_pose(believed),
            sonar_m: if arrived { Vec::new() } else { tick.sonar_m.clone() },
            collided: tick.outcome.contact != "none",
            ..self.robot.clone()
        }
    }

    /// Neurons as they are drawn.
    #[must_use]
    pub fn neurons(&self, neurons: &[NeuronView], winner: Option<u32>) -> Vec<NeuronMark> {
        let utilities = neurons.iter().filter_map(|neuron| neuron.utility);
        let worst = utilities.clone().fold(f64::INFINITY, f64::min);
        let best = utilities.fold(f64::NEG_INFINITY, f64::max);
        let scaled =
            |utility: f64| if best > worst { (utility - worst) / (best - worst) } else { 1.0 };
        let mark = |neuron: &NeuronView| NeuronMark {
            at_m: [neuron.birth.pose.x_m, neuron.birth.pose.y_m],
            heading_rad: neuron.heading_deg.to_radians(),
            region: self.regions.iter().position(|name| *name == neuron.region).unwrap_or(0),
            utility: neuron.utility.map(scaled),
            winner: Some(neuron.id) == winner,
        };
        neurons.iter().map(mark).collect()
    }
}

/// The path that a planner finds; nothing while it is not known.
#[must_use]
pub(super) fn planned(yardstick: &Yardstick) -> Vec<[f64; 2]> {
    yardstick.ready().map_or_else(Vec::new, |path| path.path_m.clone())
}

/// The world as the page needs it.
#[must_use]
pub fn world_view(plan: &Plan) -> WorldView {
    let (world, robot) = (&plan.world.world, &plan.robot);
    WorldView {
        name: plan.world.name.clone(),
        title: world.title().to_owned(),
        bounds_m: world.bounds_m(),
        walls_m: walls(world),
        regions: plan.names().regions,
        home: world.home().into(),
        goal_m: [world.goal().centre.x, world.goal().centre.y],
        goal_radius_m: world.goal().radius_m,
        robot_radius_m: robot.body().reach_m(),
        robot_corners_m: points(&robot.body().corners()),
        sonar_range_m: plan.settings.sonar_range_m,
        sonars: robot.sonars().iter().map(SonarView::from).collect(),
    }
}

impl From<&Mount> for SonarView {
    fn from(mount: &Mount) -> Self {
        Self { x_m: mount.place.x, y_m: mount.place.y, bearing_deg: mount.axis_deg }
    }
}

/// What of a plan's robot does not change while it drives.
fn still_robot(plan: &Plan) -> RobotView {
    let body = plan.robot.body();
    let cone =
        |mount: &Mount| ConeView { at_m: [mount.place.x, mount.place.y], axis_rad: mount.axis_rad };
    RobotView {
        radius_m: body.reach_m(),
        corners_m: points(&body.corners()),
        cones: plan.robot.sonars().iter().map(cone).collect(),
        cone_rad: plan.settings.sonar_cone_deg.to_radians(),
        range_m: plan.settings.sonar_range_m,
        ..RobotView::default()
    }
}

/// An arena without robot, paths or neurons.
#[must_use]
pub fn empty_arena(world: &World, regions: &[String]) -> ArenaView {
    let polygons = |index: usize| world.region_polygons(index).iter().map(|p| points(p)).collect();
    let region = |(index, name): (usize, &String)| RegionView {
        name: name.clone(),
        polygons_m: polygons(index),
    };
    ArenaView {
        bounds_m: world.bounds_m(),
        walls_m: walls(world),
        blocks_m: world.blocks().iter().map(|block| points(block)).collect(),
        regions: regions.iter().enumerate().map(region).collect(),
        home: home(world.home()),
        goal_m: [world.goal().centre.x, world.goal().centre.y],
        goal_radius_m: world.goal().radius_m,
        ..ArenaView::default()
    }
}

fn caption(tick: &TickView) -> String {
    format!("Trial {}, step {}", tick.trial, tick.step)
}

fn walls(world: &World) -> Vec<[f64; 4]> {
    world.walls().iter().map(|wall| [wall.a.x, wall.a.y, wall.b.x, wall.b.y]).collect()
}

fn points(polygon: &[sonarium_core::geometry::Vec2]) -> Vec<[f64; 2]> {
    polygon.iter().map(|point| [point.x, point.y]).collect()
}

fn home(pose: Pose) -> RobotPose {
    RobotPose { at_m: [pose.x_m, pose.y_m], heading_rad: pose.heading_rad }
}

fn robot_pose(pose: PoseView) -> RobotPose {
    RobotPose { at_m: [pose.x_m, pose.y_m], heading_rad: pose.heading_deg.to_radians() }
}
