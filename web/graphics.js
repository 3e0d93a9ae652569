// What the browser can draw with.

/** The backends that can be tried, the best first; `asked` names one, or is `auto`. */
export async function backends(asked) {
  const both = asked === "auto" ? ["webgpu", "webgl2"] : [asked, "webgl2"];
  const there = { webgpu: await hasWebGpu(), webgl2: hasWebGl2() };
  return [...new Set(both)].filter((backend) => there[backend]);
}

/** Makes a canvas's context before the module asks for it: opaque and without buffers that nothing is drawn into. */
export function prepare(canvas, backend) {
  const least = { alpha: false, antialias: false, depth: false, stencil: false };
  if (backend === "webgl2") canvas.getContext("webgl2", least);
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
