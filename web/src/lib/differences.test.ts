import { describe, expect, it } from 'vitest';

import { differencesOf, inForce } from './differences';
import type { PresetInfo, SettingInfo } from './protocol';

function setting(key: string, standing: string, source: string, value: number | string) {
  const choices = [{ value: 'band', meaning: 'from the record' }];
  const kind = typeof value === 'string' ? 'choice' : 'number';
  return {
    ...{ key, standing, source, kind, choices, meaning: `What ${key} is` },
    ...{ unit: 'm', default: value, min: 0, max: 9 },
  } as SettingInfo;
}

const infos = [
  setting('preset', 'gap', '', 'default'),
  setting('mean', 'addition', 'A1; Eq. (5.21)', 'band'),
  setting('decay', 'addition', 'A1, tuned', 0.85),
  setting('scale', 'deviation', 'D1; Eq. (5.14)', 0.05),
  setting('cap', 'simulation', 'reading', 200),
  setting('metric', 'reading', 'Eq. (5.10)', 3),
  setting('discount', 'literal', 'Eq. (5.18)', 0.7),
];
const thesis: PresetInfo = {
  name: 'thesis',
  title: '',
  summary: '',
  settings: { mean: 'gradient', scale: 1 },
};

const groups = (settings: Record<string, number | string>) =>
  differencesOf(infos, [thesis], settings);
const keys = (settings: Record<string, number | string>) =>
  groups(settings).map(({ name, differences }) => [name, differences.map(({ key }) => key)]);

describe('differences from the thesis', () => {
  it('are grouped, the farthest first, without the simulation', () => {
    expect(keys({})).toEqual([
      ['Additions', ['mean', 'decay']],
      ['Deviations', ['scale']],
      ['Readings', ['metric']],
    ]);
  });

  it('count a printed value only where it was changed', () => {
    expect(keys({ discount: 0.9 })[1]).toEqual(['Deviations', ['scale', 'discount']]);
  });

  it('say number, source, value and the literal reading beside it', () => {
    expect(groups({})[0]?.differences[0]).toMatchObject({
      number: 'A1',
      source: 'Eq. (5.21)',
      value: 'band m',
      valueMeaning: 'from the record',
      thesis: 'gradient m',
      isLiteral: false,
      isOwn: false,
    });
    expect(groups({})[0]?.differences[1]).toMatchObject({ isOwn: true, source: 'tuned' });
    expect(groups({})[2]?.differences[0]).toMatchObject({ number: '', source: 'Eq. (5.10)' });
  });

  it('tell which are in force', () => {
    expect(inForce(groups({}))).toBe('1 addition, 1 deviation in force');
    expect(inForce(groups({ scale: 1 }))).toBe('1 addition in force');
    expect(inForce(groups({ scale: 1, mean: 'gradient' }))).toBe(
      'no addition or deviation in force',
    );
  });
});
