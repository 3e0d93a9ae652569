// The gamepad that is plugged in: the first one with a standard mapping of buttons.

/** Buttons in the order of the module: south, east, west, north, cross up, down, left, right, shoulders, start, select. */
const BUTTONS = [0, 1, 2, 3, 12, 13, 14, 15, 4, 5, 9, 8];
/** Length of an effect, and after how long it is renewed [ms] (chosen: the motors stop soon after a page that hangs). */
const EFFECT_MS = 500;
const RENEW_MS = 250;
/** Strengths nearer than this are one, and weaker ones are none [-] (chosen: less is not felt; each is a message). */
const ONE_STRENGTH = 0.02;

const firstPad = () => navigator.getGamepads?.().find((pad) => pad?.connected && pad.mapping === "standard");

/** Both sticks to the right and up, both triggers, then 1 for each button that is down; undefined where there is no gamepad. */
export function readPad() {
  const pad = firstPad();
  if (!pad) return undefined;
  const [left, up, right, high] = pad.axes;
  const value = (button) => pad.buttons[button]?.value ?? 0;
  const down = BUTTONS.map((button) => Number(pad.buttons[button]?.pressed ?? false));
  return Float64Array.of(left, -up, right, -high, value(6), value(7), ...down);
}

/** The last command to the motors, and when. */
let told = { strong: 0, weak: 0, rests: true, at: 0 };

/** Lets the motors of that gamepad turn so fast, 0 to 1; nothing where the browser does not reach them. */
export function shakePad(strong, weak) {
  const motors = firstPad()?.vibrationActuator;
  if (!motors?.playEffect) return;
  const rests = Math.max(strong, weak) < ONE_STRENGTH;
  const isNear = Math.max(Math.abs(strong - told.strong), Math.abs(weak - told.weak)) < ONE_STRENGTH;
  const now = performance.now();
  if (rests ? told.rests : isNear && now - told.at < RENEW_MS) return;
  told = { strong, weak, rests, at: now };
  const effect = { duration: EFFECT_MS, strongMagnitude: Math.min(strong, 1), weakMagnitude: Math.min(weak, 1) };
  const played = rests ? motors.reset?.() : motors.playEffect("dual-rumble", effect);
  // A gamepad that is pulled out at this moment is missed at the next reading.
  played?.catch?.(() => {});
}
