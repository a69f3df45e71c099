// The numbers of the wall beside the drawing. Each field shows what the file says and edits it in place.
import { h, svg, type Child } from "../base/dom";
import { isDoor, setOpening } from "./parts/openings";
import { loadOf, pushOf, setDirection } from "./stages";
import { setWallSize } from "./parts/storeys";
import { num, say } from "../base/texts";
import { headOf, kHeads, riseOf, setHead, setRise, type Head } from "./parts/arches";
import type { Box, Selected } from "./drawing";
import { lackingOf, masonryGroup, masonryShape } from "./masonry/masonry";
import { renameOpening } from "./parts/frames";
import { frameFields, partGroup, partShape } from "./parts/part_panel";
import { originsIn, showOrigins } from "./masonry/origins";
import { removePart } from "./parts/parts";
import type { Fault, Project } from "./project";
import { countAt, find, quoted, removeAt, setValue, valueAt, type Path } from "./file/toml";
import { isWord, lengthOf, readQuantity, setLength, typedLength, typedQuantity, writeQuantity } from "./file/units";
import type { Varied } from "./push/varied";

const kBonds = ["running", "stack", "flemish", "english", "header"];


interface Field {
  root: HTMLElement;
  refresh(): void;
}

export class Panel {
  readonly root = h("div", { class: "numbers" });
  private fields: Field[] = [];
  private shape = ""; // of what is shown: another one is built anew
  private last = ""; // label of the number that was used last
  private lacking = new Set<string>(); // keys that the engine asks for
  private readonly origins = h("details", { class: "origins wide", hidden: true });

  constructor(
    readonly project: Project,
    private readonly changed: () => void,
    private readonly tell: (words: string) => void,
    private readonly vary: (number: Varied, opener: HTMLElement) => void,
  ) {
    project.listen(() => this.refresh());
    this.root.addEventListener("focusin", (e) => (this.last = (e.target as HTMLElement).getAttribute("aria-label") ?? this.last));
  }
  // Varies the number that was used last, else the first one.
  varyLast(): boolean {
    const all = [...this.root.querySelectorAll<HTMLButtonElement>(".vary:not(:disabled)")];
    const button = all.find((b) => b.previousElementSibling?.querySelector("input")?.getAttribute("aria-label") === this.last) ?? all[0];
    button?.click();
    return button !== undefined;
  }

  // The model with every value that the engine took; "" where it took none.
  took(model: string): void {
    showOrigins(this.origins, originsIn(model));
  }
  lacks(found: Fault[]): void {
    const lacking = lackingOf(found);
    if ([...lacking].join() === [...this.lacking].join()) return; // a refresh would take away what is typed and wrong
    this.lacking = lacking;
    const typed = document.activeElement;
    const isTyping = typed instanceof HTMLInputElement && this.root.contains(typed) && typed.value !== typed.dataset.shown;
    this.refresh();
    const field = document.activeElement; // of the same name
    if (!isTyping || !(field instanceof HTMLInputElement) || field === typed) return;
    field.value = typed.value;
    field.setSelectionRange(typed.selectionStart, typed.selectionEnd);
  }
  refresh(): void {
    const { project } = this;
    const doc = project.doc;
    const load = doc && loadOf(doc);
    const push = doc && pushOf(doc);
    const shape = [project.drawing?.openings.length ?? -1, project.selection?.kind, project.selection?.k, partShape(project), project.drawing?.openings[project.selected]?.arch?.kind, load?.key, load?.path[1], push?.stage, push?.until !== null, project.drawing?.storeys.length, masonryShape(doc, this.lacking)].join();
    if (shape !== this.shape) {
      this.shape = shape;
      this.build();
    }
    for (const field of this.fields) field.refresh();
    this.root.classList.toggle("locked", !project.drawable);
    for (const input of this.root.querySelectorAll<HTMLInputElement>("input, select, button")) input.disabled = !project.drawable || input.dataset.off === "1";
  }

