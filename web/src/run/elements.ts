// The damage of each part of the wall, highlighted on its picture, and the forces of a pier or spandrel.
import type { Bundle } from "../base/bundle";
import { h, type Child } from "../base/dom";
import { Figure } from "../base/figure";
import type { Element as Part, FailureMode, RunHeader } from "../headers/run";
import { Plot, rangeOf, type Point } from "../base/plot";
import { table } from "../base/tables";
import { capital, phrase, qty, say } from "../base/texts";
import { fittingScale } from "../wall/wall";
import { canvasFor, drawParts, drawWall, type Canvas, type Look } from "../wall/wall2d";
import type { WallView } from "../wall/wallview";

const kManyParts = 12; // number of parts in a wall, above which only damaged ones are listed

// The state of a part: its signs that hold, the most severe first.
const stateOf = (element: Part): string =>
  element.signs
    .filter((s) => s.holds)
    .map((s) => phrase(s.state))
    .join(", ") || phrase(element.state);

const kQuantities = ["shear", "axial", "moment", "drift"] as const;
type Quantity = (typeof kQuantities)[number];

export class ElementsView {
  readonly chart: Figure | null;
  readonly map: Figure | null; // the wall in the last state, with numbers
  private mapLook: Look | null = null;
  private mapCanvas: Canvas | null = null;
  private readonly names: string[];
  private readonly displacement: number[];
  private chosen = 0;
  private quantity: Quantity = "shear";
  private kept = ""; // the part that stays highlighted
  private readonly which = h("select", { "aria-label": say("element.which") });

  constructor(
    private readonly bundle: Bundle<RunHeader>,
    private readonly mode: FailureMode,
    private readonly view: WallView | null,
  ) {
    const forces = bundle.header.forces;
    this.names = forces?.elements ?? [];
    this.displacement = forces?.displacement_mm ?? [];
    this.map = view && view.spec.wall.parts.length > 0 ? this.picture(view) : null;
    this.chart = this.names.length > 0 && this.displacement.length > 1 ? this.figure() : null;
    this.chart?.element.classList.add("no-print");
    this.map?.element.classList.add("no-print");
  }

  // In a wall of many parts, the damaged ones; the others are counted.
  list(): Child {
    const all = this.mode.elements;
    if (all.length === 0) return null;
    const shown = all.length > kManyParts ? all.filter((e) => e.state !== "intact") : all;
    const place = h(
      "div",
      { id: "elements" },
      shown.length > 0
        ? table(
            [
              { head: say("failure.element"), left: true },
              { head: say("failure.state"), left: true },
              { head: say("failure.first") },
            ],
            shown.map((e) => [
              h("span", {}, this.markOf(e), phrase(e.element)),
              stateOf(e),
              qty(e.displacement_first_mm, "mm"),
            ]),
            say("failure.elements"),
          )
        : null,
      shown.length < all.length
        ? h(
            "p",
            { class: "soft small" },
            say(shown.length > 0 ? "failure.others_intact" : "failure.all_intact", {
              n: all.length - shown.length,
            }),
          )
        : null,
      this.view && shown.length > 0 ? h("p", { class: "soft small no-print" }, say("failure.lit")) : null,
    );
    place.querySelectorAll("tbody tr").forEach((row, i) => {
      row.addEventListener("pointerenter", () => this.light(shown[i].element));
      row.addEventListener("pointerleave", () => this.light(this.kept));
    });
    return place;
  }

  // The number of a part: a button that keeps it highlighted.
  private markOf(element: Part): Child {
    if (!element.mark) return null;
    const button = h(
      "button",
      {
        type: "button",
        class: "mark-button",
        "aria-pressed": "false",
        "aria-label": say("failure.light", { mark: element.mark, part: phrase(element.element) }),
        "data-part": element.element,
      },
      element.mark,
    );
    button.addEventListener("click", () => this.keep(this.kept === element.element ? "" : element.element));
    return button;
  }
  private keep(name: string): void {
    this.kept = name;
    this.light(name);
    document
      .querySelectorAll("#elements .mark-button")
      .forEach((b) => b.setAttribute("aria-pressed", String(b.getAttribute("data-part") === name)));
    const at = this.names.indexOf(name);
    if (at >= 0) this.choose(at);
  }
  private light(name: string): void {
    this.view?.light(name);
    if (!this.map || !this.mapLook || !this.mapCanvas) return;
    this.mapLook.lit = name;
    const { wall, frames } = this.view!.spec;
    this.map.drawing.querySelector("g.parts")?.replaceWith(drawParts(wall, frames, this.mapLook, this.mapCanvas));
  }

