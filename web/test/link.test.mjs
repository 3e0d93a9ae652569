// Promises: a link holds a cook and opens it elsewhere; one that is damaged or newer is refused with a reason.

import assert from "node:assert/strict";
import { test } from "node:test";

import { STUCK_MS, reaches, trouble, watch } from "./browser.mjs";
import { cookUntil, kitchen, press, stats, until, visit } from "./cooking.mjs";
import { clickFile } from "./labels.mjs";

const there = kitchen();

const LINK = "Copy a link to this cook";

test("a link opens the cook that was copied, and a broken one says why not", { timeout: STUCK_MS }, async () => {
  const permissions = ["clipboard-read", "clipboard-write"];
  const { page, seen, close } = await visit(there.browser, there.host.address, { permissions });
  await cookUntil(page, 6);
  await press(page, "a");
  await until(page, "the steak is in", (now) => now.pieces[0].place === "pan");
  await press(page, " ");
  const shared = await until(page, "time stands still", (now) => now.paused);
  await clickFile(page, LINK);
  const said = await until(page, "it is said", (now) => now.said[0]?.includes("is copied"));
  const link = await page.evaluate(() => navigator.clipboard.readText());
  assert.ok(said.said[0].includes(`${link.length} characters`), said.said[0]);
  assert.ok(link.startsWith(`${there.host.address}#cook=1.`) && link.length < 1500, link);
  // In another profile, as on another machine.
  const elsewhere = await watch(there.browser, link);
  await reaches(elsewhere.page, "cooking");
  const opened = await until(elsewhere.page, "it is played", (now) => now.frames > 2 && !now.travels && now.end_s > 1);
  assert.equal(opened.time_s, shared.time_s);
  assert.equal(opened.pan_c, shared.pan_c, "the same bits");
  assert.deepEqual(opened.pieces, shared.pieces);
  // A link that is put into the address of an open page.
  const cases = [[link.slice(0, -3), /damaged/], [link.replace("#cook=1.", "#cook=7."), /newer version/]];
  for (const [broken, words] of cases) {
    await elsewhere.page.evaluate((to) => (location.hash = new URL(to).hash), broken);
    await until(elsewhere.page, `${words}`, (now) => words.test(now.said[0]));
    assert.equal((await stats(elsewhere.page)).end_s, opened.end_s, "the cook stays");
  }
  assert.deepEqual([...trouble(seen), ...trouble(elsewhere.seen)], []);
  await elsewhere.close();
  await close();
});
