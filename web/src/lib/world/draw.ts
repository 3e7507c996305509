/** The drawing of a world that is edited. */

import { colour } from '../colour';
import type { Ink } from '../ink';
import type { ThemeName } from '../protocol';
import { drawGoal, drawHandles, drawHome, drawLines, drawMarks, drawScale, label } from './marks';
import type { Draft } from './draft';
import type { Mark } from './faults';
import { seen, type Plan } from './grips';
import { isShape, pointsOf } from './shapes';
import type { MapPicture, RegionShape } from '../protocol';
import { gridStep_m, toScreen, type Point } from './view';

/** Everything that is drawn. */
export interface Scene extends Plan {
  theme: ThemeName;
  shapes: RegionShape[];
  /** The map the walls were traced from, drawn below them, and where it lies. */
  picture: Underlay | null;
  /** How much of the picture is seen, 0 to 1. */
  opacity: number;
  marks: Mark[];
  /** A line that is being drawn, in the world. */
  stroke: [Point, Point] | null;
  /** It is the diagonal of a block. */
  drawsBlock: boolean;
}

/** A picture in the world. */
export interface Underlay {
  image: HTMLImageElement;
  /** As it travels. */
  picture: MapPicture;
  /** Its lower left corner, and how it is turned about it, counter-clockwise. */
  corner: Point;
  turn_deg: number;
  width_m: number;
  height_m: number;
}

type Context = CanvasRenderingContext2D;

/** Draws the whole scene. */
export function drawScene(context: Context, scene: Scene, ink: Ink): void {
  const { width, height } = scene.size;
  context.fillStyle = ink.surface;
  context.fillRect(0, 0, width, height);
  context.font = ink.font;
  if (scene.picture) drawPicture(context, scene, scene.picture);
  drawGrid(context, scene, ink);
  drawRegions(context, scene);
  drawSolid(context, scene, ink);
  drawLines(context, scene, ink);
  drawGoal(context, scene, ink);
  drawHome(context, scene, ink);
  drawHandles(context, scene, ink);
  drawRegionNames(context, scene, ink);
  drawMarks(context, scene, ink);
  drawScale(context, scene, ink);
}

/** Draws in metres, x to the right and y up, until `restore`. */
function inWorld(context: Context, { view, size }: Plan): void {
  context.save();
  context.translate(size.width / 2, size.height / 2);
  context.scale(view.scale, -view.scale);
  context.translate(-view.x_m, -view.y_m);
}

function drawPicture(context: Context, scene: Scene, underlay: Underlay): void {
  const { image, corner, turn_deg, width_m, height_m } = underlay;
  inWorld(context, scene);
  context.translate(...corner);
  context.rotate((turn_deg * Math.PI) / 180);
  context.scale(1, -1);
  context.imageSmoothingEnabled = false;
  context.globalAlpha = scene.opacity;
  context.drawImage(image, 0, -height_m, width_m, height_m);
  if (scene.theme === 'dark') {
    // White floors would glare: what is white becomes black and the other way round.
    context.globalAlpha = 1;
    context.globalCompositeOperation = 'difference';
    const level = Math.round(255 * scene.opacity);
    context.fillStyle = `rgb(${level} ${level} ${level})`;
    context.fillRect(0, -height_m, width_m, height_m);
  }
  context.restore();
}

function drawGrid(context: Context, scene: Scene, ink: Ink): void {
  const [x0, y0, x1, y1] = seen(scene);
  const step_m = gridStep_m(scene.view.scale);
  context.strokeStyle = ink.line;
  context.lineWidth = 1;
  context.globalAlpha = 0.55;
  context.beginPath();
  for (let x = Math.ceil(x0 / step_m); x * step_m <= x1; x += 1) {
    const at = Math.round(toScreen(scene.view, scene.size, [x * step_m, 0])[0]) + 0.5;
    context.moveTo(at, 0);
    context.lineTo(at, scene.size.height);
  }
  for (let y = Math.ceil(y0 / step_m); y * step_m <= y1; y += 1) {
    const at = Math.round(toScreen(scene.view, scene.size, [0, y * step_m])[1]) + 0.5;
    context.moveTo(0, at);
    context.lineTo(scene.size.width, at);
  }
  context.stroke();
  context.globalAlpha = 1;
}

