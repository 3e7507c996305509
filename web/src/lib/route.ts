/** Pages and their addresses. */

/** A page. */
export type Route =
  | {
      page: 'home';
      world: string;
      network: string;
      like: string;
      experiment: string;
      set: string[];
    }
  | { page: 'calibration' }
  | { page: 'session'; id: string }
  | { page: 'reproductions' }
  | { page: 'reproduction'; target: string }
  | { page: 'worlds' }
  | { page: 'new-world'; from: string }
  | { page: 'world'; name: string }
  | { page: 'lost-at-sea' }
  | { page: 'rules'; name: string }
  | { page: 'unknown' };

/** The page behind an address: path and query. */
export function routeOf(address: string): Route {
  const [path = '', search = ''] = address.split('?');
  const asked = new URLSearchParams(search);
  if (path === '/') {
    const of = (name: string) => asked.get(name) ?? '';
    const [world, network, like] = [of('world'), of('network'), of('like')];
    return {
      page: 'home',
      world,
      network,
      like,
      experiment: of('experiment'),
      set: asked.getAll('set'),
    };
  }
  const id = within(path, 'sessions');
  if (id !== null) return { page: 'session', id };
  if (/^\/reproduce\/?$/.test(path)) return { page: 'reproductions' };
  const target = within(path, 'reproduce');
  if (target !== null) return { page: 'reproduction', target };
  if (/^\/lost-at-sea\/?$/.test(path)) return { page: 'lost-at-sea' };
  if (/^\/calibration\/?$/.test(path)) return { page: 'calibration' };
  if (/^\/worlds\/?$/.test(path)) return { page: 'worlds' };
  const rules = within(path, 'rules');
  if (rules !== null) return { page: 'rules', name: rules };
  const name = within(path, 'worlds');
  if (name === 'new') return { page: 'new-world', from: asked.get('from') ?? '' };
  return name === null ? { page: 'unknown' } : { page: 'world', name };
}

function within(path: string, folder: string): string | null {
  const match = new RegExp(`^/${folder}/([^/]+)/?$`).exec(path);
  try {
    return match?.[1] === undefined ? null : decodeURIComponent(match[1]);
  } catch {
    return null;
  }
}

/** Address of a session's page. */
export const sessionPath = (id: string) => `/sessions/${encodeURIComponent(id)}`;

/** Address of the page of a target. */
export const reproductionPath = (target: string) => `/reproduce/${encodeURIComponent(target)}`;

/** Address of the page of a rule base. */
export const rulesPath = (name: string) => `/rules/${encodeURIComponent(name)}`;

/** Address of a world's editor. */
export const worldPath = (name: string) => `/worlds/${encodeURIComponent(name)}`;

/** Address of the editor of a new world that begins as a copy of another. */
export const copyPath = (name: string) => `/worlds/new?from=${encodeURIComponent(name)}`;

/** Address of the form for a new session in a world. */
export const sessionInPath = (name: string) => `/?world=${encodeURIComponent(name)}`;

/** Address of the form for a new session that begins with the network of another. */
export const goOnPath = (id: string) => `/?network=${encodeURIComponent(id)}`;

/** Address of the form for a new session with the settings of another. */
export const likePath = (id: string) => `/?like=${encodeURIComponent(id)}`;

/** Address of the form for a new session of an experiment with some settings, as they are typed. */
export function sessionWithPath(
  experiment: string,
  settings: { key: string; value: string }[],
): string {
  const asked = new URLSearchParams({ experiment });
  for (const { key, value } of settings) asked.append('set', `${key}=${value}`);
  return `/?${asked}`;
}
