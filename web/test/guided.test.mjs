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

/** A trial in which the steak is laid in and taken out at once. */
async function trial(page) {
  await clickLabel(page, "Begin");
  await until(page, "the trial runs", (now) => now.time_s > 0 && now.pieces[0].place === "waiting");
  await page.locator("#canvas").focus();
  await press(page, "a");
  await until(page, "the steak is in", (now) => now.pieces[0].place === "pan");
  await clickLabel(page, "Take out");
  await until(page, "the steak is out", (now) => now.pieces[0].place === "board");
  await clickLabel(page, "Finish");
}

/** Enters values into the fields of a card, in their order. */
async function enters(page, values) {
  const fields = page.locator("#controls input[type=text]");
  for (const [place, value] of values.entries()) {
    await fields.nth(place).evaluate((field, value) => {
      field.value = value;
      field.dispatchEvent(new Event("change"));
    }, value);
  }
}

/** Chooses a step of each question that has them. */
async function chooses(page, name, count) {
  const steps = page.locator("#controls").getByRole("radio", { name, exact: true });
  for (let place = 0; place < count; place++) await steps.nth(place).evaluate((step) => step.click());
}

test("a study is gone through on two days, in one tab only", { timeout: 2 * STUCK_MS }, async () => {
  const address = `${there.host.address}?study=2013&participant=P08&machine=tried`;
  const { page, seen, close } = await opened(address);
  await clickLabel(page, "I agree and begin");
  await shows(page, "Trial 1 of 4");
  await trial(page);
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
  await other.close();
  for (const next of ["Trial 3 of 4", "Trial 4 of 4", "At the stove"]) {
    await trial(page);
    await shows(page, next);
  }
  await enters(page, ["61.5", "45", "250", "210", "420"]);
  await clickLabel(page, "medium");
  await clickLabel(page, "Done");
  await shows(page, "Trial 1 of 2");
  await trial(page);
  await shows(page, "Trial 2 of 2");
  await trial(page);
  await shows(page, "A few questions");
  await chooses(page, "6 (1 is not at all, 7 is very much)", 2);
  await enters(page, ["12"]);
  await clickLabel(page, "sometimes");
  await clickLabel(page, "Done");
  await shows(page, "Thank you");
  const lines = await page.evaluate(() => localStorage.getItem("saute-study-2013-P08").trim().split("\n"));
  const kind = lines[0].split(",").indexOf("kind");
  const counted = {};
  for (const line of lines.slice(1)) counted[line.split(",")[kind]] = (counted[line.split(",")[kind]] ?? 0) + 1;
  assert.deepEqual(counted, { consent: 1, trial: 6, entry: 6, answer: 4 });
  assert.deepEqual(trouble(seen), []);
  await close();
});
