import { expect, it } from 'vitest';

import type { Yardstick } from './protocol';
import { sampleTrial } from './sample';
import { plannedWords, regretShare, withRegret } from './yardstick';

const ready: Yardstick = {
  state: 'ready',
  total_reinforcement: -4,
  steps: 27,
  collisions: 0,
  resolution: 0.01,
  path_m: [],
};
const computing: Yardstick = { state: 'computing' };

it('gives every trial that reached the goal its regret, 0 for the best path', () => {
  const regret = (R: number, reached_goal: boolean, yardstick: Yardstick) =>
    withRegret(
      sampleTrial(1, {
        total_reinforcement: R,
        safety: -1,
        goal: R + 1,
        true_goal: null,
        reached_goal,
      }),
      yardstick,
    ).regret;
  expect(regret(-6, true, ready)).toBe(2);
  expect(regret(-4, true, ready)).toBe(0);
  expect(regret(-50, false, ready)).toBeNull();
  expect(regret(-6, true, computing)).toBeNull();
  expect(regret(-6, true, { state: 'none' })).toBeNull();
});

it('takes the goal where it truly was, where the log says so', () => {
  const trial = sampleTrial(1, { total_reinforcement: -6, safety: -1, goal: -5, true_goal: -4.5 });
  expect(withRegret(trial, ready).regret).toBe(1.5);
});

it('says a regret as a share of the best cost', () => {
  expect(regretShare(2, ready)).toBe('50 %');
  expect(regretShare(2, { ...ready, total_reinforcement: 0 })).toBe('');
  expect(regretShare(2, computing)).toBe('');
});

it('says what is known of the best path', () => {
  expect(plannedWords(computing)).toContain('being computed');
  expect(plannedWords({ state: 'none' })).toContain('No planned path');
  expect(plannedWords(ready)).toContain('R* = −4.00 in 27 steps');
});
