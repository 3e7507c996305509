/** Where things lie in a course and on the screen. Metres, degrees; x ahead, y to the left. */

import type { CourseView, PoseView, SonarView } from '../protocol';

/** A point, metres. */
export type Point = [number, number];

/** A part of the plane `[x0, y0, x1, y1]`, metres. */
export type Window = [number, number, number, number];

/** How the plane lies on a canvas: y points up there, and down on the canvas. */
export interface Fit {
  /** Pixels a metre. */
  scale: number;
  /** Pixels at x = 0 and y = 0. */
  left: number;
  top: number;
}

/** Length of the corridor that is seen around the robot, metres. */
const FOLLOWED_M = 9;
/** Length of the approach that is seen, and how far to the sides, metres. */
const APPROACH_M = 3.3;
const ASIDE_M = 1.2;
/** Margin around all that is seen, metres. */
const RIM_M = 0.35;

/** A point of the robot's frame in the world. */
export function inWorld(pose: PoseView, [x, y]: Point): Point {
  const heading = radians(pose.heading_deg);
  const [cos, sin] = [Math.cos(heading), Math.sin(heading)];
  return [pose.x_m + x * cos - y * sin, pose.y_m + x * sin + y * cos];
}

/** Outline of a sonar's cone up to a reading, robot frame: from the sonar around the arc. */
export function cone(sonar: SonarView, half_deg: number, range_m: number): Point[] {
  const ARCS = 6;
  const arc = Array.from({ length: ARCS + 1 }, (_, index): Point => {
    const along = radians(sonar.bearing_deg + half_deg * ((2 * index) / ARCS - 1));
    return [sonar.x_m + range_m * Math.cos(along), sonar.y_m + range_m * Math.sin(along)];
  });
  return [[sonar.x_m, sonar.y_m], ...arc];
}

/** Where a reading lies on the axis of its cone, robot frame. */
export function tip({ x_m, y_m, bearing_deg }: SonarView, range_m: number): Point {
  const along = radians(bearing_deg);
  return [x_m + range_m * Math.cos(along), y_m + range_m * Math.sin(along)];
}

/** The part of a course that is shown: a corridor around the robot, an approach near the wall, the rest whole. */
export function shownOf(course: CourseView, pose: PoseView | null): Window {
  const [x0, y0, x1, y1] = course.bounds_m;
  switch (course.kind) {
    case 'corridor':
      return followed(course, pose);
    case 'wall-approach': {
      const behind = Math.min(x1 - APPROACH_M, (pose?.x_m ?? x1) - 0.6);
      return [behind, -ASIDE_M, x1 + RIM_M, ASIDE_M];
    }
    default:
      return [x0 - RIM_M, y0 - RIM_M, x1 + RIM_M, y1 + RIM_M];
  }
}

function followed({ bounds_m: [x0, y0, x1, y1] }: CourseView, pose: PoseView | null): Window {
  const length = Math.min(FOLLOWED_M, x1 - x0 + 2 * RIM_M);
  const wanted = (pose?.x_m ?? x0) - length / 2;
  const from = Math.max(x0 - RIM_M, Math.min(wanted, x1 + RIM_M - length));
  return [from, y0 - RIM_M, from + length, y1 + RIM_M];
}

/** Width over height of what is shown. */
export function shapeOf(course: CourseView): number {
  const [x0, y0, x1, y1] = shownOf(course, null);
  return (x1 - x0) / (y1 - y0);
}

/** Lays a window into a canvas, in its middle and as large as it goes. */
export function fit([x0, y0, x1, y1]: Window, width: number, height: number): Fit {
  const scale = Math.min(width / (x1 - x0), height / (y1 - y0));
  return {
    scale,
    left: width / 2 - (scale * (x0 + x1)) / 2,
    top: height / 2 + (scale * (y0 + y1)) / 2,
  };
}

/** A point on the canvas. */
export const onCanvas = ({ scale, left, top }: Fit, [x, y]: Point): Point => [
  left + scale * x,
  top - scale * y,
];

/** Share of the way from the start of a corridor to its finish, 0 to 1; none where it has no end. */
export function wayShare(course: CourseView, x_m: number): number | null {
  if (course.finish_m === null) return null;
  const from = course.bounds_m[0];
  return Math.max(0, Math.min(1, (x_m - from) / (course.finish_m - from)));
}

const radians = (deg: number) => (deg * Math.PI) / 180;
