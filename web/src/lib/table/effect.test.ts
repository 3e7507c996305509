import { expect, it } from 'vitest';

import type { InterventionView } from '../protocol';
import { effects } from './effect';
import { sampleEpisode } from './sample';

const advice = (trial: number): InterventionView => ({
  tick: 9,
  trial,
  kind: 'advice',
  text: 'if wall is ahead then left',
});

it('compares the trials before and after with the same trials of untouched episodes', () => {
  const [effect] = effects([
    sampleEpisode(1, [10, 8, 6, 4]),
    sampleEpisode(2, [20, 12, 10, 8]),
    sampleEpisode(3, [14, 11, 3, 1], [advice(3)]),
  ]);
  // Others: trials 1-2 have means 9 and 16, trials 3-4 have 5 and 9.
  expect(effect?.before).toEqual({ first: 1, last: 2, here: 12.5, others: { mean: 12.5, n: 2 } });
  expect(effect?.after).toEqual({ first: 3, last: 4, here: 2, others: { mean: 7, n: 2 } });
});

it('compares with nobody else, nothing shorter and nothing that was touched', () => {
  const other = { ...sampleEpisode(1, [9, 9]), entrant: 'B10' };
  const training = { ...sampleEpisode(2, [9, 9]), training: true };
  const [second, first] = effects([
    other,
    training,
    sampleEpisode(3, [9]),
    sampleEpisode(4, [5, 5], [advice(2)]),
    sampleEpisode(5, [7, 3], [advice(1)]),
  ]);
  expect([first?.round, second?.round]).toEqual([4, 5]);
  expect(first?.before?.others).toEqual({ mean: 9, n: 1 });
  expect(first?.after.others).toBeNull();
  // Given in the first trial, there is nothing before it.
  expect([second?.before, second?.after.here]).toEqual([null, 5]);
});

it('takes what was done in one trial together', () => {
  const found = effects([sampleEpisode(1, [9, 5, 3], [advice(2), advice(2), advice(3)])]);
  expect(found.map(({ trial, interventions }) => [trial, interventions.length])).toEqual([
    [3, 1],
    [2, 2],
  ]);
});

it('says nothing of episodes without interventions', () => {
  expect(effects([sampleEpisode(1, [3])])).toEqual([]);
});
