//! A tabular run: learners that compete, strategies at levers, or the plots of figure 3.3.

use serde::{Deserialize, Serialize};
use sonarium_core::experiment::{
    BanditCheckpoint, BanditRun, Contest, ContestCheckpoint, ContestError, EpisodeEnd, HorizonRun,
    Phase,
};
use sonarium_core::labyrinth::LabyrinthError;
use sonarium_core::tabular::WalkError;

use super::table_view as view;
use crate::catalog::{FieldError, PlainPlan, PlainSettings};
use crate::store::{LogRecord, StoredCheckpoint};
use crate::wire::{
    EpisodeView, InterventionView, OutcomeOfEpisode, ScoresView, StepView, TableFile, TableView,
};

/// A tabular experiment under way.
pub struct TableRun {
    machine: Machine,
    rounds: u32,
    round: Round,
}

/// The experiment's machine.
enum Machine {
    Contest(Box<Contest>),
    Bandit(Box<BanditRun>),
    Horizon(Box<HorizonRun>),
}

/// The round under way.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
struct Round {
    /// Number, from 0.
    done: u32,
    first_tick: u64,
    interventions: Vec<InterventionView>,
}

/// What one step gave.
pub struct TableStepped {
    /// The step.
    pub step: StepView,
    /// The episode that ended with it.
    pub end: Option<EpisodeView>,
}

/// What an operator does to a learner.
#[derive(Clone, Debug, PartialEq)]
pub enum Intervention {
    /// Gives advice; an empty text takes it back.
    Advise(String),
    /// Changes one value.
    Edit {
        /// x.
        state: usize,
        /// u.
        action: usize,
        /// Q(x,u).
        value: f64,
    },
    /// Puts a table in the place of the learner's.
    Load(Vec<Vec<f64>>),
    /// Changes the method that drives a robot.
    Method(String),
    /// Lets a sonar fall silent, or answer again.
    Sonar {
        /// Which, from 0.
        sonar: usize,
        /// Silent or not.
        silent: bool,
    },
}

/// A checkpoint as it is stored.
#[derive(Serialize, Deserialize)]
struct Stored {
    round: Round,
    machine: StoredMachine,
}

#[derive(Serialize, Deserialize)]
enum StoredMachine {
    Contest(Box<ContestCheckpoint>),
    Bandit(BanditCheckpoint),
    Horizon(u64),
}

impl TableRun {
    /// A new run.
    ///
    /// # Errors
    /// The setting that contradicts itself or another.
    pub fn new(plan: &PlainPlan) -> Result<Self, FieldError> {
        Self::with(plan, Machine::new(plan)?, Round { first_tick: 1, ..Round::default() })
    }

    /// Goes on from a checkpoint, to the same bits as if it had never stopped.
    ///
    /// # Errors
    /// When the checkpoint is damaged or belongs to another program or setting.
    pub fn resume(plan: &PlainPlan, stored: &StoredCheckpoint) -> Result<Self, FieldError> {
        let refuse =
            |why: String| FieldError::new("checkpoint", format!("{why}; reset the session"));
        let Stored { round, machine } =
            postcard::from_bytes(&stored.bytes).map_err(|error| refuse(error.to_string()))?;
        let machine =
            Machine::resume(plan, machine).map_err(|error| refuse(error.message.clone()))?;
        Self::with(plan, machine, round)
    }

    fn with(plan: &PlainPlan, machine: Machine, round: Round) -> Result<Self, FieldError> {
        let rounds = u64::from(plan.settings.episodes()) * machine.rounds_an_episode();
        let rounds = u32::try_from(rounds).map_err(|_| {
            let message = format!("{rounds} episodes of all competitors are too many");
            FieldError::new("settings.episodes", message)
        })?;
        Ok(Self { machine, rounds, round })
    }

    /// Episodes of one competitor each that the run goes through.
    #[must_use]
    pub fn rounds(&self) -> u32 {
        self.rounds
    }

