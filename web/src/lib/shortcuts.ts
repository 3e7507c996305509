/** Keys of the session page. */

import type { Family } from './protocol';
import { ROUNDS } from './states';

/** What a key asks for. */
export type Wish = 'main' | 'step' | 'step-trial' | 'help';

/** The keys, as the help dialog lists them. */
export const SHORTCUTS: { keys: string; wish: Wish; does: string }[] = [
  { keys: 'Space', wish: 'main', does: 'Start, pause or resume' },
  { keys: 'S', wish: 'step', does: 'One control step' },
  { keys: 'T', wish: 'step-trial', does: 'To the end of the trial' },
  { keys: '?', wish: 'help', does: 'This list' },
];

/** The keys as they act in a session of this kind. */
export function shortcuts(family: Family): typeof SHORTCUTS {
  if (family === 'path') return SHORTCUTS;
  const does: Partial<Record<Wish, string>> = {
    step: family === 'drive' ? 'One cycle of the sonars' : 'One step',
    'step-trial': `To the end of the ${ROUNDS[family]}`,
  };
  return SHORTCUTS.map((each) => ({ ...each, does: does[each.wish] ?? each.does }));
}

/** The wish behind a key, unless it belongs to what has the focus. */
export function wishOf(event: KeyboardEvent): Wish | null {
  if (event.ctrlKey || event.metaKey || event.altKey || event.repeat) return null;
  const key = event.key === ' ' ? 'space' : event.key.toLowerCase();
  const wish = SHORTCUTS.find((shortcut) => shortcut.keys.toLowerCase() === key)?.wish ?? null;
  return wish && belongsToFocus(event.target, key) ? null : wish;
}

/** Typing keeps every key; a button, link or opened list keeps its space bar. */
function belongsToFocus(target: EventTarget | null, key: string): boolean {
  if (!(target instanceof Element)) return false;
  if (target.closest('dialog, input, textarea, select, [contenteditable]')) return true;
  return key === 'space' && target.closest('button, a, summary, [tabindex="0"]') !== null;
}
