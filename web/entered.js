// Keys and wheel belong to whoever is in the picture: in a frame of another page not before somebody comes in, and Tab leaves it.

/** In a frame of another page focus and wheel stay the host's until the visitor comes in by a press or by Tab. */
export function waitToBeEntered() {
  let entered = false;
  const { focus } = HTMLElement.prototype;
  // The picture takes the focus by script as soon as it is there; that would take it from the host's fields.
  HTMLElement.prototype.focus = function (...how) {
    if (entered) focus.apply(this, how);
  };
  const enter = () => {
    entered = true;
    HTMLElement.prototype.focus = focus;
  };
  for (const way of ["pointerdown", "focusin"]) window.addEventListener(way, enter, { capture: true, once: true });
  window.addEventListener("wheel", (event) => entered || event.stopImmediatePropagation(), { capture: true, passive: true });
}

/** Lets Tab leave the picture after its last control, or after Escape, and Shift+Tab before its first one. */
export function letTabLeave(page) {
  const inPicture = () => document.activeElement?.matches("#canvas, input[autocapitalize]");
  const leave = (event) => {
    const isTab = event.key === "Tab" && !event.ctrlKey && !event.altKey && !event.metaKey;
    // What the picture does not hear it does not keep from the browser.
    if (isTab && inPicture() && page()?.tab_leaves(event.shiftKey)) event.stopImmediatePropagation();
  };
  window.addEventListener("keydown", leave, { capture: true });
}
