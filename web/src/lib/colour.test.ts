import { describe, expect, it } from 'vitest';

import { colour, share } from './colour';
import type { ThemeName } from './protocol';

/** Perceived lightness, roughly. */
function lightness(css: string): number {
  const [r = 0, g = 0, b = 0] = (css.match(/\d+/g) ?? []).map(Number);
  return 0.3 * r + 0.59 * g + 0.11 * b;
}

describe('the colour scale of utilities', () => {
  it('places a utility between the least and the greatest', () => {
    expect([-8, -4, 0, -9, 1].map((u) => share(u, -8, 0))).toEqual([0, 0.5, 1, 0, 1]);
    expect(share(-3, -3, -3)).toBe(1);
  });

  it('uses the part of viridis that stands out from the ground', () => {
    expect(colour(0, 'light')).toBe('rgb(68 1 84)');
    expect(colour(1, 'dark')).toBe('rgb(253 231 37)');
    expect(colour(0, 'dark')).toBe('rgb(64 67 133)');
    expect(colour(7, 'light')).toBe(colour(1, 'light'));
  });

  it.each<ThemeName>(['light', 'dark'])('only grows lighter towards the best, %s', (theme) => {
    const course = Array.from({ length: 21 }, (_, index) => lightness(colour(index / 20, theme)));
    expect(course).toEqual(course.toSorted((a, b) => a - b));
  });
});
