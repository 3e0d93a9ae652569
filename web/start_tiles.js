// The first sight of the page: what there is to cook, as pictures to press. What was cooked last comes first.

/** What can be begun: its text and its picture have its name; what it opens are options of the start. */
const STARTS = [
  { name: "steak", opens: { food: "beef-lean" } },
  { name: "shrimp", opens: { recipe: "shrimp" } },
  { name: "stir", opens: { recipe: "steak-carrots-leeks" } },
  { name: "burger", opens: { food: "beef-patty" } },
  { name: "inside", opens: { recipe: "medium", cut: true } },
];

/** The pictures in their element; `place` gives the address of a file of the site. */
export class StartTiles {
  constructor(heading, list, words, place) {
    Object.assign(this, { heading, list, words, place });
  }

  /** Resolves with the options that a person chose; `kept` is the cook with which one can go on, if there is one. */
  choose(kept) {
    const last = kept ? [{ name: "last", opens: { kept } }] : [];
    return new Promise((resolve) => {
      const tiles = [...last, ...STARTS].map(({ name, opens }) => this.tile(name, () => resolve({ ...opens, chosen: true })));
      this.list.replaceChildren(...tiles);
      this.list.hidden = this.heading.hidden = false;
    });
  }

  tile(name, choose) {
    const [title, line] = this.words.starts[name];
    const tile = document.createElement("button");
    tile.type = "button";
    tile.dataset.start = name;
    const picture = Object.assign(new Image(360, 240), { alt: "", src: this.place(name === "last" ? "icon.svg" : `start_${name}.webp`) });
    tile.append(picture, textOf("strong", title), textOf("span", line));
    tile.addEventListener("click", () => {
      for (const other of this.list.children) other.setAttribute("aria-pressed", String(other === tile));
      choose();
    });
    return tile;
  }
}

function textOf(element, text) {
  const made = document.createElement(element);
  made.textContent = text;
  return made;
}
