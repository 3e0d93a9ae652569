// Cooking in a page that is watched: its state, keys, and a cook that is quickly begun.

import assert from "node:assert/strict";
import { resolve } from "node:path";
import { after, before } from "node:test";

import { LATE_MS, launch, reaches, watch } from "./browser.mjs";
import { serve } from "./site_server.mjs";

/** A browser and the built page on a server, for all tests of a file. */
export function kitchen() {
  const there = { browser: null, host: null };
  before(async () => {
    [there.browser, there.host] = await Promise.all([launch(), serve(resolve(process.env.SAUTE_PAGE))]);
  });
  after(async () => {
    there.host?.end();
    await there.browser?.close();
  });
  return there;
}

export const stats = (page) => page.evaluate(() => JSON.parse(window.saute.stats()));

/** Waits until the state fulfils a condition; the last state is in the message if it never does. */
export async function until(page, what, holds) {
  const end = Date.now() + LATE_MS;
  for (let state; ; ) {
    state = await stats(page);
    if (holds(state)) return state;
    assert.ok(Date.now() < end, `${what}: ${JSON.stringify(state)}`);
    await page.waitForTimeout(100);
  }
}

/** Waits for some more frames. */
export async function draws(page, count) {
  const { frames } = await stats(page);
  return until(page, `${count} frames`, (now) => now.frames >= frames + count);
}

/** Waits until the picture stays as it is: nothing moves, nothing is left to smooth, no answer is awaited. */
export const rests = (page) => until(page, "the picture rests", (now) => now.rests);

/** Presses a key on the canvas and waits for two more frames. */
export async function press(page, key) {
  const before = await stats(page);
  await page.keyboard.press(key);
  await until(page, `a frame after ${key}`, (now) => now.frames > before.frames + 1);
}

/** Opens an address and waits until the page cooks; the card of the first steps is closed. */
export async function visit(browser, address, options = {}) {
  const found = await watch(browser, address, options);
  await begins(found.page);
  return found;
}

/** Waits until the page cooks, closes the card of the first steps and opens all controls, at the pace of a kitchen. */
export async function begins(page) {
  await reaches(page, "cooking");
  await until(page, "the first frames", (now) => now.frames > 2);
  await page.locator("#canvas").focus();
  await press(page, "Escape");
  await isNoFirstVisit(page);
}

/** Opens all controls where there are few, and lets time run at the pace of a kitchen. */
export async function isNoFirstVisit(page) {
  if ((await stats(page)).few) await press(page, "F6");
  await press(page, "[");
  await atSpeed(page, 1);
}

/** Lets time run at one of the speeds of the window. */
export async function atSpeed(page, speed) {
  for (let now; (now = (await stats(page)).speed) !== speed; ) await press(page, now < speed ? "]" : "[");
}

/** Heats the pan at five times real time until a time has passed [s]. */
export async function cookUntil(page, time_s) {
  await press(page, "e");
  await atSpeed(page, 5);
  return until(page, "the pan heats", (now) => now.hob_w > 0 && now.time_s > time_s);
}
