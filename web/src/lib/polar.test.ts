import { expect, it } from 'vitest';

import { halves, rings, sonarWords } from './polar';

const RING = Array.from({ length: 24 }, (_, index) => 15 * index);
const FRONT = [60, 51, 40, 26, 9, -9, -26, -40, -51, -60];

it('draws at most five rings at round ranges', () => {
  expect(rings(8)).toEqual([2, 4, 6, 8]);
  expect(rings(1)).toEqual([0.25, 0.5, 0.75, 1]);
  expect(rings(5)).toEqual([1, 2, 3, 4, 5]);
});

it('tells the readings, nearest first', () => {
  const sonar_m = Array.from({ length: 24 }, (_, index) => (index === 20 ? 0.4 : 2));
  expect(sonarWords(sonar_m, RING)).toBe(
    'Nearest 0.40 m 60° right (sonar 20); ahead 2.00 m, left 2.00 m, behind 2.00 m, right 0.40 m',
  );
  expect(sonarWords([], [])).toBe('No reading yet');
});

it('says nothing of where no sonar looks', () => {
  const sonar_m = FRONT.map((bearing) => (bearing === 51 ? 0.5 : 1.5));
  expect(sonarWords(sonar_m, FRONT)).toBe(
    'Nearest 0.50 m 51° left (sonar 1); ahead 1.50 m, left 0.50 m, right 1.50 m',
  );
});

it('draws each cone half way to its neighbours', () => {
  expect(halves(RING, 23)).toEqual({ left: 7.5, right: 7.5 });
  expect(halves(FRONT, 4)).toEqual({ left: 8.5, right: 9 });
  expect(halves(FRONT, 0)).toEqual({ left: 15, right: 4.5 });
  expect(halves([0], 0)).toEqual({ left: 15, right: 15 });
});
