import { expect, it } from 'vitest';

import { sorted } from './files';

const files = (...names: string[]) => names.map((name) => ({ name }));
const none = { image: null, yaml: null };

it('takes a world and a map, in any order and any case', () => {
  expect(sorted(files('hall.toml'), none)).toMatchObject({ kind: 'world' });
  for (const names of [
    ['a.pgm', 'a.yaml'],
    ['a.YML', 'a.PNG'],
  ]) {
    expect(sorted(files(...names), none).kind).toBe('map');
  }
});

it('waits for the second half of a map', () => {
  const half = sorted(files('a.pgm'), none);
  expect(half).toMatchObject({ kind: 'half', missing: expect.stringContaining('YAML') });
  if (half.kind !== 'half') return;
  expect(sorted(files('a.yaml'), half.files)).toMatchObject({
    kind: 'map',
    image: { name: 'a.pgm' },
  });
});

it('says which file is none of these', () => {
  expect(sorted(files('notes.txt'), none)).toMatchObject({
    kind: 'none',
    why: expect.stringContaining('notes.txt'),
  });
  expect(sorted([], none).kind).toBe('none');
});
