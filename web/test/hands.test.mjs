// Promises: a gamepad cooks in the page and shakes, and the cook is heard; two fingers bring the eye nearer; the phone is the pan, also
// where a browser has no sound. What fingers do else, and
// how high controls are for them: crates/window/tests/window/touch.rs.

import assert from "node:assert/strict";
import { test } from "node:test";

import { STUCK_MS, trouble } from "./browser.mjs";
import { difference, pixels } from "./canvas.mjs";
import { draws, kitchen, stats, until, visit } from "./cooking.mjs";
import { clickLabel } from "./labels.mjs";
import { renderInPage } from "./sounding.mjs";

const there = kitchen();

/** A gamepad of the usual kind whose state the test sets. */
const plugIn = (page) =>
  page.addInitScript(() => {
    const button = () => ({ pressed: false, value: 0 });
    window.pad = { connected: true, mapping: "standard", axes: [0, 0, 0, 0], buttons: Array.from({ length: 17 }, button) };
    window.effects = [];
    window.pad.vibrationActuator = {
      playEffect: async (kind, effect) => window.effects.push({ kind, ...effect }),
      reset: async () => window.effects.push({ kind: "reset" }),
    };
    navigator.getGamepads = () => [null, window.pad];
  });

/** A browser that lets pages read the sensors only after a touch. */
const askForSensors = (page) =>
  page.addInitScript(() => {
    window.asked = 0;
    window.DeviceOrientationEvent.requestPermission = async () => {
      window.asked += 1;
      return navigator.userActivation.isActive ? "granted" : "denied";
    };
  });

/** Waits until the sound of the page is in a state. */
const sounds = (page, state) => page.waitForFunction((state) => document.documentElement.dataset.sound === state, state);

/** A browser without sound. */
const takeSound = (page) => page.addInitScript(() => delete window.AudioWorkletNode);

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

test("a gamepad cooks and shakes: hob, steak, flip, toss and pause", { timeout: STUCK_MS }, async () => {
  const { page, seen, close } = await visit(there.browser, there.host.address, { prepare: plugIn });
  await sounds(page, "plays");
  await pressPad(page, 12);
  await until(page, "the hob is higher", (now) => now.hob_w > 0);
  await pressPad(page, 14);
  await until(page, "the steak is in", (now) => now.pieces[0].place === "pan");
  await pressPad(page, 0);
  // In the tongs it cannot be tossed yet, and on a slow machine it is there for long.
  await until(page, "the steak is turned and lies in the pan", ({ pieces: [steak] }) => steak.upside_down && steak.place === "pan");
  // A whole steak may fly and land, or slide in the pan that is thrown: either is felt, at the pace of a hand to which the toss slows
  // the cook.
  await page.evaluate(() => (window.effects.length = 0));
  await pressPad(page, 2);
  await page.waitForFunction(() => window.effects.some(({ strongMagnitude, weakMagnitude }) => Math.max(strongMagnitude, weakMagnitude) > 0.1));
  await pressPad(page, 9);
  await until(page, "time stands still", (now) => now.paused);
  await page.waitForFunction(() => window.effects.at(-1).kind === "reset");
  const kinds = await page.evaluate(() => [...new Set(window.effects.map(({ kind }) => kind))].sort());
  assert.deepEqual(kinds, ["dual-rumble", "reset"]);
  const { samples, silent_seconds, loudest, wide, took_ms } = await renderInPage(page, 60);
  console.log(`60 s of sound took ${(took_ms / 1000).toFixed(1)} s`);
  assert.deepEqual([samples, silent_seconds, wide], [60 * 48000, [], true]);
  assert.ok(loudest > 0.001 && loudest < 1, `${loudest}`);
  assert.deepEqual(trouble(seen), []);
  await close();
});

test("two fingers bring the eye nearer, and the phone is the pan", { timeout: STUCK_MS }, async () => {
  const options = { viewport: { width: 390, height: 844 }, hasTouch: true };
  const prepare = (page) => Promise.all([askForSensors(page), takeSound(page)]);
  const { page, close } = await visit(there.browser, there.host.address, { ...options, prepare });
  await sounds(page, "fails");
  const touch = await page.context().newCDPSession(page);
  const fingers = (type, apart) => {
    const touchPoints = apart === null ? [] : [-apart, apart].map((x, id) => ({ x: 150 + x, y: 250, id }));
    return touch.send("Input.dispatchTouchEvent", { type, touchPoints });
  };
  const { png: _, ...before } = await pixels(page);
  await fingers("touchStart", 20);
  for (let apart = 24; apart <= 80; apart += 8) {
    await fingers("touchMove", apart);
    await draws(page, 1);
  }
  await fingers("touchEnd", null);
  await draws(page, 5);
  const { png: __, ...after } = await pixels(page);
  assert.ok(difference(before, after).changed > 0.1, "the pan is seen from nearer");
  // As on iOS: the page asks by a button of its own.
  await clickLabel(page, "Phone tilt");
  const button = page.getByRole("button", { name: "how the phone is held" });
  await button.tap();
  /** Holds the phone until the pan is there; a hand is never quite still. */
  const hold = async (beta, tilt_deg) => {
    for (let times = 0, near = 0; near < 10; times++) {
      const held = { alpha: 0, beta: beta + 0.1 * (times % 2), gamma: 0 };
      await touch.send("DeviceOrientation.setDeviceOrientationOverride", held);
      const now = await stats(page);
      near = Math.abs(now.pan_tilt_deg - tilt_deg) < 2 ? near + 1 : 0;
      assert.ok(times < 400, `${now.pan_tilt_deg}° for ${beta}°`);
      await page.waitForTimeout(50);
    }
  };
  // The pan stands as the phone is first held, and tilts with it.
  await hold(40, 0);
  await hold(25, 15);
  assert.equal(await page.evaluate(() => window.asked), 1);
  await clickLabel(page, "Phone tilt");
  await until(page, "the pan is laid down", (now) => now.pan_tilt_deg < 1);
  await close();
});
