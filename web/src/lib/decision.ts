/** A control step in words: what was decided and why, sentence by sentence. */

import { count, degrees, metres, number, signed, words } from './format';
import { bearingWords, nearest } from './polar';
import type { AimView, BirthView, NeuronView, TickView } from './protocol';
import type { Value } from './settings';

/** The session's settings by key. */
export type Settings = Record<string, Value>;

/** The step in sentences: situation, adaptation of the past, action, consequence. */
export function sentences(tick: TickView, settings: Settings): string[] {
  return [situation(tick, settings), adaptation(tick, settings), action(tick), consequence(tick)];
}

/** What a neuron is compared with: the distance or, as a setting, its square. */
export function novelty(distance: number, settings: Settings): { value: number; sign: string } {
  const metric = settings['learner.novelty_metric'];
  const squared = metric !== undefined && metric !== 'distance';
  return squared
    ? { value: distance ** 2, sign: 'distance²' }
    : { value: distance, sign: 'distance' };
}

/** Why a neuron was added, from its birth certificate. */
export function birthWords(neuron: NeuronView): string {
  const { cause, value } = neuron.birth;
  const figure = value === null ? '' : number(value, 3);
  const why: Record<string, string> = {
    empty: 'the region had no neuron yet',
    distance: `the nearest neuron was too far (${figure})`,
    error: `the TD error was too large (${figure})`,
  };
  return `Added because ${why[cause] ?? cause}; action ${firstAction(neuron.birth)}`;
}

/** Where the first action of a neuron came from. */
export function firstAction({ parent, toward_m }: BirthView): string {
  if (toward_m) return `for ${point(toward_m)} of the record path`;
  return parent === null ? 'from the reflex' : `copied from neuron ${parent}`;
}

const point = ([x, y]: [number, number]) => `(${number(x)}, ${number(y)})`;

function situation(tick: TickView, settings: Settings): string {
  const place = `in the ${words(tick.region)}`;
  if (tick.neuron === null) return `No neuron is in charge ${place}: learning is off`;
  if (!tick.winner) return `There was no neuron ${place} yet, so neuron ${tick.born} was added`;
  const { neuron, distance } = tick.winner;
  const { value, sign } = novelty(distance, settings);
  const width = Number(settings['learner.novelty'] ?? NaN);
  const against = (symbol: string) =>
    Number.isFinite(width) ? `${number(value)} ${symbol} ${number(width)}` : number(value);
  if (tick.born === null) return `Neuron ${neuron} won ${place} (${sign} ${against('≤')})`;
  const origin = tick.toward_m
    ? `it makes for ${point(tick.toward_m)} of the record path`
    : tick.reflex
      ? 'the reflex gave its action'
      : 'its action was copied';
  return `Neuron ${neuron} was nearest ${place} but too far (${sign} ${against('>')}), so neuron ${tick.born} was added; ${origin}`;
}

function adaptation(tick: TickView, settings: Settings): string {
  const past = tick.adaptation;
  switch (past.kind) {
    case 'no-past':
      return 'Nothing to adapt: this is the first step of the trial';
    case 'off':
      return 'Nothing was adapted: temporal-difference learning is off';
    case 'pending':
      return `Nothing was adapted: a utility is still pending (past neuron ${past.past})`;
    case 'split':
      return `The TD error ${signed(past.delta)} exceeded Δ = ${settings['learner.split_threshold'] ?? '?'}, so neuron ${past.added} was split off from neuron ${past.past}`;
    case 'updated':
      return `Neuron ${past.past}'s utility ${course(past.utility_before, past.utility_after)} (δ = ${signed(past.delta)})`;
  }
}

function course(before: number, after: number): string {
  const [from, to] = [number(before), number(after)];
  if (from === to) return `stayed at ${to}`;
  return `${after > before ? 'rose' : 'fell'} from ${from} to ${to}`;
}

function action(tick: TickView): string {
  const turn = turnWords(tick.rotation_deg);
  if (tick.source === 'reflex') return `The bare reflex drove: ${turn}`;
  if (tick.source === 'bend' && tick.aim)
    return `Past neuron ${tick.neuron} the robot kept to the way that bends, to ${place(tick.aim)}: ${turn}`;
  if (tick.source === 'pursuit' && tick.toward_m)
    return `Neuron ${tick.neuron} is not of the record path; the robot went back to it, for ${point(tick.toward_m)}: ${turn}`;
  if (tick.source === 'sidestep')
    return `The echoes left no room, so the robot stepped aside: ${turn}`;
  if (tick.source === 'escape') return `Stuck, the robot went along the obstacle: ${turn}`;
  if (tick.source === 'scout') return `The scout went for the goal or along the obstacle: ${turn}`;
  if (tick.aim && tick.exploration.temperature_deg > 0)
    return `Neuron ${tick.neuron} drove along a shortcut to ${place(tick.aim)}: ${turn}`;
  return `Neuron ${tick.neuron} drove: ${turn}`;
}

/** Where a shortcut leads: the point, the one after it if it bends there, and who is in charge at its end. */
function place({ x_m, y_m, beyond_m, then }: AimView): string {
  const first = `${point([x_m, y_m])} m`;
  if (then === null) return `the goal at ${first}`;
  const bend = beyond_m ? ` and from there to ${point(beyond_m)} m` : '';
  return `${first}${bend}, where neuron ${then} takes over`;
}

/** A rotation as a person would say it. */
export function turnWords(rotation_deg: number): string {
  const size = degrees(Math.abs(rotation_deg));
  if (size === '0.0°') return 'straight on';
  return `turn ${size} ${rotation_deg > 0 ? 'left' : 'right'}, then advance`;
}

function consequence({ outcome }: TickView): string {
  const r = `reinforcement ${number(outcome.reinforcement)}`;
  const end = outcome.reached_goal ? '; the goal is reached' : '';
  if (outcome.contact === 'none') return `No contact; ${r}${end}`;
  const sensor = outcome.contact === 'real' ? 'tactile' : 'infrared';
  const way = `backed off ${metres(outcome.backed_m)}`;
  return `A ${outcome.contact} collision (${sensor}), ${way}; ${r}${end}`;
}

/** How far odometry alone is off what the sonars tell, where it is corrected. */
function fixFacts({ fix, pose }: TickView): [string, string][] {
  if (!fix) return [];
  const off_m = Math.hypot(fix.odometry.x_m - pose.x_m, fix.odometry.y_m - pose.y_m);
  const echoes =
    fix.echoes > 0
      ? `${fix.echoes} ${fix.echoes === 1 ? 'echo' : 'echoes'} agree`
      : 'nothing heard here before';
  return [['Odometry alone', `${metres(off_m)} off; ${echoes}`]];
}

/** Numbers of the situation, as label and value; bearings are those of the sonars. */
export function facts(tick: TickView, bearings_deg: number[]): [string, string][] {
  const least = nearest(tick.sonar_m);
  return [
    ['Region', words(tick.region)],
    ['Goal', `${metres(tick.goal_distance_m)} at ${degrees(tick.goal_bearing_deg)}`],
    [
      'Nearest sonar',
      `${metres(tick.sonar_m[least] ?? 0)} ${bearingWords(bearings_deg[least] ?? 0)}`,
    ],
    ...fixFacts(tick),
    ['Infrared', `${number(tick.reflectance_pct, 0)} %`],
    ['Trial so far', `R = ${number(tick.total_reinforcement)}`],
    ['Network', count(tick.neurons, 'neuron')],
  ];
}
