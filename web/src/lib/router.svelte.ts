/** Which page the address asks for. */

import type { Session } from './protocol';
import { routeOf, type Route } from './route';

export * from './route';

/** What one page hands to the next. */
export interface Handed {
  /** Settings to fill into the form of a new session, as they would be typed. */
  settings: Record<string, string>;
}

class Router {
  /** The session of the page just gone to, when it was known before. */
  known: Session | null = null;
  route = $state.raw<Route>(routeOf(addressOf(location)));
  /** An address that was not gone to because the page would lose changes; its page asks. */
  held = $state<string | null>(null);
  /** Whether leaving the present page would lose something. */
  #guard: () => boolean = () => false;
  #address = addressOf(location);

  constructor() {
    addEventListener('popstate', () => this.#popped());
    addEventListener('beforeunload', (event) => {
      if (this.#guard()) event.preventDefault();
    });
  }

  /** Asks before the page is left while `unsaved` holds; answers how to stop asking. */
  guard(unsaved: () => boolean): () => void {
    this.#guard = unsaved;
    return () => {
      this.#guard = () => false;
      this.held = null;
    };
  }

  /** What was handed to the present page; it survives a reload. */
  get handed(): Handed | null {
    return (history.state as Handed | null) ?? null;
  }

  /** Goes to a page of this site, with what is already known of the session there. */
  go(address: string, known: Session | null = null, handed: Handed | null = null): void {
    if (this.#guard()) {
      this.held = address;
      return;
    }
    history.pushState(handed, '', address);
    this.known = known;
    this.#follow();
    scrollTo(0, 0);
  }

  /** Goes where the reader was held back from, and loses what is unsaved. */
  leave(): void {
    const address = this.held;
    this.#guard = () => false;
    this.held = null;
    if (address !== null) this.go(address);
  }

  /** Gives the present page, as it stands, another address. */
  rename(address: string): void {
    history.replaceState(null, '', address);
    this.#address = address;
  }

  /** Follows a plain click on a link within the page, without loading it anew. */
  click(event: MouseEvent): void {
    const link = event.target instanceof Element ? event.target.closest('a') : null;
    const other = event.ctrlKey || event.metaKey || event.shiftKey || event.button !== 0;
    if (!link || other || link.target || link.hasAttribute('download')) return;
    const url = new URL(link.href);
    const address = addressOf(url);
    if (url.origin !== location.origin || url.hash || routeOf(address).page === 'unknown') return;
    event.preventDefault();
    this.go(address);
  }

  /** Back or forward: the address has changed already. */
  #popped(): void {
    const wanted = addressOf(location);
    if (wanted !== this.#address && this.#guard()) {
      history.pushState(null, '', this.#address);
      this.held = wanted;
      return;
    }
    this.known = null;
    this.#follow();
  }

  #follow(): void {
    this.#address = addressOf(location);
    this.route = routeOf(this.#address);
  }
}

function addressOf({ pathname, search }: { pathname: string; search: string }): string {
  return pathname + search;
}

/** The page's address. */
export const router = new Router();
