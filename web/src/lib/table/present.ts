/** The present of a tabular session: its newest step, and where the agent is. */

import type { LearnerView, PullView, StepView, TableView, WalkView } from '../protocol';

/** A learner's tables, if that is what is at work. */
export function learnerOf(table: TableView | null): LearnerView | null {
  return table?.kind === 'walk' ? table : null;
}

/** The newest step of a learner: steps come more often than tables, which carry one too. */
export function walkOf(step: StepView | null, table: TableView | null): WalkView | null {
  const carried = learnerOf(table)?.step ?? null;
  return newest(step?.kind === 'walk' ? step : null, carried, table);
}

/** The newest pull of a strategy. */
export function pullOf(step: StepView | null, table: TableView | null): PullView | null {
  const carried = table?.kind === 'pull' ? table.step : null;
  return newest(step?.kind === 'pull' ? step : null, carried, table);
}

/** A step told before the tables is of the past: also of an episode before theirs. */
function newest<T extends { tick: number }>(
  sampled: T | null,
  carried: T | null,
  table: TableView | null,
): T | null {
  if (!sampled) return carried;
  return sampled.tick >= (table?.tick ?? 0) ? sampled : carried;
}

/** State the agent is in: where the newest step led, or the start after a trial's end. */
export function agentState(learner: LearnerView, walk: WalkView | null): number {
  if (!walk || walk.tick <= learner.tick) return learner.state;
  return walk.trial_end ? learner.start : walk.next;
}

/** Q of the pairs that may be chosen, row by row; `null` where an action is excluded, and at ends. */
export function allowed({ values, weights, ends }: Allowed): (number | null)[][] {
  return values.map((row, state) =>
    row.map((value, action) =>
      ends.includes(state) || isExcluded(weights, state, action) ? null : value,
    ),
  );
}

type Allowed = Pick<LearnerView, 'values' | 'weights' | 'ends'>;

/** Whether an action is never chosen in a state. */
export function isExcluded(weights: number[][], state: number, action: number): boolean {
  return weights[state]?.[action] === 0;
}

/** The best of the actions that may be chosen; none where all are equal, since nothing is known there. */
export function greedy(row: number[], weights: number[] | undefined): number[] {
  const open = row.flatMap((_, action) => (weights?.[action] === 0 ? [] : [action]));
  const most = Math.max(...open.map((action) => row[action] ?? -Infinity));
  const best = open.filter((action) => row[action] === most);
  return best.length === open.length && open.length > 1 ? [] : best;
}
