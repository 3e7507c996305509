import { expect, it } from 'vitest';

import { share, shareWords, squares, verdict } from './consistency';
import { sampleCycle } from './sample';

/** χ² with one degree of freedom: 2.5 % lie below the first and above the second. */
const BOUNDS: [number, number] = [0.000982, 5.0239];

it('gathers the values of one region or of all, and leaves out those that are missing', () => {
  const cycle = sampleCycle(1);
  const regions = cycle.regions.map((region, index) => ({
    ...region,
    nis: index === 2 ? null : index,
  }));
  expect(squares({ ...cycle, regions }, 'nis', null)).toEqual([0, 1, 3, 4]);
  expect(squares({ ...cycle, regions }, 'nis', 3)).toEqual([3]);
  expect(squares({ ...cycle, regions }, 'nis', 2)).toEqual([]);
  expect(squares(cycle, 'nees', null)).toEqual([0.5, 0.5, 0.5, 0.5, 0.5]);
});

it('tells the share within the bounds', () => {
  expect(share([0, 0.001, 1, 5, 6], BOUNDS)).toEqual({
    n: 5,
    within: 0.6,
    mean: expect.closeTo(2.4002, 12) as number,
  });
  expect(share([], BOUNDS)).toBeNull();
  expect(shareWords(share([0, 1, 1, 2], BOUNDS))).toBe('75 % of 4 within, mean 1.00');
  expect(shareWords(null)).toBe('no value yet');
});

it('finds 95 % of squares of normal values within', () => {
  // Quantiles of the normal distribution stand for a large sample: 1.95996 is that of 97.5 %.
  const values = Array.from({ length: 2001 }, (_, index) => ((index - 1000) / 1000) * 4);
  const weight = (z: number) => Math.exp((-z * z) / 2);
  const total = values.reduce((sum, z) => sum + weight(z), 0);
  const within = values
    .filter((z) => share([z * z], BOUNDS)?.within === 1)
    .reduce((sum, z) => sum + weight(z), 0);
  expect(within / total).toBeCloseTo(0.95, 2);
});

it('says how sure a filter is, but not of a few values', () => {
  const of = (mean: number, n = 100) => verdict({ n, within: 1, mean });
  expect([of(1), of(0.1), of(9)].map((words) => words.split(' ')[0])).toEqual([
    'about',
    'more',
    'too',
  ]);
  expect([of(9, 5), verdict(null)]).toEqual(['', '']);
  // A mean of 1 with a quarter of the values outside is not what normal errors do.
  expect(verdict({ n: 100, within: 0.75, mean: 1 })).toContain('not normal');
  expect(verdict({ n: 100, within: 0.93, mean: 1 })).toBe('about as sure as it should be');
});
