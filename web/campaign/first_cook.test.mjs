// Promise: a first visitor who reads only the line that says what to do, and presses its button 2, 5, 10 or 20 seconds after it is lit, at
// the speed that the page chose, meets the goal at the first try. In the campaign: a cook takes some minutes. The same natively, with other
// pans, steaks and goals: crates/window/tests/window/cook/now.rs.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { before, describe, test } from "node:test";

import { reaches, trouble, watch } from "../test/browser.mjs";
import { kitchen, stats, until } from "../test/cooking.mjs";

const PICTURES = resolve(process.env.SAUTE_PICTURES ?? "pictures");
/** How late the hand is [s], and how long a cook may take on a slow machine [wall ms]. */
const HANDS = [2, 5, 10, 20];
const LONGEST = 3_000_000;

const there = kitchen();

before(() => mkdirSync(PICTURES, { recursive: true }));

const controls = (page) => page.locator("#controls");

/** What the line asks for: the name of its button; null while it asks for nothing. */
const lit = (page) =>
  page.evaluate(() => {
    const names = [...document.querySelectorAll("#controls button")].map((button) => button.ariaLabel ?? button.textContent);
    return names.find((name) => /^As advised: |^Take it out: the goal/.test(name) && !/Result$/.test(name)) ?? null;
  });

const told = (page, words) => page.evaluate((words) => document.body.textContent.includes(words), words);

/** A first visit whose hand is so late [s], up to its result. */
async function visitor(late) {
  const { page, seen, close } = await watch(there.browser, there.host.address, { everyPicture: true });
  await reaches(page, "cooking");
  await until(page, "the first frames", (now) => now.frames > 2);
  await page.screenshot({ path: join(PICTURES, `first-visit-${late}-s.png`) });
  const begun = Date.now();
  let [asked, since, presses] = [null, 0, 0];
  while (!(await told(page, "Goal met")) && !(await told(page, "Goal missed"))) {
    assert.ok(Date.now() - begun < LONGEST, JSON.stringify(await stats(page)));
    const name = await lit(page);
    if (name !== asked) [asked, since] = [name, Date.now()];
    if (name && Date.now() - since > 1000 * late) {
      const now = await stats(page);
      console.log(`${late} s late: ${now.time_s.toFixed(0)} s, ${now.speed}×: ${name}`);
      await page.screenshot({ path: join(PICTURES, `first-visit-${late}-s-${presses}.png`) });
      await controls(page).getByRole("button", { name, exact: true }).evaluate((button) => button.click());
      [asked, presses] = [null, presses + 1];
    }
    await page.waitForTimeout(300);
  }
  const end = await stats(page);
  console.log(`${late} s late: core ${end.pieces[0].core_c.toFixed(1)} °C, ${end.time_s.toFixed(0)} s cooked in ${((Date.now() - begun) / 1000).toFixed(0)} s with ${presses} presses`);
  await page.screenshot({ path: join(PICTURES, `first-visit-${late}-s-result.png`) });
  assert.ok(await told(page, "Goal met"), JSON.stringify(end));
  assert.deepEqual(trouble(seen), []);
  await close();
}

describe("by the lit button", { concurrency: 2 }, () => {
  for (const late of HANDS) test(`a hand that is ${late} s late meets the goal`, { timeout: LONGEST }, () => visitor(late));
});
