/** A maze as it is drawn: cells by value, greedy arrows, walls, and planning at work. */

import { colour, share } from '../colour';
import type { Ink } from '../ink';
import type { LearnerView, TaskView, ThemeName } from '../protocol';
import { inkOn } from './heat';
import { centre, wayOf, type Spot } from './plan';
import { greedy } from './present';

/** What is drawn. */
export interface MazePicture {
  task: TaskView;
  learner: LearnerView;
  /** State the agent is in. */
  agent: number;
  selected: number | null;
}

/** Where the maze lies on the canvas: its upper left corner and the side of a cell, pixels. */
export interface MazeFrame {
  left: number;
  top: number;
  side: number;
}

/** Cells that are smaller show no numbers. */
const NUMBERED = 56;
/** Cells that are smaller show no arrows. */
const ARROWED = 16;

/** Fits a maze into a canvas. */
export function frameOf({ rows, columns }: TaskView, width: number, height: number): MazeFrame {
  const margin = 6;
  const side = Math.min((width - 2 * margin) / columns, (height - 2 * margin) / rows);
  return { left: (width - side * columns) / 2, top: (height - side * rows) / 2, side };
}

/** A point of the canvas, in cells. */
export function spotAt({ left, top, side }: MazeFrame, x: number, y: number): Spot {
  return [(x - left) / side, (y - top) / side];
}

/** Least and greatest value of the states that have one to compare: ends have none of their own. */
export function valueRange({ state_values, ends }: LearnerView): [number, number] {
  const values = state_values.filter((_, state) => !ends.includes(state));
  return [Math.min(...values), Math.max(...values)];
}

/** The colour of a state's value. */
export function valueColour(learner: LearnerView, state: number, theme: ThemeName): string {
  const [least, greatest] = valueRange(learner);
  const value = learner.state_values[state] ?? least;
  return colour(greatest > least ? share(value, least, greatest) : 0, theme);
}

/** Draws the whole picture. */
export function drawMaze(
  context: CanvasRenderingContext2D,
  frame: MazeFrame,
  picture: MazePicture,
  ink: Ink,
  theme: ThemeName,
): void {
  const { task } = picture;
  const { left, top, side } = frame;
  context.fillStyle = ink.strong;
  context.fillRect(left - 3, top - 3, side * task.columns + 6, side * task.rows + 6);
  task.states.forEach((_, state) => drawCell(context, frame, picture, state, ink, theme));
  drawPlanning(context, frame, picture, ink);
  drawAgent(context, frame, picture, ink);
  if (picture.selected !== null) {
    outline(context, frame, picture, picture.selected, ink.text, 3);
  }
}

function drawCell(
  context: CanvasRenderingContext2D,
  frame: MazeFrame,
  { task, learner }: MazePicture,
  state: number,
  ink: Ink,
  theme: ThemeName,
) {
  const found = task.states[state];
  if (!found || found.row === null || found.column === null) return;
  const { left, top, side } = frame;
  const [x, y] = [left + found.column * side, top + found.row * side];
  const isEnd = learner.ends.includes(state);
  const ground = isEnd ? ink.goodWeak : valueColour(learner, state, theme);
  context.fillStyle = ground;
  context.fillRect(x + 0.5, y + 0.5, side - 1, side - 1);
  const on = isEnd ? ink.text : inkOn(ground);
  context.fillStyle = context.strokeStyle = on;
  if (!isEnd && side >= ARROWED)
    drawArrows(context, [x + side / 2, y + side / 2], side, task, learner, state);
  const letter = found.mark;
  context.textAlign = 'left';
  context.textBaseline = 'top';
  if (isEnd) {
    drawEnd(context, [x, y], side, letter, ink);
  } else if (letter && side >= 14) {
    context.font = `${letter === 'S' ? '700 ' : ''}${Math.min(14, side * 0.4)}px ${fontOf(ink)}`;
    context.fillText(letter, x + 3, y + 2);
  }
  if (side >= NUMBERED && !isEnd) {
    context.font = `10px ${fontOf(ink)}`;
    context.textAlign = 'right';
    context.textBaseline = 'bottom';
    context.fillText(short(learner.state_values[state] ?? 0), x + side - 3, y + side - 2);
  }
}

