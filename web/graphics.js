// What the browser can draw with.

/** The backends that can be tried, the best first; `asked` names one, or is `auto`. */
export async function backends(asked) {
  const both = asked === "auto" ? ["webgpu", "webgl2"] : [asked, "webgl2"];
  const there = { webgpu: await hasWebGpu(), webgl2: hasWebGl2() };
  return [...new Set(both)].filter((backend) => there[backend]);
}

/** Makes a canvas's context before the module requests it: opaque and without buffers that nothing is drawn into. */
export function prepare(canvas, backend) {
  const least = { alpha: false, antialias: false, depth: false, stencil: false };
  if (backend === "webgl2") canvas.getContext("webgl2", least);
}

/** How long a page that is not shown waits for its size [ms] (chosen). */
const SIZE_WAIT = 500;

/** Emulated phones, and pages in another scale than their window's, report the pixels of an element in the window's scale; the picture
 * would be twice too large or too small. Without that report the module multiplies the page's own size by its scale. */
export async function agreeOnPixels(element) {
  const seen = new Promise((resolve) => {
    const observer = new ResizeObserver(([entry]) => {
      observer.disconnect();
      resolve(entry);
    });
    observer.observe(element);
    setTimeout(resolve, SIZE_WAIT);
  });
  const entry = await seen;
  const [box] = entry?.devicePixelContentBoxSize ?? [];
  if (!box) return;
  const differs = Math.abs(box.inlineSize - entry.contentRect.width * devicePixelRatio) > 2;
  if (differs) delete ResizeObserverEntry.prototype.devicePixelContentBoxSize;
}

async function hasWebGpu() {
  try {
    return (await navigator.gpu?.requestAdapter()) != null;
  } catch {
    return false;
  }
}

function hasWebGl2() {
  const context = document.createElement("canvas").getContext("webgl2");
  // Browsers allow few contexts at a time; this one is given back at once.
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return context != null;
}
