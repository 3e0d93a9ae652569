// Loads the kitchen and starts it. The address may contain: ?lang=ja, ?backend=webgl2 (or webgpu), ?recipe=medium, ?embed, #cook=…,
// ?study=2013&participant=P07 (&machine=tried), ?scenario=first-steak (&student=S1, &lock=1, &report=https://school.example).

// Files of one build belong together; the version keeps a browser's cache from mixing two.
const version = new URL(import.meta.url).search;
const place = (file) => new URL(`./${file}${version}`, import.meta.url).href;
const FILES = ["download", "graphics", "cover", "words", "start_tiles", "host", "kept_cook", "kept_study", "controls", "offline", "jobs", "entered"];
const parts = await Promise.all(FILES.map((file) => import(place(`${file}.js`))));
const { fetchFile, withProgress, backends, prepare, agreeOnPixels, Cover, words, StartTiles, Host, KeptCook, KeptStudy, Controls, Jobs, keepForOffline, waitToBeEntered, letTabLeave } = Object.assign({}, ...parts);

const asked = new URLSearchParams(location.search);
// Without a language in the address the kitchen takes the remembered one, else the browser's.
const lang = document.body.dataset.languages.split(" ").includes(asked.get("lang")) ? asked.get("lang") : "";
const recipe = asked.get("recipe") ?? "";
/** In a frame of another page (`?embed`) nothing is kept, neither the cook nor the page. */
const isEmbedded = asked.has("embed");
/** Of a study its rows are kept, of a lesson what is saved; the cooks of both begin again. */
const isLed = asked.has("study") || asked.has("scenario");
const language = lang || navigator.language;
const spoken = words(language);
const keptCook = isEmbedded || isLed ? null : new KeptCook(`${recipe}${location.hash}`, spoken);
/** Where the address states what to cook, nobody is asked. */
const asksWhat = keptCook && !recipe && !location.hash;
const controls = new Controls(document.getElementById("controls"), () => page);
/** The compiled module and the address of its script, for the workers. */
let giveProgram;
const program = new Promise((resolve) => (giveProgram = resolve));
const jobs = new Jobs(program, place("job_worker.js"), () => page?.wake());
const host = new Host(keptCook, controls, jobs, asked.get("report") ?? "");
const led = Object.fromEntries(["study", "participant", "machine", "scenario", "student"].map((key) => [key, asked.get(key) ?? ""]));
const cover = new Cover(spoken, version.replace("?v=", ""));
host.report = (said) => cover.report(said);
const options = { lang, recipe, ...led, lock: asked.get("lock") === "1", link: location.hash, embed: isEmbedded, host, version: cover.version };
document.documentElement.lang = language;

let bindings = null;
let page = null;
/** Settled when the start under way is over; a page takes a font only then. */
let started = Promise.resolve();

/** Fetches the module and compiles it while it comes. */
async function load() {
  const bytes = Number(document.body.dataset.moduleBytes);
  const [loaded, response] = await Promise.all([import(place("saute_web.js")), fetchFile(place("saute_web_bg.wasm"))]);
  const counted = withProgress(response, (done) => cover.downloaded(done, bytes));
  const module = await WebAssembly.compileStreaming(counted);
  performance.mark("saute compiled");
  await loaded.default({ module_or_path: module });
  giveProgram({ module, script: place("saute_web.js") });
  cover.loaded();
  return loaded;
}

/** What is kept of the last cook, or what was chosen to begin instead; in the meantime the program comes. */
async function choose() {
  const kept = await keptCook?.open();
  // A slow storage may answer after the program has failed to come.
  if (!asksWhat || cover.hasFailed) return { kept };
  document.documentElement.dataset.state = "offering";
  const [heading, list] = ["choose", "starts"].map((id) => document.getElementById(id));
  return new StartTiles(heading, list, spoken, place).choose(kept);
}

/** A canvas can serve one kind of context only, so each start gets a fresh one. */
function freshCanvas(backend) {
  const canvas = document.createElement("canvas");
  canvas.id = "canvas";
  canvas.setAttribute("role", "application");
  canvas.setAttribute("aria-label", cover.words.picture);
  canvas.setAttribute("aria-describedby", "told");
  canvas.addEventListener("webglcontextlost", startAgain, { once: true });
  document.getElementById("stage").replaceChildren(canvas);
  prepare(canvas, backend);
  return canvas;
}

/** Starts with the first backend that works. */
async function start(candidates) {
  const [backend, ...others] = candidates;
  try {
    page ??= new bindings.Page();
    started = page.start(freshCanvas(backend), { ...options, backend });
    await started;
    performance.mark("saute started");
    nameTextFields();
    // Tests read `saute.stats()`.
    window.saute = page;
    cover.lift();
  } catch (error) {
    if (!others.length) throw error;
    console.info(`${backend} could not be started, ${others[0]} is tried: ${error?.message ?? error}`);
    await start(others);
  }
}

/** The field by which the canvas receives what is typed gets a name, and is not a stop for the Tab key. */
function nameTextFields() {
  for (const field of document.querySelectorAll("input[autocapitalize]")) {
    field.setAttribute("aria-label", cover.words.typed);
    field.tabIndex = -1;
  }
}

/** The graphics are gone: the cook goes on with new ones, by the least demanding backend. */
async function startAgain() {
  await started.catch(() => {});
  try {
    page.destroy();
    await start(["webgl2"]);
  } catch (error) {
    cover.fail("not_started", error);
  }
}

async function offerFont() {
  try {
    const font = await fetchFile(place("fonts/japanese.otf"));
    await started;
    page.offer_font(new Uint8Array(await font.arrayBuffer()));
  } catch (error) {
    console.warn(`The Japanese font could not be loaded: ${error.message}`);
  }
}

/** An error in WebAssembly leaves the kitchen unusable; others are only reported. */
function noticeStop(event) {
  const error = event.error ?? event.reason;
  if (error instanceof WebAssembly.RuntimeError) cover.fail("stopped", error);
}

/** The storage of the study in the address; null where there is none. */
function openStudy() {
  return led.study && !isEmbedded ? KeptStudy.open(led.study, led.participant) : null;
}

async function main() {
  document.documentElement.dataset.state = "loading";
  if (typeof WebAssembly === "undefined") return cover.fail("no_wasm");
  const candidates = await backends(asked.get("backend") ?? "auto");
  if (!candidates.length) return cover.fail("no_graphics");
  try {
    const [loaded, chosen] = await Promise.all([load(), choose()]);
    bindings = loaded;
    Object.assign(options, chosen);
  } catch (error) {
    return cover.fail("not_loaded", error);
  }
  document.documentElement.dataset.state = "loading";
  performance.mark("saute chosen");
  await cover.preparing();
  await agreeOnPixels(document.getElementById("stage"));
  try {
    host.keptStudy = await openStudy();
    await start(candidates);
  } catch (error) {
    return cover.fail("not_started", error);
  }
  if (!isEmbedded) await keepForOffline();
}

window.addEventListener("hashchange", () => page?.open_link(location.hash));
window.addEventListener("pagehide", () => page?.keep_now());
document.getElementById("describe").addEventListener("click", () => host.announce(document.getElementById("told").textContent));
document.addEventListener("visibilitychange", () => {
  page?.be_seen(!document.hidden);
  if (document.hidden) page?.keep_now();
});
letTabLeave(() => page);
if (isEmbedded) waitToBeEntered();
window.addEventListener("saute-lost", startAgain);
window.addEventListener("saute-font", offerFont);
window.addEventListener("error", noticeStop);
window.addEventListener("unhandledrejection", noticeStop);
await main();
