// Promises: forecasts come from the page's worker and follow the cook; a plan is asked for, found and cooked; a log gives my kitchen, which
// is remembered after a reload.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { before, test } from "node:test";

import { LATE_MS, STUCK_MS, reaches, trouble } from "./browser.mjs";
import { atSpeed, kitchen, press, stats, until, visit } from "./cooking.mjs";
import { clickLabel } from "./labels.mjs";

const there = kitchen();
const PICTURES = resolve(process.env.SAUTE_PICTURES ?? "pictures");

before(() => mkdirSync(PICTURES, { recursive: true }));

/** Texts and names of all controls of the panels. */
const read = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll("#controls > *")].map((found) => found.getAttribute("aria-label") ?? found.textContent),
  );

/** Waits until some control says what is looked for; returns what it says. */
async function says(page, what) {
  const end = Date.now() + LATE_MS;
  for (;;) {
    const found = (await read(page)).find((text) => what.test(text));
    if (found !== undefined) return found;
    assert.ok(Date.now() < end, `${what} in ${await read(page)}`);
    await page.waitForTimeout(100);
  }
}

/** Sets a slider of a name, as a screen reader does. */
async function slide(page, name, value) {
  await says(page, new RegExp(`^${name}$`));
  const slider = page.locator("#controls").getByLabel(name, { exact: true }).last();
  await slider.evaluate((element, value) => {
    element.value = value;
    element.dispatchEvent(new Event("change"));
  }, String(value));
}

/** The numbers of a text. */
const numbers = (text) => (text.match(/-?\d+(\.\d+)?/g) ?? []).map(Number);

/** Highest core, if the food is taken out now, by the line of the forecast [°C]. */
async function highest(page) {
  const line = /out now:\s(-?\d+)\s°C/;
  return Number((await says(page, line)).match(line)[1]);
}

/** Opens an entry of the menu of what there is to learn, and waits for a button of its card. */
async function learn(page, entry, button) {
  await clickLabel(page, "Learn");
  await clickLabel(page, entry);
  await says(page, button);
}

test("a forecast appears by the worker, and follows the cook", { timeout: STUCK_MS }, async () => {
  const { page, seen, close } = await visit(there.browser, there.host.address);
  await press(page, "e");
  await atSpeed(page, 20);
  await until(page, "the pan heats", (now) => now.time_s > 60);
  await press(page, "a");
  await until(page, "the steak is in", (now) => now.pieces[0].place === "pan");
  const first = await highest(page);
  assert.ok(page.workers().length > 0, "forecasts are made off the frame");
  const begun = await stats(page);
  assert.ok(first >= begun.pieces[0].core_c - 1, `${first} °C, core ${begun.pieces[0].core_c} °C`);
  await page.screenshot({ path: join(PICTURES, "forecast.png") });
  // The longer it lies in the pan, the more is expected of it.
  for (let last = first; last < first + 1; last = await highest(page)) {
    const { time_s, pieces } = await stats(page);
    assert.ok(time_s < begun.time_s + 300, `the forecast stays at ${last} °C, core ${pieces[0].core_c} °C`);
    await page.waitForTimeout(200);
  }
  assert.deepEqual(trouble(seen), []);
  await close();
});

test("a plan is asked for, found and cooked, while the page answers", { timeout: STUCK_MS }, async () => {
  const { page, seen, close } = await visit(there.browser, there.host.address);
  await learn(page, "Plan my steak", /^Find a plan$/);
  // A first visit plans a plain one, which has flips of its own.
  await says(page, /^Best plan$/);
  await page.locator("#controls").getByRole("radio", { name: "Best plan" }).evaluate((element) => element.click());
  for (const [name, value] of [["thickness", 10], ["length", 30], ["width", 30], ["Flips at most", 1]]) await slide(page, name, value);
  await page.waitForTimeout(300);
  await clickLabel(page, "Find a plan");
  await says(page, /^Search: \d+ %/);
  const before = await stats(page);
  await says(page, /^Search: [1-9]\d* %/);
  assert.ok((await stats(page)).frames > before.frames, "the page draws meanwhile");
  const cores = await page.evaluate(() => navigator.hardwareConcurrency);
  assert.ok(page.workers().length >= Math.min(cores, 2), "two workers share the search where there are two cores");
  await says(page, /^Cook it live$/, 240_000);
  const said = await read(page);
  const promised = numbers(said.find((text) => /at its highest/.test(text)))[0];
  assert.ok(promised > 40 && promised < 90, `${promised} °C`);
  assert.ok(said.some((text) => /30 × 30 × 10 mm/.test(text)) && said.includes("into the pan"), said.join("\n"));
  await page.screenshot({ path: join(PICTURES, "plan.png") });
  await clickLabel(page, "Cook it live");
  const doIt = await says(page, /^Do it: hob to \d+ W$/);
  await clickLabel(page, doIt);
  const watt = numbers(doIt)[0];
  await until(page, "the hob is on", (now) => now.hob_w === watt);
  await says(page, /Step 1 of \d+/);
  await page.screenshot({ path: join(PICTURES, "plan-live.png") });
  assert.deepEqual(trouble(seen), []);
  await close();
});

/** Drops a text onto the page as a file. */
async function drop(page, name, text) {
  await page.evaluate(
    ([name, text]) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([text], name, { type: "text/csv" }));
      const canvas = document.getElementById("canvas");
      for (const kind of ["dragover", "drop"]) {
        canvas.dispatchEvent(new DragEvent(kind, { dataTransfer, bubbles: true, cancelable: true }));
      }
    },
    [name, text],
  );
}

/** Heats an empty pan at twenty times real time; returns the rows that a thermometer in a weaker kitchen would have written. */
async function heated(page) {
  await press(page, "e");
  await atSpeed(page, 20);
  const rows = [];
  for (let now; !(now?.time_s > 80); await page.waitForTimeout(50)) {
    now = await stats(page);
    rows.push(`${now.time_s.toFixed(1)},${(20 + 0.85 * (now.pan_c - 20)).toFixed(2)}`);
  }
  await press(page, " ");
  return `time_s,pan_c\n${[...new Set(rows)].join("\n")}\n`;
}

test("a log of a thermometer gives my kitchen, and it is there after a reload", { timeout: STUCK_MS }, async () => {
  const { page, seen, close } = await visit(there.browser, there.host.address);
  const log = await heated(page);
  await learn(page, "My kitchen", /^Find my kitchen$/);
  await drop(page, "pan.csv", log);
  await says(page, /pan\.csv: \d+ rows/);
  await clickLabel(page, "Find my kitchen");
  await says(page, /^Use this kitchen$/, 240_000);
  await page.screenshot({ path: join(PICTURES, "my-kitchen.png") });
  await clickLabel(page, "Use this kitchen");
  const kept = await says(page, /of the power reaches the pan/);
  assert.ok(numbers(kept)[0] < 84, `weaker than the typical kitchen: ${kept}`);
  // Settings are stored from time to time.
  await page.waitForTimeout(1500);
  await page.reload();
  await reaches(page, "cooking");
  await clickLabel(page, "Start anew");
  await learn(page, "My kitchen", /^Find my kitchen$/);
  assert.equal(await says(page, /of the power reaches the pan/), kept);
  assert.deepEqual(trouble(seen), []);
  await close();
});
