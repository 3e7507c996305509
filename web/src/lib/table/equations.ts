/** The equations behind a step of a tabular experiment, with the numbers that stood in them. */

import type { Equation } from '../equations';
import { brief, count, number } from '../format';
import type { PointView, PolicyView, PullView, Session, WalkView } from '../protocol';
import { isExcluded } from './present';

/** Settings of the session, for what the step does not tell. */
export type Settings = Session['settings'];

/** How actions were chosen: the setting `exploration.rule`. */
type Rule = 'softmax' | 'epsilon-greedy' | 'greedy';

/** Whether a competitor keeps V of its policy rather than Q. */
export function isCritic(entrant: string, settings: Settings): boolean {
  if (settings['learners'] === 'all') return /ahc/i.test(entrant);
  return settings['learner.kind'] === 'ahc';
}

/** A negative number in brackets, as it stands behind an operator. */
function apart(value: number, decimals = 3): string {
  const text = number(value, decimals);
  return text.startsWith('−') ? `(${text})` : text;
}

/** All equations that were at work in a learner's step, in their order. */
export function walkEquations(
  walk: WalkView,
  weights: number[][],
  names: { actions: string[]; state: (state: number) => string },
  settings: Settings,
): Equation[] {
  return [
    choice(walk, weights, names.actions, settings),
    ...rewardParts(walk),
    ...update(walk, names, settings),
    ...planned(walk),
  ];
}

function choice(
  walk: WalkView,
  weights: number[][],
  actions: string[],
  settings: Settings,
): Equation {
  const rule = (settings['exploration.rule'] ?? 'softmax') as Rule;
  const gives = `Chance of ${actions[walk.action] ?? walk.action}`;
  const chance = percent(walk.chances[walk.action] ?? 0);
  if (rule === 'softmax') return softmax(walk, weights, gives, chance);
  const best = Math.max(...walk.values.filter((_, u) => !isExcluded(weights, walk.state, u)));
  const isBest = walk.values[walk.action] === best;
  const epsilon = rule === 'greedy' ? 0 : walk.exploration;
  return {
    gives,
    symbols: 'p(u) = (1 − ε) [u is best] + ε / |U|, several best share',
    numbers: `ε = ${brief(epsilon)}, ${isBest ? 'a best action' : 'not the best'}: ${chance}`,
    source: 'section 4.8',
  };
}

function softmax(walk: WalkView, weights: number[][], gives: string, chance: string): Equation {
  const open = walk.values.flatMap((value, action) =>
    isExcluded(weights, walk.state, action) ? [] : [{ value, action }],
  );
  const pulled = walk.pulls.some((pull) => pull !== 0);
  const weighted = open.some(({ action }) => (weights[walk.state]?.[action] ?? 1) !== 1);
  const term = ({ value, action }: { value: number; action: number }) => {
    const weight = weights[walk.state]?.[action] ?? 1;
    const pull = walk.pulls[action] ?? 0;
    const exponent = `${number(value, 3)}/${brief(walk.exploration)}${pull === 0 ? '' : ` ${pull < 0 ? '−' : '+'} ${number(Math.abs(pull))}`}`;
    return `${weight === 1 ? '' : `${brief(weight)} · `}exp(${exponent})`;
  };
  const chosen = open.find(({ action }) => action === walk.action);
  return {
    gives,
    symbols: `p(u) = ${weighted ? 'w ' : ''}exp(Q(x,u)/τ${pulled ? ' + pull' : ''}) / Σ over v`,
    numbers: `${chosen ? term(chosen) : '–'} / (${open.map(term).join(' + ')}) = ${chance}`,
    source: '4.11',
  };
}

function rewardParts({ reward }: WalkView): Equation[] {
  const parts = [
    ['task', reward.task],
    ['subgoal', reward.subgoal],
    ['wall', reward.bump],
    ['progress', reward.progress],
  ] as const;
  const extra = parts.filter(([name, value]) => name === 'task' || value !== 0);
  if (extra.length === 1) return [];
  return [
    {
      gives: 'Reward',
      symbols: `r = ${extra.map(([name]) => name).join(' + ')}`,
      numbers: `${extra.map(([, value], at) => (at === 0 ? number(value) : apart(value, 2))).join(' + ')} = ${number(reward.total)}`,
      source: 'section 4.3',
    },
  ];
}

