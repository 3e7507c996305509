/** Bell curves for drawing. */

import type { GaussianView } from './protocol';

/** Width and height of the drawing, in the units of its view box. */
export const SIZE = { width: 640, height: 240, foot: 206, head: 14 };

/** Density of a normal distribution. */
export function density({ mean, sigma }: GaussianView, at: number): number {
  const z = (at - mean) / sigma;
  return Math.exp(-0.5 * z * z) / (sigma * Math.sqrt(2 * Math.PI));
}

/** Least and greatest position to draw: three standard deviations around all of them. */
export function span(all: GaussianView[]): [number, number] {
  const low = Math.min(...all.map(({ mean, sigma }) => mean - 3 * sigma));
  const high = Math.max(...all.map(({ mean, sigma }) => mean + 3 * sigma));
  return [low, high];
}

/** Place of a position along the drawing. */
export const place = ([low, high]: [number, number], at: number) =>
  ((at - low) / (high - low)) * SIZE.width;

/** A curve as the points of a polyline; `most` is the density at the head of the drawing. */
export function curve(
  of: GaussianView,
  range: [number, number],
  most: number,
  points = 240,
): string {
  const [low, high] = range;
  const at = (k: number) => low + ((high - low) * k) / (points - 1);
  const y = (x: number) => SIZE.foot - (density(of, x) / most) * (SIZE.foot - SIZE.head);
  return Array.from({ length: points }, (_, k) => at(k))
    .map((x) => `${place(range, x).toFixed(2)},${y(x).toFixed(2)}`)
    .join(' ');
}
