import { expect, it } from 'vitest';

import {
  copyPath,
  goOnPath,
  likePath,
  reproductionPath,
  routeOf,
  sessionInPath,
  rulesPath,
  sessionPath,
  worldPath,
  type Route,
} from './route';

it.each<[string, Route]>([
  ['/', { page: 'home', world: '', network: '', like: '' }],
  [sessionInPath('a&b'), { page: 'home', world: 'a&b', network: '', like: '' }],
  [goOnPath('a&b'), { page: 'home', world: '', network: 'a&b', like: '' }],
  [likePath('a&b'), { page: 'home', world: '', network: '', like: 'a&b' }],
  [sessionPath('a/b'), { page: 'session', id: 'a/b' }],
  ['/sessions/x/', { page: 'session', id: 'x' }],
  ['/reproduce', { page: 'reproductions' }],
  ['/lost-at-sea', { page: 'lost-at-sea' }],
  [rulesPath('navigator'), { page: 'rules', name: 'navigator' }],
  ['/rules', { page: 'unknown' }],
  [reproductionPath('table 5.1'), { page: 'reproduction', target: 'table 5.1' }],
  ['/worlds', { page: 'worlds' }],
  ['/worlds/', { page: 'worlds' }],
  ['/worlds/new', { page: 'new-world', from: '' }],
  [copyPath('two rooms'), { page: 'new-world', from: 'two rooms' }],
  [worldPath('two rooms'), { page: 'world', name: 'two rooms' }],
  ['/worlds/%', { page: 'unknown' }],
  ['/worlds/a/b', { page: 'unknown' }],
  ['/elsewhere', { page: 'unknown' }],
])('%s', (address, route) => {
  expect(routeOf(address)).toEqual(route);
});
