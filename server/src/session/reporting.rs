//! Reports and stills of stored sessions and trials, put together from the log.

use super::arena::{Scenery, planned, world_view};
use super::drive_arena::{drive_arena, run_caption};
use super::drive_run::course;
use super::lab::{Lab, LabError};
use super::paths::Paths;
use super::starts::starts_arena;
use crate::catalog::{FieldError, Job, Plan};
use crate::render::{ArenaView, Quality, RenderError, Renderer};
use crate::report::{DriveReport, Picture, SessionReport, TableReport, TrialReport};
use crate::store::StoreError;
use crate::wire::{
    AlteredStartView, CourseView, DriveOutcome, DriveRunView, DriveScores, Family, PresetInfo,
    Round, ScoresView, Session, Summary, ThemeName, TickView, Trial, TrialEndView, Yardstick,
};
use crate::yardstick;

/// Size of the stills in reports, pixels.
const STILL_PX: (u32, u32) = (960, 640);
/// Lines of the event log in a report.
const LINES: usize = 2000;

/// Why there is no report.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// The session cannot be read.
    #[error(transparent)]
    Lab(#[from] LabError),
    /// A still cannot be drawn.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// There is no such run.
    #[error("run {round} has not ended; {done} have")]
    NoRun {
        /// What was asked for.
        round: u32,
        /// Runs done.
        done: usize,
    },
    /// There is no such trial.
    #[error("trial {trial} has not ended; {done} trials have")]
    NoTrial {
        /// What was asked for.
        trial: u32,
        /// Trials done.
        done: u32,
    },
}

impl From<StoreError> for ReportError {
    fn from(error: StoreError) -> Self {
        Self::Lab(error.into())
    }
}

/// What reports are made from: the laboratory and something to draw with.
#[derive(Clone, Copy)]
pub struct Reporter<'a> {
    /// Where the sessions are.
    pub lab: &'a Lab,
    /// What draws the stills.
    pub renderer: &'a Renderer,
}

