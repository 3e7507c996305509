/** Region lines: the line behind a rule, how it is drawn, moved, turned over and said. */

import { brief } from '../format';
import { clean, toCm, type Rule } from './draft';
import type { Bounds, Point } from './view';

/** `a·x + b·y = c`, with the normal `(a, b)` of length 1 pointing to where the rule holds. */
export interface Line {
  a: number;
  b: number;
  c: number;
}

/** Lines nearer than this to an axis are taken as parallel to it, degrees. */
const SNAP_DEG = 6;

/** The line of a rule; `null` when the rule says none. */
export function lineOf(rule: Rule): Line | null {
  const [a, b] =
    rule.axis === 'x' ? [1, 0] : rule.axis === 'y' ? [0, 1] : [rule.a ?? 0, rule.b ?? 0];
  const bound = rule.above ?? rule.below;
  const length = Math.hypot(a, b);
  if (typeof bound !== 'number' || !(length > 0)) return null;
  const side = typeof rule.above === 'number' ? 1 : -1;
  return {
    a: clean((side * a) / length),
    b: clean((side * b) / length),
    c: clean((side * bound) / length),
  };
}

/** How far a place lies on the side where the rule holds, metres; negative on the other. */
export const depth_m = ({ a, b, c }: Line, [x, y]: Point) => a * x + b * y - c;

/** The ends of a line within bounds; `null` when it passes them by. */
export function endsWithin(line: Line, [x0, y0, x1, y1]: Bounds): [Point, Point] | null {
  const corners: Point[] = [
    [x0, y0],
    [x1, y0],
    [x1, y1],
    [x0, y1],
  ];
  const found: Point[] = [];
  corners.forEach((from, index) => {
    const to = corners[(index + 1) % 4] ?? from;
    const [before, after] = [depth_m(line, from), depth_m(line, to)];
    if (before < 0 === after < 0) return;
    const share = before / (before - after);
    found.push([from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])]);
  });
  const [first, second] = found;
  return first && second ? [first, second] : null;
}

/** The rule of a line drawn from one place to another, holding to its left; near an axis, along it. */
export function ruleThrough(from: Point, to: Point): Rule | null {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(dx, dy);
  if (length < 1e-6) return null;
  const lean_deg = (Math.atan2(Math.abs(dy), Math.abs(dx)) * 180) / Math.PI;
  const middle: Point = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
  if (lean_deg < SNAP_DEG) return bounded({ axis: 'y' }, dx > 0, toCm(middle[1]));
  if (lean_deg > 90 - SNAP_DEG) return bounded({ axis: 'x' }, dy < 0, toCm(middle[0]));
  const [a, b] = [thousandth(-dy / length), thousandth(dx / length)];
  return bounded({ a, b }, true, toCm(a * middle[0] + b * middle[1]));
}

/** The wall drawn from one place to another, to the centimetre; near an axis, along it. */
export function wallThrough(from: Point, to: Point): Point[] | null {
  const [dx, dy] = [Math.abs(to[0] - from[0]), Math.abs(to[1] - from[1])];
  const lean_deg = (Math.atan2(dy, dx) * 180) / Math.PI;
  const end: Point = [
    lean_deg > 90 - SNAP_DEG ? from[0] : to[0],
    lean_deg < SNAP_DEG ? from[1] : to[1],
  ];
  const wall = [from, end].map(([x, y]): Point => [toCm(x), toCm(y)]);
  return Math.hypot(dx, dy) < 0.01 ? null : wall;
}

/** The rule that holds on the other side of the same line. */
export function turnedOver(rule: Rule): Rule {
  const { above, below, ...rest } = rule;
  return typeof above === 'number' ? { ...rest, below: above } : { ...rest, above: below ?? 0 };
}

/** The rule with its line moved by a way in the world. */
export function shifted(rule: Rule, [dx, dy]: Point): Rule {
  const [a, b] =
    rule.axis === 'x' ? [1, 0] : rule.axis === 'y' ? [0, 1] : [rule.a ?? 0, rule.b ?? 0];
  const by = a * dx + b * dy;
  const { above, below, ...rest } = rule;
  return typeof above === 'number'
    ? { ...rest, above: toCm(above + by) }
    : { ...rest, below: toCm((below ?? 0) + by) };
}

/** A rule in words, e.g. "x > 3.75 m". */
export function ruleWords(rule: Rule): string {
  const bound = rule.above ?? rule.below;
  if (typeof bound !== 'number') return 'no bound yet';
  const sign = typeof rule.above === 'number' ? '>' : '<';
  return `${sumWords(rule)} ${sign} ${brief(bound)} m`;
}

function sumWords({ axis, a, b }: Rule): string {
  if (axis) return axis;
  const second = b ?? 0;
  return `${brief(a ?? 0)}·x ${second < 0 ? '−' : '+'} ${brief(Math.abs(second))}·y`;
}

function bounded(rule: Rule, above: boolean, bound: number): Rule {
  return above ? { ...rule, above: bound } : { ...rule, below: bound };
}

const thousandth = (value: number) => clean(Math.round(value * 1000) / 1000);
