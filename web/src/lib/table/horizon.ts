/** The plots of figure 3.3, and the policies of figure 3.2 as chains. */

import { brief } from '../format';
import type { CrossingView, PointView, PolicyView } from '../protocol';

/** One plot. */
export interface Plot {
  model: string;
  title: string;
  /** h or γ. */
  parameter: string;
  source: string;
  /** Parameter, then J of each policy. */
  columns: number[][];
  crossings: CrossingView[];
}

const PLOTS = [
  {
    model: 'finite-horizon',
    title: 'Finite horizon',
    parameter: 'h',
    source: '3.1',
  },
  { model: 'discounted', title: 'Discounted sum', parameter: 'γ', source: '3.3' },
];

/** Both plots, from the points so far. */
export function plots(points: PointView[], policies: number): Plot[] {
  return PLOTS.map((plot) => {
    const own = points.filter(({ model }) => model === plot.model);
    return {
      ...plot,
      columns: [
        own.map(({ parameter }) => parameter),
        ...Array.from({ length: policies }, (_, which) =>
          own.map(({ values }) => values[which] ?? NaN),
        ),
      ],
      crossings: own.flatMap(({ crossing }) => (crossing ? [crossing] : [])),
    };
  });
}

/** Average reward of each policy; none before that point was reached. */
export function averages(points: PointView[]): PointView | null {
  return points.find(({ model }) => model === 'average') ?? null;
}

/** A place on an axis, as short as three decimals can say it. */
export const place = (at: number): string => String(Number(at.toFixed(3)));

/** A crossing in a sentence. */
export function crossingWords(
  { at, from, to }: CrossingView,
  parameter: string,
  names: string[],
): string {
  return `${parameter} = ${place(at)}: ${names[from] ?? from} before, ${names[to] ?? to} after`;
}

/** Rewards of the first steps as a chain shows them; the last goes on for ever. */
export function chain({ lead, then }: PolicyView): string[] {
  return [...lead.map(brief), `${brief(then)} …`];
}
