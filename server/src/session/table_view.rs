//! What the core says of tabular experiments, as it travels: indices become names.

use std::sync::Arc;

use sonarium_core::experiment::{
    BanditRun, BanditStep, Contest, ContestStep, Entrant, HorizonRun, HorizonStep, Model, Phase,
    Score,
};
use sonarium_core::settings::{Field, Value};
use sonarium_core::stats::Estimate;
use sonarium_core::tabular::{
    AnyLearner, AnyWorld, Backup, Learner, Mdp, Reward, RuleRecord, Strategy, Trial, Update, World,
};

use crate::catalog::{FieldError, PlainPlan, PlainSettings};
use crate::wire::{
    AdviceView, BackupView, BanditView, CompetitorCurve, CrossingView, FeatureView, HorizonView,
    IntervalView, LearnerView, ModelView, PlanningView, PointView, PolicyView, PullView, QueueView,
    RewardView, ScoreView, ScoresView, StateView, StepView, TableFile, TableTrialView, TaskView,
    TransitionView, UpdateView, WalkView,
};

/// Most states of a queue that travel.
const MOST_QUEUED: usize = 50;

/// An index as it travels; states and actions are far fewer than 2³².
fn number(index: usize) -> u32 {
    u32::try_from(index).unwrap_or(u32::MAX)
}

pub(super) fn walk(step: &ContestStep, entrants: &[Entrant], round: u32) -> StepView {
    let (at, trial, step) = (step.position, &step.trial, (&step.step, step.tick));
    let (walk, tick) = step;
    StepView::Walk(Box::new(WalkView {
        tick,
        round,
        episode: at.episode,
        entrant: entrants[at.entrant].name.clone(),
        training: at.phase == Phase::Training,
        trial: walk.trial,
        step: walk.step,
        state: number(walk.state),
        values: walk.values.clone(),
        pulls: walk.pulls.clone(),
        reflex_pull: walk.reflex_pull,
        chances: walk.chances.clone(),
        exploration: walk.exploration,
        action: number(walk.action),
        next: number(walk.next),
        bumped: walk.bumped,
        reward: reward(&walk.reward),
        update: update(&walk.update),
        trial_end: trial.as_ref().map(table_trial),
    }))
}

fn reward(reward: &Reward) -> RewardView {
    RewardView {
        total: reward.total(),
        task: reward.task,
        subgoal: reward.subgoal,
        bump: reward.bump,
        progress: reward.progress,
    }
}

fn update(update: &Update) -> UpdateView {
    UpdateView {
        ahead: update.ahead,
        discount: update.discount,
        rate: update.rate,
        delta: update.delta,
        before: update.before,
        after: update.after,
        planned: update.planned,
    }
}

fn table_trial(trial: &Trial) -> TableTrialView {
    TableTrialView {
        steps: trial.steps,
        reached_end: trial.reached_end,
        total_reward: trial.total_reward,
        bumps: trial.bumps,
    }
}

pub(super) fn pull(step: &BanditStep, strategies: &[Strategy], round: u32) -> StepView {
    StepView::Pull(Box::new(PullView {
        tick: step.tick,
        round,
        episode: step.episode,
        entrant: strategy_name(strategies[step.strategy]),
        pull: step.pull,
        lever: number(step.decision.arm),
        scores: step.decision.scores.iter().map(|score| score.filter(|s| s.is_finite())).collect(),
        chances: step.decision.chances.clone(),
        paid: step.paid,
        mean: step.mean,
        regret: step.regret,
        total_regret: step.total_regret,
    }))
}

/// The strategy's name as its setting has it.
fn strategy_name(strategy: Strategy) -> String {
    match strategy.to_value() {
        Value::Choice(name) => name,
        other => other.to_string(),
    }
}

pub(super) fn point(step: &HorizonStep) -> StepView {
    StepView::Point(point_view(step))
}

fn point_view(step: &HorizonStep) -> PointView {
    PointView {
        tick: step.tick,
        round: 1,
        model: match step.model {
            Model::FiniteHorizon => "finite-horizon",
            Model::Discounted => "discounted",
            Model::Average => "average",
        }
        .into(),
        parameter: step.parameter,
        values: step.values.clone(),
        best: number(step.best),
        crossing: step.crossing.map(|crossing| CrossingView {
            at: crossing.at,
            from: number(crossing.from),
            to: number(crossing.to),
        }),
    }
}

