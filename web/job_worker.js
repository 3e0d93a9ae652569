// A worker that does one kind of work for the page. The page hands over the compiled module; nothing is fetched but its script.

/** Computing time between two looks at messages of the page [ms] (chosen: a new order waits no longer). */
const SLICE_MS = 30;

let executor = null;
let isWorking = false;
/** Orders that came before the module was there: the last one counts. */
let early = null;
/** The way to the other worker of two that share the work. */
let twin = null;

async function begin({ module, script, kind, isSecond, port }) {
  const bindings = await import(script);
  await bindings.default({ module_or_path: module });
  executor = new bindings.JobExecutor(kind, isSecond);
  twin = port;
  twin?.addEventListener("message", ({ data }) => executor.take_shared(data));
  twin?.start();
  if (early) take(early);
}

function take(order) {
  executor.take(order);
  if (!isWorking) work();
}

/** Messages to itself, which are received after those that wait. */
const own = new MessageChannel();

/** Waits so long [ms]; a pause of nothing ends once other messages are received, sooner than the shortest timer. */
const pause = (ms) =>
  new Promise((resolve) => {
    if (ms > 0) return setTimeout(resolve, ms);
    own.port2.onmessage = resolve;
    own.port1.postMessage(null);
  });

/** Works slice after slice; between two of them it rests as long as its kind of work requires, and messages are received. */
async function work() {
  isWorking = true;
  while (executor.is_busy()) {
    const answer = executor.go_on(SLICE_MS);
    if (answer) postMessage({ answer }, [answer.buffer]);
    const shares = twin && executor.share();
    if (shares) twin.postMessage(shares, [shares.buffer]);
    await pause(executor.rest_ms());
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
