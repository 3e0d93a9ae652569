// Promises: a gamepad cooks in the page; two fingers bring the eye nearer. That the pan stays then: crates/window/tests/window/pan.rs.

import assert from "node:assert/strict";
import { test } from "node:test";

import { trouble } from "./browser.mjs";
import { difference, pixels } from "./canvas.mjs";
import { kitchen, until, visit } from "./cooking.mjs";

const there = kitchen();

/** A gamepad of the usual kind whose state the test sets. */
const plugIn = (page) =>
  page.addInitScript(() => {
    const button = () => ({ pressed: false, value: 0 });
    window.pad = { connected: true, mapping: "standard", axes: [0, 0, 0, 0], buttons: Array.from({ length: 17 }, button) };
    navigator.getGamepads = () => [null, window.pad];
  });

/** Presses a button for a few frames. */
async function pressPad(page, button) {
  const set = (down) => page.evaluate(([b, down]) => Object.assign(window.pad.buttons[b], { pressed: down, value: Number(down) }), [button, down]);
  const frames = async () => (await page.evaluate(() => JSON.parse(window.saute.stats()))).frames;
  for (const down of [true, false]) {
    await set(down);
    const before = await frames();
    await until(page, "two frames", (now) => now.frames > before + 2);
  }
}

test("a gamepad cooks: hob, steak, flip and pause", { timeout: 240_000 }, async () => {
  const { page, seen, close } = await visit(there.browser, there.host.address, { prepare: plugIn });
  await pressPad(page, 12);
  await until(page, "the hob is higher", (now) => now.hob_w > 0);
  await pressPad(page, 14);
  await until(page, "the steak is in", (now) => now.pieces[0].place === "pan");
  await pressPad(page, 0);
  await until(page, "the steak is turned", (now) => now.pieces[0].upside_down);
  await pressPad(page, 9);
  await until(page, "time stands still", (now) => now.paused);
  assert.deepEqual(trouble(seen), []);
  await close();
});

test("two fingers bring the eye nearer", { timeout: 240_000 }, async () => {
  const options = { viewport: { width: 390, height: 844 }, hasTouch: true };
  const { page, close } = await visit(there.browser, there.host.address, options);
  const touch = await page.context().newCDPSession(page);
  const fingers = (type, apart) => {
    const touchPoints = apart === null ? [] : [-apart, apart].map((x, id) => ({ x: 150 + x, y: 250, id }));
    return touch.send("Input.dispatchTouchEvent", { type, touchPoints });
  };
  const { png: _, ...before } = await pixels(page);
  await fingers("touchStart", 20);
  for (let apart = 24; apart <= 80; apart += 8) {
    await fingers("touchMove", apart);
    await page.waitForTimeout(300);
  }
  await fingers("touchEnd", null);
  await page.waitForTimeout(1500);
  const { png: __, ...after } = await pixels(page);
  assert.ok(difference(before, after).changed > 0.1, "the pan is seen from nearer");
  await close();
});
