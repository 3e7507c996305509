/** Light or dark: the system's choice until the reader makes one, which is kept. */

import type { ThemeName } from './protocol';

const KEY = 'sonarium.theme';

class Theme {
  #system = matchMedia('(prefers-color-scheme: dark)');
  current = $state<ThemeName>('light');

  constructor() {
    this.#apply();
    this.#system.addEventListener('change', () => this.#apply());
  }

  /** Changes to the other theme and remembers it. */
  toggle(): void {
    const chosen: ThemeName = this.current === 'dark' ? 'light' : 'dark';
    try {
      localStorage.setItem(KEY, chosen);
    } catch {
      // Without storage the choice lasts until the page is left.
    }
    this.#apply(chosen);
  }

  #apply(chosen: ThemeName | null = stored()): void {
    this.current = chosen ?? (this.#system.matches ? 'dark' : 'light');
    document.documentElement.dataset['theme'] = this.current;
  }
}

function stored(): ThemeName | null {
  try {
    const kept = localStorage.getItem(KEY);
    return kept === 'light' || kept === 'dark' ? kept : null;
  } catch {
    return null;
  }
}

/** The theme in force. */
export const theme = new Theme();
