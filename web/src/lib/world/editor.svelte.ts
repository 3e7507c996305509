/** The state of the world editor: the draft with its trail, the view, what is chosen, what is wrong. */

import { tick, untrack } from 'svelte';

import { problemOf, Refusal } from '../api';
import type { Problem } from '../protocol';
import * as api from './api';
import { Checker } from './checker.svelte';
import { boundsOf, EVERYWHERE, isCut, toCm, withGoal, withNewRule, type Draft } from './draft';
import type { Underlay } from './draw';
import { chainOf, elementOf, marksOf } from './faults';
import { removed, type Chosen } from './grips';
import { ruleThrough, wallThrough } from './line';
import type { WorldSummary } from '../protocol';
import {
  isShape,
  pointsOf,
  rectangleOf,
  shapesOf,
  withNewShape,
  withPointAfter,
  type ShapeKind,
} from './shapes';
import { begun, edited, redone, settled, undone, type Trail } from './trail';
import { fitted, type Point, type Size, type View } from './view';

/** What a press on empty ground of the plan does. */
export type Tool = 'move' | 'home' | 'goal' | 'wall' | 'block' | 'line';

/** A draft to begin with. */
export interface Beginning {
  draft: Draft;
  /** Name of the world it was read from and is saved to; `null` when it has no place yet. */
  saved: string | null;
  /** The world of the program it is; it can only be saved under another name. */
  builtIn?: string | null;
  /** Leaving it would lose work, although nothing was edited yet. */
  unsaved?: boolean;
  underlay?: Underlay | null;
  /** Where it comes from, for the reader. */
  note?: string;
}

/** Radius of a B21, until the server says it, metres. */
const ROBOT_RADIUS_M = 0.265;

/** One world being edited. */
export class WorldEditor {
  readonly note: string;
  readonly builtIn: string | null;
  readonly underlay: Underlay | null;
  readonly checker = new Checker();
  #trail = $state.raw<Trail<Draft>>(begun({} as Draft));
  /** Name of the world that the map's picture is kept with. */
  #mapAt: string | null;
  /** The draft as it was last saved or read. */
  #kept = $state.raw<Draft | null>(null);
  saved = $state<string | null>(null);
  view = $state.raw<View | null>(null);
  size = $state<Size>({ width: 0, height: 0 });
  tool = $state<Tool>('move');
  chosen = $state.raw<Chosen | null>(null);
  /** Region whose lines are shown. */
  region = $state<number | null>(null);
  /** What just happened, for those who cannot see the plan. */
  said = $state('');
  saving = $state(false);
  /** Why it could not be saved. */
  problem = $state.raw<Problem | null>(null);

