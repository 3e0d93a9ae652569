// The page without a network: installs the service worker, and lets a new version take over when the page starts.

/** True once the page cooks: from then on a version that takes over does not load it again. */
let cooks = false;

/** Before anything is loaded: a version that has been fetched since the last visit takes over. Resolves if this page may go on. */
export async function takeNewVersion() {
  const registration = await navigator.serviceWorker?.getRegistration().catch(() => undefined);
  if (!registration?.waiting) return;
  navigator.serviceWorker.addEventListener("controllerchange", () => cooks || location.reload(), { once: true });
  registration.waiting.postMessage("take over");
  // A version that does not answer does not keep this one from starting; one that answers late takes its place while it still loads.
  await new Promise((resolve) => setTimeout(resolve, 10_000));
}

/** Once the page cooks: fetches it for the next time. Where that is not possible, the page works as before. */
export async function keepForOffline() {
  cooks = true;
  try {
    await navigator.serviceWorker?.register(new URL("service_worker.js", location.href));
  } catch (error) {
    console.info(`The page is not kept for use without a network: ${error.message}`);
  }
}
