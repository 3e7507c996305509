/** Geometry of the drawn worlds. The corridor's unit is one cell; y points down. */

import type { StateView, TaskView } from '../protocol';

/** A place in a drawing. */
export type Spot = [number, number];

/** How far from a cell's centre the words of a sector stand, of half a cell. */
const WORDS_AT = 0.62;

/** Directions of the arrow keys. */
const KEYS: Record<string, Spot> = {
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
};

/** Where a heading points, counter-clockwise from east. */
export function towards(heading_deg: number): Spot {
  const angle = (heading_deg * Math.PI) / 180;
  return [tidy(Math.cos(angle)), tidy(-Math.sin(angle))];
}

/** Centre of the cell that a state lies in; none where it has no place. */
export function centre({ row, column }: StateView): Spot | null {
  return row === null || column === null ? null : [column + 0.5, row + 0.5];
}

/** The sector of a state in its cell: the triangle on the side its heading looks to. */
export function sector(state: StateView): [Spot, Spot, Spot] | null {
  const middle = centre(state);
  if (!middle || state.heading_deg === null) return null;
  const [x, y] = middle;
  const [dx, dy] = towards(state.heading_deg);
  const half = 0.5;
  return [
    middle,
    [x + half * (dx + dy), y + half * (dy - dx)],
    [x + half * (dx - dy), y + half * (dy + dx)],
  ];
}

/** Where the words of a state stand: in the sector, or in the middle of its cell. */
export function wordsAt(state: StateView): Spot | null {
  const middle = centre(state);
  if (!middle || state.heading_deg === null) return middle;
  const [dx, dy] = towards(state.heading_deg);
  return [middle[0] + (dx * WORDS_AT) / 2, middle[1] + (dy * WORDS_AT) / 2];
}

/** The state at a place of a maze, in cells from the upper left; none in a wall. */
export function stateAt(task: TaskView, [x, y]: Spot): number | null {
  const [row, column] = [Math.floor(y), Math.floor(x)];
  const found = task.states.findIndex((state) => state.row === row && state.column === column);
  return found < 0 ? null : found;
}

/** The state that an arrow key leads to: the nearest in its direction, or the same. */
export function stateBeside(task: TaskView, from: number, key: string): number {
  const way = KEYS[key];
  if (!way) return from;
  const here = task.states[from] && wordsAt(task.states[from]);
  if (!here) return listed(task, from, way);
  let best = from;
  let least = Infinity;
  task.states.forEach((state, index) => {
    const there = wordsAt(state);
    if (!there || index === from) return;
    // Sectors lie aslant of each other; cells of a maze do not, and a leap over a wall stays in line.
    const slant = task.kind === 'maze' ? 0 : 1;
    const cost = costOf(here, there, way, slant);
    if (cost < least) [best, least] = [index, cost];
  });
  return best;
}

/** Distance along the direction, with what lies aside counted twice; never backwards or too far aside. */
function costOf(here: Spot, there: Spot, way: Spot, slant: number): number {
  const [dx, dy] = [there[0] - here[0], there[1] - here[1]];
  const ahead = dx * way[0] + dy * way[1];
  const aside = Math.abs(dx * way[1]) + Math.abs(dy * way[0]);
  return ahead > 1e-6 && aside <= slant * ahead + 1e-6 ? ahead + 2 * aside : Infinity;
}

/** Without a drawing, states stand in a list. */
function listed(task: TaskView, from: number, way: Spot): number {
  const next = from + way[0] + way[1];
  return Math.min(task.states.length - 1, Math.max(0, next));
}

/** A cosine of a right angle is nothing. */
function tidy(value: number): number {
  return Math.abs(value) < 1e-12 ? 0 : value;
}

/** An arrow of an action in a maze, named after its direction; none for other actions. */
export function wayOf(action: string): Spot | null {
  const ways: Record<string, Spot> = {
    north: [0, -1],
    east: [1, 0],
    south: [0, 1],
    west: [-1, 0],
  };
  return ways[action] ?? null;
}

/** A state in a few signs, where its whole name has no room; in a maze its row and column. */
export function shortName(task: TaskView, state: number): string {
  const { name = '', row = null, column = null } = task.states[state] ?? {};
  if (task.kind === 'process' && name) return name;
  const isCell = task.kind === 'maze' && row !== null && column !== null;
  return isCell ? `r${row + 1} c${column + 1}` : `#${state}`;
}
