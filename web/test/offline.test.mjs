// Promises: after the first visit the page works without a network, and a new version takes its place as a whole.

import assert from "node:assert/strict";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, before, test } from "node:test";

import { LATE_MS, STUCK_MS, launch, reaches, trouble } from "./browser.mjs";
import { begins, until, visit } from "./cooking.mjs";
import { serve } from "./site_server.mjs";

let browser, site;

before(async () => {
  browser = await launch();
  site = mkdtempSync(join(tmpdir(), "saute-offline-"));
  cpSync(resolve(process.env.SAUTE_PAGE), site, { recursive: true });
});

after(async () => {
  await browser?.close();
  rmSync(site, { recursive: true });
});

const isKept = (page) =>
  page.waitForFunction(() => navigator.serviceWorker.controller !== null);
const versionOf = (page) => page.evaluate(() => new URL(document.querySelector("script").src).search.slice(3));

/** Waits until a new version lies ready beside the one that is used. */
async function isFetched(page) {
  const isReady = () => navigator.serviceWorker.getRegistration().then((registration) => registration.waiting !== null);
  for (const end = Date.now() + LATE_MS; !(await page.evaluate(isReady)); ) {
    assert.ok(Date.now() < end, "no new version was fetched");
    await page.waitForTimeout(200);
  }
}

/** Starts the page until the version that was fetched has taken over: the next start, or a later one where the machine is so busy that
 * the new version answers only once the old one cooks. */
async function takesOver(page, version) {
  for (const end = Date.now() + LATE_MS; ; ) {
    await page.reload();
    await reaches(page, "cooking");
    if ((await versionOf(page)) === version) return;
    assert.ok(Date.now() < end, "the new version never took over");
  }
}

/** Makes the site another version of itself, as a new build does. */
function newVersion(from, to) {
  for (const name of ["index.html", "service_worker.js"]) {
    const file = join(site, name);
    writeFileSync(file, readFileSync(file, "utf8").replaceAll(from, to));
    // Compressed forms are of the old version.
    for (const ending of [".br", ".gz"]) rmSync(file + ending, { force: true });
  }
}

for (const plain of [false, true]) {
  const how = plain ? "a host that compresses nothing" : "a host that compresses";
  test(`without a network the page cooks (${how})`, { timeout: STUCK_MS }, async () => {
    const host = await serve(site, { plain });
    const { page, seen, close } = await visit(browser, host.address);
    await isKept(page);
    host.end();
    await page.reload();
    await begins(page);
    await page.goto(`${host.address}?recipe=medium`);
    await reaches(page, "cooking");
    await until(page, "a recipe plays", (now) => now.recipe !== null);
    const problems = trouble(seen).filter((line) => !line.includes("ERR_CONNECTION_REFUSED"));
    assert.deepEqual(problems, []);
    await close();
  });
}

test("a new version takes its place as a whole at the next start", { timeout: STUCK_MS }, async () => {
  const host = await serve(site);
  const { page, close } = await visit(browser, host.address);
  await isKept(page);
  const before = await versionOf(page);
  newVersion(before, "00000002");
  // This start still has the old version, and fetches the new one.
  await page.reload();
  await reaches(page, "cooking");
  await isFetched(page);
  assert.equal(await versionOf(page), before);
  await takesOver(page, "00000002");
  await begins(page);
  const loaded = await page.evaluate(() => performance.getEntriesByType("resource").map((entry) => entry.name));
  assert.deepEqual(loaded.filter((url) => url.includes(before)), []);
  assert.deepEqual(await page.evaluate(() => caches.keys()), ["saute-00000002"]);
  host.end();
  await page.reload();
  await begins(page);
  await close();
});