function drawRegions(context: Context, scene: Scene): void {
  const { shapes, region, theme } = scene;
  if (shapes.length < 2) return;
  shapes.forEach(({ polygons_m }, index) => {
    inWorld(context, scene);
    context.fillStyle = colour(index / (shapes.length - 1), theme);
    context.globalAlpha = index === region ? 0.34 : 0.13;
    context.fill(ringsPath(polygons_m));
    context.restore();
  });
}

function drawRegionNames(context: Context, scene: Scene, ink: Ink): void {
  const { shapes, region } = scene;
  if (shapes.length < 2) return;
  shapes.forEach(({ name, polygons_m }, index) => {
    const largest = polygons_m.toSorted((p, q) => area_m2(q) - area_m2(p))[0];
    if (!largest) return;
    const [x, y] = toScreen(scene.view, scene.size, middle(largest));
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    label(context, name, x, y, index === region ? ink.text : ink.muted, ink.surface);
  });
}

function drawSolid(context: Context, scene: Scene, ink: Ink): void {
  const { draft, view } = scene;
  inWorld(context, scene);
  context.fillStyle = ink.strong;
  context.strokeStyle = ink.strong;
  context.lineJoin = 'round';
  context.lineCap = 'round';
  context.lineWidth = 2 / view.scale;
  if (draft.floor.length > 0) {
    const off = new Path2D(ringsPath(draft.floor));
    const [x0, y0, x1, y1] = seen(scene);
    off.rect(x0 - 1, y0 - 1, x1 - x0 + 2, y1 - y0 + 2);
    context.globalAlpha = scene.picture ? 0.16 : 0.22;
    context.fill(off, 'evenodd');
    context.globalAlpha = 1;
    context.stroke(ringsPath(draft.floor));
  }
  context.globalAlpha = 0.4;
  context.fill(ringsPath(draft.blocks));
  context.globalAlpha = 1;
  context.stroke(ringsPath(draft.blocks));
  context.stroke(linesPath(draft.walls));
  const chosen = isShape(scene.chosen) ? scene.chosen : null;
  if (chosen) {
    context.strokeStyle = ink.accent;
    context.lineWidth = 5 / view.scale;
    context.stroke(pathOf([pointsOf(draft, chosen)], chosen.kind !== 'wall'));
  }
  context.restore();
}

/** Paths in metres of lists that never change, made once: a traced map has thousands of pieces. */
const paths = new WeakMap<Point[][], Path2D>();

function ringsPath(rings: Draft['blocks']): Path2D {
  return pathOf(rings, true);
}

function linesPath(lines: Draft['walls']): Path2D {
  return pathOf(lines, false);
}

function pathOf(lines: Point[][], closed: boolean): Path2D {
  const known = paths.get(lines);
  if (known) return known;
  const path = new Path2D();
  for (const line of lines) {
    line.forEach(([x, y], index) => (index === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
    if (closed) path.closePath();
  }
  paths.set(lines, path);
  return path;
}

function area_m2(polygon: Point[]): number {
  const twice = polygon.reduce((sum, [x, y], index) => {
    const [u, v] = polygon[(index + 1) % polygon.length] ?? [x, y];
    return sum + x * v - y * u;
  }, 0);
  return Math.abs(twice) / 2;
}

function middle(polygon: Point[]): Point {
  const sum = polygon.reduce<Point>(([u, v], [x, y]) => [u + x, v + y], [0, 0]);
  return [sum[0] / polygon.length, sum[1] / polygon.length];
}
