/** Kinds of readings: what each is, its colour and its mark, so that colour never tells alone. */

import type { Ink } from '../ink';
import type { ReadingView } from '../protocol';

/** A kind of reading. */
export interface EchoKind {
  /** As the server names it. */
  echo: string;
  name: string;
  meaning: string;
  /** Stroke of its mark around (0, 0), 4 units to each side. */
  mark: string;
  /** Custom property of the theme that holds its colour. */
  colour: string;
}

/** The kinds, those that tell the truth first. */
export const ECHOES: EchoKind[] = [
  kind('echo', 'Echo', 'of a surface', 'M-2,0A2,2 0 1 0 2,0A2,2 0 1 0 -2,0Z', 'series-1'),
  kind('edge', 'Edge', 'scattered back by a corner', 'M0,-4L4,0L0,4L-4,0Z', 'series-3'),
  kind('none', 'No echo', 'nothing within range', 'M-3,0H3', 'series-8'),
  kind('dropped', 'Dropped', 'an echo that was lost', 'M-4,-3H4L0,4Z', 'series-6'),
  kind('ghost', 'Ghost', 'crosstalk of another sonar', 'M-4,-4L4,4M-4,4L4,-4', 'series-5'),
  kind('spurious', 'Spurious', 'falsely short', 'M-4,0H4M0,-4V4', 'series-2'),
  kind('silent', 'Silent', 'the sonar does not answer', 'M-4,-4H4V4H-4Z', 'strong'),
];

const ORDINARY = ['echo', 'none'];

/** The kind of a reading; one that is not known reads as an echo under its own name. */
export function echoKind(echo: string): EchoKind {
  const known = ECHOES.find((each) => each.echo === echo);
  return known ?? { ...ECHOES[0]!, echo, name: echo, meaning: '' };
}

/** Whether a reading is worth a mark of its own: it is not just what a sonar should say. */
export const isMarked = (echo: string): boolean => !ORDINARY.includes(echo);

/** How many readings there are of each kind, in the kinds' order; kinds without any are left out. */
export function tally(readings: ReadingView[]): { kind: EchoKind; n: number }[] {
  return ECHOES.map((kind) => ({
    kind,
    n: readings.filter(({ echo }) => echo === kind.echo).length,
  })).filter(({ n }) => n > 0);
}

/** Colour of a kind on a canvas. */
export function echoInk(echo: string, ink: Ink): string {
  const { colour } = echoKind(echo);
  const series = /^series-(\d)$/.exec(colour)?.[1];
  return series ? (ink.series[Number(series) - 1] ?? ink.accent) : ink.strong;
}

function kind(echo: string, name: string, meaning: string, mark: string, colour: string): EchoKind {
  return { echo, name, meaning, mark, colour };
}
