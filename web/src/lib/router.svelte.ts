/** Which page the address asks for. */

import type { Session } from './protocol';

/** A page. */
export type Route =
  | { page: 'home' }
  | { page: 'session'; id: string }
  | { page: 'reproductions' }
  | { page: 'reproduction'; target: string }
  | { page: 'unknown' };

/** The page behind a path. */
export function routeOf(path: string): Route {
  if (path === '/') return { page: 'home' };
  if (/^\/reproduce\/?$/.test(path)) return { page: 'reproductions' };
  const [, kind, name] = /^\/(sessions|reproduce)\/([^/]+)\/?$/.exec(path) ?? [];
  if (!name) return { page: 'unknown' };
  const which = decodeURIComponent(name);
  return kind === 'sessions'
    ? { page: 'session', id: which }
    : { page: 'reproduction', target: which };
}

class Router {
  /** The session of the page just gone to, when it was known before. */
  known: Session | null = null;
  route = $state.raw<Route>(routeOf(location.pathname));

  constructor() {
    addEventListener('popstate', () => {
      this.known = null;
      this.#follow();
    });
  }

  /** Goes to a page of this site, with what is already known of the session there. */
  go(path: string, known: Session | null = null): void {
    history.pushState(null, '', path);
    this.known = known;
    this.#follow();
    scrollTo(0, 0);
  }

  /** Follows a plain click on a link within the page, without loading it anew. */
  click(event: MouseEvent): void {
    const link = event.target instanceof Element ? event.target.closest('a') : null;
    const other = event.ctrlKey || event.metaKey || event.shiftKey || event.button !== 0;
    if (!link || other || link.target || link.hasAttribute('download')) return;
    const { origin, pathname, hash } = new URL(link.href);
    if (origin !== location.origin || hash || routeOf(pathname).page === 'unknown') return;
    event.preventDefault();
    this.go(pathname);
  }

  #follow(): void {
    this.route = routeOf(location.pathname);
  }
}

/** The page's address. */
export const router = new Router();

/** Address of the page of a target. */
export const reproductionPath = (target: string) => `/reproduce/${encodeURIComponent(target)}`;

/** Address of a session's page. */
export const sessionPath = (id: string) => `/sessions/${encodeURIComponent(id)}`;
