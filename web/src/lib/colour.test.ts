import { describe, expect, it } from 'vitest';

import { colour, share } from './colour';
import type { ThemeName } from './protocol';

const GROUND: Record<ThemeName, string> = { light: 'rgb(255 255 255)', dark: 'rgb(22 29 38)' };

/** Relative luminance, WCAG 2.2. */
function luminance(css: string): number {
  const [r = 0, g = 0, b = 0] = (css.match(/\d+/g) ?? []).map((part) => {
    const value = Number(part) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

function contrast(a: string, b: string): number {
  const [low = 0, high = 0] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
}

describe('the colour scale of utilities', () => {
  it('places a utility between the least and the greatest', () => {
    expect([-8, -4, 0, -9, 1].map((u) => share(u, -8, 0))).toEqual([0, 0.5, 1, 0, 1]);
    expect(share(-3, -3, -3)).toBe(1);
  });

  it('gives its ends and mixes between', () => {
    expect(colour(0, 'light')).toBe('rgb(122 20 74)');
    expect(colour(1, 'light')).toBe('rgb(0 122 128)');
    expect(colour(0.125, 'light')).toBe('rgb(154 40 69)');
    expect(colour(7, 'light')).toBe(colour(1, 'light'));
  });

  it.each<ThemeName>(['light', 'dark'])('stands out from the %s ground everywhere', (theme) => {
    for (let place = 0; place <= 1; place += 0.05) {
      expect(contrast(colour(place, theme), GROUND[theme])).toBeGreaterThan(3);
    }
  });
});
