/** Fuzzy sets to be drawn, and rules to be looked through. */

import { words } from '../format';
import type { RuleView, SetView, VariableView } from '../protocol';

/** Membership of a value in a set with these corners, 0 to 1; an upright side belongs to the set. */
export function membership([left, from, to, right]: SetView['corners'], value: number): number {
  if (value < left || value > right) return 0;
  if (value < from) return (value - left) / (from - left);
  if (value > to) return (right - value) / (right - to);
  return 1;
}

/** Outline of a set, drawn over a part of its variable's range: place 0 to 1, membership 0 to 1. */
export function outline(
  { corners }: SetView,
  range: [number, number],
  drawn: [number, number],
): [number, number][] {
  const [left, from, to, right] = corners;
  const points: [number, number][] = [
    [left, 0],
    [from, 1],
    [to, 1],
    [right, 0],
  ];
  // An upright side at an end of the range is no side: the set goes on there.
  const isSide = (at: number) =>
    (at > range[0] && at < range[1]) ||
    (at === left && left < from) ||
    (at === right && to < right);
  return points
    .filter(([at, height]) => height === 1 || isSide(at))
    .map(([at, height]) => [placeIn(drawn, at), height]);
}

/** Place of a value in a range, 0 to 1; what lies outside stands at its end. */
export function placeIn([least, most]: [number, number], value: number): number {
  return Math.max(0, Math.min(1, (value - least) / (most - least || 1)));
}

/** The part of a variable's range that is drawn: where memberships change, and a little beyond. */
export function drawnRange({ range, sets }: VariableView): [number, number] {
  const [least, most] = range;
  const changes = sets.flatMap(({ corners: [left, from, to, right] }) => [
    ...(left < from || left > least ? [left, from] : []),
    ...(to < right || right < most ? [to, right] : []),
  ]);
  const [first, last] = [Math.min(...changes), Math.max(...changes)];
  if (!(last > first)) return range;
  const beyond = 0.2 * (last - first);
  const step = 10 ** Math.floor(Math.log10(last - first)) / 2;
  const round = (at: number, by: (steps: number) => number) => by(at / step) * step;
  return [
    Math.max(least, round(first - beyond, Math.floor)),
    Math.min(most, round(last + beyond, Math.ceil)),
  ];
}

/** How much of a threat a set is, or how fast, from 0 for the first to 1 for the last of its input's sets. */
export function rank(input: VariableView | undefined, set: string): number {
  const sets = input?.sets ?? [];
  const index = sets.findIndex(({ name }) => name === set);
  return sets.length > 1 && index > 0 ? index / (sets.length - 1) : 0;
}

/** Whether a rule speaks of the sets asked for; an empty one asks for nothing. */
export function matches(rule: RuleView, asked: string[]): boolean {
  return rule.when.every((set, index) => !asked[index] || asked[index] === set);
}

/** What a rule says, in a sentence. */
export function ruleWords(rule: Pick<RuleView, 'when' | 'then'>, names: Names): string {
  const when = rule.when.map((set, index) => `${names.inputs[index]} ${set}`).join(', ');
  const then = rule.then.map((value, index) => `${names.outputs[index]} ${value}`).join(', ');
  return `If ${when}, then ${then}`;
}

interface Names {
  inputs: string[];
  outputs: string[];
}

/** Names of the variables of a rule base for people. */
export const namesOf = (base: { inputs: VariableView[]; outputs: VariableView[] }): Names => ({
  inputs: base.inputs.map(({ name }) => words(name)),
  outputs: base.outputs.map(outputName),
});

/** An output in words; the navigator calls them by letters. */
export function outputName({ name }: VariableView): string {
  return { v: 'velocity', w: 'turn' }[name] ?? words(name);
}
