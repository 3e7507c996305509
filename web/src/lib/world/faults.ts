/** What is wrong with a draft, and where: the field to mend and the mark on the plan. */

import type { PlaceView, WorldProblem } from '../protocol';
import type { Point } from './view';

/** A mark on the plan: the number of its problem in the list, its place, and where it could be instead. */
export interface Mark {
  number: number;
  at: Point;
  nearest: Point | null;
}

/** The marks of faults that have a place. */
export function marksOf(faults: WorldProblem[]): Mark[] {
  return faults.flatMap(({ place, nearest }, index) =>
    place ? [{ number: index + 1, at: point(place), nearest: nearest && point(nearest) }] : [],
  );
}

const point = ({ x_m, y_m }: PlaceView): Point => [x_m, y_m];

/** Identifier of the element that edits a field. */
export const elementOf = (field: string) => `field-${field.replace(/[^\w]+/g, '-')}`;

/** The fields to look for when a fault is to be mended, the most particular first. */
export function chainOf(field: string): string[] {
  const chain = [field];
  let rest = field;
  while (/[.[]/.test(rest)) {
    rest = rest.slice(0, Math.max(rest.lastIndexOf('.'), rest.lastIndexOf('[')));
    chain.push(rest);
  }
  const within: Record<string, string> = { home: 'home.x', goal: 'goal.x' };
  return chain.flatMap((each) => (within[each] ? [within[each], each] : [each]));
}

/** What is said about a field itself or something within it, for its input. */
export function faultOf(faults: WorldProblem[], field: string): string {
  return faults.find((fault) => fault.field === field)?.message ?? '';
}

/** A message without the field it begins with, for where the field is named already. */
export function plain(message: string): string {
  const text = message.replace(/`/g, '');
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** A field in words. */
export function fieldWords(field: string): string {
  const numbered = field.replace(/\[(\d+)\]/g, (_, index: string) => ` ${Number(index) + 1}`);
  const words = numbered
    .replace(/^regions /, 'Region ')
    .replace(/^walls /, 'Wall ')
    .replace(/^blocks /, 'Block ')
    .replace('.rules ', ', line ')
    .replace('.heading_deg', ', heading')
    .replace('.radius_m', ', radius')
    .replace('.', ', ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** What is wrong with its field before it, unless the words name the field themselves. */
export function told(field: string | null, detail: string): string {
  return !field || detail.includes(`\`${field}`)
    ? plain(detail)
    : `${fieldWords(field)}: ${detail.replace(/`/g, '')}`;
}
