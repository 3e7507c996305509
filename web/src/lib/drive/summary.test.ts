import { expect, it } from 'vitest';

import type { DriveScores, MeasureView } from '../protocol';
import { sampleRun, sampleScore } from './sample';
import { columnsOf, decimalsOf, isDrive, measureRows, measureWords, touched } from './summary';

const cell = (kind: string, name: string, changes = {}) =>
  columnsOf(kind)
    .find((column) => column.name === name)
    ?.said(sampleScore(changes));

it('shows in each course what matters there', () => {
  expect(cell('corridor', 'End')).toBe('reached');
  expect(cell('corridor', 'End', { done: false })).toBe('not reached');
  expect(cell('corridor', 'End', { done: false, blind: 1 })).toBe('region II silent');
  expect(cell('corridor', 'Forward')).toBe('14.51');
  expect(cell('corridor', 'Doors')).toBe('2/3');
  expect(cell('corridor', 'Contacts')).toBe('0, 1, 2');
  expect(cell('corridor', 'NIS', { nis: null })).toBe('–');
  expect(cell('block-world', 'Doors')).toBeUndefined();
  expect(cell('block-world', 'Contacts', { block_contacts: 4 })).toBe('0, 4');
  expect(cell('block-world', 'Velocity')).toBe('14.6');
});

it('knows a driven run', () => {
  expect(isDrive(sampleRun(1).outcome)).toBe(true);
  expect(isDrive({ kind: 'approach', true_variation_m: 1, haunted_pct: 0, scores: [] })).toBe(
    false,
  );
  expect(touched(sampleRun(1))).toEqual([]);
});

const measure = (name: string, mean: number, half: number | null): MeasureView => ({
  name,
  unit: 'm',
  mean,
  interval: half === null ? null : { value: mean, low: mean - half, high: mean + half },
});

it('writes a mean with its interval to about three digits', () => {
  expect(measureWords(measure('', 14.512, 0.25))).toBe('14.5 [14.3, 14.8]');
  expect(measureWords(measure('', 0.0954, 0.003))).toBe('0.095 [0.092, 0.098]');
  expect(measureWords(measure('', -3.5, 1))).toBe('−3.50 [−4.50, −2.50]');
  expect(measureWords(measure('', 96.3, null))).toBe('96.3');
  expect([decimalsOf([0]), decimalsOf([1234]), decimalsOf([0.0001])]).toEqual([0, 0, 3]);
});

it('lays methods side by side on one scale, also where one has no runs yet', () => {
  const scores: DriveScores = {
    runs_done: 2,
    methods: [
      { method: 'minimum', n: 0, done: 0, measures: [] },
      {
        method: 'median-kalman',
        n: 2,
        done: 2,
        measures: [measure('Way', 90, 6), measure('Drift', -2, 1)],
      },
    ],
  };
  const [way, drift] = measureRows(scores);
  expect(way?.cells.map((each) => each?.mean)).toEqual([undefined, 90]);
  expect(way?.scale[0]).toBe(0);
  expect(way?.scale[1]).toBeGreaterThan(96);
  expect(drift?.scale[0]).toBe(-3);
  expect(measureRows({ runs_done: 0, methods: [] })).toEqual([]);
});
