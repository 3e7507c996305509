//! A run of chapter 2: a robot driven by rules, or gliding towards a wall.

use std::sync::Arc;

use serde::{Deserialize, Serialize};
use sonarium_core::experiment::{
    ApproachRun, NavigationCheckpoint, NavigationError, NavigationRun,
};
use sonarium_core::perception::Method;
use sonarium_core::settings::{Field, Value};

use super::drive_view as view;
use super::table_run::Intervention;
use crate::catalog::{Equipment, FieldError, PlainPlan, PlainSettings};
use crate::store::{LogRecord, StoredCheckpoint};
use crate::wire::{
    CourseView, CycleView, DriveOutcome, DriveRunView, DriveScores, InterventionView,
};

/// An experiment of chapter 2 under way.
pub struct DriveRun {
    machines: Vec<Machine>,
    /// Rounds that it goes through.
    rounds: u32,
    /// Names of the methods, in the order of the depths.
    state: State,
    /// Runs that ended, for the summary.
    done: Vec<DriveRunView>,
}

/// The core's machine, and the method that drives it.
struct Machine {
    driver: Method,
    core: Core,
}

enum Core {
    Approach(Box<ApproachRun>),
    Drive(Box<NavigationRun>),
}

/// What must be kept besides the machines.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
struct State {
    /// Rounds done.
    rounds: u32,
    /// Cycles done, by all machines.
    ticks: u64,
    /// First tick of the round under way.
    first_tick: u64,
    interventions: Vec<InterventionView>,
    /// Sonars that an operator has silenced; they stay so until they are let answer.
    silent: Vec<u32>,
}

#[derive(Serialize, Deserialize)]
struct Stored {
    state: State,
    machines: Vec<NavigationCheckpoint>,
    /// Rows of the runs that ended, as JSON: they hold tagged choices, which postcard cannot read back.
    done: String,
}

/// What one cycle gave.
pub struct DriveStepped {
    /// The cycle.
    pub cycle: CycleView,
    /// The run that ended with it.
    pub end: Option<DriveRunView>,
}

impl DriveRun {
    /// A new run.
    ///
    /// # Errors
    /// The setting that contradicts itself or another.
    pub fn new(plan: &PlainPlan) -> Result<Self, FieldError> {
        let machines = machines(plan)?;
        let rounds = u64::from(plan.trials) * machines.len() as u64;
        let rounds = u32::try_from(rounds)
            .map_err(|_| FieldError::new("trials", format!("{rounds} runs are too many")))?;
        let state = State { first_tick: 1, ..State::default() };
        Ok(Self { machines, rounds, state, done: Vec::new() })
    }

    /// Goes on from a checkpoint, to the same bits as if it had never stopped.
    ///
    /// # Errors
    /// When the checkpoint is damaged or belongs to another program or setting.
    pub fn resume(plan: &PlainPlan, stored: &StoredCheckpoint) -> Result<Self, FieldError> {
        let refuse =
            |why: String| FieldError::new("checkpoint", format!("{why}; reset the session"));
        let Stored { state, machines, done } =
            postcard::from_bytes(&stored.bytes).map_err(|error| refuse(error.to_string()))?;
        let new = Self::new(plan)?;
        if machines.len() != new.machines.len() {
            return Err(refuse("it is of another experiment".into()));
        }
        let resumed = new.machines.into_iter().zip(&machines);
        let machines = resumed.map(|(machine, checkpoint)| machine.resumed(checkpoint));
        let machines = machines.collect::<Result<_, _>>().map_err(|e| refuse(e.to_string()))?;
        let done = serde_json::from_str(&done).map_err(|error| refuse(error.to_string()))?;
        Ok(Self { machines, state, done, ..new })
    }

    /// Runs of one method each that it goes through.
    #[must_use]
    pub fn rounds(&self) -> u32 {
        self.rounds
    }

    /// One cycle with everything there is to say about it.
    pub fn step(&mut self) -> DriveStepped {
        let (turn, round) = (self.turn(), self.state.rounds + 1);
        self.state.ticks += 1;
        let tick = self.state.ticks;
        let (cycle, end) = match &mut self.machines[turn].core {
            Core::Approach(run) => {
                let (cycle, end) = run.step();
                (view::cycle(cycle, tick, round, None), end.map(view::approach))
            }
            Core::Drive(run) => {
                let (cycle, end) = run.step();
                let (cycle, end) = (cycle.clone(), end.cloned());
                let cycle = view::cycle(&cycle, tick, round, Some(run.rules()));
                (cycle, end.as_ref().map(view::drive))
            }
        };
        let end = end.map(|outcome| self.end(&cycle, outcome));
        DriveStepped { cycle, end }
    }

