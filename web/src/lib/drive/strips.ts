/** Values against time: the newest cycles as lines that break where something is missing. */

import type { CycleView } from '../protocol';

/** Cycles on a strip. */
export const STRIP = 120;

/** A point of a line: place among the strip's cycles, counted back from the newest at 0, and value. */
export interface StripPoint {
  back: number;
  value: number;
}

/** The cycles of a strip: those at most `STRIP` ticks back from the newest. */
export function latest(cycles: CycleView[]): CycleView[] {
  const newest = cycles.at(-1)?.tick ?? 0;
  return cycles.filter(({ tick }) => tick > newest - STRIP);
}

/** A value over the cycles as lines; one ends at a value that is missing, a missed cycle and a run's end. */
export function lines(
  cycles: CycleView[],
  read: (cycle: CycleView) => number | null | undefined,
): StripPoint[][] {
  const newest = cycles.at(-1)?.tick ?? 0;
  const found: StripPoint[][] = [];
  let before: CycleView | null = null;
  for (const cycle of cycles) {
    const value = read(cycle);
    const isKnown = value !== null && value !== undefined && Number.isFinite(value);
    if (isKnown) {
      const point = { back: newest - cycle.tick, value };
      const open = before && before.tick + 1 === cycle.tick && before.round === cycle.round;
      if (open) found.at(-1)?.push(point);
      else found.push([point]);
    }
    before = isKnown ? cycle : null;
  }
  return found;
}

/** Where runs begin on a strip, counted back from the newest. */
export function beginnings(cycles: CycleView[]): { back: number; run: number; method: string }[] {
  const newest = cycles.at(-1)?.tick ?? 0;
  return cycles
    .filter(({ round }, index) => index > 0 && cycles[index - 1]?.round !== round)
    .map(({ tick, run, method }) => ({ back: newest - tick, run, method }));
}

/** Place on a strip, 0 at its oldest end to 1 at the newest. */
export const along = (back: number): number => 1 - back / (STRIP - 1);

/** Place of a value on a logarithmic scale, 0 to 1; what lies outside stands at its end. */
export function logPlace(value: number, least: number, most: number): number {
  if (!(value > least)) return 0;
  return Math.min(1, Math.log(value / least) / Math.log(most / least));
}
