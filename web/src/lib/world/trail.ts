/** What was edited, step by step, for undo and redo. */

/** A present state between those undone to and those redone to. */
export interface Trail<T> {
  past: readonly T[];
  present: T;
  future: readonly T[];
  /** What the present edit belongs to: edits under one key count as one. */
  key: string;
}

/** Most steps that can be undone. */
const LONGEST = 200;

/** A trail that begins here. */
export function begun<T>(present: T): Trail<T> {
  return { past: [], present, future: [], key: '' };
}

/** Goes on to a new state. Edits in a row with the same key, like those of one drag, are one step. */
export function edited<T>(trail: Trail<T>, present: T, key = ''): Trail<T> {
  if (present === trail.present) return trail;
  const same = key !== '' && key === trail.key;
  const past = same ? trail.past : [...trail.past, trail.present].slice(-LONGEST);
  return { past, present, future: [], key };
}

/** Ends an edit: the next one is a step of its own, whatever its key. */
export function settled<T>(trail: Trail<T>): Trail<T> {
  return trail.key === '' ? trail : { ...trail, key: '' };
}

/** One step back; the same when there is none. */
export function undone<T>(trail: Trail<T>): Trail<T> {
  const present = trail.past.at(-1);
  if (present === undefined) return trail;
  const future = [trail.present, ...trail.future];
  return { past: trail.past.slice(0, -1), present, future, key: '' };
}

/** One step forth; the same when there is none. */
export function redone<T>(trail: Trail<T>): Trail<T> {
  const [present, ...future] = trail.future;
  if (present === undefined) return trail;
  return { past: [...trail.past, trail.present], present, future, key: '' };
}
