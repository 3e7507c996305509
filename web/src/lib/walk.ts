/** The way of one trial, to be drawn and walked along step by step. */

import { number } from './format';
import type { PoseView, TickView, Trial } from './protocol';

/** A trial's way: where the robot was before each step and after the last. */
export interface Walk {
  poses: PoseView[];
  /** Steps, from 1, that ended in a collision. */
  collisions: number[];
}

/** The way through a trial's control steps. */
export function walkOf(ticks: TickView[]): Walk {
  const [first] = ticks;
  return {
    poses: first ? [first.true_pose, ...ticks.map((tick) => tick.outcome.true_pose)] : [],
    collisions: ticks.flatMap((tick, index) =>
      tick.outcome.contact === 'none' ? [] : [index + 1],
    ),
  };
}

/** A place in the drawing, whose y axis points down. */
export const place = ({ x_m, y_m }: { x_m: number; y_m: number }) =>
  `${x_m.toFixed(3)},${(-y_m).toFixed(3)}`;

/** The way up to a step as an SVG polyline. */
export const line = (walk: Walk, step: number) =>
  walk.poses
    .slice(0, step + 1)
    .map(place)
    .join(' ');

/** Wall segments as one SVG path. */
export function walls(segments: [number, number, number, number][]): string {
  return segments
    .map(([ax, ay, bx, by]) => `M${place({ x_m: ax, y_m: ay })}L${place({ x_m: bx, y_m: by })}`)
    .join('');
}

/** The part of the world shown, with a margin of `rim_m`. */
export function viewBox([x0, y0, x1, y1]: [number, number, number, number], rim_m: number): string {
  return [x0 - rim_m, -y1 - rim_m, x1 - x0 + 2 * rim_m, y1 - y0 + 2 * rim_m].join(' ');
}

/** What became of a trial, in a line. */
export function outcome(trial: Trial): string {
  const end = trial.reached_goal ? 'goal reached in' : 'goal not reached in';
  const regions = Object.entries(trial.region_steps)
    .filter(([, steps]) => steps > 0)
    .map(([region, steps]) => `${region} ${steps}`);
  const where = regions.length > 1 ? `; steps by region: ${regions.join(', ')}` : '';
  return `Trial ${trial.trial}: ${end} ${trial.steps} steps, R = ${number(trial.total_reinforcement)}${where}`;
}
