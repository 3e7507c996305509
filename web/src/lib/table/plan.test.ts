import { describe, expect, it } from 'vitest';

import { sector, shortName, stateAt, stateBeside, towards, wordsAt } from './plan';
import { sampleLabyrinth, sampleMaze } from './sample';

const labyrinth = sampleLabyrinth();
const maze = sampleMaze(['S.#', '..G']);

it('points headings counter-clockwise from east, with y down', () => {
  expect([0, 90, 180, 270].map(towards)).toEqual([
    [1, 0],
    [0, -1],
    [-1, 0],
    [0, 1],
  ]);
});

it('gives each heading the side of its cell that it looks to', () => {
  const corners = (state: number) => sector(labyrinth.states[state]!);
  // #13: cell 3 from the west, facing east: centre, and both right corners.
  expect(corners(13)).toEqual([
    [2.5, 0.5],
    [3, 0],
    [3, 1],
  ]);
  // #0: the first cell, facing north: both upper corners.
  expect(corners(0)).toEqual([
    [0.5, 0.5],
    [0, 0],
    [1, 0],
  ]);
});

it('covers each cell with its four sectors', () => {
  const area = labyrinth.states.reduce((sum, state) => {
    const [[ax, ay], [bx, by], [cx, cy]] = sector(state)!;
    return sum + Math.abs((bx - ax) * (cy - ay) - (cx - ax) * (by - ay)) / 2;
  }, 0);
  expect(area).toBeCloseTo(4);
});

it('puts words into the sector', () => {
  const [x, y] = wordsAt(labyrinth.states[7]!)!;
  // #7 looks west from the second cell.
  expect([x > 1 && x < 1.5, y]).toEqual([true, 0.5]);
});

it('finds the cell of a maze, and no state in a wall or outside', () => {
  expect([stateAt(maze, [0.5, 0.5]), stateAt(maze, [2.9, 1.1])]).toEqual([0, 4]);
  expect([stateAt(maze, [2.5, 0.5]), stateAt(maze, [-0.1, 0.5])]).toEqual([null, null]);
});

describe('arrow keys', () => {
  it.each([
    ['right along the row', 0, 'ArrowRight', 1],
    ['down the column', 1, 'ArrowDown', 3],
    ['stays at the edge', 0, 'ArrowUp', 0],
    ['stays beside a wall', 1, 'ArrowRight', 1],
    ['other keys do nothing', 1, 'a', 1],
  ])('%s', (_, from, key, to) => {
    expect(stateBeside(maze, from, key)).toBe(to);
  });

  it('leap over a wall', () => {
    expect(stateBeside(sampleMaze(['S#G']), 0, 'ArrowRight')).toBe(1);
  });

  it('reach every sector of the labyrinth', () => {
    const reached = new Set([7]);
    for (let round = 0; round < 16; round += 1) {
      for (const state of [...reached]) {
        for (const key of ['ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight']) {
          reached.add(stateBeside(labyrinth, state, key));
        }
      }
    }
    expect(reached.size).toBe(16);
  });

  it('go through the list where there is no drawing', () => {
    const states = labyrinth.states.map((state) => ({ ...state, row: null, column: null }));
    const process = { ...labyrinth, kind: 'process', states };
    expect(stateBeside(process, 3, 'ArrowDown')).toBe(4);
    expect(stateBeside(process, 0, 'ArrowUp')).toBe(0);
  });
});

it('names states so that they can be found', () => {
  expect(shortName(labyrinth, 7)).toBe('#7');
  expect(shortName(maze, 4)).toBe('r2 c3');
  expect(shortName({ ...labyrinth, kind: 'process' }, 7)).toBe(
    '#7 (cell 2 from the west, facing west)',
  );
});
