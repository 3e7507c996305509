/** The map of neurons: each at its birth place, pointing where its prototypical action goes. */

import { colour, share } from './colour';
import type { Ink } from './ink';
import type { NeuronView, ThemeName, WorldView } from './protocol';

/** Where the world lies on the canvas. */
export interface Frame {
  x(x_m: number): number;
  y(y_m: number): number;
  scale: number;
}

/** What the map shows. */
export interface NeuronMap {
  world: WorldView;
  neurons: NeuronView[];
  selected: number | null;
  winner: number | null;
}

/** Shapes of the region networks, in the order of the world's regions. */
export const SHAPES = ['circle', 'square', 'triangle', 'diamond', 'hexagon', 'wedge'] as const;

/** One of [`SHAPES`]. */
export type Shape = (typeof SHAPES)[number];

/** The shape of a region's neurons. */
export function shapeOf(world: WorldView, region: string): Shape {
  return SHAPES[Math.max(0, world.regions.indexOf(region)) % SHAPES.length] ?? 'circle';
}

/** Least and greatest utility; none when no neuron has one. */
export function utilityRange(neurons: NeuronView[]): [number, number] | null {
  const known = neurons.flatMap((neuron) => (neuron.utility === null ? [] : [neuron.utility]));
  return known.length === 0 ? null : [Math.min(...known), Math.max(...known)];
}

/** Fits the world into a canvas, x to the right and y up, with the same scale both ways. */
export function frameOf(world: WorldView, width: number, height: number): Frame {
  const [x0, y0, x1, y1] = world.bounds_m;
  const margin = 12;
  const scale = Math.min((width - 2 * margin) / (x1 - x0), (height - 2 * margin) / (y1 - y0));
  const left = (width - scale * (x1 - x0)) / 2;
  const top = (height - scale * (y1 - y0)) / 2;
  return { x: (x_m) => left + scale * (x_m - x0), y: (y_m) => top + scale * (y1 - y_m), scale };
}

/** The neuron nearest to a point of the canvas, if one is within reach. */
export function neuronAt(map: NeuronMap, frame: Frame, x: number, y: number): number | null {
  let found: number | null = null;
  let least = 18;
  for (const { id, birth } of map.neurons) {
    const way = Math.hypot(frame.x(birth.pose.x_m) - x, frame.y(birth.pose.y_m) - y);
    if (way < least) [found, least] = [id, way];
  }
  return found;
}

/** The nearest neuron in the direction of an arrow key; the first one when none is selected. */
export function neighbour(neurons: NeuronView[], from: number | null, key: string): number | null {
  const start = neurons.find((neuron) => neuron.id === from);
  if (!start) return neurons[0]?.id ?? null;
  const direction = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[
    key
  ];
  if (!direction) return from;
  const [dx = 0, dy = 0] = direction;
  let found = from;
  let least = Infinity;
  for (const { id, birth } of neurons) {
    const [x, y] = [birth.pose.x_m - start.birth.pose.x_m, birth.pose.y_m - start.birth.pose.y_m];
    const along = x * dx + y * dy;
    const cost = along + 2 * Math.abs(x * dy - y * dx);
    if (along > 1e-9 && cost < least) [found, least] = [id, cost];
  }
  return found;
}

/** Draws the whole map. */
export function drawMap(
  context: CanvasRenderingContext2D,
  frame: Frame,
  map: NeuronMap,
  ink: Ink,
  theme: ThemeName,
): void {
  drawWorld(context, frame, map.world, ink);
  const range = utilityRange(map.neurons);
  for (const neuron of map.neurons) drawNeuron(context, frame, map, neuron, range, ink, theme);
  const selected = map.neurons.find((neuron) => neuron.id === map.selected);
  if (selected) drawRing(context, frame, selected, ink);
}

