// Promises to those who do not see the canvas, have no mouse, or asked for less motion: the panels are there as HTML controls, axe
// finds no violation in them, a description tells the cook, and a whole cook, undo and turned time need nothing else; the window moves less. How:
// crates/window/tests/window/settings.rs.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";

import { STUCK_MS, trouble } from "./browser.mjs";
import { draws, kitchen, press, stats, until, visit } from "./cooking.mjs";
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

const CASES = [["en", "dark", "reduce", "Movement: Reduced"], ["ja", "light", "no-preference", "動き: なめらか"]];

for (const [lang, colorScheme, reducedMotion, motion] of CASES) {
  test(`axe finds no violation, and motion is as the browser says (${lang}, ${colorScheme})`, { timeout: STUCK_MS }, async () => {
    const { page, close } = await visit(there.browser, `${there.host.address}?lang=${lang}`, { colorScheme, reducedMotion });
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
    await close();
  });
}

test("a cook by the HTML controls alone, told in words", { timeout: STUCK_MS }, async () => {
  const { page, seen, close } = await visit(there.browser, there.host.address);
  await setSlider(page, "Hob", 1400);
  await until(page, "the hob is on", (now) => Math.abs(now.hob_w - 1400) < 100);
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
  assert.deepEqual(trouble(seen), []);
  await close();
});
