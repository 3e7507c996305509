import { expect, it } from 'vitest';

import { frameOf, spotAt, valueRange } from './maze';
import { sampleLearner, sampleMaze } from './sample';

const task = sampleMaze(['S.', '.G', '..']);

it('fits a maze into a canvas, in its middle', () => {
  const frame = frameOf(task, 212, 252);
  // Two columns and three rows within margins of 6: 80 by height, 100 by width.
  expect(frame).toEqual({ left: 26, top: 6, side: 80 });
  expect(spotAt(frame, 26 + 120, 6 + 200)).toEqual([1.5, 2.5]);
});

it('colours between the values of states that have one', () => {
  const learner = sampleLearner(task, { state_values: [0.2, 0.4, 0.9, 50, 0.3, 0.1], ends: [3] });
  expect(valueRange(learner)).toEqual([0.1, 0.9]);
});
