/** The path of the present run, thinned so that a long run needs no more room than a short one. */

import type { CycleView } from '../protocol';

/** A place on the path, metres. */
export interface Spot {
  x_m: number;
  y_m: number;
  /** Cycle of the run, from 1. */
  cycle: number;
  /** Nothing is known of the way from the place before. */
  isGap: boolean;
}

/** Where a contact began, metres. */
export interface BumpSpot {
  x_m: number;
  y_m: number;
  what: string;
}

/** The path of a run as far as the page has seen it. */
export interface Trail {
  round: number;
  spots: Spot[];
  bumps: BumpSpot[];
  /** Only every so many cycles there is a spot. */
  stride: number;
  /** Last cycle taken in. */
  last: number;
}

/** Most spots of a path, and most contacts. */
export const MOST_SPOTS = 1600;
const MOST_BUMPS = 200;

/** The path with cycles added; another run, or one that began again, begins another path. */
export function extended(trail: Trail | null, cycles: CycleView[]): Trail | null {
  return cycles.reduce(step, trail && { ...trail, spots: [...trail.spots] });
}

/** The path after the history was told again: what was seen before goes on where the history does. */
export function rejoined(trail: Trail | null, cycles: CycleView[]): Trail | null {
  const newest = cycles.at(-1);
  if (!trail || newest?.round !== trail.round || newest.cycle < trail.last)
    return extended(null, cycles);
  const { round, last } = trail;
  return extended(
    trail,
    cycles.filter((cycle) => cycle.round === round && cycle.cycle > last),
  );
}

/** First cycle of the run that the path shows; above 1 for a page that came late. */
export const firstCycle = ({ spots }: Trail): number => spots[0]?.cycle ?? 1;

function step(trail: Trail | null, cycle: CycleView): Trail {
  const begins = !trail || trail.round !== cycle.round || cycle.cycle <= trail.last;
  const present: Trail = begins
    ? { round: cycle.round, spots: [], bumps: [], stride: 1, last: cycle.cycle - 1 }
    : trail;
  const { x_m, y_m } = cycle.pose;
  const isGap = cycle.cycle > present.last + 1;
  present.last = cycle.cycle;
  if (cycle.bump) {
    const bump = { x_m, y_m, what: cycle.bump.what };
    present.bumps = [...present.bumps, bump].slice(-MOST_BUMPS);
  }
  if (isGap || present.spots.length === 0 || cycle.cycle % present.stride === 0)
    present.spots.push({ x_m, y_m, cycle: cycle.cycle, isGap });
  if (present.spots.length > MOST_SPOTS) thin(present);
  return present;
}

/** Leaves out every other spot, but neither the first nor one after a gap. */
function thin(trail: Trail): void {
  trail.stride *= 2;
  trail.spots = trail.spots.filter(
    ({ cycle, isGap }, index) => index === 0 || isGap || cycle % trail.stride === 0,
  );
  // A path that is nothing but gaps loses its older half.
  if (trail.spots.length > MOST_SPOTS) trail.spots = trail.spots.slice(-MOST_SPOTS / 2);
}
