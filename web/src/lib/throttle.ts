/** Calls `act` with the newest value at once, then at most every `ms`. */
export class Throttle<T> {
  readonly #ms: number;
  readonly #act: (value: T) => void;
  #timer: ReturnType<typeof setTimeout> | null = null;
  #waiting: { value: T } | null = null;

  constructor(ms: number, act: (value: T) => void) {
    this.#ms = ms;
    this.#act = act;
  }

  /** Offers a value; one that is followed by a newer one in time is never acted on. */
  offer(value: T): void {
    if (this.#timer !== null) {
      this.#waiting = { value };
      return;
    }
    this.#act(value);
    this.#timer = setTimeout(() => this.#due(), this.#ms);
  }

  /** Forgets what waits. */
  stop(): void {
    if (this.#timer !== null) clearTimeout(this.#timer);
    this.#timer = null;
    this.#waiting = null;
  }

  #due(): void {
    this.#timer = null;
    const waiting = this.#waiting;
    this.#waiting = null;
    if (waiting) this.offer(waiting.value);
  }
}