    /// One step with everything there is to say about it.
    pub fn step(&mut self) -> TableStepped {
        let number = self.round.done + 1;
        let (step, end) = match &mut self.machine {
            Machine::Contest(contest) => {
                let (step, end) = contest.step();
                let (step, end) = (step.clone(), end.cloned());
                let outcome = end.map(|end| walk_outcome(&end));
                (view::walk(&step, contest.entrants(), number), outcome)
            }
            Machine::Bandit(run) => {
                let (step, end) = run.step();
                let (step, end) = (step.clone(), end.cloned());
                let outcome = end.map(|end| OutcomeOfEpisode::Pull {
                    regret: end.regret,
                    paid: end.paid,
                    best_share: end.best_share,
                    course: end.course,
                });
                (view::pull(&step, run.strategies(), number), outcome)
            }
            Machine::Horizon(run) => {
                // The session ends with the last point, so there always is a next.
                let step = view::point(&run.step().expect("a run ends with its last point"));
                let last = run.tick() >= run.points();
                let outcome = last.then(|| OutcomeOfEpisode::Plot { points: view::points(run) });
                (step, outcome)
            }
        };
        let end = outcome_of(&step, end, &mut self.round);
        TableStepped { step, end }
    }

    /// One step, of which only the end of an episode is kept.
    pub fn step_silently(&mut self) -> Option<EpisodeView> {
        match &mut self.machine {
            Machine::Contest(contest) => {
                let (step, end) = contest.step();
                let (tick, outcome) = (step.tick, walk_outcome(end?));
                let at = step.position;
                let head = Head {
                    episode: at.episode,
                    entrant: contest.entrants()[at.entrant].name.clone(),
                    training: at.phase == Phase::Training,
                    tick,
                };
                Some(self.round.end(head, outcome))
            }
            _ => self.step().end,
        }
    }

    /// What to resume from; none within a trial.
    #[must_use]
    pub fn checkpoint(&self) -> Option<LogRecord> {
        let (tick, machine) = match &self.machine {
            Machine::Contest(contest) => {
                (contest.ticks(), StoredMachine::Contest(Box::new(contest.checkpoint()?)))
            }
            Machine::Bandit(run) => {
                let checkpoint = run.checkpoint()?;
                (run.ticks(), StoredMachine::Bandit(checkpoint))
            }
            Machine::Horizon(run) => (run.tick(), StoredMachine::Horizon(run.tick())),
        };
        let stored = Stored { round: self.round.clone(), machine };
        let bytes = postcard::to_stdvec(&stored)
            .expect("a checkpoint is plain data, which postcard always takes");
        Some(LogRecord::Checkpoint { trials_done: self.round.done, tick, bytes })
    }

    /// The tables as they are.
    pub fn table(&mut self, last: Option<&StepView>) -> TableView {
        match &mut self.machine {
            Machine::Contest(contest) => {
                let step = match last {
                    Some(StepView::Walk(step)) => Some(step.clone()),
                    _ => None,
                };
                TableView::Walk(Box::new(view::learner(contest, step)))
            }
            Machine::Bandit(run) => {
                let step = match last {
                    Some(StepView::Pull(step)) => Some(step.clone()),
                    _ => None,
                };
                TableView::Pull(Box::new(view::bandit(run, step)))
            }
            Machine::Horizon(run) => TableView::Plot(view::horizon(run)),
        }
    }

    /// How the competitors stand.
    #[must_use]
    pub fn scores(&self) -> ScoresView {
        match &self.machine {
            Machine::Contest(contest) => view::contest_scores(contest),
            Machine::Bandit(run) => view::bandit_scores(run),
            Machine::Horizon(run) => view::horizon_scores(run),
        }
    }

