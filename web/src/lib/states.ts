/** Session states and controls in words. */

import type { Control } from './api';
import type { Session, State } from './protocol';

/** Kind of a state: decides its colour; icon and word always stand beside it. */
export type Tone = 'quiet' | 'busy' | 'good' | 'warn' | 'bad';

/** What each state is called, and how it is marked. */
export const STATES: Record<State, { word: string; tone: Tone; meaning: string }> = {
  queued: { word: 'Queued', tone: 'quiet', meaning: 'Waiting to be started' },
  starting: { word: 'Starting', tone: 'busy', meaning: 'Loading its world or checkpoint' },
  running: { word: 'Running', tone: 'busy', meaning: 'Taking control steps' },
  paused: { word: 'Paused', tone: 'warn', meaning: 'Held between two ticks' },
  stopping: { word: 'Stopping', tone: 'warn', meaning: 'Writing its last checkpoint' },
  stopped: { word: 'Stopped', tone: 'quiet', meaning: 'Ended before its last trial' },
  finished: { word: 'Finished', tone: 'good', meaning: 'All trials done' },
  failed: { word: 'Failed', tone: 'bad', meaning: 'Could not go on' },
  interrupted: { word: 'Interrupted', tone: 'bad', meaning: 'The server ended while it ran' },
};

/** What an acknowledged control is reported as. */
export const DONE: Record<Control, string> = {
  start: 'Started',
  pause: 'Paused',
  resume: 'Resumed',
  step: 'Stepped',
  stop: 'Stopped',
  reset: 'Reset',
};

/** The control that the space bar stands for now, if any. */
export function mainControl(session: Session): Control | null {
  const order: Control[] = ['pause', 'resume', 'start'];
  return order.find((control) => session.controls.includes(control)) ?? null;
}

/** Speeds offered, slowest first. */
export const SPEEDS = [1, 5, 30, 100, 1000, 'max'] as const;
