import { describe, expect, it } from 'vitest';

import type { Draft } from './draft';
import {
  dragged,
  gripAt,
  headingHandle,
  nudged,
  removed,
  withSideTurned,
  type Grip,
  type Plan,
} from './grips';
import type { Point } from './view';

const draft: Draft = {
  name: '',
  title: '',
  summary: '',
  source: '',
  walls: [
    [
      [0, 1],
      [1, 1],
      [1, 1.5],
    ],
  ],
  blocks: [],
  floor: [],
  regions: [
    { name: 'east', rules: [{ axis: 'x', above: 2 }] },
    { name: 'else', rules: [] },
  ],
  home: { x: 0, y: 0, heading_deg: 90 },
  goal: { x: 4, y: 0, radius_m: 0.5 },
};
// One metre is 100 pixels; (2, 0) lies at the middle of the canvas, (400, 200).
const plan: Plan = {
  draft,
  view: { x_m: 2, y_m: 0, scale: 100 },
  size: { width: 800, height: 400 },
  robotRadius_m: 0.265,
  region: 0,
  chosen: null,
};

describe('what lies under the pointer', () => {
  it.each<[string, Point, Grip | null]>([
    ['the robot', [215, 190], { kind: 'home' }],
    ['the tip of its heading, above it', [200, 155], { kind: 'heading' }],
    ['the goal', [600, 200], { kind: 'goal' }],
    ['inside the goal', [570, 190], { kind: 'goal' }],
    ['the rim of the goal', [652, 200], { kind: 'radius' }],
    ['the line', [403, 350], { kind: 'line', region: 0, rule: 0 }],
    ['the arrow of the line, on its side', [426, 200], { kind: 'side', region: 0, rule: 0 }],
    ['a wall', [250, 104], { kind: 'wall', index: 0 }],
    ['the second piece of a wall', [297, 80], { kind: 'wall', index: 0 }],
    ['past the end of a wall', [300, 38], null],
    ['nothing', [340, 60], null],
  ])('%s', (_, at, grip) => {
    expect(gripAt(plan, at)).toEqual(grip);
  });

  it('is no line of a region that is not chosen', () => {
    expect(gripAt({ ...plan, region: null }, [403, 350])).toBeNull();
  });
});

it('finds the heading outside a robot of any size', () => {
  expect(headingHandle(plan)).toEqual([200, 200 - 26.5 - 18]);
  expect(headingHandle({ ...plan, robotRadius_m: 0.01 })[1]).toBe(162);
});

describe('dragging', () => {
  it('moves by the way of the pointer, so that nothing jumps', () => {
    expect(dragged(draft, { kind: 'home' }, [0.1, 0.1], [1.1, -0.4]).home).toEqual({
      x: 1,
      y: -0.5,
      heading_deg: 90,
    });
    expect(dragged(draft, { kind: 'goal' }, [4, 0], [4.004, 1]).goal.x).toBe(4);
    const line = { kind: 'line', region: 0, rule: 0 } as const;
    expect(dragged(draft, line, [2, 0], [2.5, 3]).regions[0]?.rules).toEqual([
      { axis: 'x', above: 2.5 },
    ]);
  });

  it('moves a wall whole, and takes it away', () => {
    const wall = { kind: 'wall', index: 0 } as const;
    expect(dragged(draft, wall, [0, 0], [1, -1]).walls[0]).toEqual([
      [1, 0],
      [2, 0],
      [2, 0.5],
    ]);
    expect(removed(draft, wall).walls).toEqual([]);
    expect(removed(draft, { kind: 'home' })).toBe(draft);
  });

  it('turns towards the pointer and widens up to it', () => {
    expect(dragged(draft, { kind: 'heading' }, [0, 1], [-1, -1]).home.heading_deg).toBe(-135);
    expect(dragged(draft, { kind: 'radius' }, [4.5, 0], [4, 0.8]).goal.radius_m).toBe(0.8);
    expect(dragged(draft, { kind: 'radius' }, [4.5, 0], [4, 0]).goal.radius_m).toBe(0.05);
  });

  it('turns a line over at its arrow', () => {
    const turned = withSideTurned(draft, { kind: 'side', region: 0, rule: 0 });
    expect(turned.regions[0]?.rules).toEqual([{ axis: 'x', below: 2 }]);
  });
});

describe('keys', () => {
  const press = (key: string, shiftKey = false) => ({ key, shiftKey });

  it('move what is chosen by 10 cm or by 1', () => {
    expect(nudged(draft, { kind: 'home' }, press('ArrowUp'))?.home.y).toBe(0.1);
    expect(nudged(draft, { kind: 'goal' }, press('ArrowLeft', true))?.goal.x).toBe(3.99);
  });

  it('turn the robot, widen the goal, turn a line over', () => {
    expect(nudged(draft, { kind: 'home' }, press(','))?.home.heading_deg).toBe(95);
    expect(nudged(draft, { kind: 'home' }, press('>', true))?.home.heading_deg).toBe(89);
    expect(nudged(draft, { kind: 'goal' }, press('.'))?.goal.radius_m).toBe(0.55);
    const line = { kind: 'line', region: 0, rule: 0 } as const;
    expect(nudged(draft, line, press(','))?.regions[0]?.rules).toEqual([{ axis: 'x', below: 2 }]);
  });

  it('that mean nothing change nothing', () => {
    expect(nudged(draft, { kind: 'home' }, press('q'))).toBeNull();
  });
});
