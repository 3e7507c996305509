import { describe, expect, it } from 'vitest';

import type { ExperimentInfo, Family, SettingInfo } from './protocol';
import {
  changed,
  grouped,
  parsed,
  parsedSeed,
  range,
  said,
  saidBriefly,
  trialsLabel,
  typedFrom,
  unreadable,
} from './settings';

function setting(key: string, kind: string, value: number | string | boolean): SettingInfo {
  return {
    key,
    kind,
    meaning: `What ${key} means`,
    unit: '1',
    default: value,
    min: 0,
    max: 2,
    choices: [],
    source: 'Eq. (5.9)',
    standing: 'literal',
  };
}

const noise = setting('sonar.noise', 'number', 0.01);
const rays = setting('sonar.rays', 'integer', 5);
const learning = setting('learner.learning', 'switch', true);
const info = {
  settings: [setting('preset', 'choice', 'learner'), noise, rays, learning],
} as unknown as ExperimentInfo;
const preset = { name: 'quiet', title: '', summary: '', settings: { 'sonar.noise': 0 } };

it('takes what an address gives as if it were typed, and leaves out what there is not', () => {
  const given = ['sonar.noise=0.5', 'learner.learning=false', 'elsewhere=1', 'sonar.rays'];
  expect(typedFrom(info, given)).toEqual({ 'sonar.noise': '0.5', 'learner.learning': false });
});

describe('settings that are sent', () => {
  it.each([
    ['nothing typed', {}, {}],
    ['the preset’s own value', { 'sonar.noise': '0' }, {}],
    ['the default where the preset differs', { 'sonar.noise': '0.01' }, { 'sonar.noise': 0.01 }],
    ['a switch', { 'learner.learning': false }, { 'learner.learning': false }],
    ['what cannot be read', { 'sonar.noise': 'much', 'sonar.rays': '2.5' }, {}],
  ])('%s', (_, typed, sent) => {
    expect(changed(info, preset, typed)).toEqual(sent);
  });

  it('names what cannot be read', () => {
    expect(unreadable(info, { 'sonar.noise': '', 'sonar.rays': '7' })).toEqual(['sonar.noise']);
  });
});

it('reads numbers as people type them', () => {
  expect(['0,5', ' 1e-3 ', '−2', 'x', ''].map((text) => parsed(noise, text))).toEqual([
    0.5,
    0.001,
    -2,
    null,
    null,
  ]);
  expect(parsed(rays, '2.5')).toBeNull();
});

it('reads seeds up to 2⁵³ − 1', () => {
  expect(['', '42', '9007199254740991', '9007199254740992', '-1', '1.5'].map(parsedSeed)).toEqual([
    undefined,
    42,
    9007199254740991,
    null,
    null,
    null,
  ]);
});

it('groups by prefix and searches every word, but not preset and world', () => {
  const keys = (search: string) =>
    grouped(info.settings, search).map((group) => [group.name, group.settings.length]);
  expect(keys('')).toEqual([
    ['sonar', 2],
    ['learner', 1],
  ]);
  expect(keys('noise literal')).toEqual([['sonar', 1]]);
  expect(keys('nothing')).toEqual([]);
  // The form asks for the number of trials by itself.
  expect(grouped([setting('trials', 'integer', 100)], '')).toEqual([]);
});

it('says ranges and values', () => {
  expect(range({ ...noise, unit: 'm' })).toBe('0 to 2 m');
  expect([said(true), said(-3), said('sonar-range'), said(undefined)]).toEqual([
    'on',
    '−3',
    'sonar-range',
    '–',
  ]);
});

it('takes words and tables as they are, also none, and says how long they are', () => {
  const advice = setting('advice', 'text', '');
  expect([parsed(advice, ''), parsed(advice, 'if\n')]).toEqual(['', 'if\n']);
  const matrix = '[[1, 1, -1],\n [1, 1, 1]]';
  expect([saidBriefly(''), saidBriefly('short'), saidBriefly(matrix), saidBriefly(3)]).toEqual([
    'none',
    'short',
    '2 lines',
    '3',
  ]);
});

it('says what a session is given a number of', () => {
  const label = (family: Family, name: string) => trialsLabel({ family, name });
  expect(label('path', 'a')).toBe('Trials');
  expect(label('drive', 'corridor')).toBe('Runs of each method');
  expect(['labyrinth', 'bandit', 'horizon'].map((name) => label('table', name))).toEqual([
    'Trials an episode',
    'Pulls an episode',
    '',
  ]);
});
