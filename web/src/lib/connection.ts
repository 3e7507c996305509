/** The life of a connection as a state machine: pure, so that its waits can be tested. */

/** Where a connection stands. Times are milliseconds of one clock. */
export type Link =
  | { phase: 'connecting'; attempt: number }
  | { phase: 'open' }
  | { phase: 'waiting'; attempt: number; until: number }
  | { phase: 'closed' };

/** What can happen to it. */
export type LinkEvent =
  | { kind: 'greeted' }
  | { kind: 'lost'; now: number; chance: number }
  | { kind: 'due' }
  | { kind: 'closed' };

/** A connection that is being made for the first time. */
export const FIRST: Link = { phase: 'connecting', attempt: 0 };

const SHORTEST_WAIT_MS = 500;
const LONGEST_WAIT_MS = 15_000;

/** The state after an event; an event that does not fit changes nothing. */
export function advance(link: Link, event: LinkEvent): Link {
  if (link.phase === 'closed') return link;
  switch (event.kind) {
    case 'greeted':
      return link.phase === 'connecting' ? { phase: 'open' } : link;
    case 'lost':
      return lost(link, event.now, event.chance);
    case 'due':
      return link.phase === 'waiting' ? { phase: 'connecting', attempt: link.attempt } : link;
    case 'closed':
      return { phase: 'closed' };
  }
}

/** Wait before an attempt: doubled each time, bounded, and spread by `chance` in [0, 1). */
export function waitMs(attempt: number, chance: number): number {
  const doubled = Math.min(SHORTEST_WAIT_MS * 2 ** (attempt - 1), LONGEST_WAIT_MS);
  return doubled * (0.75 + chance / 2);
}

/** Whole seconds until the next attempt, at least 1. */
export function secondsLeft(link: Link, now: number): number {
  return link.phase === 'waiting' ? Math.max(1, Math.ceil((link.until - now) / 1000)) : 0;
}

function lost(link: Link, now: number, chance: number): Link {
  if (link.phase === 'waiting') return link;
  const attempt = link.phase === 'connecting' ? link.attempt + 1 : 1;
  return { phase: 'waiting', attempt, until: now + waitMs(attempt, chance) };
}
