/** Colours of heat maps: two hues that part at a middle, and one for chances. */

import type { ThemeName } from '../protocol';

type Rgb = [number, number, number];

/** Least, middle and greatest of what is coloured. */
export interface Span {
  least: number;
  middle: number;
  greatest: number;
}

/** A colour and what can be read on it. */
export interface Shade {
  ground: string;
  ink: string;
}

/** Blue below, orange above: told apart without colour vision, and by lightness from the middle. */
const ENDS: Record<ThemeName, { low: Rgb; middle: Rgb; high: Rgb }> = {
  light: { low: [52, 118, 178], middle: [250, 250, 250], high: [222, 130, 44] },
  dark: { low: [84, 160, 220], middle: [34, 41, 51], high: [226, 142, 58] },
};

/** Of chances, from 0 to 1. */
const CHANCE: Record<ThemeName, [Rgb, Rgb]> = {
  light: [
    [255, 255, 255],
    [94, 176, 204],
  ],
  dark: [
    [18, 22, 28],
    [34, 116, 146],
  ],
};

const DARK_INK = '#000000';
const LIGHT_INK = '#ffffff';

/** The span of values: parted at 0 where they have both signs, else in the middle of them. */
export function spanOf(values: (number | null)[]): Span | null {
  let [least, greatest] = [Infinity, -Infinity];
  for (const value of values) {
    if (value === null || !Number.isFinite(value)) continue;
    least = Math.min(least, value);
    greatest = Math.max(greatest, value);
  }
  if (least > greatest) return null;
  const middle = least < 0 && greatest > 0 ? 0 : (least + greatest) / 2;
  return { least, middle, greatest };
}

/** Place of a value in a span, −1 (least) to 1 (greatest). */
export function placeOf(value: number, { least, middle, greatest }: Span): number {
  const room = value < middle ? middle - least : greatest - middle;
  if (!(room > 0)) return 0;
  return Math.max(-1, Math.min(1, (value - middle) / room));
}

/** The shade at a place, −1 to 1. */
export function diverging(place: number, theme: ThemeName): Shade {
  const { low, middle, high } = ENDS[theme];
  return shade(mix(middle, place < 0 ? low : high, Math.abs(place)));
}

/** The shade of a chance, 0 to 1. */
export function ofChance(chance: number, theme: ThemeName): Shade {
  const [none, sure] = CHANCE[theme];
  return shade(mix(none, sure, Math.max(0, Math.min(1, chance))));
}

/** The dark or the light ink, whichever stands out more from a colour given as `rgb(r g b)`. */
export function inkOn(ground: string): string {
  const parts = ground.match(/[\d.]+/g)?.map(Number) ?? [];
  return contrastInk([parts[0] ?? 0, parts[1] ?? 0, parts[2] ?? 0]);
}

function shade(colour: Rgb): Shade {
  return { ground: `rgb(${colour.join(' ')})`, ink: contrastInk(colour) };
}

function mix(from: Rgb, to: Rgb, share: number): Rgb {
  return from.map((part, index) => Math.round(part + share * ((to[index] ?? part) - part))) as Rgb;
}

function contrastInk(colour: Rgb): string {
  const light = luminance(colour);
  // WCAG contrast: (lighter + 0.05) / (darker + 0.05). One of black and white always has 4.58 or more.
  return (light + 0.05) / 0.05 >= 1.05 / (light + 0.05) ? DARK_INK : LIGHT_INK;
}

/** Relative luminance of an sRGB colour, 0 to 1. */
export function luminance(colour: Rgb): number {
  const [r, g, b] = colour.map((part) => {
    const share = part / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  }) as Rgb;
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}
