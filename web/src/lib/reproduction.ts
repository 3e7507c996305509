/** Reproductions: rows and curves as the page shows them. */

import { brief, number } from './format';
import type {
  ExperimentInfo,
  ReproductionArm,
  ReproductionCurve,
  ReproductionPoint,
  ReproductionRow,
  SettingInfo,
  Verdict,
} from './protocol';
import type { Value } from './settings';

/** The rows of one arm. */
export interface ArmRows {
  arm: string;
  rows: ReproductionRow[];
}

/** Rows by the arm their names begin with, in the server's order. */
export function byArm(rows: ReproductionRow[]): ArmRows[] {
  const groups: ArmRows[] = [];
  for (const row of rows) {
    const arm = armOf(row.name);
    const group = groups.find((each) => each.arm === arm);
    if (group) group.rows.push(row);
    else groups.push({ arm, rows: [row] });
  }
  return groups;
}

/** The arm a row's name begins with; empty when it names none. */
export function armOf(name: string): string {
  const end = name.indexOf(': ');
  return end < 0 ? '' : name.slice(0, end);
}

/** A row's name without its arm. */
export const quantityOf = (name: string) =>
  name.slice(name.indexOf(': ') < 0 ? 0 : name.indexOf(': ') + 2);

/** A reading without the preset and seeds it begins with; they stand above the table. */
export function plainReading(reading: string): string {
  return reading.replace(/^Preset [^:]*seeds \d+\.\.\d+: /, '');
}

/** How many rows came out so. */
export function tally(rows: ReproductionRow[]): Record<Verdict, number> {
  const counts: Record<Verdict, number> = { agrees: 0, differs: 0, 'cannot tell': 0 };
  for (const row of rows) counts[row.verdict] += 1;
  return counts;
}

/** As many decimals as an interval of this width deserves. */
export function decimalsFor(low: number, high: number): number {
  const width = Math.abs(high - low);
  if (!Number.isFinite(width) || width === 0) return 2;
  return Math.min(3, Math.max(1, 1 - Math.floor(Math.log10(width))));
}

/** The quantities that are drawn, in the server's order. */
export function quantities(curves: ReproductionCurve[]): string[] {
  return [...new Set(curves.map((curve) => curve.quantity))];
}

/** A curve in a sentence: where it begins and ends, with intervals. */
export function spoken(curve: ReproductionCurve): string {
  const known = curve.points.filter((point) => point.mean !== null);
  const [first, last] = [known[0], known[known.length - 1]];
  if (!first || !last) return `${curve.arm}: no value`;
  const say = (point: ReproductionPoint) => `${mean(point)} at ${curve.x_name} ${brief(point.x)}`;
  const course = first === last ? say(first) : `from ${say(first)} to ${say(last)}`;
  return `${curve.arm}: ${course}`;
}

/** A point's mean with its interval. */
export function mean(point: ReproductionPoint): string {
  if (point.mean === null) return '–';
  if (point.low === null || point.high === null) return number(point.mean);
  const decimals = decimalsFor(point.low, point.high);
  const [low, high] = [number(point.low, decimals), number(point.high, decimals)];
  return `${number(point.mean, decimals)} [${low}, ${high}]`;
}

/** A setting of an arm that is not the thesis as printed. */
export interface Difference {
  info: SettingInfo;
  value: Value;
}

/** Settings of an arm that say how the thesis was read or left, the simulation's own apart. */
export function differences(experiment: ExperimentInfo, arm: ReproductionArm): Difference[] {
  const name = String(arm.settings['preset'] ?? experiment.presets[0]?.name ?? '');
  const preset = experiment.presets.find((each) => each.name === name);
  const found = experiment.settings.map((info) => ({
    info,
    value: arm.settings[info.key] ?? preset?.settings[info.key] ?? info.default,
  }));
  return found
    .filter(({ info, value }) => differs(info, value))
    .sort((a, b) => ORDER.indexOf(a.info.standing) - ORDER.indexOf(b.info.standing));
}

/** Standings in the order of the list; a literal setting that was changed counts as a deviation. */
const ORDER = ['addition', 'deviation', 'literal', 'reading', 'gap'];

function differs(info: SettingInfo, value: Value): boolean {
  if (info.key === 'preset' || info.key === 'world' || info.standing === 'simulation') return false;
  return info.standing !== 'literal' || value !== info.default;
}
