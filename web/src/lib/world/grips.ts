/** What can be taken hold of on the plan, and what dragging it or pressing keys does to the draft. */

import {
  toCm,
  toDegrees,
  withGoal,
  withHome,
  withoutRule,
  withRule,
  type Draft,
  type Rule,
} from './draft';
import { depth_m, endsWithin, lineOf, shifted, turnedOver, type Line } from './line';
import {
  isShape,
  movedBy,
  piecesOf,
  pointsOf,
  shapeAt,
  withoutChosen,
  withPointAfter,
  type Shape,
} from './shapes';
import { toScreen, toWorld, type Bounds, type Point, type Size, type View } from './view';

/** What is chosen: the arrow keys move it. */
export type Chosen =
  { kind: 'home' } | { kind: 'goal' } | Shape | { kind: 'line'; region: number; rule: number };

/** Something under the pointer: a thing, or the handle that turns or widens it. */
export type Grip = Chosen | { kind: 'heading' } | { kind: 'radius' } | Side | Between;

/** The handle between two points of the chosen shape: dragging it adds a point there. */
export interface Between {
  kind: 'between';
  shape: Shape;
  after: number;
}

/** The arrow that says on which side of a line its rule holds; pressing it turns the rule over. */
export interface Side {
  kind: 'side';
  region: number;
  rule: number;
}

/** What the plan shows, for finding things on it. */
export interface Plan {
  draft: Draft;
  view: View;
  size: Size;
  robotRadius_m: number;
  /** Region whose lines are shown and can be taken; none when `null`. */
  region: number | null;
  /** What is chosen: only its points can be taken one by one. */
  chosen: Chosen | null;
}

/** How near the pointer must come, pixels. */
const REACH = 14;
/** Length of the arrow at a line's middle, pixels. */
export const SIDE_ARROW = 26;

/** Where the handle of the heading lies, pixels. */
export function headingHandle({ draft, view, size, robotRadius_m }: Plan): Point {
  const [x, y] = toScreen(view, size, [draft.home.x, draft.home.y]);
  const angle = (draft.home.heading_deg * Math.PI) / 180;
  const out = Math.max(38, robotRadius_m * view.scale + 18);
  return [x + out * Math.cos(angle), y - out * Math.sin(angle)];
}

/** Where the handle of the goal's radius lies, pixels. */
export function radiusHandle({ draft, view, size }: Plan): Point {
  const [x, y] = toScreen(view, size, [draft.goal.x, draft.goal.y]);
  return [x + Math.max(20, draft.goal.radius_m * view.scale), y];
}

/** What is seen of the world, metres. */
export function seen({ view, size }: Plan): Bounds {
  const [x0, y1] = toWorld(view, size, [0, 0]);
  const [x1, y0] = toWorld(view, size, [size.width, size.height]);
  return [x0, y0, x1, y1];
}

/** A line on the plan, with its index among the rules. */
export interface ShownLine {
  rule: number;
  line: Line;
  ends: [Point, Point];
  /** Where its arrow begins and ends, pixels. */
  arrow: [Point, Point];
}

/** The lines of the chosen region as they lie on the canvas. */
export function shownLines(plan: Plan): ShownLine[] {
  const rules = plan.region === null ? [] : (plan.draft.regions[plan.region]?.rules ?? []);
  return rules.flatMap((rule, index) => {
    const line = lineOf(rule);
    const ends = line && endsWithin(line, seen(plan));
    if (!line || !ends) return [];
    const [from, to] = ends.map((end) => toScreen(plan.view, plan.size, end)) as [Point, Point];
    const middle: Point = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
    const tip: Point = [middle[0] + SIDE_ARROW * line.a, middle[1] - SIDE_ARROW * line.b];
    return [{ rule: index, line, ends: [from, to], arrow: [middle, tip] }];
  });
}

/** Shortest piece, pixels, that has a handle for a new point. */
const ROOM = 44;

/** The handles of the chosen shape as they lie on the canvas: its points, and those for new ones. */
export function shapeHandles({ chosen, draft, view, size }: Plan): { grip: Grip; at: Point }[] {
  if (!isShape(chosen)) return [];
  const shape: Shape = { kind: chosen.kind, index: chosen.index };
  const points = pointsOf(draft, shape);
  const seenAt = (at: Point) => {
    const [x, y] = toScreen(view, size, at);
    return x > -REACH && y > -REACH && x < size.width + REACH && y < size.height + REACH;
  };
  const corners = points.flatMap((each, point) =>
    seenAt(each) ? [{ grip: { ...shape, point }, at: toScreen(view, size, each) }] : [],
  );
  const between: { grip: Grip; at: Point }[] = [];
  for (const [from, to, after] of piecesOf(shape.kind, points)) {
    const middle: Point = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
    if (apart(from, to) * view.scale < ROOM || !seenAt(middle)) continue;
    between.push({ grip: { kind: 'between', shape, after }, at: toScreen(view, size, middle) });
  }
  return [...corners, ...between];
}

/** The nearest handle of the chosen shape within reach. */
function pointAt(plan: Plan, at: Point): Grip | null {
  let [found, least]: [Grip | null, number] = [null, REACH];
  for (const handle of shapeHandles(plan)) {
    const away = apart(handle.at, at);
    if (away < least) [found, least] = [handle.grip, away];
  }
  return found;
}

