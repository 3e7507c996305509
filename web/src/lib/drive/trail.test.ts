import { expect, it } from 'vitest';

import { sampleCycle } from './sample';
import { extended, firstCycle, MOST_SPOTS, rejoined } from './trail';

const cycles = (from: number, to: number, round = 1) =>
  Array.from({ length: to - from + 1 }, (_, index) => sampleCycle(from + index, { round }));

it('follows a run, and begins anew with the next', () => {
  const trail = extended(extended(null, cycles(1, 3)), cycles(4, 6));
  expect(trail?.spots.map(({ cycle }) => cycle)).toEqual([1, 2, 3, 4, 5, 6]);
  expect(trail?.spots[5]?.x_m).toBeCloseTo(1.44, 12);
  const next = extended(trail, cycles(1, 2, 2));
  expect([next?.round, next?.spots.length]).toEqual([2, 2]);
});

it('begins anew after a reset', () => {
  expect(extended(extended(null, cycles(1, 30)), cycles(1, 2))?.spots).toHaveLength(2);
});

it('draws no line over cycles that were missed', () => {
  const trail = extended(extended(null, cycles(1, 3)), cycles(10, 12));
  expect(trail?.spots.filter(({ isGap }) => isGap).map(({ cycle }) => cycle)).toEqual([10]);
});

it('says where it begins for a page that came late', () => {
  const trail = extended(null, cycles(500, 510));
  expect(trail && firstCycle(trail)).toBe(500);
});

it('stays bounded however long a run is, and keeps its ends', () => {
  let trail = extended(null, []);
  for (let from = 1; from <= 40_000; from += 50) trail = extended(trail, cycles(from, from + 49));
  expect(trail?.spots.length).toBeLessThanOrEqual(MOST_SPOTS);
  expect(trail?.spots.length).toBeGreaterThan(MOST_SPOTS / 4);
  expect(trail?.spots[0]?.cycle).toBe(1);
  expect(trail?.spots.some(({ isGap }) => isGap)).toBe(false);
  expect(40_000 - (trail?.spots.at(-1)?.cycle ?? 0)).toBeLessThan(64);
});

it('stays bounded when it is nothing but gaps', () => {
  let trail = extended(null, []);
  for (let cycle = 1; cycle <= 20_000; cycle += 2) trail = extended(trail, [sampleCycle(cycle)]);
  expect(trail?.spots.length).toBeLessThanOrEqual(MOST_SPOTS);
  expect(trail?.spots.at(-1)?.cycle).toBe(19_999);
});

it('remembers contacts where they began', () => {
  const bump = { what: 'door', time_s: 1, front: true };
  const trail = extended(null, [sampleCycle(1), sampleCycle(2, { bump })]);
  expect(trail?.bumps.map(({ what }) => what)).toEqual(['door']);
});

it('goes on where the page has seen it when the history is told again', () => {
  const trail = extended(null, cycles(1, 400));
  expect(rejoined(trail, cycles(111, 410))?.spots).toHaveLength(410);
  const lost = rejoined(trail, cycles(701, 1000));
  expect(lost?.spots.filter(({ isGap }) => isGap).map(({ cycle }) => cycle)).toEqual([701]);
  expect(rejoined(trail, cycles(1, 20))?.spots).toHaveLength(20);
  expect(rejoined(trail, cycles(1, 20, 2))?.round).toBe(2);
  expect(rejoined(null, cycles(5, 6))?.spots).toHaveLength(2);
});
