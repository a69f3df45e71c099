// Everything the studio can do, each with a name and perhaps a key: one list for the keyboard, the palette
// (Ctrl+K) and the sheet of keys (?).
import { h } from "../base/dom";
import { say } from "../base/texts";

export interface Command {
  name: string; // key of its text: studio.do.NAME
  keys: string[]; // "v", "Ctrl+z", "ArrowLeft"
  does: () => void;
  hidden?: boolean; // not in the palette
  typing?: boolean; // works in a text field too
}

// A key as commands write it.
export function keyOf(e: KeyboardEvent): string {
  const key = e.key.length === 1 ? e.key.toLowerCase() : e.key;
  return `${e.ctrlKey || e.metaKey ? "Ctrl+" : ""}${e.altKey ? "Alt+" : ""}${e.shiftKey && (e.key.length > 1 || e.ctrlKey || e.metaKey) ? "Shift+" : ""}${key}`;
}
const shown = (key: string): string =>
  key.replace(/^ $/, say("studio.space")).replace("Ctrl+", "Ctrl ").replace("Shift+", "⇧ ").replace(/Arrow(\w+)/, (_, d: string) => ({ Left: "←", Right: "→", Up: "↑", Down: "↓" })[d] ?? d).replace(/(^| )([a-z])$/, (_, a: string, b: string) => a + b.toUpperCase());
const kbd = (keys: string[]): HTMLElement => h("span", { class: "keys" }, ...keys.slice(0, 1).map((k) => h("kbd", {}, shown(k))));

export class Commands {
  readonly palette: HTMLDialogElement;
  readonly sheet: HTMLDialogElement;
  private readonly find = h("input", { type: "text", autocomplete: "off", role: "combobox", "aria-expanded": "true", "aria-controls": "palette-list", "aria-label": say("studio.palette") });
  private readonly list = h("ul", { id: "palette-list", role: "listbox", "aria-label": say("studio.palette") });
  private hits: Command[] = [];
  private at = 0;

  constructor(readonly all: Command[]) {
    this.palette = h("dialog", { class: "palette", "aria-label": say("studio.palette") }, this.find, this.list);
    this.find.placeholder = say("studio.palette.find");
    this.find.addEventListener("input", () => this.search());
    this.palette.addEventListener("keydown", (e) => {
      if (e.key === "ArrowDown" || e.key === "ArrowUp") {
        e.preventDefault();
        this.at = (this.at + (e.key === "ArrowDown" ? 1 : this.hits.length - 1)) % Math.max(1, this.hits.length);
        this.mark();
      } else if (e.key === "Enter") {
        e.preventDefault();
        this.run(this.hits[this.at]);
      }
      e.stopPropagation();
    });
    this.sheet = h("dialog", { class: "sheet-of-keys", "aria-label": say("studio.do.keys") });
    for (const dialog of [this.palette, this.sheet])
      dialog.addEventListener("click", (e) => {
        if (e.target === dialog) dialog.close();
      });
  }
  // Whether a key was one of ours.
  key(e: KeyboardEvent, inField: boolean): boolean {
    const key = keyOf(e);
    const command = this.all.find((c) => c.keys.includes(key));
    if (!command || (inField && !command.typing)) return false;
    command.does();
    return true;
  }
  openPalette(): void {
    this.find.value = "";
    this.search();
    this.palette.showModal();
    this.find.focus();
  }
  private search(): void {
    const words = this.find.value.toLowerCase().split(/\s+/).filter(Boolean);
    this.hits = this.all.filter((c) => !c.hidden && words.every((w) => say(`studio.do.${c.name}`).toLowerCase().includes(w)));
    this.at = 0;
    this.list.replaceChildren(
      ...this.hits.map((c, k) => {
        const item = h("li", { role: "option", id: `hit-${k}`, onclick: () => this.run(c) }, say(`studio.do.${c.name}`), kbd(c.keys));
        return item;
      }),
    );
    this.mark();
  }
  private mark(): void {
    [...this.list.children].forEach((item, k) => item.setAttribute("aria-selected", String(k === this.at)));
    this.list.children[this.at]?.scrollIntoView({ block: "nearest" });
    this.find.setAttribute("aria-activedescendant", `hit-${this.at}`);
  }
  private run(command: Command | undefined): void {
    this.palette.close();
    command?.does();
  }
  openSheet(): void {
    const rows = this.all.filter((c, k) => c.keys.length > 0 && this.all.findIndex((other) => other.name === c.name) === k);
    this.sheet.replaceChildren(
      h("header", {}, h("h2", {}, say("studio.do.keys")), h("button", { class: "button", type: "button", onclick: () => this.sheet.close() }, say("studio.close"))),
      h("dl", {}, ...rows.map((c) => h("div", {}, h("dt", {}, kbd(c.keys)), h("dd", {}, say(`studio.do.${c.name}`))))),
      h("p", { class: "soft" }, say("studio.keys.hint")),
    );
    this.sheet.showModal();
  }
}
