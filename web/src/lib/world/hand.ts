/** The pointers on the plan: one drags or draws, two pinch. No events and no canvas here, so that it can be tested. */

import { withGoal, withHome, toCm, type Draft } from './draft';
import type { Tool } from './editor.svelte';
import { dragged, gripAt, withSideTurned, type Chosen, type Grip, type Plan } from './grips';
import { panned, pinched, toWorld, type Point, type View } from './view';

/** What the hand asks of the editor. */
export interface Table {
  plan(): Plan;
  tool(): Tool;
  edit(draft: Draft, key: string): void;
  settle(): void;
  look(view: View): void;
  choose(chosen: Chosen | null): void;
  /** A line or wall that is being drawn; `null` when it is none any more. */
  stroke(line: [Point, Point] | null): void;
  /** Adds what was drawn. */
  add(from: Point, to: Point): void;
}

/** Way of the pointer that makes a press a drag, pixels. */
const STILL = 3;

type Doing =
  | { what: 'pan' }
  | { what: 'pinch' }
  | { what: 'draw'; from: Point }
  | { what: 'drag'; grip: Grip; start: Draft; from: Point; key: string };

/** What a tool takes hold of: one for placing leaves all but its handle, for it goes where it is pressed. */
const TAKES: Record<Tool, Grip['kind'][]> = {
  move: ['home', 'heading', 'goal', 'radius', 'wall', 'block', 'ring', 'between', 'line', 'side'],
  home: ['heading'],
  goal: ['radius'],
  line: ['side'],
  wall: [],
  block: [],
};

/** One hand on one plan. */
export class Hand {
  readonly #table: Table;
  readonly #pointers = new Map<number, Point>();
  #doing: Doing | null = null;
  #moved = false;
  #presses = 0;

  constructor(table: Table) {
    this.#table = table;
  }

  /** What the pointer would take hold of. */
  over(at: Point): Grip | null {
    const grip = gripAt(this.#table.plan(), at);
    return grip && TAKES[this.#table.tool()].includes(grip.kind) ? grip : null;
  }

  down(pointer: number, at: Point): void {
    this.#pointers.set(pointer, at);
    this.#moved = false;
    if (this.#pointers.size > 1) {
      this.#stopDrawing();
      this.#doing = { what: 'pinch' };
      return;
    }
    this.#presses += 1;
    this.#doing = this.#begin(at);
  }

  move(pointer: number, at: Point): void {
    const before = this.#pointers.get(pointer);
    if (!before || !this.#doing) return;
    const others = [...this.#pointers].filter(([each]) => each !== pointer);
    const { plan, look, edit, stroke } = this.#table;
    const { view, size } = plan();
    if (!this.#moved && Math.hypot(at[0] - before[0], at[1] - before[1]) < STILL) return;
    this.#moved = true;
    this.#pointers.set(pointer, at);
    const other = others[0]?.[1];
    switch (this.#doing.what) {
      case 'pan':
        return look(panned(view, at[0] - before[0], at[1] - before[1]));
      case 'pinch':
        if (other) look(pinched(view, size, [before, other], [at, other]));
        return;
      case 'draw':
        return stroke([this.#doing.from, toWorld(view, size, at)]);
      case 'drag': {
        const { start, grip, from, key } = this.#doing;
        return edit(dragged(start, grip, from, toWorld(view, size, at)), key);
      }
    }
  }

  up(pointer: number, at: Point): void {
    if (!this.#pointers.delete(pointer)) return;
    const doing = this.#doing;
    if (this.#pointers.size > 0) {
      this.#doing = doing?.what === 'pinch' ? { what: 'pan' } : doing;
      return;
    }
    this.#doing = null;
    const { plan, edit, settle, choose, add } = this.#table;
    const { draft, view, size } = plan();
    if (doing?.what === 'draw' && this.#moved) add(doing.from, toWorld(view, size, at));
    if (doing?.what === 'pan' && !this.#moved) choose(null);
    if (doing?.what === 'drag' && doing.grip.kind === 'side' && !this.#moved) {
      edit(withSideTurned(draft, doing.grip), doing.key);
    }
    this.#stopDrawing();
    settle();
  }

  /** The pointer was taken away, as by a scroll: nothing more comes of it. */
  cancel(pointer: number): void {
    this.#pointers.delete(pointer);
    this.#doing = null;
    this.#stopDrawing();
    this.#table.settle();
  }

  /** What a press begins. */
  #begin(at: Point): Doing {
    const { plan, tool, choose, edit } = this.#table;
    const { draft, view, size, region } = plan();
    const from = toWorld(view, size, at);
    const key = `press ${this.#presses}`;
    const grip = this.over(at);
    if (grip) {
      if (grip.kind === 'between') edit(dragged(draft, grip, from, from), key);
      choose(chosenBy(grip));
      return { what: 'drag', grip, start: draft, from, key };
    }
    if (tool() === 'home') return this.#place({ kind: 'home' }, from, key);
    if (tool() === 'goal') return this.#place({ kind: 'goal' }, from, key);
    const draws = tool() === 'wall' || tool() === 'block' || (tool() === 'line' && region !== null);
    return draws ? { what: 'draw', from } : { what: 'pan' };
  }

  /** Puts home or goal where the plan was pressed; going on, it is dragged. */
  #place(grip: { kind: 'home' } | { kind: 'goal' }, from: Point, key: string): Doing {
    const { plan, edit, choose } = this.#table;
    const { draft } = plan();
    const [x, y] = [toCm(from[0]), toCm(from[1])];
    const start = grip.kind === 'home' ? withHome(draft, { x, y }) : withGoal(draft, { x, y });
    edit(start, key);
    choose(grip);
    return { what: 'drag', grip, start, from, key };
  }

  #stopDrawing(): void {
    this.#table.stroke(null);
  }
}

/** What is chosen when something is taken hold of. */
function chosenBy(grip: Grip): Chosen {
  switch (grip.kind) {
    case 'heading':
      return { kind: 'home' };
    case 'radius':
      return { kind: 'goal' };
    case 'side':
      return { kind: 'line', region: grip.region, rule: grip.rule };
    case 'between':
      return { ...grip.shape, point: grip.after + 1 };
    default:
      return grip;
  }
}
