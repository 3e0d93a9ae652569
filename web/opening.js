// The page's first script, and no module: it reports what is wrong where modules do not come or may not run. The texts are in index.html.

"use strict";

{
  const root = document.documentElement;
  const asked = new URLSearchParams(location.search).get("lang");
  const spoken = ["en", "ja"].includes(asked) ? asked : navigator.language.split("-")[0];
  root.lang = spoken === "ja" ? "ja" : "en";
  root.dataset.lang = root.lang;

  /** Shows why the page cannot begin: `stuck`, `sandbox` or `disk`. */
  const tell = (why) => {
    root.dataset.trouble = why;
    root.dataset.state = "failed";
  };

  // A page without its own origin loads no modules and keeps nothing.
  if (location.protocol === "file:") tell("disk");
  else if (self.origin === "null") tell("sandbox");
  // Until the page's own script has begun, whatever fails is a part that did not come. What is fetched ahead may fail: it is requested again.
  const notice = ({ target }) => root.dataset.state || target instanceof HTMLLinkElement || tell("stuck");
  for (const kind of ["error", "unhandledrejection"]) window.addEventListener(kind, notice, { capture: true });

  document.addEventListener("DOMContentLoaded", () => {
    const here = new URL(location.href);
    here.searchParams.delete("embed");
    for (const link of document.querySelectorAll("#trouble a.alone")) link.href = here.href;
    // With its fragment, which contains a cook; a link to this very page would leave it out.
    for (const link of document.querySelectorAll("#trouble a.again")) {
      link.addEventListener("click", (event) => (event.preventDefault(), location.reload()));
    }
  });
}
