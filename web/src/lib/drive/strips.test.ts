import { expect, it } from 'vitest';

import { sampleCycle } from './sample';
import { along, beginnings, latest, lines, logPlace, STRIP } from './strips';

it('shows the newest cycles', () => {
  const cycles = Array.from({ length: 300 }, (_, index) => sampleCycle(index + 1));
  const shown = latest(cycles);
  expect([shown.length, shown[0]?.tick, shown.at(-1)?.tick]).toEqual([STRIP, 181, 300]);
  // After a gap the old ones are too far back, however few there are.
  expect(latest([sampleCycle(1), sampleCycle(500)]).map(({ tick }) => tick)).toEqual([500]);
});

it('breaks a line at what is missing, at missed cycles and at the end of a run', () => {
  const cycles = [
    sampleCycle(1),
    sampleCycle(2),
    sampleCycle(3, { clearance_m: NaN }),
    sampleCycle(4),
    sampleCycle(7),
    sampleCycle(8, { round: 2 }),
    sampleCycle(9, { round: 2 }),
  ];
  const found = lines(cycles, ({ clearance_m }) => clearance_m);
  expect(found.map((points) => points.map(({ back }) => back))).toEqual([[8, 7], [5], [2], [1, 0]]);
  expect(lines(cycles, () => null)).toEqual([]);
});

it('marks where runs begin', () => {
  const method = 'minimum';
  const cycles = [sampleCycle(5), sampleCycle(6, { round: 2, run: 2, method }), sampleCycle(7)];
  expect(beginnings(cycles)[0]).toEqual({ back: 1, run: 2, method });
});

it('puts the newest cycle at the right end', () => {
  expect([along(0), along(STRIP - 1)]).toEqual([1, 0]);
});

it('places values on a logarithmic scale', () => {
  expect(logPlace(1, 0.01, 100)).toBeCloseTo(0.5, 12);
  expect([logPlace(0, 0.01, 100), logPlace(-1, 0.01, 100), logPlace(1e9, 0.01, 100)]).toEqual([
    0, 0, 1,
  ]);
});
