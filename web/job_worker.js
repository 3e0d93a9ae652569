// A worker that does one kind of work for the page. The page hands over the compiled module; nothing is fetched but its script.

/** Computing time between two looks at messages of the page [ms] (chosen: a new order waits no longer). */
const SLICE_MS = 30;

let executor = null;
let isWorking = false;
/** Orders that came before the module was there: the last one counts. */
let early = null;

async function begin({ module, script, kind }) {
  const bindings = await import(script);
  await bindings.default({ module_or_path: module });
  executor = new bindings.JobExecutor(kind);
  if (early) take(early);
}

function take(order) {
  executor.take(order);
  if (!isWorking) work();
}

/** Works slice after slice; between two of them it rests as long as its kind of work requires, and messages are received. */
async function work() {
  isWorking = true;
  while (executor.is_busy()) {
    const answer = executor.go_on(SLICE_MS);
    if (answer) postMessage({ answer }, [answer.buffer]);
    await new Promise((resolve) => setTimeout(resolve, executor.rest_ms()));
  }
  isWorking = false;
}

const failed = (error) => postMessage({ failure: String(error?.message ?? error) });

self.addEventListener("message", ({ data }) => {
  if (data.module) begin(data).catch(failed);
  else if (executor) take(data.order);
  else early = data.order;
});
self.addEventListener("unhandledrejection", ({ reason }) => failed(reason));
