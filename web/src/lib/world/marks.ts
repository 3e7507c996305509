/** What stands on the plan of a world: robot, goal, region lines, problems, the scale. */

import { brief } from '../format';
import type { Ink } from '../ink';
import type { Scene } from './draw';
import { headingHandle, radiusHandle, shapeHandles, shownLines } from './grips';
import { isShape } from './shapes';
import { gridStep_m, toScreen, type Point } from './view';

type Context = CanvasRenderingContext2D;

/** The robot at home in its true size, its heading and the handle that turns it. */
export function drawHome(context: Context, scene: Scene, ink: Ink): void {
  const { draft, view, size, robotRadius_m, chosen } = scene;
  const at = toScreen(view, size, [draft.home.x, draft.home.y]);
  const handle = headingHandle(scene);
  context.strokeStyle = ink.accent;
  context.fillStyle = ink.accentWeak;
  context.lineWidth = chosen?.kind === 'home' ? 3 : 2;
  circle(context, at, Math.max(5, robotRadius_m * view.scale));
  context.fill();
  context.stroke();
  stroke(context, at, handle);
  grip(context, handle, ink, ink.accent);
  context.textAlign = 'center';
  context.textBaseline = 'top';
  const below = at[1] + Math.max(5, robotRadius_m * view.scale) + 5;
  label(context, 'home', at[0], below, ink.text, ink.surface);
}

/** The goal's circle and the handle that widens it. */
export function drawGoal(context: Context, scene: Scene, ink: Ink): void {
  const { draft, view, size, chosen } = scene;
  const at = toScreen(view, size, [draft.goal.x, draft.goal.y]);
  context.strokeStyle = ink.warn;
  context.fillStyle = ink.warnWeak;
  context.lineWidth = chosen?.kind === 'goal' ? 3 : 2;
  circle(context, at, Math.max(3, draft.goal.radius_m * view.scale));
  context.globalAlpha = 0.6;
  context.fill();
  context.globalAlpha = 1;
  context.setLineDash([5, 3]);
  context.stroke();
  context.setLineDash([]);
  cross(context, at, 5);
  grip(context, radiusHandle(scene), ink, ink.warn);
  context.textAlign = 'center';
  context.textBaseline = 'bottom';
  label(context, 'goal', at[0], at[1] - 7, ink.text, ink.surface);
}

/** The chosen region's lines, each with an arrow to the side where its rule holds. */
export function drawLines(context: Context, scene: Scene, ink: Ink): void {
  const { chosen, view, size } = scene;
  for (const { rule, ends, arrow } of shownLines(scene)) {
    const [from, to] = ends.map((end) => toScreen(view, size, end)) as [Point, Point];
    context.strokeStyle = ink.accent;
    context.lineWidth = chosen?.kind === 'line' && chosen.rule === rule ? 3 : 1.5;
    context.setLineDash([8, 4]);
    stroke(context, from, to);
    context.setLineDash([]);
    drawArrow(context, arrow, ink);
  }
  if (!scene.stroke) return;
  const [from, to] = scene.stroke.map((end) => toScreen(view, size, end)) as [Point, Point];
  context.strokeStyle = ink.accent;
  context.lineWidth = 3;
  if (scene.drawsBlock) {
    context.strokeRect(from[0], from[1], to[0] - from[0], to[1] - from[1]);
  } else {
    stroke(context, from, to);
  }
}

/** The points of the chosen shape, and, smaller, the places for new ones. */
export function drawHandles(context: Context, scene: Scene, ink: Ink): void {
  const { chosen } = scene;
  for (const { grip: held, at } of shapeHandles(scene)) {
    const isNew = held.kind === 'between';
    const isChosen = isShape(chosen) && isShape(held) && held.point === chosen.point;
    context.fillStyle = isChosen ? ink.accent : ink.surface;
    context.strokeStyle = ink.accent;
    context.lineWidth = isNew ? 1.5 : 2;
    circle(context, at, isNew ? 3.5 : 5.5);
    context.fill();
    context.stroke();
  }
}

function drawArrow(context: Context, [from, tip]: [Point, Point], ink: Ink): void {
  context.lineWidth = 2;
  stroke(context, from, tip);
  grip(context, tip, ink, ink.accent);
}

/** Problems at their places, numbered as in the list. */
export function drawMarks(context: Context, scene: Scene, ink: Ink): void {
  const { view, size } = scene;
  // Wide enough to be seen round the robot.
  const reach = Math.max(22, scene.robotRadius_m * view.scale + 7);
  for (const { number, at, nearest } of scene.marks) {
    const [x, y] = toScreen(view, size, at);
    if (nearest) drawNearest(context, [x, y], toScreen(view, size, nearest), ink);
    context.strokeStyle = ink.bad;
    context.lineWidth = 2.5;
    circle(context, [x, y], reach);
    context.stroke();
    const badge: Point = [x + 0.75 * reach, y - 0.75 * reach];
    context.fillStyle = ink.bad;
    circle(context, badge, 10);
    context.fill();
    context.fillStyle = ink.surface;
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.font = `bold ${ink.font}`;
    context.fillText(String(number), ...badge);
    context.font = ink.font;
  }
}

function drawNearest(context: Context, from: Point, to: Point, ink: Ink): void {
  context.strokeStyle = ink.bad;
  context.lineWidth = 1.5;
  context.setLineDash([3, 3]);
  stroke(context, from, to);
  context.setLineDash([]);
  cross(context, to, 6);
  context.textAlign = 'center';
  context.textBaseline = 'top';
  label(context, 'nearest reachable point', to[0], to[1] + 9, ink.bad, ink.surface);
}

/** A bar as long as a cell of the grid. */
export function drawScale(context: Context, { view, size }: Scene, ink: Ink): void {
  const step_m = gridStep_m(view.scale);
  const [x, y] = [14, size.height - 14];
  const length = step_m * view.scale;
  context.strokeStyle = ink.text;
  context.lineWidth = 2;
  context.beginPath();
  context.moveTo(x, y - 4);
  context.lineTo(x, y);
  context.lineTo(x + length, y);
  context.lineTo(x + length, y - 4);
  context.stroke();
  context.textAlign = 'left';
  context.textBaseline = 'bottom';
  label(context, `${brief(step_m)} m`, x + 5, y - 3, ink.text, ink.surface);
}

/** Text with a rim of the ground's colour, so that it can be read on anything. */
export function label(
  context: Context,
  text: string,
  x: number,
  y: number,
  fill: string,
  rim: string,
): void {
  context.lineWidth = 3;
  context.lineJoin = 'round';
  context.strokeStyle = rim;
  context.strokeText(text, x, y);
  context.fillStyle = fill;
  context.fillText(text, x, y);
}

function grip(context: Context, at: Point, ink: Ink, colour: string): void {
  context.fillStyle = ink.surface;
  context.strokeStyle = colour;
  context.lineWidth = 2;
  circle(context, at, 5.5);
  context.fill();
  context.stroke();
}

function circle(context: Context, [x, y]: Point, radius: number): void {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
}

function stroke(context: Context, from: Point, to: Point): void {
  context.beginPath();
  context.moveTo(...from);
  context.lineTo(...to);
  context.stroke();
}

function cross(context: Context, [x, y]: Point, reach: number): void {
  context.lineWidth = 2;
  context.beginPath();
  context.moveTo(x - reach, y);
  context.lineTo(x + reach, y);
  context.moveTo(x, y - reach);
  context.lineTo(x, y + reach);
  context.stroke();
}
