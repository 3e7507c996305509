/** The HTTP interface as the page uses it. */

import { bodyOf, type Beginning } from './network';
import type {
  Ack,
  AlteredStartView,
  CalibrationQuestion,
  CalibrationView,
  ExperimentInfo,
  LostAtSea,
  NeuronView,
  NewSession,
  Problem,
  Reproduction,
  ReproductionProgress,
  ReproductionTarget,
  RuleList,
  Session,
  Speed,
  StepUnit,
  TableFile,
  TableRequest,
  ThemeName,
  TickView,
} from './protocol';

/** Where the interface lies. */
export const ROOT = '/api/v1';

/** A refusal by the server, or no answer at all (`status` 0). */
export class Refusal extends Error {
  readonly problem: Problem;

  constructor(problem: Problem) {
    super(`${problem.title}: ${problem.detail}`);
    this.problem = problem;
  }
}

/** The problem behind any error. */
export function problemOf(error: unknown): Problem {
  if (error instanceof Refusal) return error.problem;
  return local('The page ran into an error', String(error));
}

export const experiments = () => call<ExperimentInfo[]>('GET', 'experiments');
export const sessions = () => call<Session[]>('GET', 'sessions');
export const createSession = (asked: NewSession, beginning: Beginning) =>
  ask<Session>('sessions', json('POST', bodyOf(asked, beginning)));
export const session = (id: string) => call<Session>('GET', path(id));
export const deleteSession = (id: string) => call<null>('DELETE', path(id));
export const neuron = (id: string, which: number) =>
  call<NeuronView>('GET', `${path(id)}/neurons/${which}`);

/** What the session's networks do from altered starts: from `at`, or from those of the experiment. */
export const alteredStarts = (id: string, at: string) =>
  call<AlteredStartView[]>('GET', `${path(id)}/starts${at ? `?${query({ at })}` : ''}`);

/** Control steps of a session, both ends included. */
export const ticks = (id: string, from: number, to: number) =>
  call<TickView[]>('GET', `${path(id)}/ticks?${query({ from, to })}`);

/** What a star and a light beacon say together about a position. */
export const lostAtSea = (
  asked: Record<'star' | 'star_sigma' | 'beacon' | 'beacon_sigma', number>,
) => call<LostAtSea>('GET', `lost-at-sea?${query(asked)}`);

/** The deviation ς of a sonar at a level of noise. */
export const calibration = (asked: CalibrationQuestion) =>
  call<CalibrationView>('GET', `calibration?${query({ ...asked })}`);

/** Address of a file of its report. */
export const calibrationFile = (file: string, asked: CalibrationQuestion) =>
  `${ROOT}/calibration/${file}?${query({ ...asked })}`;

/** A control of a session; `step` may go to the end of the trial. */
export type Control = 'start' | 'pause' | 'resume' | 'step' | 'stop' | 'reset';

export function control(id: string, name: Control, unit?: StepUnit): Promise<Ack> {
  return call<Ack>('POST', `${path(id)}/${name}`, unit && { unit });
}

export const setSpeed = (id: string, speed: Speed) =>
  call<Ack>('POST', `${path(id)}/speed`, { speed });

export const advise = (id: string, text: string) =>
  call<Ack>('POST', `${path(id)}/advice`, { text });

/** The table of values of the learner whose turn it is. */
export const table = (id: string) => call<TableFile>('GET', `${path(id)}/table`);

export const editTable = (id: string, change: TableRequest) =>
  call<Ack>('POST', `${path(id)}/table`, change);

/** Changes the method that drives, from the next cycle to the end of the run. */
export const setMethod = (id: string, method: string) =>
  call<Ack>('POST', `${path(id)}/method`, { method });

/** Silences a sonar, or lets it answer again. */
export const setSonar = (id: string, sonar: number, silent: boolean) =>
  call<Ack>('POST', `${path(id)}/sonars`, { sonar, silent });

/** Address of a rule base as a file. */
export const rulesFile = (name: string, form: 'rules' | 'fll') =>
  `${ROOT}/rules/${encodeURIComponent(name)}.${form}`;

/** A rule base with all its rules. */
export const rules = (name: string) => call<RuleList>('GET', `rules/${encodeURIComponent(name)}`);

