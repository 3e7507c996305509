/** Walls, blocks and rings of the floor: what can be done to them and to their points. */

import { toCm, type Draft } from './draft';
import type { Bounds, Point } from './view';

/** An open line, a solid polygon, a closed line round the floor. */
export type ShapeKind = 'wall' | 'block' | 'ring';

/** One of them, or one of its points. */
export interface Shape {
  kind: ShapeKind;
  index: number;
  point?: number;
}

/** The list of a world's file that holds a kind. */
export const LISTS = { wall: 'walls', block: 'blocks', ring: 'floor' } as const;

/** Fewest points of a kind. */
const FEWEST = { wall: 2, block: 3, ring: 3 } as const;

export const shapesOf = (draft: Draft, kind: ShapeKind): Point[][] => draft[LISTS[kind]];

export const pointsOf = (draft: Draft, { kind, index }: Shape): Point[] =>
  shapesOf(draft, kind)[index] ?? [];

/** Whether a thing that is chosen is a shape. */
export const isShape = <T extends { kind: string }>(
  thing: T | null | undefined,
): thing is Extract<T, Shape> => thing !== null && thing !== undefined && thing.kind in LISTS;

export function withPoints(draft: Draft, { kind, index }: Shape, points: Point[]): Draft {
  const list = shapesOf(draft, kind).map((each, at) => (at === index ? points : each));
  return { ...draft, [LISTS[kind]]: list };
}

export function withNewShape(draft: Draft, kind: ShapeKind, points: Point[]): Draft {
  return { ...draft, [LISTS[kind]]: [...shapesOf(draft, kind), points] };
}

function withoutShape(draft: Draft, { kind, index }: Shape): Draft {
  const list = shapesOf(draft, kind).filter((_, at) => at !== index);
  return { ...draft, [LISTS[kind]]: list };
}

/** Without the chosen point, or the whole shape when none is chosen or too few would be left. */
export function withoutChosen(draft: Draft, shape: Shape): Draft {
  const points = pointsOf(draft, shape);
  if (shape.point === undefined || points.length <= FEWEST[shape.kind]) {
    return withoutShape(draft, shape);
  }
  return withPoints(
    draft,
    shape,
    points.filter((_, at) => at !== shape.point),
  );
}

/** Moves a shape, or the point of it that is chosen; a rectangular block stays a rectangle. */
export function movedBy(draft: Draft, shape: Shape, [dx, dy]: Point): Draft {
  const points = pointsOf(draft, shape);
  const chosen = shape.point === undefined ? undefined : points[shape.point];
  if (!chosen) {
    const moved = points.map(([x, y]): Point => [toCm(x + dx), toCm(y + dy)]);
    return withPoints(draft, shape, moved);
  }
  const to: Point = [toCm(chosen[0] + dx), toCm(chosen[1] + dy)];
  const resized = shape.kind === 'block' && isRectangle(points);
  const moved = points.map((each, at): Point => {
    if (at === shape.point) return to;
    if (!resized) return each;
    return [each[0] === chosen[0] ? to[0] : each[0], each[1] === chosen[1] ? to[1] : each[1]];
  });
  return withPoints(draft, shape, moved);
}

/** Adds a point halfway to the one after, and answers the draft with it. */
export function withPointAfter(draft: Draft, shape: Shape, after: number): Draft {
  const points = pointsOf(draft, shape);
  const [from, to] = [points[after], points[(after + 1) % points.length]];
  if (!from || !to) return draft;
  const added: Point = [toCm((from[0] + to[0]) / 2), toCm((from[1] + to[1]) / 2)];
  return withPoints(draft, shape, points.toSpliced(after + 1, 0, added));
}

/** The rectangle between two corners; none when it is thinner than a centimetre. */
export function rectangleOf(from: Point, to: Point): Point[] | null {
  const [x0, x1] = [from[0], to[0]].map(toCm).sort((a, b) => a - b) as Point;
  const [y0, y1] = [from[1], to[1]].map(toCm).sort((a, b) => a - b) as Point;
  if (x1 - x0 < 0.01 || y1 - y0 < 0.01) return null;
  return [
    [x0, y0],
    [x1, y0],
    [x1, y1],
    [x0, y1],
  ];
}

