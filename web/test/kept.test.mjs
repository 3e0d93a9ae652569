// Promises: a cook survives a reload; two tabs do not destroy each other's; a storage that fails is told once and breaks nothing.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { before, test } from "node:test";

import { STUCK_MS, reaches, trouble } from "./browser.mjs";
import { begins, cookUntil, kitchen, press, stats, until, visit } from "./cooking.mjs";

const PICTURES = resolve(process.env.SAUTE_PICTURES ?? "pictures");
/** What a reload may lose [simulated s]: a second of wall time at five times real time. */
const LOST_S = 5;

const there = kitchen();

before(() => mkdirSync(PICTURES, { recursive: true }));

/** Reloads and waits for the offer; returns how far the offered cook came [s]. */
async function offered(page) {
  await page.reload();
  await reaches(page, "cooking");
  return (await until(page, "the offer", (now) => now.frames > 2 && now.offered_s !== null)).offered_s;
}

/** Presses the first button of the card: "Go on with it". */
async function goOn(page) {
  await page.locator("#canvas").focus();
  await press(page, "Tab");
  await page.keyboard.press("Enter");
  return until(page, "the cook is back", (now) => now.offered_s === null && !now.travels);
}

test("a cook survives a reload, and a second one", { timeout: STUCK_MS }, async () => {
  const { page, seen, close } = await visit(there.browser, there.host.address);
  let last = await cookUntil(page, 8);
  await press(page, "a");
  last = await until(page, "the steak is in", (now) => now.pieces[0].place === "pan" && now.time_s > last.time_s + 3);
  const came = await offered(page);
  assert.ok(came <= last.time_s + 2 * LOST_S && came >= last.time_s - LOST_S, `${came} s of ${last.time_s} s`);
  await page.screenshot({ path: join(PICTURES, "kept-offer.png") });
  const back = await goOn(page);
  assert.ok(Math.abs(back.time_s - came) < 0.2 && back.pieces[0].place === "pan", JSON.stringify(back));
  assert.equal(back.hob_w, last.hob_w);
  // It goes on, and is kept again.
  await press(page, " ");
  const further = await until(page, "it goes on", (now) => now.time_s > came + 3);
  await page.waitForTimeout(1000);
  assert.ok((await offered(page)) >= further.time_s - LOST_S);
  assert.deepEqual(trouble(seen), []);
  await close();
});

test("two tabs keep a cook each", { timeout: STUCK_MS }, async () => {
  const one = await visit(there.browser, there.host.address);
  const first = await cookUntil(one.page, 6);
  const context = one.page.context();
  const other = await context.newPage();
  await other.goto(there.host.address);
  await begins(other);
  assert.equal((await stats(other)).offered_s, null, "a cook that goes on in another tab is not offered");
  const second = await cookUntil(other, 30);
  await other.waitForTimeout(1000);
  await other.close();
  await one.page.bringToFront();
  await one.page.reload();
  await reaches(one.page, "cooking");
  // The other tab is closed, and its cook was written last.
  const left = await until(one.page, "the offer", (now) => now.frames > 2 && now.offered_s !== null);
  assert.ok(left.offered_s >= second.time_s - LOST_S, `${left.offered_s} s, not ${second.time_s} s`);
  const kept = await one.page.evaluate(async () => {
    const opened = indexedDB.open("saute");
    await new Promise((done) => (opened.onsuccess = done));
    const count = opened.result.transaction("cooks").objectStore("cooks").count();
    await new Promise((done) => (count.onsuccess = done));
    return count.result;
  });
  assert.equal(kept, 2, "both cooks are there");
  assert.ok(first.time_s < second.time_s);
  await one.close();
});

test("a storage that fails is told once, and the cook goes on", { timeout: STUCK_MS }, async () => {
  const breakAll = () => {
    IDBFactory.prototype.open = () => {
      throw new DOMException("no access", "SecurityError");
    };
  };
  const breakWrites = () => {
    IDBObjectStore.prototype.put = () => {
      throw new DOMException("the disk is full", "QuotaExceededError");
    };
  };
  for (const [script, why] of [[breakAll, "SecurityError"], [breakWrites, "QuotaExceededError"]]) {
    const { page, seen, close } = await visit(there.browser, there.host.address, { prepare: (page) => page.addInitScript(script) });
    const now = await cookUntil(page, 10);
    assert.equal(now.said.filter((text) => text.includes(why)).length, 1, `${now.said}`);
    await until(page, "time goes on", (later) => later.time_s > now.time_s + 5);
    assert.deepEqual(trouble(seen), []);
    await close();
  }
});