  readonly draft = $derived(this.#trail.present);
  readonly canUndo = $derived(this.#trail.past.length > 0);
  readonly canRedo = $derived(this.#trail.future.length > 0);
  readonly changed = $derived(this.draft !== this.#kept);
  readonly faults = $derived(this.checker.found?.problems ?? []);
  readonly marks = $derived(marksOf(this.faults));
  readonly shapes = $derived(isCut(this.draft) ? (this.checker.found?.regions ?? []) : []);
  readonly robotRadius_m = $derived(this.checker.found?.robot_radius_m ?? ROBOT_RADIUS_M);

  constructor({
    draft,
    saved,
    builtIn = null,
    unsaved = false,
    underlay = null,
    note = '',
  }: Beginning) {
    this.#trail = begun(draft);
    this.#kept = unsaved ? null : draft;
    this.saved = saved;
    this.builtIn = builtIn;
    this.underlay = underlay;
    // What was read with its picture need not send it again.
    this.#mapAt = saved;
    this.note = note;
    $effect(() => {
      const draft = this.draft;
      untrack(() => this.checker.ask(draft));
    });
    // Fitted once; later the view is the reader's.
    $effect(() => {
      if (this.view === null) this.fit();
    });
    $effect(() => () => this.checker.close());
  }

  /** Changes the draft; edits with one key in a row are undone together. */
  edit(draft: Draft, key = ''): void {
    this.#trail = edited(this.#trail, draft, key);
  }

  /** Ends a drag or a visit to a field. */
  settle(): void {
    this.#trail = settled(this.#trail);
  }

  undo(): void {
    this.#trail = undone(this.#trail);
    this.#keepChoice();
    this.said = 'Undone';
  }

  redo(): void {
    this.#trail = redone(this.#trail);
    this.#keepChoice();
    this.said = 'Redone';
  }

  /** Shows the whole world. */
  fit(): void {
    if (this.size.width > 0) this.view = fitted(boundsOf(this.draft), this.size);
  }

  /** Adds what was drawn on the plan: a wall, or a line of the chosen region. */
  add(from: Point, to: Point): void {
    if (this.tool === 'wall') this.#addShape('wall', wallThrough(from, to));
    else if (this.tool === 'block') this.#addShape('block', rectangleOf(from, to));
    else this.#addLine(from, to);
  }

  /** Adds a wall, block or ring and chooses it. */
  #addShape(kind: ShapeKind, points: Point[] | null): void {
    if (!points) return;
    this.edit(withNewShape(this.draft, kind, points));
    this.chosen = { kind, index: shapesOf(this.draft, kind).length - 1 };
  }

  /** A wall of a metre, or a square, at the middle of what is seen, to be typed from there. */
  typeShape(kind: ShapeKind): void {
    const [x, y] = [toCm(this.view?.x_m ?? 0), toCm(this.view?.y_m ?? 0)];
    const to: Point = [toCm(x + 1), toCm(y + 1)];
    this.#addShape(
      kind,
      kind === 'wall'
        ? [
            [x, y],
            [to[0], y],
          ]
        : rectangleOf([x, y], to),
    );
  }

  /** Adds a point after the one that is chosen, and chooses it. */
  addPoint(): void {
    if (!isShape(this.chosen)) return;
    const shape = this.chosen;
    const last = pointsOf(this.draft, shape).length - 1;
    // The open end of a wall has nothing after it.
    const most = shape.kind === 'wall' ? last - 1 : last;
    const after = Math.min(shape.point ?? 0, most);
    this.edit(withPointAfter(this.draft, shape, after));
    this.chosen = { ...shape, point: after + 1 };
    this.said = `Point ${after + 2} added`;
  }

  /** Chooses the next point (1) or the one before (−1) of the chosen shape. */
  turnPoint(by: 1 | -1): void {
    if (!isShape(this.chosen)) return;
    const count = pointsOf(this.draft, this.chosen).length;
    const from = this.chosen.point ?? (by === 1 ? -1 : 0);
    const point = (from + by + count) % count;
    this.chosen = { ...this.chosen, point };
    this.said = `Point ${point + 1} of ${count}`;
  }

  /** Takes away the point, wall, block, ring or line that is chosen. */
  remove(): void {
    if (!this.chosen) return;
    const chosen = this.chosen;
    const rest = removed(this.draft, chosen);
    if (rest === this.draft) return;
    const wasPoint =
      isShape(chosen) &&
      shapesOf(rest, chosen.kind).length === shapesOf(this.draft, chosen.kind).length;
    this.edit(rest);
    this.chosen = wasPoint ? { kind: chosen.kind, index: chosen.index } : null;
    const name = wasPoint ? 'point' : chosen.kind;
    this.said = `${name[0]?.toUpperCase()}${name.slice(1)} removed`;
  }

  #addLine(from: Point, to: Point): void {
    const rule = ruleThrough(from, to);
    if (this.region === null || !rule) return;
    const index = this.draft.regions[this.region]?.rules.length ?? 0;
    this.edit(withNewRule(this.draft, this.region, rule));
    this.chosen = { kind: 'line', region: this.region, rule: index };
  }

  /** Cuts nothing any more, or takes the regions the server proposes. */
  leaveWhole(): void {
    this.edit({ ...this.draft, regions: [EVERYWHERE] });
    this.chooseRegion(null);
  }

  /** Takes the regions that the server proposes. */
  async takeProposal(): Promise<void> {
    this.problem = null;
    try {
      const { regions } = await api.propose(this.draft);
      this.edit({ ...this.draft, regions });
      this.chooseRegion(null);
      this.said = `${regions.length} regions proposed`;
    } catch (error) {
      this.problem = problemOf(error);
    }
  }

  chooseRegion(index: number | null): void {
    this.region = index;
    if (this.chosen?.kind === 'line') this.chosen = null;
    if (index === null && this.tool === 'line') this.tool = 'move';
  }

  /** Puts a place of the world at the middle of the plan. */
  show([x_m, y_m]: Point): void {
    if (this.view) this.view = { ...this.view, x_m, y_m, scale: Math.max(this.view.scale, 40) };
  }

  /** Puts the goal elsewhere, as near as a centimetre. */
  moveGoal([x, y]: Point): void {
    this.edit(withGoal(this.draft, { x: toCm(x), y: toCm(y) }));
    this.chosen = { kind: 'goal' };
  }

  /** Goes to the input that mends a field, if there is one. */
  async goTo(field: string): Promise<void> {
    const region = /^regions\[(\d+)\]/.exec(field)?.[1];
    if (region !== undefined) this.chooseRegion(Number(region));
    await tick();
    for (const each of chainOf(field)) {
      const element = document.getElementById(elementOf(each));
      if (!element) continue;
      element.focus();
      element.scrollIntoView({ block: 'center' });
      return;
    }
  }

  /** Saves the draft under its name; answers whether it was. */
  async save(): Promise<WorldSummary | null> {
    this.saving = true;
    this.problem = null;
    const draft = this.draft;
    try {
      const summary = await api.save(draft, this.saved !== draft.name);
      this.#kept = draft;
      this.saved = draft.name;
      await this.#keepMap(draft.name);
      this.said = 'Saved';
      return summary;
    } catch (error) {
      this.problem = refusedSave(error, draft.name);
      return null;
    } finally {
      this.saving = false;
    }
  }

  /** Keeps the map's picture with the world, once for each name. */
  async #keepMap(name: string): Promise<void> {
    const picture = this.underlay?.picture;
    if (!picture || this.#mapAt === name) return;
    await api.keepMap(name, picture);
    this.#mapAt = name;
  }

  /** Drops a choice that the draft no longer has. */
  #keepChoice(): void {
    const { regions } = this.draft;
    if (this.region !== null && this.region >= regions.length) this.region = null;
    const chosen = this.chosen;
    if (isShape(chosen) && !pointsOf(this.draft, chosen)[chosen.point ?? 0]) this.chosen = null;
    if (chosen?.kind !== 'line') return;
    if (!regions[chosen.region]?.rules[chosen.rule]) this.chosen = null;
  }
}

/** The answer to a save, where 412 means that the name is taken. */
function refusedSave(error: unknown, name: string): Problem {
  const problem = problemOf(error);
  if (!(error instanceof Refusal) || problem.status !== 412) return problem;
  const detail = `There is a world “${name}” already. Choose another name, or open that world to change it.`;
  return { ...problem, title: 'The name is taken', detail, field: 'name' };
}
