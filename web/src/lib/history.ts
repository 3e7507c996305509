/** How the session's history grows in the page: bounded, in order, without doubles. */

import type { EpisodeView, LogEntry, Session, Trial } from './protocol';

/** Lines of the event log kept in the page. */
export const LOG_LINES = 500;

/** Trials kept in the page, the newest; a longer history is in the downloads. */
export const TRIALS_KEPT = 1000;

/** Trials with new ones added; a trial told twice stands once, as told last. */
export function addTrials(trials: Trial[], added: Trial[]): Trial[] {
  const [first, last] = [added[0], trials.at(-1)];
  if (!first) return trials;
  const repeats = last !== undefined && last.trial >= first.trial;
  const kept = repeats ? trials.filter((trial) => trial.trial < first.trial) : trials;
  return kept.concat(added).slice(-TRIALS_KEPT);
}

/** Trials the session still stands by; a reset takes them back. */
export function trialsOf(session: Session, trials: Trial[]): Trial[] {
  if (session.trials_done >= (trials.at(-1)?.trial ?? 0)) return trials;
  return trials.filter((trial) => trial.trial <= session.trials_done);
}

/** Episodes kept in the page, the newest. */
export const EPISODES_KEPT = 400;

/** Episodes with new ones added; one told twice stands once, as told last. */
export function addEpisodes(episodes: EpisodeView[], added: EpisodeView[]): EpisodeView[] {
  const first = added[0];
  if (!first) return episodes;
  const kept = episodes.filter((episode) => episode.round < first.round);
  return kept.concat(added).slice(-EPISODES_KEPT);
}

/** Episodes the session still stands by; a reset takes them back. */
export function episodesOf(session: Session, episodes: EpisodeView[]): EpisodeView[] {
  if (session.rounds_done >= (episodes.at(-1)?.round ?? 0)) return episodes;
  return episodes.filter((episode) => episode.round <= session.rounds_done);
}

/** How many of the session's trials are shown, when it is not all. */
export function shownOf(session: Session, trials: Trial[]): string {
  const first = trials[0]?.trial ?? 1;
  if (first === 1) return '';
  return `newest ${trials.length} of ${session.trials_done} trials, all are in the CSV`;
}

/** The newest lines of the log. */
export function addLog(log: LogEntry[], added: LogEntry[]): LogEntry[] {
  return [...log, ...added].slice(-LOG_LINES);
}
