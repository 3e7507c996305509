/** Ways to begin editing: a world's file, a map that was traced, a copy of a world. */

import { brief } from '../format';
import * as api from './api';
import type { Underlay } from './draw';
import type { Beginning } from './editor.svelte';
import { freeName, nameFrom } from './names';
import type { MapPicture, TraceDraft, WorldFile, WorldSummary } from '../protocol';

/** Begins with an uploaded world; its name is changed when it is taken. */
export async function fromFile(file: File, taken: string[]): Promise<Beginning> {
  const { world } = await api.read(await file.text());
  const name = freeName(world.name, taken);
  return { draft: { ...world, name }, saved: null, unsaved: true, note: `From ${file.name}.` };
}

/** Begins with a map that the server traces. */
export async function fromMap(
  image: File,
  yaml: File,
  taken: string[],
  onsent: (share: number) => void,
): Promise<Beginning> {
  const traced = await api.trace(image, yaml, onsent);
  const title = traced.world.title || image.name.replace(/\.[^.]+$/, '');
  const name = freeName(traced.world.name || nameFrom(title), taken);
  return {
    draft: { ...traced.world, title, name },
    saved: null,
    unsaved: true,
    underlay: await underlayOf(traced.picture),
    note: traceWords(traced, image.name),
  };
}

const NO_MAP = 'No picture of the map is kept with this world; its plan is complete without.';

/** Begins with a copy of a world. */
export function copyOf(world: WorldFile, underlay: Underlay | null, taken: string[]): Beginning {
  const name = freeName(world.name, [...taken, world.name]);
  return { draft: { ...world, name, title: `${world.title} (copy)` }, saved: null, underlay };
}

/** Begins with a world as it stands; a built-in one is saved under another name. */
export function opened(
  world: WorldFile,
  underlay: Underlay | null,
  worlds: WorldSummary[],
): Beginning {
  const isBuiltIn = worlds.some(({ name, built_in }) => built_in && name === world.name);
  if (!isBuiltIn) {
    const note = world.floor.length > 0 && !underlay ? NO_MAP : '';
    return { draft: world, saved: world.name, underlay, note };
  }
  const names = worlds.map(({ name }) => name);
  const draft = { ...world, name: freeName(world.name, names) };
  return { draft, saved: null, builtIn: world.name };
}

/** What tracing did, in a sentence. */
export function traceWords(traced: TraceDraft, from: string): string {
  const { width_cells, height_cells, resolution_m, free_area_m2 } = traced;
  const specks = traced.specks_dropped > 0 ? `, ${traced.specks_dropped} specks left out` : '';
  return (
    `Traced from ${from}: ${width_cells} × ${height_cells} cells of ${brief(resolution_m)} m, ` +
    `${Math.round(free_area_m2)} m² free; ${traced.segments_before.toLocaleString('en')} cell edges ` +
    `became ${traced.segments_after.toLocaleString('en')} wall pieces within half a cell${specks}.`
  );
}

/** The picture of a world's map, ready to be drawn; `null` when there is none that can be. */
export async function underlayOf(picture: MapPicture | null): Promise<Underlay | null> {
  if (!picture) return null;
  const image = new Image();
  image.src = `data:image/png;base64,${picture.png_base64}`;
  try {
    await image.decode();
  } catch {
    // Without the picture the traced walls are still there.
    return null;
  }
  const { corner, yaw_deg, width_m, height_m } = picture;
  return { image, picture, corner: [corner.x_m, corner.y_m], turn_deg: yaw_deg, width_m, height_m };
}
