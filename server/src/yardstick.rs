//! The best path a planner finds, and the regret of trials against it.
//!
//! Planning takes about a second and depends on the world and on few settings, so a path is planned
//! once a process for each such task. A session never waits for it: its actor knows nothing of it, and
//! its viewers are told when it is there.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use sonarium_core::learner::LearnerSettings;
use sonarium_core::planner::{BestPath, best_path};
use sonarium_core::robot::SimulationSettings;

use crate::catalog::Plan;
use crate::wire::{PlannedPath, Trial, Yardstick};

/// Tasks remembered.
const MOST_TASKS: usize = 64;

/// A yardstick that is there, or on its way.
type Entry = Arc<OnceLock<Yardstick>>;

static TASKS: Mutex<BTreeMap<String, Entry>> = Mutex::new(BTreeMap::new());

/// The yardstick of a plan as far as it is known now.
#[must_use]
pub fn known(plan: &Plan) -> Yardstick {
    entry(plan).get().cloned().unwrap_or(Yardstick::Computing)
}

/// The yardstick of a plan, computed now if need be.
#[must_use]
pub fn compute(plan: &Plan) -> Yardstick {
    let planned = || best_path(&plan.world.world, &plan.robot, &plan.settings);
    let entry = entry(plan);
    let known = entry.get_or_init(|| {
        planned().map_or(Yardstick::None, |path| Yardstick::Ready(PlannedPath::from(&path)))
    });
    known.clone()
}

impl Yardstick {
    /// The planned path, when it is there.
    #[must_use]
    pub fn ready(&self) -> Option<&PlannedPath> {
        match self {
            Self::Ready(path) => Some(path),
            Self::Computing | Self::None => None,
        }
    }

    /// Regret of a trial: R* − R(n), with the goal where it truly was, since the planner knows where that is.
    /// A capped trial has no defined R(n) (section 5.11).
    #[must_use]
    pub fn regret(&self, trial: &Trial) -> Option<f64> {
        let best = self.ready().filter(|_| trial.reached_goal)?;
        Some(best.total_reinforcement - trial.true_total_reinforcement())
    }

    /// The same in percent of R*; none when the best path costs nothing.
    #[must_use]
    pub fn regret_pct(&self, trial: &Trial) -> Option<f64> {
        let cost = -self.ready()?.total_reinforcement;
        self.regret(trial).filter(|_| cost > 0.0).map(|regret| 100.0 * regret / cost)
    }

    /// A trial with its regret.
    #[must_use]
    pub fn mark(&self, trial: Trial) -> Trial {
        Trial { regret: self.regret(&trial), ..trial }
    }
}

impl From<&BestPath> for PlannedPath {
    fn from(path: &BestPath) -> Self {
        Self {
            total_reinforcement: path.total_reinforcement(),
            steps: u32::try_from(path.steps()).unwrap_or(u32::MAX),
            collisions: path.collisions,
            resolution: path.resolution,
            path_m: path.poses.iter().map(|pose| [pose.x_m, pose.y_m]).collect(),
        }
    }
}

fn entry(plan: &Plan) -> Entry {
    let mut tasks = TASKS.lock().unwrap_or_else(PoisonError::into_inner);
    let key = task(plan);
    if !tasks.contains_key(&key) && tasks.len() >= MOST_TASKS {
        tasks.pop_first();
    }
    tasks.entry(key).or_default().clone()
}

/// What the best path depends on: the world, the robot, how it moves and what it is paid. It senses and
/// moves without error.
fn task(plan: &Plan) -> String {
    let simulation = SimulationSettings {
        sonar_noise: 0.0,
        sonar_dropout: 0.0,
        odometry_drift: 0.0,
        ..plan.settings.simulation()
    };
    let reward = LearnerSettings::from(&plan.settings).reward;
    format!("{}\n{:?}\n{simulation:?}\n{reward:?}", plan.world.text, plan.robot)
}
