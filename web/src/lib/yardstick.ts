/** The best path a planner finds, in words, and the regret of trials against it. */

import { number } from './format';
import type { Trial, Yardstick } from './protocol';

/** What is known of the best path a planner finds, in a sentence. */
export function plannedWords(yardstick: Yardstick): string {
  switch (yardstick.state) {
    case 'computing':
      return 'Best path a planner finds: being computed';
    case 'none':
      return 'No planned path to compare with';
    case 'ready':
      return `Best path a planner finds (dashed): R* = ${number(yardstick.total_reinforcement)} in ${yardstick.steps} steps`;
  }
}

/** A trial with its regret R* − R(n), where it has one: with the goal where it truly was, as the planner has it. */
export function withRegret(trial: Trial, yardstick: Yardstick): Trial {
  if (yardstick.state !== 'ready' || !trial.reached_goal) return { ...trial, regret: null };
  const truly = trial.safety + (trial.true_goal ?? trial.goal);
  return { ...trial, regret: yardstick.total_reinforcement - truly };
}

/** A regret in percent of what the best path costs; empty where that is nothing. */
export function regretShare(regret: number, yardstick: Yardstick): string {
  const cost = yardstick.state === 'ready' ? -yardstick.total_reinforcement : 0;
  return cost > 0 ? `${number((100 * regret) / cost, 0)} %` : '';
}
