// The sound of the page: begins with the first touch, sleeps while the tab is hidden, and reports once why there is none.

const version = new URL(import.meta.url).search;
const place = (file) => new URL(`./${file}${version}`, import.meta.url).href;
/** What counts as a touch: browsers let a page sound only after one. */
const TOUCHES = ["pointerup", "keydown"];

/** Plays what the window sends. Its state, for tests, is at the page's root: waits, opens, plays, sleeps or fails. */
export class Sound {
  constructor() {
    Object.assign(this, { context: null, port: null, touched: false, problem: undefined });
    this.be("waits");
    const touch = () => this.touch();
    for (const kind of TOUCHES) window.addEventListener(kind, touch, { capture: true, passive: true });
    document.addEventListener("visibilitychange", () => this.sleepOrWake());
  }

  /** Takes a letter to the player. The first one after a touch opens the sound. */
  tell(letter) {
    if (this.port) return this.port.postMessage(letter.buffer, [letter.buffer]);
    if (this.touched && this.is("waits")) this.open().catch((error) => this.fail(error));
  }

  /** Why nothing is heard, once; undefined where something is. */
  trouble() {
    const { problem } = this;
    this.problem = undefined;
    return problem;
  }

  touch() {
    this.touched = true;
    // Some browsers wake a sound only within a touch.
    if (this.port && this.context.state !== "running") this.sleepOrWake();
  }

  async open() {
    this.be("opens");
    if (!window.isSecureContext) throw new Error("browsers give it to pages by https only");
    if (!window.AudioContext || !window.AudioWorkletNode) throw new Error("this browser has no AudioWorklet");
    this.context = new AudioContext({ latencyHint: "interactive" });
    const node = await player(this.context);
    node.addEventListener("processorerror", () => this.fail(new Error("its module has stopped")));
    node.connect(this.context.destination);
    this.port = node.port;
    await this.sleepOrWake();
  }

  async sleepOrWake() {
    if (!this.port) return;
    const asleep = document.hidden;
    await (asleep ? this.context.suspend() : this.context.resume()).catch(() => {});
    if (this.port) this.be(asleep ? "sleeps" : "plays");
  }

  fail(error) {
    this.context?.close().catch(() => {});
    Object.assign(this, { port: null, problem: error.message });
    this.be("fails");
  }

  be(state) {
    document.documentElement.dataset.sound = state;
  }

  is(state) {
    return document.documentElement.dataset.sound === state;
  }
}

/** A player in a context, also in one that renders to memory. */
export async function player(context) {
  const [bytes] = await Promise.all([fetchBytes("sound_player.wasm"), context.audioWorklet.addModule(place("sound_worklet.js"))]);
  const options = { numberOfInputs: 0, outputChannelCount: [2], processorOptions: { bytes } };
  return new AudioWorkletNode(context, "saute-player", options);
}

async function fetchBytes(file) {
  const response = await fetch(place(file));
  if (!response.ok) throw new Error(`${file}: ${response.status}`);
  return response.arrayBuffer();
}