  private build(): void {
    const { project } = this;
    this.fields = [];
    if (!project.drawing) return this.root.replaceChildren();
    const k = project.selected;
    const part = project.selection && project.selection.kind !== "opening" ? [partGroup(this, project.selection)] : [];
    const had = this.root.contains(document.activeElement) ? document.activeElement?.getAttribute("aria-label") : null;
    this.root.replaceChildren(...(k >= 0 ? [this.openingGroup(k)] : part), this.wallGroup(), masonryGroup(this, this.lacking, this.origins), this.loadGroup());
    if (had) this.root.querySelector<HTMLElement>(`[aria-label="${CSS.escape(had)}"]`)?.focus(); // the field of that name, if there is one still
  }
  group(title: string, ...fields: Child[]): HTMLElement {
    return h("section", { class: "group" }, h("h2", {}, title), h("div", { class: "fields" }, fields));
  }

  // --- groups -------------------------------------------------------------------------------------

  private openingGroup(k: number): HTMLElement {
    const { project } = this;
    const opening = () => project.drawing!.openings[Math.min(k, project.drawing!.openings.length - 1)];
    const side = (key: keyof Box, label: string): HTMLElement =>
      this.length(label, () => opening()[key] - (key === "y" ? opening().foot : 0), (value) => {
        const o = opening();
        return setOpening(project.text, k, { ...o, [key]: value + (key === "y" ? o.foot : 0) }, o.foot);
      }, key === "x" || key === "width" ? "half" : "course");
    const arch = opening().arch;
    const depth: Path = ["wall", "opening", k, "arch", "depth"];
    return this.group(
      say(isDoor(opening()) ? "studio.door" : "studio.window"),
      this.text(say("studio.name"), () => opening().name, (name) => renameOpening(project.text, project.drawing!, k, name), true),
      side("x", say("studio.left")), side("y", say("studio.sill")), side("width", say("studio.width")), side("height", say("studio.height")),
      this.choice(say("studio.head"), kHeads.map((head) => [head, say(`studio.head.${head}`)]), () => headOf(opening()), (head) => setHead(project.text, project.drawing!, k, head as Head), true),
      arch && arch.kind !== "flat" && this.length(say("studio.rise"), () => riseOf(opening().arch, opening().width), (v) => setRise(project.text, project.drawing!, k, v), 0.01),
      arch && this.length(say("studio.arch.depth"), () => opening().arch?.depth ?? NaN, (v) => setLength(project.text, depth, v), 0.01),
      frameFields(this, k),
      h("button", { class: "button", type: "button", onclick: () => this.remove({ kind: "opening", k }) }, say("studio.delete")),
    );
  }
  private wallGroup(): HTMLElement {
    const { project } = this;
    const d = () => project.drawing!;
    const own = (label: string, path: Path): HTMLElement | null =>
      find(project.doc!, path) === undefined ? null : this.length(label, () => lengthOf(valueAt(project.doc!, path)) ?? NaN, (v) => setLength(project.text, path, v), 0.01, readQuantity(valueAt(project.doc!, path))?.unit);
    return this.group(
      say("studio.wall"),
      this.length(say("studio.length"), () => d().length, (v) => setWallSize(project.text, d(), v, d().height), "half"),
      this.length(say("studio.height"), () => d().height, (v) => setWallSize(project.text, d(), d().length, v), "course"),
      own(say("studio.thickness"), ["wall", "thickness"]),
      this.choice(say("studio.bond"), kBonds.map((b) => [b, say(`studio.bond.${b}`)]), () => String(valueAt(project.doc!, ["wall", "bond"]) ?? "running"), (b) => setValue(project.text, ["wall", "bond"], quoted(b))),
      own(say("studio.unit.length"), ["wall", "unit", "length"]),
      own(say("studio.unit.height"), ["wall", "unit", "height"]),
    );
  }
  private loadGroup(): HTMLElement {
    const { project } = this;
    const load = loadOf(project.doc!),
      push = pushOf(project.doc!);
    const fields: Child[] = [];
    if (load) fields.push(this.quantity(say(`studio.load.${load.key}`), () => loadOf(project.doc!)?.value ?? "", (v) => setValue(project.text, load.path, quoted(v))));
    if (countAt(project.doc!, ["floor"]) > 0) fields.push(h("p", { class: "hint" }, say("studio.floors", { count: countAt(project.doc!, ["floor"]) })));
    if (push) {
      if (push.until !== null) {
        const drift = h("output", { class: "hint" });
        const path: Path = ["stage", push.stage, "until"];
        const until = () => lengthOf(pushOf(project.doc!)?.until) ?? NaN;
        fields.push(this.quantity(say("studio.until"), () => pushOf(project.doc!)?.until ?? "", (v) => setValue(project.text, path, quoted(v))), drift);
        this.fields.push({ root: drift, refresh: () => {
          const height = pushOf(project.doc!)?.y ?? project.drawing!.height;
          drift.textContent = say("studio.drift", { drift: num((100 * until()) / height, 2) });
        } });
      }
      fields.push(this.choice(say("studio.direction"), [["+x", say("studio.right")], ["-x", say("studio.leftwards")]], () => pushOf(project.doc!)?.direction ?? "+x", (v) => setDirection(project.text, project.drawing!, v), true));
    } else fields.push(h("p", { class: "hint" }, say("studio.nopush")));
    return this.group(say("studio.load"), fields);
  }

