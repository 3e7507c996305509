import { expect, it } from 'vitest';

import { freeName, nameFrom } from './names';

it.each([
  ['Two rooms, one door', 'two-rooms-one-door'],
  ['  Büro 3.OG ', 'buro-3-og'],
  ['***', ''],
  ['x'.repeat(99), 'x'.repeat(64)],
])('makes a name of "%s"', (title, name) => {
  expect(nameFrom(title)).toBe(name);
});

it('finds one that is free', () => {
  expect(freeName('hall', [])).toBe('hall');
  expect(freeName('hall', ['hall', 'hall-2'])).toBe('hall-3');
  expect(freeName('new', [])).toBe('new-2');
  expect(freeName('', [])).toBe('world');
});
