// Measures the page in Chromium with software graphics: time to interactive with a warm cache, frames per second of the
// default steak, simulated seconds per second, at 5 times and at real time. `SAUTE_PAGE` is the site's folder, `SAUTE_SITE` the
// program that serves it. Run it on a machine that is quiet.

import { resolve } from "node:path";

import { SHARP, WEBGL2, WEBGPU, launch, reaches, watch } from "./test/browser.mjs";
import { serve } from "./test/site_server.mjs";

const COOKS_S = 20;
const host = await serve(resolve(process.env.SAUTE_PAGE));
const stats = (page) => page.evaluate(() => JSON.parse(window.saute.stats()));

/** Seconds from navigation until the page cooks, with everything in the cache. */
async function interactive(page) {
  const start = Date.now();
  await page.reload();
  await reaches(page, "cooking");
  return (Date.now() - start) / 1000;
}

for (const [backend, args] of [["webgl2", WEBGL2], ["webgpu", WEBGPU]]) {
  const browser = await launch(args);
  const { page } = await watch(browser, `${host.address}?backend=${backend}`, { everyPicture: true, ...SHARP });
  await reaches(page, "cooking");
  const ready = await interactive(page);
  await page.mouse.click(640, 560);
  for (const key of ["Escape", "e", "e", "]"]) {
    await page.keyboard.press(key);
    await page.waitForTimeout(300);
  }
  await page.waitForTimeout(8_000);
  await page.keyboard.press("a");
  console.log(`${backend}: interactive after ${ready.toFixed(1)} s`);
  for (const slower of [null, "["]) {
    if (slower) await page.keyboard.press(slower);
    await page.waitForTimeout(COOKS_S * 1000);
    const now = await stats(page);
    console.log(
      `${backend}, ${now.speed} times real time: ${now.frames_per_s.toFixed(1)} frames/s (median), ` +
        `scene ${now.scene_size.join(" x ")}, quality ${JSON.stringify(now.quality)}, reached ${now.time_ratio.toFixed(2)}`,
    );
  }
  await browser.close();
}
await host.end();
