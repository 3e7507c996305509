import { expect, it } from 'vitest';

import type { PointView } from '../protocol';
import { averages, chain, crossingWords, plots } from './horizon';

const point = (model: string, parameter: number, values: number[], at?: number): PointView => ({
  tick: 1,
  round: 1,
  model,
  parameter,
  values,
  best: 0,
  crossing: at === undefined ? null : { at, from: 0, to: 1 },
});
const points = [
  point('finite-horizon', 5, [6, 0]),
  point('finite-horizon', 6, [8, 10], 5.75),
  point('discounted', 0.9, [16.2, 59.049], 0.2 ** (1 / 3)),
  point('average', 0, [2, 10]),
];

it('parts the points into the two plots, with their crossings', () => {
  const [finite, discounted] = plots(points, 2);
  expect(finite?.columns).toEqual([
    [5, 6],
    [6, 8],
    [0, 10],
  ]);
  expect(finite?.crossings.map(({ at }) => at)).toEqual([5.75]);
  expect(discounted?.columns[0]).toEqual([0.9]);
  expect(averages(points)?.values).toEqual([2, 10]);
  expect(averages([])).toBeNull();
});

it('says a crossing as short as it can', () => {
  const names = ['a0', 'a1'];
  const words = (at: number) => crossingWords({ at, from: 0, to: 1 }, 'γ', names);
  expect(words(0.2 ** (1 / 3))).toBe('γ = 0.585: a0 before, a1 after');
  expect(words(16)).toBe('γ = 16: a0 before, a1 after');
});

it('draws a policy as a chain whose last reward goes on', () => {
  expect(chain({ name: 'a0', lead: [0, 0], then: 2 })).toEqual(['0', '0', '2 …']);
});
