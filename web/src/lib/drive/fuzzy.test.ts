import { describe, expect, it } from 'vitest';

import { drawnRange, matches, membership, namesOf, outline, placeIn, rank } from './fuzzy';
import { sampleRules } from './sample';

const rules = sampleRules();
const left = rules.inputs[1]!;
const [safe, steer, dangerous] = left.sets;

describe('membership', () => {
  it('rises and falls in lines, and is 1 between', () => {
    const at = (value: number) => membership(steer!.corners, value);
    expect([0.1, 0.2, 0.25, 0.3, 0.4, 0.55, 0.775, 1, 1.5].map(at)).toEqual(
      [0, 0, 0.5, 1, 1, 1, 0.5, 0, 0].map((value) => expect.closeTo(value, 12)),
    );
  });

  it('is 1 at an upright side', () => {
    expect([membership(dangerous!.corners, 0), membership(safe!.corners, 2)]).toEqual([1, 1]);
  });

  it('adds up to 1 over the sets everywhere', () => {
    for (const { range, sets } of rules.inputs)
      for (let step = 0; step <= 100; step += 1) {
        const value = range[0] + (step / 100) * (range[1] - range[0]);
        const sum = sets.reduce((sum, { corners }) => sum + membership(corners, value), 0);
        expect(sum).toBeCloseTo(1, 12);
      }
  });
});

it('draws only the sides of a set that lie within the range', () => {
  expect(outline(safe!, left.range, [0, 2]).map(([at]) => at)).toEqual([0.275, 0.5, 1]);
  expect(outline(dangerous!, left.range, [0, 2]).map(([, height]) => height)).toEqual([1, 1, 0]);
  expect(outline(steer!, left.range, [0, 2])).toHaveLength(4);
});

it('draws the part of the range where memberships change', () => {
  for (const variable of rules.inputs) {
    const [least, most] = drawnRange(variable);
    expect(least).toBeGreaterThanOrEqual(variable.range[0]);
    expect(most).toBeLessThanOrEqual(variable.range[1]);
    // Beyond it every membership is what it is at its end.
    for (const { corners } of variable.sets) {
      expect(membership(corners, least)).toBe(membership(corners, variable.range[0]));
      expect(membership(corners, most)).toBe(membership(corners, variable.range[1]));
    }
  }
  expect(drawnRange({ name: 'v', unit: '', range: [-10, 15], sets: [] })).toEqual([-10, 15]);
});

it('places values in a range, and what lies outside at its end', () => {
  expect([placeIn([-10, 15], 2.5), placeIn([0, 2], 3), placeIn([0, 2], -1)]).toEqual([0.5, 1, 0]);
});

it('tells how much of a threat a set is', () => {
  expect(['safe', 'steer', 'dangerous', 'no such'].map((set) => rank(left, set))).toEqual([
    0, 0.5, 1, 0,
  ]);
});

it('looks rules through by their sets', () => {
  const rule = { rule: 0, when: ['safe', 'steer', 'fast'], then: [1], because: '' };
  expect(matches(rule, [])).toBe(true);
  expect(matches(rule, ['', 'steer', ''])).toBe(true);
  expect(matches(rule, ['safe', 'dangerous', ''])).toBe(false);
});

it('names variables for people', () => {
  expect(namesOf(rules)).toEqual({
    inputs: ['far left', 'left', 'centre', 'right', 'far right', 'velocity'],
    outputs: ['velocity', 'turn'],
  });
});
