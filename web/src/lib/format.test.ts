import { expect, it } from 'vitest';

import { ago, brief, capital, count, degrees, number, pace, signed, words } from './format';

it('writes numbers with a true minus and no negative zero', () => {
  expect([number(-6.244), number(-0.001), number(2, 0), number(NaN)]).toEqual([
    '−6.24',
    '0.00',
    '2',
    '–',
  ]);
  expect([signed(0.5), signed(-0.5)]).toEqual(['+0.50', '−0.50']);
  expect([brief(0.1 + 0.2), brief(-0.001), brief(1000)]).toEqual(['0.3', '−0.001', '1000']);
  expect(degrees(-12.34)).toBe('−12.3°');
});

it('counts with the right noun', () => {
  expect([count(1, 'trial'), count(0, 'trial'), count(12000, 'tick')]).toEqual([
    '1 trial',
    '0 trials',
    '12,000 ticks',
  ]);
});

it('says how long ago', () => {
  const now = Date.parse('2026-11-22T12:00:00Z');
  const before = (seconds: number) => ago(new Date(now - seconds * 1000).toISOString(), now);
  expect([-5, 44, 45, 61, 7200, 90_000, 200_000].map(before)).toEqual([
    'just now',
    'just now',
    '1 minute ago',
    '1 minute ago',
    '2 hours ago',
    '1 day ago',
    '2 days ago',
  ]);
});

it('says paces and names in words', () => {
  expect([pace('max'), pace(30)]).toEqual(['as fast as it goes', '30 ticks/s']);
  expect(capital(words('minimum-cost-path'))).toBe('Minimum cost path');
});
