// What the page shows before the window is there, and when it fails.

const part = (id) => document.getElementById(id);
const megabytes = (bytes) => (bytes / 1e6).toFixed(1);

/** After so long without a byte the page reports that something holds it up [ms] (chosen: a slow line sends some in this time). */
const SILENT_MS = 20_000;
/** How an error begins that is about a value of the address. */
const ASKED = /^(scenario|student|study|participant|recipe|lang|machine|backend): /;
/** What goes together in an address. */
const LESSON = ["scenario", "student", "lock"];
const STUDY = ["study", "participant", "machine"];
const PARTS = { scenario: LESSON, student: LESSON, study: STUDY, participant: STUDY, machine: STUDY };
/** Texts of the page by the ids of their elements. */
const TEXTS = ["about", "guides", "teach", "report", "private", "again", "tilt", "describe", "choose"];

/** The cover over the stage, in the language of its texts. */
export class Cover {
  constructor(words, version) {
    Object.assign(this, { words, version });
    for (const id of TEXTS) part(id).textContent = words[id];
    document.title = words.title;
    document.querySelector("meta[name=description]").content = words.about;
    part("version").textContent = words.version(version);
    part("progress").setAttribute("aria-label", words.loading);
    part("progress").hidden = part("report").hidden = false;
    part("again").onclick = () => location.reload();
    part("report").addEventListener("click", () => this.report(part("detail").textContent));
    this.say(words.loading);
    this.awaitBytes();
  }

  /** Writes what goes on, if that is new: it is read aloud. */
  say(text) {
    if (part("status").textContent !== text) part("status").textContent = text;
  }

  /** Reports after a while without a byte that something holds them up. */
  awaitBytes() {
    clearTimeout(this.waiting);
    this.waiting = setTimeout(() => {
      this.say(this.words.held_up);
      part("again").hidden = false;
    }, SILENT_MS);
  }

  /** Shows how far the download is. */
  downloaded(bytes, all) {
    this.awaitBytes();
    part("again").hidden = true;
    part("progress").value = Math.min(bytes / all, 1);
    this.say(this.words.loaded(megabytes(Math.min(bytes, all)), megabytes(all)));
  }

  /** The program is there. */
  loaded() {
    clearTimeout(this.waiting);
    part("progress").hidden = true;
    this.say("");
  }

  /** It was chosen what to cook, and the kitchen is not there yet. */
  async preparing() {
    this.say(this.words.preparing);
    for (const tile of part("starts").children) tile.disabled = true;
    // To build the kitchen keeps the page busy; this is seen before.
    await new Promise((resolve) => setTimeout(resolve, 50));
  }

  /** Copies what a report of a problem needs: version, browser, and past messages. */
  report(said) {
    const report = `saute ${this.version}\n${navigator.userAgent}\n${location.href}\n${said}`;
    this.say(this.words.report_copied);
    return report;
  }

  /** Lets the stage be seen. */
  lift() {
    part("cover").hidden = true;
    document.documentElement.dataset.state = "cooking";
  }

  /** Whether the page has given up: then nothing is offered any more. */
  get hasFailed() {
    return document.documentElement.dataset.state === "failed";
  }

  /** What the address asks for is not there, and asking again does not help. */
  offerWithout(key) {
    const address = new URL(location.href);
    // A lesson and a study go with the code of who takes them.
    for (const name of PARTS[key] ?? [key]) address.searchParams.delete(name);
    part("again").textContent = this.words.without;
    part("again").onclick = () => location.assign(address);
  }

  /** Shows what went wrong: a text by its key, and the browser's message. */
  fail(key, error) {
    clearTimeout(this.waiting);
    part("cover").hidden = false;
    part("progress").hidden = part("starts").hidden = part("choose").hidden = true;
    const said = String(error?.message ?? error ?? "");
    const asked = key === "not_started" ? ASKED.exec(said)?.[1] : undefined;
    this.say(this.words[asked ? "bad_address" : key]);
    part("detail").hidden = error == null;
    part("detail").textContent = said;
    part("again").hidden = false;
    if (asked) this.offerWithout(asked);
    document.documentElement.dataset.state = "failed";
  }
}
