/** How large a picture has to be drawn to fill a part of the page sharply. */

import type { Size } from './api';

/** The sides that a picture may have, pixels. */
const LEAST = 64;
const MOST = 2048;

/** Tells the size of an element in pixels of the screen, now and whenever it changes. */
export function watchPixels(element: HTMLElement, tell: (size: Size) => void): () => void {
  let last: Size | null = null;
  const watch = new ResizeObserver(() => {
    const ratio = devicePixelRatio || 1;
    const pixels = (length: number) => Math.min(MOST, Math.max(LEAST, Math.round(length * ratio)));
    const size = { width: pixels(element.clientWidth), height: pixels(element.clientHeight) };
    if (size.width === last?.width && size.height === last.height) return;
    last = size;
    tell(size);
  });
  watch.observe(element);
  return () => watch.disconnect();
}
