/** A labyrinth, a maze and what goes on in them, for tests: as the server would send it. */

import type {
  BanditView,
  CompetitorCurve,
  EpisodeView,
  InterventionView,
  LearnerView,
  ScoresView,
  StateView,
  TaskView,
  TransitionView,
  WalkView,
} from '../protocol';

/** First state of each cell of the corridor, west to east (figure 4.5 (a)). */
const CELLS = [0, 4, 12, 8];
const HEADINGS = ['north', 'east', 'south', 'west'];

/** The labyrinth of chapter 4. */
export function sampleLabyrinth(): TaskView {
  const states = Array.from({ length: 16 }, (_, state): StateView => {
    const heading = state % 4;
    const column = CELLS.indexOf(state - heading);
    const name = `#${state} (cell ${column + 1} from the west, facing ${HEADINGS[heading]})`;
    const mark = state === 7 ? 'S' : state === 15 ? 'G' : '';
    return { name, row: 0, column, heading_deg: [90, 0, 270, 180][heading] ?? null, mark };
  });
  return {
    kind: 'labyrinth',
    name: 'labyrinth',
    title: 'Labyrinth of sixteen states',
    states,
    actions: ['left', 'forward', 'right'],
    rows: 1,
    columns: 4,
    transitions: states.flatMap((_, state) => transitionsOf(state)),
    features: [
      { name: 'wall', meaning: 'whether going forward runs into the boundary', terms: ['ahead'] },
      {
        name: 'goal',
        meaning: 'where the goal’s cell lies, seen along the heading',
        terms: ['near', 'far', 'ahead', 'right', 'behind', 'left', 'here'],
      },
    ],
    policies: [],
  };
}

function transitionsOf(state: number): TransitionView[] {
  const heading = state % 4;
  const base = state - heading;
  const way = heading === 1 ? 1 : heading === 3 ? -1 : 0;
  const ahead = CELLS[CELLS.indexOf(base) + way];
  const nexts = [
    base + ((heading + 3) % 4),
    way === 0 || ahead === undefined ? state : ahead + heading,
    base + ((heading + 1) % 4),
  ];
  return nexts.map((next, action) => {
    return { state, action, next, chance: 1, reward: next === 15 ? 1 : 0 };
  });
}

/** A maze drawn in characters, as the files of the server are. */
export function sampleMaze(lines: string[]): TaskView {
  const states = lines.flatMap((line, row) =>
    [...line].flatMap((mark, column): StateView[] =>
      mark === '#'
        ? []
        : [
            {
              name: `row ${row + 1}, column ${column + 1}`,
              row,
              column,
              heading_deg: null,
              mark: mark === '.' ? '' : mark,
            },
          ],
    ),
  );
  const columns = Math.max(...lines.map((line) => line.length));
  return {
    ...sampleLabyrinth(),
    kind: 'maze',
    name: 'maze',
    title: 'A maze',
    states,
    actions: ['north', 'east', 'south', 'west'],
    rows: lines.length,
    columns,
    transitions: [],
  };
}

/** A step from state 4 forward into the boundary, τ = 0.5, with r = 0 and max Q(y,·) = 2. */
export function sampleWalk(changes: Partial<WalkView> = {}): WalkView {
  return {
    tick: 57,
    round: 3,
    episode: 1,
    entrant: 'B11',
    training: false,
    trial: 4,
    step: 2,
    state: 4,
    values: [1, 0.5, 2],
    pulls: [0, 0, 0],
    reflex_pull: 0,
    chances: [0.114, 0.042, 0.844],
    exploration: 0.5,
    action: 1,
    next: 4,
    bumped: true,
    reward: { total: 0, task: 0, subgoal: 0, bump: 0, progress: 0 },
    update: { ahead: 2, discount: 1, rate: 0.9, delta: 1.5, before: 0.5, after: 1.85, planned: 0 },
    trial_end: null,
    ...changes,
  };
}

/** A learner in a task, with all values 0 and nothing excluded. */
export function sampleLearner(task: TaskView, changes: Partial<LearnerView> = {}): LearnerView {
  const rows = (value: number) => task.states.map(() => task.actions.map(() => value));
  return {
    tick: 57,
    episode: 1,
    entrant: 'B11',
    training: false,
    trial: 4,
    state: 4,
    start: 7,
    ends: [15],
    exploration: 0.5,
    step: null,
    values: rows(0),
    beliefs: rows(1),
    weights: rows(1),
    chances: rows(1 / task.actions.length),
    state_values: task.states.map(() => 0),
    editable: true,
    planning: null,
    advice: [],
    ...changes,
  };
}

/** An episode of one competitor, with the actions of each trial. */
export function sampleEpisode(
  round: number,
  trials: number[],
  interventions: InterventionView[] = [],
): EpisodeView {
  const steps = trials.reduce((sum, each) => sum + each, 0);
  return {
    round,
    episode: round,
    entrant: 'B0',
    training: false,
    steps,
    first_tick: 1,
    last_tick: steps,
    outcome: { kind: 'walk', index: steps / trials.length, trials, capped: 0 },
    interventions,
  };
}

/** A curve over trials 1, 2, 3, … */
export function sampleCurve(name: string, n: number, mean: number[]): CompetitorCurve {
  return {
    name,
    n,
    at: mean.map((_, index) => index + 1),
    mean,
    low: n < 2 ? [] : mean.map((value) => value - 1),
    high: n < 2 ? [] : mean.map((value) => value + 1),
  };
}

/** Two competitors after ten episodes. */
export function sampleScores(changes: Partial<ScoresView> = {}): ScoresView {
  const alike = { n: 10, capped: 0, gain: null };
  return {
    episodes_done: 10,
    measure: 'actions a trial',
    over: 'trial',
    scores: [
      {
        ...alike,
        name: 'B0',
        reference: null,
        index: { value: 27, low: 25, high: 29 },
        gain_pct: null,
        last: 5.3,
        search_space: 48,
      },
      {
        ...alike,
        name: 'B10',
        reference: 'B0',
        index: { value: 21.2, low: 20, high: 22.4 },
        gain_pct: 21.5,
        last: 5.2,
        search_space: 38,
      },
    ],
    curves: [sampleCurve('B0', 10, [60, 40, 20]), sampleCurve('B10', 10, [50, 30, 10])],
    ...changes,
  };
}

/** Three levers after four pulls; the third was not tried yet. */
export function sampleBandit(changes: Partial<BanditView> = {}): BanditView {
  return {
    tick: 4,
    episode: 1,
    entrant: 'ucb',
    pull: 4,
    step: {
      tick: 4,
      round: 1,
      episode: 1,
      entrant: 'ucb',
      pull: 4,
      lever: 1,
      scores: [1.1, 1.4, null],
      chances: [0, 1, 0],
      paid: 1,
      mean: 0.6,
      regret: 0.2,
      total_regret: 0.7,
    },
    means: [0.3, 0.6, 0.8],
    estimates: [0.5, 0.5, 0],
    pulls: [2, 2, 0],
    ...changes,
  };
}
