/** A world as it is edited: what its file says, and the edits that can be made to it. */

import type { WorldFile, WorldRegion, WorldRule } from '../protocol';
import type { Bounds } from './view';

/** A world's file, with all its lists. */
export type Draft = WorldFile;

/** A named region: the first whose rules all hold is the robot's. */
export type Region = WorldRegion;

/** A half-plane: `axis`, or `a` and `b`, with one of `above` and `below`. */
export type Rule = WorldRule;

/** The region that a world without a partition has: everywhere. */
export const EVERYWHERE: Region = { name: 'everywhere', rules: [] };

/** To the centimetre, which is finer than anybody drags. */
export const toCm = (value_m: number) => clean(Math.round(value_m * 100) / 100);

/** Degrees from −180 (not itself) to 180, to the degree. */
export function toDegrees(value_deg: number): number {
  const turned = ((((Math.round(value_deg) + 180) % 360) + 360) % 360) - 180;
  return turned === -180 ? 180 : clean(turned);
}

/** No negative zero. */
export const clean = (value: number) => (value === 0 ? 0 : value);

export function withHome(draft: Draft, change: Partial<Draft['home']>): Draft {
  return { ...draft, home: { ...draft.home, ...change } };
}

export function withGoal(draft: Draft, change: Partial<Draft['goal']>): Draft {
  return { ...draft, goal: { ...draft.goal, ...change } };
}

/** Whether the plane is cut into more than one region. */
export const isCut = (draft: Draft) => draft.regions.length > 1;

export function withRegion(draft: Draft, index: number, change: Partial<Region>): Draft {
  const regions = draft.regions.map((each, at) => (at === index ? { ...each, ...change } : each));
  return { ...draft, regions };
}

/** Adds a region without rules yet before the last, which stays everywhere else. */
export function withNewRegion(draft: Draft): Draft {
  const names = draft.regions.map(({ name }) => name);
  let number = draft.regions.length;
  while (names.includes(`region-${number}`)) number += 1;
  const added: Region = { name: `region-${number}`, rules: [] };
  const last = draft.regions.at(-1);
  const rest = last && last.rules.length === 0 ? last : EVERYWHERE;
  const before = rest === last ? draft.regions.slice(0, -1) : draft.regions;
  return { ...draft, regions: [...before, added, rest] };
}

export function withoutRegion(draft: Draft, index: number): Draft {
  return { ...draft, regions: draft.regions.filter((_, at) => at !== index) };
}

/** Moves a region earlier (−1) or later (+1); the last one, everywhere else, keeps its place. */
export function withRegionMoved(draft: Draft, index: number, by: -1 | 1): Draft {
  const to = index + by;
  const [moved, other] = [draft.regions[index], draft.regions[to]];
  const last = draft.regions.length - 1;
  if (!moved || !other || index === last || to === last) return draft;
  const regions = [...draft.regions];
  [regions[index], regions[to]] = [other, moved];
  return { ...draft, regions };
}

export function withRule(draft: Draft, region: number, index: number, rule: Rule): Draft {
  const rules = draft.regions[region]?.rules.map((each, at) => (at === index ? rule : each));
  return rules ? withRegion(draft, region, { rules }) : draft;
}

export function withNewRule(draft: Draft, region: number, rule: Rule): Draft {
  const rules = draft.regions[region]?.rules;
  return rules ? withRegion(draft, region, { rules: [...rules, rule] }) : draft;
}

export function withoutRule(draft: Draft, region: number, index: number): Draft {
  const rules = draft.regions[region]?.rules.filter((_, at) => at !== index);
  return rules ? withRegion(draft, region, { rules }) : draft;
}

/** Least and greatest x and y of walls, home and goal, metres. */
export function boundsOf({ walls, blocks, floor, home, goal }: Draft): Bounds {
  const bounds: Bounds = [
    Math.min(home.x, goal.x),
    Math.min(home.y, goal.y),
    Math.max(home.x, goal.x),
    Math.max(home.y, goal.y),
  ];
  for (const line of [...walls, ...blocks, ...floor]) {
    for (const [x, y] of line) {
      bounds[0] = Math.min(bounds[0], x);
      bounds[1] = Math.min(bounds[1], y);
      bounds[2] = Math.max(bounds[2], x);
      bounds[3] = Math.max(bounds[3], y);
    }
  }
  return bounds;
}
