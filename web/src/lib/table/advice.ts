/** Advice that cannot be read: the place that the server names. */

/** A character of a text that is wrong. */
export interface Fault {
  /** From 1. */
  line: number;
  /** In characters, from 1. */
  column: number;
  problem: string;
  /** The line as it stands. */
  written: string;
  /** Blanks up to the character, and the caret. */
  caret: string;
  /** Place of the character in the text, in code units, for the selection. */
  offset: number;
}

/** The fault in "advice, line L, column C: problem"; none where the text says something else. */
export function faultIn(detail: string, text: string): Fault | null {
  const match = /line (\d+), column (\d+): ([\s\S]+)/.exec(detail);
  if (!match) return null;
  const [line, column] = [Number(match[1]), Number(match[2])];
  const lines = text.split('\n');
  const written = lines[line - 1] ?? '';
  const before = [...written].slice(0, column - 1);
  const start = lines.slice(0, line - 1).reduce((sum, each) => sum + each.length + 1, 0);
  return {
    line,
    column,
    problem: match[3] ?? '',
    written,
    // A tab stays one, so that the caret stands below its character.
    caret: `${before.map((sign) => (sign === '\t' ? '\t' : ' ')).join('')}^`,
    offset: start + before.join('').length,
  };
}

/** A rule to begin with, from the words that a world knows. */
export function exampleRule(
  features: { name: string; terms: string[] }[],
  actions: string[],
): string {
  const feature = features.find(({ terms }) => terms.length > 0);
  const action = actions[0];
  if (!feature || !action) return '';
  return `if ${feature.name} is ${feature.terms[0]} then ${action}`;
}