    /// One cycle, of which only the end of a run is kept.
    pub fn step_silently(&mut self) -> Option<DriveRunView> {
        let turn = self.turn();
        self.state.ticks += 1;
        let (run, cycle, method, outcome) = match &mut self.machines[turn].core {
            Core::Approach(run) => {
                let (cycle, end) = run.step();
                (cycle.run, cycle.cycle, cycle.method, view::approach(end?))
            }
            Core::Drive(run) => {
                let (cycle, end) = run.step();
                (cycle.run, cycle.cycle, cycle.method, view::drive(end?))
            }
        };
        Some(self.close(run, cycle, view::name(method), outcome))
    }

    fn turn(&self) -> usize {
        self.state.rounds as usize % self.machines.len()
    }

    fn end(&mut self, last: &CycleView, outcome: DriveOutcome) -> DriveRunView {
        self.close(last.run, last.cycle, last.method.clone(), outcome)
    }

    fn close(
        &mut self,
        run: u32,
        cycles: u32,
        method: String,
        outcome: DriveOutcome,
    ) -> DriveRunView {
        let turn = self.turn();
        let ended = std::mem::take(&mut self.state);
        let State { rounds, ticks, first_tick, interventions, silent } = ended;
        self.state = State {
            rounds: rounds + 1,
            ticks,
            first_tick: ticks + 1,
            interventions: silent.iter().map(|sonar| still_silent(*sonar, ticks)).collect(),
            silent,
        };
        // The next run of this machine is driven as the settings say, whatever an operator chose.
        self.machines[turn].drive_by_settings();
        let row = DriveRunView {
            round: rounds + 1,
            run,
            method,
            cycles,
            first_tick,
            last_tick: ticks,
            outcome,
            interventions,
        };
        self.done.push(row.clone());
        row
    }

    /// What to resume from; none within a run.
    #[must_use]
    pub fn checkpoint(&self) -> Option<LogRecord> {
        let machines = self.machines.iter().map(|machine| match &machine.core {
            Core::Approach(run) => run.checkpoint(),
            Core::Drive(run) => run.checkpoint(),
        });
        let done = serde_json::to_string(&self.done).expect("rows have text keys");
        let stored =
            Stored { state: self.state.clone(), machines: machines.collect::<Option<_>>()?, done };
        let bytes = postcard::to_stdvec(&stored)
            .expect("a checkpoint is plain data, which postcard always takes");
        let State { rounds, ticks, .. } = self.state;
        Some(LogRecord::Checkpoint { trials_done: rounds, tick: ticks, bytes })
    }

    /// How the methods stand, over the runs that no operator changed.
    #[must_use]
    pub fn scores(&self) -> DriveScores {
        let (ends, doors) = match self.machines.first().map(|machine| &machine.core) {
            Some(Core::Drive(run)) => (run.finish_m().is_some(), !run.doors().is_empty()),
            _ => (false, false),
        };
        view::scores(&self.done, ends, doors)
    }

    /// Does something to the robot under way.
    ///
    /// # Errors
    /// The field that is wrong; nothing is changed then.
    pub fn intervene(&mut self, intervention: &Intervention) -> Result<String, FieldError> {
        let (kind, text) = match intervention {
            Intervention::Method(name) => {
                let method = Method::from_value(&Value::Choice(name.clone())).ok_or_else(|| {
                    let known: Vec<String> = Method::ALL.map(view::name).to_vec();
                    let message = format!("must be one of {}, not {name}", known.join(", "));
                    FieldError::new("method", message)
                })?;
                let turn = self.turn();
                self.machines[turn].set_method(method);
                ("method", format!("Driven by {name} until the run ends"))
            }
            Intervention::Sonar { sonar, silent } => {
                let sonars = self.machines[0].sonars();
                if *sonar >= sonars {
                    let message = format!("must be from 0 to {}, not {sonar}", sonars - 1);
                    return Err(FieldError::new("sonar", message));
                }
                self.machines.iter_mut().for_each(|machine| machine.silence(*sonar, *silent));
                let number = u32::try_from(*sonar).unwrap_or(u32::MAX);
                self.state.silent.retain(|other| *other != number);
                if *silent {
                    self.state.silent.push(number);
                }
                let what = if *silent { "fell silent" } else { "answers again" };
                ("sonar", format!("Sonar {sonar} {what}"))
            }
            _ => {
                let message = "a robot driven by rules has no table to change or to advise";
                return Err(FieldError::new("experiment", message));
            }
        };
        let State { ticks, first_tick, .. } = self.state;
        let trial = u32::try_from(ticks + 1 - first_tick.min(ticks + 1)).unwrap_or(u32::MAX);
        self.state.interventions.push(InterventionView {
            tick: ticks,
            trial,
            kind: kind.into(),
            text: text.clone(),
        });
        Ok(text)
    }
}

