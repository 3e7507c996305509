import { expect, it } from 'vitest';

import { ceiling, chosen, columns, gainWords, interval, isRegret, spoken } from './curves';
import { sampleCurve, sampleScores } from './sample';

it('puts curves of unlike points on one axis', () => {
  const short = { ...sampleCurve('B0', 1, [5, 3]), at: [2, 4] };
  const long = sampleCurve('B10', 2, [9, 8, 7]);
  expect(columns([short, long])).toEqual([
    [1, 2, 3, 4],
    [null, 5, null, 3],
    [null, null, null, null],
    [null, null, null, null],
    [9, 8, 7, null],
    [8, 7, 6, null],
    [10, 9, 8, null],
  ]);
});

it('keeps the colour of a curve whatever else is hidden', () => {
  const curves = ['B0', 'B10', 'B11'].map((name) => sampleCurve(name, 3, [1]));
  const shown = chosen(curves, ['B0']).map(({ curve, mark }) => [curve.name, mark]);
  expect(shown).toEqual([
    ['B10', 1],
    ['B11', 2],
  ]);
  expect(chosen([sampleCurve('B0', 0, [])], [])).toEqual([]);
});

it('ends the axis where bands do, unless they are far above all means', () => {
  expect(ceiling([10, null, 4], [12, null])).toBe(12);
  expect(ceiling([10, 4], [])).toBe(10);
  expect(ceiling([10, 4], [900])).toBe(20);
});

it('says where a curve begins and ends', () => {
  expect(spoken(sampleCurve('B0', 10, [60, 40, 20]), 'trial')).toBe(
    'B0: from 60.0 in trial 1 to 20.0 in trial 3, n = 10',
  );
});

it('says intervals, and gains as far as they are known', () => {
  const { scores } = sampleScores();
  expect(interval(scores[0]!.index)).toBe('27.0 [25.0, 29.0]');
  expect(scores.map(gainWords)).toEqual(['reference', '21.5']);
  expect(gainWords({ ...scores[1]!, gain: { value: 21, low: 19, high: 23 } })).toBe(
    '21.0 [19.0, 23.0]',
  );
  expect(gainWords({ ...scores[1]!, gain_pct: null })).toBe('–');
});

it('knows regret from actions', () => {
  expect([isRegret(sampleScores()), isRegret(sampleScores({ over: 'pull' }))]).toEqual([
    false,
    true,
  ]);
});
