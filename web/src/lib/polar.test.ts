import { expect, it } from 'vitest';

import { rings, sonarWords } from './polar';

it('draws at most five rings at round ranges', () => {
  expect(rings(8)).toEqual([2, 4, 6, 8]);
  expect(rings(1)).toEqual([0.25, 0.5, 0.75, 1]);
  expect(rings(5)).toEqual([1, 2, 3, 4, 5]);
});

it('tells the readings, nearest first', () => {
  const sonar_m = Array.from({ length: 24 }, (_, index) => (index === 20 ? 0.4 : 2));
  expect(sonarWords(sonar_m)).toBe(
    'Nearest 0.40 m at 60° right (sonar 20); ahead 2.00 m, left 2.00 m, behind 2.00 m, right 2.00 m',
  );
  expect(sonarWords([])).toBe('No reading yet');
});