  private picture(view: WallView): Figure {
    const { wall, frames } = view.spec;
    return new Figure({
      id: "parts",
      title: say("parts.title"),
      draw: (width) => {
        const frame = frames.count - 1;
        this.mapLook = {
          frame,
          scale: fittingScale(wall, frames, frame),
          measure: "cracks",
          forces: false,
          numbers: true,
          lit: this.kept,
          stressSteps: [],
        };
        this.mapCanvas = canvasFor(wall, width, 420);
        return drawWall(wall, frames, this.mapLook, this.mapCanvas);
      },
      caption: say("parts.caption"),
      sheet: () => ({
        head: ["mark", "name", "kind", "storey", "x0_m", "x1_m", "y0_m", "y1_m"],
        rows: wall.parts.map((p) => [p.mark, p.name, p.kind, p.storey, ...p.box]),
      }),
    });
  }
  private choose(element: number): void {
    this.chosen = element;
    this.which.value = String(element);
    this.chart?.redraw();
  }

  private figure(): Figure {
    const marks = new Map<string, string>(this.mode.elements.map((e) => [e.element, e.mark]));
    this.names.forEach((name, i) =>
      this.which.appendChild(h("option", { value: i }, `${marks.get(name) ?? ""} ${capital(phrase(name))}`.trim())),
    );
    this.which.addEventListener("change", () => {
      this.choose(Number(this.which.value));
      this.keep(this.names[this.chosen]);
    });
    const what = h(
      "select",
      { "aria-label": say("element.what") },
      kQuantities.map((q) => h("option", { value: q }, say(`element.${q}`))),
    );
    what.addEventListener("change", () => {
      this.quantity = what.value as Quantity;
      this.chart?.redraw();
    });
    return new Figure({
      id: "element-forces",
      title: say("element.title"),
      above: h(
        "div",
        { class: "controls" },
        h("label", {}, h("span", {}, say("element.which")), this.which),
        h("label", {}, h("span", {}, say("element.what")), what),
      ),
      draw: (width, onPaper) => this.draw(width, onPaper),
      caption: say("element.caption"),
      sheet: () => ({
        head: ["displacement_mm", "element", ...this.columns()],
        rows: this.displacement.flatMap((d, r) =>
          this.names.map((name, e) => [d, name, ...this.columns().map((c) => this.at(c, r, e))]),
        ),
      }),
    });
  }
  private columns(): string[] {
    return ["axial_1", "shear_1", "moment_1", "axial_2", "shear_2", "moment_2", "drift", "distortion"];
  }
  private at(column: string, row: number, element: number): number {
    return this.bundle.array(`forces.${column}`)[row * this.names.length + element];
  }
  // The two lines of the chosen quantity: columns and words.
  private lines(): [string, string][] {
    if (this.quantity === "drift")
      return [
        ["drift", say("element.chord")],
        ["distortion", say("element.distortion")],
      ];
    const element = this.mode.elements.find((e) => e.element === this.names[this.chosen]);
    const ends = element?.kind === "spandrel" ? ["left", "right"] : ["foot", "head"];
    return ends.map((end, i) => [`${this.quantity}_${i + 1}`, say(`element.${end}`)]);
  }
  private draw(width: number, onPaper: boolean): SVGSVGElement {
    const lines = this.lines();
    const values = lines.map(([column]) => this.displacement.map((_, r) => this.at(column, r, this.chosen)));
    const plot = new Plot({
      width,
      height: onPaper ? 0.5 * width : Math.max(220, Math.min(340, 0.5 * width)),
      x: rangeOf([0, ...this.displacement]),
      y: rangeOf([0, ...values.flat()], 0.05),
      xLabel: say("axis.displacement"),
      yLabel: say(`element.${this.quantity}.axis`),
      title: `${say("element.title")}: ${phrase(this.names[this.chosen])}, ${say(`element.${this.quantity}`)}`,
    });
    const css = ["base", "force"]; // the second end above
    lines.forEach((_, i) =>
      plot.line(
        this.displacement.map((d, r): Point => [d, values[i][r]]),
        css[i],
      ),
    );
    lines.forEach(([, words], i) =>
      plot.text(plot.left + 10, plot.top + 14 + 15 * i, words, `key-text ${css[i]}-key`),
    );
    return plot.svg;
  }
}
