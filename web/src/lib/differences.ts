/** Where a run differs from the thesis: what is set, what is printed, and why. */

import type { PresetInfo, SettingInfo } from './protocol';
import { presetValue, said, unit, type Value } from './settings';

/** Settings that name sets of other settings and of walls; what they choose is listed itself. */
const NAMES_OF_SETS = ['preset', 'world'];

/** The preset that reads the thesis literally. */
const LITERAL = 'thesis';

/** One setting that says how the thesis was read. */
export interface Difference {
  key: string;
  /** Its number, e.g. "D1"; empty when it has none. */
  number: string;
  /** What the setting means. */
  meaning: string;
  /** Where it comes from: equation, section, reason. */
  source: string;
  /** How the setting stands to the thesis. */
  standing: string;
  /** What it is here, and what that means when it is one of several names. */
  value: string;
  valueMeaning: string;
  /** What it is in the literal reading, and what that means. */
  thesis: string;
  thesisMeaning: string;
  /** The literal reading's value itself. */
  literal: Value;
  /** It is here as in the literal reading. */
  isLiteral: boolean;
  /** It belongs to something that the thesis does not have: nothing is printed that it could be. */
  isOwn: boolean;
}

/** Differences of one kind. */
export interface DifferenceGroup {
  name: string;
  explanation: string;
  differences: Difference[];
}

/** The kinds, the farthest from the thesis first. */
const KINDS: [string, string, string][] = [
  ['addition', 'Additions', 'Not in the thesis at all'],
  ['deviation', 'Deviations', 'The thesis says otherwise'],
  ['reading', 'Readings', 'The thesis can be read in more than one way; this is the one taken'],
  ['gap', 'Gaps', 'The thesis is silent; something had to be chosen'],
];

/** All differences by kind, for settings as they are in a session or in the form. */
export function differencesOf(
  infos: SettingInfo[],
  presets: PresetInfo[],
  settings: Record<string, Value | undefined>,
): DifferenceGroup[] {
  const literal = presets.find(({ name }) => name === LITERAL);
  const all = infos
    .filter(({ key }) => !NAMES_OF_SETS.includes(key))
    .map((info) => difference(info, settings[info.key] ?? info.default, literal));
  return KINDS.map(([standing, name, explanation]) => ({
    name,
    explanation,
    differences: all.filter((each) => kindOf(each) === standing),
  })).filter(({ differences }) => differences.length > 0);
}

/** A printed value that is used is no difference; one that was changed is a deviation. */
function kindOf({ standing, isLiteral }: Difference): string {
  if (standing !== 'literal') return standing;
  return isLiteral ? '' : 'deviation';
}

/** How many additions and deviations are in force, e.g. "2 additions, 5 deviations". */
export function inForce(groups: DifferenceGroup[]): string {
  const counts = ['Additions', 'Deviations'].map((name) => {
    const group = groups.find((each) => each.name === name);
    const amount = group?.differences.filter(({ isLiteral }) => !isLiteral).length ?? 0;
    const noun = name.slice(0, -1).toLowerCase();
    return [amount, `${amount} ${noun}${amount === 1 ? '' : 's'}`] as const;
  });
  const words = counts.flatMap(([amount, text]) => (amount > 0 ? [text] : []));
  return words.length === 0 ? 'no addition or deviation in force' : `${words.join(', ')} in force`;
}

function difference(info: SettingInfo, value: Value, literal: PresetInfo | undefined): Difference {
  const printed = presetValue(info, literal);
  const departs = info.standing === 'addition' || info.standing === 'deviation';
  const [, number = '', source = info.source] = /^([A-Z]\d+)[;,:]?\s*(.*)$/.exec(info.source) ?? [];
  const mean = (each: Value) => info.choices.find((choice) => choice.value === each)?.meaning ?? '';
  const say = (each: Value) => [said(each), unit(info)].filter(Boolean).join(' ');
  return {
    key: info.key,
    number,
    meaning: info.meaning,
    source,
    standing: info.standing,
    value: say(value),
    valueMeaning: mean(value),
    thesis: say(printed),
    thesisMeaning: mean(printed),
    literal: printed,
    isLiteral: value === printed,
    isOwn: departs && literal?.settings[info.key] === undefined,
  };
}
