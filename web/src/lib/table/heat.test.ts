import { describe, expect, it } from 'vitest';

import { diverging, inkOn, luminance, ofChance, placeOf, spanOf } from './heat';

const rgb = (css: string) => css.match(/\d+/g)!.map(Number) as [number, number, number];
const contrast = (ground: string, ink: string) => {
  const [a, b] = [luminance(rgb(ground)), ink === '#000000' ? 0 : 1];
  return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
};

describe('the span of values', () => {
  it.each([
    ['both signs part at 0', [-1, 3, null], { least: -1, middle: 0, greatest: 3 }],
    ['one sign in the middle', [2, null, 4], { least: 2, middle: 3, greatest: 4 }],
    ['what is not finite is left out', [1, Infinity, NaN], { least: 1, middle: 1, greatest: 1 }],
    ['nothing', [null], null],
  ])('%s', (_, values, span) => {
    expect(spanOf(values)).toEqual(span);
  });

  it('is a scale from −1 to 1, each side by its own length', () => {
    const span = { least: -1, middle: 0, greatest: 4 };
    expect([-1, -0.5, 0, 2, 4, 9].map((value) => placeOf(value, span))).toEqual([
      -1, -0.5, 0, 0.5, 1, 1,
    ]);
    expect(placeOf(7, { least: 7, middle: 7, greatest: 7 })).toBe(0);
  });
});

it('has the luminance of the standard', () => {
  expect(luminance([255, 255, 255])).toBeCloseTo(1);
  expect(luminance([0, 0, 0])).toBe(0);
  // WCAG 2: #777777 on white has a contrast of 4.48.
  expect(1.05 / (luminance([119, 119, 119]) + 0.05)).toBeCloseTo(4.48, 2);
});

it.each(['light', 'dark'] as const)('can be read everywhere in the %s theme', (theme) => {
  for (let place = -1; place <= 1; place += 0.05) {
    const shade = diverging(place, theme);
    expect(contrast(shade.ground, shade.ink)).toBeGreaterThanOrEqual(4.5);
    const chance = ofChance(Math.abs(place), theme);
    expect(contrast(chance.ground, chance.ink)).toBeGreaterThanOrEqual(4.5);
  }
});

it('tells least from greatest by lightness of the blue and red parts', () => {
  const [least, greatest] = [rgb(diverging(-1, 'light').ground), rgb(diverging(1, 'light').ground)];
  expect(least[2]).toBeGreaterThan(least[0]);
  expect(greatest[0]).toBeGreaterThan(greatest[2]);
});

it('writes dark on light and light on dark', () => {
  expect([inkOn('rgb(253 231 37)'), inkOn('rgb(68 1 84)')]).toEqual(['#000000', '#ffffff']);
});
