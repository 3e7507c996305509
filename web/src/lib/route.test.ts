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
  sessionWithPath,
  worldPath,
  type Route,
} from './route';

type Home = Extract<Route, { page: 'home' }>;
const home = (asked: Partial<Home>): Home => ({
  page: 'home',
  world: '',
  network: '',
  like: '',
  experiment: '',
  set: [],
  ...asked,
});

it.each<[string, Route]>([
  ['/', home({})],
  [sessionInPath('a&b'), home({ world: 'a&b' })],
  [goOnPath('a&b'), home({ network: 'a&b' })],
  [likePath('a&b'), home({ like: 'a&b' })],
  [
    sessionWithPath('corridor', [
      { key: 'noise.level', value: '1' },
      { key: 'a', value: 'b=c&d' },
    ]),
    home({ experiment: 'corridor', set: ['noise.level=1', 'a=b=c&d'] }),
  ],
  [sessionPath('a/b'), { page: 'session', id: 'a/b' }],
  ['/sessions/x/', { page: 'session', id: 'x' }],
  ['/reproduce', { page: 'reproductions' }],
  ['/calibration', { page: 'calibration' }],
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
