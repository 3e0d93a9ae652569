// Promises: a cook survives a reload; two tabs do not destroy each other's; a storage that fails is told once and breaks nothing.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { before, test } from "node:test";

import { STUCK_MS, reaches, trouble } from "./browser.mjs";
import { begins, cookUntil, kitchen, press, stats, until, visit } from "./cooking.mjs";

const PICTURES = resolve(process.env.SAUTE_PICTURES ?? "pictures");

const there = kitchen();

before(() => mkdirSync(PICTURES, { recursive: true }));

/** Reloads, chooses the last cook, which comes first, and waits for the offer; returns how far the offered cook came [s]. */
async function offered(page) {
  await page.reload();
  await reaches(page, "offering");
  assert.equal(await page.locator("#starts button").first().getAttribute("data-start"), "last");
  await reaches(page, "cooking");
  return (await until(page, "the offer", (now) => now.frames > 2 && now.offered_s !== null)).offered_s;
}

/** Waits until a time is in the storage; returns how far what is stored reaches [s]. */
async function stored(page, least_s) {
  const { kept_s } = await until(page, `${least_s} s are kept`, (now) => now.kept_s >= least_s);
  // A reader of the same store waits for the writers before it.
  await countCooks(page);
  return kept_s;
}

/** Number of cooks in the storage. */
const countCooks = (page) =>
  page.evaluate(async () => {
    const opened = indexedDB.open("saute");
    await new Promise((done) => (opened.onsuccess = done));
    const count = opened.result.transaction(["cooks", "parts"]).objectStore("cooks").count();
    await new Promise((done) => (count.onsuccess = done));
    opened.result.close();
    return count.result;
  });

/** Notes how far the cook is when the page is left. */
const noteLeaving = (page) =>
  page.evaluate(() => window.addEventListener("pagehide", () => sessionStorage.setItem("left_s", JSON.parse(window.saute.stats()).time_s)));

const leftAt = async (page) => Number(await page.evaluate(() => sessionStorage.getItem("left_s")));

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
  await noteLeaving(page);
  const least = await stored(page, last.time_s);
  const came = await offered(page);
  const left = await leftAt(page);
  assert.ok(came >= least && came <= left + 0.01, `${least} s were stored, ${came} s came back, ${left} s were cooked`);
  await page.screenshot({ path: join(PICTURES, "kept-offer.png") });
  const back = await goOn(page);
  assert.ok(Math.abs(back.time_s - came) < 0.2 && back.pieces[0].place === "pan", JSON.stringify(back));
  assert.equal(back.hob_w, last.hob_w);
  // It goes on, and is kept again.
  await press(page, " ");
  const further = await until(page, "it goes on", (now) => now.time_s > came + 3);
  const more = await stored(page, further.time_s);
  assert.ok((await offered(page)) >= more);
  assert.deepEqual(trouble(seen), []);
  await close();
});

test("two tabs keep a cook each", { timeout: STUCK_MS }, async () => {
  const one = await visit(there.browser, there.host.address);
  await cookUntil(one.page, 6);
  // What is written last is offered: from here on that is the other tab.
  await press(one.page, " ");
  const first = await until(one.page, "it stands still, all of it kept", (now) => now.paused && Math.abs(now.kept_s - now.time_s) < 0.01);
  const context = one.page.context();
  const other = await context.newPage();
  await other.goto(there.host.address);
  await begins(other);
  assert.equal((await stats(other)).offered_s, null, "a cook that goes on in another tab is not offered");
  const second = await cookUntil(other, 30);
  const least = await stored(other, second.time_s);
  await other.close();
  await one.page.bringToFront();
  await one.page.reload();
  await reaches(one.page, "cooking");
  // The other tab is closed, and its cook was written last.
  const left = await until(one.page, "the offer", (now) => now.frames > 2 && now.offered_s !== null);
  assert.ok(left.offered_s >= least, `${left.offered_s} s, not ${least} s`);
  const kept = await countCooks(one.page);
  assert.equal(kept, 2, "both cooks are there");
  assert.ok(first.time_s < second.time_s);
  await one.close();
});

test("a storage that fails is told once, and the cook goes on", { timeout: STUCK_MS }, async () => {
  const breakAll = () => {
    Object.defineProperty(window, "localStorage", {
      get() {
        throw new DOMException("no access", "SecurityError");
      },
    });
    IDBFactory.prototype.open = () => {
      throw new DOMException("no access", "SecurityError");
    };
  };
  const breakWrites = () => {
    IDBObjectStore.prototype.put = () => {
      throw new DOMException("the disk is full", "QuotaExceededError");
    };
  };
  const words = [[breakAll, /lets this page store nothing.*\(SecurityError\)/], [breakWrites, /storage of the browser is full.*\(QuotaExceededError\)/]];
  for (const [script, why] of words) {
    const { page, seen, close } = await visit(there.browser, there.host.address, { prepare: (page) => page.addInitScript(script) });
    const now = await cookUntil(page, 10);
    assert.equal(now.said.filter((text) => why.test(text)).length, 1, `${now.said}`);
    await until(page, "time goes on", (later) => later.time_s > now.time_s + 5);
    assert.deepEqual(trouble(seen), []);
    await close();
  }
});
