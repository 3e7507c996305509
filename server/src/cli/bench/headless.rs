//! Control steps a second, without and with the log.

use std::sync::Arc;
use std::time::Instant;

use super::{Failure, Line, cpu, room};
use crate::catalog::{Catalog, Job, MINIMUM_COST_PATH, Plan};
use crate::session::{Run, log_header, new_row};
use crate::store::{LogRecord, LogWriter, Store};
use crate::wire::NewSession;

/// Sets of 20 trials in one measurement, seeds 1 to this.
const SETS: u64 = 50;
const RUNS: usize = 7;
/// Trials in a measurement with the log.
const LOGGED_TRIALS: u32 = 500;

/// Headless, nothing recorded: steps, and whole sets.
pub(super) fn run() -> Result<Vec<Line>, Failure> {
    let catalog = Catalog::load(None)?;
    let plans: Vec<_> =
        (1..=SETS).map(|seed| plan(&catalog, seed, 20)).collect::<Result<_, _>>()?;
    let mut next = plans.iter().cycle();
    let mut set = || next.next().map_or(Ok(0), steps_of_a_set);
    let steps = cpu::per_second(&mut set)?;
    let sets = cpu::per_second(|| set().map(|_| 1))?;
    let note = "minimum-cost-path, default preset with full sonar noise, sets of 20 trials with seeds 1 \
                to 50, one thread, CPU time, log off";
    Ok(vec![
        Line::new("run", "headless", "steps/s", steps, note),
        Line::new("run", "set of 20 trials", "ms", sets.iter().map(|n| 1e3 / n).collect(), note),
    ])
}

/// Control steps in the laboratory, and in an office of thousands of short walls.
pub(super) fn office() -> Result<Vec<Line>, Failure> {
    let catalog = Catalog::load(None)?;
    let laboratory = plan(&catalog, 1, 20)?;
    let mut office = laboratory.clone();
    office.world.world = Arc::new(room::office()?);
    let walls = office.world.world.walls().len();
    let measured = [&laboratory, &office].map(|plan| cpu::per_second(|| steps_of_a_set(plan)));
    let [in_laboratory, in_office] = measured;
    let note =
        "whole control steps, default preset, trials from an empty network, seed 1, CPU time";
    let laboratory = Line::new("office", "laboratory", "steps/s", in_laboratory?, note);
    let mut office = Line::new("office", &format!("{walls} walls"), "steps/s", in_office?, note);
    let times = laboratory.value / office.value;
    office.note = format!("{note}; a step costs {times:.2} times that in the laboratory");
    Ok(vec![laboratory, office])
}

/// Every tick into the log, the last byte on the disk.
pub(super) fn run_with_log() -> Result<Vec<Line>, Failure> {
    let catalog = Catalog::load(None)?;
    let folder = Folder::new("bench-run-log")?;
    let store = Store::open(&folder.0)?;
    let measure = |k| logged_steps_a_second(&catalog, &store, k);
    let measured = (0..RUNS as u64).map(measure).collect::<Result<_, Failure>>()?;
    let note = "minimum-cost-path, default preset, 500 trials, every tick with its explanation in the \
                log, from the first step until the log is closed; the log has its own thread";
    Ok(vec![Line::new("run-log", "headless with log", "steps/s", measured, note)])
}

/// A folder for the time of a measurement.
pub(super) struct Folder(pub(super) std::path::PathBuf);

impl Folder {
    pub(super) fn new(name: &str) -> Result<Self, Failure> {
        let path = std::env::temp_dir().join(format!("sonarium-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path)?;
        Ok(Self(path))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // It lies in the system's folder for such things, which is emptied anyway.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn plan(catalog: &Catalog, seed: u64, trials: u32) -> Result<Plan, Failure> {
    Ok(catalog.resolve(&NewSession {
        experiment: MINIMUM_COST_PATH.into(),
        seed: Some(seed),
        settings: Default::default(),
        trials: Some(trials),
        speed: None,
        network: None,
    })?)
}

/// Runs a plan to its end; gives its steps.
fn steps_of_a_set(plan: &Plan) -> Result<u64, Failure> {
    let mut run = Run::new(plan)?;
    let (mut steps, mut trials) = (0, 0);
    while trials < plan.trials {
        steps += 1;
        trials += u32::from(run.step_silently().is_some());
    }
    Ok(steps)
}

#[expect(clippy::cast_precision_loss, reason = "steps are far below 2^53")]
fn logged_steps_a_second(catalog: &Catalog, store: &Store, k: u64) -> Result<f64, Failure> {
    let plan = plan(catalog, k + 1, LOGGED_TRIALS)?;
    let row = new_row(&Job::Path(Box::new(plan.clone())))?;
    store.insert_session(&row)?;
    let mut run = Run::new(&plan)?;
    let start = Instant::now();
    let log = LogWriter::create(store, &row.id, &log_header(&row, None))?;
    let (mut steps, mut trials) = (0_u64, 0);
    while trials < plan.trials {
        let stepped = run.step();
        steps += 1;
        log.write(LogRecord::Tick(Box::new(stepped.tick)))?;
        if let Some(end) = stepped.end {
            trials += 1;
            log.write(LogRecord::TrialEnd(Box::new(end)))?;
            run.checkpoint().map(|checkpoint| log.write(checkpoint)).transpose()?;
        }
    }
    log.finish()?;
    Ok(steps as f64 / start.elapsed().as_secs_f64())
}
