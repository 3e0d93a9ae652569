// Promise: the page's canvas shows what the native window shows: every food, view, cut, liquid and panel of poses.json, in
// WebGL2 and in WebGPU. The native pictures are drawn by crates/window/tests/page/stills.rs.

import assert from "node:assert/strict";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { after, before, test } from "node:test";

import { SHARP, STUCK_MS, WEBGL2, WEBGPU, launch, trouble, watch } from "./browser.mjs";
import { decoded, difference, pixels } from "./canvas.mjs";
import { begins } from "./cooking.mjs";
import { serve } from "./site_server.mjs";

const SITE = resolve(process.env.SAUTE_PAGE);
const STILLS = resolve(process.env.SAUTE_STILLS);
const PICTURES = resolve(process.env.SAUTE_PICTURES ?? "pictures");
const POSES = JSON.parse(readFileSync(new URL("poses.json", import.meta.url)));
/** Colour difference (ΔE after a slight blur) that 99 % of the pixels keep to. */
const MOST = 3;
let host;

before(async () => {
  mkdirSync(PICTURES, { recursive: true });
  host = await serve(SITE);
});

after(() => host?.end());

/** Shows a pose and waits until its picture rests. */
async function show(page, pose) {
  const frames = await page.evaluate((text) => {
    window.saute.pose(text);
    return JSON.parse(window.saute.stats()).frames;
  }, JSON.stringify(pose));
  const isShown = (seen) => {
    const now = JSON.parse(window.saute.stats());
    return now.frames > seen + 2 && now.rests;
  };
  await page.waitForFunction(isShown, frames, { polling: 50 });
}

/** Conditions that are compared in WebGPU, whose shaders are the same: the rest as part of a campaign. */
const IN_WEBGPU = ["panels", "cut", "shrimp", "best"];
/** Conditions that WebGL2 draws otherwise: its best level has no half floats, so no bloom and no depth of field. */
const NOT_IN_WEBGL2 = ["best"];
const compared = (backend) => {
  if (backend === "webgl2") return POSES.filter(({ name }) => !NOT_IN_WEBGL2.includes(name));
  return process.env.SAUTE_CAMPAIGN ? POSES : POSES.filter(({ name }) => IN_WEBGPU.includes(name));
};

for (const [backend, args] of [["webgl2", WEBGL2], ["webgpu", WEBGPU]]) {
  test(`${backend} shows what the window shows`, { timeout: STUCK_MS }, async () => {
    const browser = await launch(args);
    const wrong = [];
    try {
      const { page, seen } = await watch(browser, `${host.address}?backend=${backend}&lang=en`, SHARP);
      // The stills are those of a window that remembers nothing, with all its controls.
      await begins(page);
      for (const { name, ...pose } of compared(backend)) {
        await show(page, pose);
        const { png, ...here } = await pixels(page);
        writeFileSync(join(PICTURES, `${backend}-pose-${name}.png`), png);
        const { mean, p99, most } = difference(here, decoded(readFileSync(join(STILLS, `${name}.png`))));
        const told = `${name}: ΔE mean ${mean.toFixed(2)}, 99 % ${p99.toFixed(2)}, most ${most.toFixed(1)}`;
        console.log(`${backend} ${told}`);
        if (p99 > MOST) wrong.push(told);
      }
      assert.deepEqual(trouble(seen), []);
    } finally {
      await browser.close();
    }
    assert.deepEqual(wrong, []);
  });
}
