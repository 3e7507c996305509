/** Strips on a canvas: values against the newest cycles, with runs told apart. */

import type { Ink } from '../ink';
import type { CourseView, CycleView } from '../protocol';
import { squares, type Square } from './consistency';
import { drawMark } from './draw';
import { isMarked } from './echoes';
import { along, beginnings, lines, logPlace } from './strips';

/** A part of a canvas, pixels. */
export interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** A line of a strip. */
export interface StripLine {
  read: (cycle: CycleView) => number | null | undefined;
  colour: string;
  dash: number[];
  width: number;
}

/** Pixels before the first cycle, for the scale's numbers. */
const GUTTER = 30;

/** Where a depth lies in a box. */
function placer(box: Box, range_m: number) {
  return (back: number, depth_m: number): [number, number] => [
    box.left + along(back) * box.width,
    box.top + box.height * (1 - Math.max(0, Math.min(1, depth_m / range_m))),
  ];
}

/** Draws depths of a region against time, with a band of ± σ where there is one. */
export function drawDepths(
  context: CanvasRenderingContext2D,
  width: number,
  height: number,
  cycles: CycleView[],
  range_m: number,
  shown: { lines: StripLine[]; band: Band | null },
  ink: Ink,
): void {
  const box = { left: GUTTER, top: 6, width: width - GUTTER - 5, height: height - 12 };
  const place = placer(box, range_m);
  drawGrid(context, box, range_m, ink);
  drawBeginnings(context, box, cycles, ink);
  if (shown.band) drawBand(context, cycles, shown.band, place);
  for (const line of shown.lines) drawLine(context, cycles, line, place);
}

/** A band around a line. */
export interface Band {
  middle: (cycle: CycleView) => number | undefined;
  half: (cycle: CycleView) => number | null | undefined;
  colour: string;
}

type Place = (back: number, depth_m: number) => [number, number];

function drawGrid(context: CanvasRenderingContext2D, box: Box, range_m: number, ink: Ink): void {
  context.strokeStyle = ink.line;
  context.fillStyle = ink.muted;
  context.lineWidth = 1;
  context.font = ink.font;
  context.textAlign = 'right';
  context.textBaseline = 'middle';
  for (const at of [0, range_m / 2, range_m]) {
    const y = Math.round(box.top + box.height * (1 - at / range_m)) + 0.5;
    context.beginPath();
    context.moveTo(box.left, y);
    context.lineTo(box.left + box.width, y);
    context.stroke();
    context.fillText(String(at), box.left - 5, y);
  }
}

function drawBeginnings(
  context: CanvasRenderingContext2D,
  box: Box,
  cycles: CycleView[],
  ink: Ink,
): void {
  context.strokeStyle = ink.strong;
  context.lineWidth = 1;
  context.setLineDash([2, 3]);
  for (const { back } of beginnings(cycles)) {
    const x = Math.round(box.left + along(back) * box.width) - 0.5;
    context.beginPath();
    context.moveTo(x, box.top);
    context.lineTo(x, box.top + box.height);
    context.stroke();
  }
  context.setLineDash([]);
}

function drawBand(
  context: CanvasRenderingContext2D,
  cycles: CycleView[],
  { middle, half, colour }: Band,
  place: Place,
): void {
  const end = (side: number) => (cycle: CycleView) => {
    const [at, spread] = [middle(cycle), half(cycle)];
    return at === undefined || spread === null || spread === undefined ? null : at + side * spread;
  };
  const [upper, lower] = [lines(cycles, end(1)), lines(cycles, end(-1))];
  context.fillStyle = colour;
  context.globalAlpha = 0.15;
  upper.forEach((points, index) => {
    const back = (lower[index] ?? []).toReversed();
    context.beginPath();
    for (const { back: at, value } of [...points, ...back]) context.lineTo(...place(at, value));
    context.fill();
  });
  context.globalAlpha = 1;
}

