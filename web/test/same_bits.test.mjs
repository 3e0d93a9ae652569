// Promise: a cook that was recorded natively is opened by the page and replays to the same bits: the hashes of its states are those
// that the native program computed. crates/window/tests/page/cook.rs records it.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { test } from "node:test";

import { STUCK_MS, trouble } from "./browser.mjs";
import { kitchen, press, until, visit } from "./cooking.mjs";
import { clickFile } from "./labels.mjs";

const COOK = join(resolve(process.env.SAUTE_STILLS), "cook.saute");

const there = kitchen();

test("a native cook replays in the page to the same bits, and is saved as the same file", { timeout: STUCK_MS }, async () => {
  const { page, seen, close } = await visit(there.browser, there.host.address);
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), clickFile(page, "Open a recipe file…")]);
  await chooser.setFiles(COOK);
  await until(page, "the cook is opened", (now) => now.end_s > 10);
  await until(page, "it is played", (now) => !now.travels);
  const hashes = await page.evaluate(() => window.saute.hashes());
  const native = readFileSync(COOK.replace(".saute", ".hashes"), "utf8");
  assert.ok(native.split("\n").length > 5, native);
  assert.equal(hashes, native);
  // Saved again it is the same cook, byte by byte.
  const [download] = await Promise.all([page.waitForEvent("download"), clickFile(page, "Save this cook…")]);
  assert.equal(download.suggestedFilename(), "my-cook.saute");
  assert.deepEqual(readFileSync(await download.path()), readFileSync(COOK));
  const [table] = await Promise.all([page.waitForEvent("download"), clickFile(page, "Save the readings…")]);
  const rows = readFileSync(await table.path(), "utf8").split("\n");
  assert.match(rows[0], /^time_s,hob_drawn_w,pan_c,/);
  assert.ok(rows.length > 50, `${rows.length} rows`);
  const [recipe] = await Promise.all([page.waitForEvent("download"), clickFile(page, "Save as a recipe…")]);
  assert.equal(recipe.suggestedFilename(), "my-recipe.toml");
  assert.match(readFileSync(await recipe.path(), "utf8"), /^\[\[step\]\]\nat_s = [\d.]+\nhob_w = /m);
  const [picture] = await Promise.all([page.waitForEvent("download"), press(page, "s")]);
  assert.equal(readFileSync(await picture.path()).toString("latin1", 1, 4), "PNG");
  assert.deepEqual(trouble(seen), []);
  await close();
});

test("a recipe that is dropped on the page is played, and a file that is none is refused", { timeout: STUCK_MS }, async () => {
  const { page, close } = await visit(there.browser, there.host.address);
  const drop = (name, text) =>
    page.evaluate(
      ([name, text]) => {
        const data = new DataTransfer();
        data.items.add(new File([text], name));
        const event = (type) => new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true });
        for (const type of ["dragover", "drop"]) document.getElementById("canvas").dispatchEvent(event(type));
      },
      [name, text],
    );
  await drop("own.toml", 'title = "My own"\n[[step]]\nhob_w = 900\n[[step]]\nafter_s = 60\nend = true\n');
  await until(page, "it plays", (now) => now.recipe === "My own" && now.hob_w === 900);
  // Many pieces are built over several frames; the cook before is there meanwhile.
  await drop("many.toml", 'title = "Many"\n[[food]]\nid = "x"\nkind = "shrimp"\ncount = 20\n[[step]]\nat_s = 60\nend = true\n');
  await until(page, "it plays", (now) => now.recipe === "Many" && now.pieces.length === 20);
  await drop("broken.toml", "[[step]]\nhob_w = yes\n");
  await until(page, "it is refused", (now) => now.said[0]?.includes("broken.toml:2"));
  await drop("future.saute", "saute session 9\nrest");
  await until(page, "it is refused", (now) => now.said[0]?.includes("format 9"));
  await close();
});
