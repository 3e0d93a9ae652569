// Controls of the panels by their names, in the HTML beside the canvas.

/** Presses the control of a name as a screen reader does; the panel that shows it is opened by its key. */
export async function clickLabel(page, name, key = null) {
  const control = page.locator("#controls").getByRole("button", { name, exact: true });
  if (key && !(await control.count())) {
    await page.locator("#canvas").focus();
    await page.keyboard.press(key);
  }
  await control.waitFor({ state: "attached" });
  // Where the machine is slow a control is still off for a moment after what had it off is over.
  await page.waitForFunction((element) => !element.disabled, await control.elementHandle());
  await control.evaluate((element) => element.click());
}

/** Presses a row of the card of files, which a chip on top opens; a first cook has it once all controls are there. */
export async function clickFile(page, name) {
  await clickLabel(page, "File", "n");
  await clickLabel(page, name);
  // Else the next press could reach a row of this card, while it closes.
  await page.locator("#controls").getByRole("button", { name, exact: true }).waitFor({ state: "detached" });
}
