// Promises of the page's sound without a page: a small module that imports nothing and makes the bits of the window. With a page:
// hands.test.mjs.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { test } from "node:test";

import { frying } from "./sounding.mjs";

const RATE = 48000;
const BLOCK = 128;

const bytes = readFileSync(join(resolve(process.env.SAUTE_PAGE), "sound_player.wasm"));
const module = new WebAssembly.Module(bytes);

/** A player at a rate, as the worklet has it. */
function begun(rate) {
  const calls = new WebAssembly.Instance(module).exports;
  calls.begin(rate);
  const numbers = () => new Float32Array(calls.memory.buffer);
  const hear = (letter) => {
    numbers().set(letter, calls.letter_at() >> 2);
    return calls.hear(letter.length);
  };
  const render = (count) => {
    const made = calls.render(count);
    return [calls.left_at(), calls.right_at()].map((at) => numbers().slice(at >> 2, (at >> 2) + made));
  };
  return { calls, hear, render };
}

test("the module is small and imports nothing", () => {
  assert.deepEqual(WebAssembly.Module.imports(module), []);
  assert.ok(bytes.length <= 150_000, `${bytes.length} bytes`);
});

test("the module makes the bits of the window", () => {
  const { hear, render } = begun(RATE);
  assert.equal(hear(frying()), 1);
  // FNV-1a of the bits, in 32 bits; crates/sound/tests/sound/played.rs has this number too.
  let hash = 0x811c9dc5;
  const bits = new DataView(new ArrayBuffer(4));
  for (let left = RATE / 2; left > 0; left -= BLOCK) {
    const [l, r] = render(Math.min(BLOCK, left));
    for (let place = 0; place < l.length; place++) {
      for (const sample of [l[place], r[place]]) {
        bits.setFloat32(0, sample);
        hash = Math.imul(hash ^ bits.getUint32(0), 0x01000193) >>> 0;
      }
    }
  }
  assert.equal(hash.toString(16), "c0cd5f5a");
});

test("blocks of any length, and letters that are none, are survived", () => {
  const { calls, hear, render } = begun(44100);
  for (const length of [0, 16, 18, calls.letter_room() + 1, 1e9]) assert.equal(calls.hear(length), 0, `${length}`);
  assert.equal(hear(frying()), 1);
  for (const [asked, made] of [[0, 0], [1, 1], [128, 128], [1024, 1024], [5000, 1024]]) assert.equal(render(asked)[0].length, made);
  assert.ok(render(1024)[0].every((sample) => Number.isFinite(sample)));
});
