/** The live check of a draft: the newest draft counts, answers to older ones are dropped. */

import { problemOf } from '../api';
import type { Problem } from '../protocol';
import { check } from './api';
import type { Draft } from './draft';
import type { WorldCheck } from '../protocol';

/** Quiet time after an edit before it is checked, milliseconds. */
const QUIET_MS = 200;

/** What the server says of the draft. */
export class Checker {
  /** The newest answer; it may be about an earlier draft while `pending`. */
  found = $state.raw<WorldCheck | null>(null);
  /** The server could not be asked. */
  problem = $state.raw<Problem | null>(null);
  /** An edit has not been answered yet. */
  pending = $state(false);
  #timer: ReturnType<typeof setTimeout> | undefined;
  #call: AbortController | null = null;

  /** Checks a draft soon. */
  ask(draft: Draft): void {
    this.close();
    this.pending = true;
    this.#timer = setTimeout(() => void this.#check(draft), this.found ? QUIET_MS : 0);
  }

  /** Waits for no answer any more. */
  close(): void {
    clearTimeout(this.#timer);
    this.#call?.abort();
  }

  async #check(draft: Draft): Promise<void> {
    const call = new AbortController();
    this.#call = call;
    try {
      this.found = await check(draft, call.signal);
      this.problem = null;
    } catch (error) {
      if (call.signal.aborted) return;
      this.problem = problemOf(error);
    }
    this.pending = false;
  }
}
