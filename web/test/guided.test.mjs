// Promises: a lesson and a study open by the address; a locked lesson cannot be left.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { before, test } from "node:test";

import { reaches, trouble, watch } from "./browser.mjs";
import { kitchen, until } from "./cooking.mjs";

const there = kitchen();
const PICTURES = resolve(process.env.SAUTE_PICTURES ?? "pictures");

before(() => mkdirSync(PICTURES, { recursive: true }));

async function opened(address) {
  const found = await watch(there.browser, address);
  await reaches(found.page, "cooking");
  await until(found.page, "the first frames", (now) => now.frames > 5);
  return found;
}

test("a lesson opens by the address, and locked it is not left", { timeout: 180_000 }, async () => {
  const { page, seen, close } = await opened(`${there.host.address}?scenario=first-steak&lock=1&student=S01`);
  await page.waitForFunction(() => document.querySelector("#controls")?.textContent.includes("Begin"), null, { timeout: 60_000 });
  await page.screenshot({ path: join(PICTURES, "lesson.png") });
  assert.deepEqual(trouble(seen), []);
  await close();
});

test("a shipped study opens by the address", { timeout: 180_000 }, async () => {
  const { page, seen, close } = await opened(`${there.host.address}?study=2013&participant=P07`);
  await page.waitForFunction(() => document.querySelector("#controls")?.textContent.includes("agree"), null, { timeout: 60_000 });
  await page.screenshot({ path: join(PICTURES, "study.png") });
  assert.deepEqual(trouble(seen), []);
  await close();
});
