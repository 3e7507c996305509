/** Trained networks that a new session begins with. */

import { count, exact } from './format';
import type {
  ExperimentInfo,
  NetworkFile,
  NewSession,
  PresetInfo,
  Problem,
  Session,
} from './protocol';
import { APART, presetValue } from './settings';

/** A network file that was read. */
export interface ReadNetwork {
  /** Name of the file. */
  name: string;
  /** The file itself; it is sent as it is, to the last digit. */
  text: string;
  /** What it is called where there is place for a few words. */
  label: string;
}

/** What a new session begins with; something is still to be chosen while it is `null` or empty. */
export type Beginning =
  { kind: 'empty' } | { kind: 'session'; id: string } | { kind: 'file'; file: ReadNetwork | null };

/** What every network file says it is. */
const FORMAT = 'sonarium-network';

/** Reads a network file, or says what is wrong with it. */
export function readNetwork(name: string, text: string): ReadNetwork | { fault: string } {
  const how = 'choose a file from “Download network” on the page of a session';
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch {
    return { fault: `${name} is no network file: it is not JSON, or it is cut off; ${how}` };
  }
  const file = (json ?? {}) as Partial<NetworkFile>;
  if (file.format !== FORMAT) return { fault: `${name} is no network file; ${how}` };
  const { world, seed, trials, networks } = file;
  if (!Array.isArray(networks) || !networks.every(Array.isArray)) {
    return { fault: `${name} holds no networks; ${how}` };
  }
  const neurons = networks.reduce((sum, network) => sum + network.length, 0);
  const label = `${world ?? '–'}, seed ${seed ?? '–'}, ${count(trials ?? 0, 'trial')}, ${count(neurons, 'neuron')}`;
  return { name, text, label };
}

/** Sessions whose networks can be begun with, newest first. */
export function trainedIn(experiment: string, sessions: Session[]): Session[] {
  return sessions
    .filter((each) => each.experiment === experiment && each.trials_done > 0)
    .toSorted((a, b) => b.created_at.localeCompare(a.created_at));
}

/** A session with a network, in a line. */
export function trainedWords({ id, world, seed, trials_done, created_at }: Session): string {
  return `${id}: ${world}, seed ${seed}, ${count(trials_done, 'trial')}, ${exact(created_at)}`;
}

/** What the server says against a network; its words go on from the place in the file. */
export function networkRefusal({ title, detail, field }: Problem): string {
  return field?.startsWith('network.') ? `${title}: ${field} ${detail}` : `${title}. ${detail}`;
}

/** Why a session cannot be begun with yet; empty when it can. */
export function unchosen(beginning: Beginning): string {
  if (beginning.kind === 'session' && !beginning.id) return 'Choose a session.';
  if (beginning.kind === 'file' && !beginning.file) return 'Choose a network file.';
  return '';
}

/** The body of a request for a new session that begins so. */
export function bodyOf(asked: NewSession, beginning: Beginning): string {
  if (beginning.kind === 'session') return JSON.stringify({ ...asked, network: beginning.id });
  const body = JSON.stringify(asked);
  const text = beginning.kind === 'file' ? beginning.file?.text : undefined;
  // Read and written again, numbers such as -0 would not be the same.
  return text === undefined ? body : `${body.slice(0, -1)},"network":${text}}`;
}

/** A session's settings as somebody would have typed them over the preset's. */
export function typedOf(
  info: ExperimentInfo,
  preset: PresetInfo | undefined,
  settings: Session['settings'],
): Record<string, string | boolean> {
  const typed: Record<string, string | boolean> = {};
  for (const setting of info.settings) {
    const value = settings[setting.key];
    if (APART.includes(setting.key) || value === undefined) continue;
    if (value === presetValue(setting, preset)) continue;
    typed[setting.key] = typeof value === 'boolean' ? value : String(value);
  }
  return typed;
}

/** What a session began with, in a few words; empty when with an empty network. */
export function beganWith({ settings }: Session): string {
  return typeof settings.network === 'string' ? settings.network : '';
}
