// Promises of the guides beside the page: all reachable, no dead link, a policy, readable on a phone.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { after, before, test } from "node:test";

import { launch, trouble, watch } from "./browser.mjs";
import { serve } from "./site_server.mjs";

const SITE = resolve(process.env.SAUTE_PAGE);
const PICTURES = resolve(process.env.SAUTE_PICTURES ?? "pictures");
const LINK = /(?:href|src)="([^"]+)"/g;
const ID = /\sid="([^"]+)"/g;

let host;

before(async () => {
  mkdirSync(PICTURES, { recursive: true });
  host = await serve(SITE);
});

after(() => host?.end());

/** Fetches a page and all that it leads to on this host; returns each page's text by its address. */
async function crawl(start) {
  const pages = new Map();
  const open = [start];
  while (open.length) {
    const address = open.pop();
    if (pages.has(address)) continue;
    const response = await fetch(address);
    assert.equal(response.status, 200, address);
    const isPage = response.headers.get("Content-Type").startsWith("text/html");
    const text = isPage ? await response.text() : (await response.arrayBuffer(), "");
    pages.set(address, text);
    for (const [, link] of text.matchAll(LINK)) {
      const to = new URL(link.replaceAll("&amp;", "&"), address);
      to.hash = "";
      if (to.href.startsWith(host.address)) open.push(to.href);
    }
  }
  return pages;
}

test("the page leads to every guide, and no link of them is dead", async () => {
  const pages = await crawl(host.address);
  for (const name of ["docs/your-own-food.html", "docs/formats/recipe.html", "docs/hosting.html", "README.html"]) {
    assert.ok(pages.has(host.address + name), name);
  }
  for (const [address, text] of pages) {
    for (const [, link] of text.matchAll(LINK)) {
      const to = new URL(link, address);
      const name = decodeURIComponent(to.hash.slice(1));
      to.hash = "";
      if (!name || !pages.has(to.href)) continue;
      const ids = [...pages.get(to.href).matchAll(ID)].map(([, id]) => id);
      assert.ok(ids.includes(name), `${address}: ${link}`);
    }
  }
});

test("every guide has a policy that allows no script and nothing from elsewhere", async () => {
  const pages = await crawl(`${host.address}docs/index.html`);
  const guides = [...pages].filter(([address, text]) => text && !/\/(index\.html)?$/.test(new URL(address).pathname));
  assert.ok(guides.length > 20, `${guides.length} guides`);
  for (const [address, text] of guides) {
    assert.match(text, /Content-Security-Policy" content="default-src 'none'; style-src 'self'; img-src 'self';/, address);
  }
});

test("guides are readable at both sizes, light and dark, without a word in the console", async () => {
  const browser = await launch();
  const looks = [
    ["docs/your-own-food.html", { viewport: { width: 1280, height: 720 } }],
    ["docs/formats/recipe.html", { viewport: { width: 390, height: 844 }, colorScheme: "dark" }],
    ["VALIDATION.html", { viewport: { width: 390, height: 844 } }],
    ["README.html", { viewport: { width: 1280, height: 720 }, colorScheme: "dark" }],
    ["docs/formats/index.html", { viewport: { width: 1280, height: 720 } }],
  ];
  for (const [name, options] of looks) {
    const { page, seen, close } = await watch(browser, host.address + name, options);
    const [shown, wide] = await page.evaluate(() => [innerWidth, document.documentElement.scrollWidth]);
    assert.ok(wide <= shown, `${name} is ${wide} wide`);
    assert.deepEqual([...trouble(seen), ...seen.missing, ...seen.violations], [], name);
    await page.screenshot({ path: join(PICTURES, `guide-${name.replaceAll("/", "-")}.png`) });
    await close();
  }
  await browser.close();
});
