import { expect, it } from 'vitest';

import { sampleSession } from './sample';
import { mainControl, outcome } from './states';

it.each([
  [['start', 'step'], 'start'],
  [['pause', 'stop'], 'pause'],
  [['resume', 'step', 'stop', 'reset'], 'resume'],
  [['reset'], null],
])('of %j the space bar means %s', (controls, main) => {
  expect(mainControl(sampleSession({ controls }))).toBe(main);
});

it('says what a control led to, and never more', () => {
  expect(outcome('pause', undefined, { state: 'paused', tick: 132 })).toBe('Paused at tick 132');
  expect(outcome('pause', undefined, { state: 'finished', tick: 540 })).toBe(
    'Finished at tick 540',
  );
  expect(outcome('start', undefined, { state: 'queued', tick: 0 })).toBe('Queued at tick 0');
  expect(outcome('step', 'trial', { state: 'paused', tick: 39 })).toBe(
    'Stepped to the end of the trial at tick 39',
  );
  expect(outcome('step', 'trial', { state: 'paused', tick: 39 }, 'drive')).toBe(
    'Stepped to the end of the run at tick 39',
  );
});
