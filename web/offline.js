// The page without a network: installs the service worker, and lets a new version take over when the page starts.

/** Before anything is loaded: a version that has been fetched since the last visit takes over. Resolves if this page may go on. */
export async function takeNewVersion() {
  const registration = await navigator.serviceWorker?.getRegistration().catch(() => undefined);
  if (!registration?.waiting) return;
  const taken = new Promise((resolve) => {
    navigator.serviceWorker.addEventListener("controllerchange", () => resolve(true), { once: true });
    // A version that does not answer does not keep this one from starting.
    setTimeout(() => resolve(false), 10_000);
  });
  registration.waiting.postMessage("take over");
  if (!(await taken)) return;
  location.reload();
  await new Promise(() => {});
}

/** Once the page cooks: fetches it for the next time. Where that is not possible, the page works as before. */
export async function keepForOffline() {
  try {
    await navigator.serviceWorker?.register(new URL("service_worker.js", location.href));
  } catch (error) {
    console.info(`The page is not kept for use without a network: ${error.message}`);
  }
}
