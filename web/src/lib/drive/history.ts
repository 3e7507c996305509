/** How the cycles and runs of a drive grow in the page: bounded, in order, without doubles. */

import type { CycleView, DriveRunView, Session } from '../protocol';

/** Cycles kept in the page, the newest. */
export const CYCLES_KEPT = 300;

/** Runs kept in the page, the newest. */
export const RUNS_KEPT = 400;

/** Cycles with new ones added; one told twice stands once, as told last, and a reset begins anew. */
export function addCycles(cycles: CycleView[], added: CycleView[]): CycleView[] {
  const first = added[0];
  if (!first) return cycles;
  const kept = cycles.filter(({ tick }) => tick < first.tick);
  return kept.concat(added).slice(-CYCLES_KEPT);
}

/** Runs with new ones added; one told twice stands once, as told last. */
export function addRuns(runs: DriveRunView[], added: DriveRunView[]): DriveRunView[] {
  const first = added[0];
  if (!first) return runs;
  return runs
    .filter(({ round }) => round < first.round)
    .concat(added)
    .slice(-RUNS_KEPT);
}

/** Runs the session still stands by; a reset takes them back. */
export function runsOf(session: Session, runs: DriveRunView[]): DriveRunView[] {
  if (session.rounds_done >= (runs.at(-1)?.round ?? 0)) return runs;
  return runs.filter(({ round }) => round <= session.rounds_done);
}
