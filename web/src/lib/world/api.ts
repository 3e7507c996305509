/** The worlds interface as the page uses it. */

import { ask, problemIn, Refusal, request, ROOT, SILENCE, type Size } from '../api';
import type { ThemeName } from '../protocol';
import type { Draft } from './draft';
import type {
  MapPicture,
  RegionProposal,
  TraceDraft,
  WorldCheck,
  WorldFile,
  WorldSummary,
} from '../protocol';

const path = (name: string) => `worlds/${encodeURIComponent(name)}`;

export const worlds = () => ask<WorldSummary[]>('worlds', request('GET', undefined));
export const world = async (name: string) =>
  complete(await ask<WorldFile>(path(name), request('GET', undefined)));
export const deleteWorld = (name: string) => ask<null>(path(name), request('DELETE', undefined));

/** Checks a draft; the answer to a check that was given up is never waited for. */
export const check = (draft: Draft, signal: AbortSignal) =>
  ask<WorldCheck>('worlds/check', { ...request('POST', draft), signal });

/** Reads and checks a world's file. */
export async function read(toml: string): Promise<WorldCheck> {
  const headers = { 'content-type': 'application/toml' };
  const found = await ask<WorldCheck>('worlds/check', { method: 'POST', body: toml, headers });
  return { ...found, world: complete(found.world) };
}

/** Regions the server proposes for a draft. */
export const propose = (draft: Draft) =>
  ask<RegionProposal>('worlds/regions', request('POST', { ...draft, regions: [] }));

/** Saves a world; a new one is refused (412) where there is one of its name already. */
export function save(draft: Draft, isNew: boolean): Promise<WorldSummary> {
  const init = request('PUT', draft);
  const headers = { ...init.headers, ...(isNew && { 'if-none-match': '*' }) };
  return ask<WorldSummary>(path(draft.name), { ...init, headers });
}

/** The picture of the map that a world was traced from; `null` when none is kept. */
export const mapOf = (name: string) =>
  ask<MapPicture | null>(`${path(name)}/map`, request('GET', undefined));

/** Keeps the picture of a map with a world that is saved. */
export const keepMap = (name: string, picture: MapPicture) =>
  ask<null>(`${path(name)}/map`, request('PUT', picture));

/** Traces a map; `onsent` hears the share of the files that has been sent. */
export async function trace(
  image: File,
  yaml: File,
  onsent: (share: number) => void,
): Promise<TraceDraft> {
  const form = new FormData();
  form.append('image', image);
  form.append('yaml', yaml);
  const found = await send<TraceDraft>('worlds/trace', form, onsent);
  return { ...found, world: complete(found.world) };
}

/** Address of a world's file. */
export const worldFile = (name: string) => `${ROOT}/${path(name)}?format=toml`;

/** Address of a world's picture. */
export function worldPlan(name: string, { width, height }: Size, theme: ThemeName): string {
  return `${ROOT}/${path(name)}/picture.png?width=${width}&height=${height}&theme=${theme}`;
}

/** All lists are there, as an editor wants them. */
function complete(file: WorldFile): WorldFile {
  const regions = (file.regions ?? []).map((each) => ({ ...each, rules: each.rules ?? [] }));
  const [walls, blocks, floor] = [file.walls ?? [], file.blocks ?? [], file.floor ?? []];
  return { ...file, walls, blocks, floor, regions };
}

/** Posts a form. `fetch` does not tell how much has been sent. */
function send<T>(where: string, form: FormData, onsent: (share: number) => void): Promise<T> {
  return new Promise((resolve, reject) => {
    const call = new XMLHttpRequest();
    call.open('POST', `${ROOT}/${where}`);
    call.upload.addEventListener('progress', ({ loaded, total }) =>
      onsent(total > 0 ? loaded / total : 0),
    );
    call.addEventListener('error', () => reject(new Refusal(SILENCE)));
    call.addEventListener('load', () => {
      const { status, statusText, responseText } = call;
      if (status >= 200 && status < 300) resolve(JSON.parse(responseText) as T);
      else reject(new Refusal(problemIn(responseText, status, statusText)));
    });
    call.send(form);
  });
}
