// What the page shows before the window is there, and when it fails.

const part = (id) => document.getElementById(id);
const megabytes = (bytes) => (bytes / 1e6).toFixed(1);

/** The cover over the stage, in the language of its texts. */
export class Cover {
  constructor(words) {
    this.words = words;
    for (const id of ["about", "guides", "again", "tilt"]) part(id).textContent = words[id];
    part("status").textContent = words.loading;
    part("progress").setAttribute("aria-label", words.loading);
    part("again").addEventListener("click", () => location.reload());
  }

  /** Shows how far the download is. */
  downloaded(bytes, all) {
    part("progress").value = Math.min(bytes / all, 1);
    part("status").textContent = this.words.loaded(megabytes(Math.min(bytes, all)), megabytes(all));
  }

  /** The download is over, the kitchen is not there yet. */
  preparing() {
    part("progress").value = 1;
    part("status").textContent = this.words.preparing;
  }

  /** Lets the stage be seen. */
  lift() {
    part("cover").hidden = true;
    document.documentElement.dataset.state = "cooking";
  }

  /** Shows what went wrong: a text by its key, and what the browser says. */
  fail(key, error) {
    part("cover").hidden = false;
    part("progress").hidden = true;
    part("status").textContent = this.words[key];
    part("detail").hidden = error == null;
    part("detail").textContent = String(error?.message ?? error ?? "");
    part("again").hidden = false;
    document.documentElement.dataset.state = "failed";
  }
}
