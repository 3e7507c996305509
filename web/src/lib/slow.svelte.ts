/** Text for screen readers, which must not change faster than it can be heard. */

import { Throttle } from './throttle';

/** Follows a text at most once a second. Call it while a component is set up. */
export function slowly(read: () => string): { readonly text: string } {
  let text = $state('');
  const throttle = new Throttle<string>(1000, (newest) => (text = newest));
  $effect(() => throttle.offer(read()));
  $effect(() => () => throttle.stop());
  return {
    get text() {
      return text;
    },
  };
}