  // --- fields, for part_panel.ts too -------------------------------------------------------------------------------------------

  edit(text: string, selected: Selected | number | null = this.project.selection): void {
    this.project.endStep();
    this.project.change(text, selected);
    this.changed();
  }
  remove(part: Selected): void {
    const text = removePart(this.project.text, this.project.drawing!, part);
    if (text === null) this.tell(say("studio.hinder.file"));
    else this.edit(text, null);
  }
  // A text field whose words `take` turns into an edit; null: it cannot be read. Emptied, a key that the file may leave out goes
  // (`unset`), unless words say why it must stay (`needed`). A number may be varied.
  private entry(label: string, unit: string, show: () => string, take: (text: string) => string | null, more: { step?: (by: number) => string | null; wide?: boolean; vary?: () => Omit<Varied, "name"> | null; unset?: Path; needed?: string } = {}): HTMLElement {
    const { step, vary, unset, needed } = more;
    const input = h("input", { type: "text", "aria-label": label, "aria-description": unit === "" ? undefined : unit, autocomplete: "off", spellcheck: "false", inputmode: unit === "" ? undefined : "decimal", placeholder: unset && say("studio.unset") });
    const commit = (): void => {
      if (input.value === input.dataset.shown) return;
      const empty = unset !== undefined && input.value.trim() === "";
      const text = empty ? this.without(unset) : take(input.value);
      if (empty) input.value = input.dataset.shown ?? "";
      if (empty && needed) {
        input.removeAttribute("aria-invalid");
        return this.tell(needed);
      }
      input.setAttribute("aria-invalid", String(text === null));
      if (text !== null) this.edit(text);
    };
    input.addEventListener("change", commit);
    input.addEventListener("keydown", (e) => {
      if (e.key === "Enter") commit();
      else if (e.key === "Escape") {
        input.value = input.dataset.shown ?? "";
        input.removeAttribute("aria-invalid");
      } else if (step && (e.key === "ArrowUp" || e.key === "ArrowDown")) {
        e.preventDefault();
        const text = step(e.key === "ArrowUp" ? 1 : -1);
        if (text !== null) this.edit(text);
      }
    });
    const refresh = (): void => {
      const value = show();
      if (input.dataset.shown === value && input.getAttribute("aria-invalid") !== "true") return;
      input.dataset.shown = input.value = value;
      input.removeAttribute("aria-invalid");
    };
    const field = h("label", {}, h("span", {}, label), h("span", { class: "box" }, input, unit !== "" && h("span", { class: "unit" }, unit)));
    const button = h("button", { class: "vary", type: "button", title: say("studio.vary", { name: label }), onclick: () => {
      const number = vary?.();
      const { project } = this;
      const part = project.selection; // whose number it may be
      const isThere = (): boolean => project.drawable && project.holds(part);
      if (number) this.vary({ ...number, name: label, now: () => (isThere() ? number.now() : NaN), text: (v) => (isThere() ? number.text(v) : null) }, button);
    } }, svg("svg", { viewBox: "0 0 16 16", "aria-hidden": "true" }, svg("path", { d: "M1 4.5H6M10 4.5H15M1 11.5H8M12 11.5H15" }), svg("circle", { cx: 8, cy: 4.5, r: 2 }), svg("circle", { cx: 10, cy: 11.5, r: 2 })));
    const root = h("div", { class: more.wide ? "entry wide" : vary ? "entry varied" : "entry" }, field, vary && button);
    this.fields.push({ root, refresh });
    return root;
  }
  private without(path: Path): string {
    const { text, doc } = this.project;
    return doc && find(doc, path) ? removeAt(text, path) : text;
  }
  // `unset`: the key of a number that the file may leave out.
  length(label: string, show: () => number, set: (value: number) => string | null, step: "half" | "course" | number, unit = "m", unset?: Path): HTMLElement {
    const by = (): number => (typeof step === "number" ? step : this.project.drawing![step]);
    const safe = (v: number | null): string | null => (v === null || v < 0 || v > 1e4 ? null : set(v));
    const plain = (v: number): string => (Number.isFinite(v) ? writeQuantity(v, unit, unit === "m" ? "0.00" : "").split(" ")[0] : "");
    return this.entry(label, unit, () => plain(show()), (text) => safe(typedLength(/[a-z]/i.test(text) ? text : `${text} ${unit}`)), {
      step: (n) => safe(show() + n * by()),
      vary: () => ({ unit, whole: false, now: () => Number(plain(show()) || NaN), text: (v) => safe(lengthOf(`${v} ${unit}`)) }),
      unset,
    });
  }
  // `like`: a quantity of its kind, for where there is none.
  quantity(label: string, show: () => string, set: (value: string) => string | null, like = "", unset?: Path, needed?: string): HTMLElement {
    return this.entry(label, "", show, (text) => {
      const value = typedQuantity(text, show() || like);
      return value === null ? null : set(value);
    }, { unset, needed, vary: () => {
      const unit = readQuantity(show())?.unit;
      // in another unit by now it is another number
      const now = (): number => (readQuantity(show())?.unit === unit ? parseFloat(show()) : NaN);
      return unit ? { unit, whole: false, now, text: (v) => set(`${v} ${unit}`) } : null;
    } });
  }
  // A quantity that the file may leave out; null where it says it in words.
  optional(label: string, path: Path, unit: string, needed?: string): HTMLElement | null {
    const show = (): string => String(valueAt(this.project.doc!, path) ?? "");
    if (isWord(this.project.doc!, path)) return null;
    return this.quantity(label, show, (v) => setValue(this.project.text, path, quoted(v)), `1 ${unit}`, path, needed);
  }
  // A number from 0 to 1 without a unit, which the file may leave out.
  share(label: string, path: Path, needed?: string): HTMLElement {
    const show = (): string => String(valueAt(this.project.doc!, path) ?? "");
    const safe = (v: number): string | null => (v >= 0 && v <= 1 ? setValue(this.project.text, path, String(v)) : null);
    const read = (text: string): number => (text.trim() === "" ? NaN : Number(text.replace(",", ".")));
    return this.entry(label, "", show, (text) => safe(read(text)), { unset: path, needed, vary: () => (Number.isFinite(read(show())) ? { unit: "", whole: false, now: () => read(show()), text: safe } : null) });
  }
  number(label: string, show: () => number, set: (value: number) => string, unset?: Path): HTMLElement {
    const safe = (n: number): string | null => (Number.isInteger(n) && n >= 1 && n < 100 ? set(n) : null);
    return this.entry(label, "", () => String(show()), (text) => safe(Number(text)), { step: (by) => safe(show() + by), vary: () => ({ unit: "", whole: true, now: show, text: safe }), unset });
  }
  // What follows from the numbers.
  hint(show: () => string): HTMLElement {
    const root = h("output", { class: "hint" });
    this.fields.push({ root, refresh: () => (root.textContent = show()) });
    return root;
  }
  text(label: string, show: () => string, set: (value: string) => string, wide = false): HTMLElement {
    return this.entry(label, "", show, (text) => (text.trim() === "" ? null : set(text.trim())), { wide });
  }
  choice(label: string, options: [string, string][], show: () => string, set: (value: string) => string, wide = false): HTMLElement {
    const select = h("select", { "aria-label": label, onchange: () => this.edit(set(select.value)) });
    for (const [value, text] of options) select.append(h("option", { value }, text));
    const root = h("label", { class: wide ? "entry wide" : "entry" }, h("span", {}, label), select);
    this.fields.push({ root, refresh: () => {
      const value = show();
      if (![...select.options].some((o) => o.value === value)) select.append(h("option", { value }, value === "" ? say("studio.none") : value));
      select.value = value;
    } });
    return root;
  }
}
