/** Levers as bars: one scale for what they pay, are believed to pay, and at best may pay. */

import type { BanditView } from '../protocol';

/** One lever. */
export interface Lever {
  name: string;
  mean: number;
  /** None before the first pull. */
  estimate: number | null;
  /** What the strategy compared; none for one that must be tried first, or before the first pull. */
  score: number | null;
  pulls: number;
  chance: number | null;
  isBest: boolean;
  isLast: boolean;
}

/** The levers of a bandit. */
export function leversOf(bandit: BanditView, names: string[]): Lever[] {
  const best = Math.max(...bandit.means);
  return bandit.means.map((mean, index) => {
    const pulls = bandit.pulls[index] ?? 0;
    return {
      name: names[index] ?? String(index),
      mean,
      estimate: pulls > 0 ? (bandit.estimates[index] ?? null) : null,
      score: bandit.step?.scores[index] ?? null,
      pulls,
      chance: bandit.step?.chances[index] ?? null,
      isBest: mean === best,
      isLast: bandit.step?.lever === index,
    };
  });
}

/** The scale that holds all of it, and 0. Bounds far above everything would squeeze the rest: they are cut. */
export function scaleOf(levers: Lever[]): [number, number] {
  const close = levers.flatMap(({ mean, estimate }) =>
    estimate === null ? [mean] : [mean, estimate],
  );
  const [least, most] = [Math.min(0, ...close), Math.max(...close)];
  const room = Math.max(most - least, 1e-9);
  const bounds = levers.flatMap(({ score }) => (score === null ? [] : [score]));
  const reach = Math.max(most, ...bounds.map((bound) => Math.min(bound, most + room)));
  return [least, reach];
}

/** Place of a value on a scale, percent; what lies outside stands at its end. */
export function placeOn([least, most]: [number, number], value: number): number {
  const share = (value - least) / (most - least || 1);
  return 100 * Math.max(0, Math.min(1, share));
}
