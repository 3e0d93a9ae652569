// Does heavy work in workers, so that no frame waits for it: the same module once more for each kind of work, with its own memory.

/** The workers, by the kind of their work. */
export class Jobs {
  /** `program` resolves with the compiled module and the address of its script; `wake` lets the window take answers. */
  constructor(program, address, wake) {
    this.begin = (kind) => new Job(kind, program, address, wake);
    this.kinds = new Map();
  }

  /** Gives the worker of a kind an order in place of the one before. */
  ask(kind, bytes) {
    this.of(kind).ask(bytes);
  }

  /** Answers of a kind since the last call; undefined once its worker is of no use. */
  take(kind) {
    return this.of(kind).take();
  }

  of(kind) {
    if (!this.kinds.has(kind)) this.kinds.set(kind, this.begin(kind));
    return this.kinds.get(kind);
  }
}

/** One kind of work and its worker, which begins with the first order. */
class Job {
  constructor(kind, program, address, wake) {
    Object.assign(this, { kind, program, address, wake });
    this.answers = [];
    this.failed = typeof Worker === "undefined";
    this.worker = null;
  }

  ask(bytes) {
    if (this.failed) return;
    this.answers.length = 0;
    this.worker ??= this.begin();
    this.worker.then((worker) => worker.postMessage({ order: bytes }, [bytes.buffer])).catch(() => this.fail());
  }

  take() {
    return this.failed ? undefined : this.answers.splice(0);
  }

  async begin() {
    const { module, script } = await this.program;
    const worker = new Worker(this.address, { type: "module", name: this.kind });
    worker.addEventListener("error", () => this.fail());
    worker.addEventListener("message", ({ data }) => {
      if (data.failure) return this.fail(data.failure);
      this.answers.push(data.answer);
      this.wake();
    });
    worker.postMessage({ module, script, kind: this.kind });
    return worker;
  }

  fail(reason = "it could not be started") {
    if (!this.failed) console.info(`The page does without its worker "${this.kind}": ${reason}`);
    this.failed = true;
    this.wake();
  }
}
