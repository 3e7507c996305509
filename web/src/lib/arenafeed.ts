/** Draws the arena pictures of the stream: the newest wins, and none is kept. */

/** Decodes one picture at a time into a canvas. */
export class ArenaFeed {
  readonly #canvas: HTMLCanvasElement;
  readonly #ondrawn: () => void;
  #busy = false;
  #next: Blob | null = null;

  constructor(canvas: HTMLCanvasElement, ondrawn: () => void) {
    this.#canvas = canvas;
    this.#ondrawn = ondrawn;
  }

  /** Shows a picture, unless a newer one comes while the last is being decoded. */
  show(picture: Blob): void {
    this.#next = picture;
    if (!this.#busy) void this.#drawAll();
  }

  async #drawAll(): Promise<void> {
    this.#busy = true;
    while (this.#next) {
      const picture = this.#next;
      this.#next = null;
      // A broken picture is skipped: the next one replaces it anyway.
      await this.#draw(picture).catch(() => {});
    }
    this.#busy = false;
  }

  async #draw(picture: Blob): Promise<void> {
    const bitmap = await createImageBitmap(picture);
    const canvas = this.#canvas;
    if (canvas.width !== bitmap.width || canvas.height !== bitmap.height) {
      canvas.width = bitmap.width;
      canvas.height = bitmap.height;
    }
    canvas.getContext('2d')?.drawImage(bitmap, 0, 0);
    bitmap.close();
    this.#ondrawn();
  }
}
