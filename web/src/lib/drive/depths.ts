/** The depths of a region by every method: which are shown, how they look, and how far they are off. */

import type { CourseView, CycleView } from '../protocol';

/** A line of a region: a method's depth, or the truth. */
export interface Look {
  /** A method, or `truth`. */
  name: string;
  /** Custom property of the theme that holds its colour. */
  colour: string;
  dash: number[];
  width: number;
}

/** The truth as a line. */
export const TRUTH: Look = { name: 'truth', colour: 'text', dash: [1.5, 3], width: 2 };

const LOOKS: Record<string, Omit<Look, 'name'>> = {
  minimum: { colour: 'series-2', dash: [5, 2], width: 1.75 },
  'minimum-kalman': { colour: 'series-6', dash: [8, 3, 2, 3], width: 1.75 },
  median: { colour: 'series-3', dash: [2, 2], width: 1.5 },
  'median-kalman': { colour: 'series-1', dash: [], width: 2.25 },
  'median-walk': { colour: 'series-4', dash: [10, 3], width: 1.75 },
};

/** How a method's depth is drawn. */
export const lookOf = (method: string): Look => ({
  name: method,
  ...(LOOKS[method] ?? { colour: 'series-8', dash: [], width: 1.5 }),
});

/** Methods that are shown at first: the thesis's and the one it is set against. */
export const SHOWN = ['minimum', 'median', 'median-kalman'];

/** Place of a method among a region's depths; -1 where the course lacks it. */
export const placeOf = (course: CourseView, method: string): number =>
  course.methods.findIndex(({ name }) => name === method);

/** σ of a method's estimate, metres; none for one that has none. */
export function sigmaOf(cycle: CycleView, region: number, method: string): number | null {
  const found = cycle.regions[region];
  if (method === 'median-kalman' || method === 'minimum-kalman') return found?.sigma_m ?? null;
  return method === 'median-walk' ? (found?.walk_sigma_m ?? null) : null;
}

/** Methods in the course's order, those asked for and the one that drives. */
export function shownMethods(course: CourseView, asked: string[], drives: string): string[] {
  return course.methods
    .map(({ name }) => name)
    .filter((name) => asked.includes(name) || name === drives);
}
