import { expect, test } from 'vitest';
import { SIZE, curve, density, place, span } from './gaussian';

test('the density is that of printed tables', () => {
  // Standard normal: 0.39894 in the middle, 0.24197 one deviation away.
  expect(density({ mean: 0, sigma: 1 }, 0)).toBeCloseTo(0.39894, 5);
  expect(density({ mean: 2, sigma: 1 }, 3)).toBeCloseTo(0.24197, 5);
  expect(density({ mean: 0, sigma: 2 }, 2)).toBeCloseTo(0.24197 / 2, 5);
});

test('the span holds three deviations of all', () => {
  const range = span([
    { mean: 0, sigma: 2 },
    { mean: 5, sigma: 1 },
  ]);
  expect(range).toEqual([-6, 8]);
  expect(place(range, 1)).toBe(SIZE.width / 2);
});

test('a curve reaches the head where its density is the greatest', () => {
  const narrow = { mean: 0, sigma: 1 };
  const points = curve(narrow, [-3, 3], density(narrow, 0), 3).split(' ');
  expect(points[1]).toBe(`${(SIZE.width / 2).toFixed(2)},${SIZE.head.toFixed(2)}`);
});
