/** Learning curves of competitors as columns of one chart, and in words. */

import { brief, number } from '../format';
import type { CompetitorCurve, IntervalView, ScoresView, ScoreView } from '../protocol';

/** How many lines can be told apart by colour and dash; more begin again. */
export const MARKS = 8;

/** Dashes of the lines, so that colour is not the only thing that tells them apart. */
export const DASHES: number[][] = [
  [],
  [8, 4],
  [2, 3],
  [10, 3, 2, 3],
  [5, 2],
  [12, 5],
  [2, 6],
  [7, 3, 2, 3, 2, 3],
];

/** Columns for a chart: x, then mean, low and high of each curve; `null` where a curve has no point. */
export function columns(curves: CompetitorCurve[]): (number | null)[][] {
  const x = [...new Set(curves.flatMap((curve) => curve.at))].sort((a, b) => a - b);
  const places = new Map(x.map((at, index) => [at, index]));
  const spread = (curve: CompetitorCurve, values: number[]) => {
    const column: (number | null)[] = x.map(() => null);
    values.forEach((value, index) => {
      const place = places.get(curve.at[index] ?? NaN);
      if (place !== undefined) column[place] = value;
    });
    return column;
  };
  return [
    x,
    ...curves.flatMap((curve) => [
      spread(curve, curve.mean),
      spread(curve, curve.low),
      spread(curve, curve.high),
    ]),
  ];
}

/** The curves that are shown, each with its place among all, which gives its colour. */
export function chosen(
  curves: CompetitorCurve[],
  hidden: string[],
): { curve: CompetitorCurve; mark: number }[] {
  return curves
    .map((curve, index) => ({ curve, mark: index % MARKS }))
    .filter(({ curve }) => curve.n > 0 && !hidden.includes(curve.name));
}

/**
 * Where the y axis ends: at the greatest mean or end of a band, but at most at twice the greatest mean. The band
 * of two episodes may be many times as wide as all there is to see.
 */
export function ceiling(means: (number | null)[], highs: (number | null)[]): number {
  const most = (values: (number | null)[]) =>
    values.reduce<number>((most, value) => Math.max(most, value ?? -Infinity), -Infinity);
  const mean = most(means);
  return mean > 0 ? Math.min(Math.max(mean, most(highs)), 2 * mean) : Math.max(mean, most(highs));
}

/** A curve in a few words. */
export function spoken(curve: CompetitorCurve, over: string): string {
  const [first, last] = [curve.mean[0], curve.mean.at(-1)];
  if (first === undefined || last === undefined) return `${curve.name}: no point yet`;
  const ends = `from ${number(first, 1)} in ${over} ${brief(curve.at[0] ?? 0)} to ${number(last, 1)} in ${over} ${brief(curve.at.at(-1) ?? 0)}`;
  return `${curve.name}: ${ends}, n = ${curve.n}`;
}

/** "21.6 [18.2, 25.0]", or the estimate alone. */
export function interval(found: IntervalView | null, decimals = 1): string {
  if (!found) return '–';
  return `${number(found.value, decimals)} [${number(found.low, decimals)}, ${number(found.high, decimals)}]`;
}

/** The gain of a competitor in words of the table. */
export function gainWords({ reference, gain, gain_pct }: ScoreView): string {
  if (!reference) return 'reference';
  if (gain) return interval(gain);
  return gain_pct === null ? '–' : number(gain_pct, 1);
}

/** Whether the competitors are strategies at levers, whose measure is regret. */
export const isRegret = ({ over }: ScoresView): boolean => over === 'pull';
