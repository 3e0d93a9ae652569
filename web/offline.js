// The page without a network: installs the service worker.

/** The version of the build that this page is of. */
const VERSION = new URL(import.meta.url).searchParams.get("v");

/** Once the page cooks: fetches it for the next time. Where that is not possible, the page works as before. */
export async function keepForOffline() {
  try {
    await navigator.serviceWorker?.register(new URL("service_worker.js", location.href));
    // The version that answers forgets the others, if it is this one.
    navigator.serviceWorker?.controller?.postMessage(VERSION);
  } catch (error) {
    console.info(`The page is not kept for use without a network: ${error.message}`);
  }
}
