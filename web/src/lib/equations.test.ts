import { describe, expect, it } from 'vitest';

import { equations } from './equations';
import type { TickView } from './protocol';
import { sampleTick, SETTINGS } from './sample';

function numbers(gives: string, changes: Partial<TickView> = {}): string | undefined {
  return equations(sampleTick(changes), SETTINGS).find((each) => each.gives === gives)?.numbers;
}

describe('the equations of a decision', () => {
  it.each([
    ['Winner', 'i = 17, 0.080 ≤ ς = 0.1'],
    ['TD error', '−0.31 + 0.7 · (−3.10) − (−3.20) = 0.72'],
    ['Utility of neuron 12', '−3.20 + 0.5 · (0.72) = −2.84'],
    ['Spread', '100.0° / (1 + exp(−3.10)) = 95.7°'],
    ['Exploration', 'μ = 3.0°, s = 3.4°: 5.2°, not clipped'],
    ['Action', '12.0° + 5.2° = 17.2°'],
    ['Rotation', '17.2° − (30.0°) → −12.8°'],
    ['Reinforcement', '−0.20 + (−0.11) = −0.31, close to a wall'],
  ])('%s: %s', (gives, expected) => {
    expect(numbers(gives)).toBe(expected);
  });

  it('says that a shortcut may turn by more than the temperature', () => {
    const exploration = {
      ...sampleTick().exploration,
      temperature_deg: 10,
      mean_deg: 30,
      most_deg: 30,
    };
    const found = equations(sampleTick({ exploration }), SETTINGS).find(
      (each) => each.gives === 'Exploration',
    );
    expect(found).toMatchObject({
      symbols: 'ξ ~ N(μ, s), clipped to [−|μ|, |μ|]',
      source: '5.12, addition A11',
    });
  });

  it('says when ξ was clipped', () => {
    const exploration = { ...sampleTick().exploration, drawn_deg: 12, xi_deg: 10 };
    expect(numbers('Exploration', { exploration })).toContain('12.0°, clipped to 10.0°');
  });

  it('says when the action wrapped, and never claims a sum that does not add up', () => {
    expect(numbers('Action', { prototypical_deg: 178, action_deg: -176.8 })).toBe(
      '178.0° + 5.2° = −176.8° (wrapped)',
    );
    expect(numbers('Action', { action_deg: 40 })).toBe('12.0° + 5.2°, executed 40.0°');
  });

  it('leaves out what was not at work', () => {
    const quiet = equations(
      sampleTick({ source: 'reflex', winner: null, adaptation: { kind: 'no-past' } }),
      SETTINGS,
    );
    expect(quiet.map((each) => each.gives)).toEqual(['Rotation', 'Reinforcement']);
  });
});
