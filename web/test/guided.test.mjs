// Promises: a lesson and a study open by the address; a locked lesson cannot be left; a study goes on after a reload, in one tab.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { before, test } from "node:test";

import { STUCK_MS, reaches, trouble, watch } from "./browser.mjs";
import { kitchen, press, until } from "./cooking.mjs";
import { clickLabel } from "./labels.mjs";

const there = kitchen();
const PICTURES = resolve(process.env.SAUTE_PICTURES ?? "pictures");

before(() => mkdirSync(PICTURES, { recursive: true }));

async function opened(address) {
  const found = await watch(there.browser, address);
  await reaches(found.page, "cooking");
  await until(found.page, "the first frames", (now) => now.frames > 5);
  return found;
}

/** Waits until a text stands on the panels. */
const shows = (page, text) =>
  page.waitForFunction((text) => document.querySelector("#controls")?.textContent.includes(text), text);

test("a lesson opens by the address, and locked it is not left", { timeout: STUCK_MS }, async () => {
  const { page, seen, close } = await opened(`${there.host.address}?scenario=first-steak&lock=1&student=S01`);
  await page.waitForFunction(() => document.querySelector("#controls")?.textContent.includes("Begin"));
  await page.screenshot({ path: join(PICTURES, "lesson.png") });
  assert.deepEqual(trouble(seen), []);
  await close();
});

test("a shipped study opens by the address", { timeout: STUCK_MS }, async () => {
  const { page, seen, close } = await opened(`${there.host.address}?study=2013&participant=P07&machine=tried`);
  await page.waitForFunction(() => document.querySelector("#controls")?.textContent.includes("agree"));
  await page.screenshot({ path: join(PICTURES, "study.png") });
  assert.deepEqual(trouble(seen), []);
  await close();
});

test("a study goes on after a reload where it was, and in one tab only", { timeout: STUCK_MS }, async () => {
  const address = `${there.host.address}?study=2013&participant=P08&machine=tried`;
  const { page, seen, close } = await opened(address);
  await clickLabel(page, "I agree and begin");
  await shows(page, "Trial 1 of 4");
  await clickLabel(page, "Begin");
  await until(page, "the trial runs", (now) => now.time_s > 0);
  await page.locator("#canvas").focus();
  await press(page, "a");
  await until(page, "the steak is in", (now) => now.pieces[0].place === "pan");
  await clickLabel(page, "Take out");
  await until(page, "the steak is out", (now) => now.pieces[0].place === "board");
  await clickLabel(page, "Finish");
  await shows(page, "Trial 2 of 4");
  await page.reload();
  await reaches(page, "cooking");
  await shows(page, "Trial 2 of 4");
  const rows = await page.evaluate(() => localStorage.getItem("saute-study-2013-P08").trim().split("\n"));
  assert.equal(rows.length, 3, "the names of the columns, the consent and the trial");
  const other = await page.context().newPage();
  await other.goto(address);
  await reaches(other, "failed");
  assert.match(await other.locator("body").innerText(), /another tab goes on with P08/);
  assert.deepEqual(trouble(seen), []);
  await close();
});
