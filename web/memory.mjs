// Measures how the page's memory grows over a cook of ten minutes, after its first minute. Ends with an error if it grows by 20 MB or
// more. `SAUTE_PAGE` is the site's folder, `SAUTE_SITE` the program that serves it. It takes a few minutes.

import { resolve } from "node:path";

import { launch } from "./test/browser.mjs";
import { press, stats, until, visit } from "./test/cooking.mjs";
import { serve } from "./test/site_server.mjs";

/** Most growth after the first minute [bytes]. */
const MOST = 20e6;
/** From when on, and until when, it is measured [simulated s]. */
const [FROM_S, UNTIL_S] = [60, 660];

const [browser, host] = await Promise.all([launch(), serve(resolve(process.env.SAUTE_PAGE))]);
const { page } = await visit(browser, `${host.address}?recipe=medium`);

/** Memory of the module and of the scripts [bytes]. */
async function memory() {
  const network = await page.context().newCDPSession(page);
  await network.send("HeapProfiler.collectGarbage");
  const { usedSize } = await network.send("Runtime.getHeapUsage");
  return { module: (await stats(page)).memory_bytes, scripts: usedSize };
}

await press(page, "]");
await press(page, "]");
await until(page, "a minute", (now) => now.time_s > FROM_S, 600_000);
const first = await memory();
await until(page, "ten minutes", (now) => now.time_s > UNTIL_S, 1_800_000);
const last = await memory();
const grown = last.module - first.module + last.scripts - first.scripts;
const megabytes = (bytes) => `${(bytes / 1e6).toFixed(1)} MB`;
console.log(`module ${megabytes(first.module)} to ${megabytes(last.module)}, scripts ${megabytes(first.scripts)} to ${megabytes(last.scripts)}`);
console.log(`grown by ${megabytes(grown)} after the first minute; less than ${megabytes(MOST)} is allowed`);
await browser.close();
host.end();
process.exitCode = grown < MOST ? 0 : 1;
