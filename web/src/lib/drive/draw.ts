/** The course on a canvas: surfaces, path, people, the robot and what its sonars hear. */

import type { Ink } from '../ink';
import type { CourseView, CycleView } from '../protocol';
import { echoInk, echoKind, isMarked } from './echoes';
import { cone, fit, inWorld, onCanvas, shownOf, tip, type Fit, type Point } from './geometry';
import type { Trail } from './trail';

/** What is drawn. */
export interface Scene {
  course: CourseView;
  /** The present cycle; none before the first. */
  cycle: CycleView | null;
  trail: Trail | null;
}

/** Marks are drawn on a grid of 8 by 8. */
const MARK_SCALE = 0.95;

/** Draws a course, as much of it as is shown, over the whole canvas. */
export function drawCourse(
  context: CanvasRenderingContext2D,
  { course, cycle, trail }: Scene,
  width: number,
  height: number,
  ink: Ink,
): void {
  const at = fit(shownOf(course, cycle?.pose ?? null), width, height);
  drawScale(context, at, height, ink);
  if (cycle) drawCones(context, course, cycle, at, ink);
  drawFinish(context, course, at, ink);
  drawFaces(context, course, at, ink);
  if (trail) drawTrail(context, trail, at, ink);
  if (!cycle) return;
  drawPeople(context, course, cycle, at, ink);
  drawRobot(context, course, cycle, at, ink);
  drawMarks(context, course, cycle, at, ink);
}

/** Draws the mark of a kind of reading around a place. */
export function drawMark(
  context: CanvasRenderingContext2D,
  echo: string,
  [x, y]: Point,
  ink: Ink,
  scale = MARK_SCALE,
): void {
  context.save();
  context.translate(x, y);
  context.scale(scale, scale);
  const path = new Path2D(echoKind(echo).mark);
  context.strokeStyle = ink.surface;
  context.lineWidth = 4.5;
  context.stroke(path);
  context.strokeStyle = echoInk(echo, ink);
  context.lineWidth = 2;
  context.stroke(path);
  context.restore();
}

