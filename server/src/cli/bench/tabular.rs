//! Learning in tables: Q-learning steps and Dyna's backups, each a CPU second.

use std::hint::black_box;
use std::sync::Arc;

use sonarium_core::rng::{Purpose, stream};
use sonarium_core::tabular::{
    AdvisorRule, Anneal, AnyWorld, Belief, Compact, CompactRule, CompactTable, Exploration,
    Explorer, LearnerKind, LearnerRule, Maze, MazeFile, Shaping, Transport, Units, Walk, WalkSetup,
    World,
};

use super::{Failure, Line, cpu};

const STATES: usize = 16;
const ACTIONS: usize = 3;
/// Learners of an experiment, trials of a learner, and steps at which a trial is broken off.
const LEARNERS: u32 = 100;
const TRIALS: u32 = 10;
const RULE: CompactRule = CompactRule {
    rate: 0.2,
    discount: 0.95,
    temperature: 0.1,
    transport: Transport::Terminal,
    start: 0,
    cap: 100,
};
/// Experiments between two looks at the time.
const BATCH: usize = 8;
/// Experiments whose steps are counted for the note.
const COUNTED: u64 = 50;

/// The workload of the comparison: a maze of 2 x 2 cells with four headings, a wall between the two cells in
/// the west.
pub(super) fn maze() -> Result<Vec<Line>, Failure> {
    let world = two_by_two();
    let mut seeds = COUNTED..;
    let measured = cpu::per_second(|| {
        Ok(seeds.by_ref().take(BATCH).map(|seed| experiment(&world, seed)).sum())
    })?;
    let steps: u64 = (0..COUNTED).map(|seed| experiment(&world, seed)).sum();
    let note = format!(
        "16 states, 3 actions, β 0.2, γ 0.95, softmax τ 0.1, 100 learners of 10 trials of at most 100 steps; \
         f64, ChaCha8 numbers, the same bits as the explained walk; one thread, CPU time; mean steps of \
         {COUNTED} such experiments {}",
        steps / COUNTED
    );
    Ok(vec![Line::new("1-maze", "Q-learning with softmax", "steps/s", measured, &note)])
}

/// The maze: cell 0 is in the south-west, 1 east of it, 2 north of it; entering cell 2 ends a trial.
fn two_by_two() -> Compact<STATES, ACTIONS> {
    let mut world = Compact {
        next: [[0; ACTIONS]; STATES],
        reward: [[-0.01; ACTIONS]; STATES],
        ends: [[false; ACTIONS]; STATES],
    };
    for state in 0..STATES as u8 {
        let (cell, heading) = (state / 4, state % 4);
        let ahead = match (cell, heading) {
            (1, 0) => Some(3),
            (0, 1) => Some(1),
            (2, 1) => Some(3),
            (3, 2) => Some(1),
            (1, 3) => Some(0),
            (3, 3) => Some(2),
            _ => None,
        };
        let at = usize::from(state);
        let goal = ahead == Some(2);
        world.next[at] = [
            4 * ahead.unwrap_or(cell) + heading,
            4 * cell + (heading + 3) % 4,
            4 * cell + (heading + 1) % 4,
        ];
        world.ends[at][0] = goal;
        world.reward[at][0] = match ahead {
            Some(_) if goal => 1.0,
            Some(_) => -0.01,
            None => -0.1,
        };
    }
    world
}

/// Steps of an experiment.
fn experiment(world: &Compact<STATES, ACTIONS>, seed: u64) -> u64 {
    let mut steps = 0;
    for learner in 0..LEARNERS {
        let mut table = CompactTable::new([[0.0; ACTIONS]; STATES], [[1.0; ACTIONS]; STATES]);
        let mut units = Units::new(stream(seed, learner, Purpose::Selection));
        for _ in 0..TRIALS {
            steps += u64::from(table.trial(world, &RULE, &mut units).0);
        }
        black_box(&table);
    }
    steps
}

/// Planning steps of Dyna a real step.
const PLANNING: u32 = 50;
/// Trials of a learner before another begins from nothing.
const DYNA_TRIALS: u32 = 20;

/// Dyna in its own maze, with the walk that explains each step.
pub(super) fn dyna() -> Result<Vec<Line>, Failure> {
    let setup = dyna_setup()?;
    let mut seed = 0;
    let measured = cpu::per_second(|| {
        seed += 1;
        let mut walk = Walk::new(setup.clone(), seed, 0).map_err(failed)?;
        let steps: u64 = (0..DYNA_TRIALS).map(|_| u64::from(walk.trial().steps)).sum();
        Ok(steps * u64::from(1 + PLANNING))
    })?;
    let note = "Algorithm 7 in the maze dyna, 50 planning steps a real step, learned model, ε-greedy 0.1, 20 \
                trials a learner; backups of real and planned steps, everything a step does included; one \
                thread, CPU time";
    Ok(vec![Line::new("dyna", "Dyna, 50 planning steps", "backups/s", measured, note)])
}

fn dyna_setup() -> Result<WalkSetup, Failure> {
    let text = include_str!("../../../../assets/mazes/dyna.toml");
    let file: MazeFile = toml::from_str(text).map_err(failed)?;
    let world = AnyWorld::Maze(Maze::new(&file).map_err(failed)?);
    let rule =
        LearnerRule { kind: LearnerKind::Dyna, planning: PLANNING, ..LearnerRule::default() };
    let anneal = Anneal { first: 0.1, least: 0.1, keep: 1.0 };
    Ok(WalkSetup {
        rule,
        exploration: Exploration { explorer: Explorer::EpsilonGreedy, anneal },
        belief: Belief::none(world.mdp(), 0.0),
        world: Arc::new(world),
        modules: false,
        reflex: None,
        shaping: Shaping::default(),
        advice: String::new(),
        advisor: AdvisorRule::default(),
        cap: 10_000,
    })
}

fn failed(error: impl std::fmt::Display) -> Failure {
    Failure::Failed(error.to_string())
}
