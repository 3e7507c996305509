/** Session states and controls in words. */

import type { Control } from './api';
import type { Ack, Family, Session, State, StepUnit } from './protocol';

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

/** What each control leads to, and what it is called when it did. */
const DONE: Record<Control, { state: State; word: string }> = {
  start: { state: 'running', word: 'Started' },
  pause: { state: 'paused', word: 'Paused' },
  resume: { state: 'running', word: 'Resumed' },
  step: { state: 'paused', word: 'Stepped' },
  stop: { state: 'stopped', word: 'Stopped' },
  reset: { state: 'queued', word: 'Reset' },
};

/** What a session of each kind goes through, one after the other. */
export const ROUNDS: Record<Family, string> = { path: 'trial', table: 'episode', drive: 'run' };

/** What a control led to, e.g. "Paused at tick 132"; the state's name when it led elsewhere. */
export function outcome(
  control: Control,
  unit: StepUnit | undefined,
  ack: Ack,
  family: Family = 'path',
): string {
  const { state, word } = DONE[control];
  const far = unit === 'trial' ? `${word} to the end of the ${ROUNDS[family]}` : word;
  return `${ack.state === state ? far : STATES[ack.state].word} at tick ${ack.tick}`;
}

/** The control that the space bar stands for now, if any. */
export function mainControl(session: Session): Control | null {
  const order: Control[] = ['pause', 'resume', 'start'];
  return order.find((control) => session.controls.includes(control)) ?? null;
}

/** Speeds offered, slowest first. */
export const SPEEDS = [1, 5, 30, 100, 1000, 'max'] as const;
