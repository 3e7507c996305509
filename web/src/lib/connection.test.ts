import { describe, expect, it } from 'vitest';

import { advance, FIRST, secondsLeft, waitMs, type Link, type LinkEvent } from './connection';

const LOST: LinkEvent = { kind: 'lost', now: 1000, chance: 0.5 };
const after = (...events: LinkEvent[]) => events.reduce(advance, FIRST as Link);

describe('a connection', () => {
  it('is open once it was greeted', () => {
    expect(after({ kind: 'greeted' })).toEqual({ phase: 'open' });
  });

  it('waits after a loss and then tries again', () => {
    expect(after({ kind: 'greeted' }, LOST)).toEqual({ phase: 'waiting', attempt: 1, until: 1500 });
    expect(after({ kind: 'greeted' }, LOST, { kind: 'due' })).toEqual({
      phase: 'connecting',
      attempt: 1,
    });
  });

  it('waits longer after each failed attempt, and from the start after a success', () => {
    const again: LinkEvent[] = [LOST, { kind: 'due' }, LOST, { kind: 'due' }, LOST];
    expect(after(...again)).toMatchObject({ attempt: 3, until: 3000 });
    expect(after(...again, { kind: 'due' }, { kind: 'greeted' }, LOST)).toMatchObject({
      attempt: 1,
    });
  });

  it('takes only the first of two losses', () => {
    expect(after(LOST, { ...LOST, now: 9000 })).toMatchObject({ attempt: 1, until: 1500 });
  });

  it('stays closed', () => {
    expect(after({ kind: 'closed' }, { kind: 'greeted' }, LOST)).toEqual({ phase: 'closed' });
  });

  it('never waits longer than 15 s, give or take a quarter', () => {
    expect([1, 2, 3, 4, 5, 6, 20].map((attempt) => waitMs(attempt, 0.5))).toEqual([
      500, 1000, 2000, 4000, 8000, 15_000, 15_000,
    ]);
    expect([waitMs(1, 0), waitMs(1, 1)]).toEqual([375, 625]);
  });

  it('counts whole seconds down to 1', () => {
    const link: Link = { phase: 'waiting', attempt: 1, until: 5000 };
    expect([1000, 2500, 4990, 6000].map((now) => secondsLeft(link, now))).toEqual([4, 3, 1, 1]);
  });
});
