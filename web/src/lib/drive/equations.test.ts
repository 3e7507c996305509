import { describe, expect, it } from 'vitest';

import { algorithmOne, estimation, inference, membershipOf, windowOf } from './equations';
import { sampleCycle, sampleInference, sampleRules } from './sample';

describe('Algorithm 1', () => {
  const window_m = [1.02, 1.7, 0.4, 1.1];

  it('is the mean of the window, whatever ς is', () => {
    for (const deviation of [0.01, 0.32, 5]) {
      const last = algorithmOne(window_m, deviation ** 2).at(-1);
      expect(last?.mean_m).toBeCloseTo((1.02 + 1.7 + 0.4 + 1.1) / 4, 12);
      expect(last?.variance_m2).toBeCloseTo(deviation ** 2 / 4, 12);
    }
  });

  it('has gains 1/2, 1/3, 1/4', () => {
    const gains = algorithmOne(window_m, 0.1).map(({ gain }) => gain);
    [1, 1 / 2, 1 / 3, 1 / 4].forEach((gain, index) => expect(gains[index]).toBeCloseTo(gain, 12));
  });

  it('begins with what there is', () => {
    expect(algorithmOne([], 1)).toEqual([]);
    expect(algorithmOne([0.7], 4)).toEqual([{ z_m: 0.7, gain: 1, mean_m: 0.7, variance_m2: 4 }]);
  });

  it('stands with its numbers', () => {
    const [window, gains, estimate, sigma] = estimation([1, 2], 0.32);
    expect(window?.numbers).toBe('1.00, 2.00 m');
    expect(gains?.numbers).toBe('0.50');
    expect(estimate?.numbers).toBe('1.000 → 1.500 m');
    expect(sigma?.numbers).toBe('σ = 0.320 → 0.226 m');
    expect(estimation([], 0.32)).toEqual([]);
  });
});

it('takes the window from this run, without gaps', () => {
  const of = (cycle: number, depth: number, round = 1) => {
    const regions = sampleCycle(cycle).regions.map((region) => ({ ...region, depths_m: [depth] }));
    return sampleCycle(cycle, { regions, round });
  };
  expect(windowOf([of(1, 1), of(2, 2), of(3, 3)], 0, 0, 4)).toEqual([1, 2, 3]);
  expect(windowOf([of(1, 1), of(2, 2), of(3, 3)], 0, 0, 2)).toEqual([2, 3]);
  expect(windowOf([of(1, 1), of(3, 3)], 0, 0, 4)).toEqual([3]);
  expect(windowOf([of(1, 1), of(2, 2, 2)], 0, 0, 4)).toEqual([2]);
  expect(windowOf([], 0, 0, 4)).toEqual([]);
});

it('writes Algorithm 2 with the numbers that stood in it', () => {
  const [strength, v, w] = inference(sampleInference(), sampleRules());
  expect(strength?.numbers).toBe('1.00 · 0.50 · 1.00 · 1.00 · 1.00 · 1.00 = 0.500');
  expect(v?.numbers).toBe('0.50 · 15 + 0.50 · 13 = +14.00');
  expect(w?.numbers).toBe('0.50 · 0 + 0.50 · (−3.5) = −1.75');
  const many = { ...sampleInference(), fired: 64 };
  expect(inference(many, sampleRules())[1]?.numbers).toContain(' + 62 more = ');
  expect(inference({ ...many, firings: [] }, sampleRules())).toEqual([]);
});

it('finds the membership of an input in a set', () => {
  expect(membershipOf(sampleInference(), sampleRules(), 1, 'steer')).toBe(0.5);
  expect(membershipOf(sampleInference(), sampleRules(), 1, 'no such')).toBeNaN();
});
