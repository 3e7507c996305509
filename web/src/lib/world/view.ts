/** Where the plan of a world lies on its canvas: pan, zoom and pinch. */

/** A place in the world, metres, or on the canvas, pixels. */
export type Point = [number, number];

/** Least and greatest x and y, metres: `[x0, y0, x1, y1]`. */
export type Bounds = [number, number, number, number];

/** Width and height of the canvas, pixels. */
export interface Size {
  width: number;
  height: number;
}

/** What is seen: the place at the middle of the canvas, and pixels per metre. x to the right, y up. */
export interface View {
  x_m: number;
  y_m: number;
  scale: number;
}

/** Pixels per metre that zooming stops at. */
export const SCALES: [number, number] = [1, 4000];

/** The view that shows all of some bounds, with a margin in pixels. */
export function fitted(bounds: Bounds, size: Size, margin = 36): View {
  const [x0, y0, x1, y1] = bounds;
  const across = Math.max(1, size.width - 2 * margin) / Math.max(1e-3, x1 - x0);
  const up = Math.max(1, size.height - 2 * margin) / Math.max(1e-3, y1 - y0);
  return { x_m: (x0 + x1) / 2, y_m: (y0 + y1) / 2, scale: clamped(Math.min(across, up)) };
}

/** Where a place of the world lies on the canvas. */
export function toScreen(view: View, size: Size, [x_m, y_m]: Point): Point {
  return [
    size.width / 2 + (x_m - view.x_m) * view.scale,
    size.height / 2 - (y_m - view.y_m) * view.scale,
  ];
}

/** The place of the world at a point of the canvas. */
export function toWorld(view: View, size: Size, [x, y]: Point): Point {
  return [
    view.x_m + (x - size.width / 2) / view.scale,
    view.y_m - (y - size.height / 2) / view.scale,
  ];
}

/** The view moved with the hand: what was at a point lies `dx`, `dy` pixels farther. */
export function panned(view: View, dx: number, dy: number): View {
  return { ...view, x_m: view.x_m - dx / view.scale, y_m: view.y_m + dy / view.scale };
}

/** Zooms by a factor; what is at a point of the canvas stays there. */
export function zoomed(view: View, size: Size, at: Point, factor: number): View {
  const [x_m, y_m] = toWorld(view, size, at);
  const scale = clamped(view.scale * factor);
  const rest = view.scale / scale;
  return { x_m: x_m + (view.x_m - x_m) * rest, y_m: y_m + (view.y_m - y_m) * rest, scale };
}

/** Follows two fingers: what was between them stays between them. */
export function pinched(
  view: View,
  size: Size,
  before: [Point, Point],
  after: [Point, Point],
): View {
  const [from, to] = [middle(before), middle(after)];
  const factor = span(after) / Math.max(1, span(before));
  return zoomed(panned(view, to[0] - from[0], to[1] - from[1]), size, to, factor);
}

/** Metres between the lines of the grid: 1, 2 or 5 times a power of ten, at least 48 pixels. */
export function gridStep_m(scale: number): number {
  const least_m = 48 / scale;
  const power = 10 ** Math.floor(Math.log10(least_m));
  const found = [1, 2, 5, 10].find((times) => times * power >= least_m * (1 - 1e-9));
  return (found ?? 10) * power;
}

const clamped = (scale: number) => Math.min(SCALES[1], Math.max(SCALES[0], scale));

const middle = ([a, b]: [Point, Point]): Point => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];

const span = ([a, b]: [Point, Point]) => Math.hypot(a[0] - b[0], a[1] - b[1]);
