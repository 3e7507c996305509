/** One reproduction as the page sees it: how far it is, and the result when it is there. */

import * as api from './api';
import type { Problem, Reproduction, ReproductionProgress } from './protocol';

/** Milliseconds between two looks at the progress. */
const LOOK = 500;

/** A target that is watched. Whether it is computed is the server's to say, so a reload changes nothing. */
export class Computation {
  readonly target: string;
  progress = $state.raw<ReproductionProgress | null>(null);
  result = $state.raw<Reproduction | null>(null);
  problem = $state.raw<Problem | null>(null);

  #timer: ReturnType<typeof setTimeout> | null = null;
  #closed = false;
  #asked = false;

  constructor(target: string) {
    this.target = target;
  }

  /** Looks how far it is, and fetches what is there or under way. Starts nothing. */
  async open(): Promise<void> {
    await this.#look();
  }

  /** Has it computed. */
  async compute(): Promise<void> {
    this.problem = null;
    this.#watch();
    await this.#fetch();
  }

  /** Stops looking. */
  close(): void {
    this.#closed = true;
    if (this.#timer !== null) clearTimeout(this.#timer);
  }

  async #look(): Promise<void> {
    try {
      const progress = await api.reproductionProgress(this.target);
      if (this.#closed) return;
      this.progress = progress;
      if (this.result) return;
      if (progress.state === 'done' || busy(progress)) {
        void this.#fetch();
        if (busy(progress)) this.#watch();
      } else if (this.#asked) this.#watch();
    } catch (error) {
      this.problem = api.problemOf(error);
    }
  }

  #watch(): void {
    if (this.#timer !== null) clearTimeout(this.#timer);
    if (!this.#closed) this.#timer = setTimeout(() => void this.#look(), LOOK);
  }

  async #fetch(): Promise<void> {
    if (this.#asked) return;
    this.#asked = true;
    try {
      this.result = await api.reproduction(this.target);
    } catch (error) {
      this.problem = api.problemOf(error);
    } finally {
      this.#asked = false;
      if (!this.#closed) await this.#look();
    }
  }
}

/** Whether sets are being run, or will be. */
export const busy = (progress: ReproductionProgress | null) =>
  progress?.state === 'running' || progress?.state === 'waiting';
