// Chromium with a page that is watched: requests, failures, console, violations of the content policy.

import { appendFileSync } from "node:fs";
import { join } from "node:path";

import { chromium } from "playwright-core";

const QUIET = ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking"];
const BARE = [...QUIET, "--disable-component-update", "--disable-sync"];
/** Graphics by software, so that tests run on any machine. */
export const WEBGL2 = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

export const WEBGPU = [
  ...["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader", "--enable-features=Vulkan"],
  // Without Vulkan for the compositor too, Chromium loses the device of any page that draws to a canvas.
  ...["--use-vulkan=swiftshader", ...WEBGL2],
];

/** Starts Chromium; `args` says what it draws with. */
export function launch(args = WEBGL2) {
  const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
  return chromium.launch({ executablePath, args: [...BARE, ...args] });
}

/** How long a test waits for what a page does, and for the whole of a test [ms] (chosen: no test may depend on how busy the machine is, so
 * these only end what is stuck). */
export const LATE_MS = 300_000;
export const STUCK_MS = 1_200_000;

/** Pixels of the canvas for each of the page's, along an edge. Software draws a quarter of the pixels four times as fast and the layout is the
 * same, so tests ask for few of them; those that look at the picture for more, and in the campaign for all. */
const COARSE = { deviceScaleFactor: 0.25 };
export const SHARP = { deviceScaleFactor: process.env.SAUTE_CAMPAIGN ? 1 : 0.5 };

/** Wait before each picture [ms] (chosen: twenty a second). A page that waits leaves the cores to others, and software draws no more than that
 * of many pages anyway. */
const BETWEEN_PICTURES_MS = 33;

/** Lets a page draw fewer pictures. */
function drawLess(between_ms) {
  const draw = window.requestAnimationFrame.bind(window);
  const cancel = window.cancelAnimationFrame.bind(window);
  const drawn = new Map();
  window.requestAnimationFrame = (then) => {
    const drawNow = (at) => {
      drawn.delete(asked);
      then(at);
    };
    const asked = setTimeout(() => drawn.set(asked, draw(drawNow)), between_ms);
    return asked;
  };
  window.cancelAnimationFrame = (asked) => {
    clearTimeout(asked);
    if (drawn.has(asked)) cancel(drawn.get(asked));
  };
}

/** Opens an address in a fresh profile and notes what happens there. */
export async function watch(browser, address, { prepare = async () => {}, everyPicture = Boolean(process.env.SAUTE_CAMPAIGN), ...options } = {}) {
  const usual = { viewport: { width: 1280, height: 720 }, locale: "en-GB", ...COARSE };
  const context = await browser.newContext({ ...usual, ...options });
  // `scripts/durations.toml` has a ceiling for them.
  if (process.env.SAUTE_TALLY) appendFileSync(join(process.env.SAUTE_TALLY, "pages_opened.count"), "1\n");
  context.setDefaultTimeout(LATE_MS);
  const page = await context.newPage();
  const seen = { requests: [], missing: [], said: [], violations: [], sent: 0 };
  page.on("request", (request) => seen.requests.push(request.url()));
  page.on("response", (response) => response.status() >= 400 && seen.missing.push(response.url()));
  page.on("console", (message) => seen.said.push(`${message.type()}: ${message.text()}`));
  page.on("pageerror", (error) => seen.said.push(`error: ${error.message}`));
  await page.exposeFunction("noteViolation", (text) => seen.violations.push(text));
  await page.addInitScript(() => {
    const note = (event) => window.noteViolation(`${event.effectiveDirective} ${event.blockedURI}`);
    document.addEventListener("securitypolicyviolation", note);
  });
  if (!everyPicture) await page.addInitScript(drawLess, BETWEEN_PICTURES_MS);
  const network = await context.newCDPSession(page);
  await network.send("Network.enable");
  network.on("Network.dataReceived", ({ encodedDataLength }) => (seen.sent += encodedDataLength));
  await prepare(page);
  await page.goto(address);
  return { page, seen, close: () => context.close() };
}

/** Waits until the page is in a state: `offering`, `cooking` or `failed`. Where it asks what to cook, the first is taken: the last cook where
 * there is one, else the steak. */
export async function reaches(page, state) {
  const settled = (states) => states.includes(document.documentElement.dataset.state);
  await page.waitForFunction(settled, ["offering", "cooking", "failed"]);
  if (state !== "offering" && (await page.evaluate(settled, ["offering"]))) {
    // The program may fail to come in the meantime.
    await page.evaluate(() => document.querySelector("#starts button")?.click());
    await page.waitForFunction(settled, ["cooking", "failed"]);
  }
  const [found, cover] = await page.evaluate(() => [
    document.documentElement.dataset.state,
    document.getElementById("cover").innerText,
  ]);
  if (found !== state) throw new Error(`the page is ${found}, not ${state}: ${cover}`);
}

/** Warnings about a machine without a graphics card, what its drawing by software says about its own speed, and what the browser says about the
 * speed at which the library of the panels reads letters that its font lacks. */
const OF_THE_MACHINE = [
  ...[/No available adapters/, /Software rasterizer detected/, /GL Driver Message \(OpenGL, Performance,/],
  /Multiple readback operations using getImageData are faster/,
];

/** Problems of the console. */
export function trouble(seen) {
  const problems = seen.said.filter((line) => line.startsWith("error") || line.startsWith("warning"));
  return problems.filter((line) => !OF_THE_MACHINE.some((known) => known.test(line)));
}
