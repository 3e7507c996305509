import { describe, expect, it } from 'vitest';

import type { Draft } from './draft';
import { dragged, gripAt, nudged, removed, type Plan } from './grips';
import { rectangleOf, shapeAt, withPointAfter, withoutChosen, type Shape } from './shapes';
import type { Point } from './view';

const square: Point[] = [
  [0, 0],
  [2, 0],
  [2, 2],
  [0, 2],
];
const ring: Point[] = [
  [-9, -9],
  [9, -9],
  [0, 9],
];
const draft: Draft = {
  name: '',
  title: '',
  summary: '',
  source: '',
  walls: [],
  blocks: [square],
  floor: [ring],
  regions: [],
  home: { x: -5, y: -8, heading_deg: 0 },
  goal: { x: 5, y: -8, radius_m: 0.1 },
};
const block: Shape = { kind: 'block', index: 0 };
// One metre is 50 pixels; (1, 1) lies at the middle, (200, 200).
const plan: Plan = {
  draft,
  view: { x_m: 1, y_m: 1, scale: 50 },
  size: { width: 400, height: 400 },
  robotRadius_m: 0.265,
  region: null,
  chosen: null,
};

describe('taking hold of shapes', () => {
  it('finds edges of closed lines, the closing one too, and the inside of blocks', () => {
    expect(shapeAt(draft, [0, 1], 0.1)).toEqual(block);
    expect(shapeAt(draft, [1, 1], 0.1)).toEqual(block);
    // Halfway along the closing edge of the ring.
    expect(shapeAt(draft, [-4.5, 0], 0.1)).toEqual({ kind: 'ring', index: 0 });
    expect(shapeAt(draft, [-3, 0], 0.1)).toBeNull();
    // Inside the ring is floor, which is pressed to move the view.
    expect(shapeAt(draft, [0, -4], 0.1)).toBeNull();
  });

  it('takes points, and the places between them, of the chosen shape alone', () => {
    expect(gripAt(plan, [250, 150])).toEqual(block);
    const held = { ...plan, chosen: block };
    expect(gripAt(held, [250, 150])).toEqual({ ...block, point: 2 });
    expect(gripAt(held, [200, 250])).toEqual({ kind: 'between', shape: block, after: 0 });
  });
});

describe('changing shapes', () => {
  it('resizes a rectangular block by a corner', () => {
    const { blocks } = dragged(draft, { ...block, point: 2 }, [2, 2], [3, 4]);
    expect(blocks[0]).toEqual([
      [0, 0],
      [3, 0],
      [3, 4],
      [0, 4],
    ]);
  });

  it('moves one point of a ring, or all of it', () => {
    const { floor } = dragged(draft, { kind: 'ring', index: 0, point: 2 }, [0, 9], [1, 8]);
    expect(floor[0]).toEqual([ring[0], ring[1], [1, 8]]);
    const all = nudged(draft, { kind: 'ring', index: 0 }, { key: 'ArrowRight', shiftKey: false });
    expect(all?.floor[0]).toEqual([
      [-8.9, -9],
      [9.1, -9],
      [0.1, 9],
    ]);
  });

  it('adds a point where it is dragged to, after the last one too', () => {
    const added = dragged(draft, { kind: 'between', shape: block, after: 0 }, [1, 0], [1, -1]);
    expect(added.blocks[0]).toEqual([[0, 0], [1, -1], ...square.slice(1)]);
    expect(withPointAfter(draft, block, 3).blocks[0]).toEqual([...square, [0, 1]]);
  });

  it('removes a point while enough are left, and then the shape', () => {
    const three = removed(draft, { ...block, point: 0 });
    expect(three.blocks[0]).toEqual(square.slice(1));
    expect(withoutChosen(three, { ...block, point: 0 }).blocks).toEqual([]);
    expect(removed(draft, { kind: 'ring', index: 0 }).floor).toEqual([]);
  });

  it('draws a block from any corner, and none that is too thin', () => {
    expect(rectangleOf([2, 2], [0, 0])).toEqual(square);
    expect(rectangleOf([0, 0], [1, 0.001])).toBeNull();
  });
});

it('finds a shape among 8600 pieces in well under a frame', () => {
  const rings = Array.from({ length: 86 }, (_, each) =>
    Array.from({ length: 100 }, (_, k): Point => {
      const angle = (2 * Math.PI * k) / 100;
      return [3 * each + Math.cos(angle), Math.sin(angle)];
    }),
  );
  const big = { ...draft, blocks: [], floor: rings };
  const begin = performance.now();
  for (let k = 0; k < 100; k += 1) shapeAt(big, [k, 0.5], 0.01);
  const each_ms = (performance.now() - begin) / 100;
  console.info(`${each_ms.toFixed(3)} ms to find what lies under the pointer among 8600 pieces`);
  expect(each_ms).toBeLessThan(8);
});
