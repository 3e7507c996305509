/** How far a session is: in trials of a path, episodes of competitors with tables, or runs of a drive. */

import { methodName } from './drive/names';
import type { LiveSession } from './live.svelte';
import type { CourseView, Session, TaskView } from './protocol';

/** Progress in words and numbers. */
export interface Progress {
  /** What the bar counts. */
  label: string;
  max: number;
  done: number;
  /** "Trial 3 of 20". */
  words: string;
  /** "step 9"; empty when there is none to tell. */
  step: string;
}

/** What a session's progress is read from. */
export type Present = Pick<LiveSession, 'tick' | 'step' | 'cycle'>;

/** How far a session is. */
export function progressOf(session: Session, live: Present): Progress {
  switch (session.family) {
    case 'table':
      return ofTable(session, live);
    case 'drive':
      return ofDrive(session, live);
    case 'path':
      return ofPath(session, live);
  }
}

function ofPath(session: Session, { tick }: Present): Progress {
  const { trials, trials_done } = session;
  const present = presentOf(session, trials_done, trials);
  // Between two trials the last step belongs to the trial before.
  const step = session.tick > 0 && tick?.trial === present ? `step ${tick.step}` : '';
  const words = `Trial ${present} of ${trials}`;
  return { label: 'Trials done', max: trials, done: trials_done, words, step };
}

function ofTable(session: Session, { step }: Present): Progress {
  const { rounds, rounds_done } = session;
  const present = presentOf(session, rounds_done, rounds);
  const words = `Round ${present} of ${rounds}`;
  const shown = session.tick > 0 && step?.round === present ? stepWords(step) : '';
  return { label: 'Rounds done', max: rounds, done: rounds_done, words, step: shown };
}

function ofDrive(session: Session, { cycle }: Present): Progress {
  const { rounds, rounds_done } = session;
  const present = presentOf(session, rounds_done, rounds);
  const words = `Run ${present} of ${rounds}`;
  // Between two runs the last cycle belongs to the run before.
  const shown = session.tick > 0 && cycle?.round === present;
  const step = shown ? `by ${methodName(cycle.method)}, cycle ${cycle.cycle}` : '';
  return { label: 'Runs done', max: rounds, done: rounds_done, words, step };
}

function stepWords(step: NonNullable<LiveSession['step']>): string {
  switch (step.kind) {
    case 'walk': {
      const training = step.training ? ', training' : '';
      return `episode ${step.episode} of ${step.entrant}${training}, trial ${step.trial}, step ${step.step}`;
    }
    case 'pull':
      return `episode ${step.episode} of ${step.entrant}, pull ${step.pull}`;
    case 'point':
      return `point ${step.tick}`;
  }
}

function presentOf(session: Session, done: number, all: number): number {
  return session.state === 'finished' ? all : Math.min(done + 1, all);
}

/** How long its episodes are, and how many each competitor has; nothing where there is but one. */
export function tableFacts(session: Session, task: TaskView | null): [string, string][] {
  if (task?.kind === 'policies') return [];
  const { episodes } = session.settings;
  const each = task?.kind === 'levers' ? 'Pulls an episode' : 'Trials an episode';
  return [
    ...(episodes === undefined ? [] : [['Episodes', String(episodes)] as [string, string]]),
    [each, String(session.trials)],
  ];
}

/** By which methods a course is driven, and how often by each. */
export function driveFacts(session: Session, course: CourseView | null): [string, string][] {
  const drivers = (course?.drivers ?? []).map(methodName).join(', then ');
  return [
    ...(drivers ? [[course?.rules ? 'Driven by' : 'Looked at', drivers] as [string, string]] : []),
    [course && course.drivers.length > 1 ? 'Runs of each method' : 'Runs', String(session.trials)],
  ];
}

/** "3 of 20 trials", in the list of sessions. */
export function doneWords({ family, trials, trials_done, rounds, rounds_done }: Session): string {
  if (family === 'path') return `${trials_done} of ${trials} trials`;
  return `${rounds_done} of ${rounds} ${family === 'table' ? 'episodes' : 'runs'}`;
}
