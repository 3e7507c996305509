//! Altered starts: what a trained network does from elsewhere.

use sonarium_core::experiment::{AlteredStart, Excursion};
use sonarium_core::geometry::{Pose, Vec2};

use super::arena::Scenery;
use super::run::Run;
use crate::catalog::{FieldError, Plan};
use crate::render::ArenaView;
use crate::wire::{AlteredStartView, ExcursionView, StartView};

/// Most starts asked for at once.
pub const MOST_STARTS: usize = 64;

/// Checks that a plan's robot can stand at every start.
///
/// # Errors
/// The first start at fault; the field is `start`.
pub fn check_starts(plan: &Plan, starts: &[StartView]) -> Result<(), FieldError> {
    if starts.len() > MOST_STARTS {
        let message = format!("at most {MOST_STARTS} starts at once, not {}", starts.len());
        return Err(FieldError::new("start", message));
    }
    starts.iter().try_for_each(|start| check_start(plan, start))
}

fn check_start(plan: &Plan, start: &StartView) -> Result<(), FieldError> {
    let refuse = |why: String| Err(FieldError::new("start", format!("{} {why}", start.name)));
    if ![start.x_m, start.y_m, start.heading_deg].iter().all(|number| number.is_finite()) {
        return refuse("must be three numbers: x and y in metres, heading in degrees".into());
    }
    let (world, pose) = (&plan.world.world, pose(start));
    let [x0, y0, x1, y1] = world.bounds_m();
    if !(x0..=x1).contains(&start.x_m) || !(y0..=y1).contains(&start.y_m) {
        return refuse(format!("must lie within the world, x {x0} to {x1} m, y {y0} to {y1} m"));
    }
    let clearance_m = plan.robot.body().clearance_m(world, pose.position(), pose.direction());
    if clearance_m <= 0.0 || world.clearance_m(pose.position()) <= 0.0 {
        return refuse(format!(
            "must leave room for the {}, which would touch a wall",
            plan.robot.title()
        ));
    }
    Ok(())
}

impl Run {
    /// What the networks do, as they are now, from each of these starts.
    #[must_use]
    pub fn altered_starts(&self, starts: &[StartView]) -> Vec<AlteredStartView> {
        let numbered = (0..).zip(starts);
        numbered
            .map(|(number, start)| view(start, &self.machine().altered_start(pose(start), number)))
            .collect()
    }
}

impl AlteredStartView {
    /// The same without the paths.
    #[must_use]
    pub fn without_paths(self) -> Self {
        let bare = |excursion| ExcursionView { path_m: Vec::new(), ..excursion };
        Self { alone: bare(self.alone), guided: bare(self.guided), ..self }
    }
}

/// The ways from altered starts, those of the network alone.
#[must_use]
pub fn starts_arena(scenery: &Scenery, starts: &[AlteredStartView]) -> ArenaView {
    let ends = starts.iter().filter(|start| start.alone.collisions > 0);
    let reached = starts.iter().filter(|start| start.alone.reached_goal).count();
    ArenaView {
        earlier_paths_m: starts.iter().map(|start| start.alone.path_m.clone()).collect(),
        collisions_m: ends.filter_map(|start| start.alone.path_m.last().copied()).collect(),
        caption: format!("Altered starts: {reached} of {} reached the goal", starts.len()),
        ..scenery.empty()
    }
}

fn view(start: &StartView, found: &AlteredStart) -> AlteredStartView {
    AlteredStartView {
        start: start.clone(),
        inside: found.inside,
        explored_m: found.explored_m,
        alone: excursion(&found.alone),
        guided: excursion(&found.guided),
    }
}

fn excursion(excursion: &Excursion) -> ExcursionView {
    let share = f64::from(excursion.silent_steps) / f64::from(excursion.steps.max(1));
    ExcursionView {
        reached_goal: excursion.reached_goal,
        steps: excursion.steps,
        total_reinforcement: excursion.total_reinforcement,
        collisions: excursion.collisions,
        silent_pct: 100.0 * share,
        path_m: excursion.path.iter().map(|place: &Vec2| [place.x, place.y]).collect(),
    }
}

fn pose(start: &StartView) -> Pose {
    Pose::new(start.x_m, start.y_m, start.heading_deg.to_radians())
}
