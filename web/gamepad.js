// The gamepad that is plugged in: the first one whose buttons the browser knows.

/** Buttons in the order of the module: south, east, west, north, cross up, down, left, right, shoulders, start, select. */
const BUTTONS = [0, 1, 2, 3, 12, 13, 14, 15, 4, 5, 9, 8];

/** Both sticks to the right and up, both triggers, then 1 for each button that is down; undefined where there is no gamepad. */
export function readPad() {
  const pad = navigator.getGamepads?.().find((pad) => pad?.connected && pad.mapping === "standard");
  if (!pad) return undefined;
  const [left, up, right, high] = pad.axes;
  const value = (button) => pad.buttons[button]?.value ?? 0;
  const down = BUTTONS.map((button) => Number(pad.buttons[button]?.pressed ?? false));
  return Float64Array.of(left, -up, right, -high, value(6), value(7), ...down);
}
