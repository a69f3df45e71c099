// The frame of a chart in SVG: axes with ticks, grid and titles, and the marks within it.
import { append, fresh, svg, type Attributes, type Child } from "./dom";
import { num } from "./texts";

export type Point = [number, number];
export type Range = [number, number];

// Round numbers (1, 2, 5 times a power of ten) from low to high, about `wanted` of them.
export function ticks([low, high]: Range, wanted: number): number[] {
  if (!(high > low)) return [low];
  const rough = (high - low) / Math.max(1, wanted);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= rough * 0.999)!;
  const out: number[] = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) out.push(k * step);
  return out.map((v) => (Math.abs(v) < 1e-12 * step ? 0 : Number(v.toPrecision(12))));
}

// A range with all finite values, and a margin as a share of its width.
export function rangeOf(values: Iterable<number | null>, air = 0): Range {
  let low = Infinity,
    high = -Infinity;
  for (const v of values) {
    if (v === null || !Number.isFinite(v)) continue;
    low = Math.min(low, v);
    high = Math.max(high, v);
  }
  if (low > high) return [0, 1];
  if (low === high) return [low - (Math.abs(low) * 0.1 || 0.5), high + (Math.abs(high) * 0.1 || 0.5)];
  return [low - air * (high - low), high + air * (high - low)];
}

// The fewest points whose line stays within `tolerance` pixels of all points (Douglas and Peucker).
export function thinned(points: Point[], tolerance: number): Point[] {
  if (points.length < 3) return points;
  const keep = new Uint8Array(points.length);
  keep[0] = keep[points.length - 1] = 1;
  const stack: [number, number][] = [[0, points.length - 1]];
  while (stack.length > 0) {
    const [a, b] = stack.pop()!;
    const [ax, ay] = points[a];
    const dx = points[b][0] - ax,
      dy = points[b][1] - ay;
    const length = Math.hypot(dx, dy);
    let most = tolerance,
      at = -1;
    for (let i = a + 1; i < b; ++i) {
      const px = points[i][0] - ax,
        py = points[i][1] - ay;
      const off = length > 0 ? Math.abs(px * dy - py * dx) / length : Math.hypot(px, py);
      if (off > most) {
        most = off;
        at = i;
      }
    }
    if (at < 0) continue;
    keep[at] = 1;
    stack.push([a, at], [at, b]);
  }
  return points.filter((_, i) => keep[i]);
}

export const kLeft = 56; // space for the ticks and title of the y axis

export interface PlotSpec {
  width: number;
  height: number;
  x: Range;
  y: Range;
  xLabel: string;
  yLabel: string;
  title: string; // for screen readers
  left?: number;
  right?: number;
  top?: number;
  bottom?: number;
  xTicks?: number[];
  yTicks?: number[];
  xFormat?: (v: number) => string;
  yFormat?: (v: number) => string;
  topAxis?: { label: string; factor: number; unit: string }; // top value = factor * x
  noX?: boolean;
  noY?: boolean;
}

export class Plot {
  readonly svg: SVGSVGElement;
  readonly marks: SVGGElement; // clipped to the frame
  readonly over: SVGGElement; // labels, not clipped
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;

  constructor(readonly spec: PlotSpec) {
    this.left = spec.left ?? kLeft;
    this.right = spec.width - (spec.right ?? 16);
    this.top = spec.top ?? (spec.topAxis ? 44 : 14);
    this.bottom = spec.height - (spec.bottom ?? 46);
    const clip = fresh("clip");
    this.marks = svg("g", { "clip-path": `url(#${clip})` });
    this.over = svg("g");
    this.svg = svg(
      "svg",
      {
        class: "plot",
        viewBox: `0 0 ${spec.width} ${spec.height}`,
        width: spec.width,
        height: spec.height,
        role: "img",
        "aria-label": spec.title,
      },
      svg(
        "defs",
        {},
        svg(
          "clipPath",
          { id: clip },
          svg("rect", {
            x: this.left - 1,
            y: this.top - 1,
            width: this.right - this.left + 2,
            height: this.bottom - this.top + 2,
          }),
        ),
      ),
      this.frame(),
      this.marks,
      this.over,
    );
  }

  X = (v: number): number =>
    this.left + ((this.right - this.left) * (v - this.spec.x[0])) / (this.spec.x[1] - this.spec.x[0]);
  Y = (v: number): number =>
    this.bottom - ((this.bottom - this.top) * (v - this.spec.y[0])) / (this.spec.y[1] - this.spec.y[0]);
  // Values at a pixel of the drawing.
  xAt = (pixel: number): number =>
    this.spec.x[0] + ((pixel - this.left) / (this.right - this.left)) * (this.spec.x[1] - this.spec.x[0]);
  yAt = (pixel: number): number =>
    this.spec.y[0] + ((this.bottom - pixel) / (this.bottom - this.top)) * (this.spec.y[1] - this.spec.y[0]);

