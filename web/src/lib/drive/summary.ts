/** Runs and methods as tables: which columns matter in which experiment, and how numbers stand in them. */

import { number } from '../format';
import type {
  DriveOutcome,
  DriveRunView,
  DriveScore,
  DriveScores,
  MeasureView,
  MethodScoreView,
} from '../protocol';
import { numeral } from './names';

/** A column of the table of controlled runs. */
export interface Column {
  name: string;
  /** Empty for a pure number. */
  unit: string;
  said: (score: DriveScore) => string;
}

const measured = (key: keyof DriveScore, name: string, unit: string, decimals: number, by = 1) => ({
  name,
  unit,
  said: (score: DriveScore) => figure(score[key], decimals, by),
});

/** A number that may be missing. */
function figure(value: number | boolean | null, decimals: number, by: number): string {
  return typeof value === 'number' ? number(by * value, decimals) : '–';
}

const TIME = measured('time_s', 'Time', 's', 0);
const PATH = measured('path_m', 'Path', 'm', 1);
const SPEED = measured('speed_m_s', 'Velocity', 'cm/s', 1, 100);
const REVERSE = measured('reverse_pct', 'Backing up', '%', 1);
const FLIPS = measured('flips_per_min', 'Changes of side', '1/min', 1);
const CLEARANCE = measured('clearance_m', 'Least clearance', 'm', 2);
const NIS = measured('nis', 'NIS', '', 2);

const CORRIDOR: Column[] = [
  { name: 'End', unit: '', said: endWords },
  measured('progress_m', 'Way gained', 'm', 1),
  TIME,
  measured('forward_m_s', 'Forward', 'cm/s', 2, 100),
  measured('straightness', 'Straightness', '', 3),
  measured('heading_rms_deg', 'Heading', 'deg RMS', 1),
  FLIPS,
  REVERSE,
  { name: 'Doors', unit: 'clean/passed', said: (score) => `${score.clean_doors}/${score.doors}` },
  { name: 'Contacts', unit: 'wall, door, person', said: contactsOf('wall', 'door', 'people') },
  CLEARANCE,
  NIS,
];

const BLOCKS: Column[] = [
  TIME,
  PATH,
  SPEED,
  measured('slow_pct', 'Slow', '%', 1),
  REVERSE,
  measured('turn_deg_s', 'Turn', 'deg/s', 2),
  FLIPS,
  { name: 'Contacts', unit: 'wall, block', said: contactsOf('wall', 'block') },
  CLEARANCE,
  NIS,
];

/** The columns that matter in a course with a controlled robot. */
export const columnsOf = (kind: string): Column[] => (kind === 'corridor' ? CORRIDOR : BLOCKS);

function endWords({ done, blind }: DriveScore): string {
  if (blind !== null) return `region ${numeral(blind)} silent`;
  return done ? 'reached' : 'not reached';
}

type Touched = 'wall' | 'door' | 'block' | 'people';

function contactsOf(...kinds: Touched[]) {
  return (score: DriveScore) => kinds.map((kind) => score[`${kind}_contacts`]).join(', ');
}

/** A score of a method in the approach to a wall. */
export const SCORES: {
  key: keyof MethodScoreView;
  name: string;
  unit: string;
  decimals: number;
}[] = [
  { key: 'rms_m', name: 'RMS error', unit: 'm', decimals: 3 },
  { key: 'r2', name: 'R² of a line', unit: '', decimals: 3 },
  { key: 'variation_m', name: 'Variation', unit: 'm', decimals: 2 },
  { key: 'rise_m', name: 'Rise', unit: 'm', decimals: 2 },
  { key: 'jump_m', name: 'Greatest jump', unit: 'm', decimals: 2 },
];

/** Whether a run was driven by rules. */
export function isDrive(outcome: DriveOutcome): outcome is { kind: 'drive' } & DriveScore {
  return outcome.kind === 'drive';
}

/** A measure with its interval: "14.51 [14.40, 14.62]", or the mean alone. */
export function measureWords({ mean, interval }: MeasureView): string {
  const decimals = decimalsOf(interval ? [interval.low, interval.high, mean] : [mean]);
  const said = number(mean, decimals);
  if (!interval) return said;
  return `${said} [${number(interval.low, decimals)}, ${number(interval.high, decimals)}]`;
}

/** Decimals that leave about three digits to the greatest of some values. */
export function decimalsOf(values: number[]): number {
  const most = Math.max(...values.map(Math.abs));
  if (!(most > 0)) return 0;
  return Math.max(0, Math.min(3, 2 - Math.floor(Math.log10(most))));
}

/** A measure of all methods side by side. */
export interface MeasureRow {
  name: string;
  unit: string;
  /** In the methods' order; none where a method lacks it. */
  cells: (MeasureView | null)[];
  /** Scale that holds all means and intervals, with a little room. */
  scale: [number, number];
}

/** The measures of all methods side by side, in the order of the first that has runs. */
export function measureRows({ methods }: DriveScores): MeasureRow[] {
  const order = methods.find(({ measures }) => measures.length > 0)?.measures ?? [];
  return order.map(({ name, unit }) => {
    const cells = methods.map(
      ({ measures }) => measures.find((measure) => measure.name === name) ?? null,
    );
    return { name, unit, cells, scale: scaleOf(cells) };
  });
}

function scaleOf(cells: (MeasureView | null)[]): [number, number] {
  const ends = cells.flatMap((cell) =>
    cell ? [cell.mean, cell.interval?.low ?? cell.mean, cell.interval?.high ?? cell.mean] : [],
  );
  const [least, most] = [Math.min(0, ...ends), Math.max(0, ...ends)];
  return [least, most > least ? most + 0.04 * (most - least) : least + 1];
}

/** What an operator did during a run. */
export const touched = ({ interventions }: DriveRunView) => interventions ?? [];
