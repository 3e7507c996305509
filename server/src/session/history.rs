//! A session that nobody runs, as the store knows it: from its first row to what viewers see of it.

use std::sync::Arc;

use super::arena::world_view;
use super::feed::{Feed, Snapshot};
use super::paths::Paths;
use super::state::Condition;
use crate::catalog::Plan;
use crate::clock;
use crate::store::{LogHeader, SessionRow, Store, StoreError};
use crate::wire::{NeuronView, Session, State, TickView, Trial};

/// Letters and digits of identifiers: none that is easily taken for another.
const ALPHABET: &[u8] = b"abcdefghjkmnpqrstuvwxyz23456789";
const ID_LENGTH: usize = 8;
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

/// The row of a session that has just been thought of.
pub(crate) fn new_row(plan: &Plan) -> SessionRow {
    let now = clock::now();
    SessionRow {
        id: new_id(),
        experiment: plan.experiment.clone(),
        seed: plan.seed,
        preset: plan.preset.clone(),
        world: plan.world.name.clone(),
        world_text: plan.world.text.clone(),
        settings: plan.values.clone(),
        trials: plan.trials,
        speed: plan.speed,
        build: crate::build(),
        state: State::Queued,
        reason: None,
        created_at: now.clone(),
        changed_at: now,
        tick: 0,
        trials_done: 0,
    }
}

/// What a session's log begins with.
pub(crate) fn log_header(row: &SessionRow, network_text: Option<String>) -> LogHeader {
    LogHeader {
        experiment: row.experiment.clone(),
        seed: row.seed,
        settings: row.settings.clone(),
        trials: row.trials,
        build: row.build.clone(),
        world_text: row.world_text.clone(),
        network_text,
    }
}

/// An identifier short enough to be read out.
fn new_id() -> String {
    let letters = ALPHABET.len() as u64;
    let mut rest = clock::entropy();
    let mut letter = || {
        let index = usize::try_from(rest % letters).unwrap_or_default();
        rest /= letters;
        char::from(ALPHABET[index])
    };
    (0..ID_LENGTH).map(|_| letter()).collect()
}
