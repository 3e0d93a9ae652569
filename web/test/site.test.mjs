// Promises of the page as a site: what it fetches, what it says, which hosts it works on.

import assert from "node:assert/strict";
import { mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, before, test } from "node:test";

import { launch, reaches, trouble, watch } from "./browser.mjs";
import { serve } from "./site_server.mjs";

const SITE = resolve(process.env.SAUTE_PAGE);
const PICTURES = resolve(process.env.SAUTE_PICTURES ?? "pictures");
/** Bytes over the wire up to the first interaction: for people 4 MB, for the page that is made for tests a limit of its own. */
const BUDGET = Number(process.env.SAUTE_PAGE_BYTES);

let browser, host, plain;

before(async () => {
  mkdirSync(PICTURES, { recursive: true });
  [browser, host, plain] = await Promise.all([launch(), serve(SITE), serve(SITE, { plain: true })]);
});

after(async () => {
  host?.end();
  plain?.end();
  await browser?.close();
});

/** Opens the page, waits until it cooks, and closes it after a look. */
async function cooks(address, look = async () => {}, options = {}) {
  const visit = await watch(browser, address, options);
  try {
    await reaches(visit.page, "cooking");
    await visit.page.waitForFunction(() => JSON.parse(window.saute.stats()).frames > 2);
    await look(visit);
  } finally {
    await visit.close();
  }
}

const isFont = (url) => url.includes("/fonts/");

test("a first visit cooks: no third party, no missing file, no word in the console, within its size", async () => {
  await cooks(host.address, async ({ page, seen }) => {
    assert.deepEqual(seen.requests.filter((url) => !url.startsWith(host.address) && !url.startsWith("blob:")), []);
    assert.deepEqual(seen.missing, []);
    assert.deepEqual(trouble(seen), []);
    assert.deepEqual(seen.violations, []);
    assert.ok(!seen.requests.some(isFont), "the Japanese font is for those who choose Japanese");
    assert.ok(!seen.requests.some((url) => url.includes("sound_player")), "nothing sounds before the first touch");
    assert.ok(seen.sent > 100_000 && seen.sent <= BUDGET, `${seen.sent} bytes were sent`);
    await printParts(page);
    await page.screenshot({ path: join(PICTURES, "cooking.png") });
  });
});

/** Prints how long the parts of the first visit took. A clock judges nothing. */
async function printParts(page) {
  const at = await page.evaluate(() => Object.fromEntries(performance.getEntriesByType("mark").map(({ name, startTime }) => [name, startTime])));
  const [fetched, compiled, chosen, started] = ["fetched", "compiled", "chosen", "started"].map((name) => at[`saute ${name}`]);
  const seconds = (from, to) => `${((to - from) / 1000).toFixed(1)} s`;
  console.log(`first visit: fetched in ${seconds(0, fetched)}, compiled ${seconds(fetched, compiled)} later, first frame ${seconds(chosen, started)} after the choice`);
}

test("the policy stands in the page and is obeyed", async () => {
  await cooks(host.address, async ({ page, seen }) => {
    const policy = await page.locator("meta[http-equiv=Content-Security-Policy]").getAttribute("content");
    assert.match(policy, /default-src 'self'; script-src 'self' 'wasm-unsafe-eval';/);
    assert.doesNotMatch(policy, /unsafe-inline|'unsafe-eval'|\*/);
    await page.evaluate(() => {
      setTimeout("window.broken = true");
      const style = document.createElement("style");
      style.textContent = "body { color: red }";
      document.body.append(style);
      return fetch("http://127.0.0.1:9/").catch(() => {});
    });
    await page.waitForTimeout(500);
    const directives = seen.violations.map((text) => text.split(" ")[0]).sort();
    assert.deepEqual(directives, ["connect-src", "script-src", "style-src-elem"]);
    assert.equal(await page.evaluate(() => window.broken), undefined);
  });
});

test("any base path serves", async () => {
  const root = mkdtempSync(join(tmpdir(), "saute-site-"));
  mkdirSync(join(root, "some"));
  symlinkSync(SITE, join(root, "some", "where"));
  const deep = await serve(root);
  try {
    await cooks(`${deep.address}some/where/`, async ({ seen }) => {
      assert.deepEqual(seen.missing, []);
      assert.deepEqual(seen.requests.filter((url) => !url.startsWith(`${deep.address}some/where/`)), []);
    });
  } finally {
    deep.end();
    rmSync(root, { recursive: true });
  }
});

test("where the host compresses nothing, the page fetches .gz and inflates it", async () => {
  await cooks(plain.address, async ({ seen }) => {
    assert.ok(seen.requests.some((url) => url.includes("saute_web_bg.wasm.gz")), `${seen.requests}`);
    assert.deepEqual(trouble(seen), []);
    // The plain module is given up after its header; the window of a connection may have come by then.
    assert.ok(seen.sent <= 1.5 * BUDGET, `${seen.sent} bytes were sent`);
  });
});

