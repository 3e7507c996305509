import { expect, it } from 'vitest';

import { begun, edited, redone, settled, undone } from './trail';

it('goes back and forth', () => {
  const trail = edited(edited(begun(1), 2), 3);
  expect(undone(trail).present).toBe(2);
  expect(undone(undone(trail)).present).toBe(1);
  expect(redone(undone(trail)).present).toBe(3);
  expect(undone(begun(1)).present).toBe(1);
  expect(redone(trail).present).toBe(3);
});

it('forgets what was undone when something new is done', () => {
  const trail = edited(undone(edited(begun(1), 2)), 5);
  expect(redone(trail).present).toBe(5);
  expect(undone(trail).present).toBe(1);
});

it('takes the edits of one drag as one step', () => {
  let trail = begun(0);
  for (const at of [1, 2, 3]) trail = edited(trail, at, 'home');
  expect(undone(trail).present).toBe(0);
  trail = edited(settled(trail), 4, 'home');
  expect(undone(trail).present).toBe(3);
  trail = edited(trail, 5, 'goal');
  expect(undone(trail).present).toBe(4);
});

it('does not count an edit that changes nothing', () => {
  const trail = begun('a');
  expect(edited(trail, 'a')).toBe(trail);
});

it('keeps a bounded past', () => {
  let trail = begun(0);
  for (let at = 1; at <= 1000; at += 1) trail = edited(trail, at);
  expect(trail.past).toHaveLength(200);
});
