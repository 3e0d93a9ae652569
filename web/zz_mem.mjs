import { resolve } from "node:path";
import { launch } from "./test/browser.mjs";
import { press, stats, until, visit } from "./test/cooking.mjs";
import { serve } from "./test/site_server.mjs";
const [browser, host] = await Promise.all([launch(), serve(resolve(process.env.SAUTE_PAGE))]);
const first = await visit(browser, `${host.address}?recipe=medium`);
const page = first.page;
if (process.env.OFF) {
  await page.waitForTimeout(33000);
  await page.evaluate(() => { const s = JSON.parse(localStorage["saute.settings"]); s.forecasts = false; localStorage["saute.settings"] = JSON.stringify(s); });
  await page.addInitScript(() => { const s = JSON.parse(localStorage["saute.settings"]); s.forecasts = false; localStorage["saute.settings"] = JSON.stringify(s); });
  await page.reload(); await page.waitForTimeout(6000);
  console.log(await page.evaluate(() => JSON.parse(localStorage["saute.settings"]).forecasts));
  console.log((await page.locator("#controls").innerText()).slice(0,600)); await page.locator("#canvas").focus(); await press(page, "Escape"); await page.waitForTimeout(1000); await press(page, "Escape"); await press(page, "]"); await page.waitForTimeout(1000); console.log(JSON.stringify(await stats(page)).slice(0,300));
}
await press(page, "]"); await press(page, "]");
let last = 0;
for (let t = 0; t < 660; ) {
  const now = await stats(page);
  if (now.memory_bytes !== last) console.log(now.time_s.toFixed(0), (now.memory_bytes/1e6).toFixed(1), now.pieces[0].place, now.speed);
  last = now.memory_bytes; t = now.time_s;
  await page.waitForTimeout(200);
}
await browser.close(); host.end();
