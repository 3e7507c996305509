//! The yardstick of a learning curve: the cheapest path from home to the goal that a planner finds.
//!
//! The planner knows what the learner does not: the whole world and the cost beforehand. It minimises
//! the total penalty `-R`, Eq. (5.27), of the reinforcement of section 5.5 over headings, one a step of
//! the robot's own motion, with sensors and odometry that never err. A rotation costs nothing by
//! itself, so the position alone is the state.
//!
//! | stage | file | what it does |
//! |---|---|---|
//! | drive | `drive` | one step, to the bit as the simulator takes it without noise |
//! | search | `search` | Dijkstra's algorithm over positions, one kept for each cell of a grid |
//! | refine | `refine` | changes headings alone, in pairs and in blocks for as long as that pays |
//!
//! The search goes over the whole world first and then, on a finer grid, over a strip along the path
//! found. What comes out is a path that the robot can drive at exactly the cost named, so the best cost
//! there is can only be lower. How much lower is not proved: [`BestPath::resolution`] says what the
//! refinement gained over the finer search. In the worlds that come with the program, searches up to four
//! times as fine gained at most 0.6 % more.
//!
//! NOTE: a collision is a motion like any other here, and dear. Where a passage is too narrow for virtual
//! collisions, backing off can be the only way through, and the planner takes it.

mod drive;
mod refine;
mod search;

use crate::experiment::Settings;
use crate::geometry::Pose;
use crate::learner::Reinforcement;
use crate::robot::{Contact, Robot};
use crate::world::World;

use drive::Driver;
use search::Grid;

/// The grid over the whole world: edge of a cell in metres, headings tried at each place.
const WHOLE: (f64, u32) = (0.05, 72);
/// The grid over the strip: farthest from the path and edge of a cell in metres, headings.
const STRIP: (f64, f64, u32) = (0.2, 0.02, 144);

/// A path that cannot be bettered by much, as far as the planner sees.
#[derive(Clone, Debug, PartialEq)]
pub struct BestPath {
    /// Home with the heading of the first step, then the pose after each step.
    pub poses: Vec<Pose>,
    /// What was paid after each step; the sum is the total reinforcement.
    pub reinforcements: Vec<Reinforcement>,
    /// Steps that ended in a collision; none, unless every way round costs more.
    pub collisions: u32,
    /// What the refinement gained over the search, in reinforcement: the best path there is may be
    /// better by about as much again.
    pub resolution: f64,
}

impl BestPath {
    /// Control steps.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.reinforcements.len()
    }

    /// Total reinforcement, Eq. (5.27), summed like that of a trial.
    #[must_use]
    pub fn total_reinforcement(&self) -> f64 {
        // Eq. (5.27): R = Σ r(t)
        let safety: f64 = self.reinforcements.iter().map(|r| r.safety).sum();
        safety + self.reinforcements.iter().map(|r| r.goal).sum::<f64>()
    }

    /// Length of the path, metres.
    #[must_use]
    pub fn path_m(&self) -> f64 {
        self.poses.windows(2).map(|ends| ends[1].distance_to(ends[0].position())).sum()
    }
}

/// The cheapest path found for a robot with these settings; none when it finds no way, or the robot is
/// not round: then a rotation is not free, and the position alone is not the state. Noise, missed
/// echoes and drift are left out.
#[must_use]
pub fn best_path(world: &World, robot: &Robot, settings: &Settings) -> Option<BestPath> {
    let mut driver = Driver::new(world, robot, settings)?;
    let (cell_m, headings) = WHOLE;
    let coarse = Grid::over(world, cell_m, headings).search(&mut driver)?;
    let known = path(&mut driver, &coarse);
    let (within_m, cell_m, headings) = STRIP;
    let fine = Grid::along(&known.poses, within_m, cell_m, headings).search(&mut driver);
    // The strip holds the known path, but need not keep it: another place in a cell may be cheaper.
    let total = |driver: &mut Driver<'_>, line: &[f64]| path(driver, line).total_reinforcement();
    let better = |fine: &Vec<f64>| total(&mut driver, fine) > known.total_reinforcement();
    let searched = fine.filter(better).unwrap_or(coarse);
    let before = total(&mut driver, &searched);
    let refined = refine::refine(&mut driver, searched);
    let best = path(&mut driver, &refined);
    Some(BestPath { resolution: best.total_reinforcement() - before, ..best })
}

/// Drives headings, and then straight to the goal.
fn path(driver: &mut Driver<'_>, headings: &[f64]) -> BestPath {
    let mut place = driver.home();
    let mut path =
        BestPath { poses: Vec::new(), reinforcements: Vec::new(), collisions: 0, resolution: 0.0 };
    for step in 0..driver.most_steps(headings.len()) {
        let heading_rad = headings.get(step).copied().unwrap_or_else(|| driver.to_goal_rad(place));
        if step == 0 {
            path.poses.push(Pose::new(place.position.x, place.position.y, heading_rad));
        }
        let taken = driver.step(place, heading_rad);
        place = taken.to;
        path.poses.push(Pose::new(place.position.x, place.position.y, heading_rad));
        path.reinforcements.push(taken.reinforcement);
        path.collisions += u32::from(taken.contact != Contact::None);
        if driver.at_goal(place) {
            break;
        }
    }
    path
}

#[cfg(test)]
mod tests;