function drawLine(
  context: CanvasRenderingContext2D,
  cycles: CycleView[],
  { read, colour, dash, width }: StripLine,
  place: Place,
): void {
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.lineJoin = 'round';
  context.setLineDash(dash);
  for (const points of lines(cycles, read)) {
    context.beginPath();
    for (const { back, value } of points) context.lineTo(...place(back, value));
    // A line of a single point would be nothing.
    if (points.length === 1 && points[0]) {
      const [x, y] = place(points[0].back, points[0].value);
      context.lineTo(x + 1, y);
    }
    context.stroke();
  }
  context.setLineDash([]);
}

/** Height of a sonar's row, pixels. */
export const ROW = 34;

/** Draws all sonars against time, one row each; readings that are not just echoes have marks. */
export function drawReadings(
  context: CanvasRenderingContext2D,
  width: number,
  course: CourseView,
  cycles: CycleView[],
  ink: Ink,
): void {
  const left = 52;
  course.sonars.forEach((_, sonar) => {
    const box = { left, top: sonar * ROW + 4, width: width - left - 6, height: ROW - 8 };
    const place = placer(box, course.sonar_range_m);
    context.strokeStyle = ink.line;
    context.lineWidth = 1;
    context.strokeRect(box.left - 0.5, Math.round(box.top) - 0.5, box.width + 1, box.height + 1);
    drawBeginnings(context, box, cycles, ink);
    const read = ({ readings }: CycleView) => readings[sonar]?.range_m;
    drawLine(context, cycles, { read, colour: ink.accent, dash: [], width: 1.25 }, place);
    const newest = cycles.at(-1)?.tick ?? 0;
    for (const cycle of cycles) {
      const reading = cycle.readings[sonar];
      if (!reading || !isMarked(reading.echo)) continue;
      drawMark(context, reading.echo, place(newest - cycle.tick, reading.range_m), ink, 0.55);
    }
    context.fillStyle = ink.text;
    context.font = ink.font;
    context.textAlign = 'left';
    context.textBaseline = 'middle';
    context.fillText(`sonar ${sonar}`, 2, box.top + box.height / 2);
  });
}

/** Ends of the logarithmic scale of NIS and NEES. */
const SQUARES: [number, number] = [1e-5, 100];

/** Draws NIS or NEES of all regions or one as points between their bounds, on a logarithmic scale. */
export function drawSquares(
  context: CanvasRenderingContext2D,
  width: number,
  height: number,
  course: CourseView,
  cycles: CycleView[],
  shown: { square: Square; region: number | null },
  ink: Ink,
): void {
  const box = { left: 44, top: 6, width: width - 50, height: height - 12 };
  const y = (value: number) => box.top + box.height * (1 - logPlace(value, ...SQUARES));
  const [low, high] = course.chi_square;
  context.fillStyle = ink.goodWeak;
  context.fillRect(box.left, y(high), box.width, y(low) - y(high));
  context.strokeStyle = ink.line;
  context.strokeRect(box.left - 0.5, box.top - 0.5, box.width + 1, box.height + 1);
  context.font = ink.font;
  context.textAlign = 'right';
  context.textBaseline = 'middle';
  for (const at of [low, 1, high]) {
    context.strokeStyle = at === 1 ? ink.line : ink.good;
    context.fillStyle = at === 1 ? ink.muted : ink.good;
    context.beginPath();
    context.moveTo(box.left, y(at));
    context.lineTo(box.left + box.width, y(at));
    context.stroke();
    context.fillText(
      at < 0.01 ? at.toFixed(4) : String(Number(at.toFixed(2))),
      box.left - 5,
      y(at),
    );
  }
  drawBeginnings(context, box, cycles, ink);
  const newest = cycles.at(-1)?.tick ?? 0;
  for (const cycle of cycles) {
    const x = box.left + along(newest - cycle.tick) * box.width;
    for (const value of squares(cycle, shown.square, shown.region)) {
      const isWithin = value >= low && value <= high;
      context.fillStyle = isWithin ? ink.accent : ink.bad;
      // Beyond the bounds the shape changes too.
      if (isWithin) context.fillRect(x - 1.5, y(value) - 1.5, 3, 3);
      else context.fillRect(x - 1, y(value) - 3.5, 2, 7);
    }
  }
}
