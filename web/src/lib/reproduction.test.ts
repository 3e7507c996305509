import { expect, test } from 'vitest';
import {
  armOf,
  byArm,
  decimalsFor,
  differences,
  mean,
  plainReading,
  quantityOf,
  spoken,
  tally,
} from './reproduction';
import type {
  ExperimentInfo,
  ReproductionCurve,
  ReproductionPoint,
  ReproductionRow,
  SettingInfo,
} from './protocol';

function row(name: string, change: Partial<ReproductionRow> = {}): ReproductionRow {
  return {
    name,
    published: null,
    required: null,
    ours: 1,
    low: 0,
    high: 2,
    n: 200,
    unit: '',
    verdict: 'cannot tell',
    reading: 'Preset default, seeds 1..2: a reading: with a colon',
    ...change,
  };
}

function point(x: number, change: Partial<ReproductionPoint> = {}): ReproductionPoint {
  return { x, mean: null, low: null, high: null, least: null, greatest: null, n: 0, ...change };
}

test('rows stand with their arm, in the order they came', () => {
  const groups = byArm([row('b: steps'), row('a: steps'), row('b: R: best')]);
  expect(groups.map((group) => [group.arm, group.rows.length])).toEqual([
    ['b', 2],
    ['a', 1],
  ]);
  expect(armOf('steps')).toBe('');
  expect(quantityOf('b: R: best')).toBe('R: best');
  expect(quantityOf('steps')).toBe('steps');
});

test('a reading loses what stands above the table and nothing else', () => {
  expect(plainReading(row('a').reading)).toBe('a reading: with a colon');
  expect(plainReading('of the whole: nothing')).toBe('of the whole: nothing');
  // What a bias was read as does not stand above the table.
  const bias = 'B2, {right right} left out, seeds 1..2: Eq. (4.13)';
  expect(plainReading(bias)).toBe(bias);
});

test('verdicts are counted', () => {
  const rows = [row('a', { verdict: 'agrees' }), row('b', { verdict: 'differs' }), row('c')];
  expect(tally(rows)).toEqual({ agrees: 1, differs: 1, 'cannot tell': 1 });
});

test('decimals follow the width of the interval', () => {
  expect(decimalsFor(27.4, 27.9)).toBe(2);
  expect(decimalsFor(0, 60)).toBe(1);
  expect(decimalsFor(1.0012, 1.0049)).toBe(3);
  expect(decimalsFor(0, 0)).toBe(2);
});

test('a curve is said with its intervals, and gaps are left out', () => {
  const curve: ReproductionCurve = {
    arm: 'default',
    quantity: 'number of steps',
    unit: '',
    x_name: 'trial',
    band: '',
    bars: '',
    points: [
      point(1),
      point(2, { mean: 39.5, low: 39.25, high: 39.75 }),
      point(3, { mean: 27.5, low: 27.25, high: 27.75 }),
    ],
  };
  expect(spoken(curve)).toBe(
    'default: from 39.50 [39.25, 39.75] at trial 2 to 27.50 [27.25, 27.75] at trial 3',
  );
  expect(spoken({ ...curve, points: [point(1)] })).toBe('default: no value');
  expect(mean(point(1, { mean: 3 }))).toBe('3.00');
});

test('differences are what is not printed in the thesis, with the value of the arm', () => {
  const setting = (key: string, standing: string, value: number): SettingInfo => ({
    key,
    meaning: '',
    kind: 'number',
    unit: '',
    default: value,
    min: null,
    max: null,
    choices: [],
    source: '',
    standing,
  });
  const experiment = {
    presets: [
      { name: 'default', title: '', summary: '', settings: {} },
      { name: 'thesis', title: '', summary: '', settings: { scale: 1 } },
    ],
    settings: [
      setting('rate', 'literal', 0.5),
      setting('noise', 'simulation', 0.01),
      setting('frame', 'reading', 2),
      setting('scale', 'deviation', 0.05),
    ],
  } as unknown as ExperimentInfo;
  const of = (settings: Record<string, string | number>) =>
    differences(experiment, { name: '', settings }).map(({ info, value }) => [info.key, value]);
  expect(of({ preset: 'thesis' })).toEqual([
    ['scale', 1],
    ['frame', 2],
  ]);
  expect(of({ rate: 0.1 })).toEqual([
    ['scale', 0.05],
    ['rate', 0.1],
    ['frame', 2],
  ]);
});