impl Reporter<'_> {
    /// Everything the report of a session is made from.
    ///
    /// # Errors
    /// When the session cannot be read, or a still not be drawn.
    pub fn session(&self, id: &str) -> Result<SessionReport, ReportError> {
        let (plan, session) = (self.lab.plan(id)?, self.lab.session(id)?);
        let yardstick = yardstick::compute(&plan);
        let trials = self.lab.store().trials(id)?;
        let trials: Vec<Trial> = trials.into_iter().map(|trial| yardstick.mark(trial)).collect();
        let starts = self.lab.altered_starts(id, None)?;
        Ok(SessionReport {
            title: self.title(&session),
            summary: summary(&trials, &yardstick),
            settings: self.experiment(&session).map(|e| e.settings.clone()).unwrap_or_default(),
            preset: self.preset(&session),
            world: world_view(&plan),
            events: self.lab.store().events(id, LINES)?,
            pictures: self.stills(id, &plan, &trials, &starts, &yardstick)?,
            network: self.lab.store().network(id)?,
            starts: starts.into_iter().map(AlteredStartView::without_paths).collect(),
            build: crate::build(),
            yardstick,
            session,
            trials,
        })
    }

    /// Everything the report of a tabular session is made from; none for a robot's session.
    ///
    /// # Errors
    /// When the session cannot be read.
    pub fn table(&self, id: &str) -> Result<Option<TableReport>, ReportError> {
        let session = self.lab.session(id)?;
        if session.family != Family::Table {
            return Ok(None);
        }
        let feed = self.lab.feed(id)?;
        let rounds = self.lab.store().rounds(id)?.into_iter();
        let episode = |round| match round {
            Round::Episode(episode) => Some(*episode),
            Round::Trial(_) | Round::Run(_) => None,
        };
        let present = feed.snapshot().present.table().cloned().unwrap_or_default();
        Ok(Some(TableReport {
            title: self.title(&session),
            scores: ScoresView::clone(&present.scores),
            episodes: rounds.filter_map(episode).collect(),
            settings: self.experiment(&session).map(|e| e.settings.clone()).unwrap_or_default(),
            preset: self.preset(&session),
            events: self.lab.store().events(id, LINES)?,
            build: crate::build(),
            session,
        }))
    }

    /// Everything the report of a session of chapter 2 is made from; none for another session.
    ///
    /// # Errors
    /// When the session cannot be read.
    pub fn drive(&self, id: &str) -> Result<Option<DriveReport>, ReportError> {
        let session = self.lab.session(id)?;
        if session.family != Family::Drive {
            return Ok(None);
        }
        let feed = self.lab.feed(id)?;
        let present = feed.snapshot().present.drive().cloned().unwrap_or_default();
        let runs = self.runs(id)?;
        Ok(Some(DriveReport {
            title: self.title(&session),
            scores: DriveScores::clone(&present.scores),
            pictures: self.ways(id, &runs)?,
            runs,
            settings: self.experiment(&session).map(|e| e.settings.clone()).unwrap_or_default(),
            preset: self.preset(&session),
            events: self.lab.store().events(id, LINES)?,
            build: crate::build(),
            session,
        }))
    }

    /// The floor of chapter 2 with the way of a run that ended, by the number of its round, or of what
    /// was driven since the last one that did, which is shown if nothing was.
    ///
    /// # Errors
    /// When the session drives no robot, there is no such run, or it cannot be read.
    pub fn run_arena(&self, id: &str, round: Option<u32>) -> Result<ArenaView, ReportError> {
        let course = self.course(id)?;
        let runs = self.runs(id)?;
        if let Some(round) = round {
            let run = runs.iter().find(|run| run.round == round);
            let run = run.ok_or(ReportError::NoRun { round, done: runs.len() })?;
            return self.way(id, &course, run);
        }
        let from = runs.last().map_or(1, |run| run.last_tick + 1);
        let cycles = self.lab.store().cycles(id, from, u64::MAX)?;
        match runs.last() {
            Some(run) if cycles.is_empty() => self.way(id, &course, run),
            _ => {
                let caption = format!("Run under way: {} cycles", cycles.len());
                Ok(drive_arena(&course, &cycles, caption))
            }
        }
    }

    fn way(
        &self,
        id: &str,
        course: &CourseView,
        run: &DriveRunView,
    ) -> Result<ArenaView, ReportError> {
        let cycles = self.lab.store().cycles(id, run.first_tick, run.last_tick)?;
        Ok(drive_arena(course, &cycles, run_caption(run)))
    }

    fn course(&self, id: &str) -> Result<CourseView, ReportError> {
        match self.lab.job(id)? {
            Job::Plain(plan) => Ok(course(&plan).map_err(LabError::Field)?),
            Job::Path(plan) => {
                let message = format!("a session of `{}` has trials, not runs", plan.experiment);
                Err(LabError::Field(FieldError::new("experiment", message)).into())
            }
        }
    }

    fn runs(&self, id: &str) -> Result<Vec<DriveRunView>, ReportError> {
        let run = |round| match round {
            Round::Run(run) => Some(*run),
            Round::Trial(_) | Round::Episode(_) => None,
        };
        Ok(self.lab.store().rounds(id)?.into_iter().filter_map(run).collect())
    }

    /// The ways of the first run by each method, and of the last. An approach has none worth a picture.
    fn ways(&self, id: &str, runs: &[DriveRunView]) -> Result<Vec<Picture>, ReportError> {
        let is_drive = |run: &&DriveRunView| matches!(run.outcome, DriveOutcome::Drive(_));
        let mut shown: Vec<&DriveRunView> = Vec::new();
        for run in runs.iter().filter(is_drive) {
            if !shown.iter().any(|other| other.method == run.method) {
                shown.push(run);
            }
        }
        let last = runs.iter().rfind(is_drive);
        shown.extend(last.filter(|last| !shown.iter().any(|run| run.round == last.round)));
        if shown.is_empty() {
            return Ok(Vec::new());
        }
        let course = self.course(id)?;
        let picture = |run: &DriveRunView| {
            let view = self.way(id, &course, run)?;
            let caption = view.caption.clone();
            Ok(self.still(view, &format!("run-{:03}", run.round), caption)?)
        };
        shown.into_iter().map(picture).collect()
    }

    /// Everything the report of a trial is made from.
    ///
    /// # Errors
    /// When there is no such trial, or it cannot be read or drawn.
    pub fn trial(&self, id: &str, trial: u32) -> Result<TrialReport, ReportError> {
        let (plan, session) = (self.lab.plan(id)?, self.lab.session(id)?);
        let (end, ticks) = self.read(id, trial)?;
        let view = trial_view(&plan, &end, &ticks, &yardstick::compute(&plan));
        let caption = view.caption.clone();
        let picture = self.still(view, &format!("trial-{trial:03}"), caption)?;
        Ok(TrialReport { title: self.title(&session), session, end, ticks, picture: Some(picture) })
    }

    /// The arena with the path of one trial, the neurons after it, and the planned path if it is known by
    /// now.
    ///
    /// # Errors
    /// When there is no such trial, or it cannot be read.
    pub fn trial_arena(&self, id: &str, trial: u32) -> Result<ArenaView, ReportError> {
        let plan = self.lab.plan(id)?;
        let (end, ticks) = self.read(id, trial)?;
        Ok(trial_view(&plan, &end, &ticks, &yardstick::known(&plan)))
    }

    fn read(&self, id: &str, trial: u32) -> Result<(TrialEndView, Vec<TickView>), ReportError> {
        let store = self.lab.store();
        let Some(end) = store.trial_end(id, trial)? else {
            let done = self.lab.session(id)?.trials_done;
            return Err(ReportError::NoTrial { trial, done });
        };
        let ticks = store.ticks(id, end.trial.first_tick, end.trial.last_tick)?;
        Ok((end, ticks))
    }

    /// The first trial, the best, the last, and the ways from altered starts.
    fn stills(
        &self,
        id: &str,
        plan: &Plan,
        trials: &[Trial],
        starts: &[AlteredStartView],
        yardstick: &Yardstick,
    ) -> Result<Vec<Picture>, ReportError> {
        let first = trials.first().map(|trial| ("First", trial.trial));
        let best = summary(trials, &Yardstick::Computing).best_trial.map(|trial| ("Best", trial));
        let last = trials.last().map(|trial| ("Last", trial.trial));
        let mut stills: Vec<Picture> = Vec::new();
        for (word, trial) in [first, best, last].into_iter().flatten() {
            let name = format!("trial-{trial:03}");
            if stills.iter().any(|still| still.name == name) {
                continue;
            }
            let (end, ticks) = self.read(id, trial)?;
            let view = trial_view(plan, &end, &ticks, yardstick);
            let caption = format!("{word} trial. {}", view.caption);
            stills.push(self.still(view, &name, caption)?);
        }
        if !starts.is_empty() {
            let view = starts_arena(&Scenery::new(plan), starts);
            let caption = view.caption.clone();
            stills.push(self.still(view, "altered-starts", caption)?);
        }
        Ok(stills)
    }

    fn still(&self, view: ArenaView, name: &str, caption: String) -> Result<Picture, RenderError> {
        let (width, height) = STILL_PX;
        let alt = format!("Map of the arena with the robot's path. {caption}");
        let quality = Quality::Balanced;
        let png = self.renderer.picture_blocking(view, width, height, ThemeName::Light, quality)?;
        Ok(Picture { name: name.to_owned(), caption, alt, png: png.to_vec() })
    }

    fn experiment(&self, session: &Session) -> Option<&crate::wire::ExperimentInfo> {
        self.lab.catalog().experiment(&session.experiment)
    }

    fn title(&self, session: &Session) -> String {
        self.experiment(session).map_or_else(|| session.experiment.clone(), |e| e.title.clone())
    }

    fn preset(&self, session: &Session) -> PresetInfo {
        let presets = self.experiment(session).map(|experiment| &experiment.presets);
        let preset = presets.and_then(|all| all.iter().find(|p| p.name == session.preset));
        preset.cloned().unwrap_or_else(|| PresetInfo {
            name: session.preset.clone(),
            title: session.preset.clone(),
            summary: String::new(),
            settings: Default::default(),
        })
    }
}

