// The model file beside the drawing: the whole text, editable, with line numbers and the lines of faults marked. The number at the
// cursor may be varied.
import { h } from "../../base/dom";
import { say } from "../../base/texts";
import type { Fault, Project } from "../project";
import { numberAt, type Varied } from "../push/varied";

const kPause = 250; // after a key, before the text counts [ms]

export class FilePane {
  readonly root: HTMLElement;
  private readonly area: HTMLTextAreaElement;
  private readonly lines = h("pre", { class: "lines", "aria-hidden": "true" });
  private timer = 0;
  private faults = new Map<number, string>();

  private varied: Varied | null = null; // the number at the cursor
  private readonly varies = h("button", { class: "button small", type: "button", hidden: true });

  constructor(
    private readonly project: Project,
    vary: (number: Varied, opener: HTMLElement) => void,
  ) {
    this.area = h("textarea", { class: "file-text", spellcheck: "false", wrap: "off", autocapitalize: "off", autocomplete: "off", "aria-label": say("studio.file") });
    this.area.addEventListener("input", () => {
      this.number();
      document.documentElement.dataset.typing = "yes"; // until the text counts
      window.clearTimeout(this.timer);
      this.timer = window.setTimeout(() => this.take(), kPause);
    });
    this.area.addEventListener("blur", () => {
      this.take();
      project.endStep();
    });
    this.area.addEventListener("scroll", () => (this.lines.scrollTop = this.area.scrollTop));
    this.varies.addEventListener("click", () => this.varied && vary(this.varied, this.varies));
    document.addEventListener("selectionchange", () => this.hasFocus && this.point());
    this.root = h("div", { class: "file-pane" }, h("div", { class: "file" }, this.lines, this.area), h("div", { class: "file-number" }, this.varies));
    project.listen((why) => {
      if (why === "selection") return;
      this.refresh();
      this.point();
    });
  }
  // What stands at the cursor. While somebody types, the text is not yet that of the project.
  private point(): void {
    this.varied = this.area.value === this.project.text ? numberAt(this.project, this.area.selectionStart) : null;
    this.varies.hidden = this.varied === null;
    this.varies.textContent = say("studio.vary", { name: this.varied?.name ?? "" });
  }
  // Varies the number at the cursor, if there is one.
  vary(): boolean {
    this.varies.click();
    return this.varied !== null;
  }
  // What is typed becomes the project's text.
  take(): void {
    window.clearTimeout(this.timer);
    if (this.area.value !== this.project.text) this.project.change(this.area.value, this.project.selection, "typing");
    delete document.documentElement.dataset.typing;
  }
  private refresh(): void {
    if (this.area.value === this.project.text) return this.number();
    const { selectionStart, scrollTop } = this.area;
    this.area.value = this.project.text;
    this.area.selectionStart = this.area.selectionEnd = Math.min(selectionStart, this.area.value.length);
    this.area.scrollTop = scrollTop;
    this.number();
  }
  mark(faults: Fault[]): void {
    this.faults = new Map(faults.map((f) => [f.line, f.problem]));
    this.number();
  }
  private number(): void {
    const count = this.area.value.split("\n").length;
    this.lines.replaceChildren(
      ...Array.from({ length: count }, (_, k) => h("span", { class: this.faults.has(k + 1) ? "bad" : undefined }, `${k + 1}\n`)),
    );
    this.lines.scrollTop = this.area.scrollTop;
  }
  // Puts a line in sight and selects it.
  show(line: number, focus: boolean): void {
    const rows = this.area.value.split("\n");
    const from = rows.slice(0, line - 1).reduce((n, r) => n + r.length + 1, 0);
    if (focus) {
      this.area.focus({ preventScroll: true });
      this.area.setSelectionRange(from, from + (rows[line - 1]?.length ?? 0));
    }
    const height = parseFloat(getComputedStyle(this.area).lineHeight) || 18;
    this.area.scrollTop = Math.max(0, (line - 1) * height - this.area.clientHeight / 3);
    this.lines.scrollTop = this.area.scrollTop;
  }
  get hasFocus(): boolean {
    return document.activeElement === this.area;
  }
}