pub(super) fn points(run: &HorizonRun) -> Vec<PointView> {
    run.so_far().iter().map(point_view).collect()
}

pub(super) fn horizon(run: &HorizonRun) -> HorizonView {
    HorizonView { tick: run.tick(), of: run.points(), points: points(run) }
}

/// The policies, without a score: each is the best somewhere.
pub(super) fn horizon_scores(run: &HorizonRun) -> ScoresView {
    ScoresView {
        episodes_done: u32::from(run.tick() >= run.points()),
        measure: "J".into(),
        over: "horizon".into(),
        scores: Vec::new(),
        curves: Vec::new(),
    }
}

pub(super) fn learner(contest: &mut Contest, step: Option<Box<WalkView>>) -> LearnerView {
    let states = contest.walk().world().mdp().states();
    let chances = (0..states).map(|state| contest.walk_mut().chances(state)).collect();
    let (at, walk) = (contest.position(), contest.walk());
    let (setup, agent, mdp) = (walk.setup(), walk.learner(), walk.world().mdp());
    LearnerView {
        tick: contest.ticks(),
        episode: at.episode,
        entrant: contest.entrants()[at.entrant].name.clone(),
        training: at.phase == Phase::Training,
        trial: (walk.trials_done() + 1).min(contest.trials()),
        state: number(walk.state()),
        start: number(walk.world().start()),
        ends: (0..states).filter(|state| mdp.is_absorbing(*state)).map(number).collect(),
        exploration: walk.exploration(),
        step,
        values: (0..states).map(|state| agent.preferences(state).to_vec()).collect(),
        beliefs: setup.belief.initial.clone(),
        weights: setup.belief.weights.clone(),
        chances,
        state_values: (0..states).map(|state| agent.value(state)).collect(),
        editable: agent.table().is_some(),
        planning: planning(agent),
        advice: advice(contest),
    }
}

fn planning(learner: &AnyLearner) -> Option<PlanningView> {
    let known = learner.model()?;
    let model = known.tried().iter().flat_map(|&(state, action)| {
        let count: u32 = known.seen(state, action).iter().map(|seen| seen.count).sum();
        known.seen(state, action).iter().map(move |seen| ModelView {
            state: number(state),
            action: number(action),
            ahead: seen.ahead.map(number),
            chance: f64::from(seen.count) / f64::from(count.max(1)),
            reward: seen.reward,
        })
    });
    let backup = |backup: &Backup| BackupView {
        state: number(backup.state),
        action: number(backup.action),
        before: backup.before,
        after: backup.after,
    };
    let queue = learner.queue().into_iter().take(MOST_QUEUED);
    Some(PlanningView {
        known: number(known.tried().len()),
        model: model.collect(),
        backups: learner.planned().iter().map(backup).collect(),
        queue: queue
            .map(|(state, priority)| QueueView { state: number(state), priority })
            .collect(),
    })
}

fn advice(contest: &Contest) -> Vec<AdviceView> {
    let walk = contest.walk();
    let Some(advisor) = walk.advisor() else { return Vec::new() };
    let first_weight = walk.setup().advisor.strength;
    let view = |(rule, degree): (&RuleRecord, f64)| AdviceView {
        text: rule.text.clone(),
        weight: rule.weight,
        first_weight,
        degree,
        followed: rule.followed,
        ignored: rule.ignored,
        steps_followed: rule.steps_followed,
        steps_ignored: rule.steps_ignored,
        given: rule.given,
        discarded: rule.discarded,
    };
    advisor.memory().rules.iter().zip(advisor.degrees(walk.state())).map(view).collect()
}

pub(super) fn bandit(run: &BanditRun, step: Option<Box<PullView>>) -> BanditView {
    let levers = run.levers();
    let (strategy, episode) = levers.as_ref().map_or((0, 1), |of| (of.strategy, of.episode));
    let (means, known) = levers.map(|of| (of.means, of.estimates)).unzip();
    let pulls = known.as_ref().map(|known| known.pulls().to_vec()).unwrap_or_default();
    BanditView {
        tick: run.ticks(),
        episode,
        entrant: strategy_name(run.strategies()[strategy]),
        pull: pulls.iter().sum(),
        step,
        means: means.unwrap_or_default(),
        estimates: known.map(|known| known.means().to_vec()).unwrap_or_default(),
        pulls,
    }
}

