// Promises to those who do not see the canvas, have no mouse, or asked for less motion: the panels are there as HTML controls, axe
// finds no violation in them, a description tells the cook, and a whole cook, undo and turned time need nothing else; the window moves less. How:
// crates/window/tests/window/settings.rs.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";

import { STUCK_MS, reaches, trouble, watch } from "./browser.mjs";
import { begins, draws, kitchen, press, stats, until, visit } from "./cooking.mjs";
import { clickLabel } from "./labels.mjs";

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

const there = kitchen();

/** Rules that axe finds broken in the whole page, in words. */
async function violations(page) {
  await page.evaluate(AXE);
  const { violations } = await page.evaluate(() => window.axe.run(document));
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 120)).join(" | ")}`);
}

/** Sets a slider as a screen reader does. */
async function setSlider(page, name, value) {
  const slider = page.locator("#controls").getByRole("slider", { name });
  await slider.waitFor({ state: "attached" });
  await slider.evaluate((element, to) => {
    element.value = String(to);
    element.dispatchEvent(new Event("change"));
  }, value);
}

/** Goes by Tab until the picture no longer has the keys; false if it keeps them. */
async function leavesByTab(page) {
  const inPicture = () => page.evaluate(() => document.activeElement.matches("#canvas, input[autocapitalize]"));
  await page.locator("#canvas").focus();
  for (let presses = 0; presses < 150 && (await inPicture()); presses++) await press(page, "Tab");
  const left = !(await inPicture());
  // And comes back.
  await page.locator("#canvas").focus();
  return left;
}

/** Goes by Tab to the first picture of the first sight, and chooses it. */
async function choosesByKeys(page) {
  const isThere = () => document.activeElement.dataset.start === "steak";
  for (let presses = 0; presses < 10 && !(await page.evaluate(isThere)); presses++) await page.keyboard.press("Tab");
  assert.ok(await page.evaluate(isThere), "the keyboard reaches the pictures");
  await page.keyboard.press("Enter");
}

/** What was announced, the first first. */
const announced = (page) => page.evaluate(() => [...document.querySelectorAll("#said > p")].map((line) => line.textContent.replaceAll("\u00a0", " ")));

const CASES = [["en", "dark", "reduce", "Movement: Reduced", "Settings"], ["ja", "light", "no-preference", "動き: なめらか", "設定"]];

for (const [lang, colorScheme, reducedMotion, motion, settings] of CASES) {
  test(`axe finds no violation, and motion is as the browser says (${lang}, ${colorScheme})`, { timeout: STUCK_MS }, async () => {
    const { page, close } = await watch(there.browser, `${there.host.address}?lang=${lang}`, { colorScheme, reducedMotion });
    await reaches(page, "offering");
    assert.deepEqual(await violations(page), []);
    await choosesByKeys(page);
    await begins(page);
    await page.waitForFunction(() => document.querySelectorAll("#controls button").length > 20);
    assert.deepEqual(await violations(page), []);
    assert.ok(await leavesByTab(page), "the keyboard can leave the picture");
    // With panels and a card open.
    await press(page, "n");
    await draws(page, 3);
    assert.deepEqual(await violations(page), []);
    await page.keyboard.press("F2");
    const chosen = page.locator("#controls").getByRole("radio", { name: motion });
    await chosen.waitFor({ state: "attached" });
    assert.equal(await chosen.getAttribute("aria-checked"), "true");
    // Under the card nothing can be used.
    const card = page.locator("#controls").getByRole("heading", { name: settings });
    await card.waitFor({ state: "attached" });
    const off = () => document.querySelector("#controls > input[type=range]").disabled;
    await page.waitForFunction(off);
    assert.ok(await chosen.isEnabled());
    await close();
  });
}

test("a cook by the HTML controls alone, told in words", { timeout: STUCK_MS }, async () => {
  const { page, seen, close } = await visit(there.browser, there.host.address);
  await setSlider(page, "Hob", 1400);
  await until(page, "the hob is on", (now) => Math.abs(now.hob_w - 1400) < 100);
  await page.waitForFunction(() => document.querySelector("#controls > [aria-label='Hob power']").ariaValueText === "1400 W");
  await clickLabel(page, "5×");
  await until(page, "time runs faster", (now) => now.speed === 5);
  await clickLabel(page, "In the pan");
  await until(page, "the steak is in", (now) => now.pieces[0].place === "pan");
  await page.waitForFunction(() => /steak: in the pan, core \d+ °C/.test(document.getElementById("told").textContent.replaceAll("\u00a0", " ")));
  // A control keeps its focus while the panels change, and is pressed by the keyboard.
  const flip = page.locator("#controls").getByRole("button", { name: "Flip", exact: true });
  // What is off cannot have the focus; it is on once the panels have seen the steak in the pan.
  await page.waitForFunction((element) => !element.disabled, await flip.elementHandle());
  await flip.focus();
  await draws(page, 10);
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Flip");
  await page.keyboard.press("Enter");
  const turned = await until(page, "the steak is turned", (now) => now.pieces[0].upside_down);
  // One press is enough, though the hand is still turning it.
  const { commands } = await stats(page);
  await clickLabel(page, "Take out");
  await until(page, "the press is taken", (now) => now.commands > commands);
  await until(page, "the steak is out", (now) => now.pieces[0].place === "board");
  // Time is turned back: to before the last act, and to an instant.
  await clickLabel(page, "Undo");
  const undone = await until(page, "undone", (now) => now.pieces[0].place === "pan" && !now.travels);
  assert.ok(undone.pieces[0].upside_down && undone.time_s >= turned.time_s, JSON.stringify(undone));
  await setSlider(page, "Time of the cook", 2);
  const early = await until(page, "the beginning", (now) => now.time_s < 4 && !now.travels);
  assert.ok(!early.pieces[0].upside_down && early.pan_c < turned.pan_c, JSON.stringify(early));
  // What was heard of it: each thing once, in its order, and the description only when it was asked for.
  const heard = await announced(page);
  const told = [/^Turn the hob on\. /, /^steak: in the pan\.$/, /^steak: turned over\.$/, /^steak: on the board\.$/, /^Undone: /];
  const places = told.map((line) => heard.findIndex((text) => line.test(text)));
  assert.deepEqual(places, places.toSorted((a, b) => a - b), JSON.stringify(heard));
  // After it time was turned back, where the first order comes again.
  const cook = heard.slice(0, places.at(-1) + 1);
  assert.ok(places[0] >= 0 && new Set(cook).size === cook.length, JSON.stringify(heard));
  assert.ok(!heard.some((text) => /Time \d/.test(text)), JSON.stringify(heard));
  await page.getByRole("button", { name: "Describe the cook" }).evaluate((button) => button.click());
  assert.match((await announced(page)).at(-1), /^Pan \d+ °C[^]*steak: [^]*Time \d/);
  assert.equal(await page.locator("#told").getAttribute("aria-live"), null);
  assert.deepEqual(trouble(seen), []);
  await close();
});