/// What is said of a run that begins with a silent sonar.
fn still_silent(sonar: u32, tick: u64) -> InterventionView {
    let text = format!("Sonar {sonar} was silent from the start");
    InterventionView { tick, trial: 1, kind: "sonar".into(), text }
}

impl Machine {
    fn resumed(self, checkpoint: &NavigationCheckpoint) -> Result<Self, NavigationError> {
        let core = match self.core {
            Core::Approach(run) => Core::Approach(Box::new(run.resumed(checkpoint)?)),
            Core::Drive(run) => Core::Drive(Box::new(run.resumed(checkpoint)?)),
        };
        Ok(Self { core, ..self })
    }

    fn drive_by_settings(&mut self) {
        self.set_method(self.driver);
    }

    fn set_method(&mut self, method: Method) {
        match &mut self.core {
            Core::Approach(run) => run.set_method(method),
            Core::Drive(run) => run.set_method(method),
        }
    }

    fn silence(&mut self, sonar: usize, silent: bool) {
        match &mut self.core {
            Core::Approach(run) => run.silence(sonar, silent),
            Core::Drive(run) => run.silence(sonar, silent),
        }
    }

    fn sonars(&self) -> usize {
        let hashing = match &self.core {
            Core::Approach(run) => run.hashing(),
            Core::Drive(run) => run.hashing(),
        };
        hashing.regions().iter().flatten().max().map_or(0, |last| last + 1)
    }
}

/// Methods of Experiments I and II.
const COMPARED: [Method; 2] = [Method::Minimum, Method::MedianKalman];

fn machines(plan: &PlainPlan) -> Result<Vec<Machine>, FieldError> {
    let Equipment { robot, rules } = equipment(plan)?;
    let rules = plan.texts.rules()?.map_or_else(|| rules.clone(), Arc::new);
    let (rules, seed) = (|| rules.clone(), plan.seed);
    let regions = plan.texts.regions(robot.sonars().len())?;
    let people = plan.texts.people()?;
    let drivers = |compare: bool, method: Method| {
        if compare { COMPARED.to_vec() } else { vec![method] }
    };
    let drive = |driver: Method, run: Result<NavigationRun, NavigationError>| {
        let run = run.and_then(|run| match &regions {
            Some(regions) => run.hashed_into(regions.clone()),
            None => Ok(run),
        });
        let run = run.and_then(|run| match &people {
            Some(people) => run.peopled_by(people.clone()),
            None => Ok(run),
        });
        let run = run.map_err(|error| field(&error))?;
        Ok(Machine { driver, core: Core::Drive(Box::new(run)) })
    };
    match &plan.settings {
        PlainSettings::WallApproach(settings) => {
            let run = ApproachRun::new(robot, settings, seed).map_err(|error| field(&error))?;
            let run = match &regions {
                Some(regions) => run.hashed_into(regions.clone()),
                None => run,
            };
            Ok(vec![Machine { driver: settings.method, core: Core::Approach(Box::new(run)) }])
        }
        PlainSettings::BlockWorld(settings) => drivers(settings.compare, settings.method)
            .into_iter()
            .map(|method| {
                let settings =
                    sonarium_core::experiment::BlockWorldSettings { method, ..settings.clone() };
                drive(method, NavigationRun::block_world(robot, rules(), &settings, seed))
            })
            .collect(),
        PlainSettings::Corridor(settings) => drivers(settings.compare, settings.method)
            .into_iter()
            .map(|method| {
                let settings =
                    sonarium_core::experiment::CorridorSettings { method, ..settings.clone() };
                drive(method, NavigationRun::corridor(robot, rules(), &settings, seed))
            })
            .collect(),
        _ => Err(FieldError::new("experiment", "must be one of chapter 2")),
    }
}

fn equipment(plan: &PlainPlan) -> Result<&Equipment, FieldError> {
    let missing = || FieldError::new("experiment", "has no robot to drive");
    plan.equipment.as_ref().ok_or_else(missing)
}

fn field(error: &NavigationError) -> FieldError {
    FieldError::new(format!("settings.{}", error.field()), error.to_string())
}

/// Where the robot of a plan drives.
///
/// # Errors
/// The setting that contradicts itself or another.
pub fn course(plan: &PlainPlan) -> Result<CourseView, FieldError> {
    let machines = machines(plan)?;
    let equipment = equipment(plan)?;
    let drivers = machines.iter().map(|machine| view::name(machine.driver)).collect();
    let course = match machines.first().map(|machine| &machine.core) {
        Some(Core::Approach(run)) => {
            view::course(view::Stage::of_approach(run, &equipment.robot), &equipment.robot)
        }
        Some(Core::Drive(run)) => view::course(view::Stage::of_drive(run), &equipment.robot),
        None => return Err(FieldError::new("experiment", "has nothing to drive")),
    };
    Ok(CourseView { kind: plan.experiment.clone(), title: plan.title.clone(), drivers, ..course })
}