  private frame(): SVGGElement {
    const { spec, left, right, top, bottom } = this;
    const g = svg("g", { class: "frame", "aria-hidden": "true" });
    const format = (v: number): string => num(v, 4);
    if (!spec.noX) {
      for (const v of spec.xTicks ?? ticks(spec.x, Math.max(2, (right - left) / 75))) {
        const x = this.X(v);
        append(g, [
          svg("line", { class: "grid", x1: x, x2: x, y1: top, y2: bottom }),
          svg(
            "text",
            { class: "tick", x, y: bottom + 17, "text-anchor": "middle" },
            (spec.xFormat ?? format)(v),
          ),
        ]);
      }
      append(g, [
        svg(
          "text",
          { class: "title", x: (left + right) / 2, y: bottom + 38, "text-anchor": "middle" },
          spec.xLabel,
        ),
      ]);
    }
    if (!spec.noY) {
      for (const v of spec.yTicks ?? ticks(spec.y, Math.max(2, (bottom - top) / 52))) {
        const y = this.Y(v);
        append(g, [
          svg("line", { class: "grid", x1: left, x2: right, y1: y, y2: y }),
          svg(
            "text",
            { class: "tick", x: left - 7, y: y + 4, "text-anchor": "end" },
            (spec.yFormat ?? format)(v),
          ),
        ]);
      }
      append(g, [
        svg(
          "text",
          {
            class: "title",
            x: -(top + bottom) / 2,
            y: 13,
            "text-anchor": "middle",
            transform: "rotate(-90)",
          },
          spec.yLabel,
        ),
      ]);
    }
    const zero = spec.y[0] <= 0 && spec.y[1] >= 0 ? this.Y(0) : bottom;
    append(g, [
      svg("line", {
        class: "axis",
        x1: left,
        x2: right,
        y1: spec.noY ? bottom : zero,
        y2: spec.noY ? bottom : zero,
      }),
      svg("line", { class: "axis", x1: left, x2: left, y1: top, y2: bottom }),
    ]);
    if (spec.topAxis) this.topAxis(g, spec.topAxis);
    return g;
  }

  private topAxis(g: SVGGElement, axis: { label: string; factor: number; unit: string }): void {
    const range: Range = [this.spec.x[0] * axis.factor, this.spec.x[1] * axis.factor];
    append(g, [svg("line", { class: "grid", x1: this.left, x2: this.right, y1: this.top, y2: this.top })]);
    for (const v of ticks(range, Math.max(2, (this.right - this.left) / 95))) {
      const x = this.X(v / axis.factor);
      append(g, [
        svg("line", { class: "axis", x1: x, x2: x, y1: this.top, y2: this.top - 4 }),
        svg("text", { class: "tick", x, y: this.top - 8, "text-anchor": "middle" }, num(v, 3)),
      ]);
    }
    append(g, [
      svg(
        "text",
        { class: "tick", x: this.right, y: this.top - 25, "text-anchor": "end" },
        `${axis.label} [${axis.unit}]`,
      ),
    ]);
  }

  path(points: Point[], thin = 0.35): string {
    const pixels = points
      .filter(([x, y]) => Number.isFinite(x) && Number.isFinite(y))
      .map(([x, y]): Point => [this.X(x), this.Y(y)]);
    return (thin > 0 ? thinned(pixels, thin) : pixels)
      .map(([x, y], i) => `${i === 0 ? "M" : "L"}${x.toFixed(1)} ${y.toFixed(1)}`)
      .join("");
  }
  line(points: Point[], css: string, more: Attributes = {}): SVGPathElement {
    const path = svg("path", { class: css, d: this.path(points), ...more });
    this.marks.appendChild(path);
    return path;
  }
  band(x: number[], low: number[], high: number[], css: string): void {
    const finite = x.map((_, i) => i).filter((i) => Number.isFinite(low[i]) && Number.isFinite(high[i]));
    const edge = [
      ...finite.map((i): Point => [x[i], high[i]]),
      ...finite.reverse().map((i): Point => [x[i], low[i]]),
    ];
    this.marks.appendChild(svg("path", { class: css, d: this.path(edge, 0) + "Z" }));
  }
  bar(x0: number, x1: number, y0: number, y1: number, css: string, title = ""): SVGRectElement {
    const [a, b] = [this.X(x0), this.X(x1)],
      [c, d] = [this.Y(y0), this.Y(y1)];
    const rect = svg(
      "rect",
      { class: css, x: Math.min(a, b), y: Math.min(c, d), width: Math.abs(b - a), height: Math.abs(d - c) },
      title ? svg("title", {}, title) : null,
    );
    this.marks.appendChild(rect);
    return rect;
  }
  dot(x: number, y: number, r: number, css: string, more: Attributes = {}): SVGCircleElement {
    const circle = svg("circle", {
      class: css,
      cx: this.X(x).toFixed(1),
      cy: this.Y(y).toFixed(1),
      r,
      ...more,
    });
    this.marks.appendChild(circle);
    return circle;
  }
  text(x: number, y: number, text: string, css = "", more: Attributes = {}): SVGTextElement {
    const element = svg("text", { class: css, x, y, ...more }, text);
    this.over.appendChild(element);
    return element;
  }
  add(...children: Child[]): void {
    append(this.marks, children);
  }
}
