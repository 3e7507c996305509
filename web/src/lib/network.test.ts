import { describe, expect, it } from 'vitest';

import {
  beganWith,
  bodyOf,
  networkRefusal,
  readNetwork,
  trainedIn,
  trainedWords,
  typedOf,
  unchosen,
} from './network';
import type { ExperimentInfo, Session } from './protocol';

const text =
  '{"format":"sonarium-network","version":1,"world":"laboratory","seed":7,"trials":20,' +
  '"networks":[[{"value":-0.0},{"value":1.0}],[{"value":2.5}]]}';
const session = (id: string, more: Partial<Session>) =>
  ({
    id,
    experiment: 'minimum-cost-path',
    world: 'laboratory',
    seed: 1,
    trials_done: 3,
    created_at: '2026-01-01T00:00:00Z',
    settings: {},
    ...more,
  }) as Session;

describe('a network file', () => {
  it('is read and described', () => {
    const label = 'laboratory, seed 7, 20 trials, 3 neurons';
    expect(readNetwork('net.json', text)).toEqual({ name: 'net.json', text, label });
  });

  it.each([
    ['', 'not JSON'],
    [text.slice(0, 60), 'cut off'],
    ['P5 2 2 255', 'not JSON'],
    ['null', 'is no network file'],
    ['[1, 2]', 'is no network file'],
    ['{"format":"sonarium-world"}', 'is no network file'],
    ['{"format":"sonarium-network"}', 'holds no networks'],
    ['{"format":"sonarium-network","networks":[1]}', 'holds no networks'],
  ])('is refused: %s', (broken, says) => {
    const found = readNetwork('net.json', broken);
    expect('fault' in found && found.fault).toContain(says);
    expect('fault' in found && found.fault).toContain('net.json');
  });
});

describe('sessions to begin with', () => {
  it('are of the experiment, have a trial and come newest first', () => {
    const sessions = [
      session('old', {}),
      session('new', { created_at: '2026-02-01T00:00:00Z' }),
      session('empty', { trials_done: 0 }),
      session('other', { experiment: 'minimum-cost-path-trc' }),
    ];
    expect(trainedIn('minimum-cost-path', sessions).map(({ id }) => id)).toEqual(['new', 'old']);
  });

  it('are said in a line', () => {
    expect(trainedWords(session('ab', {}))).toContain('ab: laboratory, seed 1, 3 trials, 2');
  });
});

describe('the request', () => {
  const asked = { experiment: 'minimum-cost-path', trials: 2 };
  const file = { name: 'net.json', text, label: '' };

  it('names no network, a session, or holds the file as it is', () => {
    expect(bodyOf(asked, { kind: 'empty' })).toBe(JSON.stringify(asked));
    expect(JSON.parse(bodyOf(asked, { kind: 'session', id: 'ab' }))).toEqual({
      ...asked,
      network: 'ab',
    });
    const body = bodyOf(asked, { kind: 'file', file });
    expect(body).toContain(`"network":${text}`);
    expect(JSON.parse(body)).toEqual({ ...asked, network: JSON.parse(text) });
  });

  it('waits until something is chosen', () => {
    expect(unchosen({ kind: 'empty' })).toBe('');
    expect(unchosen({ kind: 'session', id: '' })).toBe('Choose a session.');
    expect(unchosen({ kind: 'session', id: 'ab' })).toBe('');
    expect(unchosen({ kind: 'file', file: null })).toBe('Choose a network file.');
    expect(unchosen({ kind: 'file', file })).toBe('');
  });
});

it.each([
  ['network.sonars', 'must be 10 sonars', 'Not acceptable: network.sonars must be 10 sonars'],
  ['network', 'there is no session `ab`', 'Not acceptable. there is no session `ab`'],
])('says what is wrong with %s', (field, detail, said) => {
  const problem = { type: 'about:blank', title: 'Not acceptable', status: 422, detail, field };
  expect(networkRefusal(problem)).toBe(said);
});

it('types a session’s settings over those of its preset', () => {
  const info = {
    settings: [
      { key: 'preset', default: 'default' },
      { key: 'world', default: 'laboratory' },
      { key: 'sonar.noise', default: 0.01 },
      { key: 'sonar.rays', default: 5 },
      { key: 'learner.learning', default: true },
      { key: 'learner.regions', default: 'two' },
    ],
  } as unknown as ExperimentInfo;
  const preset = { name: 'quiet', title: '', summary: '', settings: { 'sonar.noise': 0 } };
  const settings = {
    preset: 'quiet',
    world: 'hall',
    network: 'laboratory, seed 7',
    'sonar.noise': 0,
    'sonar.rays': 7,
    'learner.learning': false,
    'learner.regions': 'two',
  };
  expect(typedOf(info, preset, settings)).toEqual({ 'sonar.rays': '7', 'learner.learning': false });
});

it('says what a session began with', () => {
  expect(beganWith(session('ab', {}))).toBe('');
  expect(beganWith(session('ab', { settings: { network: 'hall, seed 2' } }))).toBe('hall, seed 2');
});