/// Summary over trials.
#[must_use]
pub fn summary(trials: &[Trial], yardstick: &Yardstick) -> Summary {
    let reached = || trials.iter().filter(|trial| trial.reached_goal);
    let better = |a: &&Trial, b: &&Trial| a.total_reinforcement.total_cmp(&b.total_reinforcement);
    // Of equals, the first: it was the record.
    let best = reached().rev().max_by(better);
    let last = trials.last();
    Summary {
        trials: u32::try_from(trials.len()).unwrap_or(u32::MAX),
        reached: u32::try_from(reached().count()).unwrap_or(u32::MAX),
        best_total_reinforcement: best.map(|trial| trial.total_reinforcement),
        best_trial: best.map(|trial| trial.trial),
        last_steps: last.map(|trial| trial.steps),
        last_total_reinforcement: last.map(|trial| trial.total_reinforcement),
        planned_total_reinforcement: yardstick.ready().map(|path| path.total_reinforcement),
        last_regret: last.and_then(|trial| yardstick.regret(trial)),
        last_regret_pct: last.and_then(|trial| yardstick.regret_pct(trial)),
        neurons: last.map_or(0, |trial| trial.neurons),
        collisions: trials.iter().map(|trial| trial.collisions).sum(),
        steps: trials.iter().map(|trial| u64::from(trial.steps)).sum(),
    }
}

fn trial_view(
    plan: &Plan,
    end: &TrialEndView,
    ticks: &[TickView],
    yardstick: &Yardstick,
) -> ArenaView {
    let scenery = Scenery::new(plan);
    let mut paths = Paths::default();
    for tick in ticks {
        paths.follow(tick);
    }
    let Trial { trial, steps, total_reinforcement, reached_goal, .. } = &end.trial;
    let result = if *reached_goal { "reached the goal in" } else { "did not reach the goal in" };
    ArenaView {
        planned_path_m: planned(yardstick),
        path_m: paths.present,
        collisions_m: paths.collisions,
        neurons: scenery.neurons(&end.neurons, None),
        robot: ticks.last().map(|tick| scenery.robot(tick)),
        caption: format!("Trial {trial} {result} {steps} steps, R = {total_reinforcement:.2}"),
        ..scenery.empty()
    }
}