fn interval(estimate: &Estimate) -> IntervalView {
    IntervalView { value: estimate.value, low: estimate.low, high: estimate.high }
}

pub(super) fn contest_scores(contest: &Contest) -> ScoresView {
    let numbered = || contest.scores().into_iter().enumerate();
    ScoresView {
        episodes_done: contest.episodes_done(),
        measure: "actions a trial".into(),
        over: "trial".into(),
        scores: numbered().map(|(which, score)| score_view(contest, which, &score)).collect(),
        curves: numbered().map(|(which, score)| contest_curve(contest, which, &score)).collect(),
    }
}

fn score_view(contest: &Contest, which: usize, score: &Score) -> ScoreView {
    ScoreView {
        name: score.name.clone(),
        reference: score.reference.clone(),
        n: number(contest.episodes(which).len()),
        index: score.index.as_ref().map(interval),
        gain_pct: score.gain,
        gain: score.spread.as_ref().map(|gain| interval(&gain.mean)),
        last: score.last,
        capped: score.capped,
        search_space: Some(number(score.search_space)),
    }
}

fn contest_curve(contest: &Contest, which: usize, score: &Score) -> CompetitorCurve {
    let samples: Vec<Vec<f64>> = contest
        .episodes(which)
        .iter()
        .map(|episode| episode.steps.iter().map(|steps| f64::from(*steps)).collect())
        .collect();
    let points = samples.first().map_or(0, Vec::len);
    curve(&score.name, (1..=points).map(|trial| f64::from(number(trial))).collect(), &samples)
}

/// A curve over samples of equal length; with its band from two samples on.
fn curve(name: &str, at: Vec<f64>, samples: &[Vec<f64>]) -> CompetitorCurve {
    let mut curve = CompetitorCurve {
        name: name.to_owned(),
        n: number(samples.len()),
        at,
        mean: Vec::new(),
        low: Vec::new(),
        high: Vec::new(),
    };
    for point in 0..samples.first().map_or(0, Vec::len) {
        let values: Vec<f64> = samples.iter().map(|sample| sample[point]).collect();
        if let Some(Estimate { value, low, high, .. }) = Estimate::mean(&values) {
            curve.mean.push(value);
            curve.low.push(low);
            curve.high.push(high);
        } else {
            curve.mean.push(values[0]);
        }
    }
    curve
}

pub(super) fn bandit_scores(run: &BanditRun) -> ScoresView {
    let at: Vec<f64> = run.course_pulls().into_iter().map(f64::from).collect();
    let of = |which: usize| run.episodes().iter().filter(move |episode| episode.strategy == which);
    let score = |(which, score): (usize, sonarium_core::experiment::BanditScore)| ScoreView {
        name: strategy_name(score.strategy),
        reference: None,
        n: number(of(which).count()),
        index: score.regret.as_ref().map(interval),
        gain_pct: None,
        gain: None,
        last: score.best_share.map(|share| 100.0 * share.value),
        capped: 0,
        search_space: None,
    };
    let course = |(which, strategy): (usize, &Strategy)| {
        let samples: Vec<Vec<f64>> = of(which).map(|episode| episode.course.clone()).collect();
        curve(&strategy_name(*strategy), at.clone(), &samples)
    };
    ScoresView {
        episodes_done: run.episodes_done(),
        measure: "regret".into(),
        over: "pull".into(),
        scores: run.scores().into_iter().enumerate().map(score).collect(),
        curves: run.strategies().iter().enumerate().map(course).collect(),
    }
}

pub(super) fn table_file(contest: &Contest, experiment: &str) -> Option<TableFile> {
    let walk = contest.walk();
    let world = walk.world();
    Some(TableFile {
        experiment: experiment.to_owned(),
        entrant: contest.entrants()[contest.position().entrant].name.clone(),
        tick: contest.ticks(),
        states: (0..world.mdp().states()).map(|state| world.state_name(state)).collect(),
        actions: world.action_names().to_vec(),
        values: walk.learner().table()?.rows(),
    })
}

/// The world of `gridworld`.
pub(super) fn gridworld(plan: &PlainPlan) -> Result<&Arc<AnyWorld>, FieldError> {
    let missing = || FieldError::new("settings.world", "must name a maze or a process");
    plan.task.as_ref().map(|task| &task.world).ok_or_else(missing)
}

