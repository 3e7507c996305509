/** Tables of values as files and as settings. */

import type { TableFile } from '../protocol';

/** Reads a table that was saved, or rows alone, for a world of so many states and actions. */
export function readTable(
  name: string,
  text: string,
  states: number,
  actions: number,
): { values: number[][] } | { fault: string } {
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch {
    return { fault: `${name} is no table: it is not JSON, or it is cut off` };
  }
  const rows = Array.isArray(json) ? json : (json as Partial<TableFile> | null)?.values;
  if (!Array.isArray(rows)) return { fault: `${name} holds no “values”; take a file from “Save”` };
  const fault = faultOf(rows, states, actions);
  return fault ? { fault: `${name}: ${fault}` } : { values: rows as number[][] };
}

function faultOf(rows: unknown[], states: number, actions: number): string {
  if (rows.length !== states) return `${rows.length} rows, but this world has ${states} states`;
  for (const [state, row] of rows.entries()) {
    if (!Array.isArray(row) || row.length !== actions) {
      return `row of state ${state} must hold ${actions} numbers, one an action`;
    }
    const wrong = row.findIndex((value) => typeof value !== 'number' || !Number.isFinite(value));
    if (wrong >= 0) return `state ${state}, action ${wrong} is no finite number`;
  }
  return '';
}

/** Rows as the settings `learner.table` and `belief.matrix` take them: a row a line. */
export function rowsText(rows: number[][]): string {
  return `[${rows.map((row) => `[${row.join(', ')}]`).join(',\n ')}]`;
}

/** Rows with one value changed. */
export function withValue(
  rows: number[][],
  state: number,
  action: number,
  value: number,
): number[][] {
  return rows.map((row, index) => (index === state ? row.with(action, value) : row));
}
