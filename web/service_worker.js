// Keeps the page for later visits without a network. One version of the build is one cache: a page never mixes two, since every file but the
// page itself is addressed with its version. A new version answers as soon as it is kept as a whole; pages of the old one that are still open
// go on from theirs.

const VERSION = "{{version}}";
const CACHE = `saute-${VERSION}`;
/** The files of this version, as the build lists them; the Japanese font comes when it is first requested. */
const FILES = JSON.parse('{{files}}');
/** Files that hosts may not compress: then their `.gz` is kept, a third of the size. */
const LARGE = [".wasm", ".otf"];

const scope = new URL(self.registration.scope);
const placed = (file) => new URL(`${file}?v=${VERSION}`, scope).href;

/** The `.gz` next to a file. */
function compressed(url) {
  const name = new URL(url);
  name.pathname += ".gz";
  return name.href;
}

/** True for a response that is the file and not a host's page about a missing one. */
const isFile = (response) => response.ok && !response.headers.get("Content-Type")?.startsWith("text/html");

/** Keeps a file, in the form in which the host sends the fewest bytes. */
async function keep(cache, url) {
  const plain = await fetch(url);
  if (!plain.ok) throw new Error(`${url}: ${plain.status}`);
  const isLarge = LARGE.some((ending) => new URL(url).pathname.endsWith(ending));
  if (isLarge && !plain.headers.has("Content-Encoding")) {
    const small = await fetch(compressed(url)).catch(() => null);
    if (small && isFile(small)) {
      await plain.body?.cancel();
      return cache.put(compressed(url), small);
    }
  }
  return cache.put(url, plain);
}

async function install() {
  const cache = await caches.open(CACHE);
  // The page itself carries no version: the cache of the browser must not give an old one.
  const page = await fetch(scope.href, { cache: "no-cache" });
  if (!page.ok) throw new Error(`${scope.href}: ${page.status}`);
  await cache.put(scope.href, page);
  await Promise.all(FILES.map((file) => keep(cache, placed(file))));
  // Now, while the page that is open cooks and requests nothing. A version that waits is changed for while the next start is under way, and
  // the browser may lose that start: it then waits for minutes.
  await self.skipWaiting();
}

/** Once a page of this version cooks and no other is open: nobody needs the files of other versions. */
async function forgetOthers() {
  const pages = await self.clients.matchAll({ type: "window", includeUncontrolled: true });
  if (pages.length > 1) return;
  const names = await caches.keys();
  await Promise.all(names.filter((name) => name.startsWith("saute-") && name !== CACHE).map((name) => caches.delete(name)));
}

/** True for the page itself; guides and pictures come from the network. */
function isPage(request) {
  const { pathname } = new URL(request.url);
  return request.mode === "navigate" && [scope.pathname, `${scope.pathname}index.html`].includes(pathname);
}

async function answer(request) {
  const cache = await caches.open(CACHE);
  const kept = isPage(request) ? await cache.match(scope.href) : await caches.match(request);
  if (kept) return kept;
  const twin = await caches.match(compressed(request.url));
  if (twin) return new Response(twin.body.pipeThrough(new DecompressionStream("gzip")));
  const response = await fetch(request);
  // The font, and its `.gz`, from the first time on.
  const isFont = request.url.includes("/fonts/") && request.url.endsWith(`?v=${VERSION}`);
  if (isFont && response.status === 200) await cache.put(request, response.clone());
  return response;
}

self.addEventListener("install", (event) => event.waitUntil(install()));
self.addEventListener("activate", (event) => event.waitUntil(self.clients.claim()));
self.addEventListener("fetch", (event) => {
  const { method, url } = event.request;
  if (method === "GET" && url.startsWith(scope.href)) event.respondWith(answer(event.request));
});
// A page states its version once it cooks.
self.addEventListener("message", (event) => event.data === VERSION && event.waitUntil(forgetOthers()));
