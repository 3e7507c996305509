//! Marks: home, goal, collisions, neurons and the robot with its sonar cones.

use super::{Canvas, rimmed_stroke};
use crate::render::scene::{Point, Primitive, Scene, Stroke};
use crate::render::view::{ConeView, NeuronMark, RobotPose, RobotView};
use std::f32::consts::{FRAC_PI_2, TAU};

impl Canvas<'_> {
    pub(super) fn goal(&self, scene: &mut Scene) {
        let Some(centre) = self.goal_place() else { return };
        let radius = self.at.length(self.view.goal_radius_m);
        scene.disc(centre, radius, self.theme.goal.fade(0.16));
        scene.ring(centre, radius, self.px(1.8).max(1.0), self.theme.goal);
        scene.disc(centre, self.px(2.6).max(1.2).min(radius), self.theme.goal);
    }

    /// The goal's centre, if there is a goal.
    pub(super) fn goal_place(&self) -> Option<Point> {
        let exists = self.view.goal_radius_m > 0.0;
        self.at.place(self.view.goal_m).filter(|_| exists)
    }

    /// A square ring with a tick towards the heading every trial begins with.
    pub(super) fn home(&self, scene: &mut Scene) {
        let Some(centre) = self.at.place(self.view.home.at_m) else { return };
        let half = self.px(5.5).max(2.5);
        self.square(scene, centre, half);
        if self.view.home.heading_rad.is_finite() {
            let angle = screen_angle(self.view.home.heading_rad);
            let tick = vec![toward(centre, angle, half), toward(centre, angle, 2.2 * half)];
            rimmed_stroke(
                scene,
                tick,
                self.px(1.8).max(1.0),
                self.theme.ink,
                self.theme.background,
            );
        }
    }

    pub(super) fn square(&self, scene: &mut Scene, [x, y]: Point, half: f32) {
        let at = |h: f32| vec![[x - h, y - h], [x + h, y - h], [x + h, y + h], [x - h, y + h]];
        let width = self.px(1.8).max(1.0);
        scene.polygon(at(half), self.theme.background);
        scene.outline(at(half), width, self.theme.ink);
        scene.disc([x, y], 0.35 * half, self.theme.ink);
    }

    pub(super) fn collisions(&self, scene: &mut Scene) {
        for place in self.at.places(&self.view.collisions_m) {
            self.cross(scene, place);
        }
    }

    pub(super) fn cross(&self, scene: &mut Scene, [x, y]: Point) {
        let (reach, width) = (self.px(5.0).max(2.5), self.px(2.2).max(1.2));
        let lines = [
            vec![[x - reach, y - reach], [x + reach, y + reach]],
            vec![[x - reach, y + reach], [x + reach, y - reach]],
        ];
        for line in &lines {
            scene.stroke(line.clone(), width + self.px(2.4), self.theme.background);
        }
        for line in lines {
            scene.stroke(line, width, self.theme.collision);
        }
    }

    /// All neurons but the winner.
    pub(super) fn neurons(&self, scene: &mut Scene) {
        for neuron in self.view.neurons.iter().filter(|neuron| !neuron.winner) {
            self.neuron(scene, neuron);
        }
    }

    /// The winner, ringed.
    pub(super) fn winners(&self, scene: &mut Scene) {
        for neuron in self.view.neurons.iter().filter(|neuron| neuron.winner) {
            if let Some(centre) = self.at.place(neuron.at_m) {
                self.winner_ring(scene, centre);
            }
            self.neuron(scene, neuron);
        }
    }

    pub(super) fn winner_ring(&self, scene: &mut Scene, centre: Point) {
        let radius = self.px(8.5).max(4.0);
        scene.disc(centre, radius + self.px(2.2), self.theme.background);
        scene.ring(centre, radius, self.px(2.0).max(1.0), self.theme.ink);
    }

    fn neuron(&self, scene: &mut Scene, neuron: &NeuronMark) {
        let Some(centre) = self.at.place(neuron.at_m) else { return };
        let heading = neuron.heading_rad.is_finite().then(|| screen_angle(neuron.heading_rad));
        self.neuron_at(scene, centre, neuron.utility, heading);
    }

    /// A disc that grows and brightens with the utility, hollow while that is pending.
    pub(super) fn neuron_at(
        &self,
        scene: &mut Scene,
        centre: Point,
        utility: Option<f64>,
        heading: Option<f32>,
    ) {
        let ink = self.theme.ink.fade(0.85);
        let share = utility.filter(|u| u.is_finite()).unwrap_or(0.3).clamp(0.0, 1.0) as f32;
        let radius = self.px(3.2 + 1.6 * share).max(1.4);
        let line = self.px(0.9).max(0.5);
        if let Some(angle) = heading {
            let tick =
                vec![toward(centre, angle, radius), toward(centre, angle, radius + self.px(5.5))];
            scene.stroke(tick, self.px(1.5).max(0.8), ink);
        }
        match utility {
            Some(utility) => {
                scene.disc(centre, radius + line, ink);
                scene.disc(centre, radius, self.theme.utility(utility));
            }
            None => scene.ring(centre, radius, 1.6 * line, ink),
        }
    }

    /// What the sonars measured: a sector from the shell to the reading, its far end stressed.
    pub(super) fn cones(&self, scene: &mut Scene) {
        let Some(robot) = self.view.robot.as_ref() else { return };
        let half = (robot.cone_rad / 2.0) as f32;
        if !half.is_finite() || half <= 0.0 || !robot.pose.heading_rad.is_finite() {
            return;
        }
        let half = half.min(FRAC_PI_2);
        for (cone, &reading_m) in robot.cones.iter().zip(&robot.sonar_m) {
            self.cone(scene, robot, *cone, reading_m, half);
        }
    }

    fn cone(
        &self,
        scene: &mut Scene,
        robot: &RobotView,
        cone: ConeView,
        reading_m: f64,
        half: f32,
    ) {
        let heading = robot.pose.heading_rad + cone.axis_rad;
        let at_m = on_robot(&robot.pose, cone.at_m);
        let (Some(apex), true) = (self.at.place(at_m), reading_m > 0.0) else { return };
        // A sonar that hears nothing answers its range: no surface stands there.
        let echo = reading_m < robot.range_m;
        let reach = self.at.length(if robot.range_m > 0.0 {
            reading_m.min(robot.range_m)
        } else {
            reading_m
        });
        let turn = [screen_angle(heading) - half, 2.0 * half];
        let cone = self.theme.cone;
        scene.arc(apex, [0.0, reach], turn, cone.fade(if echo { 0.11 } else { 0.05 }));
        if echo {
            let inner = (reach - self.px(1.6).max(0.9)).max(0.0);
            scene.arc(apex, [inner, reach], turn, cone.fade(0.8));
        }
    }

    /// The robot's floor area, below the neurons it stands on.
    pub(super) fn shell(&self, scene: &mut Scene) {
        let Some(robot) = self.view.robot.as_ref() else { return };
        let ground = self.theme.background.fade(0.6);
        match (self.at.place(robot.pose.at_m), robot.corners_m.is_empty()) {
            (Some(centre), true) => scene.disc(centre, self.shell_px(robot), ground),
            (Some(_), false) => scene.polygon(self.outline(robot, &robot.pose), ground),
            (None, _) => {}
        }
    }

    /// The robot's outline with a nose towards its heading, and the pose it believes in.
    pub(super) fn robot(&self, scene: &mut Scene) {
        let Some(robot) = self.view.robot.as_ref() else { return };
        let radius = self.shell_px(robot);
        if differs(robot) {
            self.believed(scene, robot, radius);
        }
        let Some(centre) = self.at.place(robot.pose.at_m) else { return };
        let edge = if robot.collided { self.theme.collision } else { self.theme.robot };
        let width = self.px(if robot.collided { 3.2 } else { 2.2 }).max(1.0);
        if robot.corners_m.is_empty() {
            scene.ring(centre, radius, width, edge);
        } else {
            scene.outline(self.outline(robot, &robot.pose), width, edge);
        }
        if robot.pose.heading_rad.is_finite() {
            let angle = screen_angle(robot.pose.heading_rad);
            scene.polygon(nose(centre, angle, self.front_px(robot)), edge);
        }
        if robot.collided {
            self.cross(scene, [centre[0], centre[1] + radius]);
        }
    }

    fn shell_px(&self, robot: &RobotView) -> f32 {
        self.at.length(robot.radius_m).max(self.px(4.0))
    }

    /// Way from the centre to the front, where the nose sits.
    fn front_px(&self, robot: &RobotView) -> f32 {
        let front_m = robot.corners_m.iter().map(|[x, _]| *x).reduce(f64::max);
        front_m.map_or_else(|| self.shell_px(robot), |front_m| self.at.length(front_m))
    }

    /// The outline of a body that is not round, at a pose.
    fn outline(&self, robot: &RobotView, pose: &RobotPose) -> Vec<Point> {
        let corners: Vec<[f64; 2]> =
            robot.corners_m.iter().map(|corner| on_robot(pose, *corner)).collect();
        self.at.places(&corners)
    }

    /// The dashed outline of the pose the robot believes in.
    fn believed(&self, scene: &mut Scene, robot: &RobotView, radius: f32) {
        let pose = &robot.believed;
        let Some(centre) = self.at.place(pose.at_m) else { return };
        let circle = |i: u16| toward(centre, TAU * f32::from(i) / 64.0, radius);
        let round = robot.corners_m.is_empty();
        let width = self.px(1.8).max(1.0);
        let stroke = Stroke { width, colour: self.theme.robot, ..Stroke::default() };
        scene.push(Primitive::Stroke(Stroke {
            points: if round { (0..64).map(circle).collect() } else { self.outline(robot, pose) },
            dash: Some(believed_dash(width)),
            closed: true,
            ..stroke.clone()
        }));
        if pose.heading_rad.is_finite() {
            let points = nose(centre, screen_angle(pose.heading_rad), self.front_px(robot));
            scene.push(Primitive::Stroke(Stroke { points, ..stroke }));
        }
    }
}