function drawEnd(
  context: CanvasRenderingContext2D,
  [x, y]: Spot,
  side: number,
  letter: string,
  ink: Ink,
) {
  context.strokeStyle = context.fillStyle = letter === 'X' ? ink.bad : ink.good;
  context.lineWidth = 2;
  context.strokeRect(x + 2, y + 2, side - 4, side - 4);
  if (side < 10) return;
  context.font = `700 ${Math.min(18, side * 0.5)}px ${fontOf(ink)}`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillText(letter, x + side / 2, y + side / 2);
}

function drawArrows(
  context: CanvasRenderingContext2D,
  [x, y]: Spot,
  side: number,
  task: TaskView,
  learner: LearnerView,
  state: number,
) {
  const best = greedy(learner.values[state] ?? [], learner.weights[state]);
  context.lineWidth = Math.max(1.2, side / 28);
  for (const action of best) {
    const way = wayOf(task.actions[action] ?? '');
    if (!way) continue;
    const reach = side * 0.27;
    const [tx, ty] = [x + way[0] * reach, y + way[1] * reach];
    const head = side * 0.12;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(tx, ty);
    context.moveTo(tx - way[0] * head + way[1] * head, ty - way[1] * head + way[0] * head);
    context.lineTo(tx, ty);
    context.lineTo(tx - way[0] * head - way[1] * head, ty - way[1] * head - way[0] * head);
    context.stroke();
  }
}

/** The last step's backups as frames, and the queue as squares that grow with the priority. */
function drawPlanning(
  context: CanvasRenderingContext2D,
  frame: MazeFrame,
  { task, learner }: MazePicture,
  ink: Ink,
) {
  const { planning } = learner;
  if (!planning) return;
  for (const { state } of planning.backups) {
    outline(context, frame, { task }, state, ink.warn, 2, 3);
  }
  const most = planning.queue[0]?.priority ?? 1;
  context.fillStyle = ink.bad;
  for (const { state, priority } of planning.queue) {
    const middle = middleOf(frame, task, state);
    if (!middle) continue;
    const size = frame.side * (0.1 + 0.16 * Math.min(1, priority / most));
    const corner = frame.side / 2 - size - 3;
    context.fillRect(middle[0] + corner, middle[1] - corner - size, size, size);
  }
}

function drawAgent(
  context: CanvasRenderingContext2D,
  frame: MazeFrame,
  { task, agent }: MazePicture,
  ink: Ink,
) {
  const middle = middleOf(frame, task, agent);
  if (!middle) return;
  context.beginPath();
  context.arc(middle[0], middle[1], Math.max(3, frame.side * 0.2), 0, 2 * Math.PI);
  context.fillStyle = ink.surface;
  context.strokeStyle = ink.text;
  context.lineWidth = Math.max(2, frame.side * 0.07);
  context.fill();
  context.stroke();
}

function outline(
  context: CanvasRenderingContext2D,
  { left, top, side }: MazeFrame,
  { task }: Pick<MazePicture, 'task'>,
  state: number,
  stroke: string,
  width: number,
  inset = 1,
) {
  const found = task.states[state];
  if (!found || found.row === null || found.column === null) return;
  context.strokeStyle = stroke;
  context.lineWidth = width;
  const [x, y] = [left + found.column * side + inset, top + found.row * side + inset];
  context.strokeRect(x, y, side - 2 * inset, side - 2 * inset);
}

function middleOf({ left, top, side }: MazeFrame, task: TaskView, state: number): Spot | null {
  const found = task.states[state];
  const spot = found ? centre(found) : null;
  return spot && [left + spot[0] * side, top + spot[1] * side];
}

function fontOf({ font }: Ink): string {
  return font.replace(/^\S+\s/, '');
}

function short(value: number): string {
  const size = Math.abs(value);
  return value.toFixed(size >= 100 ? 0 : size >= 10 ? 1 : 2).replace('-', '−');
}
