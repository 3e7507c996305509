/** Whether a filter's errors are as great as it says: NIS and NEES against their χ² bounds. */

import { number } from '../format';
import type { CycleView } from '../protocol';

/** Which of the two. */
export type Square = 'nis' | 'nees';

/** How single values stand to their bounds. */
export interface Share {
  n: number;
  /** Share within the bounds, 0 to 1. */
  within: number;
  mean: number;
}

/** The values of a cycle: of one region, or of all. */
export function squares(cycle: CycleView, square: Square, region: number | null): number[] {
  return cycle.regions.flatMap((each, index) => {
    const value = each[square];
    return (region === null || region === index) && value !== null ? [value] : [];
  });
}

/** The share of values within their bounds; none without values. */
export function share(values: number[], [low, high]: [number, number]): Share | null {
  if (values.length === 0) return null;
  const within = values.filter((value) => value >= low && value <= high).length;
  const sum = values.reduce((sum, value) => sum + value, 0);
  return { n: values.length, within: within / values.length, mean: sum / values.length };
}

/** A share in words. */
export function shareWords(found: Share | null): string {
  if (!found) return 'no value yet';
  return `${number(100 * found.within, 0)} % of ${found.n} within, mean ${number(found.mean)}`;
}

/** What mean and share say of the filter: 1 and 95 % are consistent. */
export function verdict(found: Share | null): string {
  if (!found || found.n < 20) return '';
  if (found.mean < 0.5) return 'more careful than it need be: σ is larger than its errors';
  if (found.mean > 2) return 'too sure of itself: its errors are larger than σ';
  return found.within < 0.9
    ? 'about as sure as it should be on average, but its errors are not normal: too many lie outside'
    : 'about as sure as it should be';
}