    /// Does something to the learner whose turn it is. It holds until the end of its episode.
    ///
    /// # Errors
    /// The field that is wrong; nothing is changed then.
    pub fn intervene(&mut self, intervention: &Intervention) -> Result<String, FieldError> {
        let Machine::Contest(contest) = &mut self.machine else {
            let message = "this experiment has no learner with a table to change or to advise";
            return Err(FieldError::new("experiment", message));
        };
        // An episode that has ended learns nothing any more.
        contest.begin();
        let (tick, trial) = (contest.ticks(), contest.walk().trials_done() + 1);
        let walk = contest.walk_mut();
        let done = match intervention {
            Intervention::Advise(text) => walk.advise(text).map_err(WalkError::Advice),
            Intervention::Edit { state, action, value } => walk.edit(*state, *action, *value),
            Intervention::Load(values) => walk.load(values),
            Intervention::Method(_) | Intervention::Sonar { .. } => return Err(no_robot()),
        };
        done.map_err(|error| intervention.refused(&error))?;
        let (kind, text) = intervention.words();
        let entrant = contest.entrants()[contest.position().entrant].name.clone();
        let said = format!("{text} ({entrant}, trial {trial})");
        self.round.interventions.push(InterventionView { tick, trial, kind: kind.into(), text });
        Ok(said)
    }

    /// The values of the learner whose turn it is, as a file.
    ///
    /// # Errors
    /// When there is no learner with a table of its own.
    pub fn table_file(&self, plan: &PlainPlan) -> Result<TableFile, FieldError> {
        let none = || {
            let message = "this learner keeps no single table that could be saved";
            FieldError::new("experiment", message)
        };
        let Machine::Contest(contest) = &self.machine else { return Err(none()) };
        view::table_file(contest, &plan.experiment).ok_or_else(none)
    }
}

impl Machine {
    fn new(plan: &PlainPlan) -> Result<Self, FieldError> {
        let seed = plan.seed;
        Ok(match &plan.settings {
            PlainSettings::Labyrinth(settings) => Self::Contest(Box::new(
                settings.contest(&plan.texts.extras()?, seed).map_err(|e| contest_field(&e))?,
            )),
            PlainSettings::Continual(settings) => {
                Self::Contest(Box::new(settings.contest(seed).map_err(|e| contest_field(&e))?))
            }
            PlainSettings::Gridworld(settings) => {
                let (world, advice) = (view::gridworld(plan)?, &plan.texts.advice);
                let contest = settings.contest(world, advice, seed);
                Self::Contest(Box::new(contest.map_err(|e| contest_field(&e))?))
            }
            PlainSettings::Bandit(settings) => Self::Bandit(Box::new(
                BanditRun::new(settings.clone(), seed, None).map_err(|e| setting_field(&e))?,
            )),
            PlainSettings::Horizon(settings) => {
                Self::Horizon(Box::new(HorizonRun::new(settings.clone(), 0)))
            }
            _ => return Err(FieldError::new("experiment", "must be a tabular one")),
        })
    }

    fn resume(plan: &PlainPlan, stored: StoredMachine) -> Result<Self, FieldError> {
        let seed = plan.seed;
        Ok(match (&plan.settings, stored) {
            (PlainSettings::Labyrinth(settings), StoredMachine::Contest(checkpoint)) => {
                let contest = settings.resume(&plan.texts.extras()?, seed, &checkpoint);
                Self::Contest(Box::new(contest.map_err(|e| contest_field(&e))?))
            }
            (PlainSettings::Continual(settings), StoredMachine::Contest(checkpoint)) => {
                let contest = settings.resume(seed, &checkpoint);
                Self::Contest(Box::new(contest.map_err(|e| contest_field(&e))?))
            }
            (PlainSettings::Gridworld(settings), StoredMachine::Contest(checkpoint)) => {
                let (world, advice) = (view::gridworld(plan)?, &plan.texts.advice);
                let contest = settings.resume(world, advice, seed, &checkpoint);
                Self::Contest(Box::new(contest.map_err(|e| contest_field(&e))?))
            }
            (PlainSettings::Bandit(settings), StoredMachine::Bandit(checkpoint)) => {
                let run = BanditRun::new(settings.clone(), seed, Some(checkpoint));
                Self::Bandit(Box::new(run.map_err(|e| setting_field(&e))?))
            }
            (PlainSettings::Horizon(settings), StoredMachine::Horizon(tick)) => {
                Self::Horizon(Box::new(HorizonRun::new(settings.clone(), tick)))
            }
            _ => return Err(FieldError::new("checkpoint", "it is of another experiment")),
        })
    }