/** What lies under a point of the canvas, the smallest first. */
export function gripAt(plan: Plan, at: Point): Grip | null {
  const { draft, view, size, region } = plan;
  const point = pointAt(plan, at);
  if (point) return point;
  const home = toScreen(view, size, [draft.home.x, draft.home.y]);
  const goal = toScreen(view, size, [draft.goal.x, draft.goal.y]);
  const lines = region === null ? [] : shownLines(plan);
  const side = lines.find(({ arrow }) => apart(arrow[1], at) < REACH);
  if (apart(headingHandle(plan), at) < REACH) return { kind: 'heading' };
  if (apart(radiusHandle(plan), at) < REACH) return { kind: 'radius' };
  if (apart(home, at) < Math.max(REACH, plan.robotRadius_m * view.scale)) return { kind: 'home' };
  if (side && region !== null) return { kind: 'side', region, rule: side.rule };
  if (apart(goal, at) < REACH) return { kind: 'goal' };
  const world = toWorld(view, size, at);
  const line = lines.find(({ line }) => Math.abs(depth_m(line, world)) * view.scale < 8);
  if (line && region !== null) return { kind: 'line', region, rule: line.rule };
  const shape = shapeAt(draft, world, 7 / view.scale);
  if (shape) return shape;
  if (apart(goal, at) < draft.goal.radius_m * view.scale) return { kind: 'goal' };
  return null;
}

/** The draft with what is held dragged from one place of the world to another. */
export function dragged(start: Draft, grip: Grip, from: Point, to: Point): Draft {
  const { home, goal } = start;
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  switch (grip.kind) {
    case 'home':
      return withHome(start, { x: toCm(home.x + dx), y: toCm(home.y + dy) });
    case 'goal':
      return withGoal(start, { x: toCm(goal.x + dx), y: toCm(goal.y + dy) });
    case 'heading': {
      const angle = Math.atan2(to[1] - home.y, to[0] - home.x);
      return withHome(start, { heading_deg: toDegrees((angle * 180) / Math.PI) });
    }
    case 'radius': {
      const radius_m = toCm(Math.hypot(to[0] - goal.x, to[1] - goal.y));
      return withGoal(start, { radius_m: Math.max(LEAST_RADIUS_M, radius_m) });
    }
    case 'line':
      return mapRule(start, grip, (rule) => shifted(rule, [dx, dy]));
    case 'wall':
    case 'block':
    case 'ring':
      return movedBy(start, grip, [dx, dy]);
    case 'between': {
      const { shape, after } = grip;
      const added = withPointAfter(start, shape, after);
      return movedBy(added, { ...shape, point: after + 1 }, [dx, dy]);
    }
    case 'side':
      return start;
  }
}

/** The smallest radius a hand can give the goal, metres. */
const LEAST_RADIUS_M = 0.05;

/** The draft with a line's rule turned over. */
export function withSideTurned(draft: Draft, { region, rule }: Side): Draft {
  return mapRule(draft, { kind: 'line', region, rule }, turnedOver);
}

/** Ways of the arrow keys: right, left, up, down. */
const WAYS: Record<string, Point> = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** A key that changes what is chosen. */
export interface Press {
  key: string;
  shiftKey: boolean;
}

/** The draft after a key: arrows move by 0.1 m (with Shift 1 cm), comma and full stop turn or resize. */
export function nudged(draft: Draft, chosen: Chosen, { key, shiftKey }: Press): Draft | null {
  const way = WAYS[key];
  if (way) {
    const step_m = shiftKey ? 0.01 : 0.1;
    return dragged(draft, chosen, [0, 0], [way[0] * step_m, way[1] * step_m]);
  }
  const sign = { ',': 1, '<': 1, '.': -1, '>': -1 }[key];
  if (!sign) return null;
  const step = '<>'.includes(key) ? 1 : 5;
  switch (chosen.kind) {
    case 'home':
      return withHome(draft, { heading_deg: toDegrees(draft.home.heading_deg + sign * step) });
    case 'goal': {
      const radius_m = toCm(draft.goal.radius_m - (sign * step) / 100);
      return withGoal(draft, { radius_m: Math.max(LEAST_RADIUS_M, radius_m) });
    }
    case 'line':
      return mapRule(draft, chosen, turnedOver);
    case 'wall':
    case 'block':
    case 'ring':
      return null;
  }
}

/** The draft without what is chosen; home and goal are always there. */
export function removed(draft: Draft, chosen: Chosen): Draft {
  if (chosen.kind === 'line') return withoutRule(draft, chosen.region, chosen.rule);
  return isShape(chosen) ? withoutChosen(draft, chosen) : draft;
}

type LineChosen = Extract<Chosen, { kind: 'line' }>;

function mapRule(draft: Draft, { region, rule }: LineChosen, change: (rule: Rule) => Rule): Draft {
  const found = draft.regions[region]?.rules[rule];
  return found ? withRule(draft, region, rule, change(found)) : draft;
}

const apart = (a: Point, b: Point) => Math.hypot(a[0] - b[0], a[1] - b[1]);
