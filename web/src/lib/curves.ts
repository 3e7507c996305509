/** Learning curves: data for the charts, and their summary in words. */

import { number } from './format';
import type { PlannedPath, Trial, Yardstick } from './protocol';

/** One curve over trials. */
export interface CurveKind {
  title: string;
  unit: string;
  decimals: number;
  best: 'least' | 'greatest' | null;
  /** A capped trial has no defined steps or total reinforcement (section 5.11). */
  needsGoal: boolean;
  value: (trial: Trial) => number;
  /** What the best path that a planner finds has. */
  planned?: (path: PlannedPath) => number;
}

/** The curves of the page, as in Figure 5.8 of the thesis. */
export const CURVES: CurveKind[] = [
  {
    title: 'Neurons',
    unit: 'neurons',
    decimals: 0,
    best: null,
    needsGoal: false,
    value: (trial) => trial.neurons,
  },
  {
    title: 'Steps',
    unit: 'steps',
    decimals: 0,
    best: 'least',
    needsGoal: true,
    value: (trial) => trial.steps,
    planned: (path) => path.steps,
  },
  {
    title: 'Total reinforcement',
    unit: 'R(n)',
    decimals: 2,
    best: 'greatest',
    needsGoal: true,
    value: (trial) => trial.total_reinforcement,
    planned: (path) => path.total_reinforcement,
  },
];

/** Points of a curve: trials, values (none for a capped trial) and the capped trials. */
export interface Points {
  trials: number[];
  values: (number | null)[];
  capped: number[];
}

/** The points of one curve. */
export function points(kind: CurveKind, trials: Trial[]): Points {
  const hole = (trial: Trial) => kind.needsGoal && !trial.reached_goal;
  return {
    trials: trials.map((trial) => trial.trial),
    values: trials.map((trial) => (hole(trial) ? null : kind.value(trial))),
    capped: trials.filter(hole).map((trial) => trial.trial),
  };
}

/** What the planned path has on a curve; none where that means nothing or is not known. */
export function planned(kind: CurveKind, yardstick: Yardstick): number | null {
  return yardstick.state === 'ready' && kind.planned ? kind.planned(yardstick) : null;
}

/** The curve in a sentence or two. */
export function summary(kind: CurveKind, trials: Trial[]): string {
  const { trials: numbers, values, capped } = points(kind, trials);
  const shown = values.flatMap((value, index) =>
    value === null ? [] : [{ trial: numbers[index] ?? 0, value }],
  );
  const [first, last] = [shown[0], shown[shown.length - 1]];
  const holes = capped.length > 0 ? ` ${cappedWords(capped)}` : '';
  if (!first || !last) return `No trial to show yet.${holes}`;
  const say = (point: Shown) => `${number(point.value, kind.decimals)} in trial ${point.trial}`;
  const course = first === last ? say(first) : `From ${say(first)} to ${say(last)}`;
  return `${course}${best(kind, shown, say)}.${holes}`;
}

interface Shown {
  trial: number;
  value: number;
}

function best(kind: CurveKind, shown: Shown[], say: (point: Shown) => string): string {
  if (kind.best === null || shown.length < 2) return '';
  const better = (a: Shown, b: Shown) =>
    kind.best === 'least' ? b.value < a.value : b.value > a.value;
  return `; ${kind.best} ${say(shown.reduce((a, b) => (better(a, b) ? b : a)))}`;
}

function cappedWords(capped: number[]): string {
  const named = capped.slice(0, 8).join(', ') + (capped.length > 8 ? ', …' : '.');
  return capped.length === 1
    ? `Trial ${capped[0]} was capped before the goal (✕).`
    : `${capped.length} trials were capped before the goal (✕): ${named}`;
}