/// Dashes and gaps of the believed pose's outline.
pub(super) fn believed_dash(width: f32) -> [f32; 2] {
    [2.0 * width, 2.4 * width]
}

/// A nose on the front of the shell: inside it would be hidden by neurons and the winner's ring.
pub(super) fn nose(centre: Point, angle: f32, radius: f32) -> Vec<Point> {
    vec![
        toward(centre, angle - 0.42, radius),
        toward(centre, angle, 1.45 * radius),
        toward(centre, angle + 0.42, radius),
    ]
}

/// A place in the robot's frame as one of the world, metres.
fn on_robot(pose: &RobotPose, [ahead, left]: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = pose.heading_rad.sin_cos();
    let [x, y] = pose.at_m;
    [x + ahead * cos - left * sin, y + ahead * sin + left * cos]
}

/// Headings turn counter-clockwise in the world; angles turn clockwise on the screen.
fn screen_angle(heading_rad: f64) -> f32 {
    -(heading_rad.rem_euclid(std::f64::consts::TAU)) as f32
}

pub(super) fn toward([x, y]: Point, angle: f32, length: f32) -> Point {
    [x + length * angle.cos(), y + length * angle.sin()]
}

/// The believed pose is off by more than a centimetre or a degree.
pub(super) fn differs(robot: &RobotView) -> bool {
    let (pose, believed) = (&robot.pose, &robot.believed);
    let apart_m = (pose.at_m[0] - believed.at_m[0]).hypot(pose.at_m[1] - believed.at_m[1]);
    let turn = pose.heading_rad - believed.heading_rad;
    apart_m > 0.01 || turn.sin().hypot(1.0 - turn.cos()) > 1_f64.to_radians()
}
