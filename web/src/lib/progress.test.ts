import { describe, expect, it } from 'vitest';

import { sampleSession, sampleTick } from './sample';
import { doneWords, progressOf, tableFacts } from './progress';
import { sampleLabyrinth, sampleWalk } from './table/sample';

const table = sampleSession({ family: 'table', rounds: 60, rounds_done: 2, trials: 100, tick: 57 });
const step = { kind: 'walk' as const, ...sampleWalk({ round: 3 }) };

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

  it('ends with the last', () => {
    const done = { ...table, state: 'finished' as const, rounds_done: 60 };
    expect(progressOf(done, { tick: null, step: null, cycle: null }).words).toBe('Round 60 of 60');
  });
});

it('says in the list what is done', () => {
  expect([doneWords(sampleSession()), doneWords(table)]).toEqual([
    '12 of 20 trials',
    '2 of 60 episodes',
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
