/** The colour scale of utilities. Numbers, shapes and the legend carry the same meaning. */

import type { ThemeName } from './protocol';

type Rgb = [number, number, number];

/** From worst to best; lightness changes steadily, so it also reads without colour vision. */
const STOPS: Record<ThemeName, Rgb[]> = {
  light: [
    [122, 20, 74],
    [186, 60, 64],
    [190, 110, 20],
    [92, 128, 44],
    [0, 122, 128],
  ],
  dark: [
    [176, 92, 150],
    [222, 110, 116],
    [232, 164, 84],
    [176, 206, 104],
    [108, 226, 216],
  ],
};

/** Place of a utility between the least and the greatest, 0 to 1; 1 when all are equal. */
export function share(utility: number, least: number, greatest: number): number {
  if (!(greatest > least)) return 1;
  return Math.min(1, Math.max(0, (utility - least) / (greatest - least)));
}

/** CSS colour at a place of the scale, 0 (worst) to 1 (best). */
export function colour(place: number, theme: ThemeName): string {
  const stops = STOPS[theme];
  const at = Math.min(1, Math.max(0, place)) * (stops.length - 1);
  const low = Math.min(Math.floor(at), stops.length - 2);
  const [from, to] = [stops[low], stops[low + 1]];
  if (!from || !to) return 'currentColor';
  const mixed = from.map((part, index) =>
    Math.round(part + (at - low) * ((to[index] ?? part) - part)),
  );
  return `rgb(${mixed.join(' ')})`;
}
