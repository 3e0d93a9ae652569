// Promise: a steak cooks in the page as in the window, in WebGL2 and in WebGPU: it is put in, heated, flipped, cut, seen in
// every view and taken out. Each step is read from the page's state and from the pixels of its canvas.

import assert from "node:assert/strict";
import { mkdirSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { after, before, test } from "node:test";

import { SHARP, STUCK_MS, WEBGL2, WEBGPU, launch, reaches, trouble, watch } from "./browser.mjs";
import { difference, pixels } from "./canvas.mjs";
import { atSpeed, isNoFirstVisit, press, until } from "./cooking.mjs";
import { serve } from "./site_server.mjs";

const SITE = resolve(process.env.SAUTE_PAGE);
const PICTURES = resolve(process.env.SAUTE_PICTURES ?? "pictures");
/** Keys of the views, in the order of their chips. */
const VIEWS = ["look", "temperature", "moisture", "doneness", "browning", "lethality", "marbling"];

let host;

before(async () => {
  mkdirSync(PICTURES, { recursive: true });
  host = await serve(SITE);
});

after(() => host?.end());

/** Takes a picture of the canvas and keeps it. */
async function look(page, name) {
  const { png, ...picture } = await pixels(page);
  writeFileSync(join(PICTURES, `${name}.png`), png);
  return picture;
}

/** In WebGPU, whose shaders are the same, the views are part of a campaign: the pictures of poses.json compare them. */
const viewsOf = (backend) => (backend === "webgl2" || process.env.SAUTE_CAMPAIGN ? VIEWS : []);
/** Sharp enough for what differs between two pictures; in the campaign every pixel. */
const SEEN = process.env.SAUTE_CAMPAIGN ? SHARP : {};

async function cook(page, backend) {
  const keep = (name) => look(page, `${backend}-${name}`);
  const first = await until(page, "the first frames", (now) => now.frames > 2);
  assert.equal(first.backend, backend);
  const empty = await keep("1-start");
  await page.mouse.click(640, 560);
  await page.keyboard.press("Escape");
  await isNoFirstVisit(page);
  // Twice the hob's power, five times real time.
  await press(page, "e");
  await press(page, "e");
  await atSpeed(page, 5);
  await until(page, "the pan heats", (now) => now.hob_w > 0 && now.pan_c > 60);
  await press(page, "a");
  const raw = await until(page, "the steak is in", (now) => now.pieces[0].place === "pan");
  const lies = await keep("2-in");
  assert.ok(difference(empty, lies).changed > 0.01, "the steak is seen in the pan");
  await until(page, "the steak cooks", (now) => now.time_s > raw.time_s + 30);
  await press(page, "f");
  await until(page, "the steak is turned", (now) => now.pieces[0].upside_down);
  await until(page, "it lies again", (now) => now.pieces[0].place === "pan");
  const seared = await keep("3-flipped");
  assert.ok(difference(lies, seared).changed > 0.01, "the seared face is seen");
  await press(page, " ");
  await until(page, "time stands still", (now) => now.paused);
  await press(page, "x");
  let last = await keep("4-cut");
  assert.ok(difference(seared, last).changed > 0.01, "the cut is seen");
  for (const [place, view] of viewsOf(backend).entries()) {
    await press(page, String(place + 1));
    const now = await keep(`5-${view}`);
    if (place > 0) assert.ok(difference(last, now).changed > 0.005, `${view} has colours of its own`);
    last = now;
  }
  await press(page, "y");
  assert.ok(difference(last, await keep("6-split")).changed > 0.05, "both halves are seen");
  for (const key of ["y", "1", "x", " "]) await press(page, key);
  await press(page, "o");
  const done = await until(page, "the steak is out", (now) => now.pieces[0].place === "board");
  await keep("7-out");
  assert.ok(done.pieces[0].core_c > raw.pieces[0].core_c, "heat has come to the core");
}

for (const [backend, args] of [["webgl2", WEBGL2], ["webgpu", WEBGPU]]) {
  test(`a steak cooks in ${backend}`, { timeout: STUCK_MS }, async () => {
    const browser = await launch(args);
    try {
      const visit = await watch(browser, `${host.address}?backend=${backend}`, SEEN);
      await reaches(visit.page, "cooking");
      await cook(visit.page, backend);
      assert.deepEqual(trouble(visit.seen), []);
    } finally {
      await browser.close();
    }
  });
}