/** Draws walls, home and goal. */
function drawWorld(
  context: CanvasRenderingContext2D,
  frame: Frame,
  world: WorldView,
  ink: Ink,
): void {
  context.strokeStyle = ink.strong;
  context.lineWidth = 2;
  context.lineCap = 'round';
  context.beginPath();
  for (const [x0, y0, x1, y1] of world.walls_m) {
    context.moveTo(frame.x(x0), frame.y(y0));
    context.lineTo(frame.x(x1), frame.y(y1));
  }
  context.stroke();
  const [x, y] = [frame.x(world.goal_m[0]), frame.y(world.goal_m[1])];
  context.lineWidth = 1;
  context.setLineDash([4, 3]);
  context.beginPath();
  context.arc(x, y, world.goal_radius_m * frame.scale, 0, 2 * Math.PI);
  context.stroke();
  context.setLineDash([]);
  context.font = ink.font;
  context.fillStyle = ink.muted;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillText('goal', x, y);
  context.textBaseline = 'top';
  context.fillText('home', frame.x(world.home.x_m), frame.y(world.home.y_m) + 8);
}

/** Half a mark, pixels: smaller where there are many. */
const sizeOf = (neurons: NeuronView[]) => (neurons.length > 50 ? 4 : 5);

function drawNeuron(
  context: CanvasRenderingContext2D,
  frame: Frame,
  map: NeuronMap,
  neuron: NeuronView,
  range: [number, number] | null,
  ink: Ink,
  theme: ThemeName,
): void {
  const [x, y] = [frame.x(neuron.birth.pose.x_m), frame.y(neuron.birth.pose.y_m)];
  const heading = (neuron.heading_deg * Math.PI) / 180;
  const pending = neuron.utility === null || range === null;
  const size = sizeOf(map.neurons);
  const inCharge = neuron.id === map.winner;
  context.strokeStyle = inCharge ? ink.text : ink.strong;
  context.lineWidth = inCharge ? 2.5 : 1;
  context.beginPath();
  context.moveTo(x, y);
  arrow(context, x, y, heading);
  context.stroke();
  context.fillStyle = pending ? ink.surface : colour(share(neuron.utility ?? 0, ...range), theme);
  outline(context, shapeOf(map.world, neuron.region), x, y, inCharge ? size + 2 : size);
  context.fill();
  context.stroke();
}

function drawRing(
  context: CanvasRenderingContext2D,
  frame: Frame,
  neuron: NeuronView,
  ink: Ink,
): void {
  context.strokeStyle = ink.accent;
  context.lineWidth = 3;
  context.beginPath();
  context.arc(frame.x(neuron.birth.pose.x_m), frame.y(neuron.birth.pose.y_m), 12, 0, 2 * Math.PI);
  context.stroke();
}

/** Path of an arrow from a place in a heading, counter-clockwise from the right. */
function arrow(context: CanvasRenderingContext2D, x: number, y: number, heading: number): void {
  const along = (length: number, turn: number): [number, number] => [
    x + length * Math.cos(heading + turn),
    y - length * Math.sin(heading + turn),
  ];
  context.lineTo(...along(14, 0));
  context.moveTo(...along(11, 0.25));
  context.lineTo(...along(14, 0));
  context.lineTo(...along(11, -0.25));
}

const CORNERS: Partial<Record<Shape, [number, number]>> = {
  square: [4, Math.PI / 4],
  triangle: [3, -Math.PI / 2],
  diamond: [4, 0],
  hexagon: [6, 0],
  wedge: [3, Math.PI / 2],
};

/** Path of a shape of about the same area as a circle of radius `size`. */
export function outline(
  context: CanvasRenderingContext2D,
  shape: Shape,
  x: number,
  y: number,
  size: number,
): void {
  context.beginPath();
  const polygon = CORNERS[shape];
  if (!polygon) {
    context.arc(x, y, size, 0, 2 * Math.PI);
    return;
  }
  const [corners, turn] = polygon;
  const radius = size * (corners === 3 ? 1.45 : 1.25);
  for (let corner = 0; corner < corners; corner += 1) {
    const angle = turn + (corner * 2 * Math.PI) / corners;
    context.lineTo(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
  }
  context.closePath();
}
