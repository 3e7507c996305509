import { describe, expect, it } from 'vitest';

import { birthWords, facts, sentences, turnWords } from './decision';
import type { TickView } from './protocol';
import { sampleNeuron, sampleTick, SETTINGS } from './sample';

const told = (changes: Partial<TickView> = {}, settings = {}) =>
  sentences(sampleTick(changes), { ...SETTINGS, ...settings });

describe('a decision in words', () => {
  it('tells situation, adaptation, action and consequence', () => {
    expect(told()).toEqual([
      'Neuron 17 won in the room (distance 0.08 ≤ 0.10)',
      "Neuron 12's utility rose from −3.20 to −2.84 (δ = +0.72)",
      'Neuron 17 drove: turn 12.8° right, then advance',
      'No contact; reinforcement −0.31',
    ]);
  });

  it.each<[string, Partial<TickView>]>([
    [
      'There was no neuron in the door yet, so neuron 3 was added',
      { region: 'door', winner: null, born: 3 },
    ],
    [
      'Neuron 17 was nearest in the room but too far (distance 0.24 > 0.10), so neuron 18 was added; its action was copied',
      { winner: { neuron: 17, distance: 0.24 }, born: 18, neuron: 18 },
    ],
    [
      'Neuron 17 was nearest in the room but too far (distance 0.24 > 0.10), so neuron 18 was added; it makes for (1.50, −0.25) of the record path',
      {
        winner: { neuron: 17, distance: 0.24 },
        born: 18,
        neuron: 18,
        toward_m: [1.5, -0.25],
      },
    ],
    ['No neuron is in charge in the room: learning is off', { winner: null, neuron: null }],
  ])('tells growth: %s', (sentence, changes) => {
    expect(told(changes)[0]).toBe(sentence);
  });

  it('compares the square when the session does', () => {
    expect(told({}, { 'learner.novelty_metric': 'squared' })[0]).toContain('distance² 0.01 ≤ 0.10');
  });

  it.each<[string, TickView['adaptation']]>([
    ['Nothing to adapt: this is the first step of the trial', { kind: 'no-past' }],
    ['Nothing was adapted: temporal-difference learning is off', { kind: 'off' }],
    [
      'Nothing was adapted: a utility is still pending (past neuron 12)',
      { kind: 'pending', past: 12 },
    ],
    [
      'The TD error +51.20 exceeded Δ = 50, so neuron 19 was split off from neuron 12',
      { kind: 'split', past: 12, delta: 51.2, added: 19 },
    ],
  ])('tells adaptation: %s', (sentence, adaptation) => {
    expect(told({ adaptation })[1]).toBe(sentence);
  });

  it('tells who drove', () => {
    expect(told({ source: 'reflex' })[2]).toMatch(/^The bare reflex drove/);
  });

  it('tells what led the robot past its neuron', () => {
    const aim = { x_m: 2, y_m: -1, beyond_m: null, then: 40 };
    expect(told({ source: 'bend', aim })[2]).toBe(
      'Past neuron 17 the robot kept to the way that bends, to (2.00, −1.00) m, where neuron 40 takes over: turn 12.8° right, then advance',
    );
    expect(told({ source: 'pursuit', toward_m: [1.5, -0.25] })[2]).toBe(
      'Neuron 17 is not of the record path; the robot went back to it, for (1.50, −0.25): turn 12.8° right, then advance',
    );
  });

  it('tells of both legs of a way that bends', () => {
    const aim = { x_m: 2, y_m: -1, beyond_m: [4, 0.5] as [number, number], then: 40 };
    expect(told({ aim })[2]).toBe(
      'Neuron 17 drove along a shortcut to (2.00, −1.00) m and from there to (4.00, 0.50) m, where neuron 40 takes over: turn 12.8° right, then advance',
    );
  });

  it('tells how far odometry is off', () => {
    const fact = (fix: TickView['fix']) =>
      facts(sampleTick({ fix }), []).find(([label]) => label === 'Odometry alone')?.[1];
    const odometry = { x_m: 0.03, y_m: -0.04, heading_deg: 31 };
    expect(fact({ odometry, echoes: 14, spread_m: 0.01 })).toBe('0.05 m off; 14 echoes agree');
    expect(fact({ odometry, echoes: 0, spread_m: 0.01 })).toMatch(/nothing heard here before$/);
    expect(fact(null)).toBeUndefined();
  });

  it('tells collisions and the goal', () => {
    const { outcome } = sampleTick();
    expect(told({ outcome: { ...outcome, contact: 'virtual', backed_m: 0.12 } })[3]).toBe(
      'A virtual collision (infrared), backed off 0.12 m; reinforcement −0.31',
    );
    expect(told({ outcome: { ...outcome, reached_goal: true } })[3]).toMatch(
      /the goal is reached$/,
    );
  });

  it('names the side of a turn', () => {
    expect([4.25, -4.25, 0.01].map(turnWords)).toEqual([
      'turn 4.3° left, then advance',
      'turn 4.3° right, then advance',
      'straight on',
    ]);
  });

  it('reads a birth certificate', () => {
    expect(birthWords(sampleNeuron(1, 0, 0))).toBe(
      'Added because the nearest neuron was too far (0.140); action from the reflex',
    );
  });
});