test("where the host has no .gz either and sends another type, the plain module does", async () => {
  const prepare = async (page) => {
    await page.route("**/*.gz*", (route) => route.fulfill({ status: 404, body: "" }));
    await page.route("**/*.wasm*", async (route) => {
      const response = await route.fetch();
      await route.fulfill({ response, headers: { ...response.headers(), "content-type": "application/octet-stream" } });
    });
  };
  await cooks(plain.address, async () => {}, { prepare });
});

test("Japanese loads its font, once", async () => {
  await cooks(`${host.address}?lang=ja`, async ({ page, seen }) => {
    await page.waitForFunction(() => performance.getEntriesByType("resource").some((e) => e.name.includes("/fonts/")));
    await page.waitForTimeout(1000);
    assert.equal(seen.requests.filter(isFont).length, 1);
    assert.deepEqual(trouble(seen), []);
    await page.screenshot({ path: join(PICTURES, "japanese.png") });
  });
});

test("without WebGPU an address that asks for it gets WebGL 2", async () => {
  await cooks(`${host.address}?backend=webgpu`, async ({ page }) => {
    assert.equal(await page.evaluate(() => window.saute.backend()), "webgl2");
  });
});

test("a frame of another site cooks, and keeps nothing; a closed one says what it needs", async () => {
  const root = mkdtempSync(join(tmpdir(), "saute-frame-"));
  const frame = `<iframe src="${host.address}?embed&recipe=medium" width="800" height="600" title="A pan"></iframe>`;
  const closed = `<iframe id="closed" sandbox="allow-scripts" src="${host.address}?embed&lang=ja" title="A closed frame"></iframe>`;
  const host_page = `<input id="answer" autofocus><p>${frame}<p>${closed}<p style="height: 3000px">`;
  writeFileSync(join(root, "index.html"), `<!doctype html><title>Another site</title><link rel="icon" href="data:,">${host_page}`);
  const other = await serve(root);
  const { page, seen, close } = await watch(browser, other.address);
  try {
    const inside = await (await page.waitForSelector("iframe")).contentFrame();
    const cooks = () => window.saute && JSON.parse(window.saute.stats() || "{}").time_s > 6;
    await inside.waitForFunction(cooks);
    const seen_inside = () => inside.evaluate(() => JSON.parse(window.saute.stats()));
    const { recipe, hob_w } = await seen_inside();
    assert.match(recipe, /medium/i);
    // Keys and wheel are the host's until somebody comes in.
    await page.keyboard.type("eee");
    assert.equal(await page.locator("#answer").inputValue(), "eee");
    assert.equal((await seen_inside()).hob_w, hob_w);
    await page.mouse.move(300, 300);
    await page.mouse.wheel(0, 400);
    await page.waitForFunction(() => window.scrollY > 100);
    await page.evaluate(() => window.scrollTo(0, 0));
    await page.mouse.click(300, 300);
    assert.equal(await page.evaluate(() => document.activeElement.localName), "iframe");
    const kept = () =>
      Promise.all([indexedDB.databases(), caches.keys(), navigator.serviceWorker.getRegistrations(), Object.keys(localStorage)]);
    assert.deepEqual(await inside.evaluate(kept), [[], [], [], []]);
    // A frame without an origin of its own may load no module: it says what it needs, and that alone is in the console.
    const shut = await (await page.$("#closed")).contentFrame();
    assert.match(await shut.locator("#cover").innerText(), /sandbox[^]*allow-same-origin[^]*このページだけを開く/);
    assert.equal(await shut.locator("a.alone:visible").getAttribute("href"), `${host.address}?lang=ja`);
    assert.deepEqual(trouble(seen).filter((line) => !/from origin 'null'|net::ERR_FAILED/.test(line)), []);
  } finally {
    await close();
    other.end();
    rmSync(root, { recursive: true });
  }
});

test("a phone gets the whole screen, light or dark", async () => {
  for (const [colorScheme, scale] of [["light", 1], ["dark", 2]]) {
    const options = { viewport: { width: 390, height: 844 }, hasTouch: true, colorScheme, deviceScaleFactor: scale };
    const look = async ({ page }) => {
      const box = await page.locator("canvas").boundingBox();
      assert.deepEqual([box.x, box.y, box.width, box.height], [0, 0, 390, 844]);
      const drawn = await page.evaluate(() => [document.getElementById("canvas").width, document.getElementById("canvas").height]);
      assert.deepEqual(drawn, [390 * scale, 844 * scale]);
      await page.screenshot({ path: join(PICTURES, `phone-${colorScheme}.png`) });
    };
    await cooks(host.address, look, options);
  }
});

