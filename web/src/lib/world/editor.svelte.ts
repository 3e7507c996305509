/** The state of the world editor: the draft with its trail, the view, what is chosen, what is wrong. */

import { tick, untrack } from 'svelte';

import { problemOf, Refusal } from '../api';
import type { Problem } from '../protocol';
import * as api from './api';
import { Checker } from './checker.svelte';
import {
  boundsOf,
  EVERYWHERE,
  isCut,
  toCm,
  withGoal,
  withNewRule,
  withNewWall,
  type Draft,
} from './draft';
import type { Underlay } from './draw';
import { chainOf, elementOf, marksOf } from './faults';
import { removed, type Chosen } from './grips';
import { ruleThrough, wallThrough } from './line';
import type { WorldSummary } from '../protocol';
import { begun, edited, redone, settled, undone, type Trail } from './trail';
import { fitted, type Point, type Size, type View } from './view';

/** What a press on empty ground of the plan does. */
export type Tool = 'move' | 'home' | 'goal' | 'wall' | 'line';

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
    if (this.tool === 'wall') this.#addWall(wallThrough(from, to));
    else this.#addLine(from, to);
  }

  /** Adds a wall and chooses it. */
  #addWall(wall: Point[] | null): void {
    if (!wall) return;
    this.edit(withNewWall(this.draft, wall));
    this.chosen = { kind: 'wall', wall: this.draft.walls.length - 1 };
  }

  /** A wall of a metre at the middle of what is seen, to be typed from there. */
  typeWall(): void {
    const [x, y] = [toCm(this.view?.x_m ?? 0), toCm(this.view?.y_m ?? 0)];
    this.#addWall([
      [x, y],
      [toCm(x + 1), y],
    ]);
  }

  /** Takes away the wall or line that is chosen. */
  remove(): void {
    if (!this.chosen) return;
    const { kind } = this.chosen;
    const rest = removed(this.draft, this.chosen);
    if (rest === this.draft) return;
    this.edit(rest);
    this.chosen = null;
    this.said = kind === 'wall' ? 'Wall removed' : 'Line removed';
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
      this.said = 'Saved';
      return summary;
    } catch (error) {
      this.problem = refusedSave(error, draft.name);
      return null;
    } finally {
      this.saving = false;
    }
  }

  /** Drops a choice that the draft no longer has. */
  #keepChoice(): void {
    const { regions } = this.draft;
    if (this.region !== null && this.region >= regions.length) this.region = null;
    const chosen = this.chosen;
    if (chosen?.kind === 'wall' && chosen.wall >= this.draft.walls.length) this.chosen = null;
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
