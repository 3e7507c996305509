/** Settings in the form and on the session page. */

import { count } from './format';
import type { ExperimentInfo, PresetInfo, SettingInfo } from './protocol';

/** The value of a setting. */
export type Value = number | string | boolean;

/** Settings that have their own place in the form; `pulls` are the trials of a bandit. */
export const APART = ['preset', 'world', 'trials', 'pulls'];

/** Settings with a common key prefix. */
export interface Group {
  name: string;
  settings: SettingInfo[];
}

/** Settings that fit the search, by prefix, in the server's order. */
export function grouped(settings: SettingInfo[], search: string): Group[] {
  const groups: Group[] = [];
  for (const setting of settings.filter((each) => fits(each, search))) {
    const name = setting.key.split('.')[0] ?? '';
    const group = groups.find((each) => each.name === name);
    if (group) group.settings.push(setting);
    else groups.push({ name, settings: [setting] });
  }
  return groups;
}

/** Whether every word of the search stands in the setting's key, meaning, source or standing. */
export function fits(setting: SettingInfo, search: string): boolean {
  if (APART.includes(setting.key)) return false;
  const text = [setting.key, setting.meaning, setting.source, setting.standing]
    .join(' ')
    .toLowerCase();
  return search
    .toLowerCase()
    .split(/\s+/)
    .every((word) => text.includes(word));
}

/** The value a setting has in a preset. */
export function presetValue(setting: SettingInfo, preset: PresetInfo | undefined): Value {
  return preset?.settings[setting.key] ?? setting.default;
}

/** What was typed, as a value; `null` when it is none. */
export function parsed(setting: SettingInfo, typed: string | boolean): Value | null {
  if (typeof typed === 'boolean' || isText(setting) || setting.kind === 'choice') return typed;
  const value = typedNumber(typed);
  if (value === null) return null;
  return setting.kind === 'integer' && !Number.isInteger(value) ? null : value;
}

/** Settings given as `key=value`, as the form holds what is typed. */
export function typedFrom(info: ExperimentInfo, given: string[]): Record<string, string | boolean> {
  const typed: Record<string, string | boolean> = {};
  for (const each of given) {
    const at = each.indexOf('=');
    const [key, value] = [each.slice(0, at), each.slice(at + 1)];
    const setting = info.settings.find((known) => known.key === key);
    if (setting) typed[key] = setting.kind === 'switch' ? value === 'true' : value;
  }
  return typed;
}

/** Whether a setting is words or a table, of more than a line. */
export const isText = ({ kind }: SettingInfo): boolean => kind === 'text';

/** A number as people type it, with a comma or a true minus sign too; `null` when it is none. */
export function typedNumber(typed: string): number | null {
  const text = typed.trim().replace('−', '-').replace(',', '.');
  const value = Number(text);
  return text === '' || !Number.isFinite(value) ? null : value;
}

/** The typed settings that differ from the preset's: only these are sent. */
export function changed(
  info: ExperimentInfo,
  preset: PresetInfo | undefined,
  typed: Record<string, string | boolean>,
): Record<string, Value> {
  const sent: Record<string, Value> = {};
  for (const setting of info.settings) {
    const given = typed[setting.key];
    if (given === undefined) continue;
    const value = parsed(setting, given);
    if (value !== null && value !== presetValue(setting, preset)) sent[setting.key] = value;
  }
  return sent;
}

/** Keys of typed settings that are no value of their kind. */
export function unreadable(
  info: ExperimentInfo,
  typed: Record<string, string | boolean>,
): string[] {
  return info.settings
    .filter((setting) => {
      const given = typed[setting.key];
      return given !== undefined && parsed(setting, given) === null;
    })
    .map((setting) => setting.key);
}

/** A seed: a whole number from 0 to 2⁵³ − 1; `undefined` when empty, `null` when it is none. */
export function parsedSeed(typed: string): number | undefined | null {
  const text = typed.trim();
  if (text === '') return undefined;
  const value = Number(text);
  return /^\d+$/.test(text) && Number.isSafeInteger(value) ? value : null;
}

/** The range of a setting in words. */
export function range(setting: SettingInfo): string {
  if (setting.min === null || setting.max === null) return '';
  const unit = setting.unit && setting.unit !== '1' ? ` ${setting.unit}` : '';
  return `${setting.min} to ${setting.max}${unit}`;
}

/** A value in words. */
export function said(value: Value | undefined): string {
  if (value === undefined) return '–';
  if (typeof value === 'boolean') return value ? 'on' : 'off';
  return String(value).replace('-', typeof value === 'number' ? '−' : '-');
}

/** A value in a few words: a long text by how much it is. */
export function saidBriefly(value: Value | undefined): string {
  if (typeof value !== 'string') return said(value);
  if (value === '') return 'none';
  const lines = value.split('\n').length;
  return lines > 1 || value.length > 40 ? count(lines, 'line') : value;
}

/** What a session of this kind is given a number of; nothing where it has but one. */
export function trialsLabel({ family, name }: Pick<ExperimentInfo, 'family' | 'name'>): string {
  if (family === 'path') return 'Trials';
  if (family === 'drive') return 'Runs of each method';
  if (name === 'horizon') return '';
  return name === 'bandit' ? 'Pulls an episode' : 'Trials an episode';
}

/** The unit to show beside a number; a pure number has none. */
export function unit(setting: SettingInfo): string {
  return setting.unit === '1' ? '' : setting.unit;
}

/** How settings stand to the thesis. */
export const STANDINGS: Record<string, string> = {
  literal: 'Printed in the thesis',
  reading: 'One way to read an ambiguous passage',
  gap: 'The thesis is silent; something had to be chosen',
  deviation: 'The thesis says otherwise',
  addition: 'Not in the thesis at all',
  simulation: 'Belongs to the simulation, not to the thesis',
};
