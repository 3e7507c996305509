import { describe, expect, it } from 'vitest';

import type { Rule } from './draft';
import {
  depth_m,
  endsWithin,
  lineOf,
  ruleThrough,
  ruleWords,
  shifted,
  turnedOver,
  wallThrough,
} from './line';
import type { Point } from './view';

describe('the line of a rule', () => {
  it.each<[Rule, number, Point]>([
    [{ axis: 'x', above: 3.75 }, 1.25, [5, 9]],
    [{ axis: 'x', below: 3.75 }, -1.25, [5, 9]],
    [{ axis: 'y', below: -1 }, 2, [7, -3]],
    // The distance of (2, 2) from x + y = 2 is the square root of 2.
    [{ a: 1, b: 1, above: 2 }, Math.SQRT2, [2, 2]],
    [{ a: 3, b: 3, below: 6 }, -Math.SQRT2, [2, 2]],
  ])('%j holds %d m deep at %j', (rule, deep, point) => {
    const line = lineOf(rule);
    expect(line && depth_m(line, point)).toBeCloseTo(deep, 12);
  });

  it.each<[Rule]>([[{}], [{ axis: 'x' }], [{ a: 0, b: 0, above: 1 }]])('%j is none', (rule) => {
    expect(lineOf(rule)).toBeNull();
  });
});

it('is drawn from edge to edge, or not at all', () => {
  const line = lineOf({ a: 1, b: -1, above: 0 });
  const ends = line && endsWithin(line, [0, 0, 4, 3]);
  expect(ends?.toSorted((p, q) => p[0] - q[0])).toEqual([
    [0, 0],
    [3, 3],
  ]);
  const far = lineOf({ axis: 'x', above: 9 });
  expect(far && endsWithin(far, [0, 0, 4, 3])).toBeNull();
});

describe('a line drawn by hand', () => {
  it.each<[Point, Point, Rule]>([
    [[0, 1], [5, 1.1], { axis: 'y', above: 1.05 }],
    [[5, 1], [0, 1], { axis: 'y', below: 1 }],
    [[2, 0], [2.02, 4], { axis: 'x', below: 2.01 }],
    [[2, 4], [2, 0], { axis: 'x', above: 2 }],
  ])('from %j to %j is along an axis', (from, to, rule) => {
    expect(ruleThrough(from, to)).toEqual(rule);
  });

  it('at an angle passes through both ends and holds to its left', () => {
    const rule = ruleThrough([0, 0], [4, 2]);
    const line = rule && lineOf(rule);
    expect(line && depth_m(line, [0, 0])).toBeCloseTo(0, 2);
    expect(line && depth_m(line, [4, 2])).toBeCloseTo(0, 2);
    expect(line && depth_m(line, [0, 1])).toBeGreaterThan(0);
  });

  it('needs two places', () => {
    expect(ruleThrough([1, 1], [1, 1])).toBeNull();
  });
});

it('turns over: what held no longer does', () => {
  for (const rule of [{ axis: 'y', above: 2 } as Rule, { a: 1, b: 2, below: -3 }]) {
    const [one, other] = [lineOf(rule), lineOf(turnedOver(rule))];
    expect(one && depth_m(one, [4, 1])).toBeCloseTo(-(other ? depth_m(other, [4, 1]) : 0), 12);
    expect(turnedOver(turnedOver(rule))).toEqual(rule);
  }
});

it('moves across itself only', () => {
  expect(shifted({ axis: 'x', above: 1 }, [0.5, 9])).toEqual({ axis: 'x', above: 1.5 });
  expect(shifted({ a: 1, b: 1, below: 2 }, [0.5, -0.5])).toEqual({ a: 1, b: 1, below: 2 });
});

it('is said in words', () => {
  expect(ruleWords({ axis: 'x', above: 3.75 })).toBe('x > 3.75 m');
  expect(ruleWords({ a: 1, b: -0.5, below: -2 })).toBe('1·x − 0.5·y < −2 m');
  expect(ruleWords({ axis: 'y' })).toBe('no bound yet');
});

it('makes walls to the centimetre, along an axis when near one', () => {
  expect(wallThrough([1.004, 2], [4, 2.1])).toEqual([
    [1, 2],
    [4, 2],
  ]);
  expect(wallThrough([1, 2], [1.05, -3])).toEqual([
    [1, 2],
    [1, -3],
  ]);
  expect(wallThrough([0, 0], [2, 1])).toEqual([
    [0, 0],
    [2, 1],
  ]);
  expect(wallThrough([1, 1], [1.001, 1])).toBeNull();
});