/// The world of a plan, for drawing.
#[must_use]
pub fn task_view(plan: &PlainPlan) -> TaskView {
    let (name, title) = match &plan.task {
        Some(task) => (task.name.clone(), task.title.clone()),
        None => (plan.experiment.clone(), plan.title.clone()),
    };
    let empty = TaskView {
        kind: String::new(),
        name,
        title,
        states: Vec::new(),
        actions: Vec::new(),
        rows: 0,
        columns: 0,
        transitions: Vec::new(),
        features: Vec::new(),
        policies: Vec::new(),
    };
    match &plan.settings {
        PlainSettings::Labyrinth(settings) => labyrinth_task(settings.labyrinth().ok(), empty),
        PlainSettings::Continual(settings) => labyrinth_task(settings.labyrinth().ok(), empty),
        PlainSettings::Gridworld(_) => match plan.task.as_ref().map(|task| task.world.as_ref()) {
            Some(AnyWorld::Maze(maze)) => maze_task(maze, empty),
            Some(world) => TaskView { kind: "process".into(), ..world_task(world, empty) },
            None => empty,
        },
        PlainSettings::Bandit(settings) => TaskView {
            kind: "levers".into(),
            actions: (1..=settings.arms).map(|lever| format!("lever {lever}")).collect(),
            ..empty
        },
        PlainSettings::Horizon(settings) => horizon_task(settings, empty),
        _ => empty,
    }
}

fn horizon_task(
    settings: &sonarium_core::experiment::HorizonSettings,
    empty: TaskView,
) -> TaskView {
    let run = HorizonRun::new(settings.clone(), 0);
    let policy = |chain: &sonarium_core::tabular::Chain| PolicyView {
        name: chain.name.clone(),
        lead: chain.lead.clone(),
        then: chain.then,
    };
    let policies: Vec<PolicyView> = run.chains().iter().map(policy).collect();
    TaskView {
        kind: "policies".into(),
        actions: policies.iter().map(|policy| policy.name.clone()).collect(),
        policies,
        ..empty
    }
}

fn labyrinth_task(
    labyrinth: Option<sonarium_core::labyrinth::Labyrinth>,
    empty: TaskView,
) -> TaskView {
    let Some(labyrinth) = labyrinth else { return empty };
    let mut task = world_task(&labyrinth, empty);
    for (index, state) in task.states.iter_mut().enumerate() {
        let (cell, heading_deg) = sonarium_core::labyrinth::place(index);
        state.row = Some(0);
        state.column = Some(number(cell));
        state.heading_deg = Some(heading_deg);
    }
    TaskView { kind: "labyrinth".into(), rows: 1, columns: 4, ..task }
}

fn maze_task(maze: &sonarium_core::tabular::Maze, empty: TaskView) -> TaskView {
    let mut task = world_task(maze, empty);
    for (state, cell) in task.states.iter_mut().zip(maze.cells()) {
        state.row = Some(number(cell.row));
        state.column = Some(number(cell.column));
        state.mark = cell.mark.to_string();
    }
    let (rows, columns) = maze.size();
    TaskView { kind: "maze".into(), rows: number(rows), columns: number(columns), ..task }
}

fn world_task(world: &impl World, empty: TaskView) -> TaskView {
    let mdp = world.mdp();
    let state = |state: usize| StateView {
        name: world.state_name(state),
        row: None,
        column: None,
        heading_deg: None,
        mark: String::new(),
    };
    let feature = |feature: &sonarium_core::tabular::Feature| FeatureView {
        name: feature.name.clone(),
        meaning: feature.meaning.clone(),
        terms: feature.terms.iter().map(|degrees| degrees.term.clone()).collect(),
    };
    TaskView {
        states: (0..mdp.states()).map(state).collect(),
        actions: world.action_names().to_vec(),
        transitions: transitions(mdp),
        features: world.knowledge().features.iter().map(feature).collect(),
        ..empty
    }
}

fn transitions(mdp: &Mdp) -> Vec<TransitionView> {
    let mut transitions = Vec::new();
    for state in 0..mdp.states() {
        for action in mdp.possible(state) {
            transitions.extend(mdp.outcomes(state, action).iter().map(|outcome| TransitionView {
                state: number(state),
                action: number(action),
                next: number(outcome.next),
                chance: outcome.chance,
                reward: outcome.reward,
            }));
        }
    }
    transitions
}