test("a browser with neither WebGPU nor WebGL 2 is told so, and loads no module", async () => {
  const blind = await launch(["--disable-3d-apis", "--disable-gpu"]);
  try {
    for (const [locale, words] of [["en-GB", /neither WebGPU nor WebGL 2/], ["ja-JP", /WebGL 2 も使えない/]]) {
      const { page, seen, close } = await watch(blind, host.address, { locale });
      await reaches(page, "failed");
      assert.match(await page.locator("#status").innerText(), words);
      assert.ok(!seen.requests.some((url) => url.includes(".wasm")));
      assert.deepEqual(seen.missing, []);
      await page.screenshot({ path: join(PICTURES, `no-graphics-${locale}.png`) });
      await close();
    }
  } finally {
    await blind.close();
  }
});

/** Loads the page again with some of its files held back; returns what the cover says when the page has given up. */
async function heldBack(page, files, hold = (route) => route.abort()) {
  await page.unrouteAll();
  await page.route(files, hold);
  await page.reload();
  await reaches(page, "failed");
  return page.locator("#cover").innerText();
}

test("the cover shows how far the download is, and says what to do where a part does not come", async () => {
  // Noted in the page: a busy machine looks too late.
  const noteStatus = () => {
    window.statuses = [];
    const note = (records) => records.forEach((record) => record.addedNodes.forEach((node) => window.statuses.push(node.textContent)));
    const watchIt = () => new MutationObserver(note).observe(document.getElementById("status"), { childList: true });
    document.addEventListener("DOMContentLoaded", watchIt);
  };
  // The storage answers when the test lets it.
  const holdStorage = () => {
    const query = LockManager.prototype.query;
    const held = new Promise((resolve) => (window.letStorageAnswer = resolve));
    LockManager.prototype.query = async function () {
      await held;
      return query.call(this);
    };
  };
  const prepare = (page) => Promise.all([page.addInitScript(noteStatus), page.addInitScript(holdStorage)]);
  const { page, close } = await watch(browser, host.address, { prepare });
  await page.waitForFunction(() => document.getElementById("progress").value === 1);
  const shares = (await page.evaluate(() => window.statuses)).map((text) => text.match(/^(\d+\.\d) of (\d+\.\d) MB$/)).filter(Boolean);
  const done = shares.map(([, done]) => Number(done));
  assert.ok(done.length > 3 && done[0] < Number(shares[0][2]), `${shares}`);
  assert.deepEqual(done, done.toSorted((a, b) => a - b));
  // The module, with the reason; a module of the page; the page's own script.
  const said = await heldBack(page, "**/*.wasm*", (route) => route.fulfill({ status: 503, body: "" }));
  assert.match(said, /could not be loaded[^]*filter[^]*503[^]*Try again/);
  // The storage answers after the failure: nothing is offered that could not be opened.
  await page.evaluate(() => new Promise((resolve) => setTimeout(resolve, 500, window.letStorageAnswer())));
  assert.equal(await page.evaluate(() => document.documentElement.dataset.state), "failed");
  assert.ok(await page.locator("#starts").isHidden());
  await page.screenshot({ path: join(PICTURES, "not-loaded.png") });
  for (const file of ["words", "loader"]) {
    const said = await heldBack(page, `**/${file}.js*`);
    assert.match(said, /A part of this page has not come\.[^]*Try again/);
    assert.doesNotMatch(said, /Loading|一部/);
  }
  // No script at all: after a while the style says so, in both languages.
  await page.unrouteAll();
  await page.route("**/*.js*", (route) => route.abort());
  await page.reload();
  await page.evaluate(() => document.getAnimations().forEach((animation) => animation.finish()));
  assert.match(await page.locator("#trouble").innerText(), /has not come[^]*Try again[^]*届いていません[^]*もう一度/);
  await page.screenshot({ path: join(PICTURES, "no-script.png") });
  // A module that never comes: time is turned on by hand.
  await page.unrouteAll();
  await page.route("**/*.wasm*", () => {});
  await page.clock.install();
  await page.reload();
  await page.evaluate(() => window.letStorageAnswer());
  await page.waitForFunction(() => document.documentElement.dataset.state === "offering");
  assert.ok(await page.locator("#again").isHidden());
  await page.clock.fastForward(30_000);
  await page.locator("#again").waitFor();
  assert.match(await page.locator("#status").innerText(), /Nothing has come for a while\.[^]*filter/);
  await close();
});

test("without JavaScript the page says so in both languages, and waits for nothing", async () => {
  const { page, seen, close } = await watch(browser, host.address, { javaScriptEnabled: false });
  const said = await page.locator("#cover").innerText();
  assert.match(said, /JavaScript is switched off\.[^]*JavaScript が無効/);
  assert.doesNotMatch(said, /Loading|has not come/);
  assert.ok(await page.locator("#progress").isHidden());
  assert.ok(!seen.requests.some((url) => url.includes(".wasm")));
  await page.screenshot({ path: join(PICTURES, "no-javascript.png") });
  await close();
});
