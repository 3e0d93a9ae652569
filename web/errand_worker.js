// The worker that plays recorded cooks for the page. The page hands over the compiled module; nothing is fetched but its script.

/** Computing time between two looks at what the page says [ms] (chosen: a new errand waits no longer). */
const SLICE_MS = 30;

let bench = null;
let isPlaying = false;
/** Errands that came before the module was there: the last one counts. */
let early = null;

async function begin({ module, script }) {
  const bindings = await import(script);
  await bindings.default({ module_or_path: module });
  bench = new bindings.ErrandBench();
  if (early) take(early);
}

function take(errand) {
  bench.take(errand);
  if (!isPlaying) play();
}

/** Plays slice after slice; between two of them messages are heard. */
async function play() {
  isPlaying = true;
  while (bench.is_busy()) {
    const answer = bench.go_on(SLICE_MS);
    if (answer) postMessage({ answer }, [answer.buffer]);
    await new Promise((resolve) => setTimeout(resolve));
  }
  isPlaying = false;
}

const failed = (error) => postMessage({ failure: String(error?.message ?? error) });

self.addEventListener("message", ({ data }) => {
  if (data.module) begin(data).catch(failed);
  else if (bench) take(data.errand);
  else early = data.errand;
});
self.addEventListener("unhandledrejection", ({ reason }) => failed(reason));
