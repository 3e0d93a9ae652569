// Plays recorded cooks in a worker, so that no frame waits for them: the same module once more, with memory of its own.

/** The worker, which begins with the first errand. */
export class Errands {
  /** `program` resolves with the compiled module and the address of its script; `wake` lets the window take answers. */
  constructor(program, address, wake) {
    Object.assign(this, { program, address, wake });
    this.answers = [];
    this.failed = typeof Worker === "undefined";
    this.worker = null;
  }

  /** Gives the worker an errand in place of the one before. */
  ask(bytes) {
    this.answers.length = 0;
    this.worker ??= this.begin();
    this.worker.then((worker) => worker.postMessage({ errand: bytes }, [bytes.buffer])).catch(() => this.fail());
  }

  /** Answers since the last call; undefined once the worker is of no use. */
  take() {
    return this.failed ? undefined : this.answers.splice(0);
  }

  async begin() {
    const { module, script } = await this.program;
    const worker = new Worker(this.address, { type: "module" });
    worker.addEventListener("error", () => this.fail());
    worker.addEventListener("message", ({ data }) => {
      if (data.failure) return this.fail(data.failure);
      this.answers.push(data.answer);
      this.wake();
    });
    worker.postMessage({ module, script });
    return worker;
  }

  fail(reason = "it could not be started") {
    if (!this.failed) console.info(`The page plays cooks without its worker: ${reason}`);
    this.failed = true;
    this.wake();
  }
}
