import { expect, it } from 'vitest';

import {
  addEpisodes,
  addLog,
  addTrials,
  EPISODES_KEPT,
  episodesOf,
  LOG_LINES,
  shownOf,
  TRIALS_KEPT,
  trialsOf,
} from './history';
import { sampleSession, sampleTrial } from './sample';
import { sampleEpisode } from './table/sample';

const trials = (...numbers: number[]) => numbers.map((number) => sampleTrial(number));
const numbers = (list: { trial: number }[]) => list.map(({ trial }) => trial);

it('adds trials in order and none twice', () => {
  expect(numbers(addTrials(trials(1, 2), trials(3, 4)))).toEqual([1, 2, 3, 4]);
  expect(numbers(addTrials(trials(1, 2, 3), trials(2, 3, 4)))).toEqual([1, 2, 3, 4]);
  expect(numbers(addTrials(trials(1), []))).toEqual([1]);
});

it('keeps the newest trials and says how many of all', () => {
  const many = trials(...Array.from({ length: TRIALS_KEPT }, (_, index) => index + 1));
  const session = sampleSession({ trials_done: TRIALS_KEPT + 2 });
  expect(shownOf(session, many)).toBe('');
  const next = addTrials(many, trials(TRIALS_KEPT + 1, TRIALS_KEPT + 2));
  expect([next.length, next[0]?.trial, next.at(-1)?.trial]).toEqual([TRIALS_KEPT, 3, 1002]);
  expect(shownOf(session, next)).toBe('newest 1000 of 1002 trials, all are in the CSV');
  expect(trialsOf(session, next)).toBe(next);
});

it('takes back the trials of a session that was reset', () => {
  expect(trialsOf(sampleSession({ trials_done: 0 }), trials(1, 2))).toEqual([]);
  expect(numbers(trialsOf(sampleSession({ trials_done: 2 }), trials(1, 2)))).toEqual([1, 2]);
});

it('keeps the newest episodes in order, none twice, and none of before a reset', () => {
  const episodes = (...rounds: number[]) => rounds.map((round) => sampleEpisode(round, [5]));
  const rounds = (list: { round: number }[]) => list.map(({ round }) => round);
  expect(rounds(addEpisodes(episodes(1, 2, 3), episodes(3, 4)))).toEqual([1, 2, 3, 4]);
  const many = episodes(...Array.from({ length: EPISODES_KEPT }, (_, index) => index + 1));
  const next = addEpisodes(many, episodes(EPISODES_KEPT + 1));
  expect([next.length, next[0]?.round]).toEqual([EPISODES_KEPT, 2]);
  expect(episodesOf(sampleSession({ rounds_done: 0 }), next)).toEqual([]);
  expect(episodesOf(sampleSession({ rounds_done: 1000 }), next)).toBe(next);
});

it('keeps the newest lines of the log', () => {
  const line = (tick: number) => ({ at: '', tick, kind: 'trial', text: '' });
  const full = Array.from({ length: LOG_LINES }, (_, index) => line(index));
  const next = addLog(full, [line(1000)]);
  expect([next.length, next[0]?.tick, next.at(-1)?.tick]).toEqual([LOG_LINES, 1, 1000]);
});
