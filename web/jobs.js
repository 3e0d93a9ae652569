// Does heavy work in workers, so that no frame waits for it: the same module once more for each kind of work, with its own memory.
// Where there are two cores, two workers share what takes long: both get the order, and tell each other what they have done.

/** The workers, by the kind of their work. */
export class Jobs {
  /** `program` resolves with the compiled module and the address of its script; `wake` lets the window take answers. */
  constructor(program, address, wake) {
    this.begin = (kind, isShared) => new Job(kind, isShared && navigator.hardwareConcurrency > 1, program, address, wake);
    this.kinds = new Map();
  }

  /** Gives the worker of a kind an order in place of the one before. */
  ask(kind, isShared, bytes) {
    if (!this.kinds.has(kind)) this.kinds.set(kind, this.begin(kind, isShared));
    this.kinds.get(kind).ask(bytes);
  }

  /** Answers of a kind since the last call; undefined once its worker is of no use. */
  take(kind) {
    return this.kinds.has(kind) ? this.kinds.get(kind).take() : [];
  }
}

/** One kind of work and its worker, which begins with the first order; the second one's answers are those of the first. */
class Job {
  constructor(kind, isShared, program, address, wake) {
    Object.assign(this, { kind, isShared, program, address, wake });
    this.answers = [];
    this.started = [];
    this.failed = typeof Worker === "undefined";
    this.workers = null;
  }

  ask(bytes) {
    if (this.failed) return;
    this.answers.length = 0;
    this.workers ??= this.begin();
    const tell = (workers) => workers.forEach((worker) => worker.postMessage({ order: bytes }));
    this.workers.then(tell).catch(() => this.fail());
  }

  take() {
    return this.failed ? undefined : this.answers.splice(0);
  }

  async begin() {
    const { module, script } = await this.program;
    const channel = this.isShared && new MessageChannel();
    const between = channel ? [channel.port1, channel.port2] : [null];
    const begin = (port, isSecond) => {
      const worker = new Worker(this.address, { type: "module", name: this.kind });
      if (!isSecond) this.listen(worker);
      worker.postMessage({ module, script, kind: this.kind, isSecond, port }, port ? [port] : []);
      this.started.push(worker);
    };
    between.forEach((port, place) => {
      try {
        begin(port, place > 0);
      } catch (error) {
        // The first one does all of it if the second one cannot work.
        if (place === 0) throw error;
      }
    });
    return this.started;
  }

  listen(worker) {
    worker.addEventListener("error", () => this.fail());
    worker.addEventListener("message", ({ data }) => {
      if (data.failure) return this.fail(data.failure);
      this.answers.push(data.answer);
      this.wake();
    });
  }

  fail(reason = "it could not be started") {
    if (!this.failed) console.info(`The page does without its worker "${this.kind}": ${reason}`);
    this.failed = true;
    this.started.forEach((worker) => worker.terminate());
    this.wake();
  }
}