function isRectangle(points: Point[]): boolean {
  if (points.length !== 4) return false;
  const sides = points.map(([x, y], at): string => {
    const [u, v] = points[(at + 1) % 4] ?? [x, y];
    return x === u ? 'up' : y === v ? 'across' : 'askew';
  });
  return (
    sides[0] !== sides[1] &&
    sides[0] === sides[2] &&
    sides[1] === sides[3] &&
    !sides.includes('askew')
  );
}

/** Pairs of neighbouring points; a closed shape's last point has its first for one. */
export function* piecesOf(kind: ShapeKind, points: Point[]): Generator<[Point, Point, number]> {
  const count = kind === 'wall' ? points.length - 1 : points.length;
  for (let at = 0; at < count; at += 1) {
    const [from, to] = [points[at], points[(at + 1) % points.length]];
    if (from && to) yield [from, to, at];
  }
}

/** The shape whose line passes nearest a place within a reach, or the block round it. */
export function shapeAt(draft: Draft, at: Point, reach_m: number): Shape | null {
  let found: Shape | null = null;
  let least = reach_m;
  for (const kind of ['wall', 'block', 'ring'] as const) {
    shapesOf(draft, kind).forEach((points, index) => {
      const closed = kind !== 'wall';
      const away = awayFrom(points, closed, at, reach_m);
      if (away < least) [found, least] = [{ kind, index }, away];
    });
  }
  if (found) return found;
  const block = draft.blocks.findIndex((points) => isInside(points, at));
  return block < 0 ? null : { kind: 'block', index: block };
}

/** Pieces to a box of the index. */
const RUN = 32;

/** The boxes round each run of pieces of lines that never change: least x and y, greatest x and y. */
const boxes = new WeakMap<Point[], Bounds[]>();

function boxesOf(points: Point[]): Bounds[] {
  const known = boxes.get(points);
  if (known) return known;
  const found: Bounds[] = [];
  for (let start = 0; start < points.length; start += RUN) {
    const box: Bounds = [Infinity, Infinity, -Infinity, -Infinity];
    // The last piece ends where the next run, or the line, begins.
    for (let at = start; at <= Math.min(start + RUN, points.length); at += 1) {
      const [x, y] = points[at % points.length] ?? [0, 0];
      box[0] = Math.min(box[0], x);
      box[1] = Math.min(box[1], y);
      box[2] = Math.max(box[2], x);
      box[3] = Math.max(box[3], y);
    }
    found.push(box);
  }
  boxes.set(points, found);
  return found;
}

/** How far a place is from a line when it is within a reach, metres; else infinite. */
function awayFrom(points: Point[], closed: boolean, [x, y]: Point, reach_m: number): number {
  let least = Infinity;
  const count = closed ? points.length : points.length - 1;
  boxesOf(points).forEach(([x0, y0, x1, y1], run) => {
    if (x < x0 - reach_m || x > x1 + reach_m || y < y0 - reach_m || y > y1 + reach_m) return;
    const end = Math.min((run + 1) * RUN, count);
    for (let at = run * RUN; at < end; at += 1) {
      const [from, to] = [points[at], points[(at + 1) % points.length]];
      if (!from || !to) continue;
      const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
      const share = ((x - from[0]) * dx + (y - from[1]) * dy) / (dx * dx + dy * dy || 1);
      const near = Math.min(1, Math.max(0, share));
      least = Math.min(least, Math.hypot(from[0] + near * dx - x, from[1] + near * dy - y));
    }
  });
  return least;
}

function isInside(points: Point[], [x, y]: Point): boolean {
  let inside = false;
  for (const [from, to] of piecesOf('block', points)) {
    if (from[1] > y === to[1] > y) continue;
    const crossing = from[0] + ((y - from[1]) / (to[1] - from[1])) * (to[0] - from[0]);
    if (x < crossing) inside = !inside;
  }
  return inside;
}
