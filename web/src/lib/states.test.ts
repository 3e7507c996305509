import { expect, it } from 'vitest';

import { sampleSession } from './sample';
import { mainControl } from './states';

it.each([
  [['start', 'step'], 'start'],
  [['pause', 'stop'], 'pause'],
  [['resume', 'step', 'stop', 'reset'], 'resume'],
  [['reset'], null],
])('of %j the space bar means %s', (controls, main) => {
  expect(mainControl(sampleSession({ controls }))).toBe(main);
});
