/** The polar plot of the sonars: 24 cones around the robot, heading upwards. */

import type { Ink } from './ink';

/** What the plot shows. Ranges from the shell, metres. */
export interface Sonars {
  sonar_m: number[];
  range_m: number;
  robot_radius_m: number;
}

/** Radius of the rings, metres: at most five, at round numbers. */
export function rings(range_m: number): number[] {
  const step = [0.25, 0.5, 1, 2, 5, 10, 20].find((each) => range_m / each <= 5) ?? range_m / 5;
  return Array.from(
    { length: Math.floor(range_m / step + 1e-9) },
    (_, index) => (index + 1) * step,
  );
}

/** Index of the smallest reading; -1 without readings. */
export function nearest(sonar_m: number[]): number {
  return sonar_m.indexOf(Math.min(...sonar_m));
}

/** The readings in words, for those who do not see the plot. */
export function sonarWords(sonar_m: number[]): string {
  const least = nearest(sonar_m);
  if (least < 0) return 'No reading yet';
  const side = ['ahead', 'left', 'behind', 'right'] as const;
  const sectors = side.map((name, index) => {
    const around = [-1, 0, 1].map((offset) => sonar_m[(index * 6 + offset + 24) % 24] ?? Infinity);
    return `${name} ${Math.min(...around).toFixed(2)} m`;
  });
  const angle = least <= 12 ? `${least * 15}° left` : `${360 - least * 15}° right`;
  return `Nearest ${(sonar_m[least] ?? 0).toFixed(2)} m at ${angle} (sonar ${least}); ${sectors.join(', ')}`;
}

/** Draws the plot into a square of `side` pixels. */
export function drawSonars(
  context: CanvasRenderingContext2D,
  side: number,
  view: Sonars,
  ink: Ink,
): void {
  const centre = side / 2;
  const hub = side * 0.045;
  const scale = (side / 2 - hub - 8) / Math.sqrt(view.range_m);
  // Near readings matter most, so the radius grows with the root of the range.
  const radius = (range_m: number) =>
    hub + scale * Math.sqrt(Math.max(0, Math.min(range_m, view.range_m)));
  context.translate(centre, centre);
  drawRings(context, rings(view.range_m), radius, ink);
  drawCones(context, view.sonar_m, radius, hub, ink);
  drawHub(context, hub, ink);
  drawLabels(context, rings(view.range_m), radius, ink);
}

type Radius = (range_m: number) => number;

/** Direction of sonar `index` on the canvas, heading upwards, counter-clockwise. */
const direction = (index: number) => -Math.PI / 2 - (index * Math.PI) / 12;

function drawRings(
  context: CanvasRenderingContext2D,
  at: number[],
  radius: Radius,
  ink: Ink,
): void {
  context.strokeStyle = ink.line;
  context.lineWidth = 1;
  for (const range_m of at) {
    context.beginPath();
    context.arc(0, 0, radius(range_m), 0, 2 * Math.PI);
    context.stroke();
  }
}

function drawCones(
  context: CanvasRenderingContext2D,
  sonar_m: number[],
  radius: Radius,
  hub: number,
  ink: Ink,
): void {
  const least = nearest(sonar_m);
  sonar_m.forEach((range_m, index) => {
    const middle = direction(index);
    context.beginPath();
    context.arc(0, 0, radius(range_m), middle - Math.PI / 24, middle + Math.PI / 24);
    context.arc(0, 0, hub, middle + Math.PI / 24, middle - Math.PI / 24, true);
    context.closePath();
    context.fillStyle = index === least ? ink.warnWeak : ink.accentWeak;
    context.strokeStyle = index === least ? ink.warn : ink.accent;
    context.lineWidth = index === least ? 2 : 1;
    context.fill();
    context.stroke();
  });
}

function drawHub(context: CanvasRenderingContext2D, hub: number, ink: Ink): void {
  context.fillStyle = ink.surface;
  context.strokeStyle = ink.text;
  context.lineWidth = 1.5;
  context.beginPath();
  context.arc(0, 0, hub, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  context.beginPath();
  context.moveTo(0, 0);
  context.lineTo(0, -hub);
  context.stroke();
}

function drawLabels(
  context: CanvasRenderingContext2D,
  at: number[],
  radius: Radius,
  ink: Ink,
): void {
  context.font = ink.font;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.lineWidth = 3;
  context.strokeStyle = ink.surface;
  context.fillStyle = ink.muted;
  for (const range_m of at) {
    const [x, y] = [radius(range_m) * Math.SQRT1_2, radius(range_m) * Math.SQRT1_2];
    context.strokeText(`${range_m} m`, x, y);
    context.fillText(`${range_m} m`, x, y);
  }
}
