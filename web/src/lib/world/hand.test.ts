import { beforeEach, describe, expect, it } from 'vitest';

import type { Draft } from './draft';
import type { Tool } from './editor.svelte';
import type { Chosen } from './grips';
import { Hand } from './hand';
import { begun, edited, settled, undone, type Trail } from './trail';
import type { Point, View } from './view';

const draft: Draft = {
  name: '',
  title: '',
  summary: '',
  source: '',
  walls: [],
  blocks: [],
  floor: [],
  regions: [
    { name: 'east', rules: [{ axis: 'x', above: 2 }] },
    { name: 'else', rules: [] },
  ],
  home: { x: 0, y: 0, heading_deg: 0 },
  goal: { x: 4, y: 0, radius_m: 0.5 },
};
const size = { width: 800, height: 400 };

let trail: Trail<Draft>;
let view: View;
let tool: Tool;
let chosen: Chosen | null;
let line: [Point, Point] | null;
let added: [Point, Point] | null;
let hand: Hand;

beforeEach(() => {
  trail = begun(draft);
  // One metre is 100 pixels; home lies at (200, 200), the goal at (600, 200).
  view = { x_m: 2, y_m: 0, scale: 100 };
  tool = 'move';
  chosen = line = added = null;
  hand = new Hand({
    plan: () => ({
      draft: trail.present,
      view,
      size,
      robotRadius_m: 0.265,
      region: 0,
      chosen: null,
    }),
    tool: () => tool,
    edit: (next, key) => (trail = edited(trail, next, key)),
    settle: () => (trail = settled(trail)),
    look: (next) => (view = next),
    choose: (next) => (chosen = next),
    stroke: (next) => (line = next),
    add: (from, to) => (added = [from, to]),
  });
});

function drag(...way: Point[]) {
  const [first, last] = [way[0], way.at(-1)];
  if (!first || !last) return;
  hand.down(1, first);
  for (const at of way.slice(1)) hand.move(1, at);
  hand.up(1, last);
}

describe('one finger', () => {
  it('drags home as one step, chosen afterwards', () => {
    drag([205, 200], [255, 180], [305, 150]);
    expect(trail.present.home).toMatchObject({ x: 1, y: 0.5 });
    expect(chosen).toEqual({ kind: 'home' });
    expect(undone(trail).present).toBe(draft);
  });

  it('moves the view on empty ground, and chooses nothing when it rests', () => {
    drag([300, 50], [350, 80]);
    expect(view).toMatchObject({ x_m: 1.5, y_m: 0.3 });
    chosen = { kind: 'home' };
    drag([300, 50]);
    expect(chosen).toBeNull();
    expect(trail.present).toBe(draft);
  });

  it('does not move what is only pressed', () => {
    drag([205, 200], [206, 201]);
    expect(trail.present).toBe(draft);
    expect(chosen).toEqual({ kind: 'home' });
  });

  it('places home and goal with their tools, even on each other’s place', () => {
    tool = 'home';
    drag([600, 200]);
    expect(trail.present.home).toMatchObject({ x: 4, y: 0 });
    tool = 'goal';
    drag([100, 300], [100, 350]);
    expect(trail.present.goal).toMatchObject({ x: -1, y: -1.5 });
    expect(undone(undone(trail)).present).toBe(draft);
  });

  it('places home within its own body, but turns it at its handle', () => {
    tool = 'home';
    drag([210, 190]);
    expect(trail.present.home).toMatchObject({ x: 0.1, y: 0.1 });
    drag([254, 190], [210, 100]);
    expect(trail.present.home).toEqual({ x: 0.1, y: 0.1, heading_deg: 90 });
  });

  it('draws a line over anything with its tool', () => {
    tool = 'line';
    hand.down(1, [200, 200]);
    hand.move(1, [200, 100]);
    expect(line).toEqual([
      [0, 0],
      [0, 1],
    ]);
    hand.up(1, [200, 100]);
    expect([line, added]).toEqual([
      null,
      [
        [0, 0],
        [0, 1],
      ],
    ]);
    expect(trail.present).toBe(draft);
  });

  it('turns a line over by pressing its arrow', () => {
    drag([426, 200]);
    expect(trail.present.regions[0]?.rules).toEqual([{ axis: 'x', below: 2 }]);
  });
});

describe('two fingers', () => {
  it('zoom, and what the first one drew is given up', () => {
    tool = 'line';
    hand.down(1, [300, 100]);
    hand.move(1, [350, 100]);
    hand.down(2, [450, 100]);
    expect(line).toBeNull();
    hand.move(2, [550, 100]);
    expect(view.scale).toBe(200);
    hand.up(2, [550, 100]);
    hand.up(1, [350, 100]);
    expect(added).toBeNull();
  });
});

it('lets go when the pointer is taken away', () => {
  hand.down(1, [205, 200]);
  hand.move(1, [255, 200]);
  hand.cancel(1);
  const kept = trail.present;
  hand.move(1, [400, 200]);
  expect(trail.present).toBe(kept);
});