function update(
  walk: WalkView,
  { actions, state }: { actions: string[]; state: (state: number) => string },
  settings: Settings,
): Equation[] {
  const critic = isCritic(walk.entrant, settings);
  const { ahead, discount, rate, delta, before, after } = walk.update;
  const [x, u] = [state(walk.state), actions[walk.action] ?? String(walk.action)];
  const ahead_ = critic ? 'V(y)' : 'max Q(y,·)';
  const value = critic ? 'V(x)' : 'Q(x,u)';
  const whole = rate === 1;
  return [
    {
      gives: 'Temporal difference',
      symbols: `δ = r + γ ${ahead_} − ${value}`,
      numbers: `${number(walk.reward.total, 3)} + ${brief(discount)} · ${apart(ahead)} − ${apart(before)} = ${number(delta, 3)}`,
      source: critic ? '3.22' : '3.23',
    },
    {
      gives: critic ? `V(${x})` : `Q(${x}, ${u})`,
      symbols: `${value} ← ${value} + ${critic ? 'α' : 'β'} δ`,
      numbers: `${number(before, 3)} + ${brief(rate)} · ${apart(delta)} = ${number(after, 3)}`,
      source: critic ? '3.22' : whole ? '3.23, whole backup' : '3.23',
    },
  ];
}

function planned({ update }: WalkView): Equation[] {
  if (update.planned === 0) return [];
  return [
    {
      gives: 'Planning',
      symbols: 'the same, for experiences of the model',
      numbers: `${count(update.planned, 'further backup')}`,
      source: 'section 3.7',
    },
  ];
}

/** A chance in percent, with more digits where it is small. */
export function percent(chance: number): string {
  const hundred = chance * 100;
  const decimals = hundred === 0 || hundred >= 10 || hundred === 100 ? 0 : hundred >= 1 ? 1 : 2;
  return `${number(hundred, decimals)} %`;
}

/** What happened in a learner's step, in a sentence each. */
export function walkSentences(
  walk: WalkView,
  actions: string[],
  state: (state: number) => string,
): string[] {
  const { action, chances, next, bumped, trial_end } = walk;
  const chosen = `In ${state(walk.state)}, ${actions[action]} was chosen, which had a chance of ${percent(chances[action] ?? 0)}`;
  const led = bumped ? 'It changed nothing' : `It led to ${state(next)}`;
  const paid = `${led}; reward ${brief(walk.reward.total)}`;
  if (!trial_end) return [chosen, paid];
  const steps = count(trial_end.steps, 'action');
  const end = trial_end.reached_end
    ? `The trial ended after ${steps}`
    : `The trial was broken off at the cap, after ${steps}`;
  return [chosen, paid, end];
}

/** The equations behind a pull. */
export function pullEquations(pull: PullView, lever: string, greatest: number): Equation[] {
  return [
    {
      gives: `Chance of ${lever}`,
      symbols: 'of the strategy',
      numbers: percent(pull.chances[pull.lever] ?? 0),
      source: 'section 3.5',
    },
    {
      gives: 'Regret of this pull',
      symbols: 'best mean − mean of the lever',
      numbers: `${number(greatest, 3)} − ${apart(pull.mean)} = ${number(pull.regret, 3)}`,
      source: 'section 3.4',
    },
    {
      gives: 'Regret of the episode',
      symbols: 'sum over its pulls',
      numbers: number(pull.total_regret, 3),
      source: 'section 3.4',
    },
  ];
}

/** The equation behind a point of figure 3.3, once for each policy. */
export function pointEquations(point: PointView, policies: PolicyView[]): Equation[] {
  const models: Record<string, { symbols: string; source: string }> = {
    'finite-horizon': { symbols: 'J = Σ r(t), t = 0 to h − 1', source: '3.1' },
    discounted: { symbols: 'J = Σ γ^t r(t)', source: '3.3' },
    average: { symbols: 'J = lim (1/h) Σ r(t)', source: '3.4' },
  };
  const model = models[point.model] ?? { symbols: 'J', source: 'section 3.3' };
  return policies.map((policy, which) => ({
    gives: `J of ${policy.name}`,
    symbols: model.symbols,
    numbers: pointNumbers(point, policy, which),
    source: model.source,
  }));
}

function pointNumbers({ model, parameter, values }: PointView, policy: PolicyView, which: number) {
  const value = number(values[which] ?? NaN, 3);
  const { lead, then } = policy;
  const zeros = lead.every((reward) => reward === 0);
  if (model === 'average' || !zeros) return value;
  const k = lead.length;
  if (model === 'discounted') {
    return `${brief(then)} · ${brief(parameter)}^${k} / (1 − ${brief(parameter)}) = ${value}`;
  }
  return `${brief(then)} · max(0, ${brief(parameter)} − ${k}) = ${value}`;
}
