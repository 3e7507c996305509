import { describe, expect, it } from 'vitest';

import {
  boundsOf,
  isCut,
  toCm,
  toDegrees,
  withNewRegion,
  withNewRule,
  withoutRegion,
  withoutRule,
  withRegionMoved,
  type Draft,
} from './draft';

const draft: Draft = {
  name: 'two-rooms',
  title: 'Two rooms',
  summary: '',
  source: '',
  walls: [
    [
      [0, 0],
      [6, 0],
      [6, 4],
    ],
  ],
  blocks: [
    [
      [2, 1],
      [3, 1],
      [3, 2],
    ],
  ],
  floor: [],
  regions: [
    { name: 'left', rules: [{ axis: 'x', below: 3 }] },
    { name: 'right', rules: [{ axis: 'x', above: 3 }] },
    { name: 'else', rules: [] },
  ],
  home: { x: -1, y: 1, heading_deg: 0 },
  goal: { x: 5, y: 7, radius_m: 0.5 },
};
const names = ({ regions }: Draft) => regions.map(({ name }) => name);

describe('regions', () => {
  it('come before the one that is everywhere else', () => {
    const more = withNewRegion(draft);
    expect(names(more)).toEqual(['left', 'right', 'region-3', 'else']);
    expect(names(withNewRegion(more))).toEqual(['left', 'right', 'region-3', 'region-4', 'else']);
    expect(isCut(draft)).toBe(true);
  });

  it('get a last one when they had none', () => {
    const open = withoutRegion(draft, 2);
    expect(names(withNewRegion(open))).toEqual(['left', 'right', 'region-2', 'everywhere']);
  });

  it('change places, but never with the last', () => {
    expect(names(withRegionMoved(draft, 1, -1))).toEqual(['right', 'left', 'else']);
    for (const [index, by] of [
      [0, -1],
      [1, 1],
      [2, -1],
    ] as const) {
      expect(withRegionMoved(draft, index, by)).toBe(draft);
    }
  });

  it('gain and lose rules, leaving the draft before as it was', () => {
    const more = withNewRule(draft, 0, { axis: 'y', above: 1 });
    expect(more.regions[0]?.rules).toHaveLength(2);
    expect(withoutRule(more, 0, 0).regions[0]?.rules).toEqual([{ axis: 'y', above: 1 }]);
    expect(draft.regions[0]?.rules).toHaveLength(1);
    expect(withNewRule(draft, 9, { axis: 'y', above: 1 })).toBe(draft);
  });
});

it('knows its extent', () => {
  expect(boundsOf(draft)).toEqual([-1, 0, 6, 7]);
});

it('rounds to what a hand can mean', () => {
  expect([1.2345, -0.001, 2.675].map(toCm)).toEqual([1.23, 0, 2.68]);
  expect([0.4, 181, -180, 359.6, -540].map(toDegrees)).toEqual([0, -179, 180, 0, 180]);
});
