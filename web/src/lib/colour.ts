/** The colour scale of utilities, the same as in the arena's pictures. */

import type { ThemeName } from './protocol';

type Rgb = [number, number, number];

/** Viridis at nine even steps: lightness grows evenly, so it also reads without colour vision. */
const VIRIDIS: Rgb[] = [
  [0x44, 0x01, 0x54],
  [0x47, 0x2d, 0x7b],
  [0x3b, 0x52, 0x8b],
  [0x2c, 0x72, 0x8e],
  [0x21, 0x91, 0x8c],
  [0x28, 0xae, 0x80],
  [0x5e, 0xc9, 0x62],
  [0xad, 0xdc, 0x30],
  [0xfd, 0xe7, 0x25],
];

/** The part of the scale that is used on each ground. */
const PART: Record<ThemeName, [number, number]> = { light: [0, 0.97], dark: [0.2, 1] };

/** Place of a utility between the least and the greatest, 0 to 1; 1 when all are equal. */
export function share(utility: number, least: number, greatest: number): number {
  if (!(greatest > least)) return 1;
  return Math.min(1, Math.max(0, (utility - least) / (greatest - least)));
}

/** CSS colour at a place of the scale, 0 (worst) to 1 (best). */
export function colour(place: number, theme: ThemeName): string {
  const [worst, best] = PART[theme];
  const at = (worst + (best - worst) * Math.min(1, Math.max(0, place))) * (VIRIDIS.length - 1);
  const low = Math.min(Math.floor(at), VIRIDIS.length - 2);
  const [from, to] = [VIRIDIS[low], VIRIDIS[low + 1]];
  if (!from || !to) return 'currentColor';
  const mixed = from.map((part, index) =>
    Math.round(part + (at - low) * ((to[index] ?? part) - part)),
  );
  return `rgb(${mixed.join(' ')})`;
}
