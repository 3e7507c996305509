/** What an intervention did: the episode it fell into, against the same competitor's other episodes. */

import type { EpisodeView, InterventionView } from '../protocol';

/** Mean actions a trial over some trials, and over how many episodes. */
export interface MeanOf {
  mean: number;
  /** Episodes. */
  n: number;
}

/** What was done to an episode in one trial, and what became of it. */
export interface Effect {
  episode: number;
  round: number;
  entrant: string;
  /** Trial it fell into, from 1. */
  trial: number;
  /** In order. */
  interventions: InterventionView[];
  /** Trials before it, in its episode: first and last, from 1; none when it came in the first. */
  before: Compared | null;
  /** Trials from it on. */
  after: Compared;
}

/** The same trials of an episode and of the others. */
export interface Compared {
  first: number;
  last: number;
  /** In the episode of the intervention. */
  here: number;
  /** In the competitor's episodes without any intervention; none when there are none. */
  others: MeanOf | null;
}

/** The effects of all interventions in finished episodes, newest first; those of one trial go together. */
export function effects(episodes: EpisodeView[]): Effect[] {
  return episodes
    .flatMap((episode) => {
      const trials = [...new Set(touched(episode).map(({ trial }) => trial))];
      return trials.map((trial) => effectOf(episode, trial, episodes));
    })
    .filter((effect) => effect !== null)
    .reverse();
}

function effectOf(episode: EpisodeView, trial: number, episodes: EpisodeView[]): Effect | null {
  const trials = trialsOf(episode);
  if (trials.length === 0) return null;
  const others = episodes.filter((other) => isAlike(episode, other)).map(trialsOf);
  const from = Math.min(Math.max(1, trial), trials.length);
  const compare = (first: number, last: number): Compared => ({
    first,
    last,
    here: meanOver(trials, first, last),
    others: meanOfAll(others, first, last),
  });
  return {
    episode: episode.episode,
    round: episode.round,
    entrant: episode.entrant,
    trial,
    interventions: touched(episode).filter((each) => each.trial === trial),
    before: from > 1 ? compare(1, from - 1) : null,
    after: compare(from, trials.length),
  };
}

/** Another episode of the same competitor and task that nobody touched. */
function isAlike(episode: EpisodeView, other: EpisodeView): boolean {
  return (
    other.round !== episode.round &&
    other.entrant === episode.entrant &&
    other.training === episode.training &&
    touched(other).length === 0
  );
}

/** What an operator did to an episode. */
export const touched = ({ interventions }: EpisodeView): InterventionView[] => interventions ?? [];

function trialsOf({ outcome }: EpisodeView): number[] {
  return outcome.kind === 'walk' ? outcome.trials : [];
}

function meanOver(trials: number[], first: number, last: number): number {
  const part = trials.slice(first - 1, last);
  return part.reduce((sum, steps) => sum + steps, 0) / part.length;
}

/** Mean over episodes that have all these trials. */
function meanOfAll(episodes: number[][], first: number, last: number): MeanOf | null {
  const whole = episodes.filter((trials) => trials.length >= last);
  if (whole.length === 0) return null;
  const sum = whole.reduce((sum, trials) => sum + meanOver(trials, first, last), 0);
  return { mean: sum / whole.length, n: whole.length };
}
