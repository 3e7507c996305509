import { describe, expect, it } from 'vitest';

import {
  fitted,
  gridStep_m,
  panned,
  pinched,
  toScreen,
  toWorld,
  zoomed,
  type Point,
  type View,
} from './view';

const size = { width: 400, height: 200 };
const view: View = { x_m: 3, y_m: -1, scale: 50 };
const near = (a: Point, b: Point) => {
  expect(a[0]).toBeCloseTo(b[0], 9);
  expect(a[1]).toBeCloseTo(b[1], 9);
};

describe('the view', () => {
  it('shows its own middle at the middle of the canvas, y up', () => {
    expect(toScreen(view, size, [3, -1])).toEqual([200, 100]);
    expect(toScreen(view, size, [4, 0])).toEqual([250, 50]);
  });

  it('finds back what it shows', () => {
    near(toWorld(view, size, toScreen(view, size, [1.25, 7])), [1.25, 7]);
  });

  it('fits bounds into the tighter direction', () => {
    const all = fitted([0, 0, 10, 10], size, 0);
    expect(all).toEqual({ x_m: 5, y_m: 5, scale: 20 });
    expect(fitted([2, 2, 2, 2], size).scale).toBeLessThanOrEqual(4000);
  });

  it('moves with the hand', () => {
    const grabbed = toWorld(view, size, [50, 60]);
    near(toWorld(panned(view, 30, -10), size, [80, 50]), grabbed);
  });

  it.each([2, 0.3, 1e9, 1e-9])('zooms by %d about the pointer', (factor) => {
    const at: Point = [310, 20];
    near(toWorld(zoomed(view, size, at, factor), size, at), toWorld(view, size, at));
  });

  it('keeps what is between two fingers between them', () => {
    const before: [Point, Point] = [
      [100, 100],
      [200, 100],
    ];
    const after: [Point, Point] = [
      [100, 60],
      [300, 60],
    ];
    const moved = pinched(view, size, before, after);
    expect(moved.scale).toBe(100);
    near(toWorld(moved, size, [200, 60]), toWorld(view, size, [150, 100]));
  });
});

it.each([
  [50, 1],
  [48, 1],
  [30, 2],
  [10, 5],
  [5, 10],
  [500, 0.1],
])('draws lines of the grid far enough apart: at %d px/m every %d m', (scale, step) => {
  expect(gridStep_m(scale)).toBeCloseTo(step, 12);
});
