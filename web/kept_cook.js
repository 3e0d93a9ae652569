// The cook that goes on, kept in the browser's storage (IndexedDB) so that it survives a reload. Each tab keeps its own.

const DATABASE = "saute";
/** Cooks by their ids: { at, place }. Their bytes are in PARTS by [id, number]. */
const COOKS = "cooks";
const PARTS = "parts";
/** A part grows up to this size (chosen: each writing writes the last part again). */
const PART_BYTES = 8192;
/** Cooks of closed tabs that are kept at most (chosen: those of one afternoon). */
const MOST = 8;

const lockName = (id) => `saute-cook-${id}`;
const partsOf = (id) => IDBKeyRange.bound([id], [id, []]);

/** Resolves with the result of a request of IndexedDB. */
function done(request) {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}

function openDatabase() {
  const request = indexedDB.open(DATABASE, 1);
  request.onupgradeneeded = () => {
    request.result.createObjectStore(COOKS);
    request.result.createObjectStore(PARTS);
  };
  return done(request);
}

/** Ids of the cooks that live tabs keep; browsers without locks know of none. */
async function idsInUse() {
  const held = (await navigator.locks?.query())?.held ?? [];
  return new Set(held.map((lock) => lock.name));
}

/** Why a browser stores nothing, in words where they are known, with the browser's own name for it. */
function why(error, words) {
  const known = { QuotaExceededError: words.storage_full, SecurityError: words.storage_refused, InvalidStateError: words.storage_refused };
  return `${known[error?.name] ?? error?.message ?? ""} (${error?.name ?? "AbortError"})`;
}

/** The storage of this tab's cook. `place` distinguishes addresses that begin with different cooks. */
export class KeptCook {
  constructor(place, words) {
    Object.assign(this, { place, words });
    this.id = crypto.randomUUID?.() ?? `${Date.now()}-${Math.random()}`;
    this.failure = null;
    this.earlier = null;
    this.part = { number: 0, bytes: new Uint8Array(0) };
    // Held until the tab is closed: others leave this cook alone.
    navigator.locks?.request(lockName(this.id), () => new Promise(() => {}));
  }

  /** Opens the storage and reads the last cook of this place that no other tab goes on with; null if there is none. */
  async open() {
    try {
      this.database = await openDatabase();
      const free = await this.freeCooks();
      await this.forget(free.slice(MOST).map(({ id }) => id));
      this.earlier = free.find(({ place }) => place === this.place)?.id ?? null;
      return this.earlier && (await this.read(this.earlier));
    } catch (error) {
      this.failure = why(error, this.words);
      return null;
    }
  }

  /** Cooks that no tab goes on with, the last first. */
  async freeCooks() {
    const inUse = await idsInUse();
    const cooks = this.database.transaction(COOKS).objectStore(COOKS);
    const [ids, values] = await Promise.all([done(cooks.getAllKeys()), done(cooks.getAll())]);
    const all = ids.map((id, k) => ({ id, ...values[k] }));
    return all.filter(({ id }) => !inUse.has(lockName(id))).sort((a, b) => b.at - a.at);
  }

  async read(id) {
    const parts = this.database.transaction(PARTS).objectStore(PARTS);
    const blob = new Blob(await done(parts.getAll(partsOf(id))));
    return new Uint8Array(await blob.arrayBuffer());
  }

  async forget(ids) {
    if (!ids.length) return;
    const change = this.database.transaction([COOKS, PARTS], "readwrite");
    for (const id of ids) remove(change, id);
  }

  /** Keeps bytes: the beginning of a cook, or what follows. Returns why something before could not be kept. */
  keep(begins, bytes) {
    if (this.failure) return this.failure;
    try {
      this.write(begins, bytes);
    } catch (error) {
      this.failure = why(error, this.words);
    }
    return this.failure ?? undefined;
  }

  write(begins, bytes) {
    const change = this.database.transaction([COOKS, PARTS], "readwrite");
    change.onabort = () => {
      this.failure ??= why(change.error, this.words);
    };
    if (begins) {
      // In one transaction: the cook before is there until this one is.
      if (this.earlier) remove(change, this.earlier);
      change.objectStore(PARTS).delete(partsOf(this.id));
      this.earlier = null;
      this.part = { number: 0, bytes: new Uint8Array(0) };
    }
    this.grow(bytes);
    change.objectStore(PARTS).put(this.part.bytes, [this.id, this.part.number]);
    change.objectStore(COOKS).put({ at: Date.now(), place: this.place }, this.id);
  }

  /** Appends to the last part, or begins one if it is full. */
  grow(bytes) {
    const { number, bytes: before } = this.part;
    if (before.length >= PART_BYTES) {
      this.part = { number: number + 1, bytes: bytes.slice() };
      return;
    }
    const joined = new Uint8Array(before.length + bytes.length);
    joined.set(before);
    joined.set(bytes, before.length);
    this.part = { number, bytes: joined };
  }
}

function remove(change, id) {
  change.objectStore(PARTS).delete(partsOf(id));
  change.objectStore(COOKS).delete(id);
}
