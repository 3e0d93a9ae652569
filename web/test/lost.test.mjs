// Promise: when the browser takes the graphics away, the picture is back, with the cook where it was, without loading anything anew:
// within three seconds on a quiet machine, which is printed and not judged.

import assert from "node:assert/strict";
import { mkdirSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { test } from "node:test";

import { SHARP, STUCK_MS, WEBGL2, WEBGPU, launch, trouble } from "./browser.mjs";
import { difference, pixels } from "./canvas.mjs";
import { press, rests, stats, until, visit } from "./cooking.mjs";
import { serve } from "./site_server.mjs";

const PICTURES = resolve(process.env.SAUTE_PICTURES ?? "pictures");
/** What a browser says when its graphics are gone; what follows is the page's own. */
const SAID_OF_LOSS = /CONTEXT_LOST|context lost|device (is )?lost|Device.*lost|graphics|external Instance reference/i;

/**
 * What Chromium says with the flags of WebGPU where a page draws with WebGL 2, once or twice in a run, when it takes the canvas
 * over by its Vulkan in software; a page that only clears its canvas gets the first one too. That the picture is right is compared.
 */
const SAID_OF_FLAGS = /GL_INVALID_OPERATION: gl(BlitFramebuffer: Blit feedback loop|CopyTexSubImage2D: Invalid copy texture format)/;

const loseWebGl = () =>
  document.getElementById("canvas").getContext("webgl2").getExtension("WEBGL_lose_context").loseContext();

/** The process that draws for all pages ends, as after a fault of its driver. */
async function crash(browser) {
  const session = await browser.newBrowserCDPSession();
  await session.send("Browser.crashGpuProcess");
}

/** After a crash Chromium gives a site that drew no graphics for some minutes, unless it is told to. */
const FORGIVING = "--disable-domain-blocking-for-3d-apis";

/** The picture once it rests: a forecast under way still puts its numbers there while time stands still. */
async function settled(page) {
  await rests(page);
  return pixels(page);
}

/** What is lost, Chromium's flags, how it is lost, and what it says. */
const LOSSES = [
  ["webgl2", WEBGL2, (_, page) => page.evaluate(loseWebGl), [SAID_OF_LOSS]],
  ["webgpu", [...WEBGPU, FORGIVING], (browser) => crash(browser), [SAID_OF_LOSS, SAID_OF_FLAGS]],
];

for (const [backend, args, lose, known] of LOSSES) {
  test(`a lost ${backend} comes back with the cook`, { timeout: STUCK_MS }, async () => {
    mkdirSync(PICTURES, { recursive: true });
    const [browser, host] = await Promise.all([launch(args), serve(resolve(process.env.SAUTE_PAGE))]);
    try {
      const { page, seen } = await visit(browser, `${host.address}?backend=${backend}`, SHARP);
      // At the pace of the clock, which every machine holds: no notice comes and goes.
      await press(page, "e");
      await until(page, "the hob is on", (now) => now.hob_w > 0 && now.time_s > 2);
      await press(page, "a");
      await until(page, "the steak is in", (now) => now.pieces[0].place === "pan");
      await press(page, " ");
      const before = await until(page, "time stands still", (now) => now.paused);
      const { png: _, ...picture } = await settled(page);
      await page.evaluate(() => (window.before = document.getElementById("canvas")));
      const lost = Date.now();
      const loaded = seen.requests.length;
      await lose(browser, page);
      const isDrawn = (frames) =>
        document.getElementById("canvas") !== window.before && JSON.parse(window.saute.stats() || "{}").frames > frames + 1;
      await page.waitForFunction(isDrawn, before.frames, { polling: 20 });
      const away = Date.now() - lost;
      const after = await stats(page);
      const { png, ...again } = await settled(page);
      writeFileSync(join(PICTURES, `${backend}-lost-and-back.png`), png);
      console.log(`${backend}: the picture was away for ${away} ms, and is back with ${after.backend}`);
      assert.deepEqual(seen.requests.slice(loaded), []);
      assert.deepEqual([after.time_s, after.pan_c, after.pieces], [before.time_s, before.pan_c, before.pieces]);
      const { p99 } = difference(picture, again);
      assert.ok(p99 < 3, `the picture differs by ${p99}`);
      // The cook goes on.
      await page.locator("#canvas").focus();
      await press(page, " ");
      await until(page, "time goes on", (now) => now.time_s > before.time_s + 3);
      assert.deepEqual(trouble(seen).filter((line) => !known.some((said) => said.test(line))), []);
    } finally {
      host.end();
      await browser.close();
    }
  });
}
