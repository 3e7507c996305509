import { describe, expect, it } from 'vitest';

import {
  isCritic,
  percent,
  pointEquations,
  pullEquations,
  walkEquations,
  walkSentences,
} from './equations';
import { sampleBandit, sampleWalk } from './sample';

const names = { actions: ['left', 'forward', 'right'], state: (state: number) => `#${state}` };
const open = Array.from({ length: 16 }, () => [1, 1, 1]);
const SOFTMAX = { 'exploration.rule': 'softmax', 'learner.kind': 'q' };
const found = (
  walk: ReturnType<typeof sampleWalk>,
  weights = open,
  settings: Record<string, string> = SOFTMAX,
) => walkEquations(walk, weights, names, settings);

describe('Eq. (4.11)', () => {
  it('stands with its numbers', () => {
    const [chance] = found(sampleWalk());
    expect(chance).toEqual({
      gives: 'Chance of forward',
      symbols: 'p(u) = exp(Q(x,u)/τ) / Σ over v',
      numbers: 'exp(0.500/0.5) / (exp(1.000/0.5) + exp(0.500/0.5) + exp(2.000/0.5)) = 4.2 %',
      source: '4.11',
    });
  });

  it('leaves out what is excluded, and shows weights and pulls', () => {
    const weights = open.map((row, state) => (state === 4 ? [0, 1, 0.5] : row));
    const [chance] = found(sampleWalk({ pulls: [0, 0.4, -1] }), weights);
    expect(chance?.symbols).toBe('p(u) = w exp(Q(x,u)/τ + pull) / Σ over v');
    expect(chance?.numbers).toBe(
      'exp(0.500/0.5 + 0.40) / (exp(0.500/0.5 + 0.40) + 0.5 · exp(2.000/0.5 − 1.00)) = 4.2 %',
    );
  });

  it('gives way to ε', () => {
    const walk = sampleWalk({ exploration: 0.1, action: 2, chances: [0.033, 0.033, 0.933] });
    const [chance] = found(walk, open, { 'exploration.rule': 'epsilon-greedy' });
    expect(chance?.numbers).toBe('ε = 0.1, a best action: 93 %');
    expect(chance?.source).toBe('section 4.8');
  });
});

it('puts the numbers of the update into its equation', () => {
  const [, difference, value] = found(sampleWalk());
  expect(difference?.symbols).toBe('δ = r + γ max Q(y,·) − Q(x,u)');
  expect(difference?.numbers).toBe('0.000 + 1 · 2.000 − 0.500 = 1.500');
  expect(value).toEqual({
    gives: 'Q(#4, forward)',
    symbols: 'Q(x,u) ← Q(x,u) + β δ',
    numbers: '0.500 + 0.9 · 1.500 = 1.850',
    source: '3.23',
  });
});

it('brackets what is negative', () => {
  const update = { ...sampleWalk().update, ahead: -1, delta: -2 };
  expect(found(sampleWalk({ update }))[1]?.numbers).toBe('0.000 + 1 · (−1.000) − 0.500 = −2.000');
});

it('speaks of V where a critic learns, also among others', () => {
  expect(isCritic('ahc', { learners: 'all', 'learner.kind': 'q' })).toBe(true);
  expect(isCritic('dyna', { learners: 'all', 'learner.kind': 'ahc' })).toBe(false);
  const settings = { 'learner.kind': 'ahc', 'exploration.rule': 'softmax' };
  const [, difference, value] = found(sampleWalk(), open, settings);
  expect([difference?.symbols, value?.gives]).toEqual(['δ = r + γ V(y) − V(x)', 'V(#4)']);
});

it('adds up a reward that has parts', () => {
  const reward = { total: -0.1, task: 0, subgoal: 0, bump: -0.1, progress: 0 };
  expect(found(sampleWalk({ reward }))[1]).toMatchObject({
    symbols: 'r = task + wall',
    numbers: '0.00 + (−0.10) = −0.10',
  });
});

it('tells what happened, and how a trial ended', () => {
  const trial_end = { steps: 10_000, reached_end: false, total_reward: 0, bumps: 3 };
  expect(walkSentences(sampleWalk({ trial_end }), names.actions, names.state)).toEqual([
    'In #4, forward was chosen, which had a chance of 4.2 %',
    'It changed nothing; reward 0',
    'The trial was broken off at the cap, after 10,000 actions',
  ]);
});

it('says chances as short as they mean something', () => {
  expect([0, 0.004, 0.042, 0.27, 1].map(percent)).toEqual([
    '0 %',
    '0.40 %',
    '4.2 %',
    '27 %',
    '100 %',
  ]);
});

it('reckons the regret of a pull', () => {
  const pull = sampleBandit().step!;
  expect(pullEquations(pull, 'lever 2', 0.8)[1]?.numbers).toBe('0.800 − 0.600 = 0.200');
});

it('puts figure 3.3 into closed forms', () => {
  const policies = [{ name: 'a1', lead: [0, 0, 0, 0, 0], then: 10 }];
  const point = { tick: 1, round: 1, best: 0, crossing: null };
  const numbers = (model: string, parameter: number, value: number) =>
    pointEquations({ ...point, model, parameter, values: [value] }, policies)[0]?.numbers;
  // Chapter 3: 10 (h − 5)⁺ and 10 γ⁵ / (1 − γ); γ = 0.9 gives 59.049.
  expect(numbers('finite-horizon', 8, 30)).toBe('10 · max(0, 8 − 5) = 30.000');
  expect(numbers('discounted', 0.9, 59.049)).toBe('10 · 0.9^5 / (1 − 0.9) = 59.049');
  expect(numbers('average', 0, 10)).toBe('10.000');
});
