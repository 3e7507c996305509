import { expect, it } from 'vitest';

import { sampleSession } from '../sample';
import { addCycles, addRuns, CYCLES_KEPT, RUNS_KEPT, runsOf } from './history';
import { sampleCycle, sampleRun } from './sample';

const cycles = (from: number, to: number) =>
  Array.from({ length: to - from + 1 }, (_, index) => sampleCycle(from + index));
const runs = (...rounds: number[]) => rounds.map(sampleRun);

it('keeps cycles in order, none twice, and a bounded number of them', () => {
  const ticks = addCycles(cycles(1, 5), cycles(4, 8)).map(({ tick }) => tick);
  expect(ticks).toEqual([1, 2, 3, 4, 5, 6, 7, 8]);
  expect(addCycles(cycles(1, 3), [])).toHaveLength(3);
  const many = addCycles(cycles(1, CYCLES_KEPT), cycles(CYCLES_KEPT + 1, CYCLES_KEPT + 50));
  expect([many.length, many[0]?.tick, many.at(-1)?.tick]).toEqual([300, 51, 350]);
});

it('forgets the cycles of before a reset', () => {
  expect(addCycles(cycles(1, 200), cycles(1, 2)).map(({ tick }) => tick)).toEqual([1, 2]);
});

it('keeps runs in order, none twice, and none that the session does not stand by', () => {
  const rounds = addRuns(runs(1, 2, 3), runs(3, 4)).map(({ round }) => round);
  expect(rounds).toEqual([1, 2, 3, 4]);
  const many = runs(...Array.from({ length: RUNS_KEPT + 3 }, (_, index) => index + 1));
  expect(addRuns(many.slice(0, -3), many.slice(-3)).map(({ round }) => round)[0]).toBe(4);
  const session = (rounds_done: number) => sampleSession({ family: 'drive', rounds_done });
  expect(runsOf(session(2), runs(1, 2, 3)).map(({ round }) => round)).toEqual([1, 2]);
  expect(runsOf(session(0), runs(1, 2))).toEqual([]);
});