export const reproductions = () => call<ReproductionTarget[]>('GET', 'reproductions');
/** Computes it, if nobody has; the answer may take minutes. */
export const reproduction = (target: string) => call<Reproduction>('GET', targetPath(target));
export const reproductionProgress = (target: string) =>
  call<ReproductionProgress>('GET', `${targetPath(target)}/progress`);

/** Address of a file of a target: `rows.csv` or `curves.csv`. */
export const reproductionFile = (target: string, name: string) =>
  `${ROOT}/${targetPath(target)}/${name}`;

/** Address of a picture of a target. */
export const reproductionPicture = (target: string, name: string, size: Size, theme: ThemeName) =>
  `${ROOT}/${targetPath(target)}/pictures/${encodeURIComponent(name)}.png?${query({ ...size, theme })}`;

/** Address of a report or log of the session, e.g. `report.html`. */
export const sessionFile = (id: string, name: string) => `${ROOT}/${path(id)}/${name}`;

/** Address of a report of one trial. */
export const trialFile = (id: string, trial: number, ending: string) =>
  `${ROOT}/${path(id)}/trials/${trial}/report.${ending}`;

/** Address of a picture of one trial's path, or of a run's by its round. */
export function pastPicture(id: string, trial: number, size: Size, theme: ThemeName): string {
  return `${ROOT}/${path(id)}/arena.png?${query({ ...size, trial, theme })}`;
}

/** Address of a picture of the ways from altered starts. */
export function startsPicture(id: string, at: string, size: Size, theme: ThemeName): string {
  return `${ROOT}/${path(id)}/starts.png?${query({ ...size, theme, ...(at ? { at } : {}) })}`;
}

/** Address of a picture of an experiment's world. */
export function worldPicture(name: string, size: Size, theme: ThemeName, world: string): string {
  const asked = query({ ...size, theme, world });
  return `${ROOT}/experiments/${encodeURIComponent(name)}/picture.png?${asked}`;
}

/** Address of the stream, going on after event `since` if given. */
export function streamAddress(id: string, since: number | null): string {
  const address = new URL(`${ROOT}/${path(id)}/stream`, location.href);
  address.protocol = location.protocol === 'https:' ? 'wss:' : 'ws:';
  if (since !== null) address.searchParams.set('since', String(since));
  return address.href;
}

/** Pixels of a picture. */
export interface Size {
  width: number;
  height: number;
}

const targetPath = (target: string) => `reproductions/${encodeURIComponent(target)}`;

const path = (id: string) => `sessions/${encodeURIComponent(id)}`;

function query(parts: Record<string, string | number | boolean>): string {
  return new URLSearchParams(
    Object.entries(parts).map(([key, value]) => [key, String(value)]),
  ).toString();
}

function call<T>(method: string, where: string, body?: unknown): Promise<T> {
  return ask<T>(where, request(method, body));
}

/** Asks the interface for JSON. */
export async function ask<T>(where: string, init: RequestInit): Promise<T> {
  const response = await fetch(`${ROOT}/${where}`, init).catch((error: unknown) => {
    if (init.signal?.aborted) throw error;
    throw new Refusal(SILENCE);
  });
  if (!response.ok) throw new Refusal(await refusalOf(response));
  const text = await response.text();
  return (text ? JSON.parse(text) : null) as T;
}

/** A request with a JSON body. */
export function request(method: string, body: unknown): RequestInit {
  if (body === undefined) return { method };
  return json(method, JSON.stringify(body));
}

function json(method: string, body: string): RequestInit {
  return { method, body, headers: { 'content-type': 'application/json' } };
}

async function refusalOf(response: Response): Promise<Problem> {
  return problemIn(await response.text().catch(() => ''), response.status, response.statusText);
}

/** The problem in the body of a refusal, or what its status says. */
export function problemIn(body: string, status: number, statusText: string): Problem {
  try {
    const problem = JSON.parse(body) as Partial<Problem>;
    return {
      ...local(problem.title ?? '', problem.detail ?? ''),
      ...problem,
      status,
    };
  } catch {
    const detail = statusText || 'The answer could not be read.';
    return { ...local(`The server answered ${status}`, detail), status };
  }
}

/** No answer at all. */
export const SILENCE = local('No answer from the server', 'Check that sonarium is running.');

function local(title: string, detail: string): Problem {
  return { type: 'about:blank', title, status: 0, detail, field: null };
}
