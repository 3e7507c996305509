/** The equations behind a control step, with the numbers that really stood in them. */

import { novelty, type Settings } from './decision';
import { brief, degrees, number } from './format';
import type { TickView } from './protocol';

/** One equation: what it gives, in symbols, in numbers, and its number in the thesis. */
export interface Equation {
  gives: string;
  symbols: string;
  numbers: string;
  source: string;
}

/** All equations that were at work in this step, in the order of Algorithm 9. */
export function equations(tick: TickView, settings: Settings): Equation[] {
  return [
    ...competition(tick, settings),
    ...adaptation(tick, settings),
    ...exploration(tick),
    ...rotation(tick),
    reinforcement(tick),
  ];
}

function competition(tick: TickView, settings: Settings): Equation[] {
  if (!tick.winner) return [];
  const { value, sign } = novelty(tick.winner.distance, settings);
  const width = Number(settings['learner.novelty'] ?? NaN);
  const compared = Number.isFinite(width)
    ? ` ${value > width ? '>' : '≤'} ς = ${brief(width)}`
    : '';
  return [
    {
      gives: 'Winner',
      symbols: `i = arg min ‖x − c‖, ${sign} against ς`,
      numbers: `i = ${tick.winner.neuron}, ${number(value, 3)}${compared}`,
      source: '5.10',
    },
  ];
}

function adaptation(tick: TickView, settings: Settings): Equation[] {
  const past = tick.adaptation;
  if (past.kind === 'split') return [split(past.delta, past.past, settings)];
  if (past.kind !== 'updated') return [];
  const { reinforcement, present_utility, utility_before, utility_after, delta } = past;
  const discount = brief(Number(settings['learner.discount'] ?? NaN));
  return [
    {
      gives: 'TD error',
      symbols: 'δ = r + γ uⱼ − uᵢ',
      numbers: `${number(reinforcement)} + ${discount} · (${number(present_utility)}) − (${number(utility_before)}) = ${number(delta)}`,
      source: '5.19',
    },
    {
      gives: `Utility of neuron ${past.past}`,
      symbols: 'uᵢ ← uᵢ + η δ',
      numbers: `${number(utility_before)} + ${brief(past.utility_rate)} · (${number(delta)}) = ${number(utility_after)}`,
      source: '5.20',
    },
    {
      gives: `Mean of neuron ${past.past}`,
      symbols: 'μᵢ ← μᵢ + β δ e',
      numbers: `${degrees(past.mean_before_deg)} → ${degrees(past.mean_after_deg)}, e = ${brief(past.eligibility)} per degree`,
      source: '5.23, 5.24',
    },
    {
      gives: `Centre of neuron ${past.past}`,
      symbols: 'cᵢ ← cᵢ + ε (x − cᵢ)',
      numbers: `moved by ${number(past.centre_shift, 4)}`,
      source: '5.25',
    },
  ];
}

function split(delta: number, past: number, settings: Settings): Equation {
  return {
    gives: `Growth beside neuron ${past}`,
    symbols: 'δ > Δ',
    numbers: `${number(delta)} > ${settings['learner.split_threshold'] ?? '?'}`,
    source: '5.19, section 5.9',
  };
}

function exploration(tick: TickView): Equation[] {
  if (tick.source !== 'network') return [];
  const { temperature_deg, sigma_deg, mean_deg, deviation_deg, drawn_deg, most_deg, xi_deg } =
    tick.exploration;
  const T = degrees(temperature_deg);
  const u = tick.utility === null ? 'u pending' : number(tick.utility);
  const clipped = Math.abs(drawn_deg - xi_deg) > 1e-9;
  const sharp = (most_deg ?? temperature_deg) > temperature_deg;
  return [
    {
      gives: 'Spread',
      symbols: 'σ = T / (1 + exp u)',
      numbers: `${T} / (1 + exp(${u})) = ${degrees(sigma_deg)}`,
      source: '5.14',
    },
    {
      gives: 'Exploration',
      symbols: `ξ ~ N(μ, s), clipped to ${sharp ? '[−|μ|, |μ|]' : '[−T, T]'}`,
      numbers: `μ = ${degrees(mean_deg)}, s = ${degrees(deviation_deg)}: ${degrees(drawn_deg)}${
        clipped ? `, clipped to ${degrees(xi_deg)}` : ', not clipped'
      }`,
      source: sharp ? '5.12, addition A11' : '5.12, 5.15',
    },
    {
      gives: 'Action',
      symbols: 'α = p + ξ',
      numbers: sum(tick.prototypical_deg, xi_deg, tick.action_deg),
      source: '5.15',
    },
  ];
}

/** p + ξ as it was executed; angles wrap, and what does not add up is said rather than hidden. */
function sum(p: number, xi: number, alpha: number): string {
  const turns = (p + xi - alpha) / 360;
  const text = `${degrees(p)} + ${degrees(xi).replace(/^−.*/, '($&)')}`;
  if (Math.abs(turns) < 1e-6) return `${text} = ${degrees(alpha)}`;
  if (Math.abs(turns - Math.round(turns)) < 1e-6) return `${text} = ${degrees(alpha)} (wrapped)`;
  return `${text}, executed ${degrees(alpha)}`;
}

function rotation(tick: TickView): Equation[] {
  const frames: Record<string, [string, string]> = {
    heading: ['α − heading', `${degrees(tick.action_deg)} − (${degrees(tick.pose.heading_deg)})`],
    rotation: ['α', degrees(tick.action_deg)],
    goal: ['α + bearing', `${degrees(tick.action_deg)} + (${degrees(tick.goal_bearing_deg)})`],
  };
  const [symbols, numbers] = frames[tick.action_frame] ?? ['α', degrees(tick.action_deg)];
  return [
    {
      gives: 'Rotation',
      symbols,
      numbers: symbols === 'α' ? numbers : `${numbers} → ${degrees(tick.rotation_deg)}`,
      source: 'section 5.4',
    },
  ];
}

function reinforcement({ outcome }: TickView): Equation {
  return {
    gives: 'Reinforcement',
    symbols: 'r = f₁ + f₂',
    numbers: `${number(outcome.safety)} + (${number(outcome.goal)}) = ${number(outcome.reinforcement)}${
      outcome.close ? ', close to a wall' : ''
    }`,
    source: '5.6, 5.7',
  };
}
