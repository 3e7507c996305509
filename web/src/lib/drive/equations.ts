/** Algorithms 1 and 2 with the numbers that really stood in them. */

import type { Equation } from '../equations';
import { brief, capital, number, signed } from '../format';
import type { CycleView, InferenceView, RuleBaseView } from '../protocol';
import { outputName } from './fuzzy';

/** A pass of Algorithm 1 over one more value of the window. */
export interface Pass {
  z_m: number;
  gain: number;
  mean_m: number;
  variance_m2: number;
}

/** Algorithm 1 over a window, oldest first; `variance_m2` is ς². */
export function algorithmOne(window_m: number[], variance_m2: number): Pass[] {
  const [first, ...rest] = window_m;
  if (first === undefined) return [];
  // Eq. (2.6), (2.7): μ = z(t − n), σ² = ς²
  const passes = [{ z_m: first, gain: 1, mean_m: first, variance_m2 }];
  for (const z_m of rest) {
    const before = passes.at(-1)!;
    // G = σ² / (σ² + ς²)
    const gain = before.variance_m2 / (before.variance_m2 + variance_m2);
    passes.push({
      z_m,
      gain,
      mean_m: before.mean_m + gain * (z_m - before.mean_m),
      variance_m2: before.variance_m2 * (1 - gain),
    });
  }
  return passes;
}

/** The newest measured depths of a region, oldest first, at most `size`; those of this run without a gap. */
export function windowOf(
  cycles: CycleView[],
  region: number,
  method: number,
  size: number,
): number[] {
  const found: number[] = [];
  const newest = cycles.at(-1);
  for (const [back, cycle] of cycles.toReversed().entries()) {
    const depth = cycle.regions[region]?.depths_m[method];
    const follows = cycle.tick + back === newest?.tick && cycle.round === newest.round;
    if (!follows || depth === undefined || found.length === size) break;
    found.unshift(depth);
  }
  return found;
}

/** Algorithm 1 for a region as equations. `deviation_m` is ς. */
export function estimation(window_m: number[], deviation_m: number): Equation[] {
  const passes = algorithmOne(window_m, deviation_m ** 2);
  const last = passes.at(-1);
  if (!last) return [];
  const gains = passes.slice(1).map(({ gain }) => number(gain));
  return [
    {
      gives: 'Window',
      symbols: 'z(t − n), …, z(t)',
      numbers: `${window_m.map((z_m) => number(z_m)).join(', ')} m`,
      source: '2.2',
    },
    {
      gives: 'Gains',
      symbols: 'G = σ² / (σ² + ς²)',
      numbers: gains.length > 0 ? gains.join(', ') : 'none yet: the window holds one value',
      source: 'Algorithm 1',
    },
    {
      gives: 'Estimate',
      symbols: 'Δμ = G (z − μ)',
      numbers: `${passes.map(({ mean_m }) => number(mean_m, 3)).join(' → ')} m`,
      source: 'Algorithm 1',
    },
    {
      gives: 'Uncertainty',
      symbols: 'Δσ² = −G σ²',
      numbers: `σ = ${passes.map(({ variance_m2 }) => number(Math.sqrt(variance_m2), 3)).join(' → ')} m`,
      source: 'Algorithm 1',
    },
  ];
}

/** Terms of a sum that are written out. */
const TERMS = 3;

/** Algorithm 2 as equations: the strongest rule and both outputs. */
export function inference(found: InferenceView, base: RuleBaseView): Equation[] {
  const strongest = found.firings[0];
  if (!strongest) return [];
  const factors = strongest.when.map((set, input) => membershipOf(found, base, input, set));
  return [
    {
      gives: `Strength of rule ${strongest.rule}`,
      symbols: 'rᵢ = ∏ⱼ μᵢⱼ(uⱼ)',
      numbers: `${factors.map((factor) => number(factor)).join(' · ')} = ${number(strongest.strength, 3)}`,
      source: '2.26',
    },
    ...base.outputs.map((output, index) => ({
      gives: `${capital(outputName(output))}, ${output.unit}`,
      symbols: `${output.name} = Σ rᵢ ${output.name}ᵢ / Σ rᵢ`,
      numbers: `${sum(found, index)} = ${signed(found.outputs[index] ?? NaN)}`,
      source: 'Algorithm 2',
    })),
  ];
}

/** Membership of an input in one of its sets. */
export function membershipOf(
  { memberships }: InferenceView,
  base: RuleBaseView,
  input: number,
  set: string,
): number {
  const index = base.inputs[input]?.sets.findIndex(({ name }) => name === set) ?? -1;
  return memberships[input]?.[index] ?? NaN;
}

/** The sum of an output, its strongest terms written out. Strengths add up to 1. */
function sum({ firings, fired }: InferenceView, output: number): string {
  const terms = firings
    .slice(0, TERMS)
    .map(({ strength, then }) => `${number(strength)} · ${inSum(then[output] ?? NaN)}`);
  const rest = fired - terms.length;
  return terms.join(' + ') + (rest > 0 ? ` + ${rest} more` : '');
}

const inSum = (value: number) => (value < 0 ? `(${brief(value)})` : brief(value));
