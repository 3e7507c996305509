/** What methods, regions and sonars are called on the screen. */

import { words } from '../format';
import { bearingWords } from '../polar';
import type { CourseView } from '../protocol';

const METHODS: Record<string, string> = {
  minimum: 'Minimum',
  'minimum-kalman': 'Minimum + Kalman',
  median: 'Median',
  'median-kalman': 'Median + Kalman',
  'median-walk': 'Median + random walk',
};

const ROMAN = ['I', 'II', 'III', 'IV', 'V', 'VI', 'VII', 'VIII', 'IX', 'X'];

/** A method in words. */
export const methodName = (method: string): string => METHODS[method] ?? words(method);

/** A region's numeral, as the thesis counts them from the left. */
export const numeral = (region: number): string => ROMAN[region] ?? String(region + 1);

/** A region with its numeral, and where it lies when rules have a name for it: "II left". */
export function regionName(course: CourseView, region: number): string {
  const inputs = course.rules?.inputs ?? [];
  const input = inputs.length === course.regions.length + 1 ? inputs[region] : undefined;
  return input ? `${numeral(region)} ${words(input.name)}` : numeral(region);
}

/** A sonar by its number and where it looks: "sonar 3, 26° left". */
export function sonarName(course: CourseView, sonar: number): string {
  return `sonar ${sonar}, ${bearingWords(course.sonars[sonar]?.bearing_deg ?? 0)}`;
}
