// A figure: title, drawing that adapts to the width, caption, and export as SVG, PNG and CSV.
import { fresh, h, later, svg, type Child } from "./dom";
import { download, standalone, toCsv, toPng, type Sheet } from "./export";
import { say } from "./texts";

export interface FigureSpec {
  id: string;
  title: string;
  draw: (width: number, onPaper: boolean) => SVGSVGElement;
  sheet?: () => Sheet; // the numbers behind the drawing
  caption?: Child;
  above?: Child; // controls and legend
  wide?: boolean; // as wide as the page
}

// The element of a drawing has a reference to its figure.
type Stage = Element & { figure?: Figure };

const all = new Set<Figure>();
const watcher =
  typeof ResizeObserver === "undefined"
    ? null
    : new ResizeObserver((entries) => {
        for (const entry of entries) (entry.target as Stage).figure?.fit(entry.contentRect.width);
      });

export class Figure {
  readonly element: HTMLElement;
  private readonly stage = h("div", { class: "stage" });
  private width = 0;
  private printing = false;

  constructor(readonly spec: FigureSpec) {
    const title = fresh("figure");
    this.element = h(
      "figure",
      { id: spec.id, class: spec.wide ? "wide" : undefined, "aria-labelledby": title },
      h("div", { class: "figure-head" }, h("h3", { id: title }, spec.title), this.tools()),
      spec.above,
      this.stage,
      spec.caption ? h("figcaption", {}, spec.caption) : null,
    );
    (this.stage as Stage).figure = this;
    all.add(this);
    later(() => {
      this.fit(this.stage.clientWidth || 640);
      watcher?.observe(this.stage);
    });
  }

  fit(width: number): void {
    const rounded = Math.max(260, Math.round(width));
    if (this.printing || rounded === this.width) return;
    this.width = rounded;
    this.redraw();
  }
  redraw(): void {
    if (this.width === 0) return;
    this.stage.replaceChildren(this.spec.draw(this.width, false));
  }
  print(width: number): void {
    this.printing = true;
    this.stage.replaceChildren(this.spec.draw(width, true));
  }
  afterPrint(): void {
    this.printing = false;
    this.redraw();
  }
  get drawing(): SVGSVGElement {
    return this.stage.querySelector("svg")!;
  }

  private tools(): HTMLElement {
    const button = (kind: string, act: () => void): HTMLElement =>
      h(
        "button",
        {
          type: "button",
          class: "tool",
          "aria-label": say("export.as", { what: this.spec.title, kind }),
          "data-export": kind.toLowerCase(),
          onclick: act,
        },
        kind,
      );
    return h(
      "div",
      { class: "tools", role: "group", "aria-label": say("export") },
      button("SVG", () => download(`${this.spec.id}.svg`, "image/svg+xml", standalone(this.drawing))),
      button(
        "PNG",
        () => void toPng(this.drawing).then((png) => download(`${this.spec.id}.png`, "image/png", png)),
      ),
      this.spec.sheet
        ? button("CSV", () => download(`${this.spec.id}.csv`, "text/csv", toCsv(this.spec.sheet!())))
        : null,
    );
  }
}

// Sets the printed width of figures by their place on the page: full, a half, a third.
export function prepareFiguresForPrint(): void {
  for (const figure of all)
    figure.print(figure.spec.wide ? 760 : figure.element.closest(".three") ? 280 : 400);
}
export function restoreFigures(): void {
  for (const figure of all) figure.afterPrint();
}

// --- pointing at a drawing ---------------------------------------------------------------------------

const tip = h("div", { class: "tip", role: "status", hidden: true });
export function showTip(event: PointerEvent, lines: (string | [string, string])[]): void {
  if (!tip.isConnected) document.body.appendChild(tip);
  tip.replaceChildren(
    ...lines.map((line) =>
      typeof line === "string"
        ? h("div", { class: "tip-title" }, line)
        : h("div", {}, h("span", {}, line[0]), h("b", {}, line[1])),
    ),
  );
  tip.hidden = false;
  const box = tip.getBoundingClientRect();
  const x = Math.min(event.clientX + 14, window.innerWidth - box.width - 8);
  const y =
    event.clientY + 16 + box.height > window.innerHeight
      ? event.clientY - box.height - 12
      : event.clientY + 16;
  tip.style.transform = `translate(${Math.max(4, x)}px, ${Math.max(4, y)}px)`;
}
export function hideTip(): void {
  tip.hidden = true;
}

// Position of the pointer in the drawing's own pixels.
export function pointIn(drawing: SVGSVGElement, event: PointerEvent | MouseEvent): [number, number] {
  const box = drawing.getBoundingClientRect();
  const view = drawing.viewBox.baseVal;
  return [
    ((event.clientX - box.left) / box.width) * view.width + view.x,
    ((event.clientY - box.top) / box.height) * view.height + view.y,
  ];
}

// --- small parts ---------------------------------------------------------------------------------------

export function swatch(css: string, kind: "line" | "box" | "dot" = "line"): SVGSVGElement {
  const mark =
    kind === "line"
      ? svg("line", { class: css, x1: 1, x2: 21, y1: 6, y2: 6 })
      : kind === "dot"
        ? svg("circle", { class: css, cx: 11, cy: 6, r: 4.5 })
        : svg("rect", { class: css, x: 4, y: 0, width: 14, height: 12, rx: 2 });
  return svg(
    "svg",
    { class: "swatch", viewBox: "0 0 22 12", width: 22, height: 12, "aria-hidden": "true" },
    mark,
  );
}
export function legend(items: [SVGSVGElement, Child][]): HTMLElement {
  return h(
    "ul",
    { class: "legend" },
    items.map(([mark, words]) => h("li", {}, mark, h("span", {}, words))),
  );
}
