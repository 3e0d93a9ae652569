// The panels a second time, as HTML controls for screen readers and switches. They are next to the canvas; the one that has the
// focus is seen. What is done to them is done to the panels.

/** Makes the element of a control. */
const MAKERS = {
  button: () => button(),
  menu: () => button({ "aria-haspopup": "listbox" }),
  check: () => button({ role: "checkbox" }),
  radio: () => button({ role: "radio" }),
  slider: () => input("range"),
  text: () => input("text"),
  label: () => document.createElement("p"),
  heading: () => document.createElement("h2"),
};

function button(attributes = {}) {
  const made = document.createElement("button");
  made.type = "button";
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  return made;
}

function input(type) {
  const made = document.createElement("input");
  made.type = type;
  return made;
}

/** Sets an attribute if it is another: screen readers speak of what changes. */
function set(element, name, value) {
  if (value == null) element.removeAttribute(name);
  else if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}

/** The controls in their element; `page` is what they act on. */
export class Controls {
  constructor(list, page) {
    this.list = list;
    this.page = page;
    this.known = new Map();
  }

  /** Shows these controls, in this order; elements of controls that stay are kept with their focus. */
  show(controls) {
    const before = this.known;
    const held = [...before.values()].indexOf(document.activeElement);
    this.known = new Map(controls.map((control) => [control.id, this.element(control, before)]));
    for (const [id, element] of before) if (this.known.get(id) !== element) element.remove();
    let next = this.list.firstChild;
    for (const element of this.known.values()) {
      if (element === next) next = next.nextSibling;
      else this.list.insertBefore(element, next);
    }
    if (held >= 0) this.keepFocus(held, controls.find((control) => control.kind === "heading" && !before.has(control.id)));
  }

  /** Gives the focus away where the control that had it is gone, or covered by a card that has come: to the card, or to the next control. */
  keepFocus(place, heading) {
    const all = [...this.known.values()];
    const stays = all.includes(document.activeElement);
    if (stays && !(heading && document.activeElement.disabled)) return;
    const from = heading ? all.indexOf(this.known.get(heading.id)) : place;
    all.slice(from).find((element) => element.matches("button:enabled, input:enabled"))?.focus();
  }

  element(control, before) {
    const old = before.get(control.id);
    const element = old?.dataset.kind === control.kind ? old : this.make(control);
    update(element, control);
    return element;
  }

  make({ id, kind }) {
    const element = MAKERS[kind]();
    element.dataset.kind = kind;
    element.addEventListener("click", () => element instanceof HTMLButtonElement && this.page().press_control(id));
    element.addEventListener("change", () => this.page().set_control(id, element.value, kind === "text"));
    return element;
  }
}

function update(element, { kind, name, on, range, text, off }) {
  const isRead = kind === "label" || kind === "heading";
  if (isRead || element instanceof HTMLButtonElement) {
    if (element.textContent !== name) element.textContent = name;
  } else {
    set(element, "aria-label", name);
  }
  if (!isRead) element.disabled = off === true;
  const state = { check: "aria-checked", radio: "aria-checked", button: "aria-pressed" }[kind];
  if (state) set(element, state, on === undefined ? null : String(on));
  if (kind === "slider") set(element, "aria-valuetext", text);
  if (element === document.activeElement) return;
  if (range) fillRange(element, range);
  else if (text !== undefined && element.value !== text) element.value = text;
}

function fillRange(element, [least, most, now]) {
  set(element, "min", String(least));
  set(element, "max", String(most));
  set(element, "step", "any");
  if (element.value !== String(now)) element.value = String(now);
}
