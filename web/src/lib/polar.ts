/** The polar plot of the sonars: one cone each around the robot, heading upwards. */

import type { Ink } from './ink';

/** What the plot shows. Ranges from the sonars, metres; bearings counter-clockwise from the heading. */
export interface Sonars {
  sonar_m: number[];
  bearings_deg: number[];
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

/** A bearing as it is said: 60° left, 15° right, ahead. */
export function bearingWords(bearing_deg: number): string {
  const from_ahead = signed(bearing_deg);
  if (from_ahead === 0) return 'ahead';
  return `${Math.abs(from_ahead)}° ${from_ahead > 0 ? 'left' : 'right'}`;
}

/** The readings in words, for those who do not see the plot. */
export function sonarWords(sonar_m: number[], bearings_deg: number[]): string {
  const least = nearest(sonar_m);
  if (least < 0) return 'No reading yet';
  const sides = ['ahead', 'left', 'behind', 'right'].flatMap((name, quarter) => {
    const looking = (index: number) =>
      Math.abs(signed((bearings_deg[index] ?? 0) - 90 * quarter)) <= 45;
    const readings = sonar_m.filter((_, index) => looking(index));
    return readings.length > 0 ? [`${name} ${Math.min(...readings).toFixed(2)} m`] : [];
  });
  const where = bearingWords(bearings_deg[least] ?? 0);
  return `Nearest ${(sonar_m[least] ?? 0).toFixed(2)} m ${where} (sonar ${least}); ${sides.join(', ')}`;
}

/** How far the cone of a sonar is drawn to either side, degrees: half way to the next, at most 15. */
export function halves(bearings_deg: number[], index: number): { left: number; right: number } {
  const gaps = bearings_deg
    .filter((_, other) => other !== index)
    .map((other) => (((other - (bearings_deg[index] ?? 0)) % 360) + 360) % 360);
  return {
    left: Math.min(15, ...gaps.map((gap) => gap / 2)),
    right: Math.min(15, ...gaps.map((gap) => (360 - gap) / 2)),
  };
}

/** An angle as -180 to 180 degrees. */
const signed = (angle_deg: number) => ((((angle_deg + 180) % 360) + 360) % 360) - 180;

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
  drawCones(context, view, radius, hub, ink);
  drawHub(context, hub, ink);
  drawLabels(context, rings(view.range_m), radius, ink);
}

type Radius = (range_m: number) => number;

/** A bearing on the canvas, where the heading is upwards and angles turn clockwise. */
const direction = (bearing_deg: number) => ((-90 - bearing_deg) * Math.PI) / 180;

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
  { sonar_m, bearings_deg }: Sonars,
  radius: Radius,
  hub: number,
  ink: Ink,
): void {
  const least = nearest(sonar_m);
  sonar_m.forEach((range_m, index) => {
    const bearing_deg = bearings_deg[index] ?? 0;
    const half = halves(bearings_deg, index);
    const [from, to] = [direction(bearing_deg + half.left), direction(bearing_deg - half.right)];
    context.beginPath();
    context.arc(0, 0, radius(range_m), from, to);
    context.arc(0, 0, hub, to, from, true);
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
