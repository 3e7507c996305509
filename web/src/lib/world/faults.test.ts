import { expect, it } from 'vitest';

import type { PlaceView } from '../protocol';
import { chainOf, elementOf, fieldWords, marksOf, plain, told } from './faults';

it('marks the faults that have a place with their number in the list', () => {
  const fault = (place: PlaceView | null) => ({ field: '', message: '', place, nearest: null });
  const nearest = { x_m: 0, y_m: 3 };
  expect(marksOf([fault(null), { ...fault({ x_m: 1, y_m: 2 }), nearest }])).toEqual([
    { number: 2, at: [1, 2], nearest: [0, 3] },
  ]);
});

it.each([
  [
    'regions[2].rules[0].a',
    'regions[2].rules[0].a regions[2].rules[0] regions[2].rules regions[2] regions',
  ],
  ['home', 'home.x home'],
  ['goal.radius_m', 'goal.radius_m goal.x goal'],
  ['name', 'name'],
])('looks for %s where it can be mended', (field, chain) => {
  expect(chainOf(field).join(' ')).toBe(chain);
});

it('names elements so that they can be found', () => {
  expect(elementOf('regions[2].rules[0]')).toBe('field-regions-2-rules-0-');
  expect(elementOf('home.x')).not.toBe(elementOf('home.y'));
});

it.each([
  ['home', 'Home'],
  ['home.heading_deg', 'Home, heading'],
  ['goal.radius_m', 'Goal, radius'],
  ['regions[2].rules[0]', 'Region 3, line 1'],
  ['regions[0].name', 'Region 1, name'],
  ['walls[4][1]', 'Wall 5 2'],
])('says %s as %s', (field, words) => {
  expect(fieldWords(field)).toBe(words);
});

it('shows messages without code marks', () => {
  expect(plain('`home` must be free')).toBe('Home must be free');
});

it('names the field of a refusal once', () => {
  expect(told('image', 'must be a PNG file')).toBe('Image: must be a PNG file');
  expect(told('yaml.resolution', 'must be above 0')).toBe('Yaml, resolution: must be above 0');
  expect(told('home', '`home` must be free')).toBe('Home must be free');
  expect(told(null, 'line 3: no key')).toBe('Line 3: no key');
});
