import { describe, expect, it } from 'vitest';

import { agentState, allowed, greedy, isExcluded, walkOf } from './present';
import { sampleLabyrinth, sampleLearner, sampleWalk } from './sample';

const task = sampleLabyrinth();
const table = (tick: number, carried: number | null) => ({
  kind: 'walk' as const,
  ...sampleLearner(task, { tick, step: carried === null ? null : sampleWalk({ tick: carried }) }),
});
const step = (tick: number) => ({ kind: 'walk' as const, ...sampleWalk({ tick }) });

describe('the newest step', () => {
  it.each([
    ['only the tables carry one', null, table(5, 5), 5],
    ['the sample is newer', step(9), table(5, 5), 9],
    ['the sample is of the past', step(3), table(5, 5), 5],
    ['an episode began since, without a step', step(3), table(4, null), undefined],
    ['there is none', null, null, undefined],
  ])('%s', (_, sampled, tables, tick) => {
    expect(walkOf(sampled, tables)?.tick).toBe(tick);
  });
});

it('follows the agent to where the newest step led, and back to the start', () => {
  const learner = sampleLearner(task, { tick: 5, state: 4, start: 7 });
  expect(agentState(learner, sampleWalk({ tick: 5, next: 9 }))).toBe(4);
  expect(agentState(learner, sampleWalk({ tick: 6, next: 9 }))).toBe(9);
  const trial_end = { steps: 5, reached_end: true, total_reward: 1, bumps: 0 };
  expect(agentState(learner, sampleWalk({ tick: 6, next: 15, trial_end }))).toBe(7);
});

it('leaves out what is excluded, and ends', () => {
  const values = [
    [1, 2],
    [3, 4],
  ];
  const weights = [
    [1, 0],
    [1, 1],
  ];
  expect(allowed({ values, weights, ends: [1] })).toEqual([
    [1, null],
    [null, null],
  ]);
  expect([isExcluded(weights, 0, 1), isExcluded(weights, 1, 1)]).toEqual([true, false]);
});

it('finds the best among what may be chosen', () => {
  expect(greedy([1, 5, 5], [1, 1, 1])).toEqual([1, 2]);
  expect(greedy([1, 5, 2], [1, 0, 1])).toEqual([2]);
  // All are equal, or there is but one.
  expect([greedy([3, 3, 9], [1, 1, 0]), greedy([3, 3, 9], [0, 1, 0])]).toEqual([[], [1]]);
});
