//! A session that nobody runs, as the store knows it: from its first row to what viewers see of it.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::arena::world_view;
use super::drive_run::course;
use super::feed::{Feed, Scene, Snapshot};
use super::machine::Machine;
use super::paths::Paths;
use super::present::{DrivePresent, PathPresent, Present, TablePresent};
use super::state::Condition;
use super::table_view::task_view;
use crate::catalog::{FieldError, Job, PlainPlan};
use crate::clock;
use crate::store::{LogHeader, SessionRow, Store, StoreError};
use crate::wire::{Family, HELLO_CYCLES, NeuronView, Session, State, TickView, Trial};

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
    let rounds = store.rounds(&row.id)?;
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
        family: row.family,
        trials: row.trials_each,
        trials_done: 0,
        rounds: row.rounds,
        rounds_done: 0,
        reached: 0,
        best: None,
        tick: row.tick,
        speed: row.speed,
        build: row.build,
        created_at: row.created_at,
        changed_at: row.changed_at,
    };
    session.count(&rounds);
    Ok(session)
}

/// What viewers see of a stored session.
pub(super) fn feed(store: &Store, job: &Job, session: Session) -> Result<Feed, StoreError> {
    let id = session.id.clone();
    let rounds = store.rounds(&id)?;
    let (scene, present) = match job {
        Job::Path(plan) => {
            let trials = store.trials(&id)?;
            let ticks = last_ticks(store, &session)?;
            let present = PathPresent {
                paths: paths(&trials, &ticks),
                neurons: Arc::new(neurons(store, &id, trials.last())?),
                tick: ticks.into_iter().last().map(Arc::new),
            };
            (Scene::World(Arc::new(world_view(plan))), Present::Path(present))
        }
        Job::Plain(plan) if plan.settings.family() == Family::Drive => {
            let present = drive_present(store, plan, job, &session)?;
            let unfit =
                |error: FieldError| StoreError::Unfit { id: id.clone(), reason: error.to_string() };
            let scene = Scene::Course(Arc::new(course(plan).map_err(unfit)?));
            (scene, Present::Drive(present))
        }
        Job::Plain(plan) => {
            let present = table_present(store, plan, job, &session)?;
            (Scene::Task(Arc::new(task_view(plan))), Present::Table(present))
        }
    };
    let log = store.events(&id, LINES)?;
    Ok(Feed::new(scene, Snapshot { session, present }, rounds, log))
}

/// The last cycles of a session of chapter 2, and how its methods stood at its last checkpoint.
fn drive_present(
    store: &Store,
    plan: &PlainPlan,
    job: &Job,
    session: &Session,
) -> Result<DrivePresent, StoreError> {
    let mut present = DrivePresent::default();
    if session.tick > 0 {
        let first = session.tick.saturating_sub(HELLO_CYCLES as u64 - 1).max(1);
        for cycle in store.cycles(&session.id, first, session.tick)? {
            present.take(cycle);
        }
    }
    let mut present = Present::Drive(present);
    if let Some(stored) = store.checkpoint(&session.id)? {
        match Machine::resume(job, &stored) {
            Ok(machine) => present.count(&machine),
            Err(FieldError { message, .. }) => {
                tracing::warn!("session {} of {}: {message}", session.id, plan.experiment);
            }
        }
    }
    Ok(present.drive().cloned().unwrap_or_default())
}

/// A tabular session as its last checkpoint left it, and its last step.
fn table_present(
    store: &Store,
    plan: &PlainPlan,
    job: &Job,
    session: &Session,
) -> Result<TablePresent, StoreError> {
    let steps = match session.tick {
        0 => Vec::new(),
        last => store.steps(&session.id, last, last)?,
    };
    let machine = match store.checkpoint(&session.id)? {
        Some(stored) => Machine::resume(job, &stored),
        None => Machine::new(job),
    };
    let step = steps.into_iter().next().map(Arc::new);
    let mut present = Present::Table(TablePresent { step, ..TablePresent::default() });
    match machine {
        Ok(mut machine) => {
            present.look(&mut machine);
            present.count(&machine);
        }
        // Its reset says so; what was logged can be seen all the same.
        Err(FieldError { message, .. }) => {
            tracing::warn!("session {} of {}: {message}", session.id, plan.experiment);
        }
    }
    Ok(present.table().cloned().unwrap_or_default())
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
///
/// # Errors
/// When the plan contradicts itself.
pub(crate) fn new_row(job: &Job) -> Result<SessionRow, FieldError> {
    let now = clock::now();
    let row = SessionRow {
        id: new_id(),
        family: Family::Path,
        experiment: String::new(),
        seed: 0,
        preset: String::new(),
        world: String::new(),
        world_text: String::new(),
        settings: BTreeMap::new(),
        trials_each: 0,
        rounds: job.rounds()?,
        speed: job.speed(),
        build: crate::build(),
        state: State::Queued,
        reason: None,
        created_at: now.clone(),
        changed_at: now,
        tick: 0,
        rounds_done: 0,
    };
    Ok(match job {
        Job::Path(plan) => SessionRow {
            experiment: plan.experiment.clone(),
            seed: plan.seed,
            preset: plan.preset.clone(),
            world: plan.world.name.clone(),
            world_text: plan.world.text.clone(),
            settings: plan.values.clone(),
            trials_each: plan.trials,
            ..row
        },
        Job::Plain(plan) => SessionRow {
            family: plan.settings.family(),
            experiment: plan.experiment.clone(),
            seed: plan.seed,
            preset: plan.preset.clone(),
            world: plan.world_name().to_owned(),
            world_text: plan.task.as_ref().map(|task| task.text.clone()).unwrap_or_default(),
            settings: plan.values.clone(),
            trials_each: plan.trials,
            ..row
        },
    })
}

/// What a session's log begins with.
pub(crate) fn log_header(row: &SessionRow, network_text: Option<String>) -> LogHeader {
    LogHeader {
        experiment: row.experiment.clone(),
        family: row.family,
        seed: row.seed,
        settings: row.settings.clone(),
        trials: row.trials_each,
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
