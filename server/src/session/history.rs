//! A session that nobody runs, as the store knows it.

use std::sync::Arc;

use super::arena::world_view;
use super::feed::{Feed, Snapshot};
use super::paths::Paths;
use super::state::Condition;
use crate::catalog::Plan;
use crate::store::{SessionRow, Store, StoreError};
use crate::wire::{NeuronView, Session, State, TickView, Trial};

/// Lines of the event log that are read.
const LINES: usize = 500;
/// Most ticks read to draw where the robot has been.
const TICKS: u64 = 20_000;

/// A stored session as it travels.
pub(super) fn session(
    store: &Store,
    row: SessionRow,
    changed: Vec<String>,
) -> Result<Session, StoreError> {
    let trials = store.trials(&row.id)?;
    let checkpoint = row.state == State::Failed && store.checkpoint(&row.id)?.is_some();
    let condition = Condition { state: row.state, waiting: false, checkpoint };
    let mut session = Session {
        controls: condition.controls().iter().map(|control| (*control).to_owned()).collect(),
        id: row.id,
        experiment: row.experiment,
        state: row.state,
        reason: row.reason,
        seed: row.seed,
        preset: row.preset,
        world: row.world,
        settings: row.settings,
        changed,
        trials: row.trials,
        trials_done: row.trials_done,
        reached: 0,
        best: None,
        tick: row.tick,
        speed: row.speed,
        build: row.build,
        created_at: row.created_at,
        changed_at: row.changed_at,
    };
    session.count(&trials);
    Ok(session)
}

/// What viewers see of a stored session.
pub(super) fn feed(store: &Store, plan: &Plan, session: Session) -> Result<Feed, StoreError> {
    let id = session.id.clone();
    let trials = store.trials(&id)?;
    let ticks = last_ticks(store, &session)?;
    let snapshot = Snapshot {
        paths: paths(&trials, &ticks),
        neurons: Arc::new(neurons(store, &id, trials.last())?),
        tick: ticks.into_iter().last().map(Arc::new),
        session,
    };
    let log = store.events(&id, LINES)?;
    Ok(Feed::new(Arc::new(world_view(plan)), snapshot, trials, log))
}

fn last_ticks(store: &Store, session: &Session) -> Result<Vec<TickView>, StoreError> {
    match session.tick {
        0 => Ok(Vec::new()),
        last => store.ticks(&session.id, last.saturating_sub(TICKS).max(1), last),
    }
}

/// The neurons after the last trial that ended.
fn neurons(store: &Store, id: &str, last: Option<&Trial>) -> Result<Vec<NeuronView>, StoreError> {
    let Some(last) = last else { return Ok(Vec::new()) };
    let end = store.trial_end(id, last.trial)?;
    let without_centre = |neuron| NeuronView { centre: Vec::new(), ..neuron };
    Ok(end.map_or_else(Vec::new, |end| end.neurons.into_iter().map(without_centre).collect()))
}

fn paths(trials: &[Trial], ticks: &[TickView]) -> Paths {
    let mut paths = Paths::default();
    for tick in ticks {
        paths.follow(tick);
        // Trials follow one another, so the one that holds a tick is found by halving.
        let trial = trials.partition_point(|trial| trial.last_tick < tick.tick);
        if let Some(trial) = trials.get(trial).filter(|trial| trial.last_tick == tick.tick) {
            paths.end_trial(trial.record);
        }
    }
    paths
}
