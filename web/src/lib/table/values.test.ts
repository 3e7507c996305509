import { describe, expect, it } from 'vitest';

import { readTable, rowsText, withValue } from './values';

describe('a table that is loaded', () => {
  const fault = (text: string) => {
    const read = readTable('q.json', text, 2, 2);
    return 'fault' in read ? read.fault : 'none';
  };

  it('is a saved file or rows alone', () => {
    const values = [
      [1, 2],
      [3, 4],
    ];
    const file = JSON.stringify({ experiment: 'labyrinth', entrant: 'B0', values });
    expect(readTable('q.json', file, 2, 2)).toEqual({ values });
    expect(readTable('q.json', rowsText(values), 2, 2)).toEqual({ values });
  });

  it.each([
    ['{"values":[[1,2]', 'q.json is no table: it is not JSON, or it is cut off'],
    ['{}', 'q.json holds no “values”; take a file from “Save”'],
    ['[[1,2]]', 'q.json: 1 rows, but this world has 2 states'],
    ['[[1,2],[3]]', 'q.json: row of state 1 must hold 2 numbers, one an action'],
    ['[[1,2],[3,null]]', 'q.json: state 1, action 1 is no finite number'],
  ])('%s', (text, words) => {
    expect(fault(text)).toBe(words);
  });
});

it('changes one value and leaves the rows as they were', () => {
  const rows = [
    [1, 2],
    [3, 4],
  ];
  expect(withValue(rows, 1, 0, 9)).toEqual([
    [1, 2],
    [9, 4],
  ]);
  expect(rows[1]).toEqual([3, 4]);
});
