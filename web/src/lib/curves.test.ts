import { expect, it } from 'vitest';

import { CURVES, planned, points, summary } from './curves';
import { sampleTrial } from './sample';

const [neurons, steps, reinforcement] = CURVES;
if (!neurons || !steps || !reinforcement) throw new Error('there are three curves');
const trials = [
  sampleTrial(1, { steps: 39, neurons: 38 }),
  sampleTrial(2, { steps: 200, reached_goal: false }),
  sampleTrial(3, { steps: 26 }),
  sampleTrial(4, { steps: 28 }),
];

it('leaves a hole where a trial was capped, except in the count of neurons', () => {
  expect(points(steps, trials)).toEqual({
    trials: [1, 2, 3, 4],
    values: [39, null, 26, 28],
    capped: [2],
  });
  expect(points(neurons, trials).capped).toEqual([]);
});

it('sums a curve up', () => {
  expect(summary(steps, trials)).toBe(
    'From 39 in trial 1 to 28 in trial 4; least 26 in trial 3. Trial 2 was capped before the goal (✕).',
  );
  expect(summary(neurons, trials)).toBe('From 38 in trial 1 to 82 in trial 4.');
  expect(summary(reinforcement, trials.slice(0, 1))).toBe('−6.24 in trial 1.');
  expect(summary(steps, [])).toBe('No trial to show yet.');
});

it('has a line for the planned path on steps and reinforcement only', () => {
  const yardstick = {
    state: 'ready' as const,
    total_reinforcement: -4,
    steps: 25,
    collisions: 0,
    resolution: 0,
    path_m: [],
  };
  expect(CURVES.map((kind) => planned(kind, yardstick))).toEqual([null, 25, -4]);
  expect(CURVES.map((kind) => planned(kind, { state: 'computing' }))).toEqual([null, null, null]);
});
