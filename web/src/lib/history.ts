/** How the session's history grows in the page: bounded, in order, without doubles. */

import type { LogEntry, Session, Trial } from './protocol';

/** Lines of the event log kept in the page. */
export const LOG_LINES = 500;

/** Trials with new ones added; a trial told twice stands once, as told last. */
export function addTrials(trials: Trial[], added: Trial[]): Trial[] {
  const [first, last] = [added[0], trials.at(-1)];
  if (!first) return trials;
  if (!last || last.trial < first.trial) return trials.concat(added);
  const kept = trials.filter((trial) => trial.trial < first.trial);
  return [...kept, ...added];
}

/** Trials the session still stands by; a reset takes them back. */
export function trialsOf(session: Session, trials: Trial[]): Trial[] {
  if (session.trials_done >= trials.length) return trials;
  return trials.filter((trial) => trial.trial <= session.trials_done);
}

/** The newest lines of the log. */
export function addLog(log: LogEntry[], added: LogEntry[]): LogEntry[] {
  return [...log, ...added].slice(-LOG_LINES);
}
