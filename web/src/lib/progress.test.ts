import { describe, expect, it } from 'vitest';

import { sampleSession, sampleTick } from './sample';
import { sampleCourse, sampleCycle } from './drive/sample';
import { doneWords, driveFacts, progressOf, tableFacts } from './progress';
import { sampleLabyrinth, sampleWalk } from './table/sample';

const table = sampleSession({ family: 'table', rounds: 60, rounds_done: 2, trials: 100, tick: 57 });
const step = { kind: 'walk' as const, ...sampleWalk({ round: 3 }) };
const drive = sampleSession({ family: 'drive', rounds: 40, rounds_done: 2, trials: 20, tick: 9 });

describe('progress', () => {
  it('of a path counts trials', () => {
    const tick = sampleTick({ trial: 13, step: 9 });
    const found = progressOf(sampleSession(), { tick, step: null, cycle: null });
    expect([found.words, found.step, found.max, found.done]).toEqual([
      'Trial 13 of 20',
      'step 9',
      20,
      12,
    ]);
  });

  it('of a path has no step of the trial before', () => {
    const tick = sampleTick({ trial: 12 });
    expect(progressOf(sampleSession(), { tick, step: null, cycle: null }).step).toBe('');
  });

  it('of competitors counts rounds, and says whose turn it is', () => {
    const found = progressOf(table, { tick: null, step, cycle: null });
    expect([found.words, found.step]).toEqual([
      'Round 3 of 60',
      'episode 1 of B11, trial 4, step 2',
    ]);
    expect(progressOf({ ...table, rounds_done: 3 }, { tick: null, step, cycle: null }).step).toBe(
      '',
    );
  });

  it('of a drive counts runs, and says by which method', () => {
    const cycle = sampleCycle(400, { round: 3 });
    const found = progressOf(drive, { tick: null, step: null, cycle });
    expect([found.words, found.step]).toEqual(['Run 3 of 40', 'by Median + Kalman, cycle 400']);
    expect(progressOf({ ...drive, rounds_done: 3 }, { tick: null, step: null, cycle }).step).toBe(
      '',
    );
  });

  it('ends with the last', () => {
    const done = { ...table, state: 'finished' as const, rounds_done: 60 };
    expect(progressOf(done, { tick: null, step: null, cycle: null }).words).toBe('Round 60 of 60');
  });
});

it('says in the list what is done', () => {
  expect([sampleSession(), table, drive].map(doneWords)).toEqual([
    '12 of 20 trials',
    '2 of 60 episodes',
    '2 of 40 runs',
  ]);
});

it('says how long episodes are, where there are several', () => {
  const session = { ...table, settings: { episodes: 10 } };
  expect(tableFacts(session, sampleLabyrinth())).toEqual([
    ['Episodes', '10'],
    ['Trials an episode', '100'],
  ]);
  expect(tableFacts(session, { ...sampleLabyrinth(), kind: 'levers' })[1]?.[0]).toBe(
    'Pulls an episode',
  );
  expect(tableFacts(session, { ...sampleLabyrinth(), kind: 'policies' })).toEqual([]);
});

it('says by which methods a course is driven', () => {
  expect(driveFacts(drive, sampleCourse())).toEqual([
    ['Driven by', 'Minimum, then Median + Kalman'],
    ['Runs of each method', '20'],
  ]);
  const approach = sampleCourse({ rules: null, drivers: ['median-kalman'] });
  expect(driveFacts(drive, approach)).toEqual([
    ['Looked at', 'Median + Kalman'],
    ['Runs', '20'],
  ]);
  expect(driveFacts(drive, null)).toEqual([['Runs', '20']]);
});
