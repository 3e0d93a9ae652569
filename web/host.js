// What the page does for the window, by the names that the module calls.

const version = new URL(import.meta.url).search;
const part = (name) => import(new URL(`./${name}.js${version}`, import.meta.url).href);
const parts = ["gamepad", "tilt", "sound", "words"].map(part);
const [{ readPad, shakePad }, { canTilt, Tilt }, { Sound }, { words }] = await Promise.all(parts);

/** Sentences that stay in the log (chosen: those of some minutes, for whoever reads back). */
const MOST_LINES = 50;

/** The page's side of the module. */
export class Host {
  constructor(keptCook, controls, jobs, reportTo = "") {
    Object.assign(this, { keptCook, keptStudy: null, controls, jobs, reportTo: origin(reportTo) });
    this.phone = new Tilt(document.getElementById("tilt"));
    this.sound = new Sound();
  }

  /** Numbers of the first gamepad; undefined where there is none. */
  readPad() {
    return readPad();
  }

  /** Lets the strong and the weak motor of the first gamepad turn so fast, 0 to 1. */
  shakePad(strong, weak) {
    shakePad(strong, weak);
  }

  /** Returns true if the page can read how the phone is held. */
  canTilt() {
    return canTilt();
  }

  /** Reads from now on how the phone is held, after permission; or no longer. */
  tilt(on) {
    this.phone.hold(on);
  }

  /** How the phone is held, if that is new; empty if it was refused. */
  readTilt() {
    return this.phone.read();
  }

  /** Tells what there is to hear, as numbers. The module's memory may move: they are copied. */
  tellSound(letter) {
    this.sound.tell(letter.slice());
  }

  /** Why nothing is heard, once. */
  soundTrouble() {
    return this.sound.trouble();
  }

  /** Gives the worker for a kind of work, or the two that share it, an order. The module's memory may move: the bytes are copied. */
  askWorker(kind, isShared, order) {
    this.jobs.ask(kind, isShared, order.slice());
  }

  /** What the worker for a kind of work answered; undefined if it is of no use. */
  workerAnswers(kind) {
    return this.jobs.take(kind);
  }

  /** Shows the controls of the panels, from JSON. */
  showControls(text) {
    this.controls.show(JSON.parse(text));
  }

  /** Describes the state of the cook on request. */
  describe(cook) {
    document.getElementById("told").textContent = cook;
  }

  /** Lets a sentence be heard once: what is added to a log is read aloud, what was there before is not. */
  announce(sentence) {
    const log = document.getElementById("said");
    const line = document.createElement("p");
    line.textContent = sentence;
    log.append(line);
    while (log.childElementCount > MOST_LINES) log.firstChild.remove();
  }

  /** Copies what a report of a problem needs. */
  copyReport(said) {
    this.copyText(this.report(said));
  }

  /** Keeps a part of the cook; returns why an earlier part could not be kept. */
  keepCook(begins, bytes) {
    return this.keptCook?.keep(begins, bytes.slice());
  }

  /** The rows of a study that were kept before, as CSV; undefined where none can be kept. */
  keptRows() {
    return this.keptStudy?.text;
  }

  /** Keeps the rows of a study instead of those before; returns why it could not. */
  keepRows(text) {
    return this.keptStudy?.keep(text);
  }

  /** Hands the result of a lesson to the page around this one, if the address named its origin. */
  reportResult(row) {
    if (this.reportTo && window.parent !== window) {
      window.parent.postMessage({ type: "saute-result", row: JSON.parse(row) }, this.reportTo);
    }
  }

  /** Copies a text; without access to the clipboard by a field that is selected, and if that fails by hand. */
  copyText(text) {
    const copied = navigator.clipboard?.writeText(text) ?? Promise.reject(new Error("no clipboard"));
    copied.catch(() => copiedByField(text) || showToCopy(text));
  }
}

/** An origin such as https://school.example, as it was given; empty for anything else, `*` above all. */
function origin(text) {
  try {
    return new URL(text).origin === text && text !== "null" ? text : "";
  } catch {
    return "";
  }
}

function copiedByField(text) {
  const field = document.createElement("textarea");
  field.value = text;
  field.className = "unseen";
  document.body.append(field);
  field.select();
  const copied = document.execCommand("copy");
  field.remove();
  return copied;
}

/** Shows a text over the page, selected, until the dialog is closed. */
function showToCopy(text) {
  const { by_hand, done: close } = words(document.documentElement.lang);
  const dialog = document.createElement("dialog");
  const field = document.createElement("textarea");
  const done = document.createElement("button");
  Object.assign(field, { value: text, readOnly: true, ariaLabel: by_hand });
  done.textContent = close;
  done.addEventListener("click", () => dialog.close());
  dialog.addEventListener("close", () => dialog.remove());
  dialog.append(by_hand, field, done);
  document.body.append(dialog);
  dialog.showModal();
  field.select();
}
