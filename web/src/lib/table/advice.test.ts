import { expect, it } from 'vitest';

import { exampleRule, faultIn } from './advice';

const TEXT = 'if wall is ahead then left\nif gaol is near then forward';

it('puts the caret under the character that the server names', () => {
  const fault = faultIn('advice, line 2, column 4: unknown feature `gaol`', TEXT);
  expect(fault).toEqual({
    line: 2,
    column: 4,
    problem: 'unknown feature `gaol`',
    written: 'if gaol is near then forward',
    caret: '   ^',
    offset: TEXT.indexOf('gaol'),
  });
});

it('counts characters, not code units, and keeps tabs', () => {
  const fault = faultIn('advice, line 1, column 4: a sign without meaning', '\t𝜏 §');
  expect([fault?.caret, fault?.offset]).toEqual(['\t  ^', '\t𝜏 '.length]);
});

it('leaves other refusals as they are', () => {
  expect(faultIn('The session is finished; advice can be given while it runs', TEXT)).toBeNull();
});

it('begins with a rule that the world can read', () => {
  const features = [
    { name: 'state', terms: [] },
    { name: 'goal', terms: ['near', 'far'] },
  ];
  expect(exampleRule(features, ['north'])).toBe('if goal is near then north');
  expect(exampleRule([], ['north'])).toBe('');
});
