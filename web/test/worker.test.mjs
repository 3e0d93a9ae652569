// Promises: a recorded cook is played by a worker, and arrives as it was. Where there is no worker, the page plays the cook itself. The
// longest frame meanwhile is printed, not judged: the one in which the cook changes takes longer than 100 ms on a busy machine.

import assert from "node:assert/strict";
import { test } from "node:test";

import { STUCK_MS, trouble } from "./browser.mjs";
import { atSpeed, draws, kitchen, press, stats, until, visit } from "./cooking.mjs";
import { clickFile } from "./labels.mjs";

const there = kitchen();

/** Notes how long each frame keeps the page's thread. */
const noteFrames = (page) =>
  page.addInitScript(() => {
    window.frameTimes = [];
    const request = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (draw) =>
      request((now) => {
        const begun = performance.now();
        draw(now);
        window.frameTimes.push(performance.now() - begun);
      });
  });

/** The longest frame since the last look [ms], and how many there were. */
const longest = (page) =>
  page.evaluate(() => {
    const times = window.frameTimes.splice(0);
    return { longest: Math.max(0, ...times), count: times.length };
  });

/** Cooks a recipe fast for some seconds of its time, and stops. */
async function cooked(page, time_s) {
  await atSpeed(page, 20);
  await until(page, "it cooks", (now) => now.time_s > time_s);
  await press(page, " ");
  return until(page, "it stands still", (now) => now.paused);
}

/** The cook of an address is opened anew by its own link. */
async function openedAgain(page) {
  await clickFile(page, "Copy a link to this cook");
  await until(page, "it is copied", (now) => now.said[0]?.includes("is copied"));
  const link = await page.evaluate(() => navigator.clipboard.readText());
  await longest(page);
  await page.evaluate((to) => (location.hash = new URL(to).hash), link);
  await until(page, "it is played", (now) => now.travels || now.said[0]?.includes("played again"));
}

const OPTIONS = { permissions: ["clipboard-read", "clipboard-write"] };

test("a cook is played by a worker", { timeout: STUCK_MS }, async () => {
  const { page, seen, close } = await visit(there.browser, `${there.host.address}?recipe=medium`, { ...OPTIONS, prepare: noteFrames });
  const end = await cooked(page, 120);
  await longest(page);
  await draws(page, 10);
  const without = await longest(page);
  const began = page.waitForEvent("worker");
  await openedAgain(page);
  await began;
  const arrived = await until(page, "it has arrived", (now) => !now.travels && now.time_s >= end.time_s);
  const during = await longest(page);
  console.log(`longest frame without ${without.longest.toFixed(0)} ms, while a cook is played ${during.longest.toFixed(0)} ms of ${during.count}`);
  assert.ok(during.count > 2, `${during.count} frames`);
  assert.deepEqual([arrived.time_s, arrived.pan_c, arrived.pieces], [end.time_s, end.pan_c, end.pieces]);
  // What was opened can be undone: the cook from before comes back.
  await press(page, "Control+z");
  await until(page, "undone", (now) => now.said[0] === "The cook from before is back.");
  assert.deepEqual(trouble(seen), []);
  assert.deepEqual(seen.violations, []);
  await close();
});

test("without workers the page plays the cook itself", { timeout: STUCK_MS }, async () => {
  const prepare = async (page) => {
    await noteFrames(page);
    await page.addInitScript(() => delete window.Worker);
  };
  const { page, close } = await visit(there.browser, `${there.host.address}?recipe=medium`, { ...OPTIONS, prepare });
  const end = await cooked(page, 30);
  await openedAgain(page);
  assert.equal(page.workers().length, 0);
  const arrived = await until(page, "it has arrived", (now) => !now.travels && now.time_s >= end.time_s);
  assert.deepEqual([arrived.pan_c, arrived.pieces], [end.pan_c, end.pieces]);
  assert.equal((await stats(page)).recipe, end.recipe);
  await close();
});