    fn rounds_an_episode(&self) -> u64 {
        match self {
            Self::Contest(contest) => {
                contest.entrants().iter().map(|of| 1 + u64::from(of.training.is_some())).sum()
            }
            Self::Bandit(run) => run.strategies().len() as u64,
            Self::Horizon(_) => 1,
        }
    }
}

/// What of an episode's end does not depend on its outcome.
struct Head {
    episode: u32,
    entrant: String,
    training: bool,
    tick: u64,
}

impl Round {
    fn end(&mut self, head: Head, outcome: OutcomeOfEpisode) -> EpisodeView {
        let Head { episode, entrant, training, tick } = head;
        let ended = std::mem::take(self);
        *self = Self { done: ended.done + 1, first_tick: tick + 1, interventions: Vec::new() };
        EpisodeView {
            round: self.done,
            episode,
            entrant,
            training,
            steps: tick + 1 - ended.first_tick,
            first_tick: ended.first_tick,
            last_tick: tick,
            outcome,
            interventions: ended.interventions,
        }
    }
}

fn outcome_of(
    step: &StepView,
    outcome: Option<OutcomeOfEpisode>,
    round: &mut Round,
) -> Option<EpisodeView> {
    let (episode, entrant, training) = match step {
        StepView::Walk(step) => (step.episode, step.entrant.clone(), step.training),
        StepView::Pull(step) => (step.episode, step.entrant.clone(), false),
        StepView::Point(_) => (1, "figure 3.3".to_owned(), false),
    };
    let head = Head { episode, entrant, training, tick: step.tick() };
    outcome.map(|outcome| round.end(head, outcome))
}

fn walk_outcome(end: &EpisodeEnd) -> OutcomeOfEpisode {
    OutcomeOfEpisode::Walk {
        index: end.index,
        trials: end.episode.steps.clone(),
        capped: end.episode.capped,
    }
}

impl Intervention {
    /// Its kind and its text, as they travel.
    fn words(&self) -> (&'static str, String) {
        match self {
            Self::Advise(text) if text.trim().is_empty() => {
                ("advice", "Took all advice back".into())
            }
            Self::Advise(text) => ("advice", format!("Advised: {}", text.trim())),
            Self::Edit { state, action, value } => {
                ("value", format!("Set Q({state}, {action}) to {value}"))
            }
            Self::Load(_) => ("table", "Loaded a table of values".into()),
            Self::Method(_) | Self::Sonar { .. } => ("robot", String::new()),
        }
    }

    fn refused(&self, error: &WalkError) -> FieldError {
        let field = match self {
            Self::Advise(_) => "text",
            Self::Edit { .. } => "value",
            Self::Load(_) => "values",
            Self::Method(_) | Self::Sonar { .. } => "experiment",
        };
        FieldError::new(field, error.to_string())
    }
}

fn no_robot() -> FieldError {
    FieldError::new("experiment", "a tabular experiment has no robot with sonars")
}

/// The setting at fault, as far as the error tells it.
fn contest_field(error: &ContestError) -> FieldError {
    let field = match error {
        ContestError::Labyrinth(LabyrinthError::State { field, .. }) => {
            return FieldError::new(format!("settings.{field}"), error.to_string());
        }
        ContestError::Labyrinth(LabyrinthError::Same { .. }) => "settings.goal",
        ContestError::Belief { .. } => "settings.belief.matrix",
        ContestError::Walk(WalkError::Advice(_)) => "settings.advice",
        ContestError::Walk(WalkError::Table(_)) => "settings.learner.table",
        ContestError::Walk(WalkError::NoKnowledge { setting, .. }) => {
            return FieldError::new(format!("settings.{setting}"), error.to_string());
        }
        ContestError::Walk(WalkError::NoModules) => "settings.bias.modules",
        ContestError::Walk(WalkError::World(_)) => "settings.learner.discount",
        ContestError::Walk(_) => "settings",
    };
    FieldError::new(field, error.to_string())
}

fn setting_field(error: &sonarium_core::settings::SettingError) -> FieldError {
    FieldError::new(format!("settings.{}", error.key()), error.to_string())
}
