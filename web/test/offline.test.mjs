// Promises: after the first visit the page works without a network, and a new version takes its place as a whole at the next start.

import assert from "node:assert/strict";
import { appendFileSync, cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
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

/** Waits until a version is kept as a whole and answers. */
async function answers(page, version) {
  const isAnswering = async (cache) => {
    // In this order: a version that is seen in the cache has begun to install.
    if (!(await caches.has(cache))) return false;
    const { installing, waiting, active } = await navigator.serviceWorker.getRegistration();
    return !installing && !waiting && active.state === "activated";
  };
  for (const end = Date.now() + LATE_MS; !(await page.evaluate(isAnswering, `saute-${version}`)); ) {
    assert.ok(Date.now() < end, "no new version was fetched");
    await page.waitForTimeout(200);
  }
}

/** Waits until these versions alone are kept. */
async function areKept(page, ...versions) {
  const wanted = versions.map((version) => `saute-${version}`);
  for (const end = Date.now() + LATE_MS; ; await page.waitForTimeout(200)) {
    const found = await page.evaluate(() => caches.keys());
    if (found.toSorted().join() === wanted.toSorted().join()) return;
    assert.ok(Date.now() < end, `kept are ${found}, not ${wanted}`);
  }
}

/** Makes the site another version of itself, as a new build does. */
function newVersion(from, to) {
  appendFileSync(join(site, "style.css"), "/* of the new version */");
  for (const name of ["index.html", "service_worker.js", "style.css"]) {
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
  const style = (page) => page.evaluate(() => fetch(document.querySelector("link[rel=stylesheet]").href).then((file) => file.text()));
  const styled = await style(page);
  newVersion(before, "00000002");
  // This start still has the old version, and fetches the new one.
  await page.reload();
  await reaches(page, "cooking");
  await answers(page, "00000002");
  // It goes on with its own files, though the host has others.
  assert.equal(await versionOf(page), before);
  assert.equal(await style(page), styled);
  await areKept(page, before, "00000002");
  await page.reload();
  await begins(page);
  assert.equal(await versionOf(page), "00000002");
  assert.notEqual(await style(page), styled);
  const loaded = await page.evaluate(() => performance.getEntriesByType("resource").map((entry) => entry.name));
  assert.deepEqual(loaded.filter((url) => url.includes(before)), []);
  await areKept(page, "00000002");
  host.end();
  await page.reload();
  await begins(page);
  await close();
});
