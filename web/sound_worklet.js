// The thread of the page's sound: it plays what it receives, by a separate module that imports nothing.

/** Plays the sound of a kitchen, sent as letters of numbers (crates/sound/src/letter.rs). */
class SautePlayer extends AudioWorkletProcessor {
  constructor({ processorOptions: { bytes } }) {
    super();
    this.calls = new WebAssembly.Instance(new WebAssembly.Module(bytes)).exports;
    this.calls.begin(sampleRate);
    this.heap = null;
    this.port.onmessage = ({ data }) => this.hear(new Float32Array(data));
  }

  /** The module's memory as numbers; another view where it has grown. */
  numbers() {
    const { buffer } = this.calls.memory;
    if (this.heap?.buffer !== buffer) this.heap = new Float32Array(buffer);
    return this.heap;
  }

  /** Takes a letter; of one that is too long the last events are left out. */
  hear(letter) {
    const room = this.calls.letter_room();
    const fits = letter.length <= room ? letter : letter.subarray(0, room);
    this.numbers().set(fits, this.calls.letter_at() >> 2);
    this.calls.hear(fits.length);
  }

  process(_, [[left, right]]) {
    const count = this.calls.render(left.length);
    this.take(left, this.calls.left_at(), count);
    if (right) this.take(right, this.calls.right_at(), count);
    return true;
  }

  take(side, at, count) {
    side.set(this.numbers().subarray(at >> 2, (at >> 2) + count));
  }
}

registerProcessor("saute-player", SautePlayer);
