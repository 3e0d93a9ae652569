// The rows of a study's participant, kept in the browser's storage until the site's data are deleted.

/** Resolves with true once this tab alone may write under a name; browsers without locks have one writer only if people see to it. */
function lock(name) {
  return new Promise((resolve) => {
    const hold = (held) => {
      resolve(held !== null);
      return held && new Promise(() => {});
    };
    if (navigator.locks) navigator.locks.request(name, { ifAvailable: true }, hold);
    else resolve(true);
  });
}

/** The rows of one participant, as CSV. */
export class KeptStudy {
  /** Opens the storage; null where the browser gives none. A tab that writes there already is an error. */
  static async open(study, participant) {
    const name = `saute-study-${study}-${participant}`;
    if (!(await lock(name))) throw new Error(`participant: another tab goes on with ${participant}; close this one or that`);
    try {
      return new KeptStudy(name, localStorage.getItem(name) ?? "");
    } catch (error) {
      console.info(`The rows of the study are kept in memory only: ${error.message}`);
      return null;
    }
  }

  constructor(name, text) {
    Object.assign(this, { name, text });
  }

  /** Keeps this instead of what is there; returns why it could not. */
  keep(text) {
    try {
      localStorage.setItem(this.name, text);
      this.text = text;
    } catch (error) {
      return `${error.name}: ${error.message}`;
    }
    return undefined;
  }
}
