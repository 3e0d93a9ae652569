// How the phone is held, for a window whose pan it is.

/** Returns true where the browser can state it, and the device is one that is held. */
export const canTilt = () =>
  "DeviceOrientationEvent" in window && window.isSecureContext && matchMedia("(pointer: coarse)").matches;

/** Sensors that the browser needs a permission for, as on iOS. */
const asked = () =>
  [window.DeviceOrientationEvent, window.DeviceMotionEvent].filter((sensor) => typeof sensor?.requestPermission === "function");

/** The phone's sensors, read while they are needed. */
export class Tilt {
  /** `button` requests the permission: some browsers give it only to a touch of the page's own. `silence` is how long they may send nothing [ms]. */
  constructor(button, silence = 3000) {
    Object.assign(this, { button, silence, reading: undefined, accelerations: null, timer: 0 });
    this.onTurn = (event) => this.turn(event);
    this.onMotion = (event) => this.move(event);
    button.addEventListener("click", () => this.ask());
  }

  /** Begins to read, or ends. */
  hold(on) {
    this.end();
    if (!on) return;
    if (asked().length) this.button.hidden = false;
    else this.begin();
  }

  async ask() {
    this.button.hidden = true;
    const answers = await Promise.all(asked().map((sensor) => sensor.requestPermission())).catch(() => ["denied"]);
    if (answers.every((answer) => answer === "granted")) this.begin();
    else this.refuse();
  }

  begin() {
    window.addEventListener("deviceorientation", this.onTurn);
    window.addEventListener("devicemotion", this.onMotion);
    this.timer = setTimeout(() => this.refuse(), this.silence);
  }

  end() {
    this.button.hidden = true;
    clearTimeout(this.timer);
    window.removeEventListener("deviceorientation", this.onTurn);
    window.removeEventListener("devicemotion", this.onMotion);
    this.reading = undefined;
  }

  refuse() {
    this.end();
    this.reading = new Float64Array(0);
  }

  turn({ alpha, beta, gamma }) {
    if (beta === null || gamma === null) return;
    clearTimeout(this.timer);
    const screen = window.screen.orientation?.angle ?? 0;
    this.reading = Float64Array.of(alpha ?? 0, beta, gamma, screen, ...(this.accelerations ?? Array(6).fill(NaN)));
  }

  move({ acceleration, accelerationIncludingGravity }) {
    const list = (felt) => ["x", "y", "z"].map((axis) => felt?.[axis] ?? NaN);
    this.accelerations = [...list(acceleration), ...list(accelerationIncludingGravity)];
  }

  /** What is new since the last call; empty if it was refused. */
  read() {
    const reading = this.reading;
    this.reading = undefined;
    return reading;
  }
}
