import { expect, it } from 'vitest';

import { leversOf, placeOn, scaleOf } from './levers';
import { sampleBandit } from './sample';

const names = ['lever 1', 'lever 2', 'lever 3'];

it('shows no estimate before the first pull, and marks the best and the last', () => {
  const levers = leversOf(sampleBandit(), names);
  expect(levers.map(({ estimate }) => estimate)).toEqual([0.5, 0.5, null]);
  expect(levers.map(({ isBest }) => isBest)).toEqual([false, false, true]);
  expect(levers.map(({ isLast }) => isLast)).toEqual([false, true, false]);
  expect(levers[2]?.score).toBeNull();
});

it('scales from 0 and cuts bounds that would squeeze the rest', () => {
  expect(scaleOf(leversOf(sampleBandit(), names))).toEqual([0, 1.4]);
  const step = { ...sampleBandit().step!, scores: [50, 1, null] };
  expect(scaleOf(leversOf(sampleBandit({ step }), names))).toEqual([0, 1.6]);
  expect(scaleOf(leversOf(sampleBandit({ step: null, means: [-1, 0.5, 0.8] }), names))).toEqual([
    -1, 0.8,
  ]);
});

it('places values on the scale, and what lies outside at its end', () => {
  expect([-1, 0, 1, 2, 9].map((value) => placeOn([0, 2], value))).toEqual([0, 0, 50, 100, 100]);
});