function trace(
  context: CanvasRenderingContext2D,
  points: Point[],
  at: Fit,
  isClosed: boolean,
): void {
  context.beginPath();
  points.forEach((point, index) => {
    const [x, y] = onCanvas(at, point);
    if (index === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  });
  if (isClosed) context.closePath();
}

/** A metre, so that lengths can be judged. */
function drawScale(context: CanvasRenderingContext2D, at: Fit, height: number, ink: Ink): void {
  const [x, y] = [12, height - 10];
  context.strokeStyle = context.fillStyle = ink.muted;
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(x, y - 4);
  context.lineTo(x, y);
  context.lineTo(x + at.scale, y);
  context.lineTo(x + at.scale, y - 4);
  context.stroke();
  context.font = ink.font;
  context.textAlign = 'left';
  context.textBaseline = 'alphabetic';
  context.fillText('1 m', x + at.scale + 5, y + 1);
}

function drawFaces(context: CanvasRenderingContext2D, course: CourseView, at: Fit, ink: Ink): void {
  fillBlocks(context, course, at, ink);
  context.lineCap = 'round';
  for (const { segment_m, surface } of course.faces) {
    const [x0, y0, x1, y1] = segment_m;
    context.strokeStyle = surface === 'door' ? ink.warn : ink.strong;
    context.lineWidth = surface === 'door' ? 3.5 : 2.5;
    trace(
      context,
      [
        [x0, y0],
        [x1, y1],
      ],
      at,
      false,
    );
    context.stroke();
  }
  context.lineCap = 'butt';
}

/** Blocks are solid; their faces follow one another around them. */
function fillBlocks(
  context: CanvasRenderingContext2D,
  course: CourseView,
  at: Fit,
  ink: Ink,
): void {
  context.fillStyle = ink.line;
  context.beginPath();
  let end: Point | null = null;
  for (const { segment_m, surface } of course.faces) {
    if (surface !== 'block') continue;
    const [x0, y0, x1, y1] = segment_m;
    const isNext = end && Math.hypot(end[0] - x0, end[1] - y0) < 1e-6;
    if (!isNext) context.moveTo(...onCanvas(at, [x0, y0]));
    context.lineTo(...onCanvas(at, [x1, y1]));
    end = [x1, y1];
  }
  context.fill();
}

function drawFinish(
  context: CanvasRenderingContext2D,
  course: CourseView,
  at: Fit,
  ink: Ink,
): void {
  if (course.finish_m === null) return;
  const [, y0, , y1] = course.bounds_m;
  context.strokeStyle = ink.good;
  context.lineWidth = 2;
  context.setLineDash([6, 4]);
  trace(
    context,
    [
      [course.finish_m, y0],
      [course.finish_m, y1],
    ],
    at,
    false,
  );
  context.stroke();
  context.setLineDash([]);
}

function drawCones(
  context: CanvasRenderingContext2D,
  course: CourseView,
  { pose, readings }: CycleView,
  at: Fit,
  ink: Ink,
): void {
  for (const [index, { range_m, echo }] of readings.entries()) {
    const sonar = course.sonars[index];
    if (!sonar || echo === 'silent') continue;
    const colour = echoInk(echo, ink);
    const outline = cone(sonar, course.half_cone_deg, range_m).map((point) => inWorld(pose, point));
    trace(context, outline, at, true);
    context.globalAlpha = echo === 'none' || echo === 'dropped' ? 0.07 : 0.16;
    context.fillStyle = colour;
    context.fill();
    context.globalAlpha = 0.8;
    context.strokeStyle = colour;
    context.lineWidth = 1.5;
    // Only the arc at the reading is a statement of the sonar.
    trace(context, outline.slice(1), at, false);
    context.stroke();
    context.globalAlpha = 1;
  }
}

function drawMarks(
  context: CanvasRenderingContext2D,
  course: CourseView,
  { pose, readings }: CycleView,
  at: Fit,
  ink: Ink,
): void {
  for (const [index, { range_m, echo }] of readings.entries()) {
    const sonar = course.sonars[index];
    if (!sonar || !isMarked(echo)) continue;
    const reach = echo === 'silent' ? 0 : range_m;
    drawMark(context, echo, onCanvas(at, inWorld(pose, tip(sonar, reach))), ink);
  }
}

function drawTrail(context: CanvasRenderingContext2D, trail: Trail, at: Fit, ink: Ink): void {
  context.strokeStyle = ink.accent;
  context.lineWidth = 2;
  context.lineJoin = 'round';
  context.beginPath();
  trail.spots.forEach(({ x_m, y_m, isGap }, index) => {
    const [x, y] = onCanvas(at, [x_m, y_m]);
    if (index === 0 || isGap) context.moveTo(x, y);
    else context.lineTo(x, y);
  });
  context.stroke();
  for (const { x_m, y_m } of trail.bumps) {
    const [x, y] = onCanvas(at, [x_m, y_m]);
    context.strokeStyle = ink.bad;
    context.lineWidth = 2.5;
    context.beginPath();
    context.moveTo(x - 5, y - 5);
    context.lineTo(x + 5, y + 5);
    context.moveTo(x - 5, y + 5);
    context.lineTo(x + 5, y - 5);
    context.stroke();
  }
}

function drawPeople(
  context: CanvasRenderingContext2D,
  course: CourseView,
  { people_m }: CycleView,
  at: Fit,
  ink: Ink,
): void {
  for (const person of people_m) {
    const [x, y] = onCanvas(at, person);
    context.beginPath();
    context.arc(x, y, Math.max(3, at.scale * course.person_radius_m), 0, 2 * Math.PI);
    context.fillStyle = ink.goodWeak;
    context.strokeStyle = ink.good;
    context.lineWidth = 2;
    context.fill();
    context.stroke();
  }
}

function drawRobot(
  context: CanvasRenderingContext2D,
  course: CourseView,
  { pose, bump, backing_off }: CycleView,
  at: Fit,
  ink: Ink,
): void {
  const isTroubled = bump !== null || backing_off;
  trace(
    context,
    course.robot_corners_m.map((corner) => inWorld(pose, corner)),
    at,
    true,
  );
  context.fillStyle = isTroubled ? ink.warnWeak : ink.surface;
  context.strokeStyle = isTroubled ? ink.warn : ink.text;
  context.lineWidth = 2;
  context.fill();
  context.stroke();
  const front = Math.max(...course.robot_corners_m.map(([x]) => x));
  trace(context, [inWorld(pose, [0, 0]), inWorld(pose, [front, 0])], at, false);
  context.stroke();
}

/** Draws the whole corridor as a strip: doors, finish, people, contacts and how far the robot is. */
export function drawOverview(
  context: CanvasRenderingContext2D,
  { course, cycle, trail }: Scene,
  width: number,
  height: number,
  ink: Ink,
): void {
  const [x0, , x1] = course.bounds_m;
  const [left, right, top, bottom] = [8, width - 8, 6, height - 18];
  const place = (x_m: number) => left + ((right - left) * (x_m - x0)) / (x1 - x0);
  const middle = (top + bottom) / 2;
  context.fillStyle = ink.accentWeak;
  const furthest = Math.max(x0, ...(trail?.spots ?? []).map(({ x_m }) => x_m));
  context.fillRect(left, top, place(furthest) - left, bottom - top);
  context.strokeStyle = ink.strong;
  context.lineWidth = 1.5;
  context.strokeRect(left, top, right - left, bottom - top);
  context.font = ink.font;
  context.textAlign = 'center';
  context.textBaseline = 'top';
  for (const { x_m } of course.doors) {
    context.fillStyle = ink.warn;
    context.fillRect(place(x_m) - 1.5, top, 3, 5);
    context.fillRect(place(x_m) - 1.5, bottom - 5, 3, 5);
    context.fillStyle = ink.muted;
    context.fillText(`${x_m} m`, place(x_m), bottom + 4);
  }
  if (course.finish_m !== null) {
    context.fillStyle = ink.good;
    context.fillRect(place(course.finish_m) - 1, top, 2, bottom - top);
    context.textAlign = 'right';
    context.fillText(`finish ${course.finish_m} m`, right, bottom + 4);
  }
  for (const [x_m] of cycle?.people_m ?? []) dot(context, place(x_m), middle, 3, ink.good);
  for (const { x_m } of trail?.bumps ?? []) {
    context.fillStyle = ink.bad;
    context.fillRect(place(x_m) - 1, top + 2, 2, bottom - top - 4);
  }
  if (cycle) {
    dot(context, place(cycle.pose.x_m), middle, 6, ink.surface);
    dot(context, place(cycle.pose.x_m), middle, 5, ink.accent);
  }
}

function dot(
  context: CanvasRenderingContext2D,
  x: number,
  y: number,
  radius: number,
  colour: string,
): void {
  context.fillStyle = colour;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
}
