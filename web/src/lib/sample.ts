/** A control step and a trial for tests, as the server sends them. */

import type { NeuronView, Session, TickView, Trial } from './protocol';

const AT_HOME = { x_m: 0, y_m: 0, heading_deg: 30 };

/** Settings of the default preset that the words of a decision need. */
export const SETTINGS = {
  'learner.novelty': 0.1,
  'learner.novelty_metric': 'distance',
  'learner.discount': 0.7,
  'learner.split_threshold': 50,
};

/** A step in which neuron 17 won and neuron 12 was adapted. */
export function sampleTick(changes: Partial<TickView> = {}): TickView {
  return {
    tick: 132,
    trial: 4,
    step: 9,
    true_pose: AT_HOME,
    pose: AT_HOME,
    fix: null,
    sonar_m: Array.from({ length: 24 }, (_, index) => (index === 3 ? 0.42 : 2)),
    reflectance_pct: 12,
    goal_distance_m: 4.47,
    goal_bearing_deg: -26.6,
    region: 'room',
    winner: { neuron: 17, distance: 0.08 },
    born: null,
    toward_m: null,
    reflex: null,
    adaptation: {
      kind: 'updated',
      past: 12,
      reinforcement: -0.31,
      present_utility: -3.1,
      utility_before: -3.2,
      delta: 0.72,
      utility_rate: 0.5,
      utility_after: -2.84,
      eligibility: 0.0012,
      mean_before_deg: 1.2,
      mean_after_deg: 1.2,
      centre_shift: 0.0004,
    },
    neuron: 17,
    prototypical_deg: 12,
    utility: -3.1,
    aim: null,
    exploration: {
      temperature_deg: 100,
      mean_deg: 3,
      sigma_deg: 95.7,
      deviation_deg: 3.4,
      drawn_deg: 5.2,
      most_deg: 100,
      xi_deg: 5.2,
    },
    source: 'network',
    action_deg: 17.2,
    action_frame: 'heading',
    rotation_deg: -12.8,
    outcome: {
      true_pose: AT_HOME,
      pose: AT_HOME,
      contact: 'none',
      backed_m: 0,
      reinforcement: -0.31,
      safety: -0.2,
      goal: -0.11,
      close: true,
      reached_goal: false,
    },
    neurons: 40,
    total_reinforcement: -2.5,
    ...changes,
  };
}

/** A trial that reached the goal in 27 steps. */
export function sampleTrial(trial: number, changes: Partial<Trial> = {}): Trial {
  return {
    trial,
    steps: 27,
    total_reinforcement: -6.24,
    safety: -2,
    goal: -4.24,
    true_goal: -4.24,
    neurons: 82,
    born: 3,
    forgotten: 0,
    collisions: 0,
    reached_goal: true,
    record: false,
    scout: false,
    temperature_deg: 10,
    path_m: 5.4,
    regret: null,
    region_steps: {},
    first_tick: 1,
    last_tick: 27,
    ...changes,
  };
}

/** A neuron born at a place. */
export function sampleNeuron(id: number, x_m: number, y_m: number): NeuronView {
  const pose = { x_m, y_m, heading_deg: 0 };
  return {
    id,
    region: 'room',
    prototypical_deg: 0,
    heading_deg: 0,
    mean_deg: 0,
    utility: -1,
    wins: 1,
    birth: {
      trial: 1,
      step: id,
      tick: id,
      cause: 'distance',
      value: 0.14,
      parent: null,
      toward_m: null,
      pose,
    },
  };
}

/** A paused session after 12 of 20 trials. */
export function sampleSession(changes: Partial<Session> = {}): Session {
  return {
    id: 'a1',
    experiment: 'minimum-cost-path',
    state: 'paused',
    reason: null,
    seed: 42,
    preset: 'learner',
    world: 'laboratory',
    settings: {},
    changed: [],
    family: 'path',
    trials: 20,
    trials_done: 12,
    rounds: 20,
    rounds_done: 12,
    reached: 12,
    best: -6.12,
    tick: 329,
    speed: 30,
    build: 'sonarium 0.1.0',
    created_at: '2026-11-22T01:00:00Z',
    changed_at: '2026-11-22T01:00:00Z',
    controls: ['resume', 'step', 'stop', 'reset'],
    ...changes,
  };
}
