// Force against displacement while the wall is pushed and after it; other pushes beside it, as lines or a band.
import { h, svg } from "../../base/dom";
import { thinned, ticks, type Point } from "../../base/plot";
import { num, say } from "../../base/texts";
import type { Answer } from "./engine";

const kPad = { left: 52, right: 16, top: 14, bottom: 36 };
const kInBand = 80; // places along a band

export interface Line {
  css: string; // "other", "kept", "member"
  name: string; // in the legend; "": not there
  points: Point[];
  share?: number; // of a member of a family, which gives its colour
}

export class Curve {
  readonly root = svg("svg", { class: "curve", role: "img", "aria-label": say("studio.curve") });
  readonly legend = h("ul", { class: "curve-legend", hidden: true });
  points: Point[] = [];
  name = ""; // of the push, where other lines are shown
  lines: Line[] = [];
  walls: Point[][] = []; // scattered ones
  until = 20; // where the push ends [mm]
  cursor: number | null = null; // displacement of the state that is shown [mm]
  peak: Point | null = null;
  pick: (displacement: number) => void = () => undefined;
  private scale = { x0: 0, perMm: 1 };

  constructor() {
    const at = (e: PointerEvent): void => this.pick((e.clientX - this.root.getBoundingClientRect().left - this.scale.x0) / this.scale.perMm);
    this.root.addEventListener("pointerdown", (e) => {
      this.root.setPointerCapture(e.pointerId);
      at(e);
    });
    this.root.addEventListener("pointermove", (e) => {
      if (this.root.hasPointerCapture(e.pointerId)) at(e);
    });
    new ResizeObserver(() => this.draw()).observe(this.root);
  }

  draw(): void {
    const wide = this.root.clientWidth,
      high = this.root.clientHeight;
    if (wide < 80 || high < 60) return;
    const shown = [this.points, ...this.lines.map((l) => l.points), ...this.walls];
    let x1 = this.until,
      x0 = 0,
      y1 = 1,
      y0 = 0;
    for (const points of shown) {
      if (points.length > 0) (x0 = Math.min(x0, points[0][0])), (x1 = Math.max(x1, points[points.length - 1][0]));
      for (const [, y] of points) (y1 = Math.max(y1, y)), (y0 = Math.min(y0, y));
    }
    y1 *= 1.08;
    x1 ||= 1;
    const sx = (wide - kPad.left - kPad.right) / (x1 - x0),
      sy = (high - kPad.top - kPad.bottom) / (y1 - y0);
    this.scale = { x0: kPad.left - x0 * sx, perMm: sx };
    const px = (x: number): number => kPad.left + (x - x0) * sx,
      py = (y: number): number => high - kPad.bottom - (y - y0) * sy;
    const line = (points: Point[]): string =>
      thinned(points.map(([x, y]) => [px(x), py(y)]), 0.3).map(([x, y], k) => `${k ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`).join("");
    const band = bandOf(this.walls);
    this.root.replaceChildren(
      ...(shown.every((points) => points.length === 0) ? [] : ticks([y0, y1], high / 44)).flatMap((y) => [
        svg("line", { class: "grid", x1: px(x0), x2: wide - kPad.right, y1: py(y), y2: py(y) }),
        svg("text", { class: "tick", x: kPad.left - 8, y: py(y) + 4, "text-anchor": "end" }, num(y)),
      ]),
      ...ticks([x0, x1], wide / 80).flatMap((x) => [
        svg("line", { class: "grid", x1: px(x), x2: px(x), y1: kPad.top, y2: py(y0) }),
        svg("text", { class: "tick", x: px(x), y: high - kPad.bottom + 16, "text-anchor": "middle" }, num(x)),
      ]),
      svg("text", { class: "tick", x: wide - kPad.right, y: high - 4, "text-anchor": "end" }, say("studio.curve.x")),
      svg("text", { class: "tick", x: kPad.left + 6, y: kPad.top + 8 }, say("studio.curve.y")),
      ...(band.length > 0 ? [svg("path", { class: "band", d: `${line(band.map((b) => [b.x, b.low]))}${line([...band].reverse().map((b) => [b.x, b.high])).replace("M", "L")}Z` })] : []),
      ...this.walls.map((points) => svg("path", { class: "one-wall", d: line(points) })),
      ...this.lines.map((l) => svg("path", { class: `line ${l.css}`, style: l.share === undefined ? undefined : `--share: ${l.share}`, d: line(l.points) })),
      svg("path", { class: "force", d: line(this.points) }),
      ...(this.peak ? [svg("circle", { class: "peak", cx: px(this.peak[0]), cy: py(this.peak[1]), r: 5 })] : []),
      ...(this.cursor === null ? [] : [svg("line", { class: "cursor", x1: px(this.cursor), x2: px(this.cursor), y1: kPad.top, y2: py(y0) })]),
    );
    const names: [css: string, name: string][] = [["force", this.name], ...this.lines.filter((l) => l.name !== "").map((l): [string, string] => [`line ${l.css}`, l.name])];
    if (this.walls.length > 1) names.push(["band", say("studio.walls.name", { count: this.walls.length })]);
    this.legend.hidden = names.length < 2;
    this.legend.replaceChildren(...(names.length < 2 ? [] : names).map(([css, name]) => h("li", {}, svg("svg", { class: "curve swatch", viewBox: "0 0 22 10", "aria-hidden": "true" }, svg("path", { class: css, d: css === "band" ? "M0 1H22V9H0Z" : "M0 5H22" })), name)));
  }
}

// Between the lowest and the highest of several curves, as far as all of them go; none where one turns back. A wall that fell
// before its push has no curve and carries nothing.
export function bandOf(all: Point[][]): { x: number; low: number; high: number }[] {
  const curves = all.filter((points) => points.length > 1);
  const fell = curves.length < all.length ? [0] : [];
  const rising = (points: Point[]): boolean => points.length > 1 && points.every(([x], k) => k === 0 || x >= points[k - 1][0]);
  if (curves.length < 2 || !curves.every(rising)) return [];
  const from = Math.max(...curves.map((c) => c[0][0])),
    to = Math.min(...curves.map((c) => c[c.length - 1][0]));
  const next = curves.map(() => 1);
  const band = [];
  for (let k = 0; k <= kInBand; ++k) {
    const x = from + ((to - from) * k) / kInBand;
    const forces = curves.map((c, i) => {
      while (next[i] < c.length - 1 && c[next[i]][0] < x) ++next[i];
      const [a, b] = [c[next[i] - 1], c[next[i]]];
      return b[0] > a[0] ? a[1] + ((b[1] - a[1]) * (Math.min(x, b[0]) - a[0])) / (b[0] - a[0]) : b[1];
    });
    band.push({ x, low: Math.min(...forces, ...fell), high: Math.max(...forces) });
  }
  return band;
}

export function pointsOf(answer: Answer): Point[] {
  const table = answer.tables.curve;
  return table ? Array.from(table.displacement_mm, (x, k): Point => [x, table.reaction_kN[k]]) : [];
}
