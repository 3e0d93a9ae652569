// Fetches files of the site; inflates them here where the host does not compress.

/** Fetches a file; the response's body is as the file was before compression. */
export async function fetchFile(url) {
  const plain = await fetchPlain(url);
  if (plain.headers.has("Content-Encoding") || typeof DecompressionStream === "undefined") return plain;
  // Given up after its header: what is three times as large need not come.
  await plain.body?.cancel();
  return (await fetchCompressed(url, plain.headers.get("Content-Type"))) ?? fetchPlain(url);
}

async function fetchPlain(url) {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status} ${response.statusText}`);
  return response;
}

/** The `.gz` next to a file, inflated; null where there is none. */
async function fetchCompressed(url, type) {
  const response = await fetch(compressedName(url)).catch(() => null);
  // Some hosts answer a missing file with a page that states it.
  if (!response?.ok || response.headers.get("Content-Type")?.startsWith("text/html")) return null;
  // Some hosts mark a .gz file as encoded; then the browser has inflated it.
  const isInflated = response.headers.has("Content-Encoding");
  const body = isInflated ? response.body : response.body.pipeThrough(new DecompressionStream("gzip"));
  return new Response(body, { headers: { "Content-Type": type ?? "" } });
}

function compressedName(url) {
  const name = new URL(url);
  name.pathname += ".gz";
  return name;
}

/** A WebAssembly response that reports its bytes as they come, and compiles while they do. */
export function withProgress(response, report) {
  let done = 0;
  const count = new TransformStream({
    transform(chunk, controller) {
      report((done += chunk.byteLength));
      controller.enqueue(chunk);
    },
    flush: () => void performance.mark("saute fetched"),
  });
  // Streaming compilation insists on this type, which not every host sends.
  return new Response(response.body.pipeThrough(count), { headers: { "Content-Type": "application/wasm" } });
}
