import { expect, it } from 'vitest';

import { sampleTick, sampleTrial } from './sample';
import { line, outcome, viewBox, walkOf, walls } from './walk';

const tick = (x_m: number, contact: string) => {
  const whole = sampleTick();
  const pose = (x: number) => ({ x_m: x, y_m: -2, heading_deg: 0 });
  return {
    ...whole,
    true_pose: pose(x_m),
    outcome: { ...whole.outcome, true_pose: pose(x_m + 0.5), contact },
  };
};

it('begins at home, ends after the last step and marks collisions', () => {
  const walk = walkOf([tick(0, 'none'), tick(0.5, 'virtual'), tick(1, 'none')]);
  expect(walk.poses.map((pose) => pose.x_m)).toEqual([0, 0.5, 1, 1.5]);
  expect(walk.collisions).toEqual([2]);
  expect(line(walk, 1)).toBe('0.000,2.000 0.500,2.000');
  expect(line(walk, 9).split(' ')).toHaveLength(4);
  expect(walkOf([])).toEqual({ poses: [], collisions: [] });
});

it('turns the world over, since y points down on the screen', () => {
  expect(walls([[0, 1, 2, 1]])).toBe('M0.000,-1.000L2.000,-1.000');
  expect(viewBox([-1, -2, 3, 4], 0.5)).toBe('-1.5 -4.5 5 7');
});

it('says what became of a trial and where its steps went', () => {
  const trial = {
    ...sampleTrial(1),
    steps: 39,
    total_reinforcement: -30.1,
    reached_goal: true,
    region_steps: { room: 30, concave: 9, door: 0 },
  };
  expect(outcome(trial)).toBe(
    'Trial 1: goal reached in 39 steps, R = −30.10; steps by region: room 30, concave 9',
  );
  expect(outcome({ ...trial, reached_goal: false, region_steps: { room: 39 } })).toBe(
    'Trial 1: goal not reached in 39 steps, R = −30.10',
  );
});
